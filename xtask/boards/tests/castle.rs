//! Each board draws the desk's picture of the castle, before and after keys are pressed.

mod common;

use boards::{Board, Key, Picture, Run, SIDE, Script};
use common::Package;
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::Camera;
use reflet::scenes::{BuiltIn, Castle, ShadingLights};

static PICO: Package = Package::new("examples/pico", "pico", "thumbv6m-none-eabi");
static PICO_2: Package = Package::new("examples/pico2", "pico2", "thumbv8m.main-none-eabihf");
static BLACK_PILL: Package =
    Package::new("examples/blackpill", "blackpill", "thumbv7em-none-eabihf");

/// Prints the counts: `cargo test -p boards -- --nocapture`.
fn report(board: &str, run: &Run) {
    for picture in &run.pictures {
        let (cycles, instructions) = (picture.cycles, picture.instructions);
        println!("{board}: {cycles} cycles, {instructions} instructions");
    }
    run.said
        .iter()
        .for_each(|line| println!("{board} said: {line}"));
}

/// Returns the picture on the desk.
fn simulated<S: BuiltIn>(camera: &Camera) -> Vec<u16> {
    let size = Size::new(SIDE as u32, SIDE as u32);
    let mut display = SimulatorDisplay::<Rgb565>::new(size);
    S::frame(camera).draw(&mut display).unwrap();
    let bytes = display.to_be_bytes();
    let pixels = bytes.chunks_exact(2);
    pixels
        .map(|it| u16::from_be_bytes([it[0], it[1]]))
        .collect()
}

/// Returns the number of pixels that differ.
fn different(shown: &Picture, expected: &[u16]) -> usize {
    assert_eq!(shown.pixels.len(), expected.len());
    let pairs = shown.pixels.iter().zip(expected);
    pairs.filter(|(shown, expected)| shown != expected).count()
}

/// Tests that a board draws the castle, and once more after a key has turned the camera.
fn test(name: &str, board: &Board, firmware: &Package, key: Key) {
    let script = Script::default().picture(&[]).picture(&[key]);
    let run = board.run(firmware.path(), &script).unwrap();
    report(name, &run);
    let turned = Castle::CAMERA.orbited(10, 0).unwrap();
    let cameras = [Castle::CAMERA, turned];
    assert_eq!(run.pictures.len(), cameras.len());
    for (picture, camera) in run.pictures.iter().zip(&cameras) {
        assert_eq!(different(picture, &simulated::<Castle>(camera)), 0);
    }
    assert!(run.said[0].starts_with("castle: "), "{:?}", run.said);
}

#[test]
fn both_cores_of_a_pico_2_draw_the_castle() {
    test("Pico 2", &Board::PICO_2, &PICO_2, Key::Right);
}

#[test]
fn black_pill_draws_the_castle() {
    test("Black Pill", &Board::BLACK_PILL, &BLACK_PILL, Key::Select);
}

#[test]
fn both_cores_of_a_pico_draw_the_castle() {
    let script = Script::default().picture(&[]).picture(&[Key::Select]);
    let run = Board::PICO.run(PICO.path(), &script).unwrap();
    report("Pico", &run);
    assert_eq!(run.said[0], "cores: 2");
    let castle = simulated::<Castle>(&Castle::CAMERA);
    assert_eq!(different(&run.pictures[0], &castle), 0);
    let lights = simulated::<ShadingLights>(&ShadingLights::CAMERA);
    assert_eq!(different(&run.pictures[1], &lights), 0);
}

#[test]
fn one_core_of_a_pico_draws_the_castle() {
    const ROWS: usize = 4;
    let script = Script::default().with_one_core().rows(ROWS).picture(&[]);
    let run = Board::PICO.run(PICO.path(), &script).unwrap();
    assert_eq!(run.said[0], "cores: 1");
    let drawn = ..ROWS * SIDE;
    let castle = simulated::<Castle>(&Castle::CAMERA);
    assert_eq!(run.pictures[0].pixels[drawn], castle[drawn]);
}
