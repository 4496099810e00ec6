//! The view: a scene, a camera, and whether edges are smooth. Knows no board.

use embedded_graphics::geometry::Size;
use reflet::Camera;
use reflet::quality::{Fast, Quality, Smooth};
use reflet::scenes::{BuiltIn, Castle, NAMES, Visitor, visit};

use crate::keys::Request;
use crate::screen::{Line, SIDE};

/// One of the built-in scenes, the camera through which it is drawn, and how.
#[derive(Clone, Copy, PartialEq)]
pub struct View {
    scene: usize,
    camera: Camera,
    is_smooth: bool,
}

impl View {
    /// The view after a reset.
    pub const FIRST: Self = Self {
        scene: 0,
        camera: Castle::CAMERA,
        is_smooth: false,
    };

    /// Returns the name of the scene.
    pub fn name(&self) -> &'static str {
        NAMES[self.scene]
    }

    /// Returns the view that follows this one after a key was pressed.
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
            Request::NextScene => self.next_scene(),
            Request::Smooth => Self {
                is_smooth: !self.is_smooth,
                ..self
            },
        }
    }

    /// Prepares the picture of the view and calls `work` with its rows.
    pub fn with_rows<R>(&self, work: impl FnOnce(&dyn Rows) -> R) -> R {
        let Self {
            camera, is_smooth, ..
        } = self;
        let work = WithRows {
            camera,
            is_smooth: *is_smooth,
            work,
        };
        visit(self.name(), work).expect("the name is one of the list")
    }

    fn next_scene(self) -> Self {
        let scene = (self.scene + 1) % NAMES.len();
        let camera = visit(NAMES[scene], OwnCamera).unwrap_or(self.camera);
        Self {
            scene,
            camera,
            ..self
        }
    }
}

/// Rows of a prepared picture, whatever its scene.
pub trait Rows {
    /// Traces row `y`.
    fn row(&self, y: u32, line: &mut Line);
}

impl<S: BuiltIn, Q: Quality> Rows for reflet::Rows<'_, S, Q> {
    fn row(&self, y: u32, line: &mut Line) {
        line.fill(1, |colors| {
            self.row(y, 0, colors);
        });
    }
}

struct WithRows<'a, F> {
    camera: &'a Camera,
    is_smooth: bool,
    work: F,
}

impl<F> WithRows<'_, F> {
    /// Draws a scene in a quality. Compiled once for each scene and quality and never inlined, so that the
    /// stack holds one picture only.
    #[inline(never)]
    fn draw<S: BuiltIn, Q: Quality, R>(self) -> R
    where
        F: FnOnce(&dyn Rows) -> R,
    {
        let frame = S::frame(self.camera).quality::<Q>();
        let frame = frame.prepare(Size::new(SIDE, SIDE));
        let rows = frame.on(S::INSTANCE);
        (self.work)(&rows.expect("a constant scene never changes"))
    }
}

impl<R, F: FnOnce(&dyn Rows) -> R> Visitor for WithRows<'_, F> {
    type Output = R;

    fn visit<S: BuiltIn>(self) -> R {
        match self.is_smooth {
            true => self.draw::<S, Smooth<2>, R>(),
            false => self.draw::<S, Fast, R>(),
        }
    }
}

struct OwnCamera;

impl Visitor for OwnCamera {
    type Output = Camera;

    fn visit<S: BuiltIn>(self) -> Camera {
        S::CAMERA
    }
}
