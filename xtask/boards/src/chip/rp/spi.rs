//! The SPI units of RP2040 and RP2350: PL022 with buffers of 8 bytes.

use super::Kind;
use crate::fault::{Fault, require};
use crate::registers::Registers;
use crate::serial::Serial;

/// Offset of the data register.
pub const DATA: u32 = 0x08;

const CONTROL_0: u32 = 0x00;
const CONTROL_1: u32 = 0x04;
const STATUS: u32 = 0x0c;
const PRESCALER: u32 = 0x10;
const DMA_CONTROL: u32 = 0x24;

/// Bytes in each buffer.
const BUFFER: u64 = 8;

pub struct Spi {
    base: u32,
    serial: Serial,
}

impl Spi {
    /// Creates the unit whose registers begin at an address.
    pub fn new(base: u32) -> Self {
        let serial = Serial::default();
        Self { base, serial }
    }

    pub fn read(&mut self, registers: &Registers<Kind>, offset: u32, now: u64) -> u32 {
        match offset {
            STATUS => {
                // One byte more waits in the shift register.
                let waiting = self.serial.waiting(now);
                let [empty, room] = [waiting <= 1, waiting <= BUFFER];
                let received = self.serial.received(now);
                let [some, full] = [received > 0, received >= BUFFER];
                let flags = [empty, room, some, full, waiting > 0];
                let bits = flags.into_iter().enumerate();
                bits.map(|(bit, flag)| u32::from(flag) << bit).sum()
            }
            DATA => {
                self.serial.take(now);
                0xff
            }
            _ => registers.get(self.base + offset),
        }
    }

    /// Sends a byte that a core wrote. Tests the settings.
    pub fn send(&mut self, it: &Registers<Kind>, value: u32, now: u64) -> Result<u8, Fault> {
        let [control, enable] = [CONTROL_0, CONTROL_1].map(|offset| it.get(self.base + offset));
        require!(enable & 2 != 0, "the SPI sends and is not enabled");
        require!(enable & 4 == 0, "the SPI sends and is no master");
        require!(
            control & 15 == 7,
            "the SPI sends {} bits",
            (control & 15) + 1
        );
        require!(control & 0xf0 == 0, "the SPI is not in Motorola's mode 0");
        let prescaler = it.get(self.base + PRESCALER);
        require!(
            prescaler >= 2 && prescaler.is_multiple_of(2),
            "the SPI's prescaler is {prescaler}"
        );
        require!(self.has_room(now), "the SPI's buffer is full");
        self.serial.overflow(now, BUFFER);
        self.serial.send(now, 8 * self.divider(it));
        Ok(value as u8)
    }

    /// Sends a byte that the DMA wrote.
    pub fn send_by_dma(&mut self, it: &Registers<Kind>, byte: u8, now: u64) -> Result<u8, Fault> {
        let requests = it.get(self.base + DMA_CONTROL) & 2 != 0;
        require!(requests, "the SPI does not request bytes of the DMA");
        self.send(it, byte.into(), now)
    }

    /// Whether a byte fits into the buffer.
    pub fn has_room(&self, now: u64) -> bool {
        self.serial.waiting(now) <= BUFFER
    }

    /// Cycle at which all bytes are sent.
    pub fn end(&self) -> u64 {
        self.serial.end()
    }

    /// Whether a byte is on its way.
    pub fn is_sending(&self, now: u64) -> bool {
        self.serial.waiting(now) > 0
    }

    /// Clock in Hz, of the cores' clock.
    pub fn clock(&self, registers: &Registers<Kind>, core: u64) -> u64 {
        core / self.divider(registers).max(1)
    }

    fn divider(&self, registers: &Registers<Kind>) -> u64 {
        let rate = registers.get(self.base + CONTROL_0) >> 8 & 0xff;
        u64::from(registers.get(self.base + PRESCALER)) * u64::from(rate + 1)
    }
}
