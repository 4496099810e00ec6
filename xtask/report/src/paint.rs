//! Pictures of a scene under a setting, drawn here: the same to the bit as on every core.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::SimulatorDisplay;
use float_picture::{Shading, render as render_in_f32};
use frame_hash::FrameHash;
use reflet::host::file::{FileScene, built};
use reflet::host::precision;
use reflet::host::reference::bound::Precision;
use reflet::host::reference::{self, Picture};
use reflet::{BlinnPhong, Camera, Enlarged, Frame, Quality, Unshadowed};

use crate::settings::{Contestant, Level, Setting, Visitor};
use command_line::{Kind, Source};

/// A scene ready to be painted.
///
/// Constant scenes are filled at run time here, and their pictures are the same to the bit; so one
/// type stands for all scenes.
pub struct Painter {
    name: String,
    world: Box<FileScene>,
    camera: Camera,
    /// The same in double precision.
    pub scene: reference::Scene,
    pub exact_camera: reference::Camera,
    pub size: Size,
}

impl Painter {
    pub fn new(source: Source, size: Size) -> Result<Self, command_line::Failure> {
        let (scene, exact_camera) = source.reference();
        let reference::Camera {
            position,
            target,
            up,
            fov,
        } = exact_camera.clone();
        Ok(Self {
            name: source.name().to_owned(),
            world: match source.kind {
                Kind::BuiltIn => built(&scene, &exact_camera)?,
                Kind::File(_, scene) => scene,
            },
            camera: Camera::new(position, target, up, fov)?,
            scene,
            exact_camera,
            size,
        })
    }

    /// What the scene is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The grid that the scene is laid on.
    pub fn precision(&self) -> Precision {
        precision(&*self.world)
    }

    /// Whether nothing but planes is in it.
    pub fn is_of_planes(&self) -> bool {
        self.scene.spheres.is_empty() && self.scene.cylinders.is_empty()
    }

    /// Whether a constant scene traces every pixel, whatever its quality says: nothing in it looks
    /// otherwise in another place.
    pub fn is_plain(&self) -> bool {
        !self.world.needs().places
    }

    /// The picture under a setting.
    pub fn paint(&self, setting: &Setting) -> Picture {
        let Contestant::Fixed { level, shadows } = setting.contestant else {
            return self.float(setting);
        };
        self.draw(setting, level, shadows, false)
    }

    /// The picture under a setting of fixed point with shadows and every pixel traced.
    pub fn paint_traced(&self, level: Level, reflections: u8) -> Picture {
        self.draw(&Setting::fixed(level, reflections), level, true, true)
    }

    fn draw(&self, setting: &Setting, level: Level, shadows: bool, traces_all: bool) -> Picture {
        let mut display = SimulatorDisplay::new(self.size);
        level.visit(Draw {
            frame: self.world.frame(&self.camera),
            setting,
            shadows,
            // As a constant scene does; the one here is filled at run time, and would not.
            traces_all: traces_all || self.is_plain(),
            display: &mut display,
        });
        let bytes = display.to_be_bytes();
        let pixels = bytes.chunks_exact(3).map(|it| [it[0], it[1], it[2]]);
        Picture {
            width: self.size.width,
            height: self.size.height,
            pixels: pixels.collect(),
        }
    }

    fn float(&self, setting: &Setting) -> Picture {
        let Size { width, height } = self.size;
        let scale = u32::from(setting.scale);
        let size = (width.div_ceil(scale), height.div_ceil(scale));
        let (shading, reflections) = (Shading::BlinnPhong, setting.reflections.into());
        let small = render_in_f32(&self.scene, &self.exact_camera, size, reflections, shading);
        let at = |x: u32, y: u32| small.pixels[(y / scale * size.0 + x / scale) as usize];
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        Picture {
            width,
            height,
            pixels: places.map(|(x, y)| at(x, y)).collect(),
        }
    }
}

/// The hash that a firmware reports of the same picture.
pub fn hash(picture: &Picture) -> String {
    let mut hash = FrameHash::NONE;
    picture.pixels.iter().for_each(|pixel| hash.add(*pixel));
    format!("{:016x}", hash.value())
}

struct Draw<'a> {
    frame: Frame<'a, &'a FileScene>,
    setting: &'a Setting,
    shadows: bool,
    traces_all: bool,
    display: &'a mut SimulatorDisplay<Rgb888>,
}

impl Visitor for Draw<'_> {
    type Output = ();

    fn visit<Q: Quality, T: Quality>(self) {
        match self.traces_all {
            true => drawn(
                self.frame.quality::<T>(),
                self.setting,
                self.shadows,
                self.display,
            ),
            false => drawn(
                self.frame.quality::<Q>(),
                self.setting,
                self.shadows,
                self.display,
            ),
        }
    }
}

fn drawn<Q: Quality>(
    frame: Frame<'_, &FileScene, Q>,
    setting: &Setting,
    shadows: bool,
    display: &mut SimulatorDisplay<Rgb888>,
) {
    let frame = frame.reflections(setting.reflections);
    let mut target = Enlarged::new(display, setting.scale.into());
    let Ok(_) = match shadows {
        true => frame.shading::<BlinnPhong>().draw(&mut target),
        false => frame.shading::<Unshadowed>().draw(&mut target),
    };
}
