//! The peripherals that RP2040 and RP2350 have in common. Their tables tell the addresses.

mod clock;
mod dma;
mod edges;
mod fifo;
mod layout;
mod spi;

use crate::chip::bus_time::BusTime;
use crate::chip::{Access, Chip, Effect};
use crate::fault::{Fault, fault, require};
use crate::memory::Memory;
use crate::registers::{Place, Registers};
use crate::wires::{Pin, Pins, Role, Sent};
pub use dma::Control;
use dma::Dma;
use edges::Edges;
use fifo::Fifos;
pub use layout::{Kind, Layout, dma, pll, reset, spi};
use spi::Spi;

/// First address of the SIO.
const SIO: u32 = 0xd000_0000;

/// Bit ENABLE of CLK_PERI_CTRL: the clock of the SPI runs.
const CLOCK_ENABLED: u32 = 1 << 11;

/// Bits of a pad: output disabled; on an RP2350 also isolated.
const PAD_OFF: u32 = 0x180;

const FUNCTION_SPI: u32 = 1;
const FUNCTION_SIO: u32 = 5;

/// An RP2040 or RP2350 without its cores.
pub struct Rp {
    layout: &'static Layout,
    registers: Registers<Kind>,
    spi: [Spi; 2],
    dma: Dma,
    bus: BusTime,
    fifos: Fifos,
    spinlocks: u32,
    inputs: u32,
    edges: Edges,
}

impl Rp {
    /// Creates a chip after a reset, with one or two cores. All inputs are high.
    pub fn new(layout: &'static Layout, cores: usize) -> Self {
        Self {
            layout,
            registers: Registers::new(layout.blocks),
            spi: layout.spi.map(Spi::new),
            dma: Dma::new(&layout.dma),
            bus: BusTime::default(),
            fifos: Fifos::new(cores),
            spinlocks: 0,
            inputs: !0,
            edges: Edges::new(layout.edges),
        }
    }

    fn time(&self, now: u64) -> Result<u64, Fault> {
        let (register, bit) = self.layout.tick;
        let ticks = self.registers.get(register) & bit != 0;
        require!(ticks, "the timer is read, and its tick is not enabled");
        Ok(now * 1_000_000 / self.layout.clock)
    }

    fn sio(&mut self, offset: u32, core: usize) -> Result<u32, Fault> {
        Ok(match offset {
            0x00 => core as u32,
            0x04 => self.levels(),
            0x50 => self.fifos.status(core),
            0x58 => self.fifos.receive(core),
            0x5c => self.spinlocks,
            0x100..0x180 => {
                let bit = 1 << ((offset - 0x100) / 4);
                let was_free = self.spinlocks & bit == 0;
                self.spinlocks |= bit;
                if was_free { bit } else { 0 }
            }
            _ => self.registers.get(SIO + offset),
        })
    }

    fn write_sio(&mut self, offset: u32, value: u32, core: usize) -> Result<Effect, Fault> {
        for group in self.layout.outputs {
            let Some(way) = group.iter().position(|it| *it == offset) else {
                continue;
            };
            let old = self.registers.get(SIO + group[0]);
            let new = [value, old | value, old & !value, old ^ value][way];
            self.registers.set(SIO + group[0], new);
            return Ok(Effect::Pins);
        }
        match offset {
            0x50 => Ok(Effect::None),
            0x54 => self.fifos.send(core, value),
            0x100..0x180 => {
                self.spinlocks &= !(1 << ((offset - 0x100) / 4));
                Ok(Effect::None)
            }
            _ => Err(fault!(
                "the register {offset:#x} of the SIO is not modelled"
            )),
        }
    }

    /// Levels of the first 32 outputs, and which are enabled.
    fn outputs(&self) -> [u32; 2] {
        [0, 1].map(|group: usize| self.registers.get(SIO + self.layout.outputs[group][0]))
    }

    /// Levels of all pins: of inputs, and of outputs that are enabled.
    fn levels(&self) -> u32 {
        let [out, enabled] = self.outputs();
        self.inputs & !enabled | out & enabled
    }

