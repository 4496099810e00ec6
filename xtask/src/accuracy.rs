//! `cargo xtask accuracy`: measures every built-in scene against the double-precision reference
//! and writes `docs/accuracy.md` and `docs/measured/accuracy.jsonl`.

use std::fmt::Write as _;

use anyhow::{Context, Result};
use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::geometry::Size;
use reflet::host::compare::{Difference, compare};
use reflet::host::reference::render;
use reflet::scenes;
use serde::Serialize;

use crate::{kept, table::rounded};

/// File that the command writes, in the repository's folder.
const PAGE: &str = "docs/accuracy.md";
/// File of all figures, one line for each picture and quality.
const FIGURES_FILE: &str = "docs/measured/accuracy.jsonl";
const SIDE: u32 = 320;
/// Number of reflections that each ray may have.
const REFLECTIONS: u8 = 4;

/// The measured qualities. The float port in single precision follows.
const QUALITIES: [Quality; 3] = [Quality::Fast, Quality::Small, Quality::Exact];

/// Names of the qualities and of single precision, in the order of [`Picture::differences`].
const NAMES: [&str; 4] = ["fast", "small", "exact", "f32"];

/// Share of pixels equal to the reference's that counts as all of them: one in ten thousand may
/// differ.
const ALL: f64 = 0.9999;

struct Picture {
    scene: &'static str,
    shading: &'static str,
    /// Differences from the reference: those of each quality, then that of the float port in `f32`.
    differences: [Difference; NAMES.len()],
}

impl Picture {
    fn measured(scene: &'static str, shading: Shading) -> Result<Self> {
        let source = Source::built_in(scene).context("no built-in scene")?;
        let ((exact, camera), n) = (source.reference(), REFLECTIONS.into());
        let truth = render(&exact, &camera, SIDE, SIDE, n, shading.into());
        let fixed = QUALITIES.map(|quality| {
            let settings = Settings {
                reflections: REFLECTIONS,
                shading,
                quality,
            };
            source.drawn(Size::new_equal(SIDE), settings)
        });
        let [fast, small, precise] = fixed;
        let single = float_picture::render(&exact, &camera, (SIDE, SIDE), n, shading.into());
        Ok(Self {
            scene,
            shading: shading.name(),
            differences: [fast, small, precise, single]
                .map(|picture| compare(&picture, &truth).expect("all have one size")),
        })
    }

    /// Tests whether a quality equals the reference in at least as many pixels as single precision
    /// does, or in all but one of ten thousand. `quality` is an index into [`NAMES`].
    fn is_as_near_as_single_precision(&self, quality: usize) -> bool {
        let [.., single] = self.differences.map(|it| it.same);
        self.differences[quality].same >= single.min(ALL)
    }
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
    let pictures = measured()?;
    kept::write(FIGURES_FILE.as_ref(), &lines(&pictures)?)?;
    kept::write(PAGE.as_ref(), &page(&pictures)?)
}

fn measured() -> Result<Vec<Picture>> {
    let shadings = [Shading::BlinnPhong, Shading::Phong].into_iter();
    let pictures =
        shadings.flat_map(|shading| scenes::NAMES.map(|it| Picture::measured(it, shading)));
    pictures.collect()
}

fn lines(pictures: &[Picture]) -> Result<String> {
    let mut lines = String::new();
    for picture in pictures {
        for (quality, of) in NAMES.into_iter().zip(&picture.differences) {
            let line = Line {
                scene: picture.scene,
                shading: picture.shading,
                quality,
                same: rounded(100.0 * of.same, 3),
                within1: rounded(100.0 * of.within1, 3),
                psnr: of.psnr.is_finite().then(|| rounded(of.psnr, 1)),
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
    for (index, name) in NAMES.iter().enumerate().take(QUALITIES.len()) {
        let is_near = |it: &&Picture| it.is_as_near_as_single_precision(index);
        let near = pictures.iter().filter(is_near).count();
        writeln!(page, "- `{name}`: {near}")?;
    }
    Ok(page)
}

/// A figure of a picture: a number that is larger for a worse picture, and its text.
type Figure = (fn(&Difference) -> f64, fn(&Difference) -> String);

const FIGURES: [Figure; 4] = [
    (|it| -it.same, |it| format!("{:.3} %", 100.0 * it.same)),
    (
        |it| -it.within1,
        |it| format!("{:.3} %", 100.0 * it.within1),
    ),
    (
        |it| -it.psnr,
        |it| {
            if it.psnr.is_infinite() { "∞".to_owned() } else { format!("{:.1}", it.psnr) }
        },
    ),
    (|it| it.max.into(), |it| it.max.to_string()),
];

/// Returns the worst value of each figure for one quality, and the picture in which it occurs.
fn worst(pictures: &[Picture], index: usize) -> String {
    let worst = FIGURES.map(|(badness, text)| {
        let of = |it: &&Picture| badness(&it.differences[index]);
        let worst = pictures.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
        worst.map_or_else(String::new, |it| {
            let text = text(&it.differences[index]);
            format!("{text} ({}, {})", it.scene, it.shading)
        })
    });
    worst.join(" | ")
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
            scene,
            shading: "phong",
            differences: [
                difference(same, max),
                difference(0.999, 1),
                difference(0.99995, 1),
                difference(0.99999, 1),
            ],
        })
    }

    #[test]
    fn page_has_the_worst_case_of_each_figure_and_the_file_has_all() {
        let page = page(&pictures()).unwrap();
        let worst = "| `fast` | 50.000 % (ball, phong) | 50.000 % (ball, phong) | 50.0 (ball, phong) \
                     | 200 (cube, phong) |";
        assert!(page.contains(worst), "{page}");
        let is_short = |line: &str| line.chars().count() <= 200;
        assert!(page.lines().all(is_short), "{page}");
        let lines = lines(&pictures()).unwrap();
        let cube = r#"{"scene":"cube","shading":"phong","quality":"fast","same":75.0,"within1":75.0,"psnr":75.0,"largest":200}"#;
        assert_eq!(lines.lines().nth(4), Some(cube));
        assert_eq!(lines.lines().count(), 8);
    }

    #[test]
    fn exact_is_no_worse_than_single_precision() {
        let exact = NAMES.iter().position(|name| *name == "exact").unwrap();
        let pictures = measured().unwrap();
        let worse = pictures.iter();
        let worse = worse.filter(|it| !it.is_as_near_as_single_precision(exact));
        let worse: Vec<_> = worse.map(|it| (it.scene, it.shading)).collect();
        assert!(worse.is_empty(), "{worse:?}");
    }

    #[test]
    fn picture_with_one_pixel_in_ten_thousand_off_is_as_near_as_any() {
        let [picture, _] = pictures();
        let near = [0, 1, 2].map(|quality| picture.is_as_near_as_single_precision(quality));
        assert_eq!(near, [false, false, true]);
    }
}
