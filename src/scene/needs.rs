//! The needs of a scene: the features of the library that it uses, derived from the scene. Code for
//! other features is not linked.

mod bound;
mod finish;
mod words;

pub use bound::{MostReflections, NeedsLimit};
pub use finish::{Mirrors, Shininess};
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
        /// The features of the library that a scene, or any scene of a type, can need.
        ///
        /// For a constant scene ([`scene!`](crate::scene)) they are derived from the scene itself when
        /// the program is compiled ([`Needs::of`]). For a scene filled at run time they are derived from
        /// the room in its type, or given by a [`NeedsLimit`]. Code and tables for other features are
        /// not in the program.
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
        /// assert!(NEEDS.lights && NEEDS.shadows && !NEEDS.mirrored);
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub struct Needs {
            $(
                #[doc = concat!("Whether the scene has ", stringify!($list), ".")]
                pub $list: bool,
            )*
            /// Whether the scene has planes.
            pub planes: bool,
            /// Whether the scene has lights, and shapes that they can light.
            pub lights: bool,
            /// Whether a light is far away in comparison with the scene, or may be.
            pub far_lights: bool,
            /// Whether a light falls off with distance, or may.
            pub ranges: bool,
            /// Whether a shape may cast a shadow, on another shape or on itself.
            pub shadows: bool,
            /// Whether a light may cause a highlight on a surface.
            pub highlights: bool,
            /// Powers that the highlights take: the most general one.
            pub shininess: Shininess,
            /// Surfaces that mirror: none, some or all.
            pub mirrors: Mirrors,
            /// Number of reflections of a path that can add light: 0 without a mirror, 1 if the only
            /// shape is one plane, else 255.
            pub reflections: u8,
            /// Whether a mirror can show a shape or a sky, and not only one colour.
            pub mirrored: bool,
            /// Whether shadow rays choose candidates among the shapes, because testing all takes longer.
            pub sets: bool,
            /// Whether the scene has more than one material.
            pub materials: bool,
            /// Whether a material has a checker, or may have one.
            pub checkers: bool,
            /// Whether the background is a sky, or may be.
            pub sky: bool,
            /// Whether the scene has colours; a scene in grey computes one channel.
            pub colors: bool,
        }

        impl Needs {
            /// Needs with every feature.
            pub const ALL: Self = Self {
                $($list: true,)*
                planes: true,
                lights: true,
                far_lights: true,
                ranges: true,
                shadows: true,
                highlights: true,
                shininess: Shininess::Real,
                mirrors: Mirrors::Some,
                reflections: u8::MAX,
                mirrored: true,
                sets: true,
                materials: true,
                checkers: true,
                sky: true,
                colors: true,
            };

            /// Returns needs with every feature, but only the kinds of bounded shapes with a count above
            /// 0.
            const fn of_kinds(counts: &Counts) -> Self {
                Self { $($list: counts.$list > 0,)* ..Self::ALL }
            }

            /// Returns needs with every feature, but only the kinds of bounded shapes that both need.
            const fn of_both_kinds(&self, other: &Self) -> Self {
                Self { $($list: self.$list && other.$list,)* ..Self::ALL }
            }

            /// Returns name and level of each need that a limit may lower, the kinds of bounded shapes
            /// first.
            const fn levels(&self) -> [(&'static str, u8); KINDS + 14] {
                [
                    $((stringify!($list), self.$list as u8),)*
                    ("planes", self.planes as u8),
                    ("lights", self.lights as u8),
                    ("far_lights", self.far_lights as u8),
                    ("ranges", self.ranges as u8),
                    ("shadows", self.shadows as u8),
                    ("highlights", self.highlights as u8),
                    ("shininess", self.shininess as u8),
                    // First whether a surface mirrors, then whether a surface has a colour of its own.
                    ("mirrors", !matches!(self.mirrors, Mirrors::None) as u8),
                    ("mirrors", !matches!(self.mirrors, Mirrors::All) as u8),
                    ("mirrored", self.mirrored as u8),
                    ("materials", self.materials as u8),
                    ("checkers", self.checkers as u8),
                    ("sky", self.sky as u8),
                    ("colors", self.colors as u8),
                ]
            }

            /// Tests whether the scene has no shape and no sky, so that all pixels have one colour.
            pub const fn is_nothing(&self) -> bool {
                !(self.planes || self.sky $(|| self.$list)*)
            }

            /// Tests whether the colour of a surface, or a ray that leaves it, can depend on where it is hit.
            pub(crate) const fn places(&self) -> bool {
                self.lights || self.mirrored || self.checkers $(|| self.$list)*
            }

            $(
                #[doc = concat!("Returns these needs without ", stringify!($list), ".")]
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
    /// Returns the needs of a scene with these parts.
    pub(crate) const fn needs(&self) -> Needs {
        let mut finish = Finish::new(&self.background, self.lights);
        let mut number = 0;
        while let Some((_, material)) = self.ball(number) {
            finish.add(self, material);
            number += 1;
        }
        let mut index = 0;
        while index < self.planes.len() {
            finish.add(self, self.planes[index].material);
            index += 1;
        }
        Needs::of_room(&self.counts()).of_finish(&finish)
    }
}

/// Largest number of bounded shapes for which testing all takes less time than choosing candidates.
pub(crate) const FEW: usize = 3;

impl Needs {
    /// Returns the needs of any scene with no more parts than these counts.
    pub(crate) const fn of_room(counts: &Counts) -> Self {
        let (bounded, planes) = (counts.bounded(), counts.planes);
        let is_lit = counts.lights > 0 && bounded + planes > 0;
        Self {
            planes: planes > 0,
            lights: is_lit,
            far_lights: is_lit,
            ranges: is_lit,
            // No ray crosses a plane, so a single plane hides no light from a visible surface that faces
            // it.
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
            mirrored: bounded + planes > 0,
            sets: is_lit && bounded > FEW,
            materials: counts.materials > 1,
            checkers: bounded + planes > 0,
            ..Self::of_kinds(counts)
        }
    }

    /// Returns these needs, lowered to what the materials and lights of a scene use.
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
            far_lights: self.lights && finish.is_far,
            ranges: self.lights && finish.has_ranges,
            highlights: !matches!(shininess, Shininess::None),
            shininess,
            mirrors,
            reflections: match mirrors {
                Mirrors::None => 0,
                _ => self.reflections,
            },
            // A single plane shows only the background. A sky depends on the ray, a colour does not.
            mirrored: self.mirrored
                && !matches!(mirrors, Mirrors::None)
                && (self.reflections > 1 || finish.has_sky),
            checkers: finish.has_checkers,
            sky: finish.has_sky,
            colors: !(finish.is_grey && (finish.is_lit_grey || !self.lights)),
            ..self
        }
    }

    /// Returns these needs for a scene whose shadow rays test all shapes.
    pub(crate) const fn without_sets(mut self) -> Self {
        self.sets = false;
        self
    }

    /// Returns the features that both need.
    #[must_use]
    pub const fn both(&self, other: &Self) -> Self {
        Self {
            planes: self.planes && other.planes,
            lights: self.lights && other.lights,
            far_lights: self.far_lights && other.far_lights,
            ranges: self.ranges && other.ranges,
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
            checkers: self.checkers && other.checkers,
            sky: self.sky && other.sky,
            colors: self.colors && other.colors,
            ..self.of_both_kinds(other)
        }
    }
}

#[cfg(test)]
mod tests;
