//! Gives the linker the memory map of the target's board and the script of the start-up code. Without a script
//! the linker would make an empty firmware, without any message.

fn main() {
    let variable = |name: &str| std::env::var(name).expect("cargo sets it");
    let is_riscv = variable("CARGO_CFG_TARGET_ARCH") == "riscv32";
    let board = if is_riscv { "riscv" } else { "microbit" };
    // The linker reads a copy of the memory map: a path to this folder would be wrong in a copy of the example.
    let folder = variable("OUT_DIR");
    std::fs::copy(format!("{board}/memory.x"), format!("{folder}/memory.x")).expect("it is there");
    println!("cargo::rustc-link-search={folder}");
    if is_riscv {
        println!("cargo::rustc-link-arg-bins=-Tmemory.x");
    }
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed={board}/memory.x");
}
