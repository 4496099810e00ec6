//! Renders one scene on an emulated core and reports what it took.
//!
//! `cargo xtask measure` builds this with a job, a generated file that names the contestant, the
//! size and the settings, and runs it under QEMU's instruction counting. The report is one line
//! on the semihosting console: `measured`, then hexadecimal numbers by name.
//!
//! There are two programs: `scene` draws the job's scene, `empty` draws nothing. What the first
//! has in flash and static RAM beyond the second is the contestant's. So nothing of either
//! formats with `core::fmt` or can panic: where a linked program does, it is the contestant who
//! needs it.
//!
//! Of two more programs, neither flash nor RAM is measured: `sweep` goes through scenes in many settings, and
//! `budget` draws frames with a budget, by the core's own clock.
#![no_std]

mod clock;
mod contestant;
mod fault;
mod moving;
pub mod report;
#[path = "../../../examples/small/src/stack.rs"]
mod stack;
mod sweep;
mod tally;

use core::{hint::black_box, ptr::addr_of_mut};

#[doc(hidden)]
pub use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use frame_hash::FrameHash;
use reflet::quality::Seam;

pub use clock::Clock;
pub use contestant::{Contestant, Everything, Fixed, Float, FloatView, Nothing, View};
pub use moving::{Moves, Moving};
pub use sweep::{Run, sweep, swept};
use tally::Tally;

/// Columns and rows of the picture. `cargo xtask` writes them into a copy of the linked program, so one program
/// serves all sizes.
#[unsafe(no_mangle)]
static SIZE: [u32; 2] = [0; 2];

/// Largest width of a picture.
pub const WIDEST: usize = 65_535;

/// Defines the start of a program that includes the job as `job` and calls a function with a row of
/// the largest width. The row is static, so the stack holds only what the renderer needs.
#[macro_export]
macro_rules! program {
    (|$row:ident| $call:expr) => {
        #[allow(dead_code)] // No program needs all of a job.
        mod job {
            include!(env!("MEASURE_JOB"));
        }

        static mut ROW: [$crate::Rgb888; $crate::WIDEST] =
            [<$crate::Rgb888 as $crate::RgbColor>::BLACK; $crate::WIDEST];

        #[unsafe(no_mangle)]
        extern "C" fn main() -> ! {
            // Sound: nothing else names the row, and the start-up code calls this once.
            let $row = unsafe { &mut *core::ptr::addr_of_mut!(ROW) };
            $call
        }
    };
}

/// Returns the size of the picture, and the first pixels of a row: as many as the picture has columns.
fn sized(row: &mut [Rgb888]) -> ((u32, u32), &mut [Rgb888]) {
    // The compiler must not know it: it changes after the program is linked.
    let [width, height] = *black_box(&SIZE);
    (
        (width, height),
        row.get_mut(..width as usize).unwrap_or_default(),
    )
}

/// Returns what a row of up to 256 columns leaves to the row below. Without smooth edges it is not linked.
fn seam() -> &'static mut Seam<8> {
    // Static as the row is, so the stack holds only what the renderer needs.
    static mut SEAM: Seam<8> = Seam::new();
    // Sound: nothing else names it, and the caller gives it up before the next row.
    unsafe { &mut *addr_of_mut!(SEAM) }
}

/// Draws a frame of contestant `C` row by row into `row`, reports and ends the emulation. The report has the ticket,
/// which tells the reports of two programs apart.
pub fn measure<C: Contestant>(ticket: u64, row: &mut [Rgb888]) -> ! {
    let (size, row) = sized(row);
    // Static as the row is, so the stack holds only what the renderer needs.
    static mut TALLY: Tally = Tally::NONE;
    // Sound: nothing else names it, and this function is called once, for it never returns.
    let tally = unsafe { &mut *addr_of_mut!(TALLY) };
    let clock = Clock::start();
    stack::paint();
    let mut hash = FrameHash::NONE;
    let mut scene = C::scene();
    let moved = C::moved(&clock, &mut scene);
    let start = clock.now();
    // Seen by reference, so that the stack holds one and no copy.
    let picture = C::prepare(&scene, black_box(size));
    black_box(&picture);
    let prepare = clock.since(start);
    for y in 0..size.1 {
        let start = clock.now();
        C::row((&scene, black_box(&picture)), y, black_box(row));
        tally.add(y, clock.since(start));
        for pixel in row.iter() {
            hash.add([pixel.r(), pixel.g(), pixel.b()]);
        }
    }
    let stack = stack::peak();

    if let Some(instructions) = moved {
        report::text("moved");
        report::number(" instructions=", u64::from(instructions));
        report::text("\n");
    }
    report::text("measured");
    report::number(" ticket=", ticket);
    report::number(" prepare=", u64::from(prepare));
    tally.report();
    report::number(" stack=", u64::from(stack));
    report::number(" hash=", hash.value());
    report::text("\n");
    semihosting::process::exit(0)
}
