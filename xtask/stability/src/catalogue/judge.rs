//! Tries a case of the catalogue and returns the verdict. Never prints.

use command_line::Quality;
use embedded_graphics::geometry::Size;
use lost::case::{difference, differing};
use reflet::host::compare::compare;
use reflet::host::reference::Picture;

use super::draft::Draft;
use super::scene::Scene;
use super::{Bar, Case, Measured, Trial};

/// Width and height of a picture in pixels. `SHORT_SIDE` is used if paths are long.
pub const SIDE: u32 = 96;
pub const SHORT_SIDE: u32 = 32;

/// Largest number of reflections of a picture with the full size.
pub const MANY: u8 = 20;

/// Largest mean error, in 255ths, that counts as no worse than single precision if at least as many
/// pixels are within 8.
pub const UNSEEN: f64 = 0.05;

/// Largest error of a picture of one colour, in 255ths, without the rounding of the display level.
const ONE_LEVEL: f64 = 1.0;

/// Largest share of pixels within 8 of 255 at which a picture counts as chaotic.
const CHAOTIC: f64 = 0.9;

/// Distances by which the eye is moved for further references of a chaotic picture, in scene units.
const NUDGES: [f64; 4] = [1e-7, -1e-7, 2e-7, -2e-7];

/// Factor on the largest difference between those references: a chaotic picture may be off by that
/// much.
const TIMES_NOISE: f64 = 1.5;

/// The outcome of a case: its errors, its bar, and the comparison with single precision.
pub struct Verdict {
    /// What the result was compared with.
    pub reference: &'static str,
    /// Unit of the errors, such as radians.
    pub unit: &'static str,
    /// Errors of fixed point and of single precision; `None` for a case without numbers.
    pub errors: Option<[f64; 2]>,
    /// Shares of the pixels within 8 of 255 in `Exact`, `Fast` and single precision; `None`
    /// if the case is no picture.
    pub within8: Option<[f64; 3]>,
    /// Whether the case meets its bar.
    pub is_met: bool,
    /// Whether `Exact` and `Fast` are no worse than single precision. For a case that is no picture
    /// both are the same.
    pub no_worse: Option<[bool; 2]>,
    /// Text of the bar, and further remarks.
    pub words: String,
}

impl Verdict {
    /// Verdict of a case that was refused before it could be compared.
    const NONE: Self = Self {
        reference: "none",
        unit: "",
        errors: None,
        within8: None,
        is_met: false,
        no_worse: None,
        words: String::new(),
    };
}

/// Tries a case and returns its verdict.
pub fn judge(case: &Case) -> Verdict {
    match &case.trial {
        Trial::Picture(draft, bar) => {
            let is_chaotic = matches!(bar, Bar::Statistics);
            match (Pictures::of(draft, is_chaotic), bar) {
                (Ok(pictures), Bar::Pixels(share)) => pictures.judge(*share),
                (Ok(pictures), Bar::Statistics) => pictures.judge_statistics(),
                (Ok(pictures), Bar::Color(color)) => pictures.judge_color(*color),
                (Err(words), _) => Verdict {
                    words,
                    ..Verdict::NONE
                },
            }
        }
        Trial::Measured(measure) => judge_measured(measure()),
        Trial::Claim(claim) => {
            let outcome = claim();
            Verdict {
                reference: "what is promised",
                is_met: outcome.is_ok(),
                words: outcome.unwrap_or_else(|words| words),
                ..Verdict::NONE
            }
        }
    }
}

fn judge_measured(it: Measured) -> Verdict {
    Verdict {
        reference: it.reference,
        unit: it.unit,
        errors: Some([it.fixed, it.single]),
        is_met: it.fixed <= it.bar,
        no_worse: Some([it.fixed <= it.single; 2]),
        words: format!("at most {:.2e}. {}", it.bar, it.note),
        ..Verdict::NONE
    }
}

/// Pictures of one scene.
pub struct Pictures {
    truth: Picture,
    /// By `Exact`, `Fast`, and in single precision.
    drawn: [Picture; 3],
    /// Reference pictures from slightly moved eyes; empty unless the picture is chaotic.
    nudged: Vec<Picture>,
}

impl Pictures {
    /// Draws all pictures of a scene. For a chaotic scene also draws the references that
    /// statistics need.
    pub fn of(draft: &Draft, is_chaotic: bool) -> Result<Self, String> {
        let scene = Scene::read(draft)?;
        let has_long_paths = draft.reflections > MANY && !is_chaotic;
        let size = Size::new_equal(if has_long_paths { SHORT_SIDE } else { SIDE });
        let nudges = NUDGES.iter().filter(|_| is_chaotic);
        let nudged = nudges.map(|nudge| {
            let mut case = scene.case.clone();
            case.camera.position[0] += nudge;
            case.truth(size)
        });
        Ok(Self {
            nudged: nudged.collect(),
            truth: scene.case.truth(size),
            drawn: [
                scene.drawn(Quality::Exact, size),
                scene.drawn(Quality::Fast, size),
                scene.single(size),
            ],
        })
    }

    /// Returns an error of each picture against the truth.
    fn errors(&self, error: impl Fn(&Picture, &Picture) -> f64) -> [f64; 3] {
        self.drawn.each_ref().map(|it| error(it, &self.truth))
    }

    /// Returns a verdict without a bar, in which a quality is no worse if its error is not larger.
    fn compared(&self, errors: [f64; 3]) -> Verdict {
        let [exact, fast, single] = errors;
        Verdict {
            errors: Some([exact, single]),
            within8: Some(self.errors(within8_of)),
            no_worse: Some([exact, fast].map(|error| error <= single)),
            ..Verdict::NONE
        }
    }

