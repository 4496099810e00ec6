//! The peripherals of an STM32F411 that a firmware may use.

mod dma;
mod table;

use crate::chip::bus_time::BusTime;
use crate::chip::{Access, Chip, Effect};
use crate::fault::{Fault, require};
use crate::memory::Memory;
use crate::registers::{Place, Registers};
use crate::serial::Serial;
use crate::wires::{Pin, Pins, Role, Sent};
use table::{BLOCKS, Kind, PORT_SIZE, PORTS, POWER, RCC, SPI};

/// Frequency of the core in Hz, as examples/blackpill sets it.
pub const CLOCK: u64 = 100_000_000;

/// Frequency of the board's crystal in Hz.
const CRYSTAL: u64 = 25_000_000;

const MODES: u32 = 0x00;
const SPEEDS: u32 = 0x08;
const INPUTS: u32 = 0x10;
const OUTPUTS: u32 = 0x14;
const SET_AND_CLEAR: u32 = 0x18;
const FUNCTIONS: u32 = 0x20;

const SPI_CONTROL: u32 = 0x00;
const SPI_CONTROL_2: u32 = 0x04;
const SPI_STATUS: u32 = 0x08;
const SPI_DATA: u32 = 0x0c;

/// Clocks that stay off without the firmware: bits of RCC_CR that start one, each with the bit that
/// tells that it runs one place higher.
const OSCILLATORS: u32 = 0x0501_0001;

/// Settings of the SPI that the panel needs: enabled as a master, 8 bits, high bit first, mode 0,
/// without checksum, on one line, on which it sends.
const SPI_MASK: u32 = 0b1110_1000_1100_0111;
const SPI_WANTED: u32 = 0b1100_0000_0100_0100;

/// Bit of the second control register: the SPI requests bytes of the DMA.
const TX_DMA_ENABLED: u32 = 1 << 1;

/// Alternate function of SPI1.
const FUNCTION_SPI: u32 = 5;

/// Bytes that the SPI can hold behind its shift register.
const BUFFER: u64 = 1;

/// An STM32F411 without its core.
pub struct Stm32f411 {
    registers: Registers<Kind>,
    serial: Serial,
    bus: BusTime,
    /// Time up to which the DMA has worked.
    advanced: u64,
    /// Levels from outside, for each port.
    inputs: [u32; 3],
}

impl Stm32f411 {
    /// Creates a chip after a reset. All inputs are high.
    pub fn new() -> Self {
        Self {
            registers: Registers::new(BLOCKS),
            serial: Serial::default(),
            bus: BusTime::default(),
            advanced: 0,
            inputs: [0xffff; 3],
        }
    }

    fn status(&self, now: u64) -> u32 {
        let flag = |is, bit: u32| u32::from(is) << bit;
        flag(self.has_room(now), 1) | flag(self.is_sending(now), 7)
    }

    /// Whether a byte fits into the buffer of the SPI.
    fn has_room(&self, now: u64) -> bool {
        self.serial.waiting(now) <= BUFFER
    }

    /// Notes that the core looks at a register, if it is one of the SPI or the DMA.
    fn look(&mut self, kind: Kind, now: u64) {
        if matches!(kind, Kind::Spi | Kind::Dma) {
            self.bus.look(now, self.serial.end());
        }
    }

    /// Levels of a port's pins, as its input register shows them.
    fn levels(&self, port: u8) -> u32 {
        (0..16).map(|bit| self.level(port, bit)).sum()
    }

    fn level(&self, port: u8, bit: u8) -> u32 {
        let is_high = match self.role(port * 16 + bit) {
            Role::Output(level) => level,
            _ => self.inputs[usize::from(port)] >> bit & 1 == 1,
        };
        u32::from(is_high) << bit
    }

    /// Tests that the PLL, from which the core begins to run, gives the frequency that the emulator counts in, and that the
    /// core voltage is high enough for it.
    fn check_clock(&self) -> Result<(), Fault> {
        let pll = u64::from(self.registers.get(RCC + 4));
        let divider = (pll & 63) * 2 * ((pll >> 16 & 3) + 1);
        let clock = CRYSTAL * (pll >> 6 & 0x1ff) / divider.max(1);
        require!(clock == CLOCK, "the PLL gives {clock} Hz, not {CLOCK} Hz");
        let scale = self.registers.get(POWER) >> 14 & 3;
        require!(scale == 3, "{clock} Hz need the voltage of scale 1");
        Ok(())
    }

    /// Sends a byte that was there at a time.
    fn send(&mut self, byte: u8, at: u64) -> Result<Sent, Fault> {
        let control = self.registers.get(SPI + SPI_CONTROL);
        require!(
            control & SPI_MASK == SPI_WANTED,
            "the SPI sends with the settings {control:#06x}"
        );
        // The SPI's bus has the clock of the core.
        let prescaler = self.registers.get(RCC + 8) >> 13 & 7;
        require!(prescaler < 4, "the clock of APB2 is divided");
        let divider = 2 << (control >> 3 & 7);
        self.serial.send(at, 8 * divider);
        self.bus.sending += 8 * divider;
        Ok(Sent {
            byte,
            unit: 1,
            clock: CLOCK / divider,
        })
    }
}

