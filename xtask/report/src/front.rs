//! Writes the Pareto front as Rust source, for the library's budget. Measures nothing.

use xtask::sweep::{Contestant, Level};

use crate::point::{GAIN, Point};
use crate::scene::Measured;

pub fn source(command: &str, scenes: &[Measured]) -> String {
    let mut source = format!(
        "// Written by `{command}`:\n// what is best for a frame of so many instructions. Include it \
         where `ParetoFront`, `FrontPoint` and\n// `QualityLevel` are in scope.\n"
    );
    for scene in scenes {
        let points = points(&scene.points);
        if points.is_empty() {
            continue;
        }
        let name: String = scene.painter.name.chars().map(constant).collect();
        let is_digit = name.starts_with(|first: char| first.is_ascii_digit());
        let prefix = if is_digit { "SCENE_" } else { "" };
        let words = scene.painter.name.replace(char::is_control, " ");
        source +=
            &format!("/// {words}\npub const {prefix}{name}: ParetoFront = ParetoFront::new(&[\n");
        source.extend(points.iter().map(|point| line(point)));
        source += "]);\n";
    }
    source
}

/// Returns the front of the points that the library's `QualityLevel` can name: `Fast` and `Exact` with
/// shadows.
fn points(points: &[Point]) -> Vec<&Point> {
    let is_known = |point: &&Point| match point.setting.contestant {
        Contestant::Fixed(level) => [Level::Fast, Level::Exact].contains(&level),
        Contestant::Unshadowed | Contestant::Float => false,
    };
    let mut known: Vec<&Point> = points.iter().filter(is_known).collect();
    known.sort_by(|a, b| {
        let by_cost = a.cost.instructions.total_cmp(&b.cost.instructions);
        by_cost.then(b.psnr().total_cmp(&a.psnr()))
    });
    let mut front: Vec<&Point> = Vec::new();
    for point in known {
        let is_more = front.last().is_none_or(|last| {
            hundredths(point) > hundredths(last)
                && rounded(point) > rounded(last)
                && point.psnr() >= last.psnr() + GAIN
        });
        if is_more {
            front.push(point);
        }
    }
    front
}

/// Returns the instructions a pixel without those of the preparation, rounded up.
fn rounded(point: &Point) -> u32 {
    let pixels = point.pixels as f64;
    let whole = (point.cost.instructions * pixels).round() as u64;
    let drawing = whole.saturating_sub(prepare(point).into());
    drawing.div_ceil(point.pixels) as u32
}

fn prepare(point: &Point) -> u32 {
    point.cost.prepare as u32
}

fn hundredths(point: &Point) -> u16 {
    match point.psnr().is_finite() {
        true => (100.0 * point.psnr()).floor().clamp(0.0, 65_534.0) as u16,
        false => u16::MAX,
    }
}

fn line(point: &Point) -> String {
    let level = match point.setting.contestant {
        Contestant::Fixed(Level::Exact) => "Exact",
        _ => "Fast",
    };
    format!(
        "    FrontPoint {{ prepare: {}, instructions: {}, reflections: {}, level: QualityLevel::{level}, \
         scale: {}, psnr: {}, largest: {} }},\n",
        prepare(point),
        rounded(point),
        point.setting.reflections,
        point.setting.scale,
        hundredths(point),
        point.errors.largest,
    )
}

fn constant(letter: char) -> char {
    match letter.is_ascii_alphanumeric() {
        true => letter.to_ascii_uppercase(),
        false => '_',
    }
}
