//! Draws several built-in scenes by one firmware on one core, for tests that compare only pictures.

use std::path::Path;

use anyhow::{Result, ensure};

use super::task::{Quality, Size, Task, order};
use super::{Core, Scene, firmware};

/// Returns the hash of each picture, as 16 hexadecimal digits.
pub fn hashes(
    core: &'static Core,
    size: Size,
    pictures: &[(&'static str, Quality)],
) -> Result<Vec<String>> {
    let program = firmware::build_pictures(core, &source(core, size, pictures))?;
    let emulator = core.emulator().limit(firmware::RUN_LIMIT);
    let said = emulator.run(&program)?;
    let hashes = said
        .lines()
        .filter_map(|line| line.strip_prefix("picture hash="));
    let hashes: Vec<_> = hashes.map(str::to_owned).collect();
    ensure!(
        hashes.len() == pictures.len(),
        "the firmware reports other pictures: {said}"
    );
    Ok(hashes)
}

/// Returns the source of a job that draws these pictures.
fn source(core: &'static Core, size: Size, pictures: &[(&'static str, Quality)]) -> String {
    let mut source = order(size, 0);
    source += "use embedded_graphics::pixelcolor::Rgb888;\n\n";
    for (index, &(name, quality)) in pictures.iter().enumerate() {
        let task = Task::new(core, Scene::BuiltIn(name), size, quality);
        let contestant = task.contestant(Path::new(""));
        source += &format!("mod picture{index} {{\n{contestant}}}\n\n");
    }
    let draw = |index| format!("    firmware::picture::<picture{index}::Job>,\n");
    let draws: String = (0..pictures.len()).map(draw).collect();
    source + &format!("pub const PICTURES: &[fn((u32, u32), &mut [Rgb888])] = &[\n{draws}];\n")
}
