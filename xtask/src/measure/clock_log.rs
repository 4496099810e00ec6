//! How many instructions each row took: the differences of the clock readings that the measuring
//! firmware makes, as the emulator logs them.
//!
//! The firmware reports only the sum of its rows. The emulator logs every reading, so the program
//! that is measured needs no code for its rows. What is read is in `xtask/firmware/src/clock.rs`.

use std::{collections::BTreeMap, fs, path::Path};

use anyhow::{Context, Result};
use object::{Object, ObjectSection, SectionKind};

use super::cores::{Clock, Core, TIMER_SHIFT};

/// How the emulator logs the clock readings of a program.
pub enum ClockLog {
    /// A timer that counts down once in so many nanoseconds.
    Timer { nanoseconds_per_tick: u32 },
    /// The core's count of instructions. For the address behind each instruction that reads it: how
    /// the log names the register that is read into.
    Counter { registers: BTreeMap<u32, String> },
}

impl ClockLog {
    pub fn of(core: &Core, program: &Path) -> Result<Self> {
        Ok(match core.clock() {
            Clock::Timer {
                nanoseconds_per_tick,
            } => Self::Timer {
                nanoseconds_per_tick,
            },
            Clock::Counter => Self::Counter {
                registers: registers(program)?,
            },
        })
    }

    /// Returns the options with which QEMU logs the readings of the clock.
    pub fn options(&self) -> Vec<String> {
        match self {
            Self::Timer { .. } => vec!["-trace".to_owned(), TIMER_EVENT.to_owned()],
            // All registers, whenever the core comes to one of these addresses. QEMU ends a block of
            // translated instructions at each reading, so the address behind it begins one.
            Self::Counter { registers } => {
                let ranges = registers.keys().map(|at| format!("{at:#x}..{at:#x}"));
                let ranges: Vec<_> = ranges.collect();
                ["-d", "cpu", "-dfilter", &ranges.join(",")]
                    .map(str::to_owned)
                    .to_vec()
            }
        }
    }

    /// The instructions of the preparation and of each row, from the lines of a log.
    ///
    /// The firmware reads its clock twice to learn what that costs, and then before and after each of
    /// them.
    pub fn counts(&self, log: &str) -> Vec<u64> {
        let readings = match self {
            Self::Timer { .. } => timer_readings(log),
            Self::Counter { registers } => counter_readings(log, registers),
        };
        let pairs = readings.chunks_exact(2);
        let mut counts = pairs.map(|pair| self.instructions(pair[0], pair[1]));
        let overhead = counts.next().unwrap_or(0);
        counts.map(|count| count.saturating_sub(overhead)).collect()
    }

    /// Returns the executed instructions between two clock readings.
    fn instructions(&self, start: u32, end: u32) -> u64 {
        match self {
            Self::Timer {
                nanoseconds_per_tick,
            } => {
                let ticks = u64::from(start.wrapping_sub(end));
                let nanoseconds = ticks * u64::from(*nanoseconds_per_tick);
                // A tick is shorter than half an instruction, so rounding gives the exact count.
                (nanoseconds + (1 << TIMER_SHIFT) / 2) >> TIMER_SHIFT
            }
            Self::Counter { .. } => u64::from(end.wrapping_sub(start)),
        }
    }
}

/// QEMU's name of a reading of the first timer of an MPS2 board.
const TIMER_EVENT: &str = "cmsdk_apb_timer_read";

/// The values in lines such as
/// `cmsdk_apb_timer_read CMSDK APB timer read: offset 0x4 data 0xfffffffc size 4`.
fn timer_readings(log: &str) -> Vec<u32> {
    let events = log.lines().filter(|line| line.contains(TIMER_EVENT));
    let values = events.filter_map(|line| {
        let (_, data) = line.split_once(" data 0x")?;
        hexadecimal(data.split(' ').next()?)
    });
    values.collect()
}

