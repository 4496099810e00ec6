//! Tests that reflet cannot panic on a board and needs no soft float. xtask/no_panic calls every
//! drawing function, and links only if no panic is left.

use std::fs;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use anyhow::Result;
use object::{Object, ObjectSymbol};
use xtask::toolchain::{self, M0, M3};
use xtask::{board, profile::names::Names};

/// Builds xtask/no_panic and returns the names of its soft-float routines.
fn build(target: &str, features: &str) -> Result<Vec<String>> {
    // All builds write to the same folder, so they must not run at the same time.
    static PLACE: Mutex<()> = Mutex::new(());
    let _one_at_a_time = PLACE.lock().unwrap_or_else(PoisonError::into_inner);
    let chosen = ["--features", features];
    let program = toolchain::build_alone(target, Path::new("xtask/no_panic"), &chosen)?;
    if features.is_empty() {
        let names = Names::read(&program)?.all()?;
        let is_there = names.iter().any(|name| name.contains("display::dither::"));
        assert!(is_there, "what draws in every way dithers, too");
    }
    float_routines(&program)
}

fn float_routines(program: &Path) -> Result<Vec<String>> {
    let bytes = fs::read(program)?;
    let file = object::File::parse(&*bytes)?;
    let names = file.symbols().filter_map(|symbol| symbol.name().ok());
    let names: Vec<_> = names.map(str::to_owned).collect();
    assert!(names.len() > 20, "the symbols are there");
    Ok(names.into_iter().filter(|name| is_float(name)).collect())
}

/// Tests whether a symbol is a soft-float routine, by the Run-time ABI for the Arm Architecture,
/// chapter 5.1, or by the name of Rust's own module.
fn is_float(name: &str) -> bool {
    let is_routine = name.strip_prefix("__aeabi_").is_some_and(|name| {
        let computes = ["d", "f", "cd", "cf"].iter().any(|it| name.starts_with(it));
        let converts = ["2d", "2f"].iter().any(|it| name.ends_with(it));
        computes || converts
    });
    is_routine || name.contains("compiler_builtins5float")
}

#[test]
fn nothing_panics_and_nothing_needs_soft_float() {
    assert!(build(M3, "").unwrap().is_empty());
}

#[test]
#[ignore = "long: another core"]
fn nothing_panics_and_nothing_needs_soft_float_on_a_small_core() {
    assert!(build(M0, "").unwrap().is_empty());
}

#[test]
fn panic_would_be_noticed() {
    let refusal = format!("{:#}", build(M3, "panic").unwrap_err());
    let reason = "undefined symbol: a_panic_path_is_left";
    assert!(refusal.contains(reason), "{refusal}");
}

#[test]
fn soft_float_would_be_noticed() {
    let found = build(M3, "float").unwrap();
    let is_product = |name: &&String| *name == "__aeabi_fmul";
    assert!(found.iter().any(|name| is_product(&name)), "{found:?}");
}

#[test]
fn default_board_needs_no_soft_float() {
    let found = float_routines(&board::build().unwrap()).unwrap();
    assert!(found.is_empty(), "{found:?}");
}
