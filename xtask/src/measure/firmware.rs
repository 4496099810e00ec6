//! Builds the measurement firmware for a task, and weighs what was built. It runs nothing.

use std::{
    fs::{self, File},
    hash::{DefaultHasher, Hash, Hasher},
    path::{Path, PathBuf},
    time::Duration,
};

use anyhow::{Context, Result, bail};
use object::{Object, ObjectSection, SectionFlags, elf};
use rustix::fs::FlockOperation;

use super::{build_profile::BuildProfile, cores::Core, images, scene::Scene, task::Task};
use crate::{root, toolchain};

/// A first build compiles a dozen crates; later ones take seconds.
const BUILD_LIMIT: Duration = Duration::from_secs(10 * 60);

/// Ten thousand million instructions take about a minute.
pub const RUN_LIMIT: Duration = Duration::from_secs(10 * 60);

/// Bytes of a linked program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Weight {
    /// Bytes of machine code in a firmware.
    pub code: u64,
    /// Bytes in flash: code, constants, and first values of variables.
    pub flash: u64,
    /// Bytes of static variables in a firmware.
    pub ram: u64,
}

impl Weight {
    /// Returns how many bytes more this program has than another.
    fn beyond(self, other: Self) -> Self {
        Self {
            code: self.code.saturating_sub(other.code),
            flash: self.flash.saturating_sub(other.flash),
            ram: self.ram.saturating_sub(other.ram),
        }
    }
}

/// Builds the firmware for a task and weighs it.
pub fn weight(task: &Task) -> Result<Weight> {
    build(task)?.weight()
}

/// Builds the firmware for a task and does something with the program that draws the scene.
pub fn with_program<R>(task: &Task, run: impl FnOnce(&Path) -> Result<R>) -> Result<R> {
    run(&build(task)?.scene)
}

/// Whether a symbol is that of a function whose instructions are counted.
pub fn is_counted(symbol: &str) -> bool {
    symbol.contains("Contestant") && (symbol.contains("7prepare") || symbol.contains("3row"))
}

/// Two linked programs: one draws the scene, the other an empty frame.
pub(super) struct Programs {
    pub(super) scene: PathBuf,
    empty: PathBuf,
    pub(super) ticket: u64,
}

impl Programs {
    /// Returns the bytes that the program of the scene has beyond the empty one.
    pub(super) fn weight(&self) -> Result<Weight> {
        Ok(weigh(&self.scene)?.beyond(weigh(&self.empty)?))
    }
}

/// Where the firmware for a core is built.
struct Place {
    /// The job, and the source of a scene from a file.
    jobs: PathBuf,
    /// Folder in which cargo builds. Cores of one target share it.
    target: PathBuf,
}

impl Place {
    fn of(core: &Core) -> Self {
        let place = toolchain::target_directory().join("firmware");
        Self {
            jobs: place.join(core.name),
            target: place.join(core.target),
        }
    }

    /// Returns the path of the Rust source that is written for a scene file.
    fn scene(&self) -> PathBuf {
        self.jobs.join("scene.rs")
    }

    /// Waits until nobody else builds there, in this process or another. The lock is held until the
    /// file is dropped.
    fn lock(&self) -> Result<File> {
        let lock = [&self.jobs, &self.target]
            .into_iter()
            .try_for_each(fs::create_dir_all)
            .and_then(|()| File::create(self.target.join("lock")))
            .with_context(|| format!("cannot write in {}", self.target.display()))?;
        rustix::fs::flock(&lock, FlockOperation::LockExclusive)
            .with_context(|| format!("cannot lock {}", self.target.display()))?;
        Ok(lock)
    }
}

/// Returns the programs that measure a task, and builds them if they are not there.
pub(super) fn build(task: &Task) -> Result<Programs> {
    let place = Place::of(task.core);
    let job = task.job(&place.scene());
    let source = job.source;
    let (target, profile) = (task.core.target, task.profile);
    let programs = Programs {
        scene: images::place(("scene", &source, task.scene.source(), target, profile.name))?,
        // It has the job's size and ticket, too.
        empty: images::place(("empty", &source, target, profile.name))?,
        ticket: job.ticket,
    };
    let wanted = [("scene", &*programs.scene), ("empty", &*programs.empty)];
    make(task.core, &task.scene, &source, &wanted, profile, &[])?;
    Ok(programs)
}

