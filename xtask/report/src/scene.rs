//! The report as a whole: every scene measured, then everything written.

use std::collections::VecDeque;
use std::path::Path;
use std::sync::Mutex;
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use reflet::host::reference::Picture;

use crate::arguments::{Arguments, Core};
use crate::error::Truth;
use crate::meter::{self, Task};
use crate::paint::{Painter, hash};
use crate::point::{Cost, Point, mark_front};
use crate::settings::{self, Level, Setting};
use crate::{cache, host, write};
use command_line::Failure;
use command_line::Source;

/// A scene with all that was measured of it.
pub struct Measured {
    pub painter: Painter,
    pub truth: Truth,
    /// The last number of reflections that changes the picture.
    pub last: u8,
    /// Fixed point on the report's core.
    pub points: Vec<Point>,
    /// The float port where there is hardware for it.
    pub float: Vec<Point>,
    /// The float port in software on the report's core.
    pub soft: Option<Point>,
}

/// A scene and what is to be tried with it.
struct Plan<'a> {
    path: &'a Path,
    painter: Painter,
    last: u8,
    fixed: Vec<Setting>,
    float: Vec<Setting>,
    soft: Vec<Setting>,
}

/// Measures and writes all that the command line asks for.
pub fn report(arguments: &Arguments) -> Result<(), Failure> {
    let plans = plans(arguments)?;
    write::make(&arguments.out)?;
    let total: usize = plans.iter().map(|plan| plan.total(arguments.core)).sum();
    let bar = bar(total as u64);
    let costs = match arguments.core {
        Core::Host => plans.iter().map(|plan| plan.time(&bar)).collect(),
        core => count(&plans, core, arguments, &bar),
    };
    bar.finish_and_clear();
    let measured: Result<Vec<Measured>, Failure> = plans
        .into_par_iter()
        .zip(costs?)
        .map(|(plan, costs)| plan.measured(costs, arguments.core))
        .collect();
    write::all(arguments, &measured?)
}

fn bar(total: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} {eta:>4} {msg}");
    let bar = ProgressBar::new(total).with_style(style.expect("the template is well formed"));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

fn plans(arguments: &Arguments) -> Result<Vec<Plan<'_>>, Failure> {
    let chosen = arguments.chosen.as_deref();
    if chosen.is_some() && arguments.scenes.len() != 1 {
        return Err("--scene chooses from one file".into());
    }
    let opened = arguments.scenes.iter().map(|path| {
        let painter = Painter::new(Source::open(path, chosen)?, arguments.size)?;
        Ok(Plan::new(path, painter, arguments))
    });
    let plans = opened.collect::<Result<Vec<_>, Failure>>()?;
    for (index, plan) in plans.iter().enumerate() {
        let name = plan.painter.name();
        if plans[..index]
            .iter()
            .any(|other| other.painter.name() == name)
        {
            return Err(format!("two scenes are called {name}").into());
        }
    }
    Ok(plans)
}

impl<'a> Plan<'a> {
    fn new(path: &'a Path, painter: Painter, arguments: &Arguments) -> Self {
        let last = last_that_matters(&painter, arguments.reflections);
        let numbers = settings::numbers(last);
        // In software it takes minutes for a frame, so once is enough.
        let soft = match arguments.core {
            Core::M3 | Core::Rv32 => vec![Setting::float(last.min(4), 1)],
            _ => Vec::new(),
        };
        Self {
            path,
            painter,
            last,
            fixed: settings::fixed(&numbers),
            float: settings::float(&numbers),
            soft,
        }
    }

    fn total(&self, core: Core) -> usize {
        let settings = self.fixed.len() + self.float.len();
        match core {
            Core::Host => host::rounds(settings),
            _ => settings + self.soft.len(),
        }
    }

    /// On this machine.
    fn time(&self, bar: &ProgressBar) -> Result<Costs, Failure> {
        bar.set_message(self.painter.name().to_owned());
        let all = [self.fixed.as_slice(), &self.float].concat();
        let mut costs = host::time(&self.painter, &all, &|| bar.inc(1))?;
        let float = costs.split_off(self.fixed.len());
        Ok([costs, float, Vec::new()])
    }

