//! The smallest picture: a golden ball over water. On a board the same calls draw on its display.

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use reflet::{Camera, Material, scene};

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .diffuse(0.4)
    .specular(0.8, 4.0)
    .mirror(0.4);
const WATER: Material = Material::new([0.6, 0.8, 1.0]).diffuse(0.1).mirror(0.7);
const CAMERA: Camera = Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);

scene! {
    struct Harbour {
        sphere([0.0, 0.0, 1.0], 1.0, GOLD);
        plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER);
        light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
        background([0.3, 0.4, 0.6]);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(240, 240));
    let report = Harbour::frame(&CAMERA).reflections(4).draw(&mut display)?;
    let image = display.to_rgb_output_image(&OutputSettings::default());
    image.save_png("harbour.png")?;
    println!("harbour.png: {report}");
    Ok(())
}
