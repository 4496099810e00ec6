//! What differs between RP2040 and RP2350: the table of registers, and where some are. The blocks of
//! registers that both have are here.

use super::dma::Control;
use crate::registers::{Block, Gate, block, register, registers};

/// Kinds of peripherals. `Plain` ones keep what is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Plain,
    Resets,
    Clocks,
    Crystal,
    Pll,
    Power,
    Timer,
    Ticks,
    Pins,
    Spi(usize),
    Dma,
    Sio,
}

/// Returns the gate of a block that a bit of RESETS keeps in reset.
pub const fn reset(register: u32, bit: u32) -> Gate {
    Gate {
        register,
        mask: 1 << bit,
        open: 0,
        missing: "it is still in reset",
    }
}

pub const fn spi(name: &'static str, unit: usize, bases: [u32; 2]) -> Block<Kind> {
    block(name, Kind::Spi(unit), bases[unit]).with(const { &[registers(0, 10)] })
}

/// Returns the DMA with its first channel.
pub const fn dma() -> Block<Kind> {
    block("DMA", Kind::Dma, 0x5000_0000).with(const { &[registers(0, 16)] })
}

pub const fn pll(name: &'static str, base: u32) -> Block<Kind> {
    block(name, Kind::Pll, base)
        .with(const { &[register(0, 1), register(4, 0x2d), registers(8, 2)] })
}

/// What differs between the chips.
pub struct Layout {
    pub blocks: &'static [Block<Kind>],
    pub spi: [u32; 2],
    pub pins: u32,
    pub pads: u32,
    /// Offset of the first register of edges, and of the first core's enabled edges.
    pub edges: [u32; 2],
    pub power: u32,
    pub second_core: u32,
    /// Bits of RESETS.
    pub resets: u32,
    /// Offsets of outputs in the SIO, of their enables, and of the same for pins from 32 on. Each
    /// has a register for the value, and three that set, clear and invert bits.
    pub outputs: &'static [[u32; 4]],
    /// Offsets of the SELECTED registers of clocks with glitch-free multiplexers: REF and SYS.
    pub selected: [u32; 2],
    /// Control register of the clock of peripherals.
    pub peripheral_clock: u32,
    /// Register and bit that let the timer count.
    pub tick: (u32, u32),
    pub dma: Control,
    /// First register of the cores' PLL.
    pub pll: u32,
    /// Register of the core voltage, and the least VSEL at which the cores may run at `clock`, if that is more
    /// than after a reset.
    pub voltage: Option<(u32, u32)>,
    /// Frequency of the cores in Hz, as the examples set it.
    pub clock: u64,
}
