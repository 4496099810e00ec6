//! The registers of an STM32F411 that a firmware may use.

use crate::registers::{Block, Gate, block, register, registers};

/// First address of the clocks' registers.
pub const RCC: u32 = 0x4002_3800;
/// First address of the registers of PWR, which sets the core voltage.
pub const POWER: u32 = 0x4000_7000;
/// First address of SPI1's registers.
pub const SPI: u32 = 0x4001_3000;
/// First address of the registers of DMA2.
pub const DMA: u32 = 0x4002_6400;
/// First address of the registers of its stream 3.
pub const STREAM: u32 = DMA + 0x58;
/// First address of the ports' registers.
pub const PORTS: u32 = 0x4002_0000;
/// Bytes from one port to the next.
pub const PORT_SIZE: u32 = 0x400;

/// Kinds of peripherals. `Plain` ones keep what is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Plain,
    Clocks,
    Power,
    Port(u8),
    Spi,
    Dma,
}

const fn gate(register: u32, bit: u32) -> Gate {
    Gate {
        register: RCC + register,
        mask: 1 << bit,
        open: 1 << bit,
        missing: "its clock is not enabled",
    }
}

const fn port(name: &'static str, number: u8) -> Block<Kind> {
    let base = PORTS + number as u32 * PORT_SIZE;
    block(name, Kind::Port(number), base).behind(gate(0x30, number as u32))
}

/// The table of the chip.
pub const BLOCKS: &[Block<Kind>] = &[
    block("RCC", Kind::Clocks, RCC).with(&[
        register(0, 0x83),
        register(4, 0x2400_3010),
        registers(8, 6),
        registers(0x20, 2),
        registers(0x30, 2),
        registers(0x40, 2),
        registers(0x50, 2),
        registers(0x60, 2),
        registers(0x70, 2),
        registers(0x80, 4),
    ]),
    block("FLASH", Kind::Plain, 0x4002_3c00).with(&[registers(0, 6)]),
    block("PWR", Kind::Power, POWER)
        .with(&[register(0, 0x8000), register(4, 0)])
        .behind(gate(0x40, 28)),
    port("GPIOA", 0).with(&[
        register(0, 0xa800_0000),
        registers(4, 2),
        register(0xc, 0x6400_0000),
        registers(0x10, 6),
    ]),
    port("GPIOB", 1).with(&[
        register(0, 0x280),
        registers(4, 2),
        register(0xc, 0x100),
        registers(0x10, 6),
    ]),
    port("GPIOC", 2).with(&[registers(0, 10)]),
    block("DMA2", Kind::Dma, DMA)
        .with(&[
            registers(0, 4),
            registers(STREAM - DMA, 5),
            register(STREAM - DMA + 0x14, 0x21),
        ])
        .behind(gate(0x30, 22)),
    block("SPI1", Kind::Spi, SPI)
        .with(&[registers(0, 9)])
        .behind(gate(0x44, 12)),
];
