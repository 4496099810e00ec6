//! Connects the parts of the board to pins, and switches them on.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_hal::{digital::OutputPin, spi::MODE_0};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ST7789};
use rp235x_hal::clocks::{Clock, init_clocks_and_plls};
use rp235x_hal::dma::DMAExt;
use rp235x_hal::fugit::RateExtU32;
use rp235x_hal::gpio::{FunctionSioInput, FunctionSpi, Pin, Pins, PullUp, bank0::Gpio20};
use rp235x_hal::pac::{PPB, PSM, Peripherals};
use rp235x_hal::sio::SioFifo;
use rp235x_hal::timer::CopyableTimer0;
use rp235x_hal::{Sio, Spi, Timer, Watchdog};

use crate::screen::{SIDE, Screen};

/// Frequency of the board's crystal, in Hz.
const CRYSTAL: u32 = 12_000_000;

/// The parts of the board that the program uses, switched on.
pub struct Board {
    /// The panel: black, with its backlight on.
    pub screen: Screen,
    /// The key that orbits the camera. It connects its pin to ground.
    pub key: Pin<Gpio20, FunctionSioInput, PullUp>,
    /// Switch of the second core, its interrupts, and the FIFO to it.
    pub second_core: (PSM, PPB, SioFifo),
    pub timer: Timer<CopyableTimer0>,
}

/// Switches the board on.
///
/// # Panics
/// Panics if a clock does not start, if the panel does not accept commands, or if it is called
/// again.
pub fn switch_on() -> Board {
    let mut chip = Peripherals::take().expect("the board is switched on once");
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
    let mut timer = Timer::new_timer0(chip.TIMER0, &mut chip.RESETS, &clocks);
    let sio = Sio::new(chip.SIO);
    let banks = (chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0);
    let pins = Pins::new(banks.0, banks.1, banks.2, &mut chip.RESETS);
    let data = pins.gpio11.into_function::<FunctionSpi>();
    let clock = pins.gpio10.into_function::<FunctionSpi>();
    let frequency = clocks.peripheral_clock.freq();
    let bus = Spi::<_, _, _, 8>::new(chip.SPI1, (data, clock));
    let mut bus = bus.init(&mut chip.RESETS, frequency, 37_500_000.Hz(), MODE_0);
    let mut chip_select = pins.gpio9.into_push_pull_output();
    let mut data_command = pins.gpio8.into_push_pull_output();
    let mut buffer = [0; 512];
    let device = ExclusiveDevice::new_no_delay(&mut bus, &mut chip_select);
    let device = device.expect("a pin can be set");
    let interface = SpiInterface::new(device, &mut data_command, &mut buffer);
    let mut display = Builder::new(ST7789, interface)
        .reset_pin(pins.gpio12.into_push_pull_output())
        .display_size(SIDE as u16, SIDE as u16)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut timer)
        .expect("the panel takes commands");
    display
        .clear(Rgb565::BLACK)
        .expect("the panel takes pixels");
    let mut backlight = pins.gpio13.into_push_pull_output();
    backlight.set_high().expect("a pin can be set");

    let dma = chip.DMA.split(&mut chip.RESETS).ch0;
    let screen = Screen::new((dma, bus), (chip_select, data_command));
    Board {
        screen: screen.expect("the board is switched on once"),
        key: pins.gpio20.into_pull_up_input(),
        second_core: (chip.PSM, chip.PPB, sio.fifo),
        timer,
    }
}
