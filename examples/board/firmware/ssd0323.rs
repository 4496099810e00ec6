//! Driver for the SSD0323, a controller for OLED panels of 128x64 pixels in 16 greys, connected by
//! SPI and a data/command pin. It knows no chip and keeps no copy of the picture.
//!
//! Two neighbouring pixels share a byte, the left one in the high nibble, and over SPI the memory
//! cannot be read back. So a drawn area must consist of whole pairs: it starts at an even column and
//! is an even number of pixels wide. Half a pair is an error, because it would overwrite its
//! neighbour.
//!
//! Settings from: Solomon Systech, SSD0323 data sheet, and OSRAM, application note AN018, for the
//! panel Pictiva 128x64.

use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, OriginDimensions, Point, Size},
    pixelcolor::{Gray4, GrayColor},
    primitives::{PointsIter, Rectangle},
};
use embedded_hal::{digital::OutputPin, spi::SpiBus};

/// Columns of the panel.
pub const WIDTH: usize = 128;

const SIZE: Size = Size::new(WIDTH as u32, 64);
const ROW_BYTES: usize = WIDTH / 2;

/// Command that selects columns, in pairs. Like `SET_ROWS` it is followed by the first and the last.
const SET_COLUMNS: u8 = 0x15;
const SET_ROWS: u8 = 0x75;
const DISPLAY_ON: u8 = 0xaf;

/// Commands that set up the controller; each is sent once, before the display is switched on.
const SET_UP: &[&[u8]] = &[
    &[0xae],                                                 // display off
    &[0x81, 50],                                             // contrast
    &[0x85],                                                 // half of the full current
    &[0xa0, 0x52],                                           // order of rows; high nibble first
    &[0xa1, 0],                                              // start line
    &[0xa2, 0x4c],                                           // offset
    &[0xa4],                                                 // normal mode
    &[0xa8, 63],                                             // rows in use, less one
    &[0xb1, 0x22],                                           // phase lengths
    &[0xb2, 70],                                             // row period
    &[0xb3, 0xf1],                                           // clock
    &[0xbf, 0x0d],                                           // segment low voltage
    &[0xbe, 0x02],                                           // row high voltage
    &[0xbc, 0x10],                                           // pre-charge voltage
    &[0xb8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76], // greys
    &[0xad, 0x03],                                           // voltage converter on
];

/// Error of drawing on the display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error<S, P> {
    /// The bus that sends to the display failed.
    Bus(S),
    /// The data/command pin failed.
    Pin(P),
    /// One pixel of a pair was drawn without the other.
    HalfPair,
}

/// Driver of a display with 128x64 pixels.
pub struct Ssd0323<SPI, DC> {
    spi: SPI,
    data_command: DC,
}

impl<SPI: SpiBus, DC: OutputPin> Ssd0323<SPI, DC> {
    /// Sets up a controller that has just been reset, and switches on the display with a black
    /// picture.
    ///
    /// `data_command` is high for data and low for commands. `spi` must select the chip itself.
    pub fn new(spi: SPI, data_command: DC) -> Result<Self, Error<SPI::Error, DC::Error>> {
        let mut display = Self { spi, data_command };
        for command in SET_UP {
            display.command(command)?;
        }
        display.clear(Gray4::new(0))?;
        display.command(&[DISPLAY_ON])?;
        Ok(display)
    }

    /// Shows a whole row, with less code than any area takes.
    pub fn show_row(
        &mut self,
        y: i32,
        row: &[Gray4; WIDTH],
    ) -> Result<(), Error<SPI::Error, DC::Error>> {
        let mut pairs = [0; ROW_BYTES];
        for (byte, pixels) in pairs.iter_mut().zip(row.chunks_exact(2)) {
            *byte = pair(pixels[0], pixels[1]);
        }
        self.send(Point::new(0, y), &pairs)
    }

    /// Sends pairs of pixels of a row, from an even column to the right.
    fn send(&mut self, start: Point, pairs: &[u8]) -> Result<(), Error<SPI::Error, DC::Error>> {
        let Some(after) = pairs.len().checked_sub(1) else {
            return Ok(());
        };
        let (column, row) = (start.x as u8 / 2, start.y as u8);
        self.command(&[SET_COLUMNS, column, column + after as u8])?;
        self.command(&[SET_ROWS, row, row])?;
        self.data_command.set_high().map_err(Error::Pin)?;
        self.write(pairs)
    }

    fn command(&mut self, bytes: &[u8]) -> Result<(), Error<SPI::Error, DC::Error>> {
        self.data_command.set_low().map_err(Error::Pin)?;
        self.write(bytes)
    }

    /// Sends bytes and returns after the last bit is out: only then may the data/command pin change.
    fn write(&mut self, bytes: &[u8]) -> Result<(), Error<SPI::Error, DC::Error>> {
        self.spi.write(bytes).map_err(Error::Bus)?;
        self.spi.flush().map_err(Error::Bus)
    }
}

impl<SPI, DC> OriginDimensions for Ssd0323<SPI, DC> {
    fn size(&self) -> Size {
        SIZE
    }
}

impl<SPI: SpiBus, DC: OutputPin> DrawTarget for Ssd0323<SPI, DC> {
    type Color = Gray4;
    type Error = Error<SPI::Error, DC::Error>;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<Gray4>>,
    {
        let area = self.bounding_box();
        let mut pixels = pixels.into_iter().filter(|pixel| area.contains(pixel.0));
        while let Some(Pixel(at, left)) = pixels.next() {
            let right = pixels.next().ok_or(Error::HalfPair)?;
            if at.x % 2 != 0 || right.0 != at + Point::new(1, 0) {
                return Err(Error::HalfPair);
            }
            self.send(at, &[pair(left, right.1)])?;
        }
        Ok(())
    }

    /// Sends each row as soon as its pixels are known.
    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Gray4>,
    {
        let is_inside = self.bounding_box().intersection(area) == *area;
        let is_paired = area.top_left.x % 2 == 0 && area.size.width.is_multiple_of(2);
        if !(is_inside && is_paired) {
            let points = area.points().zip(colors);
            return self.draw_iter(points.map(|(at, color)| Pixel(at, color)));
        }
        let mut colors = colors.into_iter();
        for y in area.rows() {
            let mut row = [0; ROW_BYTES];
            let mut used = 0;
            for byte in row.iter_mut().take(area.size.width as usize / 2) {
                let Some(left) = colors.next() else { break };
                *byte = pair(left, colors.next().ok_or(Error::HalfPair)?);
                used += 1;
            }
            self.send(Point::new(area.top_left.x, y), &row[..used])?;
        }
        Ok(())
    }
}

fn pair(left: Gray4, right: Gray4) -> u8 {
    left.luma() << 4 | right.luma()
}
