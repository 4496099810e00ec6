//! Channel 0 of the RP2350's DMA, which sends bytes from memory to an SPI.

use crate::fault::{Fault, fault, require};
use crate::memory::Memory;

const READ: u32 = 0x0;
const WRITE: u32 = 0x4;
const COUNT: u32 = 0x8;
const CONTROL: u32 = 0xc;

/// Bits of the control register: enabled, step of the source, busy; and the requesting peripheral.
const ENABLED: u32 = 1;
const STEPS: u32 = 1 << 4;
const BUSY: u32 = 1 << 26;

/// Requests of the SPI units: SPI0 TX and SPI1 TX.
const REQUESTS: [u32; 2] = [24, 26];

/// Offset of the data register of an SPI.
const DATA: u32 = 0x8;

/// The channel.
#[derive(Default)]
pub struct Dma {
    source: u32,
    target: u32,
    /// Bytes that remain, and those that a start loads.
    left: u32,
    count: u32,
    control: u32,
}

impl Dma {
    /// Reads a register.
    pub fn read(&self, offset: u32, raw: u32) -> u32 {
        match offset {
            READ => self.source,
            COUNT => self.left,
            CONTROL if self.left > 0 => raw | BUSY,
            _ => raw,
        }
    }

    /// Writes a register. The control register starts the channel.
    pub fn write(&mut self, offset: u32, value: u32) -> Result<(), Fault> {
        require!(self.left == 0, "the DMA is changed while it works");
        match offset {
            READ => self.source = value,
            WRITE => self.target = value,
            COUNT => self.count = value,
            CONTROL => {
                self.control = value;
                self.left = if value & ENABLED != 0 { self.count } else { 0 };
                let is_plain = value & 0x0c == 0 && value & STEPS != 0;
                require!(is_plain, "the DMA does not send bytes one after another");
            }
            _ => return Err(fault!("the DMA's register {offset:#x} is not modelled")),
        }
        Ok(())
    }

    /// Returns the SPI unit to which the channel sends. `None` if it does not work.
    pub fn unit(&self, spi: [u32; 2]) -> Result<Option<usize>, Fault> {
        if self.left == 0 {
            return Ok(None);
        }
        let unit = spi.iter().position(|base| base + DATA == self.target);
        let unit = unit.ok_or_else(|| fault!("the DMA sends to {:#010x}", self.target))?;
        let request = self.control >> 17 & 0x3f;
        require!(request == REQUESTS[unit], "request {request} paces the DMA");
        Ok(Some(unit))
    }

    /// Returns the next byte.
    pub fn next(&mut self, memory: &Memory) -> Result<u8, Fault> {
        let byte = memory.read(self.source, 1);
        let byte = byte.ok_or_else(|| fault!("the DMA reads {:#010x}", self.source))?;
        self.source += 1;
        self.left -= 1;
        Ok(byte as u8)
    }
}
