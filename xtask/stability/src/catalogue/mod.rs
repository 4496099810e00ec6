//! The catalogue of cases that are hard: what makes each hard, what it is compared with, and how
//! much it may be off. One file a chapter.

mod chaos;
mod displays;
pub mod draft;
mod exact;
pub mod judge;
mod range;
mod scale;
mod shading;
mod stiff;
mod tangency;

use self::draft::Draft;

/// A case before it is judged.
pub struct Case {
    /// Short, and the only one of its name.
    pub name: String,
    /// Why it is hard.
    pub why: &'static str,
    /// What is done.
    pub trial: Trial,
    /// Why single precision may be better; without a reason it may not.
    pub exception: Option<&'static str>,
}

/// Why single precision may be better at an edge.
const LAST_BIT: &str = "An edge passes close to the middles of these pixels, and the last bit of a \
    place or direction decides on which side. All places share one step, 2^-28 of the scene's extent, \
    while a float has smaller ones near zero.";

impl Case {
    /// A case that is hard for a reason.
    pub fn new(name: impl Into<String>, why: &'static str, trial: Trial) -> Self {
        Self {
            name: name.into(),
            why,
            trial,
            exception: None,
        }
    }

    /// The same case, in which single precision may be better for a reason.
    fn unlike_single_precision(self, exception: &'static str) -> Self {
        Self {
            exception: Some(exception),
            ..self
        }
    }
}

/// How a case is tried.
pub enum Trial {
    /// A picture, compared with the double-precision reference's.
    Picture(Picture),
    /// A picture of one colour that is known in closed form.
    Closed {
        /// The scene.
        draft: Draft,
        /// Reflections.
        reflections: u8,
        /// The colour, not clamped.
        color: [f64; 3],
    },
    /// Something else that is measured, in both number formats.
    Measured(fn() -> Measured),
    /// Something that holds or not, in words; single precision has no part in it.
    Claim(fn() -> Result<String, String>),
}

/// A picture and its bar.
pub struct Picture {
    /// The scene.
    pub draft: Draft,
    /// Reflections.
    pub reflections: u8,
    /// The share of pixels that must be within 8 of 255.
    pub bar: f64,
    /// Whether statistics are compared and not pixels: errors grow exponentially there.
    pub is_chaotic: bool,
}

/// The errors of a case that is no picture.
pub struct Measured {
    /// What it is compared with.
    pub reference: &'static str,
    /// What the errors are errors of.
    pub unit: &'static str,
    /// Of fixed point.
    pub fixed: f64,
    /// Of single precision.
    pub single: f64,
    /// How large the error of fixed point may be.
    pub bar: f64,
    /// Below this the two errors cannot be told apart.
    pub uncertain: f64,
    /// What else was seen.
    pub note: String,
}

/// The bar of every scene that is accepted: the share of pixels within 8 of 255.
pub const BAR: f64 = 0.99;

/// A picture with four reflections that must meet the bar.
pub fn picture(name: impl Into<String>, why: &'static str, draft: Draft) -> Case {
    reflected(name, why, draft, 4)
}

/// The same with so many reflections.
pub fn reflected(
    name: impl Into<String>,
    why: &'static str,
    draft: Draft,
    reflections: u8,
) -> Case {
    let picture = Picture {
        draft,
        reflections,
        bar: BAR,
        is_chaotic: false,
    };
    Case::new(name, why, Trial::Picture(picture))
}

/// Something that holds or not.
pub fn claim(name: &str, why: &'static str, trial: fn() -> Result<String, String>) -> Case {
    Case::new(name, why, Trial::Claim(trial))
}

/// Something that is measured.
pub fn measured(name: &str, why: &'static str, trial: fn() -> Measured) -> Case {
    Case::new(name, why, Trial::Measured(trial))
}

/// A chapter: its title and its cases.
pub type Chapter = (&'static str, Vec<Case>);

/// All chapters, in the order of the page.
pub fn chapters() -> Vec<Chapter> {
    vec![
        ("Stiff accumulation", stiff::cases()),
        ("Chaotic geometry", chaos::cases()),
        ("Scale", scale::cases()),
        ("Tangency and grazing", tangency::cases()),
        ("Shading", shading::cases()),
        ("Range", range::cases()),
        ("Displays", displays::cases()),
    ]
}
