//! Tests the firmware of examples/pico on an emulated RP2040: its ST7789 shows the simulator's
//! picture.

use std::{fs, path::PathBuf, sync::OnceLock};

use embedded_graphics::{geometry::Size, pixelcolor::Rgb565};
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::Camera;
use reflet::scenes::{BuiltIn, Castle, ShadingLights};
use xtask::copies;
use xtask::emulator::rp2040::{Display, Key, Rp2040, SIDE};

fn firmware() -> &'static PathBuf {
    // A copy of the example, as a person takes it.
    static FIRMWARE: OnceLock<PathBuf> = OnceLock::new();
    FIRMWARE.get_or_init(|| copies::build("pico").unwrap())
}

fn simulated<S: BuiltIn>(camera: &Camera) -> Vec<u16> {
    let mut display = SimulatorDisplay::<Rgb565>::new(Size::new(SIDE, SIDE));
    S::frame(camera).draw(&mut display).unwrap();
    let bytes = display.to_be_bytes();
    let pixels = bytes.chunks_exact(2);
    pixels
        .map(|it| u16::from_be_bytes([it[0], it[1]]))
        .collect()
}

/// Compares two pictures row by row, so that a failure names the first row that differs.
fn assert_equal(shown: &[u16], expected: &[u16]) {
    assert_eq!(shown.len(), expected.len());
    let expected = expected.chunks(SIDE as usize);
    for (y, (shown, expected)) in shown.chunks(SIDE as usize).zip(expected).enumerate() {
        assert_eq!(shown, expected, "row {y}");
    }
}

#[test]
fn both_cores_draw_the_castle() {
    let run = Rp2040::default().picture(&[]).run(firmware()).unwrap();
    assert_eq!(run.said[0], "cores: 2");
    assert!(run.said[1].starts_with("castle: "), "{:?}", run.said);
    assert_equal(
        &run.pictures[0].pixels,
        &simulated::<Castle>(&Castle::CAMERA),
    );
}

#[test]
fn one_core_draws_the_castle() {
    const ROWS: u32 = 4;
    let chip = Rp2040::default().with_one_core().rows(ROWS);
    let run = chip.picture(&[]).run(firmware()).unwrap();
    assert_eq!(run.said, ["cores: 1"]);
    let expected = simulated::<Castle>(&Castle::CAMERA);
    let drawn = ..(ROWS * SIDE) as usize;
    assert_equal(&run.pictures[0].pixels[drawn], &expected[drawn]);
}

#[test]
fn keys_change_the_scene_and_orbit_the_camera() {
    let chip = Rp2040::default().picture(&[Key::Select]);
    let chip = chip.picture(&[Key::Right, Key::Right, Key::Up]);
    let run = chip.run(firmware()).unwrap();
    let first = ShadingLights::CAMERA;
    let turned = first.orbited(10, 0).unwrap().orbited(10, 0).unwrap();
    let second = turned.orbited(0, 10).unwrap();
    assert_equal(&run.pictures[0].pixels, &simulated::<ShadingLights>(&first));
    assert_equal(
        &run.pictures[1].pixels,
        &simulated::<ShadingLights>(&second),
    );
    assert_ne!(run.pictures[0].pixels, run.pictures[1].pixels);
}

#[test]
fn panel_is_set_up_as_its_maker_wants_it() {
    let chip = Rp2040::default().picture(&[]).rows(2);
    let expected = Display {
        inverted: true,
        address_mode: 0b0110_0000,
    };
    assert_eq!(chip.run(firmware()).unwrap().display, expected);
}

/// Returns an ELF file with these instructions at the start of the RP2040's flash.
fn program(instructions: &[u16]) -> Vec<u8> {
    const ADDRESS: u32 = 0x1000_0100;
    let vectors = [0x2000_1000, ADDRESS + 9];
    let code = instructions.iter().flat_map(|it| it.to_le_bytes());
    let image: Vec<u8> = vectors
        .into_iter()
        .flat_map(u32::to_le_bytes)
        .chain(code)
        .collect();
    let magic = [0x464c_457f, 0x0001_0101, 0, 0];
    let header = [0x0028_0002, 1, ADDRESS + 9, 52, 0, 0, 0x0020_0034, 1, 0];
    let segment = [
        1,
        84,
        ADDRESS,
        ADDRESS,
        image.len() as u32,
        image.len() as u32,
        5,
        4,
    ];
    let words = magic.into_iter().chain(header).chain(segment);
    words.flat_map(u32::to_le_bytes).chain(image).collect()
}

fn failure(instructions: &[u16]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("program");
    fs::write(&path, program(instructions)).unwrap();
    let run = Rp2040::default().limit(1_000_000).run(&path);
    run.unwrap_err().to_string()
}

#[test]
fn undefined_instruction_is_named() {
    let failure = failure(&[0xde00]);
    assert_eq!(
        failure,
        "the firmware failed: breakpoint or undefined instruction in 0x1000010a"
    );
}

#[test]
fn memory_that_is_not_there_is_named() {
    // r0 = 0xf0 << 24; r0 = the word at r0
    let failure = failure(&[0x20f0, 0x0600, 0x6800]);
    let expected = "the firmware failed: Read from invalid memory address: f0000000 in 0x1000010e";
    assert_eq!(failure, expected);
}

#[test]
fn firmware_that_does_not_end_is_ended() {
    let failure = failure(&[0xe7fe]);
    assert_eq!(
        failure,
        "the firmware failed: the limit of cycles was reached"
    );
}
