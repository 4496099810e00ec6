//! The smallest picture: a golden ball over water. On a board the same calls draw on its display.

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use reflet::{Camera, Material, Scene, room};

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .ambient(0.2)
    .diffuse(0.4)
    .specular(0.8, 4.0)
    .mirror(0.4);
const WATER: Material = Material::new([0.6, 0.8, 1.0])
    .ambient(0.2)
    .diffuse(0.1)
    .specular(1.0, 4.0)
    .mirror(0.7);

struct Harbour;

impl StaticScene for Harbour {
    type Scene = Scene<room!(spheres: 1, planes: 1, lights: 1)>; // spheres, planes, cylinders, lights
    const SCENE: &'static Self::Scene = &Scene::builder()
        .sphere([0.0, 0.0, 1.0], 1.0, GOLD)
        .plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER)
        .light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0])
        .background([0.3, 0.4, 0.6])
        .build();
}

const CAMERA: Camera = Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 240));
    let report = Harbour::frame(&CAMERA).reflections(4).draw(&mut display)?;
    display
        .to_rgb_output_image(&OutputSettings::default())
        .save_png("harbour.png")?;
    println!(
        "harbour.png: {} rays, weight cut off {:.4}",
        report.rays, report.cut_off
    );
    Ok(())
}
