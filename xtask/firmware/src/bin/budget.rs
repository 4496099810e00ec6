//! Draws the castle with budgets of instructions, and then again until the clock says that time is
//! up; reports what became of each.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::hint::black_box;
use core::ptr;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use firmware::{Clock, report};
use frame_hash::FrameHash;
use reflet::budget::{Budgeted, FrontPoint, ParetoFront, QualityLevel};
use reflet::scenes::{BuiltIn, Castle};

/// Measured points of a Pareto front, and the picture size for which they hold.
mod measured {
    // Only the castle is drawn.
    #![allow(dead_code)]

    use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};

    include!("../../../../docs/error-time/front.rs");

    pub const SIZE: (usize, usize) = (128, 128);
}

static mut FRAME: [Rgb888; measured::SIZE.0 * measured::SIZE.1] =
    [Rgb888::BLACK; measured::SIZE.0 * measured::SIZE.1];

/// An invented point of a front: each of its pixels covers 2 x 2 pixels of the picture.
const CHEAP: FrontPoint = FrontPoint {
    prepare: 0,
    instructions: 400,
    reflections: 1,
    level: QualityLevel::Fast,
    scale: 2,
    psnr: 2500,
    largest: 255,
};

const FRONT: ParetoFront = ParetoFront::new(&[
    CHEAP,
    FrontPoint {
        instructions: 1500,
        reflections: 4,
        level: QualityLevel::Exact,
        scale: 1,
        psnr: 6000,
        ..CHEAP
    },
]);

/// A display in memory, that takes rows and squares as the drivers of displays do.
struct Screen<'a> {
    pixels: &'a mut [Rgb888],
    size: (usize, usize),
}

impl Screen<'_> {
    /// So much of the row at a place as is in this rectangle; nothing outside of the display.
    fn part(&mut self, area: &Rectangle, row: usize) -> &mut [Rgb888] {
        let (left, top) = (area.top_left.x as usize, area.top_left.y as usize);
        let start = (top + row) * self.size.0 + left;
        let end = start + area.size.width as usize;
        self.pixels.get_mut(start..end).unwrap_or_default()
    }
}

impl OriginDimensions for Screen<'_> {
    fn size(&self) -> Size {
        Size::new(self.size.0 as u32, self.size.1 as u32)
    }
}

impl DrawTarget for Screen<'_> {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb888>>,
    {
        for Pixel(at, color) in pixels {
            let place = at.y as usize * self.size.0 + at.x as usize;
            if let Some(pixel) = self.pixels.get_mut(place) {
                *pixel = color;
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb888>,
    {
        let mut colors = colors.into_iter();
        for row in 0..area.size.height as usize {
            for (pixel, color) in self.part(area, row).iter_mut().zip(&mut colors) {
                *pixel = color;
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb888) -> Result<(), Infallible> {
        for row in 0..area.size.height as usize {
            self.part(area, row).fill(color);
        }
        Ok(())
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    // Sound: nothing else names the frame, and the start-up code calls this once.
    let frame = unsafe { &mut *ptr::addr_of_mut!(FRAME) };
    let clock = Clock::start();
    let mut draw = |front: &ParetoFront, size: (usize, usize), budget: u64, limit: u32| {
        let pixels = &mut frame[..size.0 * size.1];
        pixels.fill(Rgb888::BLACK);
        let castle = Castle::frame(&Castle::CAMERA);
        let mut screen = Screen { pixels, size };
        let mut longest = 0;
        let start = clock.now();
        let mut last = None;
        let is_up = || {
            if let Some(last) = last {
                longest = clock.since(last).max(longest);
            }
            last = Some(clock.now());
            clock.since(start) > limit
        };
        let Ok(drawn) = castle.draw_within(front, budget, is_up, &mut screen);
        let taken = clock.since(start);
        let mut hash = FrameHash::NONE;
        for pixel in screen.pixels.iter() {
            hash.add([pixel.r(), pixel.g(), pixel.b()]);
        }
        say(&drawn, hash, (taken, longest));
    };
    let small = (64, 48);
    draw(&FRONT, small, 1_000_000, u32::MAX);
    draw(&FRONT, small, u64::MAX, 3_000_000);
    let measured = black_box(&measured::CASTLE);
    for size in [measured::SIZE, small] {
        let whole = Size::new(size.0 as u32, size.1 as u32);
        for point in measured.points() {
            draw(measured, size, point.expected(whole), u32::MAX);
        }
    }
    semihosting::process::exit(0)
}

fn say(drawn: &Budgeted, hash: FrameHash, (taken, longest): (u32, u32)) {
    report::text("drawn");
    report::number(" reflections=", drawn.choice.point.reflections.into());
    report::number(" fits=", drawn.choice.fits.into());
    report::number(" missing=", drawn.missing_rows.into());
    report::number(" hash=", hash.value());
    report::number(" instructions=", taken.into());
    report::number(" longest=", longest.into());
    report::text("\n");
}
