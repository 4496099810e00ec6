//! What the paths of pixels meet: one path as a table, and a row as runs of equal paths.

use drawing::Settings;
use embedded_graphics::geometry::Size;
use reflet::PreparedFrame;
use reflet::host::file::FileScene;
use reflet::host::path::{End, Path, Step, path_of, paths_of_row};
use reflet::host::reference::Camera;
use reflet::quality::Exact;
use reflet::shading::{BlinnPhong, Phong, Shading};
use serde::Serialize;

use crate::opened::Opened;
use crate::projection::Projection;

/// The path of a pixel, for the page.
#[derive(Serialize)]
pub(crate) struct Table {
    pixel: [u8; 3],
    sum: [f64; 3],
    missed: bool,
    background: Option<[f64; 3]>,
    steps: Vec<Line>,
    brightest: f64,
    end: &'static str,
}

/// A surface on a path, for the page.
#[derive(Serialize)]
struct Line {
    shape: String,
    material: String,
    inside: bool,
    alpha: f64,
    weight: f64,
    color: [f64; 3],
    lights: Vec<usize>,
    sum: [f64; 3],
    bound: f64,
    from: [f64; 3],
    to: [f64; 3],
    seen: Option<[f64; 2]>,
}

/// A row as runs of pixels.
#[derive(Serialize)]
pub(crate) struct Row {
    runs: Vec<Run>,
}

/// Neighbours whose paths meet the same shapes, lit by the same lights.
#[derive(Serialize)]
struct Run {
    /// First and last column.
    from: usize,
    to: usize,
    levels: Vec<Level>,
    missed: bool,
}

#[derive(PartialEq, Serialize)]
struct Level {
    shape: String,
    flat: bool,
    inside: bool,
    lights: Vec<usize>,
}

/// Returns the path of a pixel; `None` outside of the picture.
pub(crate) fn pixel(opened: &Opened, settings: &Settings, at: (u32, u32)) -> Option<Table> {
    let path = match settings.shading {
        0 => pixel_as::<BlinnPhong>(opened, settings, at),
        _ => pixel_as::<Phong>(opened, settings, at),
    }?;
    let camera = Camera::from(&opened.view);
    let projection = Projection::new(&camera, [settings.width, settings.height]);
    let line = |step| line(opened, &projection, step);
    Some(Table {
        pixel: path.pixel,
        sum: path.sum,
        missed: path.end == End::Missed,
        background: path.background,
        steps: path.steps.iter().map(line).collect(),
        brightest: path.brightest,
        end: match path.end {
            End::Missed => "missed",
            End::NoWeight => "no weight left",
            End::LastReflection => "after the last reflection",
        },
    })
}

/// Returns the runs of a row; none below the picture.
pub(crate) fn row(opened: &Opened, settings: &Settings, y: u32) -> Row {
    let paths = match settings.shading {
        0 => row_as::<BlinnPhong>(opened, settings, y),
        _ => row_as::<Phong>(opened, settings, y),
    };
    let mut runs: Vec<Run> = Vec::new();
    for (column, path) in paths.iter().enumerate() {
        let levels: Vec<Level> = path.steps.iter().map(level).collect();
        let missed = path.end == End::Missed;
        match runs.last_mut() {
            Some(run) if run.levels == levels && run.missed == missed => run.to = column,
            _ => runs.push(Run {
                from: column,
                to: column,
                levels,
                missed,
            }),
        }
    }
    Row { runs }
}

fn pixel_as<K: Shading>(opened: &Opened, settings: &Settings, at: (u32, u32)) -> Option<Path> {
    path_of(&exact::<K>(opened, settings).on(&*opened.scene).ok()?, at)
}

fn row_as<K: Shading>(opened: &Opened, settings: &Settings, y: u32) -> Vec<Path> {
    let frame = exact::<K>(opened, settings);
    let rows = frame.on(&*opened.scene);
    rows.map_or_else(|_| Vec::new(), |rows| paths_of_row(&rows, y))
}

fn exact<K: Shading>(opened: &Opened, settings: &Settings) -> PreparedFrame<FileScene, Exact, K> {
    let frame = opened.scene.frame(&opened.view);
    let frame = frame.reflections(settings.reflections()).quality::<Exact>();
    frame
        .shading::<K>()
        .prepare(Size::new(settings.width, settings.height))
}

fn line(opened: &Opened, projection: &Projection, step: &Step) -> Line {
    let material = opened.file.materials().get(step.material);
    Line {
        shape: shape(step),
        material: material.cloned().unwrap_or_default(),
        inside: step.is_inside,
        alpha: step.alpha,
        weight: step.weight,
        color: step.color,
        lights: step.lights.clone(),
        sum: step.sum,
        bound: step.bound,
        from: step.from,
        to: step.to,
        seen: projection.seen(step.to),
    }
}

fn level(step: &Step) -> Level {
    Level {
        shape: shape(step),
        flat: ["plane", "disc", "triangle"].contains(&step.kind),
        inside: step.is_inside,
        lights: step.lights.clone(),
    }
}

/// Returns the name of a shape, such as `sphere 3`.
fn shape(step: &Step) -> String {
    format!("{} {}", step.kind, step.index)
}
