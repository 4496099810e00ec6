//! Sends a pattern to the panel of a Pico 2, row by row through the DMA. With one buffer, it is
//! refilled while it is sent: a fault that the emulated picture must show. With two it is right.

use core::panic::PanicInfo;
use core::sync::atomic::{AtomicU16, Ordering};

use rp235x_hal::pac::dma::CH;
use rp235x_hal::pac::{DMA, SIO, SPI1};

use crate::board;

const SIDE: usize = 240;

static ROWS: [[AtomicU16; SIDE]; 2] = [const { [const { AtomicU16::new(0) }; SIDE] }; 2];

/// D/C and CS of the panel as bits of the SIO.
const DATA_COMMAND: u32 = 1 << 8;
const CHIP_SELECT: u32 = 1 << 9;

/// Request of the transmitter of SPI1.
const SPI1_TX: u8 = 26;

pub fn run(buffers: usize) -> ! {
    let _board = board::switch_on();
    draw(buffers);
    loop {
        cortex_m::asm::nop();
    }
}

fn draw(buffers: usize) {
    // The board is set up and rests: nobody else uses them now.
    let (sio, spi, dma) = unsafe { (SIO::steal(), SPI1::steal(), DMA::steal()) };
    let send = |byte: u8| {
        let data = spi.sspdr();
        data.write(|it| unsafe { it.data().bits(byte.into()) });
    };
    let wait = || while spi.sspsr().read().bsy().bit_is_set() {};
    let clear = |pins| sio.gpio_out_clr().write(|it| unsafe { it.bits(pins) });
    let set = |pins| sio.gpio_out_set().write(|it| unsafe { it.bits(pins) });
    clear(CHIP_SELECT);
    for (command, arguments) in [
        (0x2a, &[0, 0, 0, 239][..]),
        (0x2b, &[0, 0, 0, 239]),
        (0x2c, &[]),
    ] {
        clear(DATA_COMMAND);
        send(command);
        wait();
        set(DATA_COMMAND);
        arguments.iter().for_each(|byte| send(*byte));
        wait();
    }
    send_rows(dma.ch(0), &spi, buffers);
    wait();
    set(CHIP_SELECT);
}

fn send_rows(channel: &CH, spi: &SPI1, buffers: usize) {
    spi.sspdmacr().write(|it| it.txdmae().set_bit());
    let is_busy = || channel.ch_ctrl_trig().read().busy().bit_is_set();
    for y in 0..SIDE {
        let row = &ROWS[y % buffers];
        for (x, pixel) in row.iter().enumerate() {
            pixel.store(((x * 257) ^ (y * 91)) as u16, Ordering::Relaxed);
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
