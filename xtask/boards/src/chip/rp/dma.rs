//! Channel 0 of the DMA of RP2040 and RP2350, which sends bytes from memory to an SPI.

use crate::fault::{Fault, fault, require};
use crate::memory::Memory;

/// Indices of the channel's values.
const READ: usize = 0;
const WRITE: usize = 1;
const COUNT: usize = 2;
const CONTROL: usize = 3;

/// The value behind each of the channel's 16 registers, 4 registers a line. A write to the last register
/// of a line starts the channel.
const REGISTERS: [usize; 16] = [
    READ, WRITE, COUNT, CONTROL, //
    CONTROL, READ, WRITE, COUNT, //
    CONTROL, COUNT, READ, WRITE, //
    CONTROL, WRITE, COUNT, READ,
];

/// Bits of the control register: enabled, step of the source.
const ENABLED: u32 = 1;
const STEPS: u32 = 1 << 4;

/// Offset of the data register of an SPI.
const DATA: u32 = 0x8;

/// Where the control register of a chip has its bits.
pub struct Control {
    /// Size of a transfer, steps of source and target, and the ring.
    pub ways: u32,
    /// Lowest bit of the requesting peripheral.
    pub request: u32,
    pub busy: u32,
    /// Requests of the SPI units: SPI0 TX and SPI1 TX.
    pub requests: [u32; 2],
}

pub struct Dma {
    layout: &'static Control,
    values: [u32; 4],
    /// Bytes that remain.
    left: u32,
}

impl Dma {
    /// Creates a channel that does not work.
    pub fn new(layout: &'static Control) -> Self {
        Self {
            layout,
            values: [0; 4],
            left: 0,
        }
    }

    pub fn read(&self, offset: u32) -> u32 {
        match REGISTERS[offset as usize / 4] {
            COUNT => self.left,
            CONTROL if self.left > 0 => self.values[CONTROL] | self.layout.busy,
            value => self.values[value],
        }
    }

    pub fn write(&mut self, offset: u32, value: u32) -> Result<(), Fault> {
        require!(self.left == 0, "the DMA is changed while it works");
        self.values[REGISTERS[offset as usize / 4]] = value;
        let control = self.values[CONTROL];
        if offset % 16 == 12 && control & ENABLED != 0 {
            let is_plain = control & self.layout.ways == STEPS;
            require!(is_plain, "the DMA does not send bytes one after another");
            self.left = self.values[COUNT];
        }
        Ok(())
    }

    /// Returns the SPI unit to which the channel sends. `None` if the channel is idle.
    pub fn unit(&self, spi: [u32; 2]) -> Result<Option<usize>, Fault> {
        if self.left == 0 {
            return Ok(None);
        }
        let target = self.values[WRITE];
        let unit = spi.iter().position(|base| base + DATA == target);
        let unit = unit.ok_or_else(|| fault!("the DMA sends to {target:#010x}"))?;
        let request = self.values[CONTROL] >> self.layout.request & 0x3f;
        let is_right = request == self.layout.requests[unit];
        require!(is_right, "request {request} paces the DMA");
        Ok(Some(unit))
    }

    pub fn next(&mut self, memory: &Memory) -> Result<u8, Fault> {
        let source = &mut self.values[READ];
        let byte = memory.read(*source, 1);
        let byte = byte.ok_or_else(|| fault!("the DMA reads {source:#010x}"))?;
        *source += 1;
        self.left -= 1;
        Ok(byte as u8)
    }
}
