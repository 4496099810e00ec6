//! Compares the estimate of cycles with the count of another emulator.

use xtask::emulator::rp2040::Rp2040;
use xtask::measure::{Core, Quality, Scene, Size, Task, estimate, with_program};

fn reported(said: &[String], name: &str) -> f64 {
    let report = said.iter().find_map(|line| line.strip_prefix("measured "));
    let mut words = report.unwrap().split(' ');
    let digits = words.find_map(|word| word.strip_prefix(name)?.strip_prefix('='));
    u64::from_str_radix(digits.unwrap(), 16).unwrap() as f64
}

#[test]
fn estimate_for_m0_plus_is_within_10_percent_of_what_an_rp2040_counts() {
    assert_is_within_10_percent("castle");
}

#[test]
#[ignore = "long: the same of more scenes"]
fn estimate_is_as_good_for_other_scenes() {
    assert_is_within_10_percent("columns");
    assert_is_within_10_percent("shading_speculars");
}

fn assert_is_within_10_percent(scene: &'static str) {
    let (core, built_in) = (Core::find("m0").unwrap(), Scene::BuiltIn(scene));
    let task = Task::new(core, built_in, Size::new(8, 8), Quality::FAST);
    let estimate = estimate(&task).unwrap().unwrap();
    let run = |rp2040: Rp2040| {
        let said = with_program(&task, |program| Ok(rp2040.run(program)?.said));
        reported(
            &said.unwrap_or_else(|error| panic!("{error:#}")),
            "instructions",
        )
    };
    let cycles = run(Rp2040::default());
    let instructions = run(Rp2040::default().counting_instructions());
    println!("{scene}: {estimate:?}, {cycles} cycles, {instructions} instructions");
    assert!((estimate.cycles / cycles - 1.0).abs() < 0.1, "{scene}");
    // The estimate and the emulator count the same instructions, except for those of the calls.
    let seen = estimate.instructions as f64;
    assert!((seen / instructions - 1.0).abs() < 0.001, "{scene}");
}
