//! The scene and the camera of the reference, in doubles, with public fields. This file checks nothing and
//! renders nothing.

use alloc::vec::Vec;
use core::fmt::Debug;

use serde::Deserialize;

/// A position in scene units, or a direction of any length.
pub(in crate::host) type Position = [f64; 3];

/// A size, such as a radius or a height, in scene units.
pub(in crate::host) type Number = f64;

/// The three corners of a triangle, in scene units.
pub(in crate::host) type Corners = [[f64; 3]; 3];

/// Normals at the corners of a triangle; `None` if it is flat.
pub(in crate::host) type Normals = Option<[[f64; 3]; 3]>;

/// Default of a scene's epsilon, the distance by which rays are lifted off surfaces, in scene units.
pub(in crate::host) const EPSILON: f64 = 1e-3;

macro_rules! scene {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $room:ident $($more:tt)*
    })*) => {
        /// A scene of the reference, in doubles.
        ///
        /// Nothing is checked. A ray never hits a shape without size or with a normal or an axis of
        /// length zero. Rendering panics if a shape names a material that is not in the list.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Scene {
            $(
                #[doc = concat!("The ", stringify!($list), " of the scene.")]
                pub $list: Vec<$described>,
            )*
            /// The point lights of the scene.
            pub lights: Vec<Light>,
            /// The materials of the scene. A shape names its material by the index in this list.
            pub materials: Vec<Material>,
            /// Linear colour that a ray shows where it hits nothing. Not used if there is a sky.
            pub background: [f64; 3],
            /// Sky that a ray shows where it hits nothing; `None` if the background has one colour.
            pub sky: Option<Sky>,
            /// Distance from a surface, along its normal, at which shadow and reflected rays start; in
            /// scene units.
            pub epsilon: f64,
        }

        impl Default for Scene {
            /// Returns an empty scene with a black background and an epsilon of 0.001.
            fn default() -> Self {
                Self {
                    $($list: Vec::new(),)*
                    lights: Vec::new(),
                    materials: Vec::new(),
                    background: [0.0; 3],
                    sky: None,
                    epsilon: EPSILON,
                }
            }
        }

        impl Scene {
            /// Returns all shapes of the scene, kind by kind, in the order of the lists.
            pub fn shapes(&self) -> impl Iterator<Item = Shape<'_>> {
                let shapes = core::iter::empty();
                $(
                    let shapes = shapes.chain(self.$list.iter().map(|it| Shape {
                        list: stringify!($list),
                        kind: stringify!($kind),
                        fields: vec![$(&it.$field),*],
                        material: it.material,
                    }));
                )*
                shapes
            }
        }

        $(
            #[doc = concat!("A ", stringify!($kind), " of a scene of the reference, in doubles.")]
            ///
            #[doc = concat!(
                "The fields are the arguments of [`", stringify!($add), "`](crate::RuntimeScene::",
                stringify!($add), ")."
            )]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct $described {
                $(
                    #[doc = concat!("The ", stringify!($field), " of the ", stringify!($kind), ".")]
                    pub $field: $type,
                )*
                /// Index of the shape's material in [`Scene::materials`].
                pub material: usize,
            }
        )*
    };
}
kinds!(shapes, scene);

/// A shape of any kind, as names and a list of its fields.
///
/// ```
/// use reflet::host::reference::{Cylinder, Disc, Plane, Scene, Shape};
///
/// let up = [0.0, 0.0, 1.0];
/// let wall = Cylinder { center: [0.0; 3], axis: up, radius: 0.5, height: 2.0, material: 0 };
/// let lid = Disc { center: up, normal: up, radius: 0.5, material: 1 };
/// let floor = Plane { point: [0.0; 3], normal: up, material: 2 };
/// let (cylinders, discs, planes) = (vec![wall], vec![lid], vec![floor]);
/// let scene = Scene { cylinders, discs, planes, ..Scene::default() };
///
/// let disc: Shape<'_> = scene.shapes().find(|shape| shape.material == 1).unwrap();
/// assert_eq!((disc.list, disc.kind), ("discs", "disc"));
/// assert_eq!(format!("{:?}", disc.fields), "[[0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 0.5]");
/// ```
#[derive(Clone, Debug)]
pub struct Shape<'a> {
    /// Name of the list that holds the shape, such as `spheres`.
    pub list: &'static str,
    /// Name of the shape's kind, such as `sphere`.
    pub kind: &'static str,
    /// Fields of the shape without the material, in the order of the builder's arguments. Each field is
    /// a number or an array of three, and prints as Rust source.
    pub fields: Vec<&'a dyn Debug>,
    /// Index of the shape's material in [`Scene::materials`].
    pub material: usize,
}

/// A camera of the reference, in doubles.
///
/// Nothing is checked. The caller makes sure that `target` differs from `position`, that `up` is not
/// parallel to the view, and that `fov` is between 0 and 180.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Position of the camera, in scene units.
    pub position: [f64; 3],
    /// Point that the camera looks at, in scene units. It is in the middle of the picture.
    pub target: [f64; 3],
    /// Direction that is up in the picture. Only its part perpendicular to the view direction matters.
    pub up: [f64; 3],
    /// Full horizontal field of view in degrees.
    pub fov: f64,
}

/// A sky: the colour of a ray that hits nothing depends on its direction d. It is
/// horizon + (above − horizon) · d · up, or horizon + (below − horizon) · −d · up below the horizon.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sky {
    /// Direction straight up, of any length above 0.
    pub up: [f64; 3],
    /// Linear colour straight down.
    pub below: [f64; 3],
    /// Linear colour at the horizon.
    pub horizon: [f64; 3],
    /// Linear colour straight up.
    pub above: [f64; 3],
}

/// A light: a lamp, which is a point, or a sun, which is a direction.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Position of a lamp, in scene units. Of a sun, the direction towards it, of any length above 0.
    pub position: [f64; 3],
    /// Linear colour of the light.
    pub color: [f64; 3],
    /// `None` for a lamp. Of a sun, the angle of its disc in the sky, in degrees; 0 shows none.
    #[serde(skip)]
    pub sun: Option<f64>,
    /// Range r of a lamp whose strength at the distance d is 1 / (1 + (d / r)²), in scene units; `None` if it does not
    /// fall off.
    pub range: Option<f64>,
}

/// The material of a surface: its colour, and how it reflects light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear colour of the material. It multiplies ambient, diffuse and specular light.
    pub color: [f64; 3],
    /// Share of the colour that is visible without any light.
    pub ambient: f64,
    /// Share of a light that the surface scatters evenly in all directions.
    pub diffuse: f64,
    /// Strength of the highlight. The highlight takes the material's colour, like the diffuse light.
    pub specular: f64,
    /// Exponent of the highlight. With 0 the highlight covers all that the light reaches.
    pub shininess: f64,
    /// Share α, 0 to 1, of the reflected colour in the surface's colour; 1 − α is its own colour's
    /// share.
    pub mirror: f64,
    /// Checker that gives parts of the surface another colour, if there is one.
    pub checker: Option<Checker>,
}

/// A checker: the second colour of a material. Along each axis a point x lies in cell ⌊x / size⌋, and where the
/// sum of the three is odd, the surface has this colour.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checker {
    /// Linear colour of every other cell.
    pub color: [f64; 3],
    /// Size of a cell along each axis, in scene units; 0 along an axis in which a cell has no end.
    #[serde(deserialize_with = "crate::host::file::document::size")]
    pub size: [f64; 3],
}
