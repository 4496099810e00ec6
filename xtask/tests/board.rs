//! Tests the default board in QEMU: its display shows the simulator's picture, pixel for pixel, also
//! after keys have been pressed. Faults on a board are named and never make a test hang.

use std::{
    fs,
    path::{Path, PathBuf},
    time::Duration,
};

use embedded_graphics::{geometry::Size, pixelcolor::Gray4};
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use image::RgbImage;
use reflet::scenes::{BuiltIn, Castle, Columns, Mirror1, ShadingLights};
use reflet::{Camera, Report};
use xtask::board::Board;
use xtask::emulator::qemu::{Failure, Key, Qemu};
use xtask::toolchain::{self, BareMetal};
use xtask::{board, root, size};

mod common;

/// Degrees by which an arrow key turns the camera.
const STEP: i32 = 10;

/// Returns the simulator's picture, enlarged as QEMU enlarges the display's.
fn simulated<S: BuiltIn>(camera: &Camera) -> RgbImage {
    let mut display = SimulatorDisplay::<Gray4>::new(Size::new(128, 64));
    common::draw::<S, _>(camera, &mut display);
    let settings = OutputSettingsBuilder::new().scale(4).build();
    let output = display.to_rgb_output_image(&settings);
    let buffer = output.as_image_buffer();
    RgbImage::from_raw(buffer.width(), buffer.height(), buffer.as_raw().to_vec()).unwrap()
}

fn assert_shows(board: &mut Board, expected: &RgbImage) {
    let shown = board.screen().unwrap();
    assert_eq!(shown.dimensions(), (512, 256));
    assert_eq!(shown.dimensions(), expected.dimensions());
    let dots = shown.enumerate_pixels().zip(expected.pixels());
    let wrong = dots.filter(|((_, _, shown), expected)| shown != expected);
    let wrong: Vec<_> = wrong.take(3).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn display_shows_the_simulators_picture_and_follows_the_keys() {
    let mut board = Board::boot(&board::build().unwrap()).unwrap();
    assert_shows(&mut board, &simulated::<Castle>(&Castle::CAMERA));

    board.press(Key::Right).unwrap();
    let turned = Castle::CAMERA.orbited(STEP, 0).unwrap();
    assert_shows(&mut board, &simulated::<Castle>(&turned));

    board.press(Key::Up).unwrap();
    let raised = turned.orbited(0, STEP).unwrap();
    assert_shows(&mut board, &simulated::<Castle>(&raised));

    board.press(Key::Left).unwrap();
    board.press(Key::Down).unwrap();
    let back = raised.orbited(-STEP, 0).unwrap().orbited(0, -STEP).unwrap();
    assert_shows(&mut board, &simulated::<Castle>(&back));

    let line = board.press(Key::Control).unwrap();
    assert!(line.starts_with("shading_lights: "), "{line}");
    let next = simulated::<ShadingLights>(&ShadingLights::CAMERA);
    assert_shows(&mut board, &next);
}

#[test]
fn select_key_leads_to_any_scene_and_around_to_the_first() {
    let mut board = Board::boot(&board::build().unwrap()).unwrap();
    board.go_to("mirror1").unwrap();
    assert_shows(&mut board, &simulated::<Mirror1>(&Mirror1::CAMERA));
    board.go_to("castle").unwrap();
    assert_shows(&mut board, &simulated::<Castle>(&Castle::CAMERA));
}

#[test]
fn report_counts_the_rays_of_the_picture() {
    let mut display = SimulatorDisplay::<Gray4>::new(Size::new(128, 64));
    let report = Castle::frame(&Castle::CAMERA).draw(&mut display).unwrap();
    let Report { rays, cut_off, .. } = report;
    let expected = format!("castle: {rays} rays, weight cut off {cut_off:.4}");
    let mut board = Board::boot(&board::build().unwrap()).unwrap();
    assert_eq!(board.go_to("castle").unwrap(), expected);
    let page = fs::read_to_string(root().join("examples/board/README.md")).unwrap();
    assert!(page.contains(&format!("\n{expected}\n")), "{expected}");
}

#[test]
fn picture_on_the_boards_page_is_what_it_shows() {
    let picture = image::open(root().join("docs/board.png")).unwrap();
    assert!(picture.to_rgb8() == simulated::<Castle>(&Castle::CAMERA));
}

#[test]
fn command_saves_what_the_display_shows_over_the_file_that_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("columns.png");
    std::fs::write(&path, "an older picture").unwrap();
    let arguments = format!("board columns --screenshot {}", path.display());
    let first = common::xtask(folder.path(), &arguments);
    assert_eq!(first.code, 0, "{}", first.err);
    assert!(first.out.contains("\ncolumns: "), "{}", first.out);
    let last = format!("written to {}\n", path.display());
    assert!(first.out.ends_with(&last), "{}", first.out);
    let saved = image::open(&path).unwrap().to_rgb8();
    assert!(saved == simulated::<Columns>(&Columns::CAMERA));
}

