//! Renders a picture of a scene: in fixed point, in double precision, or both to compare them.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Instant;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::host::compare::{Difference, compare};
use reflet::host::reference::{self, Picture};
use reflet::{Camera, Error, Report};

use crate::arguments::Arguments;
use crate::dither::Levels;
use crate::progress;
use command_line::{Failure, Settings, Source, exact};

/// The display, its PNG twice, and the reference take three bytes a pixel each.
const BYTES_OF_PIXEL: u64 = 4 * 3;

/// A picture and what is known about it.
pub struct Drawing {
    pub display: SimulatorDisplay<Rgb888>,
    /// Time for the picture alone, in seconds.
    pub seconds: f64,
    /// Report of the fixed-point renderer, if it rendered.
    pub report: Option<Report>,
    /// Difference of fixed point from the reference, if both rendered, and the samples of the reference along each
    /// side of a pixel.
    pub difference: Option<(Difference, u32)>,
}

impl Drawing {
    /// Renders what the command line asks for.
    pub fn new(source: &Source, arguments: &Arguments) -> Result<Self, Failure> {
        afford(arguments.size, BYTES_OF_PIXEL)?;
        let (scene, camera) = source.reference();
        let exactly = || {
            let Size { width, height } = arguments.size;
            let (reflections, shading) = (arguments.reflections.into(), arguments.shading);
            let shading = shading.into();
            let size = [width, height, arguments.samples()];
            let render = || reference::sampled(&scene, &camera, size, reflections, shading);
            progress::watch(None, |_| timed(render))
        };
        if arguments.reference && !arguments.check {
            let (picture, seconds) = exactly();
            let display = to_display(&picture);
            return Ok(Self {
                display,
                seconds,
                report: None,
                difference: None,
            });
        }
        let mut drawing =
            Self::in_fixed_point(source, &camera, arguments.size, arguments.settings())?;
        if arguments.check {
            let (picture, seconds) = exactly();
            let difference = compare(&to_picture(&drawing.display), &picture)?;
            drawing.difference = Some((difference, arguments.samples()));
            if arguments.reference {
                (drawing.display, drawing.seconds) = (to_display(&picture), seconds);
            }
        }
        Ok(drawing)
    }

    /// Renders in fixed point with any camera.
    pub fn in_fixed_point(
        source: &Source,
        camera: &reference::Camera,
        size: Size,
        settings: Settings,
    ) -> Result<Self, Error> {
        let camera = exact(camera)?;
        let mut display = SimulatorDisplay::new(size);
        let total = u64::from(size.height);
        let (report, seconds) = progress::watch(Some(total), |rows| {
            timed(|| draw(source, &camera, settings, &mut display, rows))
        });
        Ok(Self {
            display,
            seconds,
            report: Some(report),
            difference: None,
        })
    }

    /// Dithers the picture for a display, if `levels` is given.
    pub fn dithered(mut self, levels: Option<Levels>) -> Self {
        if let Some(levels) = levels {
            levels.dither(&mut self.display);
        }
        self
    }
}

/// Draws a scene through a camera, and counts the rows that are on the display.
pub fn draw(
    source: &Source,
    camera: &Camera,
    settings: Settings,
    display: &mut SimulatorDisplay<Rgb888>,
    rows: &AtomicU64,
) -> Report {
    let size = display.size();
    source.draw_rows(camera, size, settings, &mut |y, row| {
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(size.width, 1));
        let Ok(()) = display.fill_contiguous(&area, row.iter().copied());
        rows.fetch_add(1, Ordering::Relaxed);
    })
}

/// Refuses a size for which there is not enough memory. Otherwise the system would kill the program.
pub fn afford(size: Size, bytes_of_pixel: u64) -> Result<(), Failure> {
    let bytes = bytes_of_pixel * u64::from(size.width) * u64::from(size.height);
    let fits = |bytes| Vec::<u8>::new().try_reserve_exact(bytes).is_ok();
    if usize::try_from(bytes).is_ok_and(fits) {
        Ok(())
    } else {
        let (Size { width, height }, gigabytes) = (size, bytes.div_ceil(1_000_000_000));
        Err(format!("--size {width}x{height} needs {gigabytes} GB of memory").into())
    }
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let result = work();
    (result, started.elapsed().as_secs_f64())
}

fn to_picture(display: &SimulatorDisplay<Rgb888>) -> Picture {
    let Size { width, height } = display.size();
    let bytes = display.to_be_bytes();
    let pixels = bytes.chunks_exact(3).map(|it| [it[0], it[1], it[2]]);
    Picture {
        width,
        height,
        pixels: pixels.collect(),
    }
}

fn to_display(picture: &Picture) -> SimulatorDisplay<Rgb888> {
    let mut display = SimulatorDisplay::new(Size::new(picture.width, picture.height));
    let colors = picture.pixels.iter();
    let colors = colors.map(|&[red, green, blue]| Rgb888::new(red, green, blue));
    let Ok(()) = display.fill_contiguous(&display.bounding_box(), colors);
    display
}
