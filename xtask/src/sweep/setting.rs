//! A setting of a sweep as a value: fixed point or float, quality, reflections and pixel size.

use reflet::Unit;
use reflet::quality::{Exact, Fast, Quality};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Setting {
    pub contestant: Contestant,
    /// Largest number of reflections.
    pub reflections: u8,
    /// Width and height of a drawn pixel, in pixels of the picture; at least 1.
    pub scale: u8,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Contestant {
    Float,
    Fixed(Level),
    /// [`Level::Fast`] without shadows.
    Unshadowed,
}

/// A quality as a value: one of the library's, or [`Fast`] with one constant changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Level {
    Fast,
    Exact,
    /// [`Fast`] with a smallest weight of 2⁻²: paths stop below it.
    Cut4,
    /// [`Fast`] with a smallest weight of 2⁻⁴.
    Cut16,
    /// [`Fast`] with a smallest weight of 2⁻⁶.
    Cut64,
    /// [`Fast`] with 4 times the tolerance of interpolation between traced pixels.
    Rough4,
    /// [`Fast`] with 16 times the tolerance of interpolation between traced pixels.
    Rough16,
}

/// [`Fast`] with another smallest weight, in steps of 2⁻³⁰, and with its tolerance multiplied by
/// `TOLERANCES`.
struct Own<const WEIGHT: i32, const TOLERANCES: i32>;

impl<const WEIGHT: i32, const TOLERANCES: i32> Quality for Own<WEIGHT, TOLERANCES> {
    const SMALLEST_WEIGHT: Unit = Unit::from_bits(WEIGHT);
    const TOLERANCE: Unit = Unit::from_bits(TOLERANCES * Fast::TOLERANCE.to_bits());
}

const FAST_WEIGHT: i32 = Fast::SMALLEST_WEIGHT.to_bits();

/// Code that runs for the type of a level; [`Level::visit`] calls it.
pub trait Visitor {
    type Output;

    fn visit<Q: Quality>(self) -> Self::Output;
}

#[derive(Clone, Copy, Debug)]
pub struct Numbers {
    pub smallest_weight: Unit,
    pub tolerance: Unit,
}

struct AsNumbers;

impl Visitor for AsNumbers {
    type Output = Numbers;

    fn visit<Q: Quality>(self) -> Numbers {
        Numbers {
            smallest_weight: Q::SMALLEST_WEIGHT,
            tolerance: Q::TOLERANCE,
        }
    }
}

impl Level {
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Exact => "exact",
            Self::Cut4 => "fast, cut at 1/4",
            Self::Cut16 => "fast, cut at 1/16",
            Self::Cut64 => "fast, cut at 1/64",
            Self::Rough4 => "fast, 4 x tolerance",
            Self::Rough16 => "fast, 16 x tolerance",
        }
    }

    /// Returns the name of the library's type, if it has one.
    pub fn library_type(self) -> Option<&'static str> {
        match self {
            Self::Fast => Some("Fast"),
            Self::Exact => Some("Exact"),
            _ => None,
        }
    }

    pub fn visit<V: Visitor>(self, visitor: V) -> V::Output {
        match self {
            Self::Fast => visitor.visit::<Fast>(),
            Self::Exact => visitor.visit::<Exact>(),
            Self::Cut4 => visitor.visit::<Own<{ 1 << 28 }, 1>>(),
            Self::Cut16 => visitor.visit::<Own<{ 1 << 26 }, 1>>(),
            Self::Cut64 => visitor.visit::<Own<{ 1 << 24 }, 1>>(),
            Self::Rough4 => visitor.visit::<Own<FAST_WEIGHT, 4>>(),
            Self::Rough16 => visitor.visit::<Own<FAST_WEIGHT, 16>>(),
        }
    }

    pub fn numbers(self) -> Numbers {
        self.visit(AsNumbers)
    }
}

impl Setting {
    /// Returns a setting of fixed point with shadows and at full resolution.
    pub fn fixed(level: Level, reflections: u8) -> Self {
        Self {
            contestant: Contestant::Fixed(level),
            reflections,
            scale: 1,
        }
    }

    /// Returns a setting of fixed point without shadows.
    pub fn unshadowed(reflections: u8, scale: u8) -> Self {
        Self {
            contestant: Contestant::Unshadowed,
            reflections,
            scale,
        }
    }

    pub fn float(reflections: u8, scale: u8) -> Self {
        Self {
            contestant: Contestant::Float,
            reflections,
            scale,
        }
    }

    pub fn is_float(&self) -> bool {
        self.contestant == Contestant::Float
    }

    pub fn words(&self) -> String {
        let name = match self.contestant {
            Contestant::Float => "float",
            Contestant::Fixed(level) => level.name(),
            Contestant::Unshadowed => "fast, no shadows",
        };
        let mut words = format!("N = {}, {name}", self.reflections);
        if self.scale > 1 {
            words += &format!(", {0} x {0} pixels", self.scale);
        }
        words
    }
}
