//! The settings that are tried; it draws nothing.

use reflet::{Exact, Fast, Fine, Quality, Unit};
use serde_json::{Value, json};

/// One setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Setting {
    pub contestant: Contestant,
    pub reflections: u8,
    /// A pixel that is drawn covers so many by so many.
    pub scale: u8,
}

/// What draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Contestant {
    Float,
    Fixed { level: Level, shadows: bool },
}

/// A quality, as a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Level {
    Fast,
    Fine,
    Exact,
    /// [`Fast`] with a weight cut-off of 2⁻²
    Cut4,
    /// 2⁻⁴
    Cut16,
    /// 2⁻⁶
    Cut64,
    /// [`Fast`] with four times its tolerance between traced pixels
    Rough4,
    /// 16 times
    Rough16,
}

/// A quality by its numbers, in steps of 2⁻³⁰.
pub struct Own<const STRIDE: u32, const TOLERANCE: i32, const WEIGHT: i32>;

impl<const STRIDE: u32, const TOLERANCE: i32, const WEIGHT: i32> Quality
    for Own<STRIDE, TOLERANCE, WEIGHT>
{
    const SMALLEST_WEIGHT: Unit = Unit::from_bits(WEIGHT);
    const STRIDE: u32 = STRIDE;
    const TOLERANCE: Unit = Unit::from_bits(TOLERANCE);
}

const FAST_TOLERANCE: i32 = Fast::TOLERANCE.to_bits();
const FAST_WEIGHT: i32 = Fast::SMALLEST_WEIGHT.to_bits();

type Cut4 = Own<4, FAST_TOLERANCE, { 1 << 28 }>;
type Cut16 = Own<4, FAST_TOLERANCE, { 1 << 26 }>;
type Cut64 = Own<4, FAST_TOLERANCE, { 1 << 24 }>;
type Rough4 = Own<4, { 4 * FAST_TOLERANCE }, FAST_WEIGHT>;
type Rough16 = Own<4, { 16 * FAST_TOLERANCE }, FAST_WEIGHT>;

/// What is done with a quality that is only known by its value.
pub trait Visitor {
    /// What it returns.
    type Output;

    /// Does it with the quality `Q`, and with one that traces every pixel and is else the same.
    fn visit<Q: Quality, T: Quality>(self) -> Self::Output;
}

/// A quality's numbers.
#[derive(Clone, Copy, Debug)]
pub struct Numbers {
    pub smallest_weight: Unit,
    pub stride: u32,
    pub tolerance: Unit,
}

struct AsNumbers;

impl Visitor for AsNumbers {
    type Output = Numbers;

    fn visit<Q: Quality, T: Quality>(self) -> Numbers {
        Numbers {
            smallest_weight: Q::SMALLEST_WEIGHT,
            stride: Q::STRIDE,
            tolerance: Q::TOLERANCE,
        }
    }
}

impl Level {
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Fine => "fine",
            Self::Exact => "exact",
            Self::Cut4 => "fast, cut at 1/4",
            Self::Cut16 => "fast, cut at 1/16",
            Self::Cut64 => "fast, cut at 1/64",
            Self::Rough4 => "fast, 4 x tolerance",
            Self::Rough16 => "fast, 16 x tolerance",
        }
    }

    pub fn visit<V: Visitor>(self, visitor: V) -> V::Output {
        match self {
            Self::Fast => visitor.visit::<Fast, Own<1, 0, FAST_WEIGHT>>(),
            Self::Fine => visitor.visit::<Fine, Exact>(),
            Self::Exact => visitor.visit::<Exact, Exact>(),
            Self::Cut4 => visitor.visit::<Cut4, Own<1, 0, { 1 << 28 }>>(),
            Self::Cut16 => visitor.visit::<Cut16, Own<1, 0, { 1 << 26 }>>(),
            Self::Cut64 => visitor.visit::<Cut64, Own<1, 0, { 1 << 24 }>>(),
            Self::Rough4 => visitor.visit::<Rough4, Own<1, 0, FAST_WEIGHT>>(),
            Self::Rough16 => visitor.visit::<Rough16, Own<1, 0, FAST_WEIGHT>>(),
        }
    }

    pub fn numbers(self) -> Numbers {
        self.visit(AsNumbers)
    }

    /// How `cargo xtask sweep` is told.
    fn json(self) -> Value {
        let Numbers {
            smallest_weight,
            stride,
            tolerance,
        } = self.numbers();
        match self {
            Self::Fast => json!("fast"),
            Self::Fine => json!("fine"),
            Self::Exact => json!("exact"),
            _ => json!({
                "stride": stride,
                "tolerance": tolerance.to_bits(),
                "smallest_weight": smallest_weight.to_bits(),
            }),
        }
    }
}

