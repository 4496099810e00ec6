//! Counts instructions: asks `cargo xtask sweep` for what is not known yet.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use embedded_graphics::geometry::Size;
use serde_json::Value;
use tempfile::NamedTempFile;

use crate::cache::{self, Cache};
use crate::point::Cost;
use crate::settings::Setting;
use command_line::Failure;

/// What is counted.
pub struct Task<'a> {
    /// The scene as the command line names it, and one of several in its file.
    pub scene: &'a Path,
    pub chosen: Option<&'a str>,
    /// What the scene is called.
    pub name: &'a str,
    pub core: &'static str,
    pub size: Size,
    pub settings: &'a [Setting],
    /// The folder of what was counted before.
    pub counts: PathBuf,
}

/// Counts all settings of a task, and says of each when it is done.
pub fn count(task: &Task, done: &dyn Fn()) -> Result<Vec<Cost>, Failure> {
    let Size { width, height } = task.size;
    let safe = |letter: char| {
        if letter.is_alphanumeric() {
            letter
        } else {
            '_'
        }
    };
    let name: String = task.name.chars().map(safe).collect();
    let contestant = match task.settings.iter().any(|it| !it.is_float()) {
        true => "fixed",
        false => "float",
    };
    let name = format!("{name}-{contestant}-{}-{width}x{height}", task.core);
    let mut cache = Cache::open(&task.counts, &name, &cache::sources(task.scene)?)?;
    let is_known = |cache: &Cache, setting: &Setting| cache.cost(setting).is_some();
    let known = task
        .settings
        .iter()
        .filter(|it| is_known(&cache, it))
        .count();
    (0..known).for_each(|_| done());
    if known < task.settings.len() {
        sweep(task, &mut cache, done)?;
    }
    let costs = task.settings.iter().map(|setting| cache.cost(setting));
    let costs: Option<Vec<Cost>> = costs.collect();
    costs.ok_or_else(|| format!("{}: not every setting was counted", task.name).into())
}

fn sweep(task: &Task, cache: &mut Cache, done: &dyn Fn()) -> Result<(), Failure> {
    let is_known: Vec<bool> = task
        .settings
        .iter()
        .map(|it| cache.cost(it).is_some())
        .collect();
    let runs = task
        .settings
        .iter()
        .zip(&is_known)
        .map(|(setting, is_known)| {
            let mut run = setting.json();
            run["skip"] = Value::from(*is_known);
            run
        });
    let mut file = NamedTempFile::with_prefix("reflet-")?;
    file.write_all(Value::from_iter(runs).to_string().as_bytes())?;
    let mut child = Sweep::start(task, file.path(), cache.program(task.settings))?;
    let mut program = None;
    while let Some(line) = child.line()? {
        if let Some(found) = line["program"].as_str() {
            if Some(found) == cache.program(task.settings) {
                let open = is_known.iter().filter(|it| !**it).count();
                cache.renew(task.settings)?;
                (0..open).for_each(|_| done());
                return child.end(task);
            }
            program = is_known.iter().all(|it| !it).then(|| found.to_owned());
            continue;
        }
        let number = |key: &str| line[key].as_u64();
        let count = (number("run"), number("instructions"), number("prepare"));
        let (Some(run), Some(instructions), Some(prepare)) = count else {
            return Err(format!("cargo xtask sweep printed {line}").into());
        };
        let setting = usize::try_from(run)
            .ok()
            .and_then(|run| task.settings.get(run));
        let setting = setting.ok_or("cargo xtask sweep printed a setting nobody asked for")?;
        let pixels = u64::from(task.size.width) * u64::from(task.size.height);
        let hash = line["hash"].as_str().unwrap_or_default();
        cache.keep(setting, pixels, (instructions, prepare), hash)?;
        done();
    }
    child.end(task)?;
    match program {
        Some(program) => cache.set_program(&program, task.settings),
        None => Ok(()),
    }
}

/// The command that counts.
struct Sweep {
    child: Child,
    lines: Box<dyn Iterator<Item = std::io::Result<String>>>,
}

impl Sweep {
    fn start(task: &Task, runs: &Path, known: Option<&str>) -> Result<Self, Failure> {
        let Size { width, height } = task.size;
        let scene = match task.scene.is_file() {
            true => task.scene.canonicalize()?,
            false => task.scene.to_owned(),
        };
        let mut command = Command::new("cargo");
        command
            .current_dir(cache::root())
            .args(["run", "--quiet", "--package", "xtask", "--", "sweep"])
            .args(["--core", task.core, "--size", &format!("{width}x{height}")])
            .arg("--scene")
            .arg(scene)
            .arg("--runs")
            .arg(runs)
            .stdin(Stdio::null())
            .stdout(Stdio::piped());
        if let Some(name) = task.chosen {
            command.args(["--name", name]);
        }
        if let Some(program) = known {
            command.args(["--known", program]);
        }
        let mut child = command
            .spawn()
            .map_err(|error| format!("cargo does not start: {error}"))?;
        let out = child.stdout.take().ok_or("cargo has no standard output")?;
        Ok(Self {
            child,
            lines: Box::new(BufReader::new(out).lines()),
        })
    }

    fn line(&mut self) -> Result<Option<Value>, Failure> {
        let Some(line) = self.lines.next().transpose()? else {
            return Ok(None);
        };
        Ok(Some(serde_json::from_str(&line)?))
    }

    fn end(mut self, task: &Task) -> Result<(), Failure> {
        match self.child.wait()?.success() {
            true => Ok(()),
            false => Err(format!("{} on {} could not be counted", task.name, task.core).into()),
        }
    }
}
