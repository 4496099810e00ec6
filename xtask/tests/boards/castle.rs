//! Each board draws the desk's picture of the castle, before and after keys are pressed.

use std::fs;

use boards::{Display, Key, Picture, Run, SIDE, Script};
use command_line::{Chosen, Source};
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::Camera;
use reflet::quality::Smooth;
use reflet::scenes::{BuiltIn, Castle, ShadingLights};
use xtask::measure::ledger;
use xtask::{copies, root};

use super::{BLACK_PILL, Copied, PICO, PICO_2, common};

fn simulated<S: BuiltIn>(camera: &Camera) -> Vec<u16> {
    simulated_source(&Source::built_in(S::NAME).unwrap(), camera)
}

fn simulated_source(source: &Source, camera: &Camera) -> Vec<u16> {
    let size = Size::new(SIDE as u32, SIDE as u32);
    let mut display = SimulatorDisplay::<Rgb565>::new(size);
    common::draw_source(source, camera, &mut display);
    pixels(&display)
}

/// Returns the pixels of a display on the desk.
pub fn pixels(display: &SimulatorDisplay<Rgb565>) -> Vec<u16> {
    let bytes = display.to_be_bytes();
    let pixels = bytes.chunks_exact(2).map(|it| [it[0], it[1]]);
    pixels.map(u16::from_be_bytes).collect()
}

fn different(shown: &Picture, expected: &[u16]) -> usize {
    assert_eq!(shown.pixels.len(), expected.len());
    let pairs = shown.pixels.iter().zip(expected);
    pairs.filter(|(shown, expected)| shown != expected).count()
}

pub fn assert_are_shown(copied: &Copied, run: &Run, expected: &[Vec<u16>]) {
    let name = copied.owned.name;
    let pairs = run.pictures.iter().zip(expected);
    let pixels = pairs.map(|(shown, expected)| different(shown, expected));
    assert_eq!(
        pixels.collect::<Vec<_>>(),
        vec![0; expected.len()],
        "{name}"
    );
    assert_eq!(run.pictures.len(), expected.len(), "{name}");
}

/// Tests that a board shows the pictures of the desk. The gate prints its instructions, cycles and seconds.
fn test(copied: &Copied, expected: &[Vec<u16>]) {
    let (run, time) = copied.ran();
    assert_are_shown(copied, run, expected);
    for bus in run.pictures.iter().map(|it| it.bus) {
        assert!(bus.hidden() >= 0.9, "{bus:?}");
    }
    let did = format!(
        "{}: 0 pixels differ in {} pictures, {} instructions, {} cycles",
        copied.owned.name,
        run.pictures.len(),
        run.instructions,
        run.cycles
    );
    ledger::note_board(*time, &did);
}

/// Tests that a board draws the castle, and once more after a key has turned the camera.
fn test_castle(copied: &Copied) {
    let turned = Castle::CAMERA.orbited(10, 0).unwrap();
    let cameras = [Castle::CAMERA, turned];
    test(copied, &cameras.map(|camera| simulated::<Castle>(&camera)));
    let said = &copied.run().said;
    assert!(said[0].starts_with("picture: "), "{said:?}");
}

#[test]
fn both_cores_of_a_pico_2_draw_the_castle() {
    test_castle(&PICO_2);
}

#[test]
fn black_pill_draws_the_castle() {
    test_castle(&BLACK_PILL);
}

/// Returns the picture of a scene file on the desk.
fn simulated_file(file: &str) -> Vec<u16> {
    let path = root().join("examples/scenes").join(file);
    let source = Source::open(&path, &Chosen::default()).unwrap();
    simulated_source(&source, &source.camera())
}

#[test]
fn smallest_firmware_of_a_pico_draws_a_ball_over_water() {
    let firmware = copies::program("pico", "ball").unwrap();
    let script = Script::default().limit(3).picture(&[]);
    let run = PICO.board().run(&firmware, &script);
    assert_are_shown(&PICO, &run.unwrap(), &[simulated_file("harbour.json")]);
    let folder = root().join("examples/pico/src/bin/ball");
    let files = ["main.rs", "scene.rs"].map(|file| fs::read_to_string(folder.join(file)).unwrap());
    assert!(files.concat().lines().count() <= 60);
    assert_eq!(files[1], scene_source("harbour"));
}