    /// Notes that a core looks at a register, if it is one of the SPI or the DMA.
    fn look(&mut self, kind: Kind, now: u64) {
        if matches!(kind, Kind::Spi(_) | Kind::Dma) {
            let end = self.spi.iter().map(Spi::end).max();
            self.bus.look(now, end.unwrap_or(0));
        }
    }

    /// Describes a byte that an SPI sends, and counts its time.
    fn sent(&mut self, unit: usize, byte: u8) -> Sent {
        let clock = self.spi[unit].clock(&self.registers, self.layout.clock);
        self.bus.sending += 8 * self.layout.clock / clock;
        Sent { byte, unit, clock }
    }

    fn switch(&mut self, address: u32, old: u32, new: u32) -> Effect {
        let bit = self.layout.second_core;
        if address != self.layout.power || (old ^ new) & bit == 0 {
            return Effect::None;
        }
        self.fifos.reset();
        if new & bit != 0 {
            return Effect::Stop;
        }
        self.fifos.greet();
        Effect::Wake(0)
    }
}

/// Returns an address without the bits that choose set, clear or invert, and those bits.
fn plain(address: u32) -> (u32, u32) {
    match address >> 28 {
        0x4 | 0x5 => (address & !0x3000, address >> 12 & 3),
        _ => (address, 0),
    }
}

impl Chip for Rp {
    fn read(&mut self, access: Access) -> Result<u32, Fault> {
        let (address, _) = plain(access.address & !3);
        let Place { kind, offset } = self.registers.find(address)?;
        let raw = self.registers.get(address);
        let now = access.now;
        self.look(kind, now);
        let value = match (kind, offset) {
            (Kind::Resets, 8) => !self.registers.get(address - 8) & self.layout.resets,
            (Kind::Clocks, _) if self.layout.selected.contains(&offset) => {
                1 << (self.registers.get(address - 8) & 3)
            }
            (Kind::Crystal, 4) => match self.registers.get(address - 4) >> 12 & 0xfff {
                0xfab => 1 << 31 | 1 << 12,
                _ => 0,
            },
            (Kind::Pll, 0) => raw | 1 << 31,
            (Kind::Timer, 0x08 | 0x24) => (self.time(now)? >> 32) as u32,
            (Kind::Timer, 0x0c | 0x28) => self.time(now)? as u32,
            (Kind::Ticks, _) if offset % 12 == 0 => raw | (raw & 1) << 1,
            (Kind::Pins, _) => {
                let register = |offset| self.registers.get(self.layout.pins + offset);
                self.edges.read(offset, register).unwrap_or(raw)
            }
            (Kind::Spi(unit), _) => self.spi[unit].read(&self.registers, offset, now),
            (Kind::Dma, _) => self.dma.read(offset),
            (Kind::Sio, _) => self.sio(offset, access.core)?,
            _ => raw,
        };
        Ok(value >> (8 * (access.address & 3)))
    }

    fn write(&mut self, access: Access, value: u32) -> Result<Effect, Fault> {
        let (address, way) = plain(access.address);
        let Place { kind, offset } = self.registers.find(address)?;
        require!(
            access.size == 4,
            "{} bytes of a register are written",
            access.size
        );
        self.look(kind, access.now);
        if kind == Kind::Sio {
            return self.write_sio(offset, value, access.core);
        }
        let old = self.registers.get(address);
        let new = [value, old ^ value, old | value, old & !value][way as usize];
        self.registers.set(address, new);
        match kind {
            // CLK_SYS_CTRL, two registers before its SELECTED.
            Kind::Clocks if offset + 8 == self.layout.selected[1] && new & 1 == 1 => {
                clock::check(&self.registers, self.layout, new).map(|()| Effect::None)
            }
            Kind::Power => Ok(self.switch(address, old, new)),
            Kind::Pins => {
                self.edges.clear(offset, value);
                Ok(Effect::Pins)
            }
            Kind::Spi(unit) if offset == spi::DATA => {
                let clocked = self.registers.get(self.layout.peripheral_clock) & CLOCK_ENABLED != 0;
                require!(
                    clocked,
                    "the SPI sends, and the clock of peripherals is not enabled"
                );
                let byte = self.spi[unit].send(&self.registers, new, access.now)?;
                Ok(Effect::Sent(self.sent(unit, byte)))
            }
            Kind::Dma => self.dma.write(offset, new).map(|()| Effect::None),
            _ => Ok(Effect::None),
        }
    }

