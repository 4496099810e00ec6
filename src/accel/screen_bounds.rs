//! Which pixels each bounded shape can be seen in: rectangles, worked out once a frame.
//!
//! What a mirroring plane shows first are the shapes mirrored in it, as the camera sees them. Bound:
//! radii are widened by 2⁻¹⁰ and 64 steps, mirrored ones by two epsilon, rectangles by one or two
//! pixels.

use super::screen_axis::{Columns, THIN, widened};
use super::screen_rect::{ScreenRect, THIN_SHAPE, insert};
use crate::number::Length;
use crate::ray::ScreenAxis;
use crate::scene::access::SceneAccess;
use crate::scene::{Array, Capacity};
use crate::shape::bounded::Bounded;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Point, Vector};

macro_rules! rects {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// The rectangles of the shapes of a scene, in rising order of their left columns.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Rects<R: Capacity> {
            $(pub(super) $list: R::$lists<ScreenRect>,)*
        }

        impl<R: Capacity> Rects<R> {
            /// Room for rectangles.
            #[inline(always)]
            fn empty() -> Self {
                Self { $($list: Array::filled(ScreenRect::NONE),)* }
            }

            /// Finds the rectangles of all shapes.
            #[inline(never)]
            fn look<W: SceneAccess>(&mut self, world: &W, eye: &Eye<'_>) {
                const {
                    assert!(
                        $(R::COUNTS.$list <= THIN_SHAPE as usize)&&*,
                        "a scene has room for at most 32768 shapes of a kind"
                    );
                }
                let parts = world.parts();
                // Said so, nothing of planes is linked where there are none.
                let plane = if W::NEEDS.planes { eye.plane } else { None };
                let eye = Eye { plane, ..*eye };
                $(eye.look_at(parts.$list, self.$list.as_mut());)*
            }
        }
    };
}
kinds!(rects);

/// The rectangles of the shapes of a scene, themselves and mirrored in each plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenBounds<R: Capacity> {
    direct: Rects<R>,
    mirrored: R::Planes<Rects<R>>,
}

impl<R: Capacity> ScreenBounds<R> {
    /// Room for the rectangles of a frame.
    #[inline(always)]
    pub(crate) fn empty() -> Self {
        Self {
            direct: Rects::empty(),
            mirrored: Array::filled(Rects::empty()),
        }
    }

    /// Finds the rectangles of a scene as the rays through the columns and those through the rows of
    /// a picture see it; mirrored only where a plane mirrors.
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

    /// Of the shapes themselves.
    pub(super) fn direct(&self) -> &Rects<R> {
        &self.direct
    }

    /// Of the shapes mirrored in a plane.
    pub(super) fn mirrored(&self, plane: usize) -> Option<&Rects<R>> {
        self.mirrored.as_ref().get(plane)
    }
}

/// The camera, and the plane that it looks into if there is one.
struct Eye<'a> {
    axes: &'a [ScreenAxis; 2],
    plane: Option<&'a PreparedPlane>,
    epsilon: Length,
}

impl Eye<'_> {
    /// Finds the rectangles of the shapes of one kind.
    #[inline(always)]
    fn look_at<K: Bounded>(&self, shapes: &[K], rects: &mut [ScreenRect]) {
        for (index, shape) in shapes.iter().enumerate() {
            let (center, half_axis, radius) = shape.outline();
            let rect = match self.seen(center, half_axis) {
                Some((way, _)) if K::IS_BALL => self.ball(index, way, radius),
                Some((way, normal)) if K::IS_FLAT => self.flat(index, (way, normal), radius),
                Some((way, half_axis)) => self.capsule(index, (way, half_axis), radius),
                None => ScreenRect::new(index, Columns::ALL, Columns::ALL, None),
            };
            insert(rects, index, rect);
        }
    }

    /// Rays leave epsilon above a plane: as good as shapes that much larger.
    fn lift(&self) -> i32 {
        self.plane.map_or(0, |_| 2 * self.epsilon.to_bits())
    }

    fn ball(&self, index: usize, way: Vector, radius: i32) -> ScreenRect {
        let lift = self.lift();
        let [columns, rows] = self
            .axes
            .each_ref()
            .map(|axis| axis.sphere_columns(way, widened(radius) + lift));
        let (Some(mut columns), Some(rows)) = (columns, rows) else {
            return ScreenRect::of_nothing(index);
        };
        // If it is half a pixel and more, its bounds do not say where the tips are.
        let height = i64::from(rows.last) - i64::from(rows.first);
        columns.is_thin |= i64::from(lift) * height >= i64::from(radius);
        let tips = self.axes[0].tips(&self.axes[1], way, radius);
        ScreenRect::new(index, columns, rows, tips)
    }

    fn flat(&self, index: usize, (way, normal): (Vector, Vector), radius: i32) -> ScreenRect {
        let rect = self.capsule_columns((way, Vector::ZERO), radius);
        let Some((mut columns, rows)) = rect else {
            return ScreenRect::of_nothing(index);
        };
        // Seen edge-on it is thinner than its columns say.
        let (direction, _) = way.direction_and_length();
        let width = i64::from(columns.last) - i64::from(columns.first);
        let thickness = width * i64::from(normal.dot(direction).abs());
        columns.is_thin |= thickness <= i64::from(THIN) * i64::from(radius);
        ScreenRect::new(index, columns.with_neighbours(), rows, None)
    }

    fn capsule(&self, index: usize, capsule: (Vector, Vector), radius: i32) -> ScreenRect {
        match self.capsule_columns(capsule, radius) {
            Some((columns, rows)) => ScreenRect::new(index, columns.with_neighbours(), rows, None),
            None => ScreenRect::of_nothing(index),
        }
    }

    /// The columns and rows of a capsule, if it can be seen.
    fn capsule_columns(
        &self,
        (way, half): (Vector, Vector),
        radius: i32,
    ) -> Option<(Columns, Columns)> {
        let radius = widened(radius) + self.lift();
        let [columns, rows] = self
            .axes
            .each_ref()
            .map(|axis| axis.capsule_columns(way, half, radius));
        columns.zip(rows)
    }

    /// The way to a shape's middle and its half axis, mirrored if there is a plane; `None` where that is
    /// too far away to be told.
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
