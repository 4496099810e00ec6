//! The registers of an STM32F411 that a firmware may use.

use crate::registers::{Block, Gate, Register, register, registers};

/// First address of the clocks' registers.
pub const RCC: u32 = 0x4002_3800;
/// First address of SPI1's registers.
pub const SPI: u32 = 0x4001_3000;
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
}

const fn gate(register: u32, bit: u32) -> Option<Gate> {
    Some(Gate {
        register: RCC + register,
        mask: 1 << bit,
        open: 1 << bit,
        missing: "its clock is not enabled",
    })
}

const fn port(name: &'static str, number: u8, registers: &'static [Register]) -> Block<Kind> {
    Block {
        name,
        kind: Kind::Port(number),
        base: PORTS + number as u32 * PORT_SIZE,
        gate: gate(0x30, number as u32),
        registers,
    }
}

/// The table of the chip.
pub const BLOCKS: &[Block<Kind>] = &[
    Block {
        name: "RCC",
        kind: Kind::Clocks,
        base: RCC,
        gate: None,
        registers: &[
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
        ],
    },
    Block {
        name: "FLASH",
        kind: Kind::Plain,
        base: 0x4002_3c00,
        gate: None,
        registers: &[registers(0, 6)],
    },
    Block {
        name: "PWR",
        kind: Kind::Power,
        base: 0x4000_7000,
        gate: gate(0x40, 28),
        registers: &[registers(0, 2)],
    },
    port(
        "GPIOA",
        0,
        &[
            register(0, 0xa800_0000),
            registers(4, 2),
            register(0xc, 0x6400_0000),
            registers(0x10, 6),
        ],
    ),
    port(
        "GPIOB",
        1,
        &[
            register(0, 0x280),
            registers(4, 2),
            register(0xc, 0x100),
            registers(0x10, 6),
        ],
    ),
    port("GPIOC", 2, &[registers(0, 10)]),
    Block {
        name: "SPI1",
        kind: Kind::Spi,
        base: SPI,
        gate: gate(0x44, 12),
        registers: &[registers(0, 9)],
    },
];
