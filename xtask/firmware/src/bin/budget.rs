//! Draws the castle with a budget of instructions, and then again until the clock says that time is
//! up; reports what became of both.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::ptr;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Size};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use firmware::{Clock, report};
use frame_hash::FrameHash;
use reflet::scenes::{BuiltIn, Castle};
use reflet::{Budgeted, Front, FrontPoint, Grade, StaticFrame};

const WIDTH: usize = 64;
const HEIGHT: usize = 48;

static mut FRAME: [Rgb888; WIDTH * HEIGHT] = [Rgb888::BLACK; WIDTH * HEIGHT];

const CHEAP: FrontPoint = FrontPoint {
    instructions: 400,
    reflections: 1,
    grade: Grade::Fast,
    scale: 2,
    psnr: 2500,
    largest: 255,
};

const FRONT: Front = Front::new(&[
    CHEAP,
    FrontPoint {
        instructions: 1500,
        reflections: 4,
        grade: Grade::Fine,
        scale: 1,
        psnr: 6000,
        ..CHEAP
    },
]);

/// A display in memory.
struct Screen<'a>(&'a mut [Rgb888]);

impl OriginDimensions for Screen<'_> {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
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
            if let Some(pixel) = self.0.get_mut(at.y as usize * WIDTH + at.x as usize) {
                *pixel = color;
            }
        }
        Ok(())
    }
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    // Sound: nothing else names the frame, and the start-up code calls this once.
    let frame = unsafe { &mut *ptr::addr_of_mut!(FRAME) };
    let clock = Clock::start();
    let mut draw = |budget: u64, limit: u32| {
        frame.fill(Rgb888::BLACK);
        let start = clock.now();
        let is_up = || clock.since(start) > limit;
        let mut screen = Screen(frame);
        let castle = Castle::frame(&Castle::CAMERA);
        let Ok(drawn) = castle.draw_within(&FRONT, budget, is_up, &mut screen);
        let mut hash = FrameHash::NONE;
        for pixel in frame.iter() {
            hash.add([pixel.r(), pixel.g(), pixel.b()]);
        }
        say(&drawn, hash);
    };
    draw(1_000_000, u32::MAX);
    draw(u64::MAX, 3_000_000);
    semihosting::process::exit(0)
}

fn say(drawn: &Budgeted, hash: FrameHash) {
    report::text("drawn");
    report::number(" reflections=", drawn.choice.point.reflections.into());
    report::number(" fits=", drawn.choice.fits.into());
    report::number(" missing=", drawn.missing_rows.into());
    report::number(" hash=", hash.value());
    report::text("\n");
}
