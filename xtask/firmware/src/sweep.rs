//! Many settings of one scene, one after the other: a line of report for each.

use core::hint::black_box;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use frame_hash::FrameHash;
use reflet::__private::Apart;
use reflet::quality::Quality;
use reflet::shading::BlinnPhong;
use reflet::{FrameBuilder, PreparedFrame};

use crate::clock::Clock;
use crate::{View, report, sized};

/// Prepares a frame for one size of picture, with a number of reflections that is known only while the
/// program runs.
#[inline(never)]
fn prepare<S: Apart, V: View, Q: Quality>(
    (width, height): (u32, u32),
    reflections: u8,
) -> PreparedFrame<S, Q, BlinnPhong> {
    FrameBuilder::new(S::INSTANCE, black_box(&V::CAMERA))
        .reflections(reflections)
        .quality::<Q>()
        .prepare(Size::new(width, height))
}

#[inline(never)]
fn draw_row<S: Apart, Q: Quality>(
    frame: &PreparedFrame<S, Q, BlinnPhong>,
    y: u32,
    row: &mut [Rgb888],
) {
    if let Ok(rows) = frame.on(S::INSTANCE) {
        rows.next_row(crate::seam(), y, 0, row);
    }
}

/// One setting of a sweep: reflections, size and quality of a frame.
pub struct Run {
    pub reflections: u8,
    /// Side of a drawn pixel, in pixels of the picture.
    pub scale: u32,
    /// Function that draws a frame with this setting: [`swept`] of a quality.
    pub draw: fn(&Clock, (u32, u32), &Run, &mut [Rgb888]) -> Drawn,
}

/// Instructions and hash of the frame that one setting of a sweep drew.
pub struct Drawn {
    instructions: u64,
    prepare: u32,
    hash: FrameHash,
}

/// Draws a frame with each setting, reports each, and ends the emulation.
pub fn sweep(ticket: u64, runs: &[Run], row: &mut [Rgb888]) -> ! {
    let (size, row) = sized(row);
    let clock = Clock::start();
    for (index, run) in (0..).zip(black_box(runs)) {
        let drawn = (run.draw)(&clock, black_box(size), run, row);
        report::text("measured");
        report::number(" ticket=", ticket);
        report::number(" run=", index);
        report::number(" instructions=", drawn.instructions);
        report::number(" prepare=", u64::from(drawn.prepare));
        report::number(" hash=", drawn.hash.value());
        report::text("\n");
    }
    semihosting::process::exit(0)
}

/// Draws a frame row by row into `row`, which is as wide as the picture: scene `S`, view `V`, quality `Q`.
///
/// The rows of a picture of larger pixels are made as wide, which is counted; that each is sent to a
/// display several times takes nothing but the display's time.
pub fn swept<S: Apart, V: View, Q: Quality>(
    clock: &Clock,
    (width, height): (u32, u32),
    run: &Run,
    row: &mut [Rgb888],
) -> Drawn {
    let scale = run.scale;
    let (columns, rows) = (width.div_ceil(scale), height.div_ceil(scale));
    let mut hash = FrameHash::NONE;
    let start = clock.now();
    let size = black_box((columns, rows));
    let picture = prepare::<S, V, Q>(size, black_box(run.reflections));
    black_box(&picture);
    let prepare = clock.since(start);
    let mut instructions = u64::from(prepare);
    for y in 0..rows {
        let start = clock.now();
        let part = black_box(&mut row[..columns as usize]);
        draw_row(black_box(&picture), y, part);
        if scale > 1 {
            widen(columns as usize, scale as usize, black_box(row));
        }
        instructions += u64::from(clock.since(start));
        for _ in 0..scale.min(height - y * scale) {
            for pixel in row.iter() {
                hash.add([pixel.r(), pixel.g(), pixel.b()]);
            }
        }
    }
    Drawn {
        instructions,
        prepare,
        hash,
    }
}

/// Makes each of the first `columns` pixels `scale` wide, from the last one on, in place.
#[inline(never)]
fn widen(columns: usize, scale: usize, row: &mut [Rgb888]) {
    for column in (0..columns).rev() {
        let color = row[column];
        let end = (column * scale + scale).min(row.len());
        row[column * scale..end].fill(color);
    }
}
