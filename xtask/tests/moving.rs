//! Tests `cargo xtask measure --moving`: what a scene takes of which one shape moves.

use serde_json::Value;

mod common;

use common::Done;

fn xtask(arguments: &str) -> Done {
    let folder = tempfile::tempdir().unwrap();
    common::xtask(folder.path(), arguments)
}

fn measured(arguments: &str) -> Value {
    let done = xtask(&format!("measure --json --moving {arguments}"));
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    serde_json::from_str(&done.out).unwrap()
}

/// The command fails if the picture differs from that of the constant scene.
fn assert_takes_at_most_115_percent_of_the_constant_scenes_flash(scenes: &[&str]) {
    for arguments in scenes {
        let figures = measured(&format!("--size 16x16 {arguments}"));
        let number = |key: &str| figures[key].as_f64().unwrap();
        let share = number("flash") / number("constant_flash");
        assert!((1.0..=1.15).contains(&share), "{arguments}: {share}");
        // Only the ball is prepared again, and not the frame.
        let moved = number("move_instructions");
        assert!((100.0..4000.0).contains(&moved), "{arguments}: {moved}");
    }
}

#[test]
fn scene_with_one_ball_that_moves_takes_at_most_115_percent_of_the_constant_scenes_flash() {
    assert_takes_at_most_115_percent_of_the_constant_scenes_flash(&["castle"]);
}

#[test]
#[ignore = "long: another core and other scenes"]
fn scene_that_moves_on_a_small_core_takes_at_most_115_percent_of_the_constant_scenes_flash() {
    let scenes = ["mirror1", "primitives", "castle --core m0"];
    assert_takes_at_most_115_percent_of_the_constant_scenes_flash(&scenes);
}

#[test]
#[ignore = "long: another core"]
fn library_and_scene_of_the_boards_demo_take_at_most_56_kb_of_flash_on_a_small_core() {
    let file = xtask::root().join("examples/scenes/bounce.json");
    let figures = measured(&format!("--size 16x16 --core m0 {}", file.display()));
    let flash = figures["flash"].as_u64().unwrap();
    assert!(flash <= 56 << 10, "{flash}");
}

#[test]
fn without_a_sphere_a_cylinder_moves() {
    let Done { code, out, err } = xtask("measure --moving columns --size 16x16");
    assert_eq!((code, &*err), (0, ""));
    assert!(out.contains("\ninstructions of a move: "), "{out}");
}

#[test]
fn scene_in_which_nothing_can_move_is_refused_in_one_line() {
    let mistakes = "
measure floor --moving => nothing moves in floor: it has no sphere, cylinder or disc
measure --moving --quality float => nothing moves in the float port
measure --moving --all => cannot be used with
measure --moving --whole => cannot be used with";
    let folder = tempfile::tempdir().unwrap();
    common::assert_mistakes(folder.path(), mistakes);
}
