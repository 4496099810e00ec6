//! Makes the whole report: measures every scene, then writes all files.

use std::path::Path;
use std::time::Duration;

use anyhow::{Error, Result, bail};
use command_line::{Source, one_line};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use xtask::measure::{Core, Scene};
use xtask::sweep::{Level, Setting, Sweep};
use xtask::toolchain;

use crate::arguments::Arguments;
use crate::error::Truth;
use crate::paint::{Painter, hash};
use crate::point::{Cost, Point, mark_front};
use crate::{meter, settings, write};

/// A scene and everything that was measured of it.
pub struct Measured {
    pub painter: Painter,
    /// Largest number of reflections that changes the picture.
    pub last: u8,
    /// Points of fixed point on the report's core.
    pub points: Vec<Point>,
    /// Points of the float port, on a core with a floating-point unit.
    pub float: Vec<Point>,
}

/// A scene and the settings to measure with it.
struct Plan<'a> {
    path: &'a Path,
    painter: Painter,
    last: u8,
    jobs: [Job; 2],
}

/// Settings of one contestant, fixed point or float, on one core.
struct Job {
    settings: Vec<Setting>,
    core: &'static Core,
}

/// Costs of the two jobs of a scene: fixed point and float.
type Costs = [Vec<Cost>; 2];

/// Measures all scenes of the command line and writes the report.
pub fn report(arguments: &Arguments) -> Result<()> {
    let painters = painters(arguments)?;
    write::make(&arguments.out)?;
    let plans = arguments.scenes.par_iter().zip(painters);
    let plans: Vec<Plan> = plans
        .map(|(path, painter)| Plan::new(path, painter, arguments))
        .collect();
    let settings = plans.iter().flat_map(|plan| &plan.jobs);
    let settings: usize = settings.map(|job| job.settings.len()).sum();
    let costs = count(&plans, arguments, &bar(settings))?;
    let measured: Result<Vec<Measured>> = plans
        .into_par_iter()
        .zip(costs)
        .map(|(plan, costs)| plan.measured(costs))
        .collect();
    write::all(arguments, &measured?)
}

fn bar(total: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} {eta:>4} {msg}");
    let bar = ProgressBar::new(total as u64).with_style(style.expect("the template is sound"));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

fn painters(arguments: &Arguments) -> Result<Vec<Painter>> {
    let chosen = &arguments.chosen;
    if chosen.name.is_some() && arguments.scenes.len() != 1 {
        bail!("--scene chooses from one file");
    }
    let mut painters: Vec<Painter> = Vec::new();
    for path in &arguments.scenes {
        let source = Source::open(path, chosen).map_err(Error::from_boxed)?;
        let name = source.name();
        if painters.iter().any(|other| other.name == name) {
            bail!("two scenes are called {name}");
        }
        painters.push(Painter::new(source, arguments.size)?);
    }
    Ok(painters)
}

impl<'a> Plan<'a> {
    fn new(path: &'a Path, painter: Painter, arguments: &Arguments) -> Self {
        let core = arguments.core;
        let float = Core::find("m4f").expect("there is a Cortex-M4F");
        let last = last_that_matters(&painter, arguments.reflections);
        let numbers = settings::numbers(last);
        let job = |settings, core| Job { settings, core };
        Self {
            path,
            painter,
            last,
            jobs: [
                job(settings::fixed(&numbers), core),
                job(settings::float(&numbers), float),
            ],
        }
    }

    fn measured(self, costs: Costs) -> Result<Measured> {
        let truth = Truth::new(&self.painter);
        let points = |job: &Job, costs: Vec<Cost>| -> Result<Vec<Point>> {
            let both = job.settings.par_iter().zip(costs);
            let points = both.map(|(setting, cost)| self.point(&truth, *setting, cost, job.core));
            points.collect()
        };
        let [fixed, float] = &self.jobs;
        let [of_fixed, of_float] = costs;
        let mut fixed = points(fixed, of_fixed)?;
        let mut float = points(float, of_float)?;
        mark_front(&mut fixed);
        mark_front(&mut float);
        Ok(Measured {
            last: self.last,
            points: fixed,
            float,
            painter: self.painter,
        })
    }

    fn point(
        &self,
        truth: &Truth,
        setting: Setting,
        cost: Cost,
        core: &'static Core,
    ) -> Result<Point> {
        let picture = self.painter.paint(&setting);
        if hash(&picture) != cost.hash {
            let (name, core, words) = (&self.painter.name, core.title, setting.words());
            bail!("{name}, {words}: {core} draws another picture than this machine");
        }
        Ok(Point {
            errors: truth.errors(&self.painter, &setting, &picture)?,
            setting,
            core: core.name,
            cost,
            pixels: truth.picture.pixels.len() as u64,
            is_on_front: false,
        })
    }
}

/// Returns the largest number of reflections, up to `most`, that changes the picture.
fn last_that_matters(painter: &Painter, most: u8) -> u8 {
    let painted = |number| painter.paint(&Setting::fixed(Level::Exact, number));
    let whole = painted(most);
    let same = (0..most).find(|number| painted(*number) == whole);
    same.unwrap_or(most)
}

/// Counts the instructions of all scenes, two jobs at a time. Builds for the same core run one after
/// another.
fn count(plans: &[Plan], arguments: &Arguments, bar: &ProgressBar) -> Result<Vec<Costs>> {
    let jobs = plans.par_iter().flat_map(|plan| {
        let jobs = plan.jobs.par_iter();
        jobs.map(move |job| job.count(plan, arguments, bar))
    });
    let pool = ThreadPoolBuilder::new().num_threads(2).build()?;
    let costs: Vec<Vec<Cost>> = pool.install(|| jobs.collect::<Result<_>>())?;
    let mut costs = costs.into_iter();
    let mut next = || costs.next().unwrap_or_default();
    Ok(plans.iter().map(|_| [next(), next()]).collect())
}

impl Job {
    fn count(&self, plan: &Plan, arguments: &Arguments, bar: &ProgressBar) -> Result<Vec<Cost>> {
        let (name, core_name) = (&plan.painter.name, self.core.name);
        bar.set_message(one_line(&format!("{name} on {core_name}")));
        let is_float = self.settings.iter().all(Setting::is_float);
        let contestant = if is_float { "float" } else { "fixed" };
        let (safe, size) = (write::file_name(name), arguments.size_words());
        let file = format!("{safe}-{contestant}-{core_name}-{size}.json");
        let folder = arguments.counts.clone();
        let folder = folder.unwrap_or_else(|| toolchain::target_directory().join("report"));
        let sweep = Sweep {
            core: self.core,
            scene: &Scene::open(plan.path, &arguments.chosen)?,
            size: arguments.size.into(),
            settings: &self.settings,
        };
        let counts = meter::count(sweep, plan.path, &folder.join(file), &|| bar.inc(1))?;
        let pixels = f64::from(arguments.size.width * arguments.size.height);
        let costs = counts.into_iter().map(|count| Cost {
            instructions: count.instructions as f64 / pixels,
            prepare: count.prepare,
            hash: count.hash,
        });
        Ok(costs.collect())
    }
}
