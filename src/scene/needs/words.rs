//! What a scene needs, in words.

use super::{Mirrors, Needs, Shininess};

/// One thing that a scene may need, in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Need {
    /// The name of the field of [`Needs`].
    pub name: &'static str,
    /// Whether it is in the program.
    pub is_needed: bool,
    /// Why it is, or why not.
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

impl Needs {
    /// Each need in words.
    pub const fn list(&self) -> [Need; 14] {
        let reflections = match self.reflections {
            0 if matches!(self.mirrors, Mirrors::None) => "nothing mirrors",
            0 => "none is followed",
            1 => "one",
            _ => "as many as the frame allows",
        };
        let shininess = match self.shininess {
            Shininess::None => "there is no highlight",
            Shininess::Even => "even whole numbers: by squaring, without a root or a logarithm",
            Shininess::Whole => "whole numbers: by squaring, without a logarithm",
            Shininess::Real => "real numbers: by squaring and a logarithm",
        };
        let mirrors = match self.mirrors {
            Mirrors::None => "no mirror is above 0: a path ends at the first surface",
            Mirrors::Some => "a mirror is above 0",
            Mirrors::All => "every mirror is 1: no surface has a colour of its own",
        };
        [
            Need::either(
                "spheres",
                self.spheres,
                ["there are some", "there are none"],
            ),
            Need::either("planes", self.planes, ["there are some", "there are none"]),
            Need::either(
                "cylinders",
                self.cylinders,
                ["there are some", "there are none"],
            ),
            Need::either(
                "lights",
                self.lights,
                ["there are some", "nothing is lit: ambient light only"],
            ),
            Need::either(
                "shadows",
                self.shadows,
                [
                    "a shape may hide a light",
                    "no light is hidden from what can be seen lit",
                ],
            ),
            Need::either(
                "highlights",
                self.highlights,
                [
                    "a specular coefficient is above 0",
                    "no light shines on a specular surface",
                ],
            ),
            Need::new(
                "shininess",
                !matches!(self.shininess, Shininess::None),
                shininess,
            ),
            Need::new("mirrors", !matches!(self.mirrors, Mirrors::None), mirrors),
            Need::new("reflections", self.reflections > 0, reflections),
            Need::either(
                "mirrored",
                self.mirrored,
                [
                    "a mirror may show a shape",
                    "no mirror shows more than the background",
                ],
            ),
            Need::either(
                "places",
                self.places,
                [
                    "light or mirrors depend on where a ray meets a shape",
                    "a shape has one colour, wherever a ray meets it",
                ],
            ),
            Need::either(
                "sets",
                self.sets,
                [
                    "choosing among the shapes that may throw a shadow saves time",
                    "so few shapes may throw a shadow that all are asked",
                ],
            ),
            Need::either(
                "materials",
                self.materials,
                [
                    "there are several",
                    "there is one at most: its numbers are constants",
                ],
            ),
            Need::either(
                "colors",
                self.colors,
                [
                    "something is not grey",
                    "all is grey: one channel is worked out",
                ],
            ),
        ]
    }
}
