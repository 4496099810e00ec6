//! Connects the parts of the board to pins, and switches them on.

use core::fmt::Debug;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_hal_bus::spi::ExclusiveDevice;
use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::gpio::{Input, InputConfig, Level, Output, OutputConfig, Pull};
use esp_hal::spi::Mode;
use esp_hal::spi::master::{Config, Spi};
use esp_hal::time::Rate;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::{ColorInversion, Orientation, Rotation};

/// The parts of the board that the program uses, switched on.
pub struct Board<'a, D> {
    /// The panel: black, with its backlight on.
    pub display: D,
    pub key: Key,
    /// The backlight is on as long as this is not dropped.
    #[expect(dead_code, reason = "it is only kept")]
    backlight: Output<'a>,
}

/// Switches the board on. `buffer` is for the pixels on their way to the panel.
///
/// # Panics
/// Panics if the panel does not accept commands.
pub fn switch_on(
    buffer: &mut [u8],
) -> Board<'static, impl DrawTarget<Color = Rgb565, Error: Debug>> {
    let clock = esp_hal::Config::default().with_cpu_clock(CpuClock::max());
    let chip = esp_hal::init(clock);
    let low = OutputConfig::default();
    let config = Config::default().with_frequency(Rate::from_mhz(40));
    let bus = Spi::new(chip.SPI2, config.with_mode(Mode::_0)).expect("the bus has this clock");
    let bus = bus.with_sck(chip.GPIO6).with_mosi(chip.GPIO7);
    let chip_select = Output::new(chip.GPIO10, Level::High, low);
    let device = ExclusiveDevice::new_no_delay(bus, chip_select).expect("a pin can be set");
    let data_command = Output::new(chip.GPIO4, Level::Low, low);
    let mut display = Builder::new(ST7789, SpiInterface::new(device, data_command, buffer))
        .reset_pin(Output::new(chip.GPIO5, Level::High, low))
        .display_size(240, 240)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut Delay::new())
        .expect("the panel takes commands");
    display
        .clear(Rgb565::BLACK)
        .expect("the panel takes pixels");
    let pull_up = InputConfig::default().with_pull(Pull::Up);
    Board {
        display,
        key: Key(Input::new(chip.GPIO9, pull_up)),
        backlight: Output::new(chip.GPIO3, Level::High, low),
    }
}

/// The key BOOT of the board. It connects its pin to ground.
pub struct Key(Input<'static>);

impl Key {
    /// Waits until the key is pressed and released.
    pub fn wait(&mut self) {
        while self.0.is_high() {}
        while self.0.is_low() {
            // Contacts bounce for some milliseconds.
            Delay::new().delay_millis(10);
        }
    }
}
