//! Draws with every function that draws, moves every part that moves, and links only if none of them
//! can panic: the panic handler calls a function that does not exist.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use cortex_m_rt::entry;
use embedded_graphics::pixelcolor::{Gray4, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};
use reflet::display::AnyScene;
use reflet::display::{Dithered, Enlarged};
use reflet::needs::{Limited, MostReflections, Needs, NeedsLimit};
use reflet::quality::{Exact, Fast, Quality, Small};
use reflet::scenes::{BuiltIn, Castle, Floor};
use reflet::shading::{BlinnPhong, Normals, Phong, Shading, Unshadowed};
use reflet::{
    Camera, FrameBuilder, Material, MovingScene, Number, Report, RuntimeScene, Scene, room, scene,
};

#[entry]
fn main() -> ! {
    if cfg!(feature = "panic") {
        black_box(black_box(&[0][..])[black_box(0)]);
    } else if cfg!(feature = "float") {
        black_box(black_box(1.5_f32) * black_box(2.5_f32));
    } else {
        draw_in_all_ways();
    }
    loop {
        core::hint::spin_loop();
    }
}

fn draw_in_all_ways() {
    // A constant scene leaves out what it does not need; a scene filled at run time needs
    // everything.
    let camera = black_box(Castle::CAMERA);
    if let Ok(castle) = Limited::<_, MostReflections<0>>::new(&Castle) {
        draw::<Fast, BlinnPhong, _>(&castle, castle.frame(&camera));
    }
    draw::<Small, BlinnPhong, _>(&Castle, Castle::frame(&camera));
    draw::<Fast, BlinnPhong, _>(&Floor, Floor::frame(&camera));
    if let Some((scene, camera)) = fill() {
        draw::<Fast, BlinnPhong, _>(&scene, scene.frame(&camera));
        draw::<Exact, Phong, _>(&scene, scene.frame(&camera));
        draw::<Fast, Normals, _>(&scene, scene.frame(&camera));
        draw::<Small, BlinnPhong, _>(&scene, scene.frame(&camera));
        draw::<Small, Phong, _>(&scene, scene.frame(&camera));
        draw::<Fast, Unshadowed, _>(&scene, scene.frame(&camera));
        if let Ok(matte) = Limited::<_, Matte>::new(&scene) {
            draw::<Fast, BlinnPhong, _>(&matte, matte.frame(&camera));
        }
        seen(scene.frame(&camera).draw(&mut Dithered::new(&mut Display)));
    }
    if let Some(scene) = moved() {
        draw::<Fast, BlinnPhong, _>(&scene, scene.frame(&camera));
    }
    draw_within();
}

struct Matte;

impl NeedsLimit for Matte {
    const NEEDS: Needs = Needs::ALL.without_mirrors();
}

/// Draws a frame in every way. All numbers are hidden from the compiler, as if they came from
/// outside.
fn draw<Q: Quality, K: Shading, S: AnyScene>(scene: &S, frame: FrameBuilder<'_, S>) {
    let frame = frame.reflections(black_box(4));
    let frame = frame.quality::<Q>().shading::<K>();
    seen(frame.draw(&mut Display));
    seen(frame.draw(&mut Enlarged::new(&mut Display, black_box(3))));
    let frame = frame.prepare(black_box(Display.size()));
    let Ok(rows) = frame.on(scene) else {
        return;
    };
    let mut row = [Gray4::new(0); 16];
    let report = rows.row(black_box(7), black_box(5), &mut row);
    black_box(rows.cut_off_bound(&report));
    seen(Ok(report));
    black_box(row);
    let corner = black_box(Point::new(-5, 60));
    let whole = Rectangle::new(Point::zero(), rows.size());
    seen(rows.draw_area(whole, corner, &mut Display));
    let part = black_box(Rectangle::new(corner, Size::new(9, 9)));
    seen(rows.draw_area(part, corner, &mut Display));
}

fn draw_within() {
    const POINT: FrontPoint = FrontPoint {
        prepare: 1000,
        instructions: 100,
        reflections: 1,
        level: QualityLevel::Fast,
        scale: 2,
        psnr: 2000,
        largest: 200,
    };
    static FRONT: ParetoFront = ParetoFront::new(&[
        POINT,
        FrontPoint {
            instructions: 1000,
            level: QualityLevel::Exact,
            psnr: 4000,
            ..POINT
        },
    ]);
    let camera = black_box(Castle::CAMERA);
    let (front, budget) = (black_box(&FRONT), black_box(1 << 40));
    let frame = Castle::frame(&camera);
    let _ = black_box(frame.draw_within(front, budget, || black_box(false), &mut Display));
}

