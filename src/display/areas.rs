//! The parts of a picture that depend on one shape.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;
use heapless::Vec;

use super::common;
use crate::accel::BoundedShape;
use crate::accel::any_scene::AnyScene;
use crate::accel::screen_axis::Columns;
use crate::error::Error;
use crate::number::unsigned;
use crate::qualities::Quality;
use crate::render::FrameBuilder;
use crate::scene::Handle;
use crate::shade::Shading;

/// Most rectangles that are kept apart.
const MOST: usize = 8;

/// Rectangles of a picture, at most 8. [`FrameBuilder::areas_of`] returns them.
#[derive(Clone, Debug, Default)]
pub struct Areas(Vec<Rectangle, MOST>);

impl Areas {
    /// Adds all rectangles of others. Two become one if that has no more pixels than both.
    #[must_use]
    pub fn with(mut self, others: &Self) -> Self {
        others.0.iter().for_each(|area| self.add(*area));
        self
    }

    /// Returns the rectangles. Some may overlap.
    pub fn iter(&self) -> impl Iterator<Item = Rectangle> + '_ {
        self.0.iter().copied()
    }

    /// Adds a rectangle.
    fn add(&mut self, mut area: Rectangle) {
        if area.is_zero_sized() {
            return;
        }
        let more = |one: Rectangle, other| pixels(hull(one, other)).saturating_sub(pixels(one));
        let is_joined = |it: &Rectangle, area| more(*it, area) <= pixels(area);
        while let Some(at) = self.0.iter().position(|it| is_joined(it, area)) {
            // The last one takes its place.
            let Some(last) = self.0.pop() else { break };
            let place = self.0.get_mut(at);
            area = hull(
                place.map_or(last, |place| core::mem::replace(place, last)),
                area,
            );
        }
        if let Err(area) = self.0.push(area) {
            let nearest = self.0.iter_mut().min_by_key(|it| more(**it, area));
            if let Some(nearest) = nearest {
                *nearest = hull(*nearest, area);
            }
        }
    }
}

impl<S: AnyScene, Q: Quality, K: Shading> FrameBuilder<'_, S, Q, K> {
    /// Returns the parts of a picture of `size` that depend on a bounded shape where it is now: the pixels that show it, its
    /// shadows, or either of them in mirrors. Round mirrors, and flat ones that are bounded, count as a whole.
    ///
    /// To draw a picture again after a shape has moved, draw the areas of its old and of its new place. All other pixels
    /// stay, as long as the camera and all other parts do. With [`Exact`](crate::quality::Exact) and
    /// [`Small`](crate::quality::Small) they are the same to the bit. With [`Fast`](crate::quality::Fast), pixels beside
    /// the areas may be interpolated in another way, which may change them by a level or two of 255. With smooth edges,
    /// areas are as wide as the picture, and hold each row that a thin shape is level with.
    ///
    /// Some cases count as the whole picture: a camera or a lamp far outside of the scene, a lamp within the shape, a
    /// shadow that has no end or falls on the camera's place, and mirroring planes that show each other more than six times.
    ///
    /// # Errors
    /// [`ErrorKind::UnknownHandle`](crate::ErrorKind::UnknownHandle) if the scene has no such shape.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888, prelude::*};
    /// use reflet::{Camera, Material, MovingScene, scene};
    ///
    /// scene! {
    ///     struct Bounce {
    ///         motion([-1.0, -1.0, 0.0], [1.0, 1.0, 6.0]);
    ///         sphere BALL([0.0, 0.0, 1.0], 1.0, Material::new([0.9, 0.1, 0.1]));
    ///         plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], Material::new([0.5; 3]));
    ///         light([3.0, -4.0, 20.0], [1.0, 1.0, 1.0]);
    ///     }
    /// }
    /// const CAMERA: Camera = Camera::look_at([0.0, -9.0, 4.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    ///
    /// let mut scene = MovingScene::<Bounce>::new();
    /// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
    /// display.set_allow_overdraw(true);
    /// scene.frame(&CAMERA).draw(&mut display).unwrap();
    ///
    /// let size = display.size();
    /// let before = scene.frame(&CAMERA).areas_of(Bounce::BALL, size)?;
    /// scene.set_sphere(Bounce::BALL, [0.0, 0.0, 1.25], 1)?;
    /// let frame = scene.frame(&CAMERA).prepare(size);
    /// let areas = before.with(&scene.frame(&CAMERA).areas_of(Bounce::BALL, size)?);
    /// for area in areas.iter() {
    ///     frame.on(&scene)?.draw_area(area, Point::zero(), &mut display).unwrap();
    /// }
    /// assert!(areas.iter().map(|area| area.size.width * area.size.height).sum::<u32>() < 64 * 64 / 3);
    /// # Ok::<(), reflet::Error>(())
    /// ```
    pub fn areas_of<T: BoundedShape>(&self, shape: Handle<T>, size: Size) -> Result<Areas, Error> {
        let sides = [size.width, size.height].map(|side| side.clamp(1, 65_535));
        let picture = Rectangle::new(Point::zero(), Size::new(sides[0], sides[1]));
        let mut areas = Areas::default();
        let is_bounded = self.touched(shape, sides, |[columns, rows]| {
            let [mut columns, mut rows] = [columns, rows];
            if Q::SMOOTHNESS > 1 {
                columns = Columns::ALL;
                rows.first = rows.first.saturating_sub(1);
                rows.last = rows.last.saturating_add(1);
            }
            let start = Point::new(columns.first, rows.first);
            let side =
                |it: Columns| unsigned(it.last.saturating_sub(it.first).saturating_add(1).max(0));
            let area = Rectangle::new(start, Size::new(side(columns), side(rows)));
            areas.add(common(picture, area));
        })?;
        if !is_bounded {
            areas.add(picture);
        }
        Ok(areas)
    }
}

/// Returns the smallest rectangle around two that are not empty.
fn hull(one: Rectangle, other: Rectangle) -> Rectangle {
    let [end, last] = [one, other].map(|it| it.top_left + it.size);
    let start = one.top_left.component_min(other.top_left);
    let size = end.component_max(last) - start;
    Rectangle::new(start, Size::new(unsigned(size.x), unsigned(size.y)))
}

fn pixels(area: Rectangle) -> u32 {
    area.size.width.saturating_mul(area.size.height)
}