/// The values of the named registers in lists such as `pc 80000280`, `x10/a0 000b53b5 x11/a1 ...`.
fn counter_readings(log: &str, registers: &BTreeMap<u32, String>) -> Vec<u32> {
    let (mut readings, mut wanted) = (Vec::new(), None);
    for line in log.lines() {
        let words: Vec<_> = line.split_whitespace().collect();
        for pair in words.chunks_exact(2) {
            match (pair[0], hexadecimal(pair[1])) {
                ("pc", Some(at)) => wanted = registers.get(&at),
                // QEMU may enter a block twice. Two readings are never equal: each takes an
                // instruction.
                (name, Some(value))
                    if wanted.is_some_and(|wanted| name.starts_with(wanted))
                        && readings.last() != Some(&value) =>
                {
                    readings.push(value);
                }
                _ => {}
            }
        }
    }
    readings
}

fn hexadecimal(digits: &str) -> Option<u32> {
    u32::from_str_radix(digits, 16).ok()
}

/// Finds the instructions `csrr register, minstret` of a program.
fn registers(program: &Path) -> Result<BTreeMap<u32, String>> {
    let unreadable = || format!("cannot read {}", program.display());
    let bytes = fs::read(program).with_context(unreadable)?;
    let file = object::File::parse(&*bytes).with_context(unreadable)?;
    let mut found = BTreeMap::new();
    for section in file.sections() {
        if section.kind() == SectionKind::Text {
            found.extend(readings_in(section.address() as u32, section.data()?));
        }
    }
    Ok(found)
}

/// The same in the machine code at an address.
fn readings_in(start: u32, code: &[u8]) -> impl Iterator<Item = (u32, String)> {
    /// The RISC-V Instruction Set Manual, volume I, "Zicsr": CSRRS with the register x0.
    const READ_MINSTRET: u32 = 0xb020_2073;
    const DESTINATION: u32 = 0x1f << 7;
    // Instructions lie at even addresses.
    let words = code.windows(4).step_by(2).zip((start..).step_by(2));
    words.filter_map(|(bytes, at)| {
        let word = u32::from_le_bytes(bytes.try_into().ok()?);
        let is_read = word & !DESTINATION == READ_MINSTRET;
        is_read.then(|| (at + 4, format!("x{}/", (word & DESTINATION) >> 7)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_of_a_timer_become_instructions() {
        let line = |value: u32| {
            format!(
                "cmsdk_apb_timer_read CMSDK APB timer read: offset 0x4 data {value:#x} size 4\n"
            )
        };
        // An instruction takes 3.2 ticks: one between the first two readings, then 1001 and 11.
        let readings = [9000, 8997, 8000, 4797, 4000, 3965];
        let log = "measured a=1\n".to_owned() + &readings.map(line).concat();
        let clock = ClockLog::Timer {
            nanoseconds_per_tick: 40,
        };
        assert_eq!(clock.counts(&log), [1000, 10]);
        assert_eq!(clock.counts("measured a=1\n"), [0; 0]);
    }

    #[test]
    fn counts_of_a_core_are_found_in_its_registers() {
        let block = |at: u32, a0: u32, s2: u32| {
            format!(
                " pc       {at:08x}\n x10/a0   {a0:08x} x1/ra    00000007\n x18/s2   {s2:08x}\n"
            )
        };
        let blocks = [
            (16, 5, 0),
            (32, 0, 6),
            (16, 50, 0),
            (16, 50, 0),
            (32, 0, 71),
            (48, 1, 1),
        ];
        let log = blocks.map(|(at, a0, s2)| block(at, a0, s2)).concat();
        let registers = [(16, "x10/".to_owned()), (32, "x18/".to_owned())];
        let clock = ClockLog::Counter {
            registers: registers.into(),
        };
        assert_eq!(clock.counts(&log), [20]);
    }

    #[test]
    fn readings_of_the_core_s_count_are_found_in_machine_code() {
        // c.nop; csrr s2, minstret; csrr s2, mcycle.
        let code = [1, 0, 0x73, 0x29, 0x20, 0xb0, 0x73, 0x29, 0x00, 0xb0];
        let found: Vec<_> = readings_in(0x100, &code).collect();
        assert_eq!(found, [(0x106, "x18/".to_owned())]);
    }
}
