//! A Cortex-M33 of the crate rp2350-emu; also the Cortex-M4 of an STM32F411, whose instructions it
//! has.

use std::sync::Arc;

use rp2350_emu::CortexM33;
use rp2350_emu::threaded::CoreAtomics;

use super::Core;
use super::m33_bus::CLREX_AT;
use crate::board::ChipKind;
use crate::fault::{Fault, fault};
use crate::system::System;

/// The instruction WFE, which waits for an event.
const WFE: [u8; 2] = 0xbf20_u16.to_le_bytes();

/// Instructions that the timer of the system may lag behind.
const SYSTICK_LAG: u32 = 16;

/// Cycles in a cycle of the system timer's external clock: a microsecond, and an eighth of the core's
/// clock.
const RP2350_TICK: u64 = 150;
const STM32_TICK: u64 = 8;

/// Bit of the system timer's control register: it counts cycles of the core.
const CORE_CLOCK: u32 = 1 << 2;

pub struct M33 {
    core: CortexM33,
    steps: u32,
    /// Whether other cores write to the same memory.
    is_shared: bool,
    /// Whether the core may be asleep: it has executed WFE, and was not seen awake since.
    may_wait: bool,
    timer: SystemTimer,
}

impl M33 {
    fn number(&self) -> usize {
        self.core.id().into()
    }
}

/// Time of the system timer. The crate lets it count the cycles of the core, whatever its clock is.
struct SystemTimer {
    /// Cycles in a cycle of the external clock.
    divider: u64,
    /// Time in the timer's clock.
    ticks: u64,
    /// Cycles of the core that are counted.
    seen: u64,
}

impl SystemTimer {
    /// Lets the timer count up to now.
    fn advance(&mut self, core: &mut CortexM33) {
        let divider = match core.ppb.syst_csr & CORE_CLOCK {
            0 => self.divider,
            _ => 1,
        };
        let ticks = (core.cycles() - self.seen) / divider;
        self.seen += ticks * divider;
        self.ticks += ticks;
        core.ppb.systick_advance(self.ticks);
    }
}

impl Core for M33 {
    fn all(chip: ChipKind, atomics: &Arc<CoreAtomics>) -> Vec<Self> {
        let (cores, divider) = match chip {
            ChipKind::Rp2350 => (2, RP2350_TICK),
            _ => (1, STM32_TICK),
        };
        let core = |number| Self {
            core: CortexM33::new(number, Arc::clone(atomics)),
            steps: 0,
            is_shared: cores > 1,
            may_wait: false,
            timer: SystemTimer {
                divider,
                ticks: 0,
                seen: 0,
            },
        };
        (0..cores).map(core).collect()
    }

    fn start(&mut self, _: &mut System, [vectors, stack, entry]: [u32; 3]) {
        let core = &mut self.core;
        core.ppb.vtor = vectors;
        core.regs.msp = stack;
        core.regs.r[13] = stack;
        core.regs.xpsr = 1 << 24;
        core.regs.set_pc(entry & !1);
        core.wake();
    }

    fn step(&mut self, system: &mut System) -> Result<u64, Fault> {
        if let Some(code) = system.memory.code(self.core.regs.pc()) {
            self.may_wait |= code.starts_with(&WFE);
            mend(system, self.core.regs.pc(), code)?;
        }
        let before = self.core.cycles();
        self.core.ppb.update_latest_cycles(before);
        // Whether the core is asleep has been tested; no peripheral interrupts it.
        self.core.step_no_atomics(system);
        self.steps += 1;
        if self.steps.is_multiple_of(SYSTICK_LAG) {
            self.timer.advance(&mut self.core);
        }
        Ok(self.core.cycles() - before)
    }

    fn is_asleep(&mut self, system: &mut System) -> bool {
        if !self.may_wait {
            return false;
        }
        let number = self.number();
        if self.core.is_wfe_waiting() && system.atomics.event_flag_consume(number) {
            system.atomics.clear_wfe_waiting(number);
        }
        self.may_wait = self.core.is_wfe_waiting();
        self.may_wait
    }

    fn begin_turn(&mut self, system: &mut System) {
        if self.is_shared && !self.may_wait && self.core.it_state() == 0 {
            let pc = self.core.regs.pc();
            self.core.regs.set_pc(CLREX_AT);
            self.core.step(system);
            self.core.regs.set_pc(pc);
        }
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
        self.core.regs.xpsr & 0xf800_0000
    }
}

/// Replaces an instruction by one that the crate executes correctly. It is a fault if the crate has
/// none.
#[inline]
fn mend(system: &mut System, pc: u32, [low, high, second @ ..]: [u8; 4]) -> Result<(), Fault> {
    if !matches!(high, 0xe8 | 0xea | 0xf3 | 0xfa) {
        return Ok(());
    }
    let first = u16::from_le_bytes([low, high]);
    let second = u16::from_le_bytes(second);
    if is_wrong(first, second) {
        return Err(fault!("the emulated core has no {first:04x} {second:04x}"));
    }
    if let Some(halves) = without_order(first, second) {
        let bytes = halves.map(u16::to_le_bytes);
        system.memory.program(pc, bytes.as_flattened());
    }
    Ok(())
}

/// Instructions that the crate executes incorrectly: PKHBT, PKHTB, USAT16 and the parallel
/// additions of 8 bits.
fn is_wrong(first: u16, second: u16) -> bool {
    let pack = first & 0xfff0 == 0xeac0;
    let saturate = first & 0xfff0 == 0xf3a0 && second & 0xf0f0 == 0;
    let add = matches!(first & 0xfff0, 0xfa80 | 0xfac0) && second & 0xf080 == 0xf000;
    pack || saturate || add
}

/// Replaces an access with acquire or release, which the crate does not know, by the same access
/// without: the cores have turns, so every access is ordered.
fn without_order(first: u16, second: u16) -> Option<[u16; 2]> {
    if first & 0xffe0 != 0xe8c0 || second & 0x0f80 != 0x0f80 {
        return None;
    }
    let is_load = first & 0x10 != 0;
    let [address, value, status] = [first & 15, second & 0xf000, second & 15];
    let [is_exclusive, size] = [second >> 6 & 1, second >> 4 & 3];
    match (is_exclusive, size) {
        (0, 0..=2) if status == 15 => {
            let sized = 0xf880 + 0x20 * size;
            Some([sized | u16::from(is_load) << 4 | address, value])
        }
        (1, 2) if is_load => Some([0xe850 | address, value | 0xf00]),
        (1, 2) => Some([0xe840 | address, value | status << 8]),
        (1, _) => Some([first, value | 0xf40 | size << 4 | status]),
        _ => None,
    }
}
