//! The reference's scene: plain doubles as anyone may fill them in; it checks and renders nothing.

use core::fmt::Debug;
use std::vec::Vec;

use serde::Deserialize;

/// A place or a way, in scene units.
type Position = [f64; 3];

/// A size, in scene units.
type Number = f64;

macro_rules! scene {
    ([$($parameter:tt)*] $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $room:ident $($more:tt)*
    })*) => {
        /// A scene in plain doubles.
        ///
        /// Nothing is checked: a shape without size, a normal or an axis of length zero is never met, and
        /// a material that is not in the list panics when the scene is rendered.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Scene {
            $(
                #[doc = concat!("The ", stringify!($list), ".")]
                pub $list: Vec<$described>,
            )*
            /// The point lights.
            pub lights: Vec<Light>,
            /// What the shapes are made of; they name it by its place in this list.
            pub materials: Vec<Material>,
            /// Linear colour where a ray meets nothing.
            pub background: [f64; 3],
            /// How far from a surface, along its normal, shadow and reflected rays start; in scene units.
            pub epsilon: f64,
        }

        impl Default for Scene {
            /// Nothing at all, on black, with an epsilon of 0.001.
            fn default() -> Self {
                Self {
                    $($list: Vec::new(),)*
                    lights: Vec::new(),
                    materials: Vec::new(),
                    background: [0.0; 3],
                    epsilon: 1e-3,
                }
            }
        }

        impl Scene {
            /// All shapes, a kind after the other.
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

        /// What each number of the type of a [`crate::Scene`] counts, such as `spheres`.
        pub const PARAMETERS: &[&str] = {
            $(const $room: &str = stringify!($list);)*
            const L: &str = "lights";
            const M: &str = "materials";
            &[$($parameter)*]
        };

        $(
            #[doc = concat!("A ", stringify!($kind), " in plain doubles.")]
            ///
            #[doc = concat!(
                "The fields are the arguments of [`", stringify!($add), "`](crate::RuntimeScene::",
                stringify!($add), ")."
            )]
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct $described {
                $(
                    #[doc = concat!("Its ", stringify!($field), ".")]
                    pub $field: $type,
                )*
                /// Its place in [`Scene::materials`].
                pub material: usize,
            }
        )*
    };
}
kinds!(shapes, scene);

/// A shape of any kind, taken apart.
#[derive(Clone, Debug)]
pub struct Shape<'a> {
    /// The name of its list, such as `spheres`.
    pub list: &'static str,
    /// The name of its kind, such as `sphere`.
    pub kind: &'static str,
    /// Its fields but the material, in the order in which a builder takes them. Each is a number or three,
    /// and prints as Rust source.
    pub fields: Vec<&'a dyn Debug>,
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// A point light that does not fall off with distance.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    /// Where it stands.
    pub position: [f64; 3],
    /// Its linear colour.
    pub color: [f64; 3],
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear colour.
    pub color: [f64; 3],
    /// Share of the colour that is there without any light.
    pub ambient: f64,
    /// Share of the light that is scattered evenly.
    pub diffuse: f64,
    /// Strength of the highlight, which has the material's colour too.
    pub specular: f64,
    /// The highlight's exponent; with 0 the highlight is everywhere the light is.
    pub shininess: f64,
    /// α, 0 to 1: the share of the picture in this surface.
    pub mirror: f64,
}
