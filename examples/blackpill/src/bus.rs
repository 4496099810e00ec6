//! The bus to the panel. It only sends, so that a byte can follow the last one at once: the SPI of the HAL waits for
//! each to come back.

use stm32f4xx_hal::hal::spi::{ErrorType, SpiBus};
use stm32f4xx_hal::pac::SPI1;
use stm32f4xx_hal::spi::{Error, Spi};

/// An SPI on one line.
pub struct Bus(pub Spi<SPI1, true>);

impl ErrorType for Bus {
    type Error = Error;
}

impl SpiBus for Bus {
    fn read(&mut self, words: &mut [u8]) -> Result<(), Error> {
        self.0.read(words)
    }

    fn write(&mut self, words: &[u8]) -> Result<(), Error> {
        self.0.write(words)
    }

    fn transfer(&mut self, read: &mut [u8], write: &[u8]) -> Result<(), Error> {
        self.0.transfer(read, write)
    }

    fn transfer_in_place(&mut self, words: &mut [u8]) -> Result<(), Error> {
        self.0.transfer_in_place(words)
    }

    fn flush(&mut self) -> Result<(), Error> {
        while !self.0.is_tx_empty() || self.0.is_busy() {}
        Ok(())
    }
}
