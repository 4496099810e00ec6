//! What is shown: a scene and a camera. Knows no board.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use reflet::Camera;
use reflet::scenes::{BuiltIn, Castle, NAMES, Visitor, visit};

use crate::keys::Request;

/// The width and the height of the picture in pixels.
pub const SIDE: u32 = 240;

/// The pixels of one row.
pub type Row = [Rgb565; SIDE as usize];

/// A row before it is worked out.
pub const BLACK_ROW: Row = [Rgb565::BLACK; SIDE as usize];

/// One of the built-in scenes, seen through a camera.
#[derive(Clone, Copy)]
pub struct View {
    scene: usize,
    camera: Camera,
}

impl View {
    /// What is shown after a reset.
    pub const FIRST: Self = Self {
        scene: 0,
        camera: Castle::CAMERA,
    };

    /// The name of the scene.
    pub fn name(&self) -> &'static str {
        NAMES[self.scene]
    }

    /// The view that is asked for.
    pub fn after(self, request: Request) -> Self {
        match request {
            Request::Orbit(azimuth, elevation) => {
                // A camera cannot look along its `up`: there it stays.
                let camera = self
                    .camera
                    .orbited(azimuth, elevation)
                    .unwrap_or(self.camera);
                Self { camera, ..self }
            }
            Request::NextScene => self.next_scene(),
        }
    }

    /// Works out row `y`.
    pub fn row(&self, y: u32, row: &mut Row) {
        visit(
            self.name(),
            WorkOut {
                camera: &self.camera,
                y,
                row,
            },
        );
    }

    fn next_scene(self) -> Self {
        let scene = (self.scene + 1) % NAMES.len();
        let camera = visit(NAMES[scene], OwnCamera).unwrap_or(self.camera);
        Self { scene, camera }
    }
}

struct WorkOut<'a> {
    camera: &'a Camera,
    y: u32,
    row: &'a mut Row,
}

impl Visitor for WorkOut<'_> {
    type Output = ();

    /// Of every scene its own, so that the stack holds what one of them needs, not what all do.
    #[inline(never)]
    fn visit<S: BuiltIn>(self) {
        let picture = S::frame(self.camera).sized(Size::new(SIDE, SIDE));
        picture.row(self.y, 0, self.row);
    }
}

struct OwnCamera;

impl Visitor for OwnCamera {
    type Output = Camera;

    fn visit<S: BuiltIn>(self) -> Camera {
        S::CAMERA
    }
}
