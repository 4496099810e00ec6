//! The needs of a scene: the features of the library that it uses, derived from the scene. Code for
//! other features is not linked.

mod bound;
mod finish;
mod words;

pub use bound::{MostReflections, NeedsLimit};
pub use finish::{Mirrors, Shininess};
pub use words::Need;

use super::access::{KINDS, Parts};
use super::capacity::Counts;

macro_rules! needs {
    (
        {
            { $($(#[$about:meta])* $first:ident [$($why:literal),*];)* }
            { $($(#[$note:meta])* $last:ident [$($reason:literal),*];)* }
        }
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
            $($(#[$about])* pub $first: bool,)*
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
            $($(#[$note])* pub $last: bool,)*
        }

        impl Needs {
            /// Needs with every feature.
            pub const ALL: Self = Self {
                $($list: true,)*
                $($first: true,)*
                shininess: Shininess::Real,
                mirrors: Mirrors::Some,
                reflections: u8::MAX,
                mirrored: true,
                sets: true,
                $($last: true,)*
            };

            /// Returns needs with every feature, but only the kinds of bounded shapes with a count above
            /// 0.
            const fn of_kinds(counts: &Counts) -> Self {
                Self { $($list: counts.$list > 0,)* ..Self::ALL }
            }

            /// Returns the features that both need.
            #[must_use]
            pub const fn both(&self, other: &Self) -> Self {
                Self {
                    $($list: self.$list && other.$list,)*
                    $($first: self.$first && other.$first,)*
                    shininess: self.shininess.less(other.shininess),
                    mirrors: self.mirrors.common(other.mirrors),
                    reflections: if self.reflections < other.reflections {
                        self.reflections
                    } else {
                        other.reflections
                    },
                    mirrored: self.mirrored
                        && other.mirrored
                        && self.reflections > 0
                        && other.reflections > 0,
                    sets: self.sets && other.sets,
                    $($last: self.$last && other.$last,)*
                }
            }

            /// Returns name and level of each need that a limit may lower, the kinds of bounded shapes
            /// first.
            const fn levels(&self) -> [(&'static str, u8); KINDS + 17] {
                [
                    $((stringify!($list), self.$list as u8),)*
                    $((stringify!($first), self.$first as u8),)*
                    ("shininess", self.shininess as u8),
                    // First whether a surface mirrors, then whether a surface has a colour of its own.
                    ("mirrors", !matches!(self.mirrors, Mirrors::None) as u8),
                    ("mirrors", !matches!(self.mirrors, Mirrors::All) as u8),
                    ("mirrored", self.mirrored as u8),
                    $((stringify!($last), self.$last as u8),)*
                ]
            }

            /// Returns every need in words, the kinds of bounded shapes first.
            pub const fn list(&self) -> [Need; KINDS + 18] {
                [
                    $(Need::either(stringify!($list), self.$list, words::SHAPES),)*
                    $(Need::either(stringify!($first), self.$first, [$($why),*]),)*
                    Need::of_shininess(self.shininess),
                    Need::of_mirrors(self.mirrors),
                    Need::of_reflections(self.reflections, self.mirrors),
                    Need::either("mirrored", self.mirrored, words::MIRRORED),
                    Need::either("sets", self.sets, words::SETS),
                    $(Need::either(stringify!($last), self.$last, [$($reason),*]),)*
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
// The needs that a scene either has or not, each with the reason why it has it and why not.
kinds!(needs, {
    {
        /// Whether the scene has planes.
        planes ["there are some", "there are none"];
        /// Whether the scene has lights, and shapes that they can light.
        lights ["there are some", "nothing is lit: ambient light only"];
        /// Whether a light is near in comparison with the scene, or may be.
        near_lights ["a light may be near", "every light is far away, such as a sun"];
        /// Whether a light is far away in comparison with the scene, or may be.
        far_lights ["a light may be far away in comparison with the scene", "every light is near"];
        /// Whether a light falls off with distance, or may.
        ranges ["a light falls off with distance, or may", "no light falls off with distance"];
        /// Whether a shape may cast a shadow, on another shape or on itself.
        shadows ["a shape may hide a light", "no light is hidden from what can be seen lit"];
        /// Whether a light may cause a highlight on a surface.
        highlights ["a specular coefficient is above 0", "no light shines on a specular surface"];
    }
    {
        /// Whether a plane is a mirror, or may be.
        plane_mirrors ["a plane may be a mirror", "no plane is a mirror"];
        /// Whether two planes may mirror a ray, one after the other.
        facing_mirrors ["two planes may be mirrors", "at most one plane is a mirror"];
        /// Whether the scene has more than one material.
        materials ["there are several", "there is one at most: its numbers are constants"];
        /// Whether a material has a checker, or may have one.
        checkers ["a material has a checker, or may have one", "no material has one"];
        /// Whether the background is a sky, or may be.
        sky ["the background is a sky, or may be", "it has one colour"];
        /// Whether the scene has colours; a scene in grey computes one channel.
        colors ["something is not grey", "all is grey: one channel is worked out"];
    }
});

/// Largest number of bounded shapes for which testing all takes less time than choosing candidates.
pub(crate) const FEW: usize = 3;

impl Needs {
    /// Returns the needs of any scene with no more parts than these counts.
    pub(crate) const fn of_room(counts: &Counts) -> Self {
        let (bounded, planes) = (counts.bounded(), counts.planes);
        let is_lit = counts.lights > 0 && bounded + planes > 0;
        Self {
            planes: planes > 0,
            plane_mirrors: planes > 0,
            facing_mirrors: planes > 1,
            lights: is_lit,
            near_lights: is_lit,
            far_lights: is_lit,
            ranges: is_lit,
            // No ray crosses a plane, so a single plane hides no light from a visible surface that faces
            // it.
            shadows: is_lit && (bounded > 0 || planes > 1),
            highlights: is_lit,
            shininess: if is_lit { Shininess::Real } else { Shininess::None },
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

    /// Returns these needs for a scene whose shadow rays test all shapes.
    pub(crate) const fn without_sets(mut self) -> Self {
        self.sets = false;
        self
    }
}

#[cfg(test)]
mod tests;
