//! Tells the compiler which chip the target is, and gives the linker the chip's memory map and the script of
//! the start-up code. Without a script the linker would make an empty firmware, without any message.

fn main() {
    let variable = |name: &str| std::env::var(name).expect("cargo sets it");
    let chip = if variable("TARGET").starts_with("thumbv6m") { "rp2040" } else { "rp2350" };
    println!("cargo::rustc-check-cfg=cfg(rp2040, rp2350)");
    println!("cargo::rustc-cfg={chip}");
    // The linker reads a copy of the memory map: a path to this folder would be wrong in a copy of the example.
    let folder = variable("OUT_DIR");
    std::fs::copy(format!("{chip}/memory.x"), format!("{folder}/memory.x")).expect("it is there");
    println!("cargo::rustc-link-search={folder}");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed={chip}/memory.x");
}
