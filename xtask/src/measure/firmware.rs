//! Builds the measurement firmware for a task, and weighs what was built. It runs nothing.

use std::{
    fs::{self, File},
    hash::{DefaultHasher, Hash, Hasher},
    path::{Path, PathBuf},
    time::Duration,
};

use anyhow::{Context, Result, bail};
use embedded_graphics::geometry::Size;
use object::{Object, ObjectSection, ObjectSymbol, SectionFlags, elf};
use rustix::fs::FlockOperation;

use super::{build_profile::BuildProfile, cores::Core, images, ledger, task, task::Task};
use crate::toolchain;

/// A first build compiles a dozen crates; later ones take seconds.
const BUILD_LIMIT: Duration = Duration::from_secs(10 * 60);

/// Ten thousand million instructions take about a minute.
pub const RUN_LIMIT: Duration = Duration::from_secs(10 * 60);

/// Bytes of a linked program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Weight {
    pub code: u64,
    /// Bytes in flash: code, constants, and first values of variables.
    pub flash: u64,
    /// Bytes of static variables in a firmware.
    pub ram: u64,
}

impl Weight {
    fn beyond(self, other: Self) -> Self {
        Self {
            code: self.code.saturating_sub(other.code),
            flash: self.flash.saturating_sub(other.flash),
            ram: self.ram.saturating_sub(other.ram),
        }
    }
}

/// Builds the firmware for a task, and returns the bytes that it has beyond one that draws nothing.
pub fn weight(task: &Task) -> Result<Weight> {
    Ok(weigh(&build(task)?.scene)?.beyond(weigh(&empty(task)?)?))
}

/// Builds the firmware for a task and does something with the program that draws the scene.
pub fn with_program<R>(task: &Task, run: impl FnOnce(&Path) -> Result<R>) -> Result<R> {
    run(&build(task)?.scene)
}

/// Whether a symbol is that of a function whose instructions are counted.
pub fn is_counted(symbol: &str) -> bool {
    symbol.contains("Contestant") && (symbol.contains("7prepare") || symbol.contains("3row"))
}

/// The linked program of a task, and the number that comes back with its report.
pub(super) struct Program {
    pub(super) scene: PathBuf,
    pub(super) ticket: u64,
}

/// Where the firmware for a core is built.
struct Place {
    /// The job, and the source of a scene from a file.
    jobs: PathBuf,
    target: PathBuf,
}

impl Place {
    fn of(core: &Core) -> Self {
        let place = toolchain::target_directory().join("firmware");
        Self {
            jobs: place.join(core.name),
            target: toolchain::directory_for(core.target),
        }
    }

    /// Returns the path of the Rust source that is written for a scene file.
    fn scene(&self) -> PathBuf {
        self.jobs.join("scene.rs")
    }

    /// Waits until nobody else builds there, in this process or another. The lock is held until the
    /// file is dropped.
    fn lock(&self) -> Result<File> {
        let target = &self.target;
        let lock = [&self.jobs, target]
            .into_iter()
            .try_for_each(fs::create_dir_all)
            .and_then(|()| File::create(target.join("lock")))
            .with_context(|| format!("cannot write in {}", target.display()))?;
        rustix::fs::flock(&lock, FlockOperation::LockExclusive)
            .with_context(|| format!("cannot lock {}", target.display()))?;
        Ok(lock)
    }
}

/// Returns the program that measures a task, and builds it if it is not there.
pub(super) fn build(task: &Task) -> Result<Program> {
    let (source, ticket) = task.job(&Place::of(task.core).scene());
    let text = task.scene.source();
    let program = program("scene", task.core, text, &source, task.profile)?;
    Ok(Program {
        scene: sized(&program, task.settings.size)?,
        ticket,
    })
}

/// Returns the program that draws nothing: one for all scenes and settings.
fn empty(task: &Task) -> Result<PathBuf> {
    /// As long as any other, so that the code that reports it is the same.
    const TICKET: u64 = 0x0123_4567_89ab_cdef;
    let source = task::ticket(TICKET);
    program("empty", task.core, None, &source, task.profile)
}

/// The firmware that goes through several scenes and settings; `job` makes its source of the place where the source
/// of a file's scene, `scene`, lies.
pub(crate) fn build_sweep(
    core: &Core,
    size: Size,
    scene: Option<&str>,
    job: impl FnOnce(&Path) -> String,
) -> Result<PathBuf> {
    let source = job(&Place::of(core).scene());
    let profile = BuildProfile::RECOMMENDED;
    sized(&program("sweep", core, scene, &source, profile)?, size)
}

