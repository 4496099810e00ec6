//! The registers of an RP2040 that a firmware may use.

use super::rp::{Control, Kind, Layout, dma, pll, reset, spi};
use crate::registers::{Block, Gate, block, register, registers};

const RESETS: u32 = 0x4000_c000;
const CLOCKS: u32 = 0x4000_8000;
const PLL: u32 = 0x4002_8000;
const PSM: u32 = 0x4001_0000;
const PINS: u32 = 0x4001_4000;
const PADS: u32 = 0x4001_c000;
const WATCHDOG: u32 = 0x4005_8000;
const VOLTAGE: u32 = 0x4006_4000;
const SPI: [u32; 2] = [0x4003_c000, 0x4004_0000];

const fn gate(bit: u32) -> Gate {
    reset(RESETS, bit)
}

const BLOCKS: &[Block<Kind>] = &[
    block("RESETS", Kind::Resets, RESETS).with(&[register(0, 0x01ff_ffff), registers(4, 2)]),
    block("CLOCKS", Kind::Clocks, CLOCKS).with(&[registers(0x30, 21)]),
    block("XOSC", Kind::Crystal, 0x4002_4000).with(&[registers(0, 4)]),
    pll("PLL_SYS", PLL).behind(gate(12)),
    pll("PLL_USB", 0x4002_c000).behind(gate(13)),
    block("PSM", Kind::Power, PSM).with(&[registers(0, 4)]),
    block("VREG", Kind::Plain, VOLTAGE).with(&[register(0, 0xb1)]),
    block("WATCHDOG", Kind::Plain, WATCHDOG).with(&[registers(0, 12)]),
    block("TIMER", Kind::Timer, 0x4005_4000)
        .with(&[registers(0, 17)])
        .behind(gate(21)),
    block("IO_BANK0", Kind::Pins, PINS)
        .with(&[
            register(4, 0x1f).repeated(30, 8),
            // Edges: raw, and enabled, forced and status of both cores.
            registers(0xf0, 28),
        ])
        .behind(gate(5)),
    block("PADS_BANK0", Kind::Pins, PADS)
        .with(&[register(0, 0), register(4, 0x56).repeated(30, 4)])
        .behind(gate(8)),
    spi("SPI0", 0, SPI).behind(gate(16)),
    spi("SPI1", 1, SPI).behind(gate(17)),
    dma().behind(gate(2)),
    block("SIO", Kind::Sio, 0xd000_0000).with(&[
        registers(0, 3),
        registers(0x10, 8),
        registers(0x50, 4),
        registers(0x100, 32),
    ]),
];

pub const RP2040: Layout = Layout {
    blocks: BLOCKS,
    spi: SPI,
    pins: PINS,
    pads: PADS,
    edges: [0xf0, 0x100],
    power: PSM + 4,
    second_core: 1 << 16,
    resets: 0x01ff_ffff,
    outputs: &[[0x10, 0x14, 0x18, 0x1c], [0x20, 0x24, 0x28, 0x2c]],
    selected: [0x38, 0x44],
    peripheral_clock: CLOCKS + 0x48,
    tick: (WATCHDOG + 0x2c, 1 << 9),
    dma: Control {
        ways: 0x3fc,
        request: 15,
        busy: 1 << 24,
        requests: [16, 18],
    },
    pll: PLL,
    // VSEL is 1.15 V.
    voltage: Some((VOLTAGE, 12)),
    clock: 200_000_000,
};
