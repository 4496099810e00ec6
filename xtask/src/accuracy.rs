//! `cargo xtask accuracy`: measures every built-in scene against the double-precision reference
//! and writes `docs/accuracy.md` and `docs/measured/accuracy.jsonl`.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use float_picture::Shading;
use float_picture::accuracy::{NAMES, Row, measure};
use reflet::host::compare::Difference;
use serde::Serialize;

use crate::kept;

/// File that the command writes, in the repository's folder.
const PAGE: &str = "docs/accuracy.md";
/// File of all figures, one line for each picture and quality.
const FIGURES_FILE: &str = "docs/measured/accuracy.jsonl";
/// Width and height of each measured picture, in pixels.
const SIDE: u32 = 320;
/// Number of reflections that each ray may have.
const REFLECTIONS: u8 = 4;

/// Index of `f32` (single precision) in [`NAMES`]: the last entry.
const SINGLE: usize = NAMES.len() - 1;

/// Accuracy of one built-in scene in one shading.
struct Picture {
    shading: &'static str,
    row: Row,
}

/// One line of [`FIGURES_FILE`]. Shares are in percent. In JSON the keys are the names of the fields.
#[derive(Serialize)]
struct Line {
    scene: &'static str,
    shading: &'static str,
    quality: &'static str,
    same: f64,
    within1: f64,
    /// In dB. `None` if no channel differs.
    psnr: Option<f64>,
    largest: u8,
}

pub fn run() -> Result<()> {
    let mut pictures = Vec::new();
    for (shading, model) in [
        ("blinn-phong", Shading::BlinnPhong),
        ("phong", Shading::Phong),
    ] {
        for scene in reflet::scenes::NAMES {
            let row = measure(scene, SIDE, REFLECTIONS, model).context("no built-in scene")?;
            pictures.push(Picture { shading, row });
        }
    }
    kept::write(FIGURES_FILE.as_ref(), &lines(&pictures)?)?;
    kept::write(PAGE.as_ref(), &page(&pictures)?)
}

fn lines(pictures: &[Picture]) -> Result<String> {
    let rounded = |number: f64, digits: f64| (number * digits).round() / digits;
    let mut lines = String::new();
    for Picture { shading, row } in pictures {
        for (quality, of) in NAMES.into_iter().zip(&row.differences) {
            let line = Line {
                scene: row.scene,
                shading,
                quality,
                same: rounded(100.0 * of.same, 1e3),
                within1: rounded(100.0 * of.within1, 1e3),
                psnr: of.psnr.is_finite().then(|| rounded(of.psnr, 10.0)),
                largest: of.max,
            };
            writeln!(lines, "{}", serde_json::to_string(&line)?)?;
        }
    }
    Ok(lines)
}

fn page(pictures: &[Picture]) -> Result<String> {
    let mut page = include_str!("accuracy.md")
        .replace("SIDE", &SIDE.to_string())
        .replace("REFLECTIONS", &REFLECTIONS.to_string());
    writeln!(
        page,
        "\n| | same | within 1 | PSNR in dB | largest |\n|---|---|---|---|---|"
    )?;
    for (index, name) in NAMES.iter().enumerate() {
        writeln!(page, "| `{name}` | {} |", worst(pictures, index))?;
    }
    writeln!(
        page,
        "\n## Beside single precision\n\nPictures of {} in which the quality has the reference's value on \
         at least as many pixels as `f32`, or on 99.99 %:\n",
        pictures.len()
    )?;
    for (index, name) in NAMES.iter().enumerate().take(SINGLE) {
        let near = pictures
            .iter()
            .filter(|it| it.row.is_as_near_as_single_precision(index))
            .count();
        writeln!(page, "- `{name}`: {near}")?;
    }
    Ok(page)
}

/// Returns the worst value of each figure for one quality, and the picture in which it occurs.
fn worst(pictures: &[Picture], index: usize) -> String {
    let worst = FIGURES.map(|figure| {
        let badness = |it: &&Picture| figure.badness(&it.row.differences[index]);
        let worst = pictures
            .iter()
            .max_by(|one, other| badness(one).total_cmp(&badness(other)));
        worst.map_or_else(String::new, |it| {
            let text = figure.text(&it.row.differences[index]);
            format!("{text} ({}, {})", it.row.scene, it.shading)
        })
    });
    worst.join(" | ")
}

#[derive(Clone, Copy)]
enum Figure {
    Same,
    Within1,
    Psnr,
    Largest,
}

const FIGURES: [Figure; 4] = [Figure::Same, Figure::Within1, Figure::Psnr, Figure::Largest];

impl Figure {
    /// Returns the figure as a number that is larger for a worse picture, for finding the worst
    /// case.
    fn badness(self, of: &Difference) -> f64 {
        match self {
            Self::Same => -of.same,
            Self::Within1 => -of.within1,
            Self::Psnr => -of.psnr,
            Self::Largest => of.max.into(),
        }
    }

    fn text(self, of: &Difference) -> String {
        match self {
            Self::Same => format!("{:.3} %", 100.0 * of.same),
            Self::Within1 => format!("{:.3} %", 100.0 * of.within1),
            Self::Psnr if of.psnr.is_infinite() => "∞".to_owned(),
            Self::Psnr => format!("{:.1}", of.psnr),
            Self::Largest => of.max.to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(same: f64, max: u8) -> Difference {
        Difference {
            same,
            within1: same,
            within8: same,
            psnr: 100.0 * same,
            max,
        }
    }

    fn pictures() -> [Picture; 2] {
        [("ball", 0.5, 9), ("cube", 0.75, 200)].map(|(scene, same, max)| Picture {
            shading: "phong",
            row: Row {
                scene,
                differences: [
                    difference(same, max),
                    difference(0.999, 1),
                    difference(0.99995, 1),
                    difference(0.99999, 1),
                ],
            },
        })
    }

    #[test]
    fn page_has_the_worst_case_of_each_figure_and_the_file_has_all() {
        let page = page(&pictures()).unwrap();
        let worst = "| `fast` | 50.000 % (ball, phong) | 50.000 % (ball, phong) | 50.0 (ball, phong) \
                     | 200 (cube, phong) |";
        assert!(page.contains(worst), "{page}");
        assert!(
            page.lines().all(|line| line.chars().count() <= 200),
            "{page}"
        );
        let lines = lines(&pictures()).unwrap();
        let cube = r#"{"scene":"cube","shading":"phong","quality":"fast","same":75.0,"within1":75.0,"psnr":75.0,"largest":200}"#;
        assert_eq!(lines.lines().nth(4), Some(cube));
        assert_eq!(lines.lines().count(), 8);
    }

    #[test]
    fn picture_with_one_pixel_in_ten_thousand_off_is_as_near_as_any() {
        let [picture, _] = pictures();
        assert_eq!(
            [0, 1, 2].map(|quality| picture.row.is_as_near_as_single_precision(quality)),
            [false, false, true]
        );
    }
}
