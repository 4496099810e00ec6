//! Sets the stack of the wasm module. A scene with room for a whole file is built on the stack: it takes
//! several hundred kilobytes, more than once, and the linker's default is 1 MB.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = std::env::var("CARGO_CFG_TARGET_ARCH");
    if target.is_ok_and(|target| target == "wasm32") {
        println!("cargo::rustc-link-arg-cdylib=-zstack-size=8388608");
    }
}
