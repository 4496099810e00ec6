//! Finds the nearest hit of a ray in a scene, tests whether a ray is blocked, and offsets the hit point
//! from its surface by epsilon. This file passes on the material and never computes a colour.

use super::{IS_CAREFUL, Ray, Real, Shape, Vector};

macro_rules! scene {
    ($parameters:tt $({ $list:ident $kind:ident $described:ident $($more:tt)* })*) => {
        /// A scene prepared for tracing, as borrowed lists. A shape names its material by index.
        #[derive(Clone, Copy, Debug)]
        pub struct Scene<'a> {
            $(
                #[doc = concat!("The ", stringify!($list), " of the scene.")]
                pub $list: &'a [super::$described],
            )*
            /// The point lights of the scene.
            pub lights: &'a [Light],
            /// The materials of the scene, which shapes name by index.
            pub materials: &'a [Material],
            /// Linear colour that a ray shows where it hits nothing. Not used if there is a sky.
            pub background: Vector,
            /// Sky that a ray shows where it hits nothing; `None` if the background has one colour.
            pub sky: Option<Sky>,
            /// Distance from a surface, along its normal, at which shadow and reflected rays start; in
            /// scene units.
            pub epsilon: Real,
        }

        /// The identity of a shape that a ray hits: its kind, and its index in the list of that kind.
        #[derive(Clone, Copy, Debug)]
        pub enum Met {
            $(
                #[doc = concat!("A ", stringify!($kind), ", by its index.")]
                $described(usize),
            )*
        }

        impl<'a> Scene<'a> {
            /// Returns the surface at the nearest hit ahead on the ray, or `None` if the ray hits
            /// nothing.
            #[inline]
            pub fn nearest(&self, ray: &Ray) -> Option<Surface<'a>> {
                let mut reach = Real::INFINITY;
                let shape = None;
                $(
                    // A hit here is nearer than all hits before: `reach` is the nearest so far.
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
                let flat = if is_inside { -normal } else { normal };
                let normal = self.shaded(shape, at, flat, ray.direction);
                Some(Surface {
                    outside: at + flat * self.epsilon,
                    normal,
                    viewer: -ray.direction,
                    material: &self.materials[material],
                    distance: reach,
                    shape,
                    is_inside,
                })
            }

            /// Tests whether the ray hits any shape nearer than `reach`.
            #[inline]
            pub fn is_blocked(&self, ray: &Ray, reach: Real) -> bool {
                $(blocks(self.$list, ray, reach))||*
            }

            /// Returns the shape that was hit.
            pub fn shape(&self, met: Met) -> &'a dyn Shape {
                match met {
                    $(Met::$described(index) => &self.$list[index],)*
                }
            }

            /// Returns the number of a shape among all shapes of the scene, counted kind by kind.
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

impl Scene<'_> {
    /// Returns the normal with which a point of a shape is shaded.
    #[inline]
    fn shaded(&self, shape: Met, at: Vector, normal: Vector, view: Vector) -> Vector {
        match shape {
            Met::Triangle(index) => match self.triangles.get(index) {
                Some(triangle) => triangle.shaded(at, normal, view),
                None => normal,
            },
            _ => normal,
        }
    }

    /// Returns the colour of a ray in this direction that hits nothing.
    #[inline]
    pub fn beyond(&self, direction: Vector) -> Vector {
        let sun = self.lights.iter().find(|it| it.is_shown(direction));
        let sky = || self.sky.map_or(self.background, |sky| sky.color(direction));
        sun.map_or_else(sky, |sun| sun.color)
    }
}

/// A sky: a colour for each direction.
#[derive(Clone, Copy, Debug)]
pub struct Sky {
    /// Unit direction straight up.
    pub up: Vector,
    /// Linear colour straight down.
    pub below: Vector,
    /// Linear colour at the horizon.
    pub horizon: Vector,
    /// Linear colour straight up.
    pub above: Vector,
}

impl Sky {
    fn color(&self, direction: Vector) -> Vector {
        let rise = direction.dot(self.up);
        let (end, share) = if rise < 0.0 { (self.below, -rise) } else { (self.above, rise) };
        self.horizon + (end - self.horizon) * share
    }
}

/// A light: a lamp, which is a point, or a sun, which is a direction.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    /// Position of a lamp, in scene units. Of a sun, the unit direction towards it.
    pub position: Vector,
    /// Linear colour of the light.
    pub color: Vector,
    /// `None` for a lamp. Of a sun, the cosine of half the angle of its disc; above 1 if none is seen.
    pub sun: Option<Real>,
    /// Distance at which a lamp has half its strength, in scene units; `None` if it does not fall off.
    pub range: Option<Real>,
}

