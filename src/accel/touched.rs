//! Where a picture depends on one bounded shape: the pixels that show the shape, its shadows, or either of them in mirrors.
//!
//! Bound: each of these lies in a hull of balls, whose rectangle on the screen is known ([`super::screen_axis`]). The shadow on
//! a plane lies where the light's rays past the shape, a [`cone`], meet the plane. A bounded shape that the shadow reaches is
//! taken as a whole, and so is one that mirrors. What a plane mirrors is seen where its image in the plane is.

mod cone;

use heapless::Vec;

use super::World;
use super::screen_axis::{Columns, widened};
use crate::light::PreparedLight;
use crate::number::Length;
use crate::ray::ScreenAxis;
use crate::scene::access::{Parts, ShapeId};
use crate::shape::plane::PreparedPlane;
use crate::vector::{Point, Vector};
use cone::Cone;

/// A kind of bounded shape, as users describe it.
pub trait BoundedShape {
    /// Name of the kind.
    #[doc(hidden)]
    const KIND: &'static str;
}

macro_rules! bounded_shapes {
    ($header:tt $({ $list:ident $kind:ident $described:ident $($more:tt)* })*) => {
        $(
            impl BoundedShape for crate::shape::$described {
                const KIND: &'static str = stringify!($kind);
            }
        )*

        impl Parts<'_> {
            /// Returns the number of a shape, given its kind and its index among those of its kind.
            pub(crate) fn shape_of<T: BoundedShape>(&self, index: usize) -> Option<ShapeId> {
                let [$($list),*] = self.kinds();
                $(
                    if T::KIND == stringify!($kind) {
                        return (index < self.$list.len()).then(|| $list.id(index));
                    }
                )*
                None
            }
        }
    };
}
kinds!(bounded_shapes);

/// All points within a radius of the convex hull of some points.
#[derive(Clone, Debug)]
struct Hull {
    points: Vec<Point, 16>,
    radius: i32,
}

impl Hull {
    /// Returns the hull around a bounded shape: a ball, or a capsule around a line.
    fn around(parts: &Parts<'_>, shape: ShapeId) -> Option<Self> {
        let (middle, half, radius) = parts.outline(shape)?;
        let middle = middle.to_vector();
        let ends = [middle.plus(half), middle.minus(half)].map(Point::at);
        // A ball has one point only.
        let ends = if half == Vector::ZERO { &ends[..1] } else { &ends[..] };
        Some(Self {
            points: Vec::from_slice(ends).unwrap_or_default(),
            radius,
        })
    }
}

/// Most reflections in planes that are followed one by one.
const MOST_BOUNCES: u32 = 6;

/// The pixels of a picture that depend on a shape, while they are collected.
pub(crate) struct Touched<'a, W, F> {
    world: &'a W,
    axes: &'a [ScreenAxis; 2],
    /// How often planes mirror.
    bounces: u32,
    /// Called with the columns and the rows of each part.
    found: F,
    /// Whether the whole picture may depend on the shape.
    is_whole: bool,
}

impl<'a, W: World, F: FnMut([Columns; 2])> Touched<'a, W, F> {
    /// Calls `found` with the columns and rows of all parts of the picture that may depend on a shape. Returns `false` if that
    /// may be the whole picture. `axes` are those of a near camera, `bounces` is 0 if nothing mirrors.
    pub(crate) fn find(
        world: &'a W,
        axes: &'a [ScreenAxis; 2],
        shape: ShapeId,
        (bounces, has_shadows): (u32, bool),
        found: F,
    ) -> bool {
        let mut touched = Self {
            world,
            axes,
            bounces: if W::NEEDS.mirrored { bounces } else { 0 },
            found,
            is_whole: false,
        };
        let parts = world.parts();
        let Some(body) = Hull::around(&parts, shape) else {
            return true;
        };
        touched.show(&body, None, 0);
        if has_shadows && W::NEEDS.shadows {
            for light in parts.lights {
                touched.shade(light, shape);
            }
        }
        if touched.bounces > 0 {
            for other in (0..parts.bounded()).map(ShapeId::at) {
                let mirrors = |material| parts.material(material).mirrors();
                if other != shape && parts.material_of(other).is_some_and(mirrors) {
                    touched.show_shape(other);
                }
            }
        }
        !touched.is_whole
    }

    /// Adds the pixels that show a bounded shape.
    fn show_shape(&mut self, shape: ShapeId) {
        if let Some(hull) = Hull::around(&self.world.parts(), shape) {
            self.show(&hull, None, 0);
        }
    }

    /// Adds the pixels that show a hull, and those that show it in mirroring planes. It is an image itself after some `bounces`,
    /// the last of them in the plane `mirror`.
    fn show(&mut self, hull: &Hull, mirror: Option<usize>, bounces: u32) {
        let origin = self.axes[0].origin;
        let radius = widened(hull.radius);
        let ways = hull.points.iter().map(|point| origin.to(*point));
        let sides = self.axes.each_ref();
        let sides = sides.map(|axis| axis.hull_columns(ways.clone(), radius));
        if let [Some(columns), Some(rows)] = sides {
            (self.found)([columns, rows]);
        }
        if bounces >= self.bounces || !W::NEEDS.plane_mirrors {
            return;
        }
        let parts = self.world.parts();
        for (index, plane) in parts.planes.iter().enumerate() {
            if mirror == Some(index) || !parts.material(plane.material).mirrors() {
                continue;
            }
            match self.mirrored(hull, plane) {
                Some(image) if bounces < MOST_BOUNCES => {
                    self.show(&image, Some(index), bounces + 1)
                }
                _ => self.is_whole = true,
            }
        }
    }

    /// Returns the image of a hull in a plane. `None` if it is too far away. Mirrored rays start up to two epsilon aside.
    fn mirrored(&self, hull: &Hull, plane: &PreparedPlane) -> Option<Hull> {
        let mut image = hull.clone();
        for point in &mut image.points {
            *point = plane.mirrored(*point, Length::from_bits(0))?;
        }
        image.radius += 2 * self.world.parts().epsilon.to_bits();
        Some(image)
    }

    /// Adds the pixels that show what the shadow of a shape in one light reaches.
    fn shade(&mut self, light: &PreparedLight, shape: ShapeId) {
        let parts = self.world.parts();
        let body = Hull::around(&parts, shape);
        let ball = parts.ball(shape.index());
        let cone = ball.and_then(|(ball, _)| Cone::new(light, ball));
        let (Some(body), Some(cone)) = (body, cone) else {
            self.is_whole = true;
            return;
        };
        for plane in parts.planes.iter().filter(|plane| !cone.is_beyond(plane)) {
            let mut cut = Hull {
                points: Vec::new(),
                radius: 0,
            };
            // The shadow of a hull is the hull of the shadows. It has no end if a part of the hull throws none on the plane.
            let (mut reached, mut missed) = (false, false);
            for point in &body.points {
                let cone = Cone::new(light, (*point, body.radius));
                match cone.and_then(|cone| cone.cut(plane, parts.epsilon, &mut cut)) {
                    Some(true) => reached = true,
                    Some(false) => missed = true,
                    None => (reached, missed) = (true, true),
                }
            }
            self.is_whole |= reached && missed;
            if reached {
                self.show(&cut, None, 0);
            }
        }
        for other in (0..parts.bounded()).map(ShapeId::at) {
            let ball = parts.ball(other.index());
            let is_reached = ball.is_some_and(|(ball, _)| cone.reaches(ball));
            if other != shape && is_reached {
                self.show_shape(other);
            }
        }
    }
}
