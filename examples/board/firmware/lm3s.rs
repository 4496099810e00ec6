//! Drives the LM3S6965's SPI and pins through the traits of embedded-hal, and the tick that wakes
//! the core. Knows how the evaluation board is wired, but nothing of pictures.
//!
//! Registers: Texas Instruments, Stellaris LM3S6965 data sheet, chapters 5, 8 and 14.

use core::convert::Infallible;

use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;
use embedded_hal::{digital, spi};

/// Clock of the core in Hz.
const CLOCK: u32 = 50_000_000;

/// Number of ticks a second. Each wakes the core.
const TICKS: u32 = 100;

/// The parts of the evaluation board that the firmware uses.
pub struct Board {
    pub spi: Spi,
    /// Pin of the display: high for data, low for commands.
    pub data_command: Output,
    pub up: Button,
    pub down: Button,
    pub left: Button,
    pub right: Button,
    pub select: Button,
}

impl Board {
    /// Switches on the used parts of the board. Returns `None` if it was called before.
    pub fn take() -> Option<Self> {
        let mut tick = cortex_m::Peripherals::take()?.SYST;
        start_clock();
        tick.set_clock_source(SystClkSource::Core);
        tick.set_reload(CLOCK / TICKS - 1);
        tick.clear_current();
        tick.enable_interrupt();
        tick.enable_counter();

        const SSI_CLOCKS: Register = Register(0x400f_e104);
        const PORT_CLOCKS: Register = Register(0x400f_e108);
        SSI_CLOCKS.change(0, 1 << 4);
        PORT_CLOCKS.change(0, 0b11_0101);
        // A part of the chip can be accessed three cycles after its clock was switched on.
        cortex_m::asm::delay(3);

        Some(Self {
            spi: Spi::new(),
            data_command: Output::new(PORT_C, 7),
            up: Button::new(PORT_E, 0),
            down: Button::new(PORT_E, 1),
            left: Button::new(PORT_E, 2),
            right: Button::new(PORT_E, 3),
            select: Button::new(PORT_F, 1),
        })
    }
}

/// Switches the clock from the internal oscillator to a quarter of the PLL's 200 MHz, fed by the
/// board's crystal of 8 MHz; data sheet, 5.3.
fn start_clock() {
    const STATUS: Register = Register(0x400f_e050);
    const LOCKED: u32 = 1 << 6;
    const CONTROL: Register = Register(0x400f_e060);
    const USE_DIVIDER: u32 = 1 << 22;
    const PLL_OFF: u32 = 1 << 13 | 1 << 12;
    const BYPASS_PLL: u32 = 1 << 11;
    const CRYSTAL_OFF: u32 = 1 << 0;
    // Divider, crystal and source: 4, 8 MHz, the crystal.
    const CHOICES: u32 = 0xf << 23 | 0xf << 6 | 0x3 << 4;
    const CHOSEN: u32 = 3 << 23 | 0xe << 6;

    CONTROL.change(USE_DIVIDER | CRYSTAL_OFF, BYPASS_PLL);
    // The crystal needs time to become stable.
    cortex_m::asm::delay(1 << 19);
    CONTROL.change(CHOICES | PLL_OFF, CHOSEN | USE_DIVIDER);
    while STATUS.read() & LOCKED == 0 {}
    CONTROL.change(BYPASS_PLL, 0);
}

/// Sleeps until the next tick or another event wakes the core.
pub fn sleep() {
    cortex_m::asm::wfi();
}

#[exception]
fn SysTick() {}

/// Waits for a time without sleeping.
pub fn delay(milliseconds: u32) {
    cortex_m::asm::delay(CLOCK / 1000 * milliseconds);
}

/// SSI0 as an SPI master for bytes at 3.1 MHz. The clock is high when idle, and its own select pin
/// selects the OLED.
pub struct Spi(());

impl Spi {
    const CONTROL_0: Register = Register(0x4000_8000);
    const CONTROL_1: Register = Register(0x4000_8004);
    const DATA: Register = Register(0x4000_8008);
    const STATUS: Register = Register(0x4000_800c);
    const PRESCALE: Register = Register(0x4000_8010);

    fn new() -> Self {
        // Clock, select and data out: PA2, PA3 and PA5.
        const PINS: u32 = 0b10_1100;
        PORT_A.at(FUNCTION).change(0, PINS);
        PORT_A.at(DIGITAL).change(0, PINS);
        Self::CONTROL_1.write(0);
        Self::PRESCALE.write(16);
        Self::CONTROL_0.write(0x47);
        Self::CONTROL_1.write(2);
        Self(())
    }