    fn measured(self, costs: Costs, core: Core) -> Result<Measured, Failure> {
        let truth = Truth::new(&self.painter);
        let [fixed, float, soft] = costs;
        let fpu = match core {
            Core::Host => Core::Host,
            _ => Core::M4f,
        };
        let points = |settings: &[Setting], costs: Vec<Cost>, core: Core| {
            let both = settings.par_iter().zip(costs);
            let points = both.map(|(setting, cost)| self.point(&truth, *setting, cost, core));
            points.collect::<Result<Vec<Point>, Failure>>()
        };
        let mut points_of_core = points(&self.fixed, fixed, core)?;
        let mut float = points(&self.float, float, fpu)?;
        let soft = points(&self.soft, soft, core)?.pop();
        mark_front(&mut points_of_core);
        mark_front(&mut float);
        Ok(Measured {
            truth,
            last: self.last,
            points: points_of_core,
            float,
            soft,
            painter: self.painter,
        })
    }

    fn point(
        &self,
        truth: &Truth,
        setting: Setting,
        cost: Cost,
        core: Core,
    ) -> Result<Point, Failure> {
        let picture = self.painter.paint(&setting);
        if hash(&picture) != cost.hash {
            let (name, core, words) = (self.painter.name(), core.title(), setting.words());
            return Err(
                format!("{name}, {words}: {core} draws another picture than this machine").into(),
            );
        }
        Ok(Point {
            errors: truth.errors(&self.painter, &setting, &picture)?,
            setting,
            core: core.name(),
            cost,
            pixels: truth.picture.pixels.len() as u64,
            is_on_front: false,
        })
    }
}

/// The last number of reflections, up to `most`, that changes the picture.
fn last_that_matters(painter: &Painter, most: u8) -> u8 {
    let painted = |number| painter.paint(&Setting::fixed(Level::Exact, number));
    let whole: Picture = painted(most);
    (0..most)
        .find(|number| painted(*number) == whole)
        .unwrap_or(most)
}

/// What fixed point, the float port and the float port in software cost.
type Costs = [Vec<Cost>; 3];

/// One of the three for one scene.
struct Job<'a> {
    scene: usize,
    kind: usize,
    task: Task<'a>,
}

/// Counts what all scenes take, two at a time: builds for one core wait for each other.
fn count(
    plans: &[Plan],
    core: Core,
    arguments: &Arguments,
    bar: &ProgressBar,
) -> Result<Vec<Costs>, Failure> {
    let jobs = plans.iter().enumerate().flat_map(|(scene, plan)| {
        let kinds = [
            (&plan.fixed, core),
            (&plan.float, Core::M4f),
            (&plan.soft, core),
        ];
        kinds
            .into_iter()
            .enumerate()
            .map(move |(kind, (settings, core))| Job {
                scene,
                kind,
                task: Task {
                    scene: plan.path,
                    chosen: arguments.chosen.as_deref(),
                    name: plan.painter.name(),
                    core: core.name(),
                    size: arguments.size,
                    settings,
                    counts: arguments.counts.clone().unwrap_or_else(cache::folder),
                },
            })
    });
    let jobs: VecDeque<Job> = jobs.filter(|job| !job.task.settings.is_empty()).collect();
    let costs = Mutex::new(vec![Costs::default(); plans.len()]);
    let jobs = Mutex::new(jobs);
    let work = || -> Result<(), Failure> {
        while let Some(job) = next(&jobs) {
            bar.set_message(format!("{} on {}", job.task.name, job.task.core));
            let found = meter::count(&job.task, &|| bar.inc(1)).inspect_err(|_| {
                // Nobody goes on with a report that will not be.
                jobs.lock().map(|mut jobs| jobs.clear()).unwrap_or_default();
            })?;
            if let Ok(mut costs) = costs.lock() {
                costs[job.scene][job.kind] = found;
            }
        }
        Ok(())
    };
    thread::scope(|scope| {
        let workers = [scope.spawn(work), scope.spawn(work)];
        let results = workers.map(|worker| worker.join().expect("a worker does not panic"));
        results.into_iter().collect::<Result<(), Failure>>()
    })?;
    Ok(costs.into_inner().unwrap_or_default())
}

fn next<'a>(jobs: &Mutex<VecDeque<Job<'a>>>) -> Option<Job<'a>> {
    jobs.lock().ok()?.pop_front()
}
