//! Tries a case and says what came of it; it never prints.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::RgbColor;
use float_picture::Shading as SingleShading;
use reflet::host::compare::compare;
use reflet::host::file::SceneFile;
use reflet::host::reference::{self, Shading, render};
use reflet::{Fine, Frame, Quality, World};

use super::{Case, Measured, Trial};

/// Pixels a side, and where paths are long.
pub const SIDE: u32 = 96;
pub const SHORT_SIDE: u32 = 32;

/// More reflections than this are many.
pub const MANY: u8 = 20;

/// What is not seen on 8 bits: single precision is no better where the mean error of fixed point
/// is below this, in 255ths.
pub const UNSEEN: f64 = 0.05;

/// How far a picture of one colour may be off, in 255ths.
const ONE_LEVEL: f64 = 1.0;

/// How far the mean colour and the histogram of a chaotic picture may be off.
const MEAN_LEVELS: f64 = 1.0;
const HISTOGRAM: f64 = 0.05;

/// What came of a case.
pub struct Verdict {
    /// What it was compared with.
    pub reference: &'static str,
    /// What the errors are errors of.
    pub unit: &'static str,
    /// The errors of fixed point and of single precision; none of what has no number.
    pub errors: Option<[f64; 2]>,
    /// The shares of pixels within 8 of 255, of a picture: `Fine`, `Fast` and single precision.
    pub within8: Option<[f64; 3]>,
    /// Whether the bar is met.
    pub is_met: bool,
    /// Whether fixed point is no worse than single precision.
    pub is_no_worse: Option<bool>,
    /// The bar, and what else is to be said.
    pub words: String,
}

/// Tries a case.
pub fn judge(case: &Case) -> Verdict {
    match &case.trial {
        Trial::Picture(picture) => match Pictures::of(&picture.draft.text(), picture.reflections) {
            Ok(pictures) => match picture.is_chaotic {
                true => pictures.judge_statistics(),
                false => pictures.judge(picture.bar),
            },
            Err(words) => refused(words),
        },
        Trial::Closed {
            draft,
            reflections,
            color,
        } => match Pictures::of(&draft.text(), *reflections) {
            Ok(pictures) => pictures.judge_color(*color),
            Err(words) => refused(words),
        },
        Trial::Measured(measure) => judge_measured(measure()),
        Trial::Claim(claim) => {
            let outcome = claim();
            Verdict {
                reference: "what is promised",
                unit: "",
                errors: None,
                within8: None,
                is_met: outcome.is_ok(),
                is_no_worse: None,
                words: outcome.unwrap_or_else(|words| words),
            }
        }
    }
}

fn refused(words: String) -> Verdict {
    Verdict {
        reference: "none",
        unit: "",
        errors: None,
        within8: None,
        is_met: false,
        is_no_worse: None,
        words,
    }
}

fn judge_measured(measured: Measured) -> Verdict {
    let Measured {
        reference,
        unit,
        fixed,
        single,
        bar,
        note,
    } = measured;
    Verdict {
        reference,
        unit,
        errors: Some([fixed, single]),
        within8: None,
        is_met: fixed <= bar,
        is_no_worse: Some(fixed <= single),
        words: format!("at most {bar:.2e}. {note}"),
    }
}

/// One scene, painted in every way.
pub struct Pictures {
    truth: reference::Picture,
    fine: reference::Picture,
    fast: reference::Picture,
    single: reference::Picture,
}

/// A picture by the core, painted row by row.
pub fn painted<W: World + Copy, Q: Quality>(
    frame: Frame<'_, W, Q>,
    (width, height): (u32, u32),
) -> reference::Picture {
    let picture = frame.sized(Size::new(width, height));
    let mut row = vec![Rgb888::BLACK; width as usize];
    let mut pixels = Vec::new();
    for y in 0..height {
        picture.row(y, 0, &mut row);
        pixels.extend(row.iter().map(|it| [it.r(), it.g(), it.b()]));
    }
    reference::Picture {
        width,
        height,
        pixels,
    }
}

impl Pictures {
    /// Of a scene file.
    pub fn of(text: &str, reflections: u8) -> Result<Self, String> {
        let file = SceneFile::parse(text, None).map_err(|error| error.to_string())?;
        let built = file.build().map_err(|error| error.to_string())?;
        let (_, camera) = file.runtime().map_err(|error| error.to_string())?;
        let frame = || built.frame(&camera).reflections(reflections);
        let (scene, eye) = file.reference();
        let side = match reflections > MANY {
            true => SHORT_SIDE,
            false => SIDE,
        };
        let size = (side, side);
        let n = u32::from(reflections);
        Ok(Self {
            truth: render(&scene, &eye, side, side, n, Shading::BlinnPhong),
            fine: painted(frame().quality::<Fine>(), size),
            fast: painted(frame(), size),
            single: float_picture::render(&scene, &eye, size, n, SingleShading::BlinnPhong),
        })
    }