impl Setting {
    /// In fixed point with shadows.
    pub fn fixed(level: Level, reflections: u8) -> Self {
        Self {
            contestant: Contestant::Fixed {
                level,
                shadows: true,
            },
            reflections,
            scale: 1,
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

    /// How `cargo xtask sweep` is told, and what is kept of it is found by.
    pub fn json(&self) -> Value {
        let contestant = match self.contestant {
            Contestant::Float => json!("float"),
            Contestant::Fixed { level, shadows } => {
                json!({ "fixed": { "quality": level.json(), "shadows": shadows } })
            }
        };
        json!({
            "contestant": contestant,
            "reflections": self.reflections,
            "scale": self.scale,
        })
    }

    /// In words.
    pub fn words(&self) -> String {
        let mut words = match self.contestant {
            Contestant::Float => format!("N = {}, float", self.reflections),
            Contestant::Fixed { level, .. } => {
                format!("N = {}, {}", self.reflections, level.name())
            }
        };
        if let Contestant::Fixed { shadows: false, .. } = self.contestant {
            words += ", no shadows";
        }
        if self.scale > 1 {
            words += &format!(", {0} x {0} pixels", self.scale);
        }
        words
    }
}

/// Resolutions that are tried.
const SCALES: [u8; 3] = [1, 2, 4];

/// All that is tried in fixed point with these numbers of reflections.
pub fn fixed(numbers: &[u8]) -> Vec<Setting> {
    let most = numbers.last().copied().unwrap_or(0);
    let plain = |level| {
        numbers
            .iter()
            .map(move |&number| Setting::fixed(level, number))
    };
    let scaled = |level| {
        let scales = SCALES.into_iter().skip(1);
        scales.flat_map(move |scale| plain(level).map(move |it| Setting { scale, ..it }))
    };
    let dark = |setting: Setting| match setting.contestant {
        Contestant::Fixed { level, .. } => Setting {
            contestant: Contestant::Fixed {
                level,
                shadows: false,
            },
            ..setting
        },
        Contestant::Float => setting,
    };
    let cuts = [Level::Cut4, Level::Cut16, Level::Cut64];
    plain(Level::Fast)
        .chain(plain(Level::Fine))
        .chain(plain(Level::Exact))
        .chain(plain(Level::Rough4))
        .chain(plain(Level::Rough16))
        .chain(cuts.map(|level| Setting::fixed(level, most)))
        .chain(scaled(Level::Fast))
        .chain(scaled(Level::Fine))
        .chain(plain(Level::Fast).map(dark))
        .chain(scaled(Level::Fast).map(dark))
        .collect()
}

/// All that is tried with the float port.
pub fn float(numbers: &[u8]) -> Vec<Setting> {
    let scales = SCALES.into_iter();
    let numbers = |scale| numbers.iter().map(move |&it| Setting::float(it, scale));
    scales.flat_map(numbers).collect()
}

/// The numbers of reflections that are tried up to the last that matters.
pub fn numbers(last: u8) -> Vec<u8> {
    /// From here on every one is not worth the time.
    const DENSE: u8 = 8;
    let steps = [10, 12, 16, 24, 32, 48, 64, 96, 128, 192];
    let some = (0..=DENSE).chain(steps).filter(|number| *number < last);
    some.chain([last]).collect()
}
