//! The parts of a scene as the kernels read them, and the numbers by which they name its shapes.

use super::capacity::{Capacity, Counts, Room};
use super::needs::Needs;
use super::prepare::PlainScene;
use super::shape_set::ShapeSet;
use super::used;
use crate::background::PreparedBackground;
use crate::checker::PreparedChecker;
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Length, Unit, to_u32, unit_product};
use crate::shape::MaterialId;
use crate::shape::bounded::Bounded;
use crate::shape::plane::PreparedPlane;
use crate::vector::Point;

macro_rules! declare_of_kind {
    ($d:tt $header:tt $({ $list:ident $($more:tt)* })*) => {
        /// Asks a bounded shape of any kind. `of_kind!(parts, id, |shape| answer)` is the answer of the
        /// shape with this number, or `None` if it is not bounded. A macro, because no closure takes shapes of all kinds.
        macro_rules! of_kind {
            ($d parts:expr, $d id:expr, |$d shape:ident| $d answer:expr) => {
                'asked: {
                    let index = $d id.index();
                    $(
                        if let Some($d shape) = $d parts.$list.get(index) {
                            break 'asked Some($d answer);
                        }
                        let index = index - $d parts.$list.len();
                    )*
                    let _ = index;
                    None
                }
            };
        }
    };
}
kinds!(declare_of_kind, $);

macro_rules! parts {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $($more:tt)* })*
    ) => {
        /// Names of the kinds of bounded shapes, in their order.
        pub(crate) const KIND_NAMES: &[&str] = &[$(stringify!($kind)),*];

        /// Number of kinds of bounded shapes.
        pub(crate) const KINDS: usize = KIND_NAMES.len();

        /// The prepared lists and settings of a scene, as the kernels read them.
        #[derive(Clone, Copy, Debug)]
        pub struct Parts<'a> {
            $(pub(crate) $list: &'a [crate::shape::$prepared],)*
            pub(crate) planes: &'a [PreparedPlane],
            pub(crate) lights: &'a [PreparedLight],
            pub(crate) materials: &'a [PreparedMaterial],
            /// One for each material, whether it has a checker or not.
            pub(crate) checkers: &'a [PreparedChecker],
            pub(crate) background: PreparedBackground,
            /// Largest component of any colour that a path can add, [`Color::in_levels`]; rounded up.
            pub(crate) brightest: Brightness,
            /// Reciprocal of `brightest`, rounded down to 8 leading bits, and at most 1.
            pub(crate) dimness: Unit,
            /// Offset along the normal at which rays that leave a surface start: at least 2 steps.
            pub(crate) epsilon: Length,
            /// Offset of rays that leave a bounded shape's inside: at least 8 steps, 16 with cylinders.
            pub(crate) inner_epsilon: Length,
            pub(crate) grid: &'a Grid,
            /// Set of the shapes that move. Every table must list them for all directions.
            pub(crate) moving: ShapeSet,
        }

        impl<'a> Parts<'a> {
            /// Returns the number of shapes of each bounded kind, in the order of the kinds.
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

            /// Returns the number of bounded shapes of all kinds.
            #[inline(always)]
            pub(crate) const fn bounded(&self) -> usize {
                0 $(+ self.$list.len())*
            }

            /// Tests whether the scene has a bounded shape.
            #[inline(always)]
            pub(crate) fn has_bounded(&self) -> bool {
                $(!self.$list.is_empty())||*
            }

            /// Returns the ball around the bounded shape with this number, and its material.
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

            /// Returns a ball around a part of a shape, and the shape's number. `number` counts the balls of all shapes.
            pub(crate) const fn link(&self, number: usize) -> Option<((Point, i32), usize)> {
                let [$($list),*] = self.kinds();
                $(
                    let links = crate::shape::$prepared::LINKS;
                    if number < links * self.$list.len() {
                        let ball = self.$list[number / links].link(number % links);
                        return Some((ball, $list.id(number / links).index()));
                    }
                    let number = number - links * self.$list.len();
                )*
                let _ = number;
                None
            }

            /// Tests whether a near point lies inside of a closed shape, such as a sphere.
            pub(crate) fn hold(&self, point: Point) -> bool {
                $(self.$list.iter().any(|shape| shape.holds(point)))||*
            }

            /// Returns the parts with an empty list in place of each list that `needs` leaves out.
            #[inline(always)]
            pub(crate) const fn within(self, needs: &Needs) -> Self {
                Self {
                    $($list: if_needed(needs.$list, self.$list),)*
                    planes: if_needed(needs.planes, self.planes),
                    lights: if_needed(needs.lights || needs.sky, self.lights),
                    ..self
                }
            }
        }

        impl<$($header)*> PlainScene<Room<$($arguments)*>> {
            /// Returns the parts of the scene, in constant code.
            #[inline(always)]
            pub(crate) const fn constant_parts(&self) -> Parts<'_> {
                Parts {
                    $($list: used(&self.$list, self.counts.$list),)*
                    planes: used(&self.planes, self.counts.planes),
                    lights: used(&self.lights, self.counts.lights),
                    materials: used(&self.materials, self.counts.materials),
                    checkers: used(&self.checkers, self.counts.materials),
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

impl<R: Capacity> PlainScene<R> {
    /// Returns the parts of the scene.
    #[inline(always)]
    pub(crate) fn parts(&self) -> Parts<'_> {
        R::parts(self)
    }
}

/// Returns `items` if `is_needed`, else an empty list, so that code for unneeded items is dropped.
#[inline(always)]
pub(crate) const fn if_needed<T>(is_needed: bool, items: &[T]) -> &[T] {
    if is_needed { items } else { &[] }
}

impl<'a> Parts<'a> {
    /// Returns the material with this number, or a black one if there is none.
    #[inline(always)]
    pub(crate) fn material(&self, material: MaterialId) -> &'a PreparedMaterial {
        const NONE: &PreparedMaterial = &PreparedMaterial::NONE;
        match self.materials {
            // With one material, the compiler knows which one is read.
            [only] => only,
            several => several.get(material.index()).unwrap_or(NONE),
        }
    }

    /// Tests whether the material with this number mirrors.
    pub(crate) const fn mirrors(&self, material: MaterialId) -> bool {
        material.index() < self.materials.len() && self.materials[material.index()].mirrors()
    }

    /// Tests whether a material has no colour of its own.
    pub(crate) const fn has_blank(&self) -> bool {
        let mut index = 0;
        while index < self.materials.len() && self.materials[index].has_own() {
            index += 1;
        }
        index < self.materials.len()
    }

    /// Returns the smallest throughput with which a path can still change a channel by `change`, 0 to 1.
    pub(crate) const fn smallest_weight(&self, change: Unit) -> Unit {
        unit_product(change, self.dimness)
    }

    /// Tests whether the scene has no shape and no sky, so that all rays show one colour.
    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        !self.has_bounded() && self.planes.is_empty() && !self.has_sky()
    }

    /// Returns the number of the first plane, which follows all bounded shapes.
    #[inline(always)]
    pub(super) fn first_plane(&self) -> u32 {
        to_u32(self.bounded())
    }

    /// Tests whether a shape is a plane.
    #[inline(always)]
    pub(crate) fn is_plane(&self, shape: ShapeId) -> bool {
        shape != ShapeId::NONE && shape.0 >= self.first_plane()
    }

    /// Returns the plane with this number, or `None` if the shape is no plane.
    #[inline(always)]
    pub(crate) fn plane(&self, shape: ShapeId) -> Option<&'a PreparedPlane> {
        self.planes.get(self.plane_index(shape)?)
    }

    /// Returns the index of a plane among the planes, or `None` if the shape is bounded.
    #[inline(always)]
    pub(crate) fn plane_index(&self, shape: ShapeId) -> Option<usize> {
        let index = shape.0.checked_sub(self.first_plane())?;
        Some(index as usize)
    }
}

