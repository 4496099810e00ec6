//! Writes the Pareto front as Rust source, for the library's budget. Measures nothing.

use crate::point::{Point, front};
use crate::scene::Measured;

pub fn source(command: &str, scenes: &[Measured]) -> String {
    let mut source = format!(
        "// Written by `{command}`:\n// what is best for a frame of so many instructions. Include it \
         where `ParetoFront`, `FrontPoint` and\n// `QualityLevel` are in scope.\n"
    );
    for scene in scenes {
        let name: String = scene.name.chars().map(constant).collect();
        let is_digit = name.starts_with(|first: char| first.is_ascii_digit());
        let prefix = if is_digit { "SCENE_" } else { "" };
        let words = scene.name.replace(char::is_control, " ");
        source +=
            &format!("/// {words}\npub const {prefix}{name}: ParetoFront = ParetoFront::new(&[\n");
        source.extend(front(&scene.points).into_iter().map(line));
        source += "]);\n";
    }
    source
}

fn line(point: &Point) -> String {
    format!(
        "    FrontPoint {{ prepare: {}, instructions: {}, reflections: {}, level: QualityLevel::{}, \
         scale: {}, psnr: {}, largest: {} }},\n",
        point.count.prepare,
        point.drawing(),
        point.setting.reflections,
        point.setting.quality.type_name(),
        point.setting.scale,
        point.hundredths(),
        point.largest,
    )
}

fn constant(letter: char) -> char {
    if letter.is_ascii_alphanumeric() { letter.to_ascii_uppercase() } else { '_' }
}
