//! The catalogue of hard cases. Each says why it is hard, what it is compared with, and how far it
//! may be off. Each chapter is one file.

mod chaos;
mod displays;
pub mod draft;
pub mod judge;
mod scale;
pub mod scene;
mod shading;
mod stiff;
mod suns;
mod tangency;

use self::draft::Draft;

/// A case of the catalogue, before it is judged.
pub struct Case {
    /// Short name; no other case has it.
    pub name: String,
    /// Why the case is hard.
    pub why: &'static str,
    /// How the case is tried.
    pub trial: Trial,
    /// Why single precision may be better here. `None` if it may not.
    pub exception: Option<&'static str>,
}

/// Reason why single precision may be better at an edge.
const LAST_BIT: &str = "An edge passes close to the middles of these pixels, and the last bit of a \
    place or direction decides on which side. All places share one step, 2^-28 of the scene's extent, \
    while a float has smaller ones near zero.";

impl Case {
    /// Creates a case. `why` says why it is hard.
    pub fn new(name: impl Into<String>, why: &'static str, trial: Trial) -> Self {
        Self {
            name: name.into(),
            why,
            trial,
            exception: None,
        }
    }

    /// Allows single precision to be better in this case, for a reason.
    fn unlike_single_precision(self, exception: &'static str) -> Self {
        Self {
            exception: Some(exception),
            ..self
        }
    }
}

/// How a case is tried and compared.
pub enum Trial {
    /// A picture, compared with that of the double-precision reference.
    Picture(Picture),
    /// A quantity that is measured in fixed point and in single precision.
    Measured(fn() -> Measured),
    /// A claim that holds or not, with a text. It is not compared with single precision.
    Claim(fn() -> Result<String, String>),
}

/// A picture to draw, and the bar that it has to meet.
pub struct Picture {
    /// Scene of the case.
    pub draft: Draft,
    /// Largest number of reflections.
    pub reflections: u8,
    /// How the picture is compared.
    pub bar: Bar,
}

/// How a picture is compared, and the bar that it has to meet.
#[derive(Clone, Copy)]
pub enum Bar {
    /// Smallest share of the pixels that must be within 8 of 255.
    Pixels(f64),
    /// Statistics are compared instead of pixels, because errors grow exponentially.
    Statistics,
    /// The colour of all pixels, which a closed form gives, not clamped.
    Color([f64; 3]),
}

/// The errors of a case that is no picture.
pub struct Measured {
    /// What the result is compared with.
    pub reference: &'static str,
    /// Unit of the errors of a case, such as radians.
    pub unit: &'static str,
    /// Measured error of the fixed-point picture of a case.
    pub fixed: f64,
    /// Measured error of the single-precision picture of a case.
    pub single: f64,
    /// Largest error of fixed point that meets the bar.
    pub bar: f64,
    /// Further observations about a case, as text for the page.
    pub note: String,
}

/// Bar of every scene that is accepted: the share of the pixels that must be within 8 of 255.
pub const BAR: f64 = 0.99;

/// Returns a case with a picture of four reflections that must meet [`BAR`].
pub fn picture(name: impl Into<String>, why: &'static str, draft: Draft) -> Case {
    reflected(name, why, draft, 4)
}

/// Returns a case with a picture of `reflections` reflections that must meet [`BAR`].
pub fn reflected(
    name: impl Into<String>,
    why: &'static str,
    draft: Draft,
    reflections: u8,
) -> Case {
    drawn(name, why, draft, (reflections, Bar::Pixels(BAR)))
}

/// Returns a case with a picture that is compared as `bar` says.
pub fn drawn(
    name: impl Into<String>,
    why: &'static str,
    draft: Draft,
    (reflections, bar): (u8, Bar),
) -> Case {
    let picture = Picture {
        draft,
        reflections,
        bar,
    };
    Case::new(name, why, Trial::Picture(picture))
}

/// Returns a case with a claim that holds or not.
pub fn claim(name: &str, why: &'static str, trial: fn() -> Result<String, String>) -> Case {
    Case::new(name, why, Trial::Claim(trial))
}

/// Returns a case with a measured quantity.
pub fn measured(name: &str, why: &'static str, trial: fn() -> Measured) -> Case {
    Case::new(name, why, Trial::Measured(trial))
}

/// A chapter of the catalogue: its title and its cases.
pub type Chapter = (&'static str, Vec<Case>);

/// Returns all chapters, in the order of the page.
pub fn chapters() -> Vec<Chapter> {
    vec![
        ("Stiff accumulation", stiff::cases()),
        ("Chaotic geometry", chaos::cases()),
        ("Scale", scale::cases()),
        ("Tangency and grazing", tangency::cases()),
        ("Shading", shading::cases()),
        ("Suns", suns::cases()),
        ("Displays", displays::cases()),
    ]
}
