//! Counts the instructions of scenes in many settings on a core: one firmware draws them one after another.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::time::Duration;

use anyhow::{Result, ensure};
use command_line::Quality;

use crate::measure::outcome::Report;
use crate::measure::{Core, Scene, Size, firmware, task};

const LIMIT: Duration = Duration::from_secs(60 * 60);

pub struct Sweep {
    pub core: &'static Core,
    pub size: Size,
    /// Scenes, each with its settings. At most the first is that of a file.
    pub scenes: Vec<(Scene, Vec<Setting>)>,
}

/// A setting of a frame, which is lit in Blinn-Phong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Setting {
    pub quality: Quality,
    /// Largest number of reflections.
    pub reflections: u8,
    /// Width and height of a drawn pixel, in pixels of the picture; at least 1.
    pub scale: u8,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    pub instructions: u64,
    /// Instructions of the preparation, which are part of `instructions`.
    pub prepare: u64,
    /// Hash of the picture, by the package `frame_hash`.
    pub hash: u64,
}

impl Setting {
    pub fn words(&self) -> String {
        let mut words = format!("N = {}, {}", self.reflections, self.quality.name());
        if self.scale > 1 {
            words += &format!(", {0} x {0} pixels", self.scale);
        }
        words
    }
}

impl Sweep {
    /// Builds the firmware and runs it. Calls `counted` for each setting, in the order of the settings.
    /// Builds for the same target run one after another.
    pub fn run(&self, mut counted: impl FnMut(Count)) -> Result<()> {
        let ticket = self.ticket();
        let job = |file: &Path| self.job(file, ticket);
        let file = self.scenes.first().and_then(|(scene, _)| scene.source());
        let program = firmware::build_sweep(self.core, self.size, file, job)?;
        let emulator = self.core.counting_emulator().limit(LIMIT);
        let mut running = emulator.boot(&program)?;
        let runs = self.scenes.iter().flat_map(|(_, settings)| settings);
        for index in 0..runs.count() {
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
        self.core.name.hash(&mut hasher);
        for (scene, settings) in &self.scenes {
            (scene.name(), settings).hash(&mut hasher);
        }
        hasher.finish()
    }

    /// Returns the source that the firmware includes. `file` is the path of the source of a scene file's
    /// scene.
    fn job(&self, file: &Path, ticket: u64) -> String {
        let (mut source, mut runs) = (task::ticket(ticket), String::new());
        for (index, (scene, settings)) in self.scenes.iter().enumerate() {
            let (module, scene, view) = scene.names(file);
            source += &format!(
                "mod scene{index} {{\n{module}pub type Scene = {scene};\npub struct Seen;\n\n{view}}}\n\n"
            );
            for setting in settings {
                let quality = setting.quality.type_name();
                runs += &format!(
                    "    firmware::Run {{ reflections: {}, scale: {}, draw: firmware::swept::<\
                     scene{index}::Scene, scene{index}::Seen, reflet::quality::{quality}> }},\n",
                    setting.reflections, setting.scale
                );
            }
        }
        source + &format!("pub const RUNS: &[firmware::Run] = &[\n{runs}];\n")
    }
}
