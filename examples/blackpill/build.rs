//! Gives the linker this folder's memory map and the script of the start-up code. Without a script
//! the linker would make an empty firmware, without any message.

fn main() {
    // The linker reads a copy of the memory map: a path to this folder would be wrong in a copy of the example.
    let folder = std::env::var("OUT_DIR").expect("cargo sets it");
    std::fs::copy("memory.x", format!("{folder}/memory.x")).expect("it is there");
    println!("cargo::rustc-link-search={folder}");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed=memory.x");
}
