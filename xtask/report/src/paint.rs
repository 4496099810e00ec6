//! Draws the pictures of a scene under a setting on this machine. They are the same to the bit on
//! every core.

use std::marker::PhantomData;

use anyhow::Result;
use command_line::Source;
use embedded_graphics::geometry::Size;
use float_picture::{Shading, render as render_in_f32};
use frame_hash::FrameHash;
use reflet::Unit;
use reflet::host::reference::{self, Picture};
use reflet::quality::{Fast, Quality};
use reflet::shading::{BlinnPhong, Unshadowed};
use xtask::sweep::{Contestant, Level, Setting, Visitor};

/// A scene that is ready to be drawn under any setting.
pub struct Painter {
    pub name: String,
    pub source: Source,
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
            source,
            scene,
            exact_camera,
            size,
        })
    }

    pub fn paint(&self, setting: &Setting) -> Picture {
        let Size { width, height } = self.size;
        let scale = u32::from(setting.scale);
        let size = Size::new(width.div_ceil(scale), height.div_ceil(scale));
        let (source, reflections) = (&self.source, setting.reflections);
        let small = match setting.contestant {
            Contestant::Fixed(level) => level.visit(Draw {
                source,
                size,
                reflections,
                traces_all: false,
            }),
            Contestant::Unshadowed => source.painted::<Fast, Unshadowed>(size, reflections),
            Contestant::Float => {
                let (scene, camera) = (&self.scene, &self.exact_camera);
                let (size, shading) = (size.into(), Shading::BlinnPhong);
                render_in_f32(scene, camera, size, reflections.into(), shading)
            }
        };
        let at = |x: u32, y: u32| small.pixels[(y / scale * size.width + x / scale) as usize];
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Picture {
            width,
            height,
            pixels: places.map(|(x, y)| at(x, y)).collect(),
        }
    }

    /// Returns the fixed-point picture with shadows if every pixel is traced, and none interpolated.
    pub fn paint_traced(&self, level: Level, reflections: u8) -> Picture {
        level.visit(Draw {
            source: &self.source,
            size: self.size,
            reflections,
            traces_all: true,
        })
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
    source: &'a Source,
    size: Size,
    reflections: u8,
    traces_all: bool,
}

impl Visitor for Draw<'_> {
    type Output = Picture;

    fn visit<Q: Quality>(self) -> Picture {
        let Draw {
            source,
            size,
            reflections,
            traces_all,
        } = self;
        match traces_all {
            true => source.painted::<Traced<Q>, BlinnPhong>(size, reflections),
            false => source.painted::<Q, BlinnPhong>(size, reflections),
        }
    }
}
