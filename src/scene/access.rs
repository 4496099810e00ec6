//! What the kernels read of a scene, wherever it lives, and how they name its shapes.

use super::capacity::{Capacity, Counts, Room};
use super::needs::Needs;
use super::prepare::PlainScene;
use super::shape_set::ShapeSet;
use super::used;
use crate::color::Color;
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Length, Unit, to_u32, unit_product};
use crate::ray::spread;
use crate::shape::MaterialId;
use crate::shape::bounded::Bounded;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point};

macro_rules! parts {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $($more:tt)* })*
    ) => {
        /// How many kinds of bounded shapes there are.
        pub(crate) const KINDS: usize = [$(stringify!($list)),*].len();

        /// What the kernels read from a scene.
        #[derive(Clone, Copy, Debug)]
        pub struct Parts<'a> {
            $(pub(crate) $list: &'a [crate::shape::$prepared],)*
            pub(crate) planes: &'a [PreparedPlane],
            pub(crate) lights: &'a [PreparedLight],
            pub(crate) materials: &'a [PreparedMaterial],
            pub(crate) background: Color,
            /// The largest component of any colour that a path can meet, [`Color::in_levels`]; rounded up.
            pub(crate) brightest: Brightness,
            /// One over the brightest, rounded down to 8 leading bits, and at most 1.
            pub(crate) dimness: Unit,
            /// Offset along the normal where rays that leave a surface start: at least 2 steps.
            pub(crate) epsilon: Length,
            /// The same inside of a bounded shape: at least 8 steps, or 16 in a scene with cylinders.
            pub(crate) inner_epsilon: Length,
            pub(crate) grid: &'a Grid,
            /// The shapes that move: no table may leave them out.
            pub(crate) moving: ShapeSet,
        }

        impl<'a> Parts<'a> {
            /// How many shapes of each bounded kind there are, in the order of the kinds.
            #[inline(always)]
            pub(crate) const fn lengths(&self) -> [usize; KINDS] {
                [$(self.$list.len()),*]
            }

            pub(crate) const fn counts(&self) -> Counts {
                Counts {
                    $($list: self.$list.len(),)*
                    planes: self.planes.len(),
                    lights: self.lights.len(),
                    materials: self.materials.len(),
                }
            }

            /// How many bounded shapes there are.
            #[inline(always)]
            pub(crate) const fn bounded(&self) -> usize {
                0 $(+ self.$list.len())*
            }

            /// Whether there are bounded shapes.
            #[inline(always)]
            pub(crate) fn has_bounded(&self) -> bool {
                $(!self.$list.is_empty())||*
            }

            /// The ball around the bounded shape with a number, and its material, if there is one.
            pub(crate) const fn ball(&self, number: usize) -> Option<((Point, i32), MaterialId)> {
                $(
                    if number < self.$list.len() {
                        let shape = &self.$list[number];
                        return Some((shape.ball(), shape.material));
                    }
                    let number = number - self.$list.len();
                )*
                let _ = number;
                None
            }

            /// The outward normal of a shape at a near point of it, and its material.
            #[inline(always)]
            pub(super) fn outside(&self, shape: ShapeId, at: Point) -> Option<(Direction, MaterialId)> {
                let index = shape.index();
                $(
                    if let Some(shape) = self.$list.get(index) {
                        return Some((shape.normal(at), shape.material()));
                    }
                    let index = index - self.$list.len();
                )*
                let plane = self.planes.get(index)?;
                Some((plane.normal, plane.material))
            }

            /// Whether a shape of the scene is flat, as planes are.
            #[inline(always)]
            pub(crate) fn is_flat(&self, shape: ShapeId) -> bool {
                let index = shape.index();
                let first = 0;
                $(
                    let next = first + self.$list.len();
                    if <crate::shape::$prepared as Bounded>::IS_FLAT && (first..next).contains(&index) {
                        return true;
                    }
                    let first = next;
                )*
                index >= first
            }

            /// Whether a near point lies inside of a shape that rays from there do not leave.
            pub(crate) fn hold(&self, point: Point) -> bool {
                $(self.$list.iter().any(|shape| shape.holds(point)))||*
            }

            /// The same parts without what `needs` leaves out.
            #[inline(always)]
            pub(crate) const fn within(self, needs: &Needs) -> Self {
                Self {
                    $($list: if_needed(needs.$list, self.$list),)*
                    planes: if_needed(needs.planes, self.planes),
                    lights: if_needed(needs.lights, self.lights),
                    ..self
                }
            }
        }

        impl<$($header)*> PlainScene<Room<$($arguments)*>> {
            /// Its parts, for constants.
            pub(crate) const fn constant_parts(&self) -> Parts<'_> {
                Parts {
                    $($list: used(&self.$list, self.counts.$list),)*
                    planes: used(&self.planes, self.counts.planes),
                    lights: used(&self.lights, self.counts.lights),
                    materials: used(&self.materials, self.counts.materials),
                    ..self.values()
                }
            }
        }

        impl<R: Capacity> PlainScene<R> {
            /// Its parts.
            #[inline(always)]
            pub(crate) fn parts(&self) -> Parts<'_> {
                Parts {
                    $($list: used(self.$list.as_ref(), self.counts.$list),)*
                    planes: used(self.planes.as_ref(), self.counts.planes),
                    lights: used(self.lights.as_ref(), self.counts.lights),
                    materials: used(self.materials.as_ref(), self.counts.materials),
                    ..self.values()
                }
            }

            /// What is no list.
            #[inline(always)]
            pub(crate) const fn values(&self) -> Parts<'_> {
                Parts {
                    $($list: &[],)*
                    planes: &[],
                    lights: &[],
                    materials: &[],
                    background: self.background,
                    brightest: self.brightest,
                    dimness: self.dimness,
                    epsilon: self.epsilon,
                    inner_epsilon: self.inner_epsilon,
                    grid: &self.grid,
                    moving: self.moving,
                }
            }
        }
    };
}
kinds!(parts);