type Four = room!(
    spheres: 4,
    planes: 4,
    cylinders: 4,
    discs: 4,
    triangles: 4,
    lights: 4,
    materials: 4
);

/// Fills a scene, and makes and moves a camera, at run time.
fn fill() -> Option<(Scene<Four>, Camera)> {
    let number = || Number::from(black_box(1.5_f32));
    let read = black_box("1.5e0").parse::<Number>().ok()?;
    let point = || black_box([0.5_f64, 1.5, 2.5]);
    let mut scene = black_box(RuntimeScene::<Four>::new());
    let (color, highlight) = ([number(); 3], (number(), number()));
    let made = Material::from_numbers(color, number(), number(), highlight, number());
    let material = scene.add_material(made.ok()?).ok()?;
    let _ = black_box(scene.set_motion(point(), point()));
    let sphere = black_box(scene.add_sphere(point(), number(), material));
    let _ = black_box(scene.add_plane(point(), point(), material));
    let cylinder = black_box(scene.add_cylinder(point(), point(), number(), number(), material));
    let disc = black_box(scene.add_disc(point(), point(), number(), material));
    let corners = || [point(), point(), point()];
    let triangle = black_box(scene.add_triangle(corners(), black_box(Some(corners())), material));
    let light = black_box(scene.add_light(point(), [number(); 3]));
    let _ = black_box(scene.add_light_with_range(point(), [number(); 3], number()));
    let _ = black_box(scene.add_sun(point(), [number(); 3], number()));
    let _ = black_box(scene.set_background([number(); 3]));
    let checkered = CHALK.with_checker([number(); 3], [number(); 3]);
    let _ = black_box(checkered.map(|it| scene.add_material(it)));
    let _ = black_box(scene.set_sky([number(); 3], [[number(); 3]; 3]));
    let _ = black_box(scene.set_epsilon(read));
    let camera = Camera::new(point(), point(), point(), number());
    let camera = camera.and_then(|camera| camera.orbited(number(), number()));
    let mut scene = black_box(scene.build().ok()?);
    let sphere = sphere.ok()?;
    if let Ok(camera) = &camera {
        let areas = scene.frame(camera).areas_of(sphere, Size::new(64, 48));
        let _ = black_box(areas.map(|areas| areas.clone().with(&areas)));
    }
    let _ = black_box(scene.set_sphere(sphere, point(), number()));
    let _ = black_box(scene.set_cylinder(cylinder.ok()?, point(), point(), number(), number()));
    let _ = black_box(scene.set_disc(disc.ok()?, point(), point(), number()));
    let _ = black_box(scene.set_triangle(triangle.ok()?, corners(), black_box(Some(corners()))));
    let _ = black_box(scene.set_light(light.ok()?, point()));
    Some((black_box(scene), camera.ok()?))
}

const CHALK: Material = Material::new([0.9; 3]);

scene! {
    struct Bounce {
        motion([-1.0, -1.0, 0.0], [5.0, 5.0, 5.0]);
        sphere BALL([1.0, 1.0, 1.0], 1.0, CHALK);
        cylinder BARREL([2.0, 2.0, 2.0], [0.0, 0.0, 1.0], 1.0, 1.0, CHALK);
        disc LID([3.0, 3.0, 3.0], [0.0, 0.0, 1.0], 1.0, CHALK);
        triangle SAIL([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]],
            Some([[0.0, 0.0, 1.0], [0.5, 0.0, 1.0], [0.0, 0.5, 1.0]]), CHALK);
        light([3.0, -4.0, 9.0], [1.0, 1.0, 1.0]);
    }
}

fn moved() -> Option<MovingScene<Bounce>> {
    let number = || Number::from(black_box(1.5_f32));
    let point = || black_box([0.5_f64, 1.5, 2.5]);
    let mut scene = MovingScene::<Bounce>::new();
    scene.set_sphere(Bounce::BALL, point(), number()).ok()?;
    let barrel = scene.set_cylinder(Bounce::BARREL, point(), point(), number(), number());
    barrel.ok()?;
    let lid = scene.set_disc(Bounce::LID, point(), point(), number());
    lid.ok()?;
    let sail = scene.set_triangle(Bounce::SAIL, [point(); 3], black_box(None));
    sail.ok()?;
    Some(black_box(scene))
}

fn seen(report: Result<Report, Infallible>) {
    let _ = black_box(report);
}

/// A display that ignores all pixels.
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
