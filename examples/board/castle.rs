//! Shows only the castle on the same OLED. So the code that other scenes need is not in this
//! firmware.
//!
//! `cargo run --profile firmware --example board_castle --target thumbv7m-none-eabi` boots it in QEMU.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod firmware;

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    firmware::run(|viewer| viewer.follow::<reflet::scenes::Castle>())
}

/// Says how to run the firmware, if the program is started on a computer.
#[cfg(not(target_os = "none"))]
fn main() {
    eprintln!(
        "this is firmware: cargo run --profile firmware --example board_castle --target thumbv7m-none-eabi"
    );
    std::process::exit(2);
}
