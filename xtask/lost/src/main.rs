//! Counts the pixels that interpolation loses.
//!
//! `cargo run --release --package lost -- --help`

mod arguments;
mod sources;

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use command_line::{Failure, print, shown};
use embedded_graphics::geometry::Size;
use lost::case::{Judged, Lost};
use lost::families::scene_of_run;
use lost::file;
use lost::parallel::in_order;
use lost::table::{FamilyTable, HEAD, LINES_HEAD, Row, lines};

use self::arguments::Arguments;

/// Sizes of pictures of scene files and built-in scenes.
const SIZES: [Size; 2] = [Size::new(96, 96), Size::new(160, 120)];

/// Size of pictures of random scenes.
const RANDOM_SIZE: Size = Size::new(96, 72);

fn main() -> ExitCode {
    match Arguments::read().and_then(|arguments| run(&arguments)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(failure) => {
            // If standard error cannot be written either, nothing is left to do.
            let _ = writeln!(io::stderr(), "error: {failure}");
            ExitCode::from(2)
        }
    }
}

/// Runs the command. Returns whether no limit is exceeded.
fn run(arguments: &Arguments) -> Result<bool, Failure> {
    if let Some(folder) = &arguments.pictures {
        make(folder)?;
    }
    match (&arguments.write, arguments.families.is_empty()) {
        (Some(folder), _) => write_scenes(arguments, folder).map(|()| true),
        (None, true) => draw_named(arguments),
        (None, false) => draw_random(arguments),
    }
}

/// Draws the named scenes and prints a line for each picture.
fn draw_named(arguments: &Arguments) -> Result<bool, Failure> {
    let cases = sources::cases(&arguments.scenes, &arguments.chosen, arguments.reflections)?;
    let (sizes, qualities) = (arguments.sizes_or(&SIZES), arguments.qualities());
    print(format!("{LINES_HEAD}\n"))?;
    let mut rows: Vec<_> = qualities.iter().map(|it| Row::new(*it)).collect();
    let mut outcome = Ok(());
    in_order(
        cases.len() * sizes.len(),
        |index| cases[index / sizes.len()].judge(sizes[index % sizes.len()], &qualities),
        |judged| {
            let judged = judged.map_err(Failure::from);
            note(&mut outcome, judged, |judged| {
                rows.iter_mut().for_each(|row| row.add(judged));
                report(arguments, judged, |_| true)
            });
        },
    );
    outcome?;
    print(format!("\n{HEAD}\n"))?;
    for row in &rows {
        print(format!("{}\n", row.line("all")))?;
    }
    are_within(arguments, &rows)
}

/// Draws random scenes and prints a line for each picture that loses pixels, then a table.
fn draw_random(arguments: &Arguments) -> Result<bool, Failure> {
    let start = Instant::now();
    let (families, qualities) = (arguments.families(), arguments.qualities());
    let sizes = arguments.sizes_or(&[RANDOM_SIZE]);
    let mut table = FamilyTable::new(&families, &qualities);
    let mut outcome = Ok(());
    print(format!("{LINES_HEAD}\n"))?;
    in_order(
        arguments.count * sizes.len(),
        |index| {
            let (family, case) = scene_of_run(&families, arguments.seed, index / sizes.len());
            let judged = case.judge(sizes[index % sizes.len()], &qualities);
            (
                family,
                judged.map_err(|error| format!("{}: {error}", case.name).into()),
            )
        },
        |(family, judged)| {
            note(&mut outcome, judged, |judged| {
                table.add(family, judged);
                report(arguments, judged, |lost| lost.counts.is_any())
            });
        },
    );
    outcome?;
    let lines = table.lines().join("\n");
    let (count, seconds) = (arguments.count, start.elapsed().as_secs_f64());
    print(format!("\n{lines}\n{count} scenes, {seconds:.0} s\n"))?;
    are_within(arguments, &table.all)
}

/// Calls `done` with a result, unless it or one before is an error. Keeps the first error.
fn note(
    outcome: &mut Result<(), Failure>,
    judged: Result<Judged, Failure>,
    done: impl FnOnce(&Judged) -> Result<(), Failure>,
) {
    if outcome.is_ok() {
        *outcome = judged.and_then(|judged| done(&judged));
    }
}

/// Prints the lines of a scene and writes its pictures, for the chosen qualities.
fn report(
    arguments: &Arguments,
    judged: &Judged,
    is_chosen: impl Fn(&Lost) -> bool,
) -> Result<(), Failure> {
    for (lost, line) in judged.lost.iter().zip(lines(judged)) {
        if !is_chosen(lost) {
            continue;
        }
        print(format!("{line}\n"))?;
        if let Some(folder) = &arguments.pictures {
            let path = folder.join(file::picture_name(judged, lost));
            write(&path, &file::png(judged, lost)?)?;
        }
    }
    Ok(())
}

/// Tests the limits, and prints what exceeds one.
fn are_within(arguments: &Arguments, rows: &[Row]) -> Result<bool, Failure> {
    let mut is_within = true;
    for row in rows {
        let quality = row.quality.name();
        let worst = format!("{quality} loses most in {}", row.lost.worst_name);
        let mean = format!("{quality} loses on average");
        let found = [
            (worst, row.lost.worst, arguments.limit_scene),
            (mean, row.lost.mean(), arguments.limit_mean),
        ];
        for (what, found, limit) in found {
            if let Some(limit) = limit.filter(|limit| found > *limit) {
                is_within = false;
                writeln!(io::stderr(), "{what}: {found:.4} %, at most {limit} %")?;
            }
        }
    }
    Ok(is_within)
}

/// Writes random scenes as scene files.
fn write_scenes(arguments: &Arguments, folder: &Path) -> Result<(), Failure> {
    make(folder)?;
    let families = arguments.families();
    for index in 0..arguments.count {
        let (_, case) = scene_of_run(&families, arguments.seed, index);
        let path = folder.join(format!("{}.json", case.name));
        write(&path, file::json(&case).as_bytes())?;
    }
    print(format!("{} scenes in {}\n", arguments.count, shown(folder)))
}

fn make(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder)
        .map_err(|error| format!("{} cannot be made: {error}", shown(folder)).into())
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::write(path, bytes)
        .map_err(|error| format!("{} cannot be written: {error}", shown(path)).into())
}
