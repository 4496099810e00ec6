//! A scene that arrives as lines of text, such as over a serial line. A wrong scene is answered with one
//! line, and the old one stays on the display. `lines.rs` runs on a core without float as it is.

pub mod lines;

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use embedded_graphics_simulator::SimulatorDisplay;
use lines::{Shown, read};
use reflet::Camera;

/// What the serial line brings: a golden ball over water, then one with a radius below zero.
const RECEIVED: &str = "\
material 0.7 0.6 0 0.2 0.4 0.8 4 0.4
material 0.6 0.8 1 0.2 0.1 1 4 0.7
sphere 0 0 1 1 0
plane 0 0 0 0 0 1 1
light 3 -4 6 1 1 1
end
material 0.9 0.1 0.1 0.2 0.8 0 1 0
sphere 0 0 1 -1e0 0
light 3 -4 6 1 1 1
end
";

const CAMERA: Camera = Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);

pub fn main() {
    let mut serial = RECEIVED.lines();
    let mut scene = read(&mut serial).expect("the first scene is right");
    let first = picture(&scene);

    let answer = match read(&mut serial) {
        Ok(new) => {
            scene = new;
            "ok".to_owned()
        }
        Err((line, wrong)) => format!("line {line}: {wrong}"),
    };
    println!("{answer}");
    assert_eq!(answer, "line 2: sphere 0: radius must be greater than 0");
    assert_eq!(serial.next(), None, "the wrong scene is read to its end");
    assert!(picture(&scene) == first, "the old scene stays");
}

fn picture(scene: &Shown) -> SimulatorDisplay<Rgb565> {
    let mut display = SimulatorDisplay::new(Size::new(240, 240));
    let drawn = scene.frame(&CAMERA).reflections(4).draw(&mut display);
    drawn.expect("the simulator takes every pixel");
    display
}