    /// Sends a byte and returns the byte that was received meanwhile.
    fn exchange(&mut self, byte: u8) -> u8 {
        const RECEIVED: u32 = 1 << 2;
        Self::DATA.write(byte.into());
        while Self::STATUS.read() & RECEIVED == 0 {}
        Self::DATA.read() as u8
    }
}

impl spi::ErrorType for Spi {
    type Error = Infallible;
}

impl spi::SpiBus for Spi {
    fn read(&mut self, words: &mut [u8]) -> Result<(), Infallible> {
        words.fill(0);
        self.transfer_in_place(words)
    }

    fn write(&mut self, words: &[u8]) -> Result<(), Infallible> {
        for &word in words {
            self.exchange(word);
        }
        Ok(())
    }

    fn transfer(&mut self, read: &mut [u8], write: &[u8]) -> Result<(), Infallible> {
        for index in 0..read.len().max(write.len()) {
            let word = self.exchange(write.get(index).copied().unwrap_or(0));
            if let Some(place) = read.get_mut(index) {
                *place = word;
            }
        }
        Ok(())
    }

    fn transfer_in_place(&mut self, words: &mut [u8]) -> Result<(), Infallible> {
        for word in words {
            *word = self.exchange(*word);
        }
        Ok(())
    }

    /// Returns at once: every byte has been sent when its answer has been received.
    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// A pin of a port, set up as an output.
pub struct Output {
    level: Register,
}

impl Output {
    fn new(port: Port, pin: u32) -> Self {
        port.at(DIRECTION).change(0, 1 << pin);
        port.at(DIGITAL).change(0, 1 << pin);
        Self {
            level: port.level(pin),
        }
    }
}

impl digital::ErrorType for Output {
    type Error = Infallible;
}

impl digital::OutputPin for Output {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.level.write(0);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.level.write(0xff);
        Ok(())
    }
}

/// An input pin that a button pulls low while it is pressed. The port remembers a release.
pub struct Button {
    port: Port,
    pin: u32,
}

impl Button {
    fn new(port: Port, pin: u32) -> Self {
        port.at(PULL_UP).change(0, 1 << pin);
        port.at(DIGITAL).change(0, 1 << pin);
        port.at(NOTE_RISE).change(0, 1 << pin);
        // Rises before this moment do not come from the key.
        port.at(FORGET).write(1 << pin);
        Self { port, pin }
    }

    /// Tests whether the level has risen since the last call.
    pub fn has_risen(&mut self) -> bool {
        let risen = self.port.at(NOTED).read() & 1 << self.pin != 0;
        self.port.at(FORGET).write(1 << self.pin);
        risen
    }
}

impl digital::ErrorType for Button {
    type Error = Infallible;
}

impl digital::InputPin for Button {
    fn is_high(&mut self) -> Result<bool, Infallible> {
        Ok(self.port.level(self.pin).read() != 0)
    }

    fn is_low(&mut self) -> Result<bool, Infallible> {
        self.is_high().map(|high| !high)
    }
}

/// A port of eight pins, by its base address.
#[derive(Clone, Copy)]
struct Port(usize);

const PORT_A: Port = Port(0x4000_4000);
const PORT_C: Port = Port(0x4000_6000);
const PORT_E: Port = Port(0x4002_4000);
const PORT_F: Port = Port(0x4002_5000);

// Offsets of a port's registers, which have one bit for each pin. After a reset, pins are inputs and
// falls are noted.
const DIRECTION: usize = 0x400;
const NOTE_RISE: usize = 0x40c;
const NOTED: usize = 0x414;
const FORGET: usize = 0x41c;
const FUNCTION: usize = 0x420;
const PULL_UP: usize = 0x510;
const DIGITAL: usize = 0x51c;

impl Port {
    const fn at(self, offset: usize) -> Register {
        Register(self.0 + offset)
    }

    /// Returns the data register of one pin. The address itself selects which of the eight pins are
    /// accessed.
    const fn level(self, pin: u32) -> Register {
        self.at(4 << pin)
    }
}

/// A register of the chip, by its address. Only this file creates registers.
#[derive(Clone, Copy)]
struct Register(usize);

impl Register {
    fn read(self) -> u32 {
        // SAFETY: every address in this file is the aligned address of a register of the chip, and
        // Rust places no variable there.
        unsafe { (self.0 as *const u32).read_volatile() }
    }

    fn write(self, value: u32) {
        // SAFETY: as in `read`. A write only affects the part of the chip that the register belongs
        // to.
        unsafe { (self.0 as *mut u32).write_volatile(value) }
    }

    /// Clears some bits, then sets some, and keeps the others.
    fn change(self, clear: u32, set: u32) {
        self.write(self.read() & !clear | set);
    }
}
