//! The view: a scene and a camera. Knows no board.

use embedded_graphics::geometry::Size;
use reflet::Camera;
use reflet::scenes::{BuiltIn, Castle, NAMES, Visitor, visit};

use crate::cores::Rows;
use crate::keys::Request;
use crate::screen::{Line, SIDE};

/// One of the built-in scenes, and the camera through which it is drawn.
#[derive(Clone, Copy, PartialEq)]
pub struct View {
    scene: usize,
    camera: Camera,
}

impl View {
    /// The view after a reset.
    pub const FIRST: Self = Self {
        scene: 0,
        camera: Castle::CAMERA,
    };

    /// Returns the name of the scene.
    pub fn name(&self) -> &'static str {
        NAMES[self.scene]
    }

    /// Returns the view, scene and camera, that follows this one after a key was pressed.
    pub fn after(self, request: Request) -> Self {
        match request {
            Request::Orbit(azimuth, elevation) => {
                // A camera cannot look along its `up`: then it keeps its place.
                let camera = self
                    .camera
                    .orbited(azimuth, elevation)
                    .unwrap_or(self.camera);
                Self { camera, ..self }
            }
            Request::Select => self.next_scene(),
        }
    }

    /// Prepares the picture of the view and calls `work` with its rows.
    pub fn with_rows<R>(&self, work: impl FnOnce(&dyn Rows) -> R) -> R {
        let camera = &self.camera;
        visit(self.name(), WithRows { camera, work }).expect("the name is one of the list")
    }

    fn next_scene(self) -> Self {
        let scene = (self.scene + 1) % NAMES.len();
        let camera = visit(NAMES[scene], OwnCamera).unwrap_or(self.camera);
        Self { scene, camera }
    }
}

impl<S: BuiltIn> Rows for reflet::Rows<'_, S> {
    fn row(&self, y: u32, line: &mut Line) {
        line.fill(1, |colors| {
            self.row(y, 0, colors);
        });
    }
}

struct WithRows<'a, F> {
    camera: &'a Camera,
    work: F,
}

impl<R, F: FnOnce(&dyn Rows) -> R> Visitor for WithRows<'_, F> {
    type Output = R;

    /// Compiled once for each scene and never inlined, so that the stack holds the picture of one
    /// scene only.
    #[inline(never)]
    fn visit<S: BuiltIn>(self) -> R {
        let frame = S::frame(self.camera).prepare(Size::new(SIDE, SIDE));
        (self.work)(
            &frame
                .on(S::INSTANCE)
                .expect("a constant scene never changes"),
        )
    }
}

struct OwnCamera;

impl Visitor for OwnCamera {
    type Output = Camera;

    fn visit<S: BuiltIn>(self) -> Camera {
        S::CAMERA
    }
}
