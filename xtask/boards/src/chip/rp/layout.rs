//! What differs between RP2040 and RP2350: the table of registers, and where some are.

use crate::registers::Block;

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
    /// Frequency of the cores in Hz.
    pub clock: u64,
}
