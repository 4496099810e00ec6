//! The panel: the DMA sends a block of rows to it while the next block is traced.

mod line;

use core::cell::{Ref, RefCell};
use core::convert::Infallible;
use core::ops::Range;

use cortex_m::singleton;
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiBus};

use crate::board::chip::hal::dma::single_buffer::{Config, Transfer};
use crate::board::chip::hal::dma::{CH0, Channel};
use crate::board::chip::hal::gpio::{FunctionSioOutput, FunctionSpi, Pin, PullDown};
use crate::board::chip::hal::spi::{Enabled, Spi};
use crate::board::{ChipSelectPin, ClockPin, DataCommandPin, DataPin, SpiUnit};
pub use line::{Line, SIDE};
use line::{ROW, Wire};

/// Most rows that are sent at once. Two areas of 4 rows fit: those that both cores trace first.
const ROWS: usize = 8;

/// Rows in the panel's byte order. The DMA borrows a block until it has sent it.
type Block = RefCell<[u8; ROWS * ROW]>;

/// The SPI behind the pins of data and clock.
type Bus = Spi<Enabled, SpiUnit, (Serial<DataPin>, Serial<ClockPin>), 8>;
type Serial<P> = Pin<P, FunctionSpi, PullDown>;
type Output<P> = Pin<P, FunctionSioOutput, PullDown>;

/// The DMA and the SPI, at rest or at work.
enum State {
    Idle(Channel<CH0>, Bus),
    Sending(Transfer<Channel<CH0>, Ref<'static, [u8]>, Bus>),
}

/// The panel behind its pins.
pub struct Screen {
    /// `None` only while it changes.
    state: Option<State>,
    chip_select: Output<ChipSelectPin>,
    data_command: Output<DataCommandPin>,
    /// The block that is filled, and the one that was sent last.
    blocks: [&'static Block; 2],
    /// Area of the rows in the first block.
    filled: Rectangle,
}

impl Screen {
    /// Takes over a panel that is set up. Returns `None` if it is called again.
    pub fn new(
        (dma, spi): (Channel<CH0>, Bus),
        (chip_select, data_command): (Output<ChipSelectPin>, Output<DataCommandPin>),
    ) -> Option<Self> {
        Some(Self {
            state: Some(State::Idle(dma, spi)),
            chip_select,
            data_command,
            blocks: [
                singleton!(: Block = RefCell::new([0; ROWS * ROW]))?,
                singleton!(: Block = RefCell::new([0; ROWS * ROW]))?,
            ],
            filled: Rectangle::zero(),
        })
    }

    /// Shows a line in each of these rows.
    pub fn show(&mut self, rows: Range<u32>, line: &Line) {
        for y in rows {
            let at = Point::new(0, y as i32);
            self.add(at, SIDE, |bytes| bytes.copy_from_slice(&line.bytes));
        }
    }

    /// Adds a row to the block, and sends the block if it is full. A block that the row does not
    /// continue is sent before.
    fn add(&mut self, at: Point, width: u32, fill: impl FnOnce(&mut [u8])) {
        let Rectangle { top_left, size } = self.filled;
        if at != top_left + size.y_axis() || width != size.width {
            self.send();
            self.filled = Rectangle::new(at, Size::new(width, 0));
        }
        let row = 2 * width as usize;
        let bytes = self.filled.size.height as usize * row;
        fill(&mut self.blocks[0].borrow_mut()[bytes..bytes + row]);
        self.filled.size.height += 1;
        if bytes + 2 * row > ROWS * ROW {
            self.send();
        }
    }

    /// Starts to send the block, after the one before is sent.
    pub fn send(&mut self) {
        let Rectangle { top_left, size } = self.filled;
        let Some(last) = self.filled.bottom_right() else {
            return;
        };
        let Some((dma, mut spi)) = self.wait() else {
            return;
        };
        for (command, first, last) in [(0x2a, top_left.x, last.x), (0x2b, top_left.y, last.y)] {
            let [first, last] = [first, last].map(|it| (it as u16).to_be_bytes());
            self.command(&mut spi, command, [first, last].as_flattened());
        }
        self.command(&mut spi, 0x2c, &[]);
        let bytes = 2 * (size.width * size.height) as usize;
        let block = Ref::map(self.blocks[0].borrow(), |block| &block[..bytes]);
        self.state = Some(State::Sending(Config::new(dma, block, spi).start()));
        self.blocks.swap(0, 1);
        self.filled = Rectangle::zero();
    }

    /// Waits until the DMA and the SPI rest, and takes them.
    fn wait(&mut self) -> Option<(Channel<CH0>, Bus)> {
        let (dma, mut spi) = match self.state.take()? {
            State::Idle(dma, spi) => (dma, spi),
            State::Sending(transfer) => {
                let (dma, _, spi) = transfer.wait();
                (dma, spi)
            }
        };
        let Ok(()) = spi.flush();
        let Ok(()) = self.chip_select.set_high();
        Some((dma, spi))
    }

    /// Sends a command with its arguments, and selects the panel for what follows.
    fn command(&mut self, spi: &mut Bus, command: u8, arguments: &[u8]) {
        let Ok(()) = self.chip_select.set_low();
        let Ok(()) = self.data_command.set_low();
        let Ok(()) = spi.write(&[command]);
        let Ok(()) = spi.flush();
        let Ok(()) = self.data_command.set_high();
        let Ok(()) = spi.write(arguments);
        let Ok(()) = spi.flush();
    }
}

impl OriginDimensions for Screen {
    fn size(&self) -> Size {
        Size::new_equal(SIDE)
    }
}

impl DrawTarget for Screen {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        let panel = self.bounding_box();
        for Pixel(at, color) in pixels.into_iter().filter(|it| panel.contains(it.0)) {
            self.add(at, 1, |bytes| bytes.copy_from_slice(&Wire::from(color).0));
            self.send();
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        let mut colors = colors.into_iter();
        if area.intersection(&self.bounding_box()) != *area {
            let pixels = area.points().zip(colors);
            return self.draw_iter(pixels.map(|(at, color)| Pixel(at, color)));
        }
        for y in area.rows() {
            let at = Point::new(area.top_left.x, y);
            self.add(at, area.size.width, |bytes| {
                for (bytes, color) in bytes.chunks_exact_mut(2).zip(&mut colors) {
                    bytes.copy_from_slice(&Wire::from(color).0);
                }
            });
        }
        self.send();
        Ok(())
    }
}
