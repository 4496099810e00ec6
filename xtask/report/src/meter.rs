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
    /// Hash of the settings.
    settings: u64,
    sources: u64,
    /// Fingerprint of the program that counted all settings.
    program: Option<u64>,
    /// Counts of the first settings of the sweep.
    counts: Vec<Count>,
}

/// Counts all settings of a sweep whose counts are not in the file yet. Calls `done` after each
/// setting. `scene` is the scene's name on the command line.
pub fn count(mut sweep: Sweep, scene: &Path, file: &Path, done: &dyn Fn()) -> Result<Vec<Count>> {
    let (mut kept, old) = Kept::read(file, hash(sweep.settings), sources(scene)?);
    sweep.known = kept.counts.len();
    (0..sweep.known).for_each(|_| done());
    if sweep.known == sweep.settings.len() {
        return Ok(kept.counts);
    }
    let program = sweep.build()?;
    let fingerprint = Some(program.fingerprint()?);
    if let Some(old) = old.filter(|it| it.program == fingerprint) {
        kept.counts = old.counts;
        kept.counts.iter().for_each(|_| done());
    } else {
        program.run(|count| {
            kept.counts.push(count);
            done();
            kept.write(file)
        })?;
    }
    // A program that skips known settings has another fingerprint.
    kept.program = fingerprint.filter(|_| sweep.known == 0);
    kept.write(file)?;
    Ok(kept.counts)
}

impl Kept {
    /// Returns the counts in the file if its settings and sources are these. If only the sources
    /// differ, returns no counts, and those of the file as the second value.
    fn read(file: &Path, settings: u64, sources: u64) -> (Self, Option<Self>) {
        let text = fs::read_to_string(file).unwrap_or_default();
        let found = serde_json::from_str(&text).ok();
        match found.filter(|it: &Self| it.settings == settings) {
            Some(kept) if kept.sources == sources => (kept, None),
            old => {
                let (program, counts) = (None, Vec::new());
                let kept = Self {
                    settings,
                    sources,
                    program,
                    counts,
                };
                (kept, old)
            }
        }
    }

    /// Replaces the file in one step, so that it is complete even if the program is interrupted.
    fn write(&self, file: &Path) -> Result<()> {
        let folder = file.parent().unwrap_or(Path::new("."));
        let written = || -> Result<()> {
            fs::create_dir_all(folder)?;
            let mut new = NamedTempFile::new_in(folder)?;
            new.write_all(&serde_json::to_vec(self)?)?;
            new.persist(file)?;
            Ok(())
        };
        written().with_context(|| format!("--counts: {} cannot be written", file.display()))
    }
}

fn hash(value: impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

/// Returns a hash of the sources that a firmware is made from, including the scene file if there is
/// one.
fn sources(scene: &Path) -> Result<u64> {
    let mut hasher = DefaultHasher::new();
    measure::sources()?.hash(&mut hasher);
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
        let count = Count {
            instructions: 20,
            prepare: 3,
            hash: u64::MAX,
        };
        let (mut kept, old) = Kept::read(&file, 1, 2);
        assert_eq!((kept.counts.len(), old), (0, None));
        kept.counts.push(count);
        kept.write(&file).unwrap();
        let (kept, old) = Kept::read(&file, 1, 2);
        assert_eq!((kept.counts.as_slice(), old), ([count].as_slice(), None));
        let (other, old) = Kept::read(&file, 1, 3);
        assert_eq!((other.counts.len(), old), (0, Some(kept)));
        let (other, old) = Kept::read(&file, 9, 2);
        assert_eq!((other.counts.len(), old), (0, None));
    }
}
