//! All that the cores see: memory, the chip's peripherals and the panel behind them.

use std::sync::Arc;

use rp2040_emu::bus::ppb::Ppb;
use rp2040_emu::core::Nvic;
use rp2350_emu::threaded::CoreAtomics;

use crate::chip::{Access, Chip, Effect};
use crate::fault::{Fault, require};
use crate::memory::Memory;
use crate::wires::{Sent, Wires};

/// Registers of a Cortex-M0+ that a firmware may use: of its interrupts, its vector table and the
/// protection of its memory, which protects nothing here.
const M0_REGISTERS: [u32; 9] = [
    0xe000_e100,
    0xe000_e180,
    0xe000_e280,
    0xe000_ed08,
    0xe000_ed0c,
    0xe000_ed94,
    0xe000_ed98,
    0xe000_ed9c,
    0xe000_eda0,
];

/// A start of the second core: vector table, stack, entry. `None` switches it off.
pub type Start = Option<[u32; 3]>;

/// Private registers of a Cortex-M0+, and its state of sleep. Those of a Cortex-M33 are in its core.
#[derive(Default)]
pub struct Private {
    pub system: Ppb,
    pub interrupts: Nvic,
    pub is_asleep: bool,
    pub event: bool,
}

pub struct System {
    pub memory: Memory,
    pub chip: Box<dyn Chip>,
    pub wires: Wires,
    /// Time in cycles, of the core whose turn it is.
    pub now: u64,
    /// The core whose turn it is.
    pub core: usize,
    /// Address of the instruction that it executes.
    pub pc: u32,
    /// First fault. It ends the run.
    pub fault: Option<Fault>,
    /// Start of the second core that the loop has to do.
    pub start: Option<Start>,
    pub private: [Private; 2],
    pub atomics: Arc<CoreAtomics>,
    /// Cycles of a microsecond.
    pub microsecond: u64,
    /// Whether an address must be a multiple of the access, as on a Cortex-M0+.
    pub aligned: bool,
}

impl System {
    /// Reads. The first fault is kept, and the value is then 0.
    #[inline(always)]
    pub fn read(&mut self, address: u32, size: usize) -> u32 {
        if !self.aligned || (address as usize).is_multiple_of(size) {
            if let Some(value) = self.memory.read(address, size) {
                return value;
            }
        }
        let value = self.read_register(address, size);
        value.unwrap_or_else(|fault| {
            self.fault.get_or_insert(fault);
            0
        })
    }

    /// Writes. The first fault is kept.
    #[inline(always)]
    pub fn write(&mut self, address: u32, value: u32, size: usize) {
        if (!self.aligned || (address as usize).is_multiple_of(size))
            && self.memory.write(address, value, size).is_some()
        {
            return;
        }
        if let Err(fault) = self.write_register(address, value, size) {
            self.fault.get_or_insert(fault);
        }
    }

    #[inline]
    pub fn check(&mut self) -> Result<(), Fault> {
        self.fault.take().map_or(Ok(()), Err)
    }

    /// Lets the DMA work until now.
    pub fn advance(&mut self) -> Result<(), Fault> {
        while let Some(sent) = self.chip.advance(&self.memory, self.now)? {
            self.pass(sent)?;
        }
        Ok(())
    }

    fn pass(&mut self, sent: Sent) -> Result<(), Fault> {
        let time = self.now / self.microsecond;
        self.wires.pass(&*self.chip, sent, time)
    }

    /// Wakes a core that waits for an event.
    pub fn wake(&mut self, core: usize) {
        self.private[core].event = true;
        self.atomics.set_event_flag(core);
    }

    fn access(&self, address: u32, size: usize) -> Result<Access, Fault> {
        require!(
            (address as usize).is_multiple_of(size),
            "{address:#010x} is no address of {size} bytes"
        );
        Ok(Access {
            address,
            size,
            core: self.core,
            now: self.now,
        })
    }

    #[cold]
    fn read_register(&mut self, address: u32, size: usize) -> Result<u32, Fault> {
        let access = self.access(address, size)?;
        if M0_REGISTERS.contains(&address) {
            return Ok(self.private[self.core].system.read32(address));
        }
        require!(has_registers(address), "no memory at {address:#010x}");
        self.advance()?;
        self.chip.read(access)
    }

    #[cold]
    fn write_register(&mut self, address: u32, value: u32, size: usize) -> Result<(), Fault> {
        let access = self.access(address, size)?;
        if M0_REGISTERS.contains(&address) {
            self.private[self.core].system.write32(address, value);
            return Ok(());
        }
        require!(
            has_registers(address),
            "no memory to write at {address:#010x}"
        );
        self.advance()?;
        match self.chip.write(access, value)? {
            Effect::None => {}
            Effect::Pins => {
                let is_sending = self.chip.is_sending(self.now);
                self.wires.change(&*self.chip, is_sending)?;
            }
            Effect::Sent(sent) => self.pass(sent)?,
            Effect::Wake(core) => self.wake(core),
            Effect::Stop => self.start = Some(None),
            Effect::Start(start) => {
                self.start = Some(Some(start));
                self.wake(0);
            }
        }
        Ok(())
    }
}

/// Tests whether an address is in a region of registers.
fn has_registers(address: u32) -> bool {
    matches!(address >> 28, 0x4 | 0x5 | 0xd)
}
