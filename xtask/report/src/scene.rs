//! Makes the whole report: measures every scene, then writes all files.

use std::path::Path;
use std::time::Duration;

use anyhow::{Error, Result, bail};
use command_line::{Quality, Source, one_line};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use reflet::host::compare::compare;
use reflet::host::reference::{Picture, Shading, render};
use xtask::measure::Scene;
use xtask::sweep::{Count, Setting, Sweep};

use crate::arguments::Arguments;
use crate::point::{Point, hash, mark_front, paint};
use crate::write;

/// Number of reflections that stands for all of them. The rest of a path is then darker than a
/// display can show, unless its mirrors reflect nearly all light.
const ALL: u32 = 2000;

/// Widths of a drawn pixel, in pixels of the picture.
const SCALES: [u8; 3] = [1, 2, 4];

/// A scene and everything that was measured of it.
pub struct Measured {
    pub name: String,
    /// Largest number of reflections that changes the picture.
    pub last: u8,
    pub points: Vec<Point>,
}

struct Plan<'a> {
    path: &'a Path,
    source: Source,
    last: u8,
    settings: Vec<Setting>,
}

/// Measures all scenes of the command line and writes the report.
pub fn report(arguments: &Arguments) -> Result<()> {
    let sources = sources(arguments)?;
    write::make(&arguments.out)?;
    let pairs = arguments.scenes.par_iter().zip(sources);
    let plans = pairs.map(|(path, source)| Plan::new(path, source, arguments));
    let plans: Vec<Plan> = plans.collect();
    let settings: usize = plans.iter().map(|plan| plan.settings.len()).sum();
    let bar = bar(settings);
    // Two at a time. Builds for the same core run one after another.
    let pool = ThreadPoolBuilder::new().num_threads(2).build()?;
    let count = |plan: &Plan| plan.count(arguments, &bar);
    let counts: Result<Vec<_>> = pool.install(|| plans.par_iter().map(count).collect());
    let plans = plans.into_par_iter().zip(counts?);
    let measured = plans.map(|(plan, counts)| plan.measured(counts, arguments));
    write::all(arguments, &measured.collect::<Result<Vec<_>>>()?)
}

fn bar(total: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} {eta:>4} {msg}");
    let bar = ProgressBar::new(total as u64).with_style(style.expect("the template is sound"));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

fn sources(arguments: &Arguments) -> Result<Vec<Source>> {
    let chosen = &arguments.chosen;
    if chosen.name.is_some() && arguments.scenes.len() != 1 {
        bail!("--scene chooses from one file");
    }
    let mut sources: Vec<Source> = Vec::new();
    for path in &arguments.scenes {
        let source = Source::open(path, chosen).map_err(Error::from_boxed)?;
        if sources.iter().any(|other| other.name() == source.name()) {
            bail!("two scenes are called {}", source.name());
        }
        sources.push(source);
    }
    Ok(sources)
}

impl<'a> Plan<'a> {
    fn new(path: &'a Path, source: Source, arguments: &Arguments) -> Self {
        let painted = |reflections| {
            let setting = Setting {
                quality: Quality::Exact,
                reflections,
                scale: 1,
            };
            paint(&source, arguments.size, &setting)
        };
        let most = arguments.reflections;
        let whole = painted(most);
        let last = (0..most).find(|number| painted(*number) == whole);
        let last = last.unwrap_or(most);
        Self {
            path,
            source,
            last,
            settings: settings(last),
        }
    }

    fn count(&self, arguments: &Arguments, bar: &ProgressBar) -> Result<Vec<Count>> {
        let (name, core) = (self.source.name(), arguments.core);
        bar.set_message(one_line(&format!("{name} on {}", core.name)));
        let scene = Scene::open(self.path, &arguments.chosen)?;
        let sweep = Sweep {
            core,
            size: arguments.size,
            scenes: vec![(scene, self.settings.clone())],
        };
        let mut counts = Vec::new();
        sweep.run(|count| {
            counts.push(count);
            bar.inc(1);
        })?;
        Ok(counts)
    }

    fn measured(self, counts: Vec<Count>, arguments: &Arguments) -> Result<Measured> {
        let ((scene, camera), size) = (self.source.reference(), arguments.size);
        let shading = Shading::BlinnPhong;
        let truth = render(&scene, &camera, size.width, size.height, ALL, shading);
        let both = self.settings.par_iter().zip(counts);
        let points = both.map(|(setting, count)| self.point(&truth, *setting, count, arguments));
        let mut points = points.collect::<Result<Vec<_>>>()?;
        mark_front(&mut points);
        Ok(Measured {
            name: self.source.name().to_owned(),
            last: self.last,
            points,
        })
    }

    fn point(
        &self,
        truth: &Picture,
        setting: Setting,
        count: Count,
        arguments: &Arguments,
    ) -> Result<Point> {
        let picture = paint(&self.source, arguments.size, &setting);
        if hash(&picture) != count.hash {
            let (name, core, words) = (self.source.name(), arguments.core.title, setting.words());
            bail!("{name}, {words}: {core} draws another picture than this machine");
        }
        let found = compare(&picture, truth)?;
        Ok(Point {
            setting,
            count,
            pixels: truth.pixels.len() as u64,
            psnr: found.psnr,
            largest: found.max,
            same: found.same,
            within1: found.within1,
            is_on_front: false,
        })
    }
}

/// Lists the settings that are measured: qualities, sizes of a pixel, and numbers of reflections up to the
/// last one that changes the picture.
fn settings(last: u8) -> Vec<Setting> {
    /// Up to this number every number is measured; beyond it, only some.
    const DENSE: u8 = 8;
    let steps = [10, 12, 16, 24, 32, 48, 64, 96, 128, 192];
    let some = (0..=DENSE).chain(steps).filter(|number| *number < last);
    let numbers: Vec<u8> = some.chain([last]).collect();
    let mut settings = Vec::new();
    for scale in SCALES {
        for quality in [Quality::Fast, Quality::Exact] {
            settings.extend(numbers.iter().map(|&reflections| Setting {
                quality,
                reflections,
                scale,
            }));
        }
    }
    settings
}