    /// Returns the number of pixels, over both qualities, that differ from those of `other`: at all in
    /// `Exact`, and by more than one level in `Fast`, which may trace a pixel in one of the two scenes
    /// and interpolate it in the other.
    pub fn differing(&self, other: &Self) -> usize {
        let pairs = self.drawn.iter().zip(&other.drawn).zip([0, 1]);
        pairs
            .map(|((one, other), most)| differing(one, other, most))
            .sum()
    }

    fn judge(&self, bar: f64) -> Verdict {
        let (errors, within8) = (self.errors(mean_error), self.errors(within8_of));
        let is_no_worse = |it: usize| {
            errors[it] <= errors[2] || (errors[it] < UNSEEN && within8[it] >= within8[2])
        };
        Verdict {
            reference: "double",
            unit: "mean, 255ths",
            is_met: within8[..2].iter().all(|share| *share >= bar),
            no_worse: Some([0, 1].map(is_no_worse)),
            words: format!(
                "{:.1} % of the pixels within 8, in every quality",
                100.0 * bar
            ),
            ..self.compared(errors)
        }
    }

    fn judge_color(&self, color: [f64; 3]) -> Verdict {
        let wanted = color.map(|channel| 255.0 * channel.clamp(0.0, 1.0));
        let errors = self.errors(|picture, _| {
            let pixels = picture.pixels.iter();
            let channels = pixels.flat_map(|pixel| pixel.iter().zip(wanted));
            largest(channels.map(|(found, wanted)| (f64::from(*found) - wanted).abs()))
        });
        let bar = 0.5 + ONE_LEVEL;
        Verdict {
            reference: "closed form",
            unit: "largest, 255ths",
            is_met: errors[..2].iter().all(|error| *error <= bar),
            words: format!(
                "{bar} in every quality, half of one by rounding; `Fast` {:.2}",
                errors[1]
            ),
            ..self.compared(errors)
        }
    }

    fn judge_statistics(&self) -> Verdict {
        let errors = self.errors(apart);
        let [histogram @ .., _] = self.errors(histogram_error);
        let (furthest, histogram) = (largest(errors[..2].iter().copied()), largest(histogram));
        // Differences between references of the same chaos.
        let nudged = || self.nudged.iter();
        let noise = largest(nudged().map(|it| apart(it, &self.truth)));
        let bins = largest(nudged().map(|it| histogram_error(it, &self.truth)));
        let are_close = furthest <= TIMES_NOISE * noise && histogram <= TIMES_NOISE * bins;
        // Tested with the reference alone: if the eye is moved by less than a pixel can show, the
        // picture is another one.
        let alike = largest(nudged().map(|it| within8_of(it, &self.truth)));
        let is_chaotic = alike <= CHAOTIC;
        Verdict {
            reference: "double, statistics",
            unit: "mean colour, 255ths",
            is_met: are_close && is_chaotic,
            no_worse: Some([0, 1].map(|it| errors[it] <= errors[2].max(noise))),
            words: format!(
                "at most {} % of the reference's own pixels within 8 with its eye moved (here {:.1} %); and \
                 for the mean colour (`Fast` {:.3}) and the \
                 share of pixels in another bin of a histogram of 16 (here {histogram:.4}) at most \
                 {TIMES_NOISE} times what the reference differs from itself by with its eye moved by \
                 {:.0e}: {noise:.3} and {bins:.4}. What is below that cannot be told apart",
                100.0 * CHAOTIC,
                100.0 * alike,
                errors[1],
                largest(NUDGES),
            ),
            ..self.compared(errors)
        }
    }
}

/// Returns the largest number, or 0 if all are negative.
fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    numbers.into_iter().fold(0.0, f64::max)
}

/// Returns the share of the pixels that are within 8 of 255.
fn within8_of(picture: &Picture, truth: &Picture) -> f64 {
    compare(picture, truth).expect("one size").within8
}

/// Tests whether a pixel differs by more than `most` from one of the eight around it.
pub fn is_edge(picture: &Picture, index: usize, most: u8) -> bool {
    let (width, height) = (picture.width as usize, picture.height as usize);
    let (x, y) = (index % width, index / width);
    let near = |at: usize, end: usize| at.saturating_sub(1)..=(at + 1).min(end - 1);
    let mut around = near(y, height).flat_map(|y| near(x, width).map(move |x| y * width + x));
    around.any(|other| difference(picture.pixels[index], picture.pixels[other]) > most)
}

fn mean_error(picture: &Picture, truth: &Picture) -> f64 {
    let found = picture.pixels.as_flattened().iter();
    let pairs = found.zip(truth.pixels.as_flattened());
    let sum: u64 = pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / (3 * truth.pixels.len()) as f64
}

fn mean_color(picture: &Picture) -> [f64; 3] {
    let count = picture.pixels.len() as f64;
    [0, 1, 2].map(|it| {
        let channel = picture.pixels.iter().map(|pixel| f64::from(pixel[it]));
        channel.sum::<f64>() / count
    })
}

/// Returns the largest difference of a channel of the mean colour.
fn apart(picture: &Picture, truth: &Picture) -> f64 {
    let (a, b) = (mean_color(picture), mean_color(truth));
    largest([0, 1, 2].map(|it| (a[it] - b[it]).abs()))
}

/// Returns the share of the channels that are in another of 16 bins. Values that only exchange their
/// pixels do not count.
fn histogram_error(picture: &Picture, truth: &Picture) -> f64 {
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
