//! Boards that people own, and the displays they put on them: clocks from the data sheets.

use super::Core;

#[derive(Debug)]
pub struct Board {
    pub name: &'static str,
    /// The core's name on the command line; the M0+ is measured as an M0.
    core: &'static str,
    /// Clock frequency of the board's core, in MHz.
    pub clock: f64,
    pub display: Display,
}

#[derive(Debug)]
pub struct Display {
    chip: &'static str,
    width: u32,
    height: u32,
    /// Clock cycles of the bus to send one pixel.
    clocks: f64,
    bus: Bus,
}

/// How fast a bus runs, in MHz: what the chip can make and the display takes.
#[derive(Clone, Copy, Debug)]
enum Bus {
    Spi(f64),
    I2c(f64),
}

const fn board(name: &'static str, core: &'static str, clock: f64, display: Display) -> Board {
    Board {
        name,
        core,
        clock,
        display,
    }
}

const fn rgb565(chip: &'static str, width: u32, height: u32, spi: f64) -> Display {
    let (clocks, bus) = (16.0, Bus::Spi(spi));
    Display {
        chip,
        width,
        height,
        clocks,
        bus,
    }
}

const fn st7789(spi: f64) -> Display {
    rgb565("ST7789", 240, 240, spi)
}

/// Black or white; an acknowledgement after every 8 bits.
const SSD1306: Display = Display {
    clocks: 9.0 / 8.0,
    bus: Bus::I2c(0.4),
    ..rgb565("SSD1306", 128, 64, 0.0)
};
const ST7735: Display = rgb565("ST7735", 128, 160, 9.0);
const ILI9341: Display = rgb565("ILI9341", 240, 320, 5.625);

pub const BOARDS: [Board; 8] = [
    board("Raspberry Pi Pico", "m0+", 125.0, st7789(62.5)),
    board("Raspberry Pi Pico 2", "m33", 150.0, st7789(37.5)),
    board("Blue Pill (STM32F103)", "m3", 72.0, ST7735),
    board("Black Pill (STM32F411)", "m4f", 100.0, st7789(50.0)),
    board("STM32F429 Discovery", "m4f", 180.0, ILI9341),
    board("micro:bit", "m0", 16.0, SSD1306),
    board("micro:bit v2", "m4f", 64.0, SSD1306),
    board("nRF52840 DK", "m4f", 64.0, st7789(32.0)),
];

impl Board {
    /// Returns the name of the core whose cycles are used for this board.
    pub fn core(&self) -> &'static str {
        self.core.trim_end_matches('+')
    }

    pub fn title(&self) -> String {
        let title = Core::find(self.core()).map_or("", |core| core.title);
        title.to_owned() + self.core.trim_start_matches(self.core())
    }

    /// Estimates the seconds that the board takes to draw a frame.
    pub fn frame(&self, cycles_per_pixel: f64) -> f64 {
        cycles_per_pixel * self.display.pixels() / (self.clock * 1e6)
    }
}

impl Display {
    pub fn title(&self) -> String {
        let bus = match self.bus {
            Bus::Spi(clock) => format!("SPI at {} MHz", (10.0 * clock).round() / 10.0),
            Bus::I2c(clock) => format!("I2C at {} kHz", 1e3 * clock),
        };
        format!("{}x{} {}, {bus}", self.width, self.height, self.chip)
    }

    /// Returns the seconds that the bus takes to send a frame.
    pub fn transfer(&self) -> f64 {
        let (Bus::Spi(clock) | Bus::I2c(clock)) = self.bus;
        self.pixels() * self.clocks / (clock * 1e6)
    }

    fn pixels(&self) -> f64 {
        f64::from(self.width) * f64::from(self.height)
    }
}