/// The firmware that goes through several settings of a scene; `job` makes its source of the place
/// where the source of a file's scene lies.
pub(crate) fn build_sweep(
    core: &Core,
    scene: &Scene,
    job: impl FnOnce(&Path) -> String,
) -> Result<PathBuf> {
    let source = job(&Place::of(core).scene());
    let program = images::place(("sweep", &source, scene.source(), core.target))?;
    let chosen = ["--bin", "sweep", "--features", "sweep"];
    let (wanted, profile) = ([("sweep", &*program)], BuildProfile::RECOMMENDED);
    make(core, scene, &source, &wanted, profile, &chosen)?;
    Ok(program)
}

/// Builds the wanted programs of a job and keeps each where it is wanted. What is there is taken as
/// it is.
fn make(
    core: &Core,
    scene: &Scene,
    job: &str,
    wanted: &[(&str, &Path)],
    profile: &BuildProfile,
    chosen: &[&str],
) -> Result<()> {
    let are_there = || wanted.iter().all(|(_, kept)| kept.is_file());
    if are_there() {
        return Ok(());
    }
    let place = Place::of(core);
    let _lock = place.lock()?;
    // Somebody else may have built them in the meantime.
    if are_there() {
        return Ok(());
    }
    if let Some(text) = scene.source() {
        write(&place.scene(), text)?;
    }
    let source = place.jobs.join("job.rs");
    write(&source, job)?;
    compile(core, &source, &place.target, &[profile.arguments, chosen])?;
    let built = place.target.join(core.target).join(profile.folder);
    let keep = |(name, kept): &(&str, &Path)| images::keep(&built.join(name), kept);
    wanted.iter().try_for_each(keep)
}

fn compile(core: &Core, job: &Path, target: &Path, chosen: &[&[&str]]) -> Result<()> {
    let manifest = root().join("xtask/firmware/Cargo.toml");
    toolchain::BareMetal::get()?
        .cargo("build", &[core.target])
        .args(["--quiet", "--locked", "--manifest-path"])
        .args([&manifest])
        .args(["--target-dir"])
        .args([target])
        .args(chosen.concat())
        // Instead of what any configuration says: figures must not depend on it.
        .env("CARGO_ENCODED_RUSTFLAGS", core.link_arguments())
        .env("MEASURE_JOB", job)
        .limit(BUILD_LIMIT)
        .read()?;
    Ok(())
}

/// Writes a file, unless it says that already: then nothing has to be compiled again.
fn write(path: &Path, text: &str) -> Result<()> {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return Ok(());
    }
    fs::write(path, text).with_context(|| format!("cannot write {}", path.display()))
}

/// A hash of all that a program puts into flash: the same for programs that do the same, wherever
/// their sources lie and whatever their comments say.
pub(crate) fn fingerprint(program: &Path) -> Result<u64> {
    let unreadable = || format!("cannot read {}", program.display());
    let bytes = fs::read(program).with_context(unreadable)?;
    let program = object::File::parse(&*bytes).with_context(unreadable)?;
    let mut hasher = DefaultHasher::new();
    for section in program.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else {
            bail!("a firmware is an ELF file");
        };
        if sh_flags & u64::from(elf::SHF_ALLOC) != 0 {
            (section.name()?, section.address(), section.data()?).hash(&mut hasher);
        }
    }
    Ok(hasher.finish())
}

/// The bytes of a program that flash and RAM hold.
pub fn weigh(program: &Path) -> Result<Weight> {
    let unreadable = || format!("cannot read {}", program.display());
    let bytes = fs::read(program).with_context(unreadable)?;
    let program = object::File::parse(&*bytes).with_context(unreadable)?;
    let mut weight = Weight {
        code: 0,
        flash: 0,
        ram: 0,
    };
    for section in program.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else {
            bail!("a firmware is an ELF file");
        };
        // The start-up code's names for what is left over.
        let is_room = matches!(section.name()?, ".stack" | ".heap");
        if sh_flags & u64::from(elf::SHF_ALLOC) == 0 || is_room {
            continue;
        }
        let has_content = section.file_range().is_some();
        weight.flash += if has_content { section.size() } else { 0 };
        let is_code = sh_flags & u64::from(elf::SHF_EXECINSTR) != 0;
        weight.code += if is_code { section.size() } else { 0 };
        let is_variable = sh_flags & u64::from(elf::SHF_WRITE) != 0;
        weight.ram += if is_variable { section.size() } else { 0 };
    }
    Ok(weight)
}
