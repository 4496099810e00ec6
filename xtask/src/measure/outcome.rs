//! Runs the firmware for a task, and says what the task came to.

use anyhow::{Context, Result, ensure};

use super::firmware::{self, RUN_LIMIT};
use super::ledger;
use super::task::Task;

/// Counts of one measured task: instructions, stack and hash. [`weight`](super::weight) has its bytes.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Executed instructions of the frame's preparation, before its first row.
    pub prepare: u64,
    /// Those of the even rows and of the odd ones: two cores draw a frame so. Row 0 is the top one.
    pub halves: [u64; 2],
    /// The row that took the most, the upper one of equals, and how many.
    pub worst_row: (u32, u64),
    /// Most bytes of stack at a time.
    pub stack: u64,
    pub hash: u64,
}

/// Builds and runs the firmware for a task.
pub fn run(task: &Task) -> Result<Outcome> {
    let programs = firmware::build(task)?;
    let emulator = task.core.counting_emulator();
    let title = format!("{} on {}", task.scene.name(), task.core.name);
    let run = || emulator.limit(RUN_LIMIT).run(&programs.scene);
    let said = ledger::timed("run", &title, run)?;
    let report = Report::find(&said)?;
    ensure!(
        report.number("ticket")? == programs.ticket,
        "the firmware reports another task"
    );
    Ok(Outcome {
        prepare: report.number("prepare")?,
        halves: [report.number("even")?, report.number("odd")?],
        worst_row: (report.number("worst_row")? as u32, report.number("worst")?),
        stack: report.number("stack")?,
        hash: report.number("hash")?,
    })
}

impl Outcome {
    /// Instructions of all rows, without the preparation.
    pub fn drawing(&self) -> u64 {
        self.halves.iter().sum()
    }

    pub fn instructions(&self) -> u64 {
        self.prepare + self.drawing()
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
}
