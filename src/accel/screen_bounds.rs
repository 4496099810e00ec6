//! The rectangles of pixels that the bounded shapes cover. They are worked out once a frame.
//!
//! There is one list of rectangles for the shapes themselves, and one for each mirroring plane: the
//! shapes mirrored in it, as the camera sees them there. Bound: a radius is widened by 2⁻¹⁰ of it and
//! 64 steps, and by two epsilon more if mirrored. A rectangle is widened by one or two pixels. Of a sphere whose
//! centre lies behind the plane, only the cap in front of it counts.

use super::screen_axis::{Columns, widened};
use super::screen_rect::{ScreenRect, insert};
use crate::number::{Length, narrowed, square_root, unsigned_wide, wide};
use crate::ray::ScreenAxis;
use crate::scene::access::SceneAccess;
use crate::scene::{Array, Capacity};
use crate::shape::bordered::Ball;
use crate::shape::bounded::Bounded;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Point, Vector};

macro_rules! rects {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// The rectangles of all bounded shapes, one list for each kind. Each list is sorted by the
        /// left columns.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Rects<R: Capacity> {
            $(pub(super) $list: R::$lists<ScreenRect>,)*
        }

        impl<R: Capacity> Rects<R> {
            /// Returns lists that are filled with placeholders.
            #[inline(always)]
            fn empty() -> Self {
                Self { $($list: Array::filled(ScreenRect::NONE),)* }
            }

            /// Computes the rectangles of all bounded shapes of a scene, as seen from `eye`.
            #[inline(never)]
            fn look<W: SceneAccess>(&mut self, world: &W, eye: &Eye<'_>) {
                const {
                    assert!(
                        $(R::COUNTS.$list <= 1 << 15)&&*,
                        "a scene has room for at most 32768 shapes of a kind"
                    );
                }
                let parts = world.parts();
                // This tells the compiler to link no code for mirrors if no plane is one.
                let plane = if W::NEEDS.plane_mirrors { eye.plane } else { None };
                let eye = Eye { plane, ..*eye };
                $(eye.look_at(parts.$list, self.$list.as_mut());)*
            }
        }
    };
}
kinds!(rects);

/// The rectangles of all bounded shapes of a scene: seen directly, and mirrored in each plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenBounds<R: Capacity> {
    direct: Rects<R>,
    mirrored: R::Planes<Rects<R>>,
}

impl<R: Capacity> ScreenBounds<R> {
    /// Returns screen bounds that are filled with placeholders.
    #[inline(always)]
    pub(crate) fn empty() -> Self {
        Self {
            direct: Rects::empty(),
            mirrored: Array::filled(Rects::empty()),
        }
    }

    /// Computes the rectangles of all bounded shapes for one frame.
    ///
    /// `axes` describe the rays through the columns and those through the rows of the picture.
    /// Rectangles of mirrored shapes are computed only for planes that mirror.
    pub(crate) fn look<W: SceneAccess>(&mut self, world: &W, axes: &[ScreenAxis; 2]) {
        let parts = world.parts();
        let mut eye = Eye {
            axes,
            plane: None,
            epsilon: parts.epsilon,
        };
        self.direct.look(world, &eye);
        for (plane, mirrored) in parts.planes.iter().zip(self.mirrored.as_mut()) {
            if parts.material(plane.material).mirrors() {
                eye.plane = Some(plane);
                mirrored.look(world, &eye);
            }
        }
    }

    /// Returns the rectangles of the shapes as the camera sees them directly.
    pub(super) fn direct(&self) -> &Rects<R> {
        &self.direct
    }

    /// Returns the rectangles of the shapes mirrored in a plane. `plane` is the plane's index.
    pub(super) fn mirrored(&self, plane: usize) -> Option<&Rects<R>> {
        self.mirrored.as_ref().get(plane)
    }
}

/// The camera, and the plane in which the shapes are mirrored, if there is one.
struct Eye<'a> {
    axes: &'a [ScreenAxis; 2],
    plane: Option<&'a PreparedPlane>,
    epsilon: Length,
}

impl Eye<'_> {
    /// Computes the rectangles of all shapes of one kind, and sorts them by their left columns.
    #[inline(always)]
    fn look_at<K: Bounded>(&self, shapes: &[K], rects: &mut [ScreenRect]) {
        for (index, shape) in shapes.iter().enumerate() {
            let (center, half_axis, radius) = shape.outline();
            let (center, radius) =
                if K::IS_BALL { self.in_front((center, radius)) } else { (center, radius) };
            let rect = match self.seen(center, half_axis) {
                Some(way) => self.rect((index, K::IS_BALL), way, radius),
                None => ScreenRect::new(index, Columns::ALL, Columns::ALL),
            };
            insert(rects, index, rect);
        }
    }

    /// Returns a ball around the part of a ball that mirrored rays can reach: what lies in front of the plane.
    ///
    /// If the centre lies behind the plane, that part is a cap of less than half of the ball. It lies in the ball
    /// over the circle in which the plane cuts the whole.
    fn in_front(&self, (center, radius): Ball) -> Ball {
        let Some(plane) = self.plane else {
            return (center, radius);
        };
        let [height, camera] = [center, self.axes[0].origin].map(|it| plane.height(it) >> 30);
        let depth = if camera < 0 { height } else { -height };
        let whole = widened(radius) + self.lift();
        if depth <= 0 || depth >= i64::from(whole) || camera == 0 {
            return (center, radius);
        }
        let depth = narrowed(depth);
        let square = wide(whole - depth, whole + depth);
        let foot = plane.foot(center, narrowed(height));
        (foot, square_root(unsigned_wide(square)).min(radius))
    }

    /// Returns what the radii of mirrored shapes are enlarged by: two epsilon. A mirrored ray starts
    /// epsilon above the plane; a larger shape has the same effect. Returns 0 without a plane.
    fn lift(&self) -> i32 {
        self.plane.map_or(0, |_| 2 * self.epsilon.to_bits())
    }

    /// Returns the rectangle of a shape: the vector from the camera to its middle, its half axis, and its radius.
    fn rect(
        &self,
        (index, is_ball): (usize, bool),
        (way, half): (Vector, Vector),
        radius: i32,
    ) -> ScreenRect {
        let radius = widened(radius) + self.lift();
        let sides = self.axes.each_ref().map(|axis| {
            if is_ball {
                axis.sphere_columns(way, radius)
            } else {
                axis.capsule_columns(way, half, radius)
            }
        });
        match sides {
            [Some(columns), Some(rows)] => ScreenRect::new(index, columns, rows),
            _ => ScreenRect::of_nothing(index),
        }
    }

    /// Returns the vector from the camera to a shape's middle, and the shape's half axis. Both are
    /// mirrored if there is a plane. Returns `None` if the shape is too far from the plane to be
    /// mirrored.
    fn seen(&self, center: Point, half_axis: Vector) -> Option<(Vector, Vector)> {
        let way = self.axes[0].origin.to(center);
        let Some(plane) = self.plane else {
            return Some((way, half_axis));
        };
        let height = i32::try_from(plane.height(center) >> 30).ok()?;
        if height.unsigned_abs() > 1 << 28 {
            return None;
        }
        let along = half_axis.dot(plane.normal);
        Some((
            way.without(plane.normal, 2 * height),
            half_axis.without(plane.normal, 2 * along),
        ))
    }
}

#[cfg(test)]
mod tests;
