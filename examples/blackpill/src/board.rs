//! Connects the parts of the board to pins, and switches them on.

#[path = "bus.rs"]
mod bus;

use core::fmt::Debug;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use mipidsi::Builder;
use mipidsi::models::ST7789;
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use stm32f4xx_hal::dma::StreamsTuple;
use stm32f4xx_hal::gpio::{Input, PA0, Speed};
use stm32f4xx_hal::pac::Peripherals;
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Config;
use stm32f4xx_hal::spi::{Mode, Phase, Polarity, Spi};
use stm32f4xx_hal::timer::SysDelay;

use bus::Bus;

/// Clock of the core in MHz: the most that the chip is made for.
pub const CORE_MHZ: u32 = 100;

/// Frequency of the board's crystal in MHz.
const CRYSTAL_MHZ: u32 = 25;

/// The parts of the board that the program uses, switched on.
pub struct Board<D> {
    /// The panel: black, with its backlight on.
    pub display: D,
    pub key: Key,
}

/// Switches the board on.
///
/// # Panics
/// Panics if the panel does not accept commands, or if it is called again.
pub fn switch_on() -> Board<impl DrawTarget<Color = Rgb565, Error: Debug>> {
    let chip = Peripherals::take().expect("the board is switched on once");
    let mut core = cortex_m::Peripherals::take().expect("the board is switched on once");
    core.DCB.enable_trace();
    core.DWT.enable_cycle_counter();
    // The core voltage for more than 84 MHz, while the PLL is still off.
    chip.RCC.apb1enr().modify(|_, it| it.pwren().enabled());
    chip.PWR.cr().modify(|_, it| it.vos().scale1());
    let clocks = Config::hse(CRYSTAL_MHZ.MHz()).sysclk(CORE_MHZ.MHz());
    let mut clocks = chip.RCC.freeze(clocks);
    let mut delay = core.SYST.delay(&clocks.clocks);
    let a = chip.GPIOA.split(&mut clocks);
    let b = chip.GPIOB.split(&mut clocks);

    let mode = Mode {
        polarity: Polarity::IdleLow,
        phase: Phase::CaptureOnFirstTransition,
    };
    let fast = Speed::VeryHigh;
    let pins = (
        Some(a.pa5.into_alternate().speed(fast)),
        Some(a.pa7.into_alternate().speed(fast)),
    );
    let (spi, _) = Spi::new_bidi(chip.SPI1, pins, mode, 50.MHz(), &mut clocks).release();
    let dma = StreamsTuple::new(chip.DMA2, &mut clocks).3;
    let chip_select = a.pa4.into_push_pull_output();
    let data_command = b.pb0.into_push_pull_output();
    let bus = Bus::new((dma, spi), (chip_select, data_command));
    let mut display = Builder::new(ST7789, bus.expect("the board is switched on once"))
        .reset_pin(b.pb1.into_push_pull_output())
        .display_size(240, 240)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut delay)
        .expect("the panel takes commands");
    display
        .clear(Rgb565::BLACK)
        .expect("the panel takes pixels");
    b.pb10.into_push_pull_output().set_high();

    let pin = a.pa0.into_pull_up_input();
    let key = Key { pin, delay };
    Board { display, key }
}

/// The key KEY of the board. It connects its pin to ground.
pub struct Key {
    pin: PA0<Input>,
    delay: SysDelay,
}

impl Key {
    /// Tests whether the key is pressed.
    pub fn is_pressed(&self) -> bool {
        self.pin.is_low()
    }

    /// Waits until the key is pressed and released.
    pub fn wait(&mut self) {
        while !self.is_pressed() {}
        while self.is_pressed() {
            // Contacts bounce for some milliseconds.
            self.delay.delay_ms(10_u32);
        }
    }
}
