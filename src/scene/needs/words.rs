//! The needs of a scene in English words, with the reasons.

use super::{Mirrors, Shininess};

/// One feature that a scene may need, described in words. [`Needs::list`](super::Needs::list) returns them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Need {
    /// Name of the field of [`Needs`](super::Needs), such as `"mirrors"`.
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

    pub(super) const fn either(name: &'static str, is_needed: bool, [yes, no]: Reasons) -> Self {
        Self::new(name, is_needed, if is_needed { yes } else { no })
    }

    pub(super) const fn of_shininess(shininess: Shininess) -> Self {
        let why = match shininess {
            Shininess::None => "there is no highlight",
            Shininess::Even => "even whole numbers: by squaring, without a root or a logarithm",
            Shininess::Whole => "whole numbers: by squaring, without a logarithm",
            Shininess::Real => "real numbers: by squaring and a logarithm",
        };
        Self::new("shininess", !matches!(shininess, Shininess::None), why)
    }

    pub(super) const fn of_mirrors(mirrors: Mirrors) -> Self {
        let why = match mirrors {
            Mirrors::None => "no mirror is above 0: a path ends at the first surface",
            Mirrors::Some => "a mirror is above 0",
            Mirrors::All => "every mirror is 1: no surface has a colour of its own",
        };
        Self::new("mirrors", !matches!(mirrors, Mirrors::None), why)
    }

    pub(super) const fn of_reflections(reflections: u8, mirrors: Mirrors) -> Self {
        let why = match (reflections, mirrors) {
            (0, Mirrors::None) => "nothing mirrors",
            (0, _) => "none is followed",
            (1, _) => "one",
            _ => "as many as the frame allows",
        };
        Self::new("reflections", reflections > 0, why)
    }
}

/// Two reasons: the first if a feature is needed, the second if it is not.
type Reasons = [&'static str; 2];

pub(super) const SHAPES: Reasons = ["there are some", "there are none"];
pub(super) const MIRRORED: Reasons = [
    "a mirror may show a shape or a sky",
    "no mirror shows more than one colour",
];
pub(super) const SETS: Reasons = [
    "choosing among the shapes that may throw a shadow saves time",
    "so few shapes may throw a shadow that all are asked",
];
