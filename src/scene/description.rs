//! A scene as it is described: where that is kept while it is filled, and what is read of it.

use super::capacity::{Capacity, Counts, Room};
use super::list::List;
use crate::camera::Camera;
use crate::light::Light;
use crate::material::Material;
use crate::number::Number;
use crate::shape::Extent;
use crate::shape::plane::Plane;
use crate::vector::Position;

/// How far a ray is lifted off the surface it leaves unless the scene says otherwise.
const EPSILON: f64 = 1e-3;

macro_rules! description {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// A scene as it was described: plain numbers, before they are laid on the grid.
        #[derive(Clone, Copy, Debug)]
        #[non_exhaustive]
        pub struct Description<'a> {
            $(
                #[doc = concat!("The ", stringify!($list), ".")]
                pub $list: &'a [crate::shape::$described],
            )*
            /// The planes.
            pub planes: &'a [Plane],
            /// The lights.
            pub lights: &'a [Light],
            /// The materials the shapes name.
            pub materials: &'a [Material],
            /// What a ray that meets nothing adds.
            pub background: [Number; 3],
            /// How far above a surface rays start that leave it; see
            /// [`SceneBuilder::epsilon`](crate::SceneBuilder::epsilon).
            pub epsilon: Number,
            /// The camera the scene is meant to be seen with first.
            pub camera: Option<Camera>,
            /// Two corners of the box in which parts move, if any do.
            pub motion: Option<[Position; 2]>,
        }

        impl Description<'_> {
            /// The extent of a bounded shape with this number; the kinds follow each other.
            pub(super) const fn extent(&self, number: usize) -> Option<Extent> {
                $(
                    if number < self.$list.len() {
                        return Some(self.$list[number].extent());
                    }
                    let number = number - self.$list.len();
                )*
                let _ = number;
                None
            }

            pub(super) const fn counts(&self) -> Counts {
                Counts {
                    $($list: self.$list.len(),)*
                    planes: self.planes.len(),
                    lights: self.lights.len(),
                    materials: self.materials.len(),
                }
            }

            /// The smallest epsilon of rays inside of a shape, in steps: what the strictest kind asks for,
            /// and not less than `least`.
            pub(super) const fn smallest_inside(&self, least: i32) -> i32 {
                let mut smallest = least;
                $(
                    let own = crate::shape::$prepared::SMALLEST_INSIDE;
                    if !self.$list.is_empty() && own > smallest {
                        smallest = own;
                    }
                )*
                smallest
            }
        }

        /// What the builder and the run-time scene have in common: the parts so far, which are checked, and
        /// the rest of a description.
        #[derive(Clone, Copy, Debug)]
        pub struct Described<R: Capacity> {
            $(pub(super) $list: List<R::$lists<crate::shape::$described>>,)*
            pub(super) planes: List<R::Planes<Plane>>,
            pub(super) lights: List<R::Lights<Light>>,
            pub(super) materials: List<R::Materials<Material>>,
            pub(super) background: [Number; 3],
            pub(super) epsilon: Number,
            pub(super) camera: Option<Camera>,
            pub(super) motion: Option<[Position; 2]>,
        }

        impl<$($header)*> Described<Room<$($arguments)*>> {
            /// An empty scene with a black background and an epsilon of 0.001.
            pub(super) const fn new() -> Self {
                const { assert!(M <= 1 << 16, "a scene has 65536 materials at most") };
                Self {
                    $($list: List::new(crate::shape::$described::NONE),)*
                    planes: List::new(Plane::NONE),
                    lights: List::new(Light::NONE),
                    materials: List::new(Material::NONE),
                    background: [Number::ZERO; 3],
                    epsilon: Number::new(EPSILON),
                    camera: None,
                    motion: None,
                }
            }

            pub(super) const fn description(&self) -> Description<'_> {
                Description {
                    $($list: self.$list.as_slice(),)*
                    planes: self.planes.as_slice(),
                    lights: self.lights.as_slice(),
                    materials: self.materials.as_slice(),
                    background: self.background,
                    epsilon: self.epsilon,
                    camera: self.camera,
                    motion: self.motion,
                }
            }
        }
    };
}
kinds!(description);
