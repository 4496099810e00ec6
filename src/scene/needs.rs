//! What a scene needs of the kernels, derived from the scene: what is not needed is not linked.

mod bound;
mod finish;
mod words;

pub use bound::{MostReflections, NeedsLimit};
pub use words::Need;

use finish::Finish;

use super::access::{KINDS, Parts};
use super::capacity::Counts;

macro_rules! needs {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident $($more:tt)* })*
    ) => {
        /// What a scene, or any scene of a type, can need of the library.
        ///
        /// For a constant scene ([`scene!`](crate::scene)) it is derived from the scene itself when the program is compiled
        /// ([`Needs::of`]); for a scene filled at run time from the room in its type, or from a [`NeedsLimit`].
        /// The code and the tables for what is not needed are not in the program.
        ///
        /// ```
        /// use reflet::needs::{Mirrors, Needs};
        /// use reflet::{Material, scene};
        ///
        /// scene! {
        ///     struct Marble {
        ///         sphere([0.0, 0.0, 1.0], 1.0, Material::new([0.9, 0.1, 0.1]));
        ///         light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
        ///     }
        /// }
        /// const NEEDS: Needs = Needs::of::<Marble>();
        /// assert!(NEEDS.spheres && !NEEDS.planes && NEEDS.mirrors == Mirrors::None);
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub struct Needs {
            $(
                #[doc = concat!("Whether there are ", stringify!($list), ".")]
                pub $list: bool,
            )*
            /// Whether there are planes.
            pub planes: bool,
            /// Whether there are lights, and anything to be lit.
            pub lights: bool,
            /// Whether a shape may throw a shadow, on another or on itself.
            pub shadows: bool,
            /// Whether a light may be seen as a highlight.
            pub highlights: bool,
            /// Which powers the highlights take.
            pub shininess: Shininess,
            /// Which surfaces mirror.
            pub mirrors: Mirrors,
            /// The last reflection that can add light: none without a mirror, one where a single plane is all
            /// there is, else as many as a frame allows.
            pub reflections: u8,
            /// Whether a mirror can show more than the background.
            pub mirrored: bool,
            /// Whether it takes less time to choose among the shapes that may throw a shadow than to ask all.
            pub sets: bool,
            /// Whether there is more than one material.
            pub materials: bool,
            /// Whether anything is not grey.
            pub colors: bool,
        }

        impl Needs {
            /// Everything.
            pub const ALL: Self = Self {
                $($list: true,)*
                planes: true,
                lights: true,
                shadows: true,
                highlights: true,
                shininess: Shininess::Real,
                mirrors: Mirrors::Some,
                reflections: u8::MAX,
                mirrored: true,
                sets: true,
                materials: true,
                colors: true,
            };

            /// Everything, of the kinds of bounded shapes that are counted.
            const fn of_kinds(counts: &Counts) -> Self {
                Self { $($list: counts.$list > 0,)* ..Self::ALL }
            }

            /// Everything, of the kinds of bounded shapes that both need.
            const fn of_both_kinds(&self, other: &Self) -> Self {
                Self { $($list: self.$list && other.$list,)* ..Self::ALL }
            }

            /// How much is needed of what a bound may leave out, the kinds of bounded shapes first.
            const fn levels(&self) -> [(&'static str, u8); KINDS + 10] {
                [
                    $((stringify!($list), self.$list as u8),)*
                    ("planes", self.planes as u8),
                    ("lights", self.lights as u8),
                    ("shadows", self.shadows as u8),
                    ("highlights", self.highlights as u8),
                    ("shininess", self.shininess as u8),
                    // Whether a surface mirrors, and whether one does not mirror all.
                    ("mirrors", !matches!(self.mirrors, Mirrors::None) as u8),
                    ("mirrors", !matches!(self.mirrors, Mirrors::All) as u8),
                    ("mirrored", self.mirrored as u8),
                    ("materials", self.materials as u8),
                    ("colors", self.colors as u8),
                ]
            }

            /// Whether there is no shape.
            pub const fn is_nothing(&self) -> bool {
                !(self.planes $(|| self.$list)*)
            }

            $(
                #[doc = concat!("The same without ", stringify!($list), ".")]
                #[must_use]
                pub const fn $without(self) -> Self {
                    Self { $list: false, ..self }
                }
            )*
        }

    };
}
kinds!(needs);

