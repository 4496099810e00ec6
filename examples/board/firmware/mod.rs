//! Shows scenes, drawn row by row. The arrow keys orbit the camera, the select key shows the next
//! scene. Each finished picture is reported to the debugger.

mod fault;
mod keys;
mod lm3s;
mod script;
mod ssd0323;

use core::convert::Infallible;

use embedded_graphics::geometry::OriginDimensions;
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use reflet::scenes::{BuiltIn, Visitor};
use reflet::{Camera, Report};
use semihosting::println;

use self::{
    keys::{Keys, Request},
    lm3s::{Board, Output, Spi},
    ssd0323::Ssd0323,
};

/// Error of the display; neither SPI nor the pin can fail here.
pub type Error = ssd0323::Error<Infallible, Infallible>;

/// Takes the board and calls `show` again and again.
pub fn run(show: impl Fn(&mut Viewer) -> Result<(), Error>) -> ! {
    let Err(error) = forever(show);
    panic!("the display failed: {error:?}")
}

fn forever(show: impl Fn(&mut Viewer) -> Result<(), Error>) -> Result<Infallible, Error> {
    let board = Board::take().expect("nobody else takes the board");
    let mut viewer = Viewer {
        display: Ssd0323::new(board.spi, board.data_command)?,
        keys: Keys::new([board.left, board.right, board.up, board.down, board.select]),
    };
    loop {
        show(&mut viewer)?;
    }
}

/// The display and the keys of the board.
pub struct Viewer {
    display: Ssd0323<Spi, Output>,
    keys: Keys,
}

impl Visitor for &mut Viewer {
    type Output = Result<(), Error>;

    fn visit<S: BuiltIn>(self) -> Result<(), Error> {
        self.follow::<S>()
    }
}

impl Viewer {
    /// Shows a scene and orbits its camera by the keys, until the next scene is asked for.
    pub fn follow<S: BuiltIn>(&mut self) -> Result<(), Error> {
        let mut camera = S::CAMERA;
        while let Request::Orbit(azimuth, elevation) = self.show::<S>(&camera)? {
            // A camera cannot look along its `up`: then it keeps its place.
            camera = camera.orbited(azimuth, elevation).unwrap_or(camera);
        }
        Ok(())
    }

    /// Draws a scene until it is finished or a key is pressed. Returns the request of the next key.
    fn show<S: BuiltIn>(&mut self, camera: &Camera) -> Result<Request, Error> {
        let frame = S::frame(camera).prepare(self.display.size());
        let picture = frame
            .on(S::INSTANCE)
            .expect("a constant scene never changes");
        let mut report = Report::NONE;
        let mut row = [Gray4::BLACK; ssd0323::WIDTH];
        for y in 0..picture.size().height {
            report = report.merge(picture.row(y, 0, &mut row));
            if let Some(request) = self.show_row(y as i32, &row)? {
                return Ok(request);
            }
        }
        print(S::NAME, &report);
        Ok(self.keys.wait())
    }

    /// Shows a row. Returns the request of a key if one is pressed. Linked once, not for each scene.
    #[inline(never)]
    fn show_row(
        &mut self,
        y: i32,
        row: &[Gray4; ssd0323::WIDTH],
    ) -> Result<Option<Request>, Error> {
        self.display.show_row(y, row)?;
        Ok(self.keys.pressed())
    }
}

/// Reports a finished picture to the debugger.
#[inline(never)]
fn print(scene: &str, report: &Report) {
    // Printed as whole numbers: formatting them costs a fraction of what other numbers cost.
    let (rays, cut_off) = (report.rays as u32, report.cut_off.to_bits() as u32);
    let cut_off = (u64::from(cut_off) * 10_000 + (1 << 29)) >> 30;
    let (ones, rest) = (cut_off as u32 / 10_000, cut_off as u32 % 10_000);
    println!("{scene}: {rays} rays, weight cut off {ones}.{rest:04}");
}
