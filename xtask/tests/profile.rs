//! Tests `cargo xtask profile` as a user calls it.

use std::collections::HashMap;

use xtask::measure::{Core, Quality, Scene, Size, Task, outcome};
use xtask::profile::{STAGES, Stage, Sums, Table, profile};
use xtask::root;

mod common;

use Stage::{Primary, Reflection, Shading, Shadow};
use common::{Done, assert_mistakes, xtask};

const STAGE_NAMES: &str = "preparation spans primary shading shadow reflection output other";

const EXACT: Quality = Quality::EXACT;

fn task(core: &str, scene: &'static str, size: Size, quality: Quality) -> Task {
    let core = Core::find(core).unwrap();
    Task::new(core, Scene::BuiltIn(scene), size, quality)
}

#[test]
fn total_is_what_measure_counts_but_for_the_calls() {
    // As the kept figures are measured, so that the firmware serves both.
    const ROWS: u64 = 64;
    let size = Size::new(64, ROWS as u32);
    // The scene with the fewest instructions that has every stage.
    let task = task("m3", "cylinders", size, Quality::FAST);
    let (sums, counted) = (profile(&task).unwrap(), outcome(&task).unwrap());
    // Between the two readings of the clock, the firmware also loads arguments and makes the call.
    let call = 1..=32;
    let beyond = counted.prepare - sums.stage(Stage::Preparation);
    assert!(call.contains(&beyond), "{beyond} for a call");
    let beyond = counted.instructions() - sums.total() - beyond;
    assert!(call.contains(&(beyond / ROWS)), "{beyond} for {ROWS} calls");
    for stage in STAGES {
        assert!(sums.stage(stage) > 0, "{stage:?}");
    }
}

#[test]
fn stages_and_tables_add_up_to_the_total() {
    // The Cortex-M0 lacks instructions, so all stages call the routines that replace them.
    let sums = profile(&task("m0", "cylinders", Size::new(8, 8), Quality::FAST)).unwrap();
    for stage in STAGES {
        let own = |table| {
            let rows = sums.rows(table).filter(|(it, ..)| *it == Some(stage));
            rows.map(|(.., row)| row.own).sum::<u64>()
        };
        assert_eq!(own(Table::Innermost), sums.stage(stage), "{stage:?}");
        let library = sums.rows(Table::Library);
        for (_, name, row) in library.filter(|(it, ..)| *it == Some(stage)) {
            let is_between = (row.own..=sums.stage(stage)).contains(&row.second);
            assert!(is_between, "{stage:?} {name}: {row:?}");
        }
    }
    let linked: Vec<_> = sums.rows(Table::Linked).collect();
    let sum: u64 = linked.iter().map(|(.., row)| row.own).sum();
    assert_eq!(sum, sums.total());
    // Each row of eight columns is one block.
    let follow = "reflet::render::interpolate::Colors<W,K,Q,M>::follow";
    let follow = linked
        .iter()
        .filter(|(_, name, _)| name.starts_with(follow));
    assert_eq!(follow.map(|(.., row)| row.second).sum::<u64>(), 8);
    // A routine with many callers belongs to the stage of each of them.
    let mut stages = HashMap::<_, u32>::new();
    for (_, name, row) in sums.rows(Table::Innermost) {
        *stages.entry(name).or_default() += u32::from(row.own > 0);
    }
    let of_linked = linked.iter().filter_map(|(_, name, _)| stages.get(name));
    assert!(of_linked.max().unwrap() > &2);
    assert!(sums.stage(Stage::Other) < sums.total() / 10);
}

#[test]
#[ignore = "long: two more firmware"]
fn mirrored_rays_are_told_from_the_first() {
    let of = |reflections| {
        // Every pixel is traced.
        let mut task = task("m3", "mirror1", Size::new(16, 24), EXACT);
        task.settings.reflections = reflections;
        let sums: Sums = profile(&task).unwrap();
        [Primary, Reflection, Shading, Shadow].map(|stage| sums.stage(stage))
    };
    let [primary, reflection, shading, shadow] = of(0);
    assert_eq!(reflection, 0);
    let deep = of(4);
    // The first rays are the same. Their code may differ, because it is compiled for the number of
    // reflections.
    assert!(deep[0].abs_diff(primary) <= primary / 10, "{deep:?}");
    assert!(deep[1] > primary / 2);
    assert!(deep[2] > shading && deep[3] > shadow);
}

#[test]
fn empty_scene_is_neither_shaded_nor_mirrored() {
    let sums = profile(&task("m33", "empty", Size::new(8, 4), EXACT)).unwrap();
    let without = [Primary, Shading, Shadow, Reflection];
    let found = without.map(|stage| sums.stage(stage));
    assert_eq!(found, [0; 4], "every pixel has the same colour");
    assert!(sums.stage(Stage::Output) > 32 && sums.stage(Stage::Preparation) > 0);
}

#[test]
fn tables_name_what_they_show() {
    let arguments = "profile floor --functions --top 3";
    let Done { code, out, err } = xtask(&root(), arguments);
    assert_eq!((code, err.as_str()), (0, ""));
    let parts: Vec<_> = out.split("\n\n").collect();
    assert_eq!(parts.len(), 5, "{out}");
    let first = |line: &str| line.split_whitespace().next().unwrap_or("").to_owned();
    let names: Vec<_> = parts[0].lines().map(first).collect();
    assert_eq!(names.join(" "), format!("stage {STAGE_NAMES} total"));
    assert!(parts[0].ends_with(" 100.0%"), "{out}");
    for part in &parts[1..] {
        // A title, the column heads and the rows.
        assert_eq!(part.lines().count(), 5, "{part}");
        assert!(part.contains("reflet::") || part.contains("src/"), "{part}");
    }
}

#[test]
fn mistakes_are_one_line_and_exit_code_2() {
    let mistakes = "
profile --core rv32 => rv32 cannot be profiled
profile --quality float => the float port cannot be profiled
profile --core m5 => invalid value 'm5' for '--core <CORE>'
profile --size 0x3 => not a width and a height from 1 to 65535
profile --reflections 256 => 256 is not in 0..=255
profile sandcastle => there is no built-in scene sandcastle, only castle,
profile missing.json => missing.json: No such file or directory
profile --scene ball => --scene chooses from a file
profile --top 3 => the following required arguments were not provided:; --functions
profile --functions --top many => invalid value 'many' for '--top <N>'
profile --all => unexpected argument '--all' found";
    assert_mistakes(&root(), mistakes);
}
