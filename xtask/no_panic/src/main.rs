//! Draws in every way there is, and links only if nothing of it can panic: the panic handler calls
//! a function that nobody wrote.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use cortex_m_rt::entry;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::{Gray4, Rgb565},
    primitives::Rectangle,
};
use reflet::{
    BlinnPhong, Camera, Enlarged, Fast, Fine, Front, FrontPoint, Grade, Material, Normals, Number,
    Phong, Quality, Report, RuntimeScene, Shading, StaticFrame, Unshadowed,
    scenes::{BuiltIn, Castle},
};

#[entry]
fn main() -> ! {
    draw::<Fast, BlinnPhong>();
    draw::<Fast, Phong>();
    draw::<Fast, Normals>();
    draw::<Fine, BlinnPhong>();
    draw::<Fine, Phong>();
    draw::<Fine, Normals>();
    draw::<Fast, Unshadowed>();
    draw_within();
    fill();
    #[cfg(feature = "panic")]
    black_box(black_box(&[0][..])[black_box(0)]);
    #[cfg(feature = "float")]
    black_box(black_box(1.5_f32) * black_box(2.5_f32));
    loop {
        core::hint::spin_loop();
    }
}

/// The camera and all numbers are hidden from the compiler, as if they came from outside.
fn draw<Q: Quality, K: Shading>() {
    let camera = black_box(Castle::CAMERA);
    let frame = Castle::frame(&camera).reflections(black_box(4));
    let frame = frame.quality::<Q>().shading::<K>();
    seen(frame.draw(&mut Display));
    seen(frame.draw(&mut Enlarged::new(&mut Display, black_box(3))));
    let picture = frame.sized(black_box(Display.size()));
    let mut row = [Gray4::new(0); 16];
    let report = picture.row(black_box(7), black_box(5), &mut row);
    black_box(picture.cut_off_bound(&report));
    seen(Ok(report));
    black_box(row);
    let corner = black_box(Point::new(-5, 60));
    seen(picture.draw_at(corner, &mut Display));
    seen(picture.draw_area(
        black_box(Rectangle::new(corner, Size::new(9, 9))),
        corner,
        &mut Display,
    ));
}

/// A frame with a budget.
fn draw_within() {
    const POINT: FrontPoint = FrontPoint {
        instructions: 100,
        reflections: 1,
        grade: Grade::Fast,
        scale: 2,
        psnr: 2000,
        largest: 200,
    };
    static FRONT: Front = Front::new(&[
        POINT,
        FrontPoint {
            instructions: 1000,
            grade: Grade::Fine,
            psnr: 4000,
            ..POINT
        },
    ]);
    let camera = black_box(Castle::CAMERA);
    let (front, budget) = (black_box(&FRONT), black_box(1 << 40));
    let frame = Castle::frame(&camera);
    let _ = black_box(frame.draw_within(front, budget, || black_box(false), &mut Display));
}

/// A scene that is filled, and a camera that is made and moved, while the program runs.
fn fill() {
    let number = || Number::from(black_box(1.5_f32));
    let point = || black_box([0.5_f64, 1.5, 2.5]);
    let mut scene = black_box(RuntimeScene::<4, 4, 4, 4, 4>::new());
    let made = Material::from_numbers(
        [number(); 3],
        number(),
        number(),
        (number(), number()),
        number(),
    );
    let Ok(material) = made else { return };
    let Ok(material) = scene.add_material(material) else {
        return;
    };
    let _ = black_box(scene.add_sphere(point(), number(), material));
    let _ = black_box(scene.add_plane(point(), point(), material));
    let _ = black_box(scene.add_cylinder(point(), point(), number(), number(), material));
    let _ = black_box(scene.add_light(point(), [number(); 3]));
    let _ = black_box(scene.set_background([number(); 3]));
    let _ = black_box(scene.set_epsilon(number()));
    let camera = Camera::new(point(), point(), point(), number());
    let camera = camera.and_then(|camera| camera.orbited(number(), number()));
    if let (Ok(scene), Ok(camera)) = (scene.build(), camera) {
        seen(black_box(scene).frame(&camera).draw(&mut Display));
    }
}

fn seen(report: Result<Report, Infallible>) {
    let _ = black_box(report);
}

/// Takes any picture and shows none.
struct Display;

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        black_box(Size::new(240, 240))
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for pixel in pixels {
            black_box(pixel);
        }
        Ok(())
    }
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    unsafe extern "C" {
        safe fn a_panic_path_is_left() -> !;
    }
    a_panic_path_is_left()
}
