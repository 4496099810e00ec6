//! The description of a scene: the numbers it was written with, their storage and their view.

use super::capacity::{Capacity, Counts, Room};
use super::list::List;
use crate::background::{Background, Sky};
use crate::camera::Camera;
use crate::light::Light;
use crate::material::Material;
use crate::number::Number;
use crate::shape::Extent;
use crate::shape::plane::Plane;
use crate::vector::Position;

/// Default epsilon in scene units: the height above a surface at which rays that leave the surface start.
pub(super) const EPSILON: f64 = 1e-3;

macro_rules! description {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// The description of a scene: the numbers it was written with, before they are put on its grid.
        ///
        /// ```
        /// use reflet::description::{Cylinder, Description, Disc, Plane};
        /// use reflet::{Material, Position, RuntimeScene, room};
        ///
        /// let mut scene = RuntimeScene::<room!(planes: 1, cylinders: 1, discs: 1)>::new();
        /// let tin = scene.add_material(Material::new([0.8; 3]))?;
        /// scene.add_cylinder([0, 0, 1], [0, 0, 1], 1, 2, tin)?;
        /// scene.add_disc([0, 0, 2], [0, 0, 1], 1, tin)?;
        /// scene.add_plane([0, 0, 0], [0, 0, 1], tin)?;
        ///
        /// let up = Position::new([0.0, 0.0, 1.0]);
        /// let described: Description<'_> = scene.description();
        /// let [Cylinder { axis, radius, height, .. }] = *described.cylinders else { unreachable!() };
        /// assert_eq!((axis, radius.to_f64(), height.to_f64()), (up, 1.0, 2.0));
        /// let [Disc { center, normal, material, .. }] = *described.discs else { unreachable!() };
        /// assert_eq!((center.0[2].to_f64(), normal, material), (2.0, up, tin));
        /// let [Plane { point, .. }] = *described.planes else { unreachable!() };
        /// assert_eq!(point, Position::ORIGIN);
        /// assert_eq!(described.materials[material.index()], Material::new([0.8; 3]));
        /// assert_eq!((described.epsilon.to_f64(), described.camera), (0.001, None));
        /// assert!(described.lights.is_empty() && described.motion.is_none());
        /// # Ok::<(), reflet::Error>(())
        /// ```
        #[derive(Clone, Copy, Debug)]
        #[non_exhaustive]
        pub struct Description<'a> {
            $(
                #[doc = concat!("Descriptions of the ", stringify!($list), ", in the order in which they were added.")]
                pub $list: &'a [crate::shape::$described],
            )*
            /// Descriptions of the planes, in the order in which they were added.
            pub planes: &'a [Plane],
            /// Descriptions of the lights, in the order in which they were added.
            pub lights: &'a [Light],
            /// Materials; the `material` of a shape is an index into this list.
            pub materials: &'a [Material],
            /// Colour that a ray shows where it hits nothing: red, green and blue, 0 to 16 each. Black if there is a
            /// sky.
            pub background: [Number; 3],
            /// Sky that a ray shows where it hits nothing; `None` if the background has one colour.
            pub sky: Option<Sky>,
            /// Height above a surface at which rays that leave the surface start, in scene units; see
            /// [`SceneBuilder::epsilon`](crate::SceneBuilder::epsilon).
            pub epsilon: Number,
            /// Camera that the scene is usually viewed with, if it has one.
            pub camera: Option<Camera>,
            /// Lowest and highest corner of the box in which shapes may move, if there is one.
            pub motion: Option<[Position; 2]>,
        }

        impl Description<'_> {
            /// Returns the extent of the bounded shape with this number; numbers go through kind after
            /// kind.
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

            pub(super) const fn background(&self) -> Background {
                Background { color: self.background, sky: self.sky }
            }

            /// Returns the kind of the first bounded shape.
            pub(super) const fn first_kind(&self) -> Option<&'static str> {
                $(
                    if !self.$list.is_empty() {
                        return Some(stringify!($kind));
                    }
                )*
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

            /// Returns the smallest epsilon of rays inside of a shape, in steps: the largest value that
            /// any kind in the scene requires, and at least `least`.
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

        /// The storage of a description: the checked parts so far, and the settings. The builder and the
        /// run-time scene both use it.
        #[derive(Clone, Copy, Debug)]
        pub struct Described<R: Capacity> {
            $(pub(super) $list: List<R::$lists<crate::shape::$described>>,)*
            pub(super) planes: List<R::Planes<Plane>>,
            pub(super) lights: List<R::Lights<Light>>,
            pub(super) materials: List<R::Materials<Material>>,
            pub(super) background: Background,
            pub(super) epsilon: Number,
            pub(super) camera: Option<Camera>,
            pub(super) motion: Option<[Position; 2]>,
        }

        impl<$($header)*> Described<Room<$($arguments)*>> {
            /// Creates an empty description with a black background and an epsilon of 0.001.
            pub(super) const fn new() -> Self {
                const { assert!(M <= 1 << 16, "a scene has 65536 materials at most") };
                Self {
                    $($list: List::new(crate::shape::$described::NONE),)*
                    planes: List::new(Plane::NONE),
                    lights: List::new(Light::NONE),
                    materials: List::new(Material::NONE),
                    background: Background::BLACK,
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
                    background: self.background.color,
                    sky: self.background.sky,
                    epsilon: self.epsilon,
                    camera: self.camera,
                    motion: self.motion,
                }
            }
        }
    };
}
kinds!(description);
