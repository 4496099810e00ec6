//! Chooses the board by the core that is built for: puts its memory map where the linker finds it, and
//! names the start-up code's linker script.

use std::{env, fs, path::PathBuf};

fn main() {
    let variable = |name| env::var(name).expect("cargo sets it");
    let target = variable("TARGET");
    let map = match target.as_str() {
        "riscv32imac-unknown-none-elf" => "virt.x",
        "thumbv8m.main-none-eabihf" => "an505.x",
        _ => "an385.x",
    };
    println!("cargo::rustc-check-cfg=cfg(an505)");
    if map == "an505.x" {
        println!("cargo::rustc-cfg=an505");
    }
    let directory = PathBuf::from(variable("OUT_DIR"));
    let map = PathBuf::from(variable("CARGO_MANIFEST_DIR"))
        .join("memory")
        .join(map);
    fs::copy(&map, directory.join("memory.x")).expect("the map is there and OUT_DIR takes it");
    println!("cargo::rustc-link-search={}", directory.display());
    if target.starts_with("riscv") {
        println!("cargo::rustc-link-arg-bins=-Tmemory.x");
    }
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed={}", map.display());
}