    fn against_truth(&self) -> [f64; 3] {
        let pictures = [&self.fine, &self.fast, &self.single];
        pictures.map(|picture| compare(picture, &self.truth).expect("one size").within8)
    }

    fn judge(&self, bar: f64) -> Verdict {
        let within8 = self.against_truth();
        let [fixed, single] = [&self.fine, &self.single].map(|it| mean_error(it, &self.truth));
        let [fine, fast, _] = within8;
        Verdict {
            reference: "double",
            unit: "mean, 255ths",
            errors: Some([fixed, single]),
            within8: Some(within8),
            is_met: fine >= bar && fast >= bar,
            is_no_worse: Some(fixed <= single.max(UNSEEN)),
            words: format!(
                "{:.1} % of the pixels within 8, in `Fine` and `Fast`",
                100.0 * bar
            ),
        }
    }

    fn judge_color(&self, color: [f64; 3]) -> Verdict {
        let furthest = |picture: &reference::Picture| {
            let off = |pixel: &[u8; 3]| {
                let off = [0, 1, 2].map(|channel| {
                    (f64::from(pixel[channel]) - 255.0 * color[channel].clamp(0.0, 1.0)).abs()
                });
                off.into_iter().fold(0.0, f64::max)
            };
            picture.pixels.iter().map(off).fold(0.0, f64::max)
        };
        let [fine, fast, single] = [&self.fine, &self.fast, &self.single].map(furthest);
        let bar = 0.5 + ONE_LEVEL;
        Verdict {
            reference: "closed form",
            unit: "largest, 255ths",
            errors: Some([fine, single]),
            within8: Some(self.against_truth()),
            is_met: fine <= bar && fast <= bar,
            // Half a level is lost by rounding to 8 bits.
            is_no_worse: Some(fine <= single.max(0.5 + UNSEEN)),
            words: format!("{bar} in `Fine` and `Fast`, half of one by rounding; `Fast` {fast:.2}"),
        }
    }

    fn judge_statistics(&self) -> Verdict {
        let within8 = self.against_truth();
        let apart = |picture| {
            let (a, b) = (mean_color(picture), mean_color(&self.truth));
            [0, 1, 2]
                .map(|it| (a[it] - b[it]).abs())
                .into_iter()
                .fold(0.0, f64::max)
        };
        let [fine, fast, single] = [&self.fine, &self.fast, &self.single].map(apart);
        let histograms = [&self.fine, &self.fast].map(|it| histogram_error(it, &self.truth));
        let histogram = histograms.into_iter().fold(0.0, f64::max);
        Verdict {
            reference: "double, statistics",
            unit: "mean colour, 255ths",
            errors: Some([fine, single]),
            within8: Some(within8),
            is_met: fine.max(fast) <= MEAN_LEVELS && histogram <= HISTOGRAM,
            is_no_worse: Some(fine <= single.max(UNSEEN)),
            words: format!(
                "{MEAN_LEVELS} for the mean colour and {HISTOGRAM} for the share of pixels in \
                 another bin of a histogram of 16; that share is {histogram:.4}"
            ),
        }
    }
}

fn mean_error(picture: &reference::Picture, truth: &reference::Picture) -> f64 {
    let pairs = picture
        .pixels
        .iter()
        .flatten()
        .zip(truth.pixels.iter().flatten());
    let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / (3 * truth.pixels.len()) as f64
}

fn mean_color(picture: &reference::Picture) -> [f64; 3] {
    let count = picture.pixels.len() as f64;
    [0, 1, 2].map(|it| {
        let sum: f64 = picture
            .pixels
            .iter()
            .map(|pixel| f64::from(pixel[it]))
            .sum();
        sum / count
    })
}

/// The share of channels that lie in another of 16 bins, those that have changed places apart.
fn histogram_error(picture: &reference::Picture, truth: &reference::Picture) -> f64 {
    let mut bins = [0_i64; 48];
    for (pictures, sign) in [(picture, 1), (truth, -1)] {
        for pixel in &pictures.pixels {
            for (channel, value) in pixel.iter().enumerate() {
                bins[16 * channel + usize::from(value / 16)] += sign;
            }
        }
    }
    let moved: i64 = bins.iter().map(|count| count.abs()).sum();
    moved as f64 / (2 * 3 * truth.pixels.len()) as f64
}
