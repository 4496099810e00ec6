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
    /// A picture, compared with that of the double-precision reference as the bar says.
    Picture(Draft, Bar),
    /// A quantity that is measured in fixed point and in single precision.
    Measured(fn() -> Measured),
    /// A claim that holds or not, with a text. It is not compared with single precision.
    Claim(fn() -> Result<String, String>),
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
    /// Unit of the errors, such as radians.
    pub unit: &'static str,
    /// Errors of fixed point and of single precision.
    pub fixed: f64,
    pub single: f64,
    /// Largest error of fixed point that meets the bar.
    pub bar: f64,
    /// Further observations about a case, as text for the page.
    pub note: String,
}

/// Bar of every scene that is accepted: the share of the pixels that must be within 8 of 255.
pub const BAR: f64 = 0.99;

/// Returns a case with a picture that must meet [`BAR`].
pub fn picture(name: impl Into<String>, why: &'static str, draft: Draft) -> Case {
    Case::new(name, why, Trial::Picture(draft, Bar::Pixels(BAR)))
}

/// Returns the titles and cases of all chapters, in the order of the page.
pub fn chapters() -> [(&'static str, Vec<Case>); 7] {
    [
        ("Stiff accumulation", stiff::cases()),
        ("Chaotic geometry", chaos::cases()),
        ("Scale", scale::cases()),
        ("Tangency and grazing", tangency::cases()),
        ("Shading", shading::cases()),
        ("Suns", suns::cases()),
        ("Displays", displays::cases()),
    ]
}
