//! A Cortex-M0+ of the crate rp2040-emu.

use std::sync::Arc;

use rp2040_emu::CortexM0Plus;
use rp2040_emu::bus::ppb::Ppb;
use rp2040_emu::core::{CoreBus, Nvic};
use rp2350_emu::threaded::CoreAtomics;

use super::Core;
use crate::board::ChipKind;
use crate::fault::Fault;
use crate::system::System;

pub struct M0 {
    core: CortexM0Plus,
}

impl M0 {
    fn number(&self) -> usize {
        self.core.id().into()
    }
}

/// Returns the cycles by which the crate's time of an instruction is too long: its branches take
/// the time of a Cortex-M0, one cycle more than on an M0+, and so do accesses to the SIO, which take
/// one cycle.
fn excess(instruction: u16, address: u32, cycles: u32) -> u32 {
    let is_access = instruction & 0xf000 == 0x6000 || instruction & 0xe000 == 0x6000;
    let is_branch = matches!(instruction >> 11, 0x1a..=0x1c | 0x1e)
        || matches!(instruction & 0xff00, 0x4700 | 0xbd00)
        || instruction & 0xff87 == 0x4687;
    let is_fast = is_access && address >> 28 == 0xd && cycles == 2;
    u32::from(is_branch && cycles >= 3 || is_fast)
}

impl Core for M0 {
    fn all(_: ChipKind, _: &Arc<CoreAtomics>) -> Vec<Self> {
        let cores = [0, 1].map(CortexM0Plus::with_id);
        cores.map(|core| Self { core }).into()
    }

    fn start(&mut self, system: &mut System, [vectors, stack, entry]: [u32; 3]) {
        let number = self.number();
        let private = &mut system.private[number];
        private.system.vtor = vectors;
        (private.event, private.is_asleep) = (false, false);
        self.core.regs.msp = stack;
        self.core.regs.r[13] = stack;
        self.core.regs.set_pc(entry & !1);
        self.core.reset_control_for_launch();
        self.core.wake();
    }

    fn step(&mut self, system: &mut System) -> Result<u64, Fault> {
        let instruction = system.memory.read(self.core.regs.pc(), 2).unwrap_or(0) as u16;
        let address = self.core.reg(usize::from(instruction >> 3 & 7));
        let cycles = self.core.step(system);
        Ok(u64::from(cycles - excess(instruction, address, cycles)))
    }

    fn is_asleep(&mut self, system: &mut System) -> bool {
        let private = &mut system.private[self.number()];
        if private.is_asleep && private.event {
            (private.event, private.is_asleep) = (false, false);
        }
        private.is_asleep
    }

    fn pc(&self) -> u32 {
        self.core.regs.pc()
    }

    fn exception(&self) -> u32 {
        self.core.regs.ipsr()
    }

    fn registers(&mut self) -> &mut [u32; 16] {
        &mut self.core.regs.r
    }

    fn flags(&self) -> u32 {
        self.core.regs.xpsr & 0xf000_0000
    }
}

impl CoreBus for System {
    fn read8(&mut self, address: u32) -> u8 {
        self.read(address, 1) as u8
    }

    #[inline]
    fn read16(&mut self, address: u32) -> u16 {
        self.read(address, 2) as u16
    }

    #[inline]
    fn read32(&mut self, address: u32) -> u32 {
        self.read(address, 4)
    }

    fn write8(&mut self, address: u32, value: u8) {
        self.write(address, value.into(), 1);
    }

    fn write16(&mut self, address: u32, value: u16) {
        self.write(address, value.into(), 2);
    }

    #[inline]
    fn write32(&mut self, address: u32, value: u32) {
        self.write(address, value, 4);
    }

    fn set_active_pc(&mut self, _: u32) {}

    // Faults end the run, so the core never sees one.
    fn bus_fault(&self) -> bool {
        false
    }

    fn bus_fault_addr(&self) -> u32 {
        0
    }

    fn clear_bus_fault(&mut self) {}

    fn ppb(&self, core: usize) -> &Ppb {
        &self.private[core].system
    }

    fn ppb_mut(&mut self, core: usize) -> &mut Ppb {
        &mut self.private[core].system
    }

    fn nvic(&self, core: usize) -> &Nvic {
        &self.private[core].interrupts
    }

    fn nvic_mut(&mut self, core: usize) -> &mut Nvic {
        &mut self.private[core].interrupts
    }

    fn active_core(&self) -> usize {
        self.core
    }

    fn event_flag(&self, core: usize) -> bool {
        self.private[core].event
    }

    fn consume_event_flag(&mut self, core: usize) -> bool {
        std::mem::take(&mut self.private[core].event)
    }

    fn set_wfe_waiting(&mut self, core: usize, waits: bool) {
        self.private[core].is_asleep = waits;
    }

    fn signal_sev(&mut self) {
        self.private.iter_mut().for_each(|it| it.event = true);
    }
}
