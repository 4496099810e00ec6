//! Connects the parts of the board to pins, and switches them on.

#[path = "chip.rs"]
pub mod chip;

use core::fmt::Debug;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{MODE_0, SpiBus};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::{ColorInversion, Orientation, Rotation};

use crate::screen::Screen;
use chip::hal::clocks::Clock;
use chip::hal::dma::DMAExt;
pub use chip::hal::entry;
use chip::hal::gpio::bank0::{Gpio8, Gpio9, Gpio10, Gpio11};
use chip::hal::gpio::{DynPinId, FunctionSioInput, FunctionSpi, Pin, Pins, PullUp};
use chip::hal::pac::{PPB, PSM, Peripherals, SPI1};
use chip::hal::sio::SioFifo;
use chip::hal::{Sio, Spi, Watchdog};
use chip::{Timer, init_clocks_and_plls};

/// Frequency of the crystal of both boards, in Hz.
const CRYSTAL: u32 = 12_000_000;

// The display's pins as types. For other pins, change them here and in `switch_on`.

/// SPI unit that has the pins of data and clock.
pub type SpiUnit = SPI1;
/// Pin of DIN or SDA: one of the unit's TX pins.
pub type DataPin = Gpio11;
/// Pin of CLK or SCL: one of the unit's SCK pins.
pub type ClockPin = Gpio10;
/// Pin of CS. A display without one leaves it open.
pub type ChipSelectPin = Gpio9;
/// Pin of DC.
pub type DataCommandPin = Gpio8;

/// Input pin that a key connects to ground while it is pressed.
pub type KeyPin = Pin<DynPinId, FunctionSioInput, PullUp>;

/// The parts of the board that the program uses, switched on.
pub struct Board {
    /// The panel: black, with its backlight on.
    pub screen: Screen,
    /// Keys up, down, left, right and select.
    pub keys: [KeyPin; 5],
    /// Switch of the second core, its interrupts, and the FIFO to it.
    pub second_core: (PSM, PPB, SioFifo),
    pub timer: Timer,
}

/// Switches the board on.
///
/// # Panics
/// Panics if a clock does not start, if the panel does not accept commands, or if it is called
/// again.
pub fn switch_on() -> Board {
    let mut chip = Peripherals::take().expect("the board is switched on once");
    #[cfg(rp2040)]
    chip::raise_voltage(chip.VREG_AND_CHIP_RESET);
    let clocks = init_clocks_and_plls(
        CRYSTAL,
        chip.XOSC,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        &mut chip.RESETS,
        &mut Watchdog::new(chip.WATCHDOG),
    )
    .expect("the crystal oscillates");
    #[cfg(rp2040)]
    let timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
    #[cfg(rp2350)]
    let timer = Timer::new_timer0(chip.TIMER0, &mut chip.RESETS, &clocks);
    let sio = Sio::new(chip.SIO);
    let pins = Pins::new(
        chip.IO_BANK0,
        chip.PADS_BANK0,
        sio.gpio_bank0,
        &mut chip.RESETS,
    );

    let keys = [
        pins.gpio2.into_pull_up_input().into_dyn_pin(),
        pins.gpio18.into_pull_up_input().into_dyn_pin(),
        pins.gpio16.into_pull_up_input().into_dyn_pin(),
        pins.gpio20.into_pull_up_input().into_dyn_pin(),
        pins.gpio3.into_pull_up_input().into_dyn_pin(),
    ];

    let data = pins.gpio11.into_function::<FunctionSpi>();
    let clock = pins.gpio10.into_function::<FunctionSpi>();
    let mut bus = Spi::<_, _, _, 8>::new(chip.SPI1, (data, clock)).init(
        &mut chip.RESETS,
        clocks.peripheral_clock.freq(),
        clocks.peripheral_clock.freq() / 4,
        MODE_0,
    );
    let mut chip_select = pins.gpio9.into_push_pull_output();
    let mut data_command = pins.gpio8.into_push_pull_output();
    let reset = pins.gpio12.into_push_pull_output();
    set_up(&mut bus, &mut chip_select, &mut data_command, reset, timer);
    let mut backlight = pins.gpio13.into_push_pull_output();
    backlight.set_high().expect("a pin can be set");

    let dma = chip.DMA.split(&mut chip.RESETS).ch0;
    let screen = Screen::new((dma, bus), (chip_select, data_command));
    Board {
        screen: screen.expect("the board is switched on once"),
        keys,
        second_core: (chip.PSM, chip.PPB, sio.fifo),
        timer,
    }
}

/// Sets up the panel behind these pins, and fills it with black.
fn set_up(
    bus: impl SpiBus<Error: Debug>,
    chip_select: impl OutputPin<Error: Debug>,
    data_command: impl OutputPin<Error: Debug>,
    reset: impl OutputPin<Error: Debug>,
    mut timer: Timer,
) {
    let device = ExclusiveDevice::new_no_delay(bus, chip_select).expect("a pin can be set");
    let mut buffer = [0; 512];
    let mut display = Builder::new(ST7789, SpiInterface::new(device, data_command, &mut buffer))
        .reset_pin(reset)
        .display_size(240, 240)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut timer)
        .expect("the panel takes commands");
    display
        .clear(Rgb565::BLACK)
        .expect("the panel takes pixels");
}
