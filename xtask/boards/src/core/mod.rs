//! A core: steps through instructions. The two kinds come from crates, whose faults are corrected.

pub mod m0;
pub mod m33;
mod m33_bus;

use std::sync::Arc;

use rp2350_emu::threaded::CoreAtomics;

use crate::board::ChipKind;
use crate::fault::Fault;
use crate::system::System;

/// Exceptions 2 to 6 are faults of the firmware.
const FAULTS: std::ops::RangeInclusive<u32> = 2..=6;

pub trait Core: Sized {
    /// Returns the cores of a chip, which are all of this kind.
    fn all(chip: ChipKind, atomics: &Arc<CoreAtomics>) -> Vec<Self>;
    /// Starts or restarts the core with this vector table, stack and entry.
    fn start(&mut self, system: &mut System, start: [u32; 3]);
    /// Executes an instruction. Returns the cycles that it took.
    fn step(&mut self, system: &mut System) -> Result<u64, Fault>;
    /// Whether the core waits for an event. If one has happened, the core goes on.
    fn is_asleep(&mut self, system: &mut System) -> bool;
    /// Begins a turn after another core had one.
    fn begin_turn(&mut self, _: &mut System) {}
    /// Address of the next instruction.
    fn pc(&self) -> u32;
    /// Number of the exception in which the core is. 0 for none.
    fn exception(&self) -> u32;
    /// Registers 0 to 15.
    fn registers(&mut self) -> &mut [u32; 16];
    /// Flags N, Z, C, V and Q in the 5 highest bits.
    fn flags(&self) -> u32;

    /// Tests that the core is not lost.
    fn check(&self, system: &System) -> Result<(), Fault> {
        let exception = self.exception();
        if FAULTS.contains(&exception) {
            return Err(crate::fault::fault!(
                "an invalid instruction or access: exception {exception}"
            ));
        }
        if system.memory.code(self.pc() & !3).is_none() {
            return Err(crate::fault::fault!("the core has left the flash"));
        }
        Ok(())
    }
}
