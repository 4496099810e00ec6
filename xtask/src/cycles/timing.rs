//! Gives the cycles of an instruction, as Arm publishes them.
//!
//! | core | source |
//! |---|---|
//! | M0+ | Cortex-M0+ Technical Reference Manual, ARM DDI 0484C, table 3-1 |
//! | M3 | Cortex-M3 Technical Reference Manual, ARM DDI 0337I, table 3-1 and section 3.3.2 |
//! | M4 | Cortex-M4 Technical Reference Manual, ARM DDI 0439D, table 3-1, section 3.3.2, table 7-1 |
//! | M33 | Arm publishes none. Measured on an RP2350 by the author of the crate `rp2350-emu` 0.2.6, `src/core` |
//!
//! All of them assume memory without wait states.

use super::decode::{Instruction, Kind};

/// An executed instruction and its context: the instruction before it and whether it jumps.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub instruction: Instruction,
    pub previous: Option<Instruction>,
    /// Whether the next executed instruction is not the following one in memory.
    pub jumps: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timing {
    /// Cortex-M0+ with the single-cycle multiplier.
    M0Plus,
    M3,
    M4,
    M33,
}

/// Cycles in which a Cortex-M3 or M4 refills its pipeline. Arm says 1 to 3.
const REFILL: f64 = 2.0;

/// Cycles of a division. Arm says 2 to 12, depending on the operands.
const DIVIDE: f64 = 7.0;

/// Cycles of a long multiplication on a Cortex-M3, without and with an addition. Arm says 3 to 5,
/// and 4 to 7 with an addition, depending on the operands.
const M3_LONG_MULTIPLY: [f64; 2] = [4.0, 5.5];

impl Timing {
    /// Returns who says what an instruction takes, as the end of a sentence.
    pub fn source(self) -> &'static str {
        match self {
            Self::M33 => "the author of rp2350-emu measured",
            _ => "Arm publishes",
        }
    }

    pub fn cycles(self, step: &Step) -> f64 {
        match self {
            Self::M0Plus => f64::from(m0_plus(step)),
            Self::M3 => m3_or_m4(step, M3_LONG_MULTIPLY),
            Self::M4 => m3_or_m4(step, [1.0; 2]),
            Self::M33 => f64::from(m33(step)),
        }
    }
}

fn m0_plus(step: &Step) -> u32 {
    let instruction = &step.instruction;
    match instruction.kind {
        Kind::Load | Kind::Store | Kind::StoreIndexed => 2,
        Kind::LoadMany(words) if instruction.sets_counter() => 3 + words,
        Kind::LoadMany(words) | Kind::StoreMany(words) => 1 + words,
        Kind::Call | Kind::Special | Kind::Barrier => 3,
        // A branch that is not taken takes 1 cycle.
        _ if step.jumps => 2,
        _ => 1,
    }
}

/// Cycles of a division on a Cortex-M33: the middle of the 1 to 12 that depend on the operands.
const M33_DIVIDE: u32 = 6;

fn m33(step: &Step) -> u32 {
    let instruction = &step.instruction;
    match instruction.kind {
        Kind::Load | Kind::Store | Kind::StoreIndexed => 2,
        Kind::LoadMany(words) if instruction.sets_counter() => 4 + words,
        Kind::LoadMany(words) | Kind::StoreMany(words) => 1 + words,
        Kind::FloatLoad(words) | Kind::FloatStore(words) | Kind::FloatMany(words) => 1 + words,
        Kind::Combined | Kind::Multiply | Kind::MultiplyAdd => 2,
        Kind::LongMultiply | Kind::LongMultiplyAdd => 2,
        Kind::FloatMultiplyAdd => 3,
        Kind::FloatDivideOrRoot => 14,
        Kind::Divide => M33_DIVIDE,
        Kind::TableJump => 4,
        _ => 1,
    }
}

