//! Counts the instructions of many settings of one scene on a core: one firmware draws them one
//! after another.
//!
//! [`setting`] says what can be varied, [`job`] writes the firmware's source. This module does not
//! store the counts; the report does.

mod job;
mod setting;

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::time::Duration;

use anyhow::{Result, ensure};
use serde::{Deserialize, Serialize};

pub use self::setting::{Contestant, Level, Numbers, Setting, Visitor};
use crate::measure::outcome::Report;
use crate::measure::{Core, Scene, firmware};

/// Time limit of a run. With soft floating point a frame takes minutes.
const LIMIT: Duration = Duration::from_secs(60 * 60);

pub struct Sweep<'a> {
    pub core: &'static Core,
    pub scene: &'a Scene,
    pub size: (u32, u32),
    pub settings: &'a [Setting],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Count {
    /// Instructions of the whole frame.
    pub instructions: u64,
    /// Instructions of the preparation, which are part of `instructions`.
    pub prepare: u64,
    /// Hash of the picture, by the package `frame_hash`.
    pub hash: u64,
}

impl Sweep<'_> {
    /// Builds the firmware and runs it. Calls `counted` for each setting, in the order of the settings.
    /// Builds for the same target run one after another.
    pub fn run(&self, mut counted: impl FnMut(Count)) -> Result<()> {
        let ticket = self.ticket();
        let job = |file: &Path| job::source(self, file, ticket);
        let program = firmware::build_sweep(self.core, self.scene, job)?;
        let emulator = self.core.counting_emulator().limit(LIMIT);
        let mut running = emulator.boot(&program)?;
        for index in 0..self.settings.len() {
            let line = running.line(|line| line.starts_with("measured "))?;
            let report = Report::find(&line)?;
            ensure!(
                report.number("ticket")? == ticket && report.number("run")? == index as u64,
                "the firmware reports another task"
            );
            counted(Count {
                instructions: report.number("instructions")?,
                prepare: report.number("prepare")?,
                hash: report.number("hash")?,
            });
        }
        running.end()?;
        Ok(())
    }

    /// Returns a number that identifies the task. The firmware sends it with every report.
    fn ticket(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        (self.core.name, self.size, self.settings).hash(&mut hasher);
        hasher.finish()
    }
}