    fn is_sending(&self, now: u64) -> bool {
        self.spi.iter().any(|it| it.is_sending(now))
    }

    fn set_input(&mut self, pin: Pin, level: bool) {
        let bit = 1 << pin;
        if self.inputs & bit != 0 && !level {
            self.edges.fall(pin);
        }
        self.inputs = self.inputs & !bit | if level { bit } else { 0 };
    }

    fn advance(&mut self, memory: &Memory, now: u64) -> Result<Option<Sent>, Fault> {
        let Some(unit) = self.dma.unit(self.layout.spi)? else {
            return Ok(None);
        };
        if !self.spi[unit].has_room(now) {
            return Ok(None);
        }
        let byte = self.dma.next(memory)?;
        let byte = self.spi[unit].send_by_dma(&self.registers, byte, now)?;
        Ok(Some(self.sent(unit, byte)))
    }

    fn bus_time(&self) -> BusTime {
        self.bus
    }
}

impl Pins for Rp {
    fn role(&self, pin: Pin) -> Role {
        let number = u32::from(pin);
        let pad = self.registers.get(self.layout.pads + 4 + 4 * number);
        if pad & PAD_OFF != 0 {
            return Role::Idle;
        }
        let unit = number as usize / 8 % 2;
        let function = self.registers.get(self.layout.pins + 4 + 8 * number) & 31;
        match (function, pin % 4) {
            (FUNCTION_SPI, 2) => Role::Clock { unit },
            (FUNCTION_SPI, 3) => Role::Data { unit },
            (FUNCTION_SIO, _) => {
                let [out, enabled] = self.outputs().map(|it| it >> number & 1 == 1);
                if enabled { Role::Output(out) } else { Role::Input }
            }
            _ => Role::Idle,
        }
    }

    fn name(&self, pin: Pin) -> String {
        format!("GP{pin}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chip::rp2350::RP2350;

    #[test]
    fn bytes_that_change_before_they_are_sent_are_sent_as_they_are_then() {
        const RAM: u32 = 0x2000_0000;
        let mut chip = Rp::new(&RP2350, 1);
        let [_, spi] = RP2350.spi;
        // The SPI as the examples set it up: a byte takes 32 cycles.
        for (offset, value) in [(0, 7), (4, 2), (0x10, 4), (0x24, 2)] {
            chip.registers.set(spi + offset, value);
        }
        // Ten bytes from the RAM, paced by SPI1. The last write starts the DMA.
        for (offset, value) in [(0, RAM), (4, spi + 8), (8, 10), (12, 26 << 17 | 1 << 4 | 1)] {
            chip.dma.write(offset, value).unwrap();
        }
        let mut memory = Memory::new((0x1000_0000, 0), (RAM, 16));
        memory.write(RAM, 0x3322_1100, 4).unwrap();
        let sent = |chip: &mut Rp, memory: &Memory, now| {
            let next = || chip.advance(memory, now).unwrap().map(|it| it.byte);
            std::iter::from_fn(next).collect::<Vec<_>>()
        };
        // One byte is on its way, and eight wait in the buffer.
        let first = sent(&mut chip, &memory, 0);
        assert_eq!(first, [0, 0x11, 0x22, 0x33, 0, 0, 0, 0, 0]);
        memory.write(RAM + 8, 0x9988, 2).unwrap();
        assert_eq!(sent(&mut chip, &memory, 31), []);
        assert_eq!(sent(&mut chip, &memory, 32), [0x99]);
        assert_eq!(sent(&mut chip, &memory, 999), []);
    }
}