/// Returns a copy of a program that draws pictures of this size.
fn sized(program: &Path, size: Size) -> Result<PathBuf> {
    let copy = images::place((program, size.width, size.height))?;
    if !copy.is_file() {
        let mut bytes = images::read(program)?;
        let sides = [size.width, size.height].map(u32::to_le_bytes).concat();
        let place = place_of_size(&bytes).and_then(|at| bytes.get_mut(at..at + sides.len()));
        let place = place.with_context(|| format!("{} has no SIZE", program.display()))?;
        place.copy_from_slice(&sides);
        images::keep(&bytes, &copy)?;
    }
    Ok(copy)
}

/// Returns where the size of the picture stands in the file of a program.
fn place_of_size(program: &[u8]) -> Option<usize> {
    let program = object::File::parse(program).ok()?;
    let size = program.symbol_by_name("SIZE")?;
    let section = program.section_by_index(size.section_index()?).ok()?;
    let (start, _) = section.file_range()?;
    usize::try_from(start + size.address() - section.address()).ok()
}

/// Returns the program of this name for a job, and builds it if it is not there. `scene` is the source
/// of a file's scene.
fn program(
    name: &str,
    core: &Core,
    scene: Option<&str>,
    job: &str,
    profile: &BuildProfile,
) -> Result<PathBuf> {
    let program = images::place((name, job, scene, core.target, profile.name))?;
    if program.is_file() {
        return Ok(program);
    }
    let place = Place::of(core);
    let _lock = place.lock()?;
    // Somebody else may have built it in the meantime.
    if program.is_file() {
        return Ok(program);
    }
    if let Some(text) = scene {
        write(&place.scene(), text)?;
    }
    let source = place.jobs.join("job.rs");
    write(&source, job)?;
    let title = format!("{name} on {}: {}", core.name, summary(job));
    // A feature of its own lets the other programs be built without what only this one needs.
    let features: &[&str] = match name {
        "sweep" => &["--features", name],
        _ => &[],
    };
    let chosen = [profile.arguments, &["--bin", name], features].concat();
    ledger::timed("build", &title, || compile(core, &source, &chosen))?;
    let built = place.target.join(core.target).join(profile.folder);
    images::keep(&images::read(&built.join(name))?, &program)?;
    Ok(program)
}

/// Returns the line of a job that names the scene and its settings.
fn summary(job: &str) -> String {
    let mut lines = job.lines().map(str::trim);
    let named = lines.find(|line| line.starts_with("firmware::") && line.contains('<'));
    named.unwrap_or("nothing").to_owned()
}

fn compile(core: &Core, job: &Path, chosen: &[&str]) -> Result<()> {
    let cargo = toolchain::BareMetal::get()?.cargo("build", &[core.target]);
    let place = toolchain::directory_for(core.target);
    toolchain::outside(cargo, Path::new("xtask/firmware"), &place)
        .args(["--quiet", "--locked"])
        .args(chosen)
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

/// Calls `see` for each section of a program that flash or RAM holds, with its flags.
fn sections(
    program: &Path,
    mut see: impl FnMut(&object::Section, u64) -> Result<()>,
) -> Result<()> {
    let bytes = images::read(program)?;
    let program = object::File::parse(&*bytes)
        .with_context(|| format!("cannot read {}", program.display()))?;
    for section in program.sections() {
        let SectionFlags::Elf { sh_flags } = section.flags() else {
            bail!("a firmware is an ELF file");
        };
        if sh_flags & u64::from(elf::SHF_ALLOC) != 0 {
            see(&section, sh_flags)?;
        }
    }
    Ok(())
}

/// A hash of all that a program puts into flash: the same for programs that do the same, wherever
/// their sources lie and whatever their comments say.
pub(crate) fn fingerprint(program: &Path) -> Result<u64> {
    let mut hasher = DefaultHasher::new();
    sections(program, |section, _| {
        (section.name()?, section.address(), section.data()?).hash(&mut hasher);
        Ok(())
    })?;
    Ok(hasher.finish())
}

/// The bytes of a program that flash and RAM hold.
pub fn weigh(program: &Path) -> Result<Weight> {
    let mut weight = Weight {
        code: 0,
        flash: 0,
        ram: 0,
    };
    sections(program, |section, flags| {
        // The start-up code's names for what is left over.
        if matches!(section.name()?, ".stack" | ".heap") {
            return Ok(());
        }
        let size_if = |is_counted| if is_counted { section.size() } else { 0 };
        weight.flash += size_if(section.file_range().is_some());
        weight.code += size_if(flags & u64::from(elf::SHF_EXECINSTR) != 0);
        weight.ram += size_if(flags & u64::from(elf::SHF_WRITE) != 0);
        Ok(())
    })?;
    Ok(weight)
}
