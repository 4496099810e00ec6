//! The bus to the panel: the DMA sends pixels while the next ones are traced.

use core::cell::{Ref, RefCell};
use core::convert::Infallible;

use cortex_m::singleton;
use mipidsi::interface::{Interface, InterfaceKind};
use stm32f4xx_hal::dma::config::DmaConfig;
use stm32f4xx_hal::dma::{MemoryToPeripheral, Stream3, Transfer};
use stm32f4xx_hal::gpio::{Output, PA4, PB0};
use stm32f4xx_hal::pac::{DMA2, SPI1};

/// Most bytes that are sent at once: four rows of the panel, the largest area of a picture.
const BLOCK: usize = 4 * 2 * 240;

/// Pixels in the panel's byte order. The DMA borrows a block until it has sent it.
type Block = RefCell<[u8; BLOCK]>;

/// The DMA and the SPI, at rest or at work. SPI1 requests bytes from stream 3 on channel 3.
enum State {
    Idle(Stream3<DMA2>, SPI1),
    Sending(Transfer<Stream3<DMA2>, 3, SPI1, MemoryToPeripheral, Ref<'static, [u8]>>),
}

/// The SPI and the pins of the panel.
pub struct Bus {
    /// `None` only while it changes.
    state: Option<State>,
    chip_select: PA4<Output>,
    data_command: PB0<Output>,
    /// The block that is filled, and the one that was sent last.
    blocks: [&'static Block; 2],
}

impl Bus {
    /// Takes over an SPI that is set up. Returns `None` if it is called again.
    pub fn new(
        (dma, spi): (Stream3<DMA2>, SPI1),
        (chip_select, data_command): (PA4<Output>, PB0<Output>),
    ) -> Option<Self> {
        spi.cr2().modify(|_, it| it.txdmaen().enabled());
        Some(Self {
            state: Some(State::Idle(dma, spi)),
            chip_select,
            data_command,
            blocks: [
                singleton!(: Block = RefCell::new([0; BLOCK]))?,
                singleton!(: Block = RefCell::new([0; BLOCK]))?,
            ],
        })
    }

    /// Waits until the DMA and the SPI rest, and takes them.
    fn wait(&mut self) -> Option<(Stream3<DMA2>, SPI1)> {
        let (dma, spi) = match self.state.take()? {
            State::Idle(dma, spi) => (dma, spi),
            State::Sending(transfer) => {
                transfer.wait();
                let (dma, spi, ..) = transfer.release();
                (dma, spi)
            }
        };
        flush(&spi);
        Some((dma, spi))
    }

    /// Starts to send this many bytes of the block, after the one before is sent.
    fn send(&mut self, bytes: usize) {
        if let Some((dma, spi)) = self.wait() {
            let block = Ref::map(self.blocks[0].borrow(), |block| &block[..bytes]);
            let config = DmaConfig::default().memory_increment(true);
            let mut transfer = Transfer::init_memory_to_peripheral(dma, spi, block, None, config);
            transfer.start(|_| {});
            self.state = Some(State::Sending(transfer));
            self.blocks.swap(0, 1);
        }
    }
}

/// Sends bytes without the DMA.
fn write(spi: &SPI1, bytes: &[u8]) {
    for byte in bytes {
        while spi.sr().read().txe().is_not_empty() {}
        spi.dr().write(|it| it.dr().set(u16::from(*byte)));
    }
    flush(spi);
}

/// Waits until the last byte is sent.
fn flush(spi: &SPI1) {
    while spi.sr().read().txe().is_not_empty() || spi.sr().read().bsy().is_busy() {}
}

impl Interface for Bus {
    type Word = u8;
    type Error = Infallible;

    const KIND: InterfaceKind = InterfaceKind::Serial4Line;

    fn send_command(&mut self, command: u8, arguments: &[u8]) -> Result<(), Infallible> {
        if let Some((dma, spi)) = self.wait() {
            self.chip_select.set_high();
            self.data_command.set_low();
            self.chip_select.set_low();
            write(&spi, &[command]);
            self.data_command.set_high();
            write(&spi, arguments);
            self.state = Some(State::Idle(dma, spi));
        }
        Ok(())
    }

    fn send_pixels<const N: usize>(
        &mut self,
        pixels: impl IntoIterator<Item = [u8; N]>,
    ) -> Result<(), Infallible> {
        let mut pixels = pixels.into_iter();
        loop {
            let mut block = self.blocks[0].borrow_mut();
            let mut bytes = 0;
            for (place, pixel) in block.chunks_exact_mut(N).zip(&mut pixels) {
                place.copy_from_slice(&pixel);
                bytes += N;
            }
            drop(block);
            if bytes == 0 {
                return Ok(());
            }
            self.send(bytes);
        }
    }

    fn send_repeated_pixel<const N: usize>(
        &mut self,
        pixel: [u8; N],
        count: u32,
    ) -> Result<(), Infallible> {
        self.send_pixels((0..count).map(|_| pixel))
    }
}
