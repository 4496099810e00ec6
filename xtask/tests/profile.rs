//! Tests `cargo xtask profile` as a user calls it.

use std::collections::HashMap;

use serde_json::Value;
use xtask::measure::{Core, Quality, Scene, Size, Task, outcome};
use xtask::profile::{STAGES, Stage, profile};
use xtask::root;

mod common;

use common::{Done, assert_mistakes, xtask};

const STAGE_NAMES: &str = "preparation spans primary shading shadow reflection output other";

fn stage_names() -> impl Iterator<Item = &'static str> {
    STAGE_NAMES.split(' ')
}

fn lines(arguments: &str) -> Vec<Value> {
    let Done { code, out, err } = xtask(&root(), &format!("profile --json {arguments}"));
    assert_eq!((code, err.as_str()), (0, ""));
    let line = |line| serde_json::from_str(line).unwrap();
    out.lines().map(line).collect()
}

fn stages(lines: &[Value]) -> HashMap<&str, u64> {
    let figures = lines.iter().filter(|line| line["table"].is_null());
    let figure = |line| (text(line, "stage"), count(line));
    figures.map(figure).collect()
}

fn text<'a>(line: &'a Value, key: &str) -> &'a str {
    line[key].as_str().unwrap()
}

fn count(line: &Value) -> u64 {
    line["instructions"].as_u64().unwrap()
}

#[test]
fn total_is_what_measure_counts_but_for_the_calls() {
    // As the kept figures are measured, so that the firmware serves both.
    const ROWS: u64 = 64;
    let (core, scene) = (Core::M3, Scene::BuiltIn("primitives"));
    let task = Task::new(core, scene, Size::new(64, ROWS as u32), Quality::FAST);
    let (sums, counted) = (profile(&task).unwrap(), outcome(&task).unwrap());
    // Between the two readings of the clock, the firmware also loads arguments and makes the call.
    let call = 1..=32;
    let beyond = counted.prepare - sums.stage(Stage::Preparation);
    assert!(call.contains(&beyond), "{beyond} for a call");
    let beyond = counted.instructions - sums.total() - beyond;
    assert!(call.contains(&(beyond / ROWS)), "{beyond} for {ROWS} calls");
    for stage in STAGES {
        assert!(sums.stage(stage) > 0, "{stage:?}");
    }
}

#[test]
fn stages_and_tables_add_up_to_the_total() {
    // The Cortex-M0 lacks instructions, so all stages call the routines that replace them.
    let lines = lines("--core m0 castle --size 8x8 --functions --top 100000");
    let stages = stages(&lines);
    let sum: u64 = stage_names().map(|name| stages[name]).sum();
    assert_eq!(
        (stages.len(), sum),
        (stage_names().count() + 1, stages["total"])
    );
    let rows = |table: &str, stage: Option<&str>| {
        let rows = lines.iter().filter(|line| line["table"] == table);
        let rows = rows.filter(|line| line["stage"].as_str() == stage);
        rows.cloned().collect::<Vec<_>>()
    };
    let sum = |rows: &[Value]| rows.iter().map(count).sum::<u64>();
    for name in stage_names() {
        assert_eq!(sum(&rows("innermost", Some(name))), stages[name], "{name}");
        for row in rows("library", Some(name)) {
            let all = row["all_per_pixel"].as_f64().unwrap() * 64.0;
            assert!(
                (count(&row)..=stages[name]).contains(&(all.round() as u64)),
                "{row}"
            );
        }
    }
    let linked = rows("linked", None);
    assert_eq!(sum(&linked), stages["total"]);
    let calls = |start: &str| {
        let rows = linked
            .iter()
            .filter(|row| text(row, "name").starts_with(start));
        let calls = rows.map(|row| row["calls_per_pixel"].as_f64().unwrap());
        calls.sum::<f64>()
    };
    // Each row of eight columns is one block.
    assert_eq!(
        calls("reflet::render::interpolate::Colors<W,K,Q>::follow"),
        0.125
    );
    // A routine with many callers belongs to the stage of each of them.
    let stages_of = |name: &str| {
        let is_in = |stage: &&str| {
            let rows = rows("innermost", Some(stage));
            rows.iter().any(|row| text(row, "name") == name)
        };
        stage_names().filter(is_in).count()
    };
    let shared = linked.iter().map(|row| stages_of(text(row, "name")));
    assert!(shared.max().unwrap() > 2);
    assert!(stages["other"] < stages["total"] / 10, "{stages:?}");
}

#[test]
#[ignore = "long: two more firmware"]
fn mirrored_rays_are_told_from_the_first() {
    let of = |reflections| {
        let lines = lines(&format!(
            // Every pixel is traced.
            "mirror1 --size 16x24 --quality exact --reflections {reflections}"
        ));
        ["primary", "reflection", "shading", "shadow"].map(|name| stages(&lines)[name])
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
    let lines = lines("--core m33 empty --size 8x4 --quality exact");
    let stages = stages(&lines);
    assert_eq!(
        ["primary", "shading", "shadow", "reflection"].map(|name| stages[name]),
        [0; 4],
        "every pixel has the same colour"
    );
    assert!(stages["output"] > 32 && stages["preparation"] > 0);
    let line = lines.last().unwrap();
    assert_eq!(
        (text(line, "stage"), line["share"].as_f64()),
        ("total", Some(1.0))
    );
    assert_eq!(
        line["instructions_per_pixel"].as_f64().unwrap() * 32.0,
        count(line) as f64
    );
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
    assert_eq!(names.join(" "), format!("stage {} total", STAGE_NAMES));
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
