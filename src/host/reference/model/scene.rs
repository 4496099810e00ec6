//! What a ray meets in a whole scene, and the one place that steps off a surface; it knows no
//! colour but hands on the material.

use super::{Ray, Real, Shape, Vector};

macro_rules! scene {
    ($parameters:tt $({ $list:ident $kind:ident $described:ident $($more:tt)* })*) => {
        /// A scene made ready for rays. Shapes name their material by its place.
        #[derive(Clone, Copy, Debug)]
        pub struct Scene<'a> {
            $(
                #[doc = concat!("The ", stringify!($list), ".")]
                pub $list: &'a [super::$described],
            )*
            /// The point lights.
            pub lights: &'a [Light],
            /// What the shapes are made of.
            pub materials: &'a [Material],
            /// Linear colour where a ray meets nothing.
            pub background: Vector,
            /// How far from a surface, along its normal, shadow and reflected rays start.
            pub epsilon: Real,
        }

        /// Which shape a ray meets: its kind and its place in the list of its kind.
        #[derive(Clone, Copy, Debug)]
        pub enum Met {
            $(
                #[doc = concat!("A ", stringify!($kind), ".")]
                $described(usize),
            )*
        }

        impl<'a> Scene<'a> {
            /// The nearest surface ahead.
            #[inline]
            pub fn nearest(&self, ray: &Ray) -> Option<Surface<'a>> {
                let mut reach = Real::INFINITY;
                let shape = None;
                $(
                    // It is nearer than those before.
                    let met = nearest_of(self.$list, ray, &mut reach).map(Met::$described);
                    let shape = met.or(shape);
                )*
                let (shape, at) = (shape?, ray.at(reach));
                let (normal, material) = match shape {
                    $(
                        Met::$described(index) => {
                            let it = &self.$list[index];
                            (it.normal(at), it.material)
                        }
                    )*
                };
                let is_inside = normal.dot(ray.direction) > 0.0;
                let normal = if is_inside { -normal } else { normal };
                Some(Surface {
                    outside: at + normal * self.epsilon,
                    normal,
                    viewer: -ray.direction,
                    material: &self.materials[material],
                    distance: reach,
                    shape,
                    is_inside,
                })
            }

            /// Whether the ray meets anything nearer than `reach`.
            #[inline]
            pub fn is_blocked(&self, ray: &Ray, reach: Real) -> bool {
                $(blocks(self.$list, ray, reach))||*
            }

            /// The shape that was met.
            pub fn shape(&self, met: Met) -> &'a dyn Shape {
                match met {
                    $(Met::$described(index) => &self.$list[index],)*
                }
            }

            /// The place of a shape among all; the kinds follow each other.
            pub fn number(&self, met: Met) -> usize {
                let mut first = 0;
                $(
                    if let Met::$described(index) = met {
                        return first + index;
                    }
                    first += self.$list.len();
                )*
                first
            }
        }
    };
}
kinds!(shapes, scene);

/// A point light that does not fall off with distance.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    /// Where it stands.
    pub position: Vector,
    /// Its linear colour.
    pub color: Vector,
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Linear colour.
    pub color: Vector,
    /// Share of the colour that is there without any light.
    pub ambient: Real,
    /// Share of the light that is scattered evenly.
    pub diffuse: Real,
    /// Strength of the highlight, which has the material's colour too.
    pub specular: Real,
    /// The highlight's exponent.
    pub shininess: Real,
    /// α, 0 to 1: the share of the picture in this surface.
    pub mirror: Real,
}

/// What a ray met.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The point that was met, moved off the surface by epsilon, towards where the ray came from.
    pub outside: Vector,
    /// Unit length, on the side the ray came from.
    pub normal: Vector,
    /// Unit length, from the surface to where the ray came from.
    pub viewer: Vector,
    /// What it is made of.
    pub material: &'a Material,
    /// How far the ray has come.
    pub distance: Real,
    /// Which of the scene's shapes it is.
    pub shape: Met,
    /// Whether it is seen from the side that its shape's normal leaves.
    pub is_inside: bool,
}

/// The nearest before `reach`, which becomes its distance.
#[inline]
fn nearest_of(shapes: &[impl Shape], ray: &Ray, reach: &mut Real) -> Option<usize> {
    let mut met = None;
    for (index, shape) in shapes.iter().enumerate() {
        if let Some(distance) = shape.meet(ray, *reach) {
            (*reach, met) = (distance, Some(index));
        }
    }
    met
}

#[inline]
fn blocks(shapes: &[impl Shape], ray: &Ray, reach: Real) -> bool {
    shapes.iter().any(|shape| shape.meet(ray, reach).is_some())
}

impl Surface<'_> {
    /// The ray that a mirror sends on.
    #[inline]
    pub fn reflected(&self) -> Ray {
        Ray {
            origin: self.outside,
            direction: self.viewer.mirrored(self.normal),
        }
    }
}