fn faulty(name: &str) -> PathBuf {
    let package = Path::new("xtask/faulty");
    toolchain::build_alone(toolchain::M3, package, &["--bin", name]).unwrap()
}

fn machine() -> Qemu {
    Qemu::arm("lm3s6965evb").limit(Duration::from_secs(20))
}

#[test]
fn hard_fault_is_named_with_its_cause() {
    let failure = machine().run(&faulty("hard_fault")).unwrap_err();
    assert!(matches!(failure, Failure::Fault { .. }), "{failure}");
    let words = failure.to_string();
    assert!(words.contains("exit status: 1"), "{words}");
    assert!(words.contains("so far, so good"), "{words}");
    let fault = "HardFault (undefined instruction) at 0x0000";
    assert!(words.contains(fault), "{words}");
}

#[test]
fn panic_is_repeated_with_its_message_and_place() {
    let failure = machine().run(&faulty("panic")).unwrap_err();
    let words = failure.to_string();
    assert!(words.contains("panicked at src/bin/panic.rs:"), "{words}");
    assert!(words.contains("out of tea"), "{words}");
}

#[test]
fn waiting_for_a_line_ends_with_the_panic() {
    let mut running = machine().boot(&faulty("panic")).unwrap();
    running.line(|line| line == "so far, so good").unwrap();
    let failure = running.line(|line| line == "tea").unwrap_err();
    assert!(failure.to_string().contains("out of tea"), "{failure}");
}

#[test]
fn core_stuck_in_a_fault_is_ended_and_the_fault_is_named() {
    let limit = Duration::from_secs(2);
    let failure = machine().limit(limit).run(&faulty("stuck")).unwrap_err();
    assert!(matches!(failure, Failure::TimeOut { .. }), "{failure}");
    let words = failure.to_string();
    let start = "the firmware was ended after 2 s: it is in HardFault at 0x0000";
    assert!(words.starts_with(start), "{words}");
}

#[test]
fn file_that_is_no_firmware_is_a_failure() {
    let manifest = root().join("Cargo.toml");
    let failure = machine().run(&manifest.with_file_name("no-such-firmware"));
    let words = failure.unwrap_err().to_string();
    assert!(words.contains("no-such-firmware"), "{words}");
}

#[test]
#[ignore = "long: compiles all that the board needs with other flags"]
fn board_without_its_linker_script_is_not_linked() {
    let target = toolchain::M3;
    let place = toolchain::alone_directory();
    let cargo = BareMetal::find().unwrap().cargo("build", &[target]);
    let cargo = cargo
        .args(["--quiet", "--locked", "--profile", "firmware"])
        .args(["--package", "reflet", "--example", size::BOARD])
        .args(["--target-dir".as_ref(), place.as_os_str()])
        // The script comes from the repository's configuration, which this variable replaces.
        .env("CARGO_ENCODED_RUSTFLAGS", "")
        .in_folder(root())
        .limit(Duration::from_secs(600));
    let words = cargo.read().unwrap_err().to_string();
    let reason = "undefined symbol: _stack_start";
    assert!(words.contains(reason), "{words}");
}
