//! Writes the files of a report. Measures nothing.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use anyhow::{Context, Result};
use command_line::shown;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use reflet::host::compare::difference_picture;
use reflet::host::reference::Picture;

use crate::arguments::{Arguments, Core};
use crate::page::{Page, Sample, Section};
use crate::plot::{self, Upright};
use crate::point::{GAIN, front};
use crate::scene::Measured;
use crate::{front as source, room, table};

pub fn make(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("--out {} cannot be made", folder.display()))
}

/// Factor by which the pictures of the differences are brightened.
pub const DIFFERENCE_GAIN: u8 = 16;

pub fn all(arguments: &Arguments, scenes: &[Measured]) -> Result<()> {
    let folder = Folder(&arguments.out);
    folder.write("points.csv", &table::csv(arguments, scenes)?)?;
    if arguments.core != Core::Host {
        let source = source::source(&arguments.command(), scenes);
        folder.write("front.rs", source.as_bytes())?;
    }
    let seen = room::measure()?;
    folder.write("room.svg", room::plot(&seen).as_bytes())?;
    let sections = scenes
        .iter()
        .map(|scene| section(arguments, scene, &folder));
    let page = Page {
        arguments,
        sections: sections.collect::<Result<_>>()?,
        furthest: room::furthest(&seen),
    };
    folder.write("index.md", page.markdown().as_bytes())?;
    println!("{}", shown(&arguments.out.join("index.md")));
    Ok(())
}

struct Folder<'a>(&'a Path);

impl Folder<'_> {
    fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        let path = self.0.join(name);
        fs::write(&path, bytes).with_context(|| format!("{} cannot be written", path.display()))
    }
}

pub fn file_name(scene: &str) -> String {
    let safe = |letter: char| match letter.is_alphanumeric() || "-_".contains(letter) {
        true => letter,
        false => '_',
    };
    scene.chars().map(safe).take(50).collect()
}

fn section<'a>(arguments: &Arguments, scene: &'a Measured, folder: &Folder) -> Result<Section<'a>> {
    let file = file_name(&scene.painter.name);
    for (name, upright) in [("psnr", Upright::Psnr), ("largest", Upright::Largest)] {
        let plot = plot::scene(scene, arguments.core, upright);
        folder.write(&format!("{file}-{name}.svg"), plot.as_bytes())?;
    }
    let front = front(&scene.points, GAIN);
    // Named by their position on the front, so that a later report with other points replaces them.
    let mut chosen = vec![
        ("first", 0),
        ("middle", front.len() / 2),
        ("last", front.len().saturating_sub(1)),
    ];
    // A front of one or two points has fewer pictures.
    chosen.dedup_by_key(|it| it.1);
    let sample = |(place, index): (&str, usize)| -> Result<Sample> {
        let picture = scene.painter.paint(&front[index].setting);
        let apart = difference_picture(&picture, &scene.truth.picture, DIFFERENCE_GAIN)?;
        let files = ["", "-difference"].map(|what| format!("{file}-{place}{what}.png"));
        folder.write(&files[0], &png(&picture)?)?;
        folder.write(&files[1], &png(&apart)?)?;
        Ok(Sample { index, files })
    };
    Ok(Section {
        samples: chosen.into_iter().map(sample).collect::<Result<_>>()?,
        scene,
        front,
        file,
    })
}

fn png(picture: &Picture) -> Result<Vec<u8>> {
    let mut bytes = Cursor::new(Vec::new());
    let (best, filter) = (CompressionType::Best, FilterType::Adaptive);
    PngEncoder::new_with_quality(&mut bytes, best, filter).write_image(
        picture.pixels.as_flattened(),
        picture.width,
        picture.height,
        ExtendedColorType::Rgb8,
    )?;
    Ok(bytes.into_inner())
}