/// Returns the cycles of a step on a Cortex-M3 or M4. `long` has the cycles of a long
/// multiplication, without and with an addition.
fn m3_or_m4(step: &Step, long: [f64; 2]) -> f64 {
    let instruction = &step.instruction;
    let refill = match instruction.kind {
        // The 6 cycles of a table jump include the refill.
        Kind::TableJump => 0.0,
        _ if step.jumps => REFILL,
        _ => 0.0,
    };
    let words = |words: u32| 1.0 + f64::from(words);
    let own = match instruction.kind {
        Kind::Load | Kind::StoreIndexed => 2.0 - overlap(step),
        Kind::LoadMany(count) | Kind::StoreMany(count) => words(count),
        Kind::FloatLoad(count) | Kind::FloatStore(count) | Kind::FloatMany(count) => words(count),
        Kind::Divide => DIVIDE,
        Kind::TableJump => 6.0,
        Kind::FloatMovePair | Kind::MultiplyAdd => 2.0,
        Kind::LongMultiply => long[0],
        Kind::LongMultiplyAdd => long[1],
        Kind::FloatMultiplyAdd => 3.0,
        Kind::FloatDivideOrRoot => 14.0,
        _ => 1.0,
    };
    own + refill + late_address(step)
}

/// Returns the cycle that a load or a store saves directly after a load: 1 if the two overlap, else
/// 0. They do not overlap if the address needs the loaded value.
fn overlap(step: &Step) -> f64 {
    let shares = step.previous.is_some_and(|previous| {
        previous.kind == Kind::Load && previous.sets & step.instruction.address == 0
    });
    if shares { 1.0 } else { 0.0 }
}

/// Returns the cycle that a load or a store waits for an address that the instruction before
/// computed: 1 if it waits, else 0.
fn late_address(step: &Step) -> f64 {
    let waits = step.previous.is_some_and(|previous| {
        let is_loaded = matches!(previous.kind, Kind::Load | Kind::LoadMany(_));
        !is_loaded && previous.sets & step.instruction.address != 0
    });
    if waits { 1.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(kind: Kind) -> Instruction {
        Instruction {
            size: 2,
            kind,
            sets: 0,
            address: 0,
        }
    }

    fn cycles(timing: Timing, instruction: Instruction, jumps: bool) -> f64 {
        let previous = None;
        timing.cycles(&Step {
            instruction,
            previous,
            jumps,
        })
    }

    #[test]
    fn branches_take_more_where_they_are_taken() {
        let branch = plain(Kind::Branch);
        let both = |timing| [false, true].map(|jumps| cycles(timing, branch, jumps));
        assert_eq!(both(Timing::M0Plus), [1.0, 2.0]);
        assert_eq!(both(Timing::M3), [1.0, 3.0]);
        assert_eq!(both(Timing::M4), [1.0, 3.0]);
    }

    #[test]
    fn shifting_an_operand_takes_a_cycle_on_a_cortex_m33_only() {
        let all = [Timing::M0Plus, Timing::M3, Timing::M4, Timing::M33];
        let cycles = all.map(|it| cycles(it, plain(Kind::Combined), false));
        assert_eq!(cycles, [1.0, 1.0, 1.0, 2.0]);
    }

    #[test]
    fn long_multiplications_are_what_sets_the_cores_apart() {
        let all = |kind| {
            [Timing::M0Plus, Timing::M3, Timing::M4].map(|it| cycles(it, plain(kind), false))
        };
        assert_eq!(all(Kind::Multiply), [1.0, 1.0, 1.0]);
        assert_eq!(all(Kind::LongMultiply)[1..], [4.0, 1.0]);
        assert_eq!(all(Kind::LongMultiplyAdd)[1..], [5.5, 1.0]);
    }

    #[test]
    fn returning_by_popping_takes_a_refill_more() {
        let pop = Instruction {
            sets: 1 << 4 | 1 << 15,
            ..plain(Kind::LoadMany(2))
        };
        assert_eq!(cycles(Timing::M0Plus, pop, true), 5.0);
        assert_eq!(cycles(Timing::M3, pop, true), 5.0);
    }

    #[test]
    fn loads_in_a_row_overlap_unless_one_needs_the_other() {
        let load = |sets, address| Instruction {
            sets,
            address,
            ..plain(Kind::Load)
        };
        let after = |previous, instruction| {
            let previous = Some(previous);
            Timing::M3.cycles(&Step {
                instruction,
                previous,
                jumps: false,
            })
        };
        assert_eq!(after(load(1, 2), load(2, 4)), 1.0);
        assert_eq!(after(load(4, 2), load(2, 4)), 2.0);
        let sum = Instruction {
            sets: 4,
            ..plain(Kind::Plain)
        };
        assert_eq!(after(sum, load(2, 4)), 3.0);
    }
}
