//! Counts the pixels that interpolation loses.
//!
//! `cargo run --release --package lost -- --help`

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use command_line::{
    Chosen, Failure, Quality, Shading, Source, exit_code, parse, print, shown, size,
};
use embedded_graphics::geometry::Size;
use lost::case::{Case, Judged};
use lost::families::{Family, scene_of_run};
use lost::table::{HEAD, LINES_HEAD, lines, row};
use lost::{file, on_all_cores};

/// Counts the pixels that interpolation loses: `Exact` is within 1 of the double-precision
/// reference, and the quality is off by more than 8. `Exact` itself is tested against `Small`.
///
/// The exit code is 0, or 2 after an error, which is one line.
#[derive(Parser)]
#[command(name = "lost", max_term_width = 100)]
struct Arguments {
    /// Scene files or built-in scenes [default: random scenes]
    #[arg(value_name = "SCENE")]
    named: Vec<PathBuf>,

    #[command(flatten)]
    chosen: Chosen,

    /// Size of the pictures
    #[arg(long, value_name = "WxH", default_value = "96x72", value_parser = size)]
    size: Size,

    /// Qualities to test
    #[arg(long, value_enum, value_delimiter = ',', default_value = "fast")]
    qualities: Vec<Quality>,

    /// Number of reflections of scene files and built-in scenes
    #[arg(long, value_name = "N", default_value_t = 4)]
    reflections: u8,

    /// Families of the random scenes [default: all but `any` and `fading`]
    #[arg(long, value_enum, value_delimiter = ',', conflicts_with = "named")]
    families: Vec<Family>,

    /// Number of random scenes, over all families together
    #[arg(
        long,
        value_name = "N",
        default_value_t = 300,
        conflicts_with = "named"
    )]
    scenes: usize,

    /// Seed of the random scenes
    #[arg(long, value_name = "N", default_value_t = 1, conflicts_with = "named")]
    seed: u64,

    /// Write each scene that loses a pixel into this folder, as a scene file and as pictures with
    /// lost pixels in magenta
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    exit_code(parse().and_then(|arguments| run(&arguments)))
}

/// Draws the scenes, prints a line for each picture that loses pixels, and then a table.
fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(folder) = &arguments.out {
        fs::create_dir_all(folder)
            .map_err(|error| format!("{} cannot be made: {error}", shown(folder)))?;
    }
    let (cases, qualities) = (cases(arguments)?, &arguments.qualities);
    let judge = |index: usize| {
        let case: &Case = &cases[index].1;
        let judged = case.judge(arguments.size, qualities);
        judged.map_err(|error| format!("{}: {error}", case.name))
    };
    let judged: Vec<Judged> = on_all_cores(cases.len(), judge)
        .into_iter()
        .collect::<Result<_, _>>()?;
    print(format!("{LINES_HEAD}\n"))?;
    for (judged, (_, case)) in judged.iter().zip(&cases) {
        for line in lines(judged) {
            print(format!("{line}\n"))?;
        }
        if let Some(folder) = &arguments.out {
            write(folder, judged, case)?;
        }
    }
    print(format!("\n{HEAD}\n"))?;
    let drawn = || judged.iter().zip(&cases);
    let families = Family::ALL.iter().map(|it| Some(*it));
    for title in families.chain([None]) {
        let own = drawn().filter(|(_, (family, _))| title.is_none() || *family == title);
        let own: Vec<&Judged> = own.map(|(judged, _)| judged).collect();
        let words = title.map_or("all".to_owned(), Family::name);
        for quality in qualities.iter().filter(|_| !own.is_empty()) {
            print(row(&words, *quality, &own) + "\n")?;
        }
    }
    Ok(())
}

/// Opens the named scenes, or makes random ones, each with its family.
fn cases(arguments: &Arguments) -> Result<Vec<(Option<Family>, Case)>, Failure> {
    if arguments.named.is_empty() {
        let families = match arguments.families.as_slice() {
            [] => &Family::ALL,
            some => some,
        };
        let random = |index| scene_of_run(families, arguments.seed, index);
        let random = (0..arguments.scenes).map(random);
        return Ok(random.map(|(family, case)| (Some(family), case)).collect());
    }
    let open = |path: &PathBuf| {
        let source = Source::open(path, &arguments.chosen)?;
        let (scene, camera) = source.reference();
        let case = Case {
            name: source.name().to_owned(),
            scene,
            camera,
            reflections: arguments.reflections,
            shading: Shading::BlinnPhong,
        };
        Ok((None, case))
    };
    arguments.named.iter().map(open).collect()
}

/// Writes the scene file and the pictures of a scene that loses pixels.
fn write(folder: &Path, judged: &Judged, case: &Case) -> Result<(), Failure> {
    let name = case.name.replace(['/', '\\'], "_");
    let write = |ending: &str, bytes: &[u8]| -> Result<(), Failure> {
        let path = folder.join(format!("{name}{ending}"));
        fs::write(&path, bytes)
            .map_err(|error| format!("{} cannot be written: {error}", shown(&path)).into())
    };
    for lost in judged.lost.iter().filter(|it| it.count() > 0) {
        write(".json", file::json(case).as_bytes())?;
        let ending = format!("-{}.png", lost.quality.name());
        write(&ending, &file::png(lost)?)?;
    }
    Ok(())
}
