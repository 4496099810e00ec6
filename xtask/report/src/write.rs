//! The files of a report; it measures nothing.

use std::fs;
use std::io::Cursor;
use std::path::Path;

use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use reflet::host::compare::difference_picture;
use reflet::host::reference::Picture;

use crate::arguments::Arguments;
use crate::page::{self, Page, Sample, Section};
use crate::plot::{self, Axis, GAIN};
use crate::point::front;
use crate::scene::Measured;
use crate::{front as source, room, table};
use command_line::Failure;

/// Makes the folder of a report.
pub fn make(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder)
        .map_err(|error| format!("--out {} cannot be made: {error}", folder.display()).into())
}

/// How much the differences in the pictures are made larger.
pub const DIFFERENCE_GAIN: u8 = 16;

/// Writes everything.
pub fn all(arguments: &Arguments, scenes: &[Measured]) -> Result<(), Failure> {
    let folder = Folder(&arguments.out);
    let size = format!("{}x{}", arguments.size.width, arguments.size.height);
    folder.write("points.csv", &table::csv(arguments, scenes)?)?;
    if arguments.core != crate::arguments::Core::Host {
        let source = source::source(&arguments.command(), scenes);
        folder.write("front.rs", source.as_bytes())?;
    }
    let seen = room::measure()?;
    let room = room::plot(&seen)?;
    folder.write("room.svg", room.as_bytes())?;
    let sections = scenes
        .iter()
        .map(|scene| section(arguments, scene, &folder));
    let page = Page {
        arguments,
        size,
        sections: sections.collect::<Result<_, Failure>>()?,
        room,
        furthest: room::furthest(&seen),
    };
    folder.write("index.md", page::markdown::write(&page).as_bytes())?;
    folder.write("index.html", page::html::write(&page).as_bytes())?;
    println!("{}", arguments.out.join("index.html").display());
    Ok(())
}

struct Folder<'a>(&'a Path);

impl Folder<'_> {
    fn write(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.0.join(name);
        fs::write(&path, bytes)
            .map_err(|error| format!("{} cannot be written: {error}", path.display()).into())
    }
}

fn section<'a>(
    arguments: &Arguments,
    scene: &'a Measured,
    folder: &Folder,
) -> Result<Section<'a>, Failure> {
    let safe = |letter: char| match letter.is_alphanumeric() || "-_".contains(letter) {
        true => letter,
        false => '_',
    };
    let file: String = scene.painter.name().chars().map(safe).take(50).collect();
    let psnr = plot::scene(scene, arguments.core, Axis::Psnr)?;
    let largest = plot::scene(scene, arguments.core, Axis::Largest)?;
    folder.write(&format!("{file}-psnr.svg"), psnr.as_bytes())?;
    folder.write(&format!("{file}-largest.svg"), largest.as_bytes())?;
    let front = front(&scene.points, GAIN);
    // Named by their place, so that a later report with other points replaces them.
    let chosen = [
        ("first", 0),
        ("middle", front.len() / 2),
        ("last", front.len().saturating_sub(1)),
    ];
    let sample = |(place, index): (&str, usize)| -> Result<Sample, Failure> {
        let picture = scene.painter.paint(&front[index].setting);
        let apart = difference_picture(&picture, &scene.truth.picture, DIFFERENCE_GAIN)?;
        let (picture, difference) = (png(&picture)?, png(&apart)?);
        let name = format!("{file}-{place}.png");
        let other = format!("{file}-{place}-difference.png");
        folder.write(&name, &picture)?;
        folder.write(&other, &difference)?;
        Ok(Sample {
            number: index + 1,
            files: [name, other],
            pictures: [picture, difference],
        })
    };
    let samples = chosen.into_iter().map(sample);
    let mut samples: Vec<Sample> = samples.collect::<Result<_, _>>()?;
    // A front of one or two points has no more to show.
    samples.dedup_by_key(|it| it.number);
    Ok(Section {
        scene,
        samples,
        front,
        file,
        psnr,
        largest,
    })
}

fn png(picture: &Picture) -> Result<Vec<u8>, Failure> {
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