/// Nothing of what is not needed, and the compiler sees it.
#[inline(always)]
pub(crate) const fn if_needed<T>(is_needed: bool, items: &[T]) -> &[T] {
    if is_needed { items } else { &[] }
}

impl<'a> Parts<'a> {
    /// A material; black if there is none of that number.
    #[inline(always)]
    pub(crate) fn material(&self, material: MaterialId) -> &'a PreparedMaterial {
        const NONE: &PreparedMaterial = &PreparedMaterial::NONE;
        match self.materials {
            // So that the compiler knows which.
            [only] => only,
            several => several.get(material.index()).unwrap_or(NONE),
        }
    }

    /// The smallest weight with which a path can still change a channel by `change`, 0 to 1.
    pub(crate) const fn smallest_weight(&self, change: Unit) -> Unit {
        unit_product(change, self.dimness)
    }

    /// Whether there is nothing to be met.
    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        !self.has_bounded() && self.planes.is_empty()
    }
}

/// A scene that the plain kernels can read.
pub trait SceneAccess {
    /// What it can need: what it does not is not linked.
    const NEEDS: Needs;

    /// Whether rays are given fewer candidates to hit than all shapes.
    const CHOOSES_HITS: bool;

    /// The scene's parts.
    fn parts(&self) -> Parts<'_>;
}

impl<W: SceneAccess> SceneAccess for &W {
    const NEEDS: Needs = W::NEEDS;
    const CHOOSES_HITS: bool = W::CHOOSES_HITS;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        (**self).parts()
    }
}

/// Names a shape of a scene, or none: bounded shapes in the order of their kinds, then planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeId(pub(super) u32);

impl ShapeId {
    /// No shape.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Not known: further away than near rays look.
    pub(crate) const BEYOND: Self = Self(u32::MAX - 1);

    /// Names one side of it.
    pub(crate) const fn side(self, is_inside: bool) -> u32 {
        self.0 << 1 | is_inside as u32
    }

    /// What a path notes that passes it on one side and not on the other; spread, so that several
    /// together are told from others.
    #[inline(always)]
    pub(crate) const fn passed(self) -> u32 {
        spread(self.0 + 1)
    }

    /// Where it stands among all shapes.
    #[inline(always)]
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }

    /// The shape that stands there among all shapes.
    #[inline(always)]
    pub(crate) const fn at(index: usize) -> Self {
        Self(to_u32(index))
    }
}

impl Parts<'_> {
    /// The number that the planes begin with.
    #[inline(always)]
    pub(super) fn first_plane(&self) -> u32 {
        to_u32(self.bounded())
    }

    /// Whether a shape is a plane.
    #[inline(always)]
    pub(crate) fn is_plane(&self, shape: ShapeId) -> bool {
        shape != ShapeId::NONE && shape.0 >= self.first_plane()
    }
}

impl<'a> Parts<'a> {
    /// The plane with a number, if it is one.
    #[inline(always)]
    pub(crate) fn plane(&self, shape: ShapeId) -> Option<&'a PreparedPlane> {
        self.planes.get(self.plane_index(shape)?)
    }

    /// Where a plane stands among the planes.
    #[inline(always)]
    pub(crate) fn plane_index(&self, shape: ShapeId) -> Option<usize> {
        shape
            .0
            .checked_sub(self.first_plane())
            .map(|it| it as usize)
    }
}
