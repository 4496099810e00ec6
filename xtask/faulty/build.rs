//! Tells the linker where the default board's memory map is.

fn main() {
    let package = std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets it");
    println!("cargo::rustc-link-search={package}/../..");
    println!("cargo::rerun-if-changed=../../memory.x");
}