impl Parts<'_> {
    /// What a scene of these parts needs.
    pub(crate) const fn needs(&self) -> Needs {
        let mut finish = Finish::new(self.background, self.lights);
        let mut number = 0;
        while let Some((_, material)) = self.ball(number) {
            finish.add(self.materials, material);
            number += 1;
        }
        let mut index = 0;
        while index < self.planes.len() {
            finish.add(self.materials, self.planes[index].material);
            index += 1;
        }
        Needs::of_room(&self.counts()).of_finish(&finish)
    }
}

/// Which powers the highlights of a scene take, each kind with those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shininess {
    /// None: there is no highlight.
    None,
    /// Even whole numbers: with Blinn-Phong no root is taken.
    Even,
    /// Whole numbers: no logarithm is needed.
    Whole,
    /// Any.
    Real,
}

/// Which surfaces of a scene mirror.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mirrors {
    /// None: a path ends at the first surface.
    None,
    /// Some, or some of the light.
    Some,
    /// All, and all of the light: no surface has a colour of its own.
    All,
}

/// As many spheres and cylinders as are asked in less time than it takes to choose among them.
pub(crate) const FEW: usize = 3;

impl Needs {
    /// Of any scene with no more parts than these.
    pub(crate) const fn of_room(counts: &Counts) -> Self {
        let (bounded, planes) = (counts.bounded(), counts.planes);
        let is_lit = counts.lights > 0 && bounded + planes > 0;
        Self {
            planes: planes > 0,
            lights: is_lit,
            // No ray crosses a plane, so one by itself hides nothing that could be seen lit.
            shadows: is_lit && (bounded > 0 || planes > 1),
            highlights: is_lit,
            shininess: match is_lit {
                true => Shininess::Real,
                false => Shininess::None,
            },
            mirrors: match bounded + planes {
                0 => Mirrors::None,
                _ => Mirrors::Some,
            },
            reflections: match (bounded, planes) {
                (0, 0) => 0,
                (0, 1) => 1,
                _ => u8::MAX,
            },
            mirrored: bounded > 0 || planes > 1,
            sets: is_lit && bounded > FEW,
            materials: counts.materials > 1,
            ..Self::of_kinds(counts)
        }
    }

    /// What a scene needs that has no more room, nor more in its materials and lights.
    const fn of_finish(self, finish: &Finish) -> Self {
        let mirrors = match finish.mirrors {
            [false, _] => Mirrors::None,
            [true, true] => Mirrors::Some,
            [true, false] => Mirrors::All,
        };
        let shininess = match self.lights {
            true => finish.shininess,
            false => Shininess::None,
        };
        Self {
            highlights: !matches!(shininess, Shininess::None),
            shininess,
            mirrors,
            reflections: match mirrors {
                Mirrors::None => 0,
                _ => self.reflections,
            },
            mirrored: self.mirrored && !matches!(mirrors, Mirrors::None),
            colors: !(finish.is_grey && (finish.is_lit_grey || !self.lights)),
            ..self
        }
    }

    /// The same where all shapes are asked.
    pub(crate) const fn without_sets(self) -> Self {
        Self {
            sets: false,
            ..self
        }
    }

    /// What both need.
    #[must_use]
    pub const fn both(&self, other: &Self) -> Self {
        Self {
            planes: self.planes && other.planes,
            lights: self.lights && other.lights,
            shadows: self.shadows && other.shadows,
            highlights: self.highlights && other.highlights,
            shininess: match (self.shininess as u8) < other.shininess as u8 {
                true => self.shininess,
                false => other.shininess,
            },
            mirrors: match (self.mirrors, other.mirrors) {
                (Mirrors::Some, mirrors) | (mirrors, Mirrors::Some) => mirrors,
                (Mirrors::All, Mirrors::All) => Mirrors::All,
                _ => Mirrors::None,
            },
            reflections: match self.reflections < other.reflections {
                true => self.reflections,
                false => other.reflections,
            },
            mirrored: self.mirrored
                && other.mirrored
                && self.reflections > 0
                && other.reflections > 0,
            sets: self.sets && other.sets,
            materials: self.materials && other.materials,
            colors: self.colors && other.colors,
            ..self.of_both_kinds(other)
        }
    }
}

#[cfg(test)]
mod tests;