/// Returns the address of the register, and the bit if the address is in the region of single bits.
fn plain(address: u32) -> (u32, Option<u32>) {
    match address >> 25 {
        0x21 => {
            let place = address & 0x01ff_ffff;
            let byte = 0x4000_0000 + place / 32;
            (byte & !3, Some(byte % 4 * 8 + place / 4 % 8))
        }
        _ => (address & !3, None),
    }
}

impl Chip for Stm32f411 {
    fn read(&mut self, access: Access) -> Result<u32, Fault> {
        let (address, bit) = plain(access.address);
        let Place { kind, offset } = self.registers.find(address)?;
        let raw = self.registers.get(address);
        self.look(kind, access.now);
        let value = match (kind, offset) {
            (Kind::Clocks, 0) => raw | (raw & OSCILLATORS) << 1,
            // The clock that was asked for is in use.
            (Kind::Clocks, 8) => raw & !12 | (raw & 3) << 2,
            // The regulator is ready.
            (Kind::Power, 4) => raw | 1 << 14,
            (Kind::Port(port), INPUTS) => self.levels(port),
            (Kind::Spi, SPI_STATUS) => self.status(access.now),
            _ => raw,
        };
        Ok(match bit {
            Some(bit) => value >> bit & 1,
            None => value >> (8 * (access.address & 3)),
        })
    }

    fn write(&mut self, access: Access, value: u32) -> Result<Effect, Fault> {
        let (address, bit) = plain(access.address);
        let Place { kind, offset } = self.registers.find(address)?;
        self.look(kind, access.now);
        if (kind, offset) == (Kind::Spi, SPI_DATA) {
            require!(self.has_room(access.now), "the SPI's buffer is full");
            return self.send(value as u8, access.now).map(Effect::Sent);
        }
        let (mask, shift) = match bit {
            Some(bit) => (1, bit),
            None => (u32::MAX >> (32 - 8 * access.size), 8 * (access.address & 3)),
        };
        let old = self.registers.get(address);
        let new = old & !(mask << shift) | (value & mask) << shift;
        match (kind, offset) {
            (Kind::Port(_), SET_AND_CLEAR) => {
                let outputs = address - SET_AND_CLEAR + OUTPUTS;
                let old = self.registers.get(outputs);
                self.registers
                    .set(outputs, old & !(value >> 16) | value & 0xffff);
            }
            (Kind::Dma, _) => dma::write(&mut self.registers, address, new)?,
            _ => _ = self.registers.set(address, new),
        }
        if (kind, offset) == (Kind::Clocks, 8) && new & 3 == 2 {
            self.check_clock()?;
        }
        Ok(match kind {
            Kind::Port(_) => Effect::Pins,
            _ => Effect::None,
        })
    }

    fn is_sending(&self, now: u64) -> bool {
        self.serial.waiting(now) > 0
    }

    fn set_input(&mut self, pin: Pin, level: bool) {
        let inputs = &mut self.inputs[usize::from(pin / 16)];
        *inputs = *inputs & !(1 << (pin % 16)) | u32::from(level) << (pin % 16);
    }

    fn bus_time(&self) -> BusTime {
        self.bus
    }

    fn advance(&mut self, memory: &Memory, now: u64) -> Result<Option<Sent>, Fault> {
        // The SPI requests a byte if it has room for one.
        let requests = self.registers.get(SPI + SPI_CONTROL_2) & TX_DMA_ENABLED != 0;
        if requests && self.has_room(now) {
            if let Some(byte) = dma::next(&mut self.registers, memory)? {
                // It got the byte as soon as it had room, and not only now.
                return self.send(byte, self.advanced).map(Some);
            }
        }
        self.advanced = now;
        Ok(None)
    }
}

impl Pins for Stm32f411 {
    fn role(&self, pin: Pin) -> Role {
        let (port, bit) = (u32::from(pin / 16), u32::from(pin % 16));
        let base = PORTS + port * PORT_SIZE;
        let functions = self.registers.get(base + FUNCTIONS + bit / 8 * 4);
        // A slower pin does not follow the SPI.
        let is_fast = self.registers.get(base + SPEEDS) >> (2 * bit) & 3 == 3;
        match self.registers.get(base + MODES) >> (2 * bit) & 3 {
            0 => Role::Input,
            1 => Role::Output(self.registers.get(base + OUTPUTS) >> bit & 1 == 1),
            2 if is_fast && functions >> (bit % 8 * 4) & 15 == FUNCTION_SPI => match (port, bit) {
                (0, 5) | (1, 3) => Role::Clock { unit: 1 },
                (0, 7) | (1, 5) => Role::Data { unit: 1 },
                _ => Role::Idle,
            },
            _ => Role::Idle,
        }
    }

    fn name(&self, pin: Pin) -> String {
        format!("P{}{}", char::from(b'A' + pin / 16), pin % 16)
    }
}

#[cfg(test)]
mod tests;
