//! What was counted before, kept in a file for each scene, core and size; it counts nothing.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::{Deserialize, Serialize};
use tempfile::NamedTempFile;

use crate::point::Cost;
use crate::settings::Setting;
use command_line::Failure;

/// The counts of a scene on a core.
pub struct Cache {
    file: PathBuf,
    kept: Kept,
    /// Of all sources that a firmware is made of, as they are now.
    sources: String,
}

#[derive(Default, Serialize, Deserialize)]
struct Kept {
    /// The program that counted all settings last, and those settings.
    program: Option<(String, String)>,
    counts: BTreeMap<String, Count>,
}

#[derive(Clone, Serialize, Deserialize)]
struct Count {
    sources: String,
    pixels: u64,
    instructions: u64,
    prepare: u64,
    hash: String,
}

impl Cache {
    /// What is kept under a name; nothing if that is unreadable.
    pub fn open(folder: &Path, name: &str, sources: &str) -> Result<Self, Failure> {
        fs::create_dir_all(folder)
            .map_err(|error| format!("--counts {} cannot be made: {error}", folder.display()))?;
        let file = folder.join(format!("{name}.json"));
        let text = fs::read_to_string(&file).unwrap_or_default();
        Ok(Self {
            file,
            kept: serde_json::from_str(&text).unwrap_or_default(),
            sources: sources.to_owned(),
        })
    }

    /// What a setting takes, if that is known of the sources as they are.
    pub fn cost(&self, setting: &Setting) -> Option<Cost> {
        let count = self.kept.counts.get(&key(setting))?;
        (count.sources == self.sources).then(|| Cost {
            middle: count.instructions as f64 / count.pixels as f64,
            quartiles: None,
            prepare: Some(count.prepare),
            hash: count.hash.clone(),
        })
    }

    /// The program that counted exactly these settings.
    pub fn program(&self, settings: &[Setting]) -> Option<&str> {
        let (program, of) = self.kept.program.as_ref()?;
        let is_complete = settings
            .iter()
            .all(|it| self.kept.counts.contains_key(&key(it)));
        (is_complete && *of == fingerprint(settings)).then_some(program)
    }

    /// Takes a program for the one that counted these settings.
    pub fn set_program(&mut self, program: &str, settings: &[Setting]) -> Result<(), Failure> {
        self.kept.program = Some((program.to_owned(), fingerprint(settings)));
        self.write()
    }

    /// Takes what is kept of these settings for what the sources as they are take, too.
    pub fn renew(&mut self, settings: &[Setting]) -> Result<(), Failure> {
        for setting in settings {
            if let Some(count) = self.kept.counts.get_mut(&key(setting)) {
                count.sources.clone_from(&self.sources);
            }
        }
        self.write()
    }

    /// Keeps what was counted.
    pub fn keep(
        &mut self,
        setting: &Setting,
        pixels: u64,
        (instructions, prepare): (u64, u64),
        hash: &str,
    ) -> Result<(), Failure> {
        // From here on not all that is kept was counted by one program.
        self.kept.program = None;
        let count = Count {
            sources: self.sources.clone(),
            pixels,
            instructions,
            prepare,
            hash: hash.to_owned(),
        };
        self.kept.counts.insert(key(setting), count);
        self.write()
    }

    /// Replaces the file as a whole, so that it is whole whenever the program ends.
    fn write(&self) -> Result<(), Failure> {
        let text = serde_json::to_string_pretty(&self.kept)?;
        let folder = self.file.parent().unwrap_or(Path::new("."));
        let written = NamedTempFile::new_in(folder).and_then(|mut file| {
            file.write_all(text.as_bytes())?;
            Ok(file.persist(&self.file)?)
        });
        written.map_err(|error| format!("{} cannot be written: {error}", self.file.display()))?;
        Ok(())
    }
}

fn key(setting: &Setting) -> String {
    setting.json().to_string()
}

fn fingerprint(settings: &[Setting]) -> String {
    let mut hasher = DefaultHasher::new();
    settings
        .iter()
        .for_each(|setting| key(setting).hash(&mut hasher));
    format!("{:016x}", hasher.finish())
}

/// The folder of the repository.
pub fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The folder of what was counted, unless another one is named: in that for what cargo builds.
pub fn folder() -> PathBuf {
    let target = env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    root().join(target).join("report")
}

/// What makes a firmware: if none of it changes nothing has to be counted again.
const SOURCES: [&str; 21] = [
    "Cargo.toml",
    "src",
    "src/host/reference/model",
    "src/host/reference/prepared.rs",
    "src/host/reference/shading.rs",
    "xtask/firmware/Cargo.toml",
    "xtask/firmware/Cargo.lock",
    "xtask/firmware/build.rs",
    "xtask/firmware/memory",
    "xtask/firmware/src",
    "xtask/float_picture/src",
    "xtask/float_port/src",
    "xtask/frame_hash/src",
    "xtask/src/emulator",
    "xtask/src/measure/cores.rs",
    "xtask/src/measure/firmware.rs",
    "xtask/src/measure/float_source.rs",
    "xtask/src/measure/scene.rs",
    "xtask/src/scene_source",
    "xtask/src/sweep",
    "xtask/src/toolchain.rs",
];

/// A hash of all sources, of a scene's file if it comes from one, and of the compiler's version.
pub fn sources(scene: &Path) -> Result<String, Failure> {
    let mut hasher = DefaultHasher::new();
    let compiler = Command::new("rustc")
        .arg("-vV")
        .current_dir(root())
        .output();
    compiler
        .map(|it| it.stdout)
        .unwrap_or_default()
        .hash(&mut hasher);
    for path in SOURCES {
        add(&root().join(path), &mut hasher)?;
    }
    if scene.is_file() {
        add(scene, &mut hasher)?;
    }
    Ok(format!("{:016x}", hasher.finish()))
}

/// Adds a file, or all files below a folder but those that only a desktop sees.
fn add(path: &Path, hasher: &mut DefaultHasher) -> Result<(), Failure> {
    let unreadable = |error| format!("{} cannot be read: {error}", path.display());
    if path
        .file_name()
        .is_some_and(|name| name == "host" || name == "tests.rs")
    {
        return Ok(());
    }
    if !path.is_dir() {
        let text = fs::read(path).map_err(unreadable)?;
        (path.strip_prefix(root()).unwrap_or(path), text).hash(hasher);
        return Ok(());
    }
    let entries = fs::read_dir(path).map_err(unreadable)?;
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.map(|it| it.path()))
        .collect::<Result<_, _>>()
        .map_err(unreadable)?;
    paths.sort();
    paths.iter().try_for_each(|path| add(path, hasher))
}