/// Returns what `cargo xtask scene` prints.
fn scene_source(name: &str) -> String {
    let done = common::xtask(&root(), &format!("scene examples/scenes/{name}.json"));
    assert_eq!(done.code, 0, "{}", done.err);
    done.out
}

#[test]
#[ignore = "builds two examples once more"]
fn scene_of_a_user_takes_one_changed_line() {
    for copied in [&PICO_2, &BLACK_PILL] {
        let name = copied.owned.name;
        let firmware = copies::build_with_scene(name, &scene_source("matt3"), "Matt3").unwrap();
        let script = Script::default().picture(&[]);
        let run = copied.board().run(&firmware, &script);
        assert_are_shown(copied, &run.unwrap(), &[simulated_file("matt3.json")]);
    }
}

#[test]
fn both_cores_of_a_pico_draw_the_castle_and_follow_the_keys() {
    assert_eq!(PICO.run().said[0], "cores: 2");
    let turned = ShadingLights::CAMERA.orbited(10, 0).unwrap();
    let turned = turned.orbited(10, 0).unwrap();
    let expected = [
        simulated::<Castle>(&Castle::CAMERA),
        simulated::<ShadingLights>(&turned.orbited(0, 10).unwrap()),
    ];
    test(&PICO, &expected);
}

#[test]
fn key_that_is_pressed_first_of_all_counts() {
    let script = Script::default().rows(1).picture(&[Key::Select]);
    let run = PICO.board().run(PICO.firmware(), &script).unwrap();
    let expected = simulated::<ShadingLights>(&ShadingLights::CAMERA);
    assert_eq!(run.pictures[0].pixels[..SIDE], expected[..SIDE]);
}

#[test]
fn one_core_of_a_pico_draws_the_castle() {
    const ROWS: usize = 4;
    let script = Script::default().with_one_core().rows(ROWS).picture(&[]);
    let run = PICO.board().run(PICO.firmware(), &script).unwrap();
    assert_eq!(run.said[0], "cores: 1");
    // The picture is coarse at first: its first row covers four.
    let castle = simulated::<Castle>(&Castle::CAMERA);
    let drawn = &run.pictures[0].pixels[..ROWS * SIDE];
    assert_eq!(drawn, castle[..SIDE].repeat(ROWS));
}

/// A press may come at any instruction of the loop that waits for it.
#[test]
#[ignore = "draws the castle 26 times"]
fn no_press_of_a_key_is_lost() {
    let script = Script::default().picture(&[]);
    let script = (0..25).fold(script, |all, _| all.picture(&[Key::Right]));
    let run = PICO_2.board().run(PICO_2.firmware(), &script).unwrap();
    assert_eq!(run.pictures.len(), 26);
}

#[test]
#[ignore = "builds the castle once more and draws it twice"]
fn select_key_makes_edges_smooth() {
    let script = Script::default().picture(&[]).picture(&[Key::Select]);
    let firmware = copies::program_with(PICO_2.owned.name, "castle", "smooth").unwrap();
    let run = PICO_2.board().run(&firmware, &script).unwrap();
    println!("{:?}", run.said);
    let mut smooth = SimulatorDisplay::<Rgb565>::new(Size::new(SIDE as u32, SIDE as u32));
    let frame = Castle::frame(&Castle::CAMERA).quality::<Smooth<2>>();
    let Ok(_) = frame.draw(&mut smooth);
    let jagged = simulated::<Castle>(&Castle::CAMERA);
    assert_are_shown(&PICO_2, &run, &[jagged, pixels(&smooth)]);
}

#[test]
fn panels_are_set_up_as_their_maker_wants_it() {
    let expected = Display {
        inverted: true,
        address_mode: 0b0110_0000,
    };
    for copied in [&PICO, &PICO_2, &BLACK_PILL] {
        assert_eq!(copied.run().display, expected, "{}", copied.owned.name);
    }
}
