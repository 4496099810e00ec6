//! Runs the firmware for a task, and says what the task came to.

use std::cmp::Reverse;

use anyhow::{Context, Result, ensure};

use super::clock_log::ClockLog;
use super::firmware::{self, RUN_LIMIT};
use super::ledger;
use super::task::Task;

/// Counts of one measured task: instructions, stack and hash. [`weight`](super::weight) has its bytes.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Instructions of the whole frame.
    pub instructions: u64,
    /// Executed instructions of the frame's preparation, before its first row.
    pub prepare: u64,
    /// Executed instructions of each row, from the top down.
    pub rows: Vec<u64>,
    /// Most bytes of stack at a time.
    pub stack: u64,
    /// Hash of the pixels of the frame.
    pub hash: u64,
}

/// Builds and runs the firmware for a task.
pub fn run(task: &Task) -> Result<Outcome> {
    let programs = firmware::build(task)?;
    let clock = ClockLog::of(task.core, &programs.scene)?;
    let emulator = task.core.counting_emulator().args(clock.options());
    let title = format!("{} on {}", task.scene.name(), task.core.name);
    let run = || emulator.limit(RUN_LIMIT).run(&programs.scene);
    let said = ledger::timed("run", &title, run)?;
    let report = Report::find(&said)?;
    ensure!(
        report.number("ticket")? == programs.ticket,
        "the firmware reports another task"
    );
    let (instructions, prepare) = (report.number("instructions")?, report.number("prepare")?);
    let mut counts = clock.counts(&said);
    if super::moving::moved(&said).is_some() {
        counts.drain(..counts.len().min(1)); // The move comes before the frame.
    }
    ensure!(
        !counts.is_empty(),
        "the emulator logs no readings of the clock: QEMU has to be built with its `log` trace backend"
    );
    ensure!(
        counts.len() == 1 + task.settings.size.height as usize
            && counts[0] == prepare
            && counts.iter().sum::<u64>() == instructions,
        "the emulator's log shows other counts than the firmware reports"
    );
    Ok(Outcome {
        instructions,
        prepare,
        rows: counts[1..].to_vec(),
        stack: report.number("stack")?,
        hash: report.number("hash")?,
    })
}

impl Outcome {
    /// The row that took the most instructions, and how many. Row 0 is the top one; of equal rows it
    /// is the upper one.
    pub fn worst_row(&self) -> (u32, u64) {
        let upper_first = |&(row, count): &(u32, u64)| (count, Reverse(row));
        let rows = (0..).zip(self.rows.iter().copied());
        rows.max_by_key(upper_first).unwrap_or_default()
    }
}

/// The line of text in which a measuring program reports its numbers.
pub(crate) struct Report<'a>(&'a str);

impl<'a> Report<'a> {
    pub(crate) fn find(said: &'a str) -> Result<Self> {
        let mut lines = said.lines();
        let line = lines.find_map(|line| line.strip_prefix("measured "));
        let line = line.with_context(|| format!("the firmware reports nothing, but: {said}"))?;
        Ok(Self(line))
    }

    pub(crate) fn number(&self, name: &str) -> Result<u64> {
        let mut words = self.0.split(' ').filter_map(|word| word.split_once('='));
        let (_, digits) = words
            .find(|(key, _)| *key == name)
            .with_context(|| format!("the firmware reports no `{name}`: {}", self.0))?;
        u64::from_str_radix(digits, 16).with_context(|| format!("`{digits}` is no number"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_by_name() {
        let report = Report::find("noise\nmeasured a=000000000000001f b=2\n").unwrap();
        assert_eq!(report.number("a").unwrap(), 31);
        assert_eq!(report.number("b").unwrap(), 2);
        assert!(report.number("c").is_err());
        assert!(Report::find("noise").is_err());
    }

    #[test]
    fn worst_row_is_the_upper_one_of_equals() {
        let outcome = Outcome {
            instructions: 15,
            prepare: 1,
            rows: vec![2, 5, 5, 2],
            stack: 0,
            hash: 0,
        };
        assert_eq!(outcome.worst_row(), (1, 5));
    }
}
