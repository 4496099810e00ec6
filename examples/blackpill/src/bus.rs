//! The SPI bus to the panel, on one line: it only sends. On two lines, the HAL waits after each byte until one is
//! received.

use stm32f4xx_hal::hal::spi::{ErrorType, SpiBus};
use stm32f4xx_hal::pac::SPI1;
use stm32f4xx_hal::spi::{Error, Spi};

/// All that would receive panics: the panel is never asked.
pub struct Bus(pub Spi<SPI1, true>);

impl ErrorType for Bus {
    type Error = Error;
}

impl SpiBus for Bus {
    fn read(&mut self, _: &mut [u8]) -> Result<(), Error> {
        unreachable!()
    }

    fn write(&mut self, words: &[u8]) -> Result<(), Error> {
        self.0.write(words)
    }

    fn transfer(&mut self, _: &mut [u8], _: &[u8]) -> Result<(), Error> {
        unreachable!()
    }

    fn transfer_in_place(&mut self, _: &mut [u8]) -> Result<(), Error> {
        unreachable!()
    }

    /// Waits for the end of the last byte: the HAL's own function returns at once, and chip select would rise too early.
    fn flush(&mut self) -> Result<(), Error> {
        while !self.0.is_tx_empty() || self.0.is_busy() {}
        Ok(())
    }
}
