//! Many settings of one scene, one after the other: a line of report for each.

use core::hint::black_box;
use core::marker::PhantomData;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use frame_hash::FrameHash;
use reflet::__private::Apart;
use reflet::quality::Quality;
use reflet::shading::Shading;
use reflet::{FrameBuilder, PreparedFrame};

use crate::clock::Clock;
use crate::{Float, FloatView, Order, View, report};

/// A contestant whose number of reflections is known only while it runs.
pub trait Swept {
    /// Type of a frame that is prepared for one size of picture.
    type Picture;

    /// Prepares a frame for one size of picture.
    fn prepare(size: (u32, u32), reflections: u8) -> Self::Picture;

    /// Renders row `y` of the picture into `row`.
    fn row(picture: &Self::Picture, y: u32, row: &mut [Rgb888]);
}

/// The library, with scene `S`, view `V`, quality `Q`, shading `K` and any number of reflections.
pub struct Varied<S, V, Q, K>(PhantomData<(S, V, Q, K)>);

impl<S: Apart, V: View, Q: Quality, K: Shading> Swept for Varied<S, V, Q, K> {
    type Picture = PreparedFrame<S, Q, K>;

    #[inline(never)]
    fn prepare((width, height): (u32, u32), reflections: u8) -> Self::Picture {
        FrameBuilder::new(S::INSTANCE, black_box(&V::CAMERA))
            .reflections(reflections)
            .quality::<Q>()
            .shading::<K>()
            .prepare(Size::new(width, height))
    }

    #[inline(never)]
    fn row(frame: &Self::Picture, y: u32, row: &mut [Rgb888]) {
        if let Ok(rows) = frame.on(S::INSTANCE) {
            rows.row(y, 0, row);
        }
    }
}

impl<V: FloatView> Swept for Float<V> {
    type Picture = (float_port::View, u32);

    #[inline(never)]
    fn prepare(size: (u32, u32), reflections: u8) -> Self::Picture {
        let view = float_port::View::new(black_box(&V::CAMERA), size);
        (view, reflections.into())
    }

    #[inline(never)]
    fn row((view, reflections): &Self::Picture, y: u32, row: &mut [Rgb888]) {
        for (x, pixel) in (0..).zip(row) {
            let ray = view.ray(x, y);
            let [red, green, blue] = float_port::pixel(&V::SCENE, V::SHADING, &ray, *reflections);
            *pixel = Rgb888::new(red, green, blue);
        }
    }
}

/// One setting of a sweep: size, reflections, quality and shading of a frame.
pub struct Run {
    /// Largest number of reflections of a path.
    pub reflections: u8,
    /// Side of a drawn pixel, in pixels of the picture.
    pub scale: u32,
    /// Function that draws a frame with this setting: [`swept`] of a renderer.
    pub draw: fn(&Clock, (u32, u32), &Run, &mut [Rgb888]) -> Drawn,
}

/// Instructions and hash of the frame that one setting of a sweep drew.
pub struct Drawn {
    instructions: u64,
    prepare: u32,
    hash: FrameHash,
}

/// Draws a frame with each setting, reports each, and ends the emulation.
pub fn sweep(order: &Order, runs: &[Run], row: &mut [Rgb888]) -> ! {
    let clock = Clock::start();
    for (index, run) in (0..).zip(black_box(runs)) {
        let drawn = (run.draw)(&clock, black_box(order.size), run, row);
        report::text("measured");
        report::number(" ticket=", order.ticket);
        report::number(" run=", index);
        report::number(" instructions=", drawn.instructions);
        report::number(" prepare=", u64::from(drawn.prepare));
        report::number(" hash=", drawn.hash.value());
        report::text("\n");
    }
    semihosting::process::exit(0)
}

/// Draws a frame of contestant `C` row by row into `row`, which is as wide as the picture.
///
/// The rows of a picture of larger pixels are made as wide, which is counted; that each is sent to a
/// display several times takes nothing but the display's time.
pub fn swept<C: Swept>(
    clock: &Clock,
    (width, height): (u32, u32),
    run: &Run,
    row: &mut [Rgb888],
) -> Drawn {
    let scale = run.scale;
    let (columns, rows) = (width.div_ceil(scale), height.div_ceil(scale));
    let mut hash = FrameHash::NONE;
    let start = clock.now();
    let picture = C::prepare(black_box((columns, rows)), black_box(run.reflections));
    black_box(&picture);
    let prepare = clock.since(start);
    let mut instructions = u64::from(prepare);
    for y in 0..rows {
        let start = clock.now();
        C::row(
            black_box(&picture),
            y,
            black_box(&mut row[..columns as usize]),
        );
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
