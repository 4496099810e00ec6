//! What moves: a golden ball bounces over water, and the camera orbits it. Knows no board.

use core::ops::Range;

use embedded_graphics::geometry::Size;
use reflet::display::coarse_first;
use reflet::{Camera, Material, MovingScene, Rows, scene};

/// Width and height of the panel in pixels.
const SIDE: u32 = 240;

const GOLD: Material = Material::new([0.9, 0.7, 0.1]).mirror(0.3);
const WATER: Material = Material::new([0.6, 0.8, 1.0]).diffuse(0.5).mirror(0.5);
const STONE: Material = Material::new([0.8, 0.3, 0.2]);

// Lengths are in hundredths, so that whole numbers do.
const CAMERA: Camera = Camera::look_at([0.0, -1200.0, 300.0], [0.0, 0.0, 150.0], [0.0, 0.0, 1.0]);

scene! {
    pub struct Bounce {
        motion([-100.0, -100.0, 0.0], [100.0, 100.0, 400.0]);
        sphere BALL([0.0, 0.0, 100.0], 100.0, GOLD);
        sphere([250.0, 100.0, 70.0], 70.0, STONE);
        plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER);
        light([300.0, -400.0, 900.0], [1.0, 1.0, 1.0]);
        background([0.3, 0.4, 0.6]);
    }
}

/// Milliseconds of the bounces after the ball is thrown.
const BOUNCES: [i32; 4] = [1600, 1200, 800, 400];

/// Milliseconds in which the camera turns by one degree while the ball bounces.
const DEGREE: i32 = 33;

/// Where the ball and the camera are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Camera when the ball was thrown, in degrees, and the sense in which it turns.
    azimuth: i32,
    sense: i32,
    /// Milliseconds since then.
    time: i32,
}

impl Motion {
    /// In the middle of the last bounce.
    pub const START: Self = Self {
        azimuth: 0,
        sense: 1,
        time: 3800,
    };

    /// Throws the ball. Until it rests, the camera turns in a sense, 1 or -1.
    pub fn throw(&mut self, sense: i32) {
        *self = Self {
            azimuth: self.turned(),
            sense,
            time: 0,
        };
    }

    /// Lets time pass. Nothing moves after the last bounce.
    pub fn advance(&mut self, milliseconds: i32) {
        self.time = BOUNCES.iter().sum::<i32>().min(self.time + milliseconds);
    }

    /// Tests whether the ball lies still.
    pub fn rests(&self) -> bool {
        self.height().is_none()
    }

    /// Height of the ball above the water; `None` at rest.
    fn height(&self) -> Option<i32> {
        let mut time = self.time;
        for length in BOUNCES {
            if time < length {
                return Some(time * (length - time) / 4000);
            }
            time -= length;
        }
        None
    }

    /// Direction of the camera in degrees.
    fn turned(&self) -> i32 {
        (self.azimuth + self.sense * self.time / DEGREE).rem_euclid(360)
    }

    /// Prepares the picture with so many reflections, of which each pixel covers `scale` by `scale` of
    /// the panel, and calls `work` with its rows.
    #[inline(never)]
    pub fn with_rows<R>(
        &self,
        reflections: u8,
        scale: u32,
        work: impl FnOnce(&Rows<'_, MovingScene<Bounce>>) -> R,
    ) -> R {
        let mut scene = MovingScene::<Bounce>::new();
        let height = 100 + self.height().unwrap_or(0);
        let moved = scene.set_sphere(Bounce::BALL, [0, 0, height], 100);
        moved.expect("the ball stays in its box");
        let camera = CAMERA.orbited(self.turned(), 0);
        let camera = camera.expect("the camera stays beside the ball");
        let frame = scene.frame(&camera).reflections(reflections);
        let frame = frame.prepare(Size::new_equal(SIDE / scale));
        work(&frame.on(&scene).expect("the scene has not changed"))
    }
}

/// Returns the areas of a picture in their order, for pixels of `scale` by `scale`. The first row of each
/// is traced. Only a picture with the pixels of the panel is coarse at first.
pub fn areas(scale: u32) -> impl Iterator<Item = Range<u32>> {
    let [moving, still] = if scale > 1 { [SIDE, 0] } else { [0, SIDE] };
    let moving = (0..moving).step_by(scale as usize);
    moving.map(move |y| y..y + scale).chain(coarse_first(still))
}
