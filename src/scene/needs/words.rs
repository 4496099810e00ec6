//! The needs of a scene in English words, with the reasons.

use super::{KINDS, Mirrors, Needs, Shininess};

/// One feature that a scene may need, described in words. [`Needs::list`] returns them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Need {
    /// Name of the field of [`Needs`], such as `"mirrors"`.
    pub name: &'static str,
    /// Whether the code for this feature is in the program.
    pub is_needed: bool,
    /// Reason why the feature is needed, or why it is not.
    pub why: &'static str,
}

impl Need {
    const fn new(name: &'static str, is_needed: bool, why: &'static str) -> Self {
        Self {
            name,
            is_needed,
            why,
        }
    }

    const fn either(name: &'static str, is_needed: bool, [yes, no]: [&'static str; 2]) -> Self {
        Self::new(name, is_needed, if is_needed { yes } else { no })
    }
}

/// Two reasons: the first if a feature is needed, the second if it is not.
type Reasons = [&'static str; 2];

const SHAPES: Reasons = ["there are some", "there are none"];
const LIGHTS: Reasons = ["there are some", "nothing is lit: ambient light only"];
const FAR_LIGHTS: Reasons = [
    "a light may be far away in comparison with the scene",
    "every light is near",
];
const RANGES: Reasons = [
    "a light falls off with distance, or may",
    "no light falls off with distance",
];
const SHADOWS: Reasons = [
    "a shape may hide a light",
    "no light is hidden from what can be seen lit",
];
const HIGHLIGHTS: Reasons = [
    "a specular coefficient is above 0",
    "no light shines on a specular surface",
];
const MIRRORED: Reasons = [
    "a mirror may show a shape or a sky",
    "no mirror shows more than one colour",
];
const SETS: Reasons = [
    "choosing among the shapes that may throw a shadow saves time",
    "so few shapes may throw a shadow that all are asked",
];
const MATERIALS: Reasons = [
    "there are several",
    "there is one at most: its numbers are constants",
];
const CHECKERS: Reasons = [
    "a material has a checker, or may have one",
    "no material has one",
];
const SKY: Reasons = ["the background is a sky, or may be", "it has one colour"];
const COLORS: Reasons = [
    "something is not grey",
    "all is grey: one channel is worked out",
];

/// Number of needs in the list that are not kinds of bounded shapes.
const OTHERS: usize = 15;

macro_rules! list {
    ($header:tt $({ $list:ident $($more:tt)* })*) => {
        impl Needs {
            /// Returns every need in words, the kinds of bounded shapes first.
            pub const fn list(&self) -> [Need; KINDS + OTHERS] {
                let has_shininess = !matches!(self.shininess, Shininess::None);
                let has_mirrors = !matches!(self.mirrors, Mirrors::None);
                let reflections = match self.reflections {
                    0 if !has_mirrors => "nothing mirrors",
                    0 => "none is followed",
                    1 => "one",
                    _ => "as many as the frame allows",
                };
                [
                    $(Need::either(stringify!($list), self.$list, SHAPES),)*
                    Need::either("planes", self.planes, SHAPES),
                    Need::either("lights", self.lights, LIGHTS),
                    Need::either("far_lights", self.far_lights, FAR_LIGHTS),
                    Need::either("ranges", self.ranges, RANGES),
                    Need::either("shadows", self.shadows, SHADOWS),
                    Need::either("highlights", self.highlights, HIGHLIGHTS),
                    Need::new("shininess", has_shininess, self.shininess.words()),
                    Need::new("mirrors", has_mirrors, self.mirrors.words()),
                    Need::new("reflections", self.reflections > 0, reflections),
                    Need::either("mirrored", self.mirrored, MIRRORED),
                    Need::either("sets", self.sets, SETS),
                    Need::either("materials", self.materials, MATERIALS),
                    Need::either("checkers", self.checkers, CHECKERS),
                    Need::either("sky", self.sky, SKY),
                    Need::either("colors", self.colors, COLORS),
                ]
            }
        }
    };
}
kinds!(list);

impl Shininess {
    const fn words(self) -> &'static str {
        match self {
            Self::None => "there is no highlight",
            Self::Even => "even whole numbers: by squaring, without a root or a logarithm",
            Self::Whole => "whole numbers: by squaring, without a logarithm",
            Self::Real => "real numbers: by squaring and a logarithm",
        }
    }
}

impl Mirrors {
    const fn words(self) -> &'static str {
        match self {
            Self::None => "no mirror is above 0: a path ends at the first surface",
            Self::Some => "a mirror is above 0",
            Self::All => "every mirror is 1: no surface has a colour of its own",
        }
    }
}