impl Light {
    /// Returns the unit direction to the light from a point, and its distance in scene units.
    #[inline]
    pub fn seen_from(&self, place: Vector) -> (Vector, Real) {
        match self.sun {
            Some(_) => (self.position, Real::INFINITY),
            None => {
                let way = self.position - place;
                let distance = way.length();
                (way * (1.0 / distance), distance)
            }
        }
    }

    /// Returns the share of the light that arrives at a distance: 1 / (1 + (d / r)²) for a range r.
    #[inline]
    pub fn share_at(range: Real, distance: Real) -> Real {
        let ratio = distance / range;
        1.0 / (1.0 + ratio * ratio)
    }

    /// Tests whether a ray in a unit direction that hits nothing shows the light's disc.
    #[inline]
    fn is_shown(&self, direction: Vector) -> bool {
        self.sun
            .is_some_and(|cosine| direction.dot(self.position) >= cosine)
    }
}

/// The material of a surface: its colour, and how it reflects light.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Linear colour of the material. It multiplies ambient, diffuse and specular light.
    pub color: Vector,
    /// Share of the colour that is visible without any light.
    pub ambient: Real,
    /// Share of a light that the surface scatters evenly in all directions.
    pub diffuse: Real,
    /// Strength of the highlight. The highlight takes the material's colour, like the diffuse light.
    pub specular: Real,
    /// Exponent of the highlight.
    pub shininess: Real,
    /// Share α, 0 to 1, of the reflected colour in the surface's colour; 1 − α is its own colour's
    /// share.
    pub mirror: Real,
    /// Checker that gives parts of the surface another colour, if there is one.
    pub checker: Option<Checker>,
}

impl Material {
    /// Returns the colour of the material at a point from which rays leave.
    #[inline]
    pub fn color_at(&self, place: Vector) -> Vector {
        match self.checker {
            Some(checker) if checker.is_odd(place) => checker.color,
            _ => self.color,
        }
    }
}

/// A checker: the second colour of a material, in every other cell of space.
#[derive(Clone, Copy, Debug)]
pub struct Checker {
    /// Linear colour of every other cell.
    pub color: Vector,
    /// Cells in a scene unit along each axis: 1 / size, or 0 if a cell has no end.
    pub cells: Vector,
}

impl Checker {
    /// Returns the cell in which a point lies, along each axis. To the reference, a point just below a border is on it.
    #[inline]
    pub fn cell(&self, place: Vector) -> [i32; 3] {
        let off = place.0.map(Real::abs).iter().sum::<Real>() * 1e-12;
        let Vector([x, y, z]) = [place, place + Vector::grey(off)][usize::from(IS_CAREFUL)];
        let Vector([across, along, up]) = self.cells;
        [floor(x * across), floor(y * along), floor(z * up)]
    }

    /// Tests whether a point has the checker's colour: the sum of its cells is odd.
    #[inline]
    pub fn is_odd(&self, place: Vector) -> bool {
        let [x, y, z] = self.cell(place);
        (x ^ y ^ z) & 1 != 0
    }
}

/// Rounds a number down to a whole one. `core` has no such function.
#[inline]
fn floor(number: Real) -> i32 {
    let whole = number as i32;
    whole.wrapping_sub((whole as Real > number).into())
}

/// The surface at the hit of a ray: point, normal, material and shape.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The hit point, moved off the surface by epsilon along the shape's own normal, to the side from which the
    /// ray came.
    pub outside: Vector,
    /// Unit normal with which the surface is shaded, on the side from which the ray came.
    pub normal: Vector,
    /// Unit direction from the surface back along the ray, to the viewer.
    pub viewer: Vector,
    /// Material of the surface.
    pub material: &'a Material,
    /// Distance from the start of the ray to the hit, in scene units.
    pub distance: Real,
    /// Identity of the shape that was hit.
    pub shape: Met,
    /// Whether the ray hits the side opposite the shape's own normal, such as the inside of a sphere.
    pub is_inside: bool,
}

/// Returns the index of the shape with the nearest hit before `reach`, and sets `reach` to its distance.
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
    /// Returns the ray reflected at the surface as at a perfect mirror. It starts at `outside`.
    #[inline]
    pub fn reflected(&self) -> Ray {
        Ray {
            origin: self.outside,
            direction: self.viewer.mirrored(self.normal),
        }
    }
}
