//! Shows the built-in scenes, drawn row by row; the arrow keys orbit the camera, the select key
//! goes on to the next scene. Each finished picture is reported to the debugger.

mod fault;
mod keys;
mod lm3s;
mod ssd0323;

use core::convert::Infallible;

use cortex_m_rt::entry;
use embedded_graphics::{
    geometry::{OriginDimensions, Point, Size},
    primitives::Rectangle,
};
use reflet::{
    Camera, Report, StaticFrame,
    scenes::{BuiltIn, NAMES, Visitor, visit},
};
use semihosting::println;

use self::{
    keys::{Keys, Request},
    lm3s::{Board, Output, Spi},
    ssd0323::Ssd0323,
};

type Error = ssd0323::Error<Infallible, Infallible>;

#[entry]
fn main() -> ! {
    let Err(error) = run();
    panic!("the display failed: {error:?}")
}

fn run() -> Result<Infallible, Error> {
    let board = Board::take().expect("nobody else takes the board");
    let mut display = Ssd0323::new(board.spi, board.data_command)?;
    let mut keys = Keys::new([board.left, board.right, board.up, board.down, board.select]);
    loop {
        for name in NAMES {
            let viewer = Viewer {
                display: &mut display,
                keys: &mut keys,
            };
            visit(name, viewer).transpose()?;
        }
    }
}

struct Viewer<'a> {
    display: &'a mut Ssd0323<Spi, Output>,
    keys: &'a mut Keys,
}

impl Visitor for Viewer<'_> {
    type Output = Result<(), Error>;

    /// Shows a scene from where its keys lead to, until the next one is asked for.
    fn visit<S: BuiltIn>(mut self) -> Result<(), Error> {
        let mut camera = S::CAMERA;
        while let Request::Orbit(azimuth, elevation) = self.show::<S>(&camera)? {
            // A camera cannot look along its `up`: there it stays.
            camera = camera.orbited(azimuth, elevation).unwrap_or(camera);
        }
        Ok(())
    }
}

impl Viewer<'_> {
    /// Draws a scene until it is done or a key is pressed, and returns what the next key asks for.
    fn show<S: BuiltIn>(&mut self, camera: &Camera) -> Result<Request, Error> {
        let picture = S::frame(camera).sized(self.display.size());
        let mut report = Report::NONE;
        for y in 0..picture.size().height as i32 {
            let row = Rectangle::new(Point::new(0, y), Size::new(picture.size().width, 1));
            let drawn = picture.draw_area(row, Point::zero(), self.display)?;
            report = report.merge(drawn);
            if let Some(request) = self.keys.pressed() {
                return Ok(request);
            }
        }
        let Report { rays, cut_off, .. } = report;
        println!("{}: {rays} rays, weight cut off {cut_off:.4}", S::NAME);
        Ok(self.keys.wait())
    }
}
