//! Boards that people own, and the displays they put on them: clocks from the data sheets.

#[derive(Debug)]
pub struct Board {
    pub name: &'static str,
    /// The core it has.
    pub title: &'static str,
    /// The name of the core whose cycles stand for it.
    pub core: &'static str,
    /// How fast the core runs, in MHz.
    pub clock: f64,
    pub display: Display,
}

#[derive(Debug)]
pub struct Display {
    pub name: &'static str,
    pub width: u32,
    pub height: u32,
    /// Clocks of the bus that a pixel takes.
    pub clocks: f64,
    /// How fast the bus runs, in MHz: what the chip can make and the display takes.
    pub bus: f64,
}

impl Board {
    /// The seconds that a frame takes, an estimate.
    pub fn frame(&self, cycles_per_pixel: f64) -> f64 {
        cycles_per_pixel * self.display.pixels() / (self.clock * 1e6)
    }
}

impl Display {
    /// The seconds that it takes to send a frame.
    pub fn transfer(&self) -> f64 {
        self.pixels() * self.clocks / (self.bus * 1e6)
    }

    fn pixels(&self) -> f64 {
        f64::from(self.width) * f64::from(self.height)
    }

    const fn rgb565(name: &'static str, (width, height): (u32, u32), bus: f64) -> Self {
        Self {
            name,
            width,
            height,
            clocks: 16.0,
            bus,
        }
    }

    /// Black or white; an acknowledgement after every 8 bits.
    const fn ssd1306() -> Self {
        Self {
            name: "SSD1306, I2C at 400 kHz",
            width: 128,
            height: 64,
            clocks: 9.0 / 8.0,
            bus: 0.4,
        }
    }
}

pub const BOARDS: [Board; 8] = [
    Board {
        name: "Raspberry Pi Pico",
        title: "Cortex-M0+",
        core: "m0",
        clock: 125.0,
        display: Display::rgb565("ST7789, SPI at 62.5 MHz", (240, 240), 62.5),
    },
    Board {
        name: "Raspberry Pi Pico 2",
        title: "Cortex-M33",
        core: "m33",
        clock: 150.0,
        display: Display::rgb565("ST7789, SPI at 37.5 MHz", (240, 240), 37.5),
    },
    Board {
        name: "Blue Pill (STM32F103)",
        title: "Cortex-M3",
        core: "m3",
        clock: 72.0,
        display: Display::rgb565("ST7735, SPI at 9 MHz", (128, 160), 9.0),
    },
    Board {
        name: "Black Pill (STM32F411)",
        title: "Cortex-M4F",
        core: "m4f",
        clock: 100.0,
        display: Display::rgb565("ST7789, SPI at 50 MHz", (240, 240), 50.0),
    },
    Board {
        name: "STM32F429 Discovery",
        title: "Cortex-M4F",
        core: "m4f",
        clock: 180.0,
        display: Display::rgb565("ILI9341, SPI at 5.6 MHz", (240, 320), 5.625),
    },
    Board {
        name: "micro:bit",
        title: "Cortex-M0",
        core: "m0",
        clock: 16.0,
        display: Display::ssd1306(),
    },
    Board {
        name: "micro:bit v2",
        title: "Cortex-M4F",
        core: "m4f",
        clock: 64.0,
        display: Display::ssd1306(),
    },
    Board {
        name: "nRF52840 DK",
        title: "Cortex-M4F",
        core: "m4f",
        clock: 64.0,
        display: Display::rgb565("ST7789, SPI at 32 MHz", (240, 240), 32.0),
    },
];
