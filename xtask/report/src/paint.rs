//! Draws the pictures of a scene under a setting on this machine. They are the same to the bit on
//! every core.

use std::marker::PhantomData;

use anyhow::Result;
use command_line::Source;
use embedded_graphics::geometry::Size;
use float_picture::{Shading, render as render_in_f32};
use frame_hash::FrameHash;
use reflet::host::file::FileScene;
use reflet::host::painted;
use reflet::host::reference::{self, Picture};
use reflet::quality::Quality;
use reflet::shading::{self, BlinnPhong, Unshadowed};
use reflet::{Camera, FrameBuilder, Unit};
use xtask::sweep::{Contestant, Level, Setting, Visitor};

/// A scene that is ready to be drawn under any setting.
pub struct Painter {
    pub name: String,
    pub world: Box<FileScene>,
    camera: Camera,
    /// The scene in double precision.
    pub scene: reference::Scene,
    pub exact_camera: reference::Camera,
    pub size: Size,
}

impl Painter {
    pub fn new(source: Source, size: Size) -> Result<Self> {
        let (scene, exact_camera) = source.reference();
        Ok(Self {
            name: source.name().to_owned(),
            camera: source.camera(),
            world: source.into_scene(),
            scene,
            exact_camera,
            size,
        })
    }

    pub fn paint(&self, setting: &Setting) -> Picture {
        self.draw(setting, false)
    }

    /// Returns the picture in fixed point with shadows, where every pixel is traced instead of
    /// interpolated.
    pub fn paint_traced(&self, level: Level, reflections: u8) -> Picture {
        self.draw(&Setting::fixed(level, reflections), true)
    }

    fn draw(&self, setting: &Setting, traces_all: bool) -> Picture {
        let Size { width, height } = self.size;
        let scale = u32::from(setting.scale);
        let size = Size::new(width.div_ceil(scale), height.div_ceil(scale));
        let reflections = setting.reflections;
        let small = match setting.contestant {
            Contestant::Fixed { level, shadows } => level.visit(Draw {
                scene: &self.world,
                frame: self.world.frame(&self.camera).reflections(reflections),
                size,
                shadows,
                traces_all,
            }),
            Contestant::Float => {
                let (scene, camera) = (&self.scene, &self.exact_camera);
                let (size, shading) = (size.into(), Shading::BlinnPhong);
                render_in_f32(scene, camera, size, reflections.into(), shading).pixels
            }
        };
        let at = |x: u32, y: u32| small[(y / scale * size.width + x / scale) as usize];
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Picture {
            width,
            height,
            pixels: places.map(|(x, y)| at(x, y)).collect(),
        }
    }
}

/// Returns the hash that a firmware reports for the same picture.
pub fn hash(picture: &Picture) -> u64 {
    let mut hash = FrameHash::NONE;
    picture.pixels.iter().for_each(|pixel| hash.add(*pixel));
    hash.value()
}

/// A quality like `Q`, but with a tolerance of 0: every pixel is traced.
struct Traced<Q>(PhantomData<Q>);

impl<Q: Quality> Quality for Traced<Q> {
    const SMALLEST_WEIGHT: Unit = Q::SMALLEST_WEIGHT;
    const TOLERANCE: Unit = Unit::ZERO;
    const IS_SMALL: bool = Q::IS_SMALL;
    const IS_PRECISE: bool = Q::IS_PRECISE;
}

struct Draw<'a> {
    scene: &'a FileScene,
    frame: FrameBuilder<'a, FileScene>,
    size: Size,
    shadows: bool,
    traces_all: bool,
}

impl Visitor for Draw<'_> {
    type Output = Vec<[u8; 3]>;

    fn visit<Q: Quality>(self) -> Self::Output {
        match self.traces_all {
            true => self.pixels::<Traced<Q>>(),
            false => self.pixels::<Q>(),
        }
    }
}

impl Draw<'_> {
    fn pixels<Q: Quality>(self) -> Vec<[u8; 3]> {
        match self.shadows {
            true => self.shaded::<Q, BlinnPhong>(),
            false => self.shaded::<Q, Unshadowed>(),
        }
    }

    fn shaded<Q: Quality, K: shading::Shading>(self) -> Vec<[u8; 3]> {
        let frame = self.frame.quality::<Q>().shading::<K>();
        let frame = frame.prepare(self.size);
        let rows = frame.on(self.scene).expect("the frame is this scene's");
        painted(&rows).pixels
    }
}
