//! Counts instructions. Keeps the counts in a file for each scene, contestant, core and size, so
//! that nothing is counted twice.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use tempfile::NamedTempFile;
use xtask::measure;
use xtask::sweep::{Count, Sweep};

#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Kept {
    /// Hash of the settings, and of the sources of the firmware.
    key: u64,
    counts: Vec<Count>,
}

/// Counts all settings of a sweep, unless the file has their counts. Calls `done` for each setting.
/// `scene` is the scene's name on the command line.
pub fn count(sweep: &Sweep, scene: &Path, file: &Path, done: &dyn Fn()) -> Result<Vec<Count>> {
    let key = key(sweep, scene)?;
    if let Some(counts) = read(file, key) {
        counts.iter().for_each(|_| done());
        return Ok(counts);
    }
    let mut counts = Vec::new();
    sweep.run(|count| {
        counts.push(count);
        done();
    })?;
    let kept = Kept { key, counts };
    write(&kept, file)?;
    Ok(kept.counts)
}

/// Returns the counts in a file, if they are of this key.
fn read(file: &Path, key: u64) -> Option<Vec<Count>> {
    let kept: Kept = serde_json::from_slice(&fs::read(file).ok()?).ok()?;
    (kept.key == key).then_some(kept.counts)
}

/// Replaces the file in one step, so that it is complete even if the program is interrupted.
fn write(kept: &Kept, file: &Path) -> Result<()> {
    let folder = file.parent().unwrap_or(Path::new("."));
    let written = || -> Result<()> {
        fs::create_dir_all(folder)?;
        let mut new = NamedTempFile::new_in(folder)?;
        new.write_all(&serde_json::to_vec(kept)?)?;
        new.persist(file)?;
        Ok(())
    };
    written().with_context(|| format!("--counts: {} cannot be written", file.display()))
}

/// Returns a hash of the settings and of the sources that a firmware is made from, including the scene
/// file if there is one.
fn key(sweep: &Sweep, scene: &Path) -> Result<u64> {
    let mut hasher = DefaultHasher::new();
    (sweep.settings, measure::sources()?).hash(&mut hasher);
    if scene.is_file() {
        let text = fs::read(scene);
        let text = text.with_context(|| format!("{} cannot be read", scene.display()));
        text?.hash(&mut hasher);
    }
    Ok(hasher.finish())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_known_of_the_same_settings_and_sources_alone() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("made").join("counts.json");
        let counts = vec![Count {
            instructions: 20,
            prepare: 3,
            hash: u64::MAX,
        }];
        assert_eq!(read(&file, 1), None);
        let kept = Kept {
            key: 1,
            counts: counts.clone(),
        };
        write(&kept, &file).unwrap();
        assert_eq!(read(&file, 1), Some(counts));
        assert_eq!(read(&file, 2), None);
    }
}
