//! Sends a pattern to the panel of a Pico 2, row by row through the DMA. With one buffer, it is
//! refilled while it is sent: a fault that the emulated picture must show. With two it is right.

use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU16, Ordering};

use embedded_hal::digital::OutputPin;
use embedded_hal::spi::MODE_0;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use rp235x_hal::block::ImageDef;
use rp235x_hal::clocks::{Clock, init_clocks_and_plls};
use rp235x_hal::fugit::RateExtU32;
use rp235x_hal::gpio::{FunctionSpi, Pins};
use rp235x_hal::pac::dma::CH;
use rp235x_hal::pac::{DMA, Peripherals, SIO, SPI1};
use rp235x_hal::{Sio, Spi, Timer, Watchdog};

#[used]
#[unsafe(link_section = ".start_block")]
static IMAGE_DEF: ImageDef = ImageDef::secure_exe();

const SIDE: usize = 240;

static ROWS: [[AtomicU16; SIDE]; 2] = [const { [const { AtomicU16::new(0) }; SIDE] }; 2];

/// D/C and CS of the panel as bits of the SIO.
const DATA_COMMAND: u32 = 1 << 8;
const CHIP_SELECT: u32 = 1 << 9;

/// Request of the transmitter of SPI1.
const SPI1_TX: u8 = 26;

/// Draws the pattern with one or two buffers.
pub fn run(buffers: usize) -> ! {
    let mut chip = Peripherals::take().unwrap();
    let clocks = init_clocks_and_plls(
        12_000_000,
        chip.XOSC,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        &mut chip.RESETS,
        &mut Watchdog::new(chip.WATCHDOG),
    )
    .unwrap();
    let mut timer = Timer::new_timer0(chip.TIMER0, &mut chip.RESETS, &clocks);
    let sio = Sio::new(chip.SIO);
    let banks = (chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0);
    let pins = Pins::new(banks.0, banks.1, banks.2, &mut chip.RESETS);
    let data = pins.gpio11.into_function::<FunctionSpi>();
    let clock = pins.gpio10.into_function::<FunctionSpi>();
    let frequency = clocks.peripheral_clock.freq();
    let bus = Spi::<_, _, _, 8>::new(chip.SPI1, (data, clock));
    let bus = bus.init(&mut chip.RESETS, frequency, 37_500_000.Hz(), MODE_0);
    let mut buffer = [0; 64];
    let chip_select = pins.gpio9.into_push_pull_output();
    let device = ExclusiveDevice::new_no_delay(bus, chip_select).unwrap();
    let data_command = pins.gpio8.into_push_pull_output();
    let display = Builder::new(ST7789, SpiInterface::new(device, data_command, &mut buffer))
        .reset_pin(pins.gpio12.into_push_pull_output())
        .display_size(SIDE as u16, SIDE as u16)
        .init(&mut timer);
    assert!(display.is_ok());
    pins.gpio13.into_push_pull_output().set_high().unwrap();
    chip.RESETS.reset().modify(|_, it| it.dma().clear_bit());
    while chip.RESETS.reset_done().read().dma().bit_is_clear() {}
    draw(&chip.DMA, buffers);
    loop {
        cortex_m::asm::nop();
    }
}

fn draw(dma: &DMA, buffers: usize) {
    // Nobody else uses them now.
    let (sio, spi) = unsafe { (SIO::steal(), SPI1::steal()) };
    let send = |byte: u8| {
        spi.sspdr()
            .write(|it| unsafe { it.data().bits(byte.into()) })
    };
    let wait = || while spi.sspsr().read().bsy().bit_is_set() {};
    sio.gpio_out_clr()
        .write(|it| unsafe { it.bits(CHIP_SELECT) });
    for (command, arguments) in [
        (0x2a, &[0, 0, 0, 239][..]),
        (0x2b, &[0, 0, 0, 239]),
        (0x2c, &[]),
    ] {
        sio.gpio_out_clr()
            .write(|it| unsafe { it.bits(DATA_COMMAND) });
        send(command);
        wait();
        sio.gpio_out_set()
            .write(|it| unsafe { it.bits(DATA_COMMAND) });
        arguments.iter().for_each(|byte| _ = send(*byte));
        wait();
    }
    send_rows(&dma.ch(0), &spi, buffers);
    wait();
    sio.gpio_out_set()
        .write(|it| unsafe { it.bits(CHIP_SELECT) });
}

fn send_rows(channel: &CH, spi: &SPI1, buffers: usize) {
    spi.sspdmacr().write(|it| it.txdmae().set_bit());
    let is_busy = || channel.ch_ctrl_trig().read().busy().bit_is_set();
    for y in 0..SIDE {
        let row = &ROWS[y % buffers];
        for (x, pixel) in row.iter().enumerate() {
            pixel.store((x * 257 ^ y * 91) as u16, Ordering::Relaxed);
        }
        while is_busy() {}
        channel
            .ch_read_addr()
            .write(|it| unsafe { it.bits(row.as_ptr() as u32) });
        channel
            .ch_write_addr()
            .write(|it| unsafe { it.bits(spi.sspdr().as_ptr() as u32) });
        channel
            .ch_trans_count()
            .write(|it| unsafe { it.bits(2 * SIDE as u32) });
        channel.ch_ctrl_trig().write(|it| unsafe {
            let it = it.treq_sel().bits(SPI1_TX).incr_read().set_bit();
            it.data_size().size_byte().en().set_bit()
        });
    }
    while is_busy() {}
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    cortex_m::asm::udf()
}
