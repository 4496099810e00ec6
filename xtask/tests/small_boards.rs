//! Tests the boards without a display: they draw the castle row by row, and the picture is the same
//! as on this machine.

use std::{path::PathBuf, time::Duration};

use embedded_graphics::geometry::Size;
use frame_hash::FrameHash;

use reflet::host::painted;
use reflet::scenes::{BuiltIn, Castle};
use xtask::{copies, emulator::qemu::Qemu, measure::weigh};

const SIDE: u32 = 240;

/// Time limit of a run: a Cortex-M0 takes some thousand million instructions for the frame.
const LIMIT: Duration = Duration::from_secs(300);

/// Builds a copy of an example, as a person takes it.
fn build(example: &str) -> PathBuf {
    copies::firmware(example).unwrap_or_else(|error| panic!("{error:#}"))
}

/// Returns the stack that the program reports. Panics if its picture differs from this machine's.
fn stack_of_right_picture(said: &str) -> u64 {
    let hash = hash();
    let start = format!("castle {SIDE}x{SIDE}: {SIDE} rows, hash {hash:016x}, stack ");
    let rest = said.strip_prefix(&start);
    let bytes = rest.and_then(|rest| rest.strip_suffix(" bytes")?.parse().ok());
    bytes.unwrap_or_else(|| panic!("{start} expected, and it said: {said}"))
}

fn hash() -> u64 {
    let frame = Castle::frame(&Castle::CAMERA).prepare(Size::new_equal(SIDE));
    FrameHash::of(painted(&frame.on(&Castle).unwrap()).pixels)
}

#[test]
#[ignore = "long: another board"]
fn castle_on_a_microbit_is_the_same_picture_in_10_kib_of_ram() {
    let program = build("microbit");
    let said = Qemu::arm("microbit").limit(LIMIT).run(&program);
    let stack = stack_of_right_picture(&said.unwrap_or_else(|error| panic!("{error}")));
    let ram = weigh(&program).unwrap().ram + stack;
    assert!(ram <= 10 * 1024, "{ram} bytes");
}

#[test]
#[ignore = "long: another board"]
fn castle_on_risc_v_is_the_same_picture() {
    let program = build("riscv");
    let said = Qemu::riscv32().limit(LIMIT).run(&program);
    stack_of_right_picture(&said.unwrap_or_else(|error| panic!("{error}")));
}
