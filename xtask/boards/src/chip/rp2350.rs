//! The registers of an RP2350 that a firmware may use.

use super::rp::{Control, Kind, Layout, dma, pll, reset, spi};
use crate::registers::{Block, Gate, block, register, registers};

const RESETS: u32 = 0x4002_0000;
const CLOCKS: u32 = 0x4001_0000;
const PLL: u32 = 0x4005_0000;
const PSM: u32 = 0x4001_8000;
const PINS: u32 = 0x4002_8000;
const PADS: u32 = 0x4003_8000;
const TICKS: u32 = 0x4010_8000;
const SPI: [u32; 2] = [0x4008_0000, 0x4008_8000];

const fn gate(bit: u32) -> Gate {
    reset(RESETS, bit)
}

const BLOCKS: &[Block<Kind>] = &[
    block("RESETS", Kind::Resets, RESETS).with(&[register(0, 0x1fff_ffff), registers(4, 2)]),
    block("CLOCKS", Kind::Clocks, CLOCKS).with(&[registers(0x30, 24)]),
    block("XOSC", Kind::Crystal, 0x4004_8000).with(&[registers(0, 4)]),
    pll("PLL_SYS", PLL).behind(gate(14)),
    pll("PLL_USB", 0x4005_8000).behind(gate(15)),
    block("PSM", Kind::Power, PSM).with(&[registers(0, 4)]),
    block("WATCHDOG", Kind::Plain, 0x400d_8000).with(&[registers(0, 11)]),
    block("TICKS", Kind::Ticks, TICKS).with(&[registers(0, 18)]),
    block("TIMER0", Kind::Timer, 0x400b_0000)
        .with(&[registers(0, 19)])
        .behind(gate(23)),
    block("IO_BANK0", Kind::Pins, PINS)
        .with(&[
            register(4, 0x1f).repeated(48, 8),
            // Edges: raw, and enabled, forced and status of both cores.
            registers(0x230, 42),
        ])
        .behind(gate(6)),
    block("PADS_BANK0", Kind::Pins, PADS)
        .with(&[register(0, 0), register(4, 0x116).repeated(48, 4)])
        .behind(gate(9)),
    spi("SPI0", 0, SPI).behind(gate(18)),
    spi("SPI1", 1, SPI).behind(gate(19)),
    dma().behind(gate(2)),
    block("SIO", Kind::Sio, 0xd000_0000).with(&[
        registers(0, 3),
        registers(0x10, 16),
        registers(0x50, 4),
        registers(0x100, 32),
    ]),
];

pub const RP2350: Layout = Layout {
    blocks: BLOCKS,
    spi: SPI,
    pins: PINS,
    pads: PADS,
    edges: [0x230, 0x248],
    power: PSM + 4,
    second_core: 1 << 24,
    resets: 0x1fff_ffff,
    outputs: &[
        [0x10, 0x18, 0x20, 0x28],
        [0x30, 0x38, 0x40, 0x48],
        [0x14, 0x1c, 0x24, 0x2c],
        [0x34, 0x3c, 0x44, 0x4c],
    ],
    selected: [0x38, 0x44],
    peripheral_clock: CLOCKS + 0x48,
    tick: (TICKS + 0x18, 1),
    dma: Control {
        ways: 0xffc,
        request: 17,
        busy: 1 << 26,
        requests: [24, 26],
    },
    pll: PLL,
    voltage: None,
    clock: 150_000_000,
};
