//! An animation: a golden ball bounces over water, and the camera orbits it. Lengths are in hundredths,
//! so that whole numbers do. On a board the same calls draw on its display.

use embedded_graphics::{draw_target::DrawTargetExt, prelude::*};
use embedded_graphics::{pixelcolor::Rgb565, primitives::Rectangle};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use reflet::{Camera, Material, MovingScene, scene};

const GOLD: Material = Material::new([0.9, 0.7, 0.1]).mirror(0.3);
const WATER: Material = Material::new([0.6, 0.8, 1.0]).diffuse(0.5).mirror(0.5);
const STONE: Material = Material::new([0.8, 0.3, 0.2]);
const CAMERA: Camera = Camera::look_at([0.0, -900.0, 400.0], [0.0, 0.0, 150.0], [0.0, 0.0, 1.0]);
const FRAMES: i32 = 8;
const SIDE: i32 = 120;

scene! {
    struct Bounce {
        motion([-100.0, -100.0, 0.0], [100.0, 100.0, 400.0]);
        sphere BALL([0.0, 0.0, 100.0], 100.0, GOLD);
        cylinder([250.0, 100.0, 100.0], [0.0, 0.0, 1.0], 50.0, 200.0, STONE);
        plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER);
        light([300.0, -400.0, 900.0], [1.0, 1.0, 1.0]);
        background([0.3, 0.4, 0.6]);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scene = MovingScene::<Bounce>::new();
    let mut strip = SimulatorDisplay::<Rgb565>::new(Size::new(960, 120));
    for time in 0..FRAMES {
        let height = 100 + 12 * time * (FRAMES - time);
        scene.set_sphere(Bounce::BALL, [0, 0, height], 100)?;
        let camera = CAMERA.orbited(10 * time, 0)?;
        let area = Rectangle::new(Point::new(SIDE * time, 0), Size::new(120, 120));
        scene.frame(&camera).draw(&mut strip.cropped(&area))?;
    }
    let image = strip.to_rgb_output_image(&OutputSettings::default());
    image.save_png("bounce.png")?;
    Ok(())
}
