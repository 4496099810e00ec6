//! Shows every built-in scene on an OLED: the firmware of the default board, an LM3S6965
//! (Cortex-M3).
//!
//! `cargo run --profile firmware --example board --target thumbv7m-none-eabi` boots it in QEMU.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod firmware;

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    use reflet::scenes::{NAMES, visit};

    firmware::run(|viewer| {
        for name in NAMES {
            visit(name, &mut *viewer).transpose()?;
        }
        Ok(())
    })
}

/// Says how to run the firmware, if the program is started on a computer.
#[cfg(not(target_os = "none"))]
fn main() {
    eprintln!(
        "this is firmware: cargo run --profile firmware --example board --target thumbv7m-none-eabi"
    );
    std::process::exit(2);
}