/// A scene that the plain kernels can read.
pub trait SceneAccess {
    /// Features of the library that the scene can need. The code for others is not linked.
    const NEEDS: Needs;

    /// Whether a material may have no colour of its own.
    const HAS_BLANK: bool = true;

    /// Returns the parts of the scene.
    fn parts(&self) -> Parts<'_>;
}

impl<W: SceneAccess> SceneAccess for &W {
    const NEEDS: Needs = W::NEEDS;
    const HAS_BLANK: bool = W::HAS_BLANK;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        (**self).parts()
    }
}

/// The number of a shape, or a sentinel. Bounded shapes come first, kind after kind, then planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeId(pub(super) u32);

impl ShapeId {
    /// Sentinel for no shape.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Sentinel for an unknown hit: it lies beyond the reach of near rays.
    pub(crate) const BEYOND: Self = Self(u32::MAX - 1);

    /// Returns a number for the shape's inside or its outside, different for each side of each shape.
    pub(crate) const fn side(self, is_inside: bool) -> u32 {
        self.0 << 1 | is_inside as u32
    }

    /// Returns the index of the shape among all shapes of the scene.
    #[inline(always)]
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }

    /// Returns the shape with this index among all shapes of the scene.
    #[inline(always)]
    pub(crate) const fn at(index: usize) -> Self {
        Self(to_u32(index))
    }
}
