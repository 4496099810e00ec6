//! Tells the compiler which chip the target is, and gives the linker the chip's memory map and the script of
//! the start-up code. Without a script the linker would make an empty firmware, without any message.

fn main() {
    let variable = |name: &str| std::env::var(name).expect("cargo sets it");
    let chip = match variable("TARGET").starts_with("thumbv6m") {
        true => "rp2040",
        false => "rp2350",
    };
    println!("cargo::rustc-check-cfg=cfg(rp2040, rp2350)");
    println!("cargo::rustc-cfg={chip}");
    let folder = variable("CARGO_MANIFEST_DIR");
    println!("cargo::rustc-link-search={folder}/{chip}");
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rerun-if-changed={chip}/memory.x");
}
