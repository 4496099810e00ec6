//! What differs between the RP2040 of a Pico and the RP2350 of a Pico 2.

#[cfg(rp2350)]
pub use rp235x_hal as hal;
#[cfg(rp2040)]
pub use rp2040_hal as hal;

#[cfg(rp2350)]
pub use hal::clocks::init_clocks_and_plls;
#[cfg(rp2040)]
use hal::{
    Watchdog,
    clocks::{ClocksManager, InitError},
    fugit::{HertzU32, RateExtU32},
    pac::vreg_and_chip_reset::vreg::VSEL_A,
    pac::{CLOCKS, PLL_SYS, PLL_USB, RESETS, VREG_AND_CHIP_RESET, XOSC},
    pll::{PLLConfig, common_configs::PLL_USB_48MHZ, setup_pll_blocking},
    vreg::set_voltage,
    xosc::setup_xosc_blocking,
};

#[cfg(rp2040)]
pub use hal::Timer;
#[cfg(rp2350)]
pub type Timer = hal::Timer<hal::timer::CopyableTimer0>;

/// Second stage of the boot loader. It makes the flash readable as memory.
#[cfg(rp2040)]
#[used]
#[unsafe(link_section = ".boot2")]
static BOOT2_FIRMWARE: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Tells the boot ROM that this is a program for the Arm cores.
#[cfg(rp2350)]
#[used]
#[unsafe(link_section = ".start_block")]
static IMAGE_DEF: hal::block::ImageDef = hal::block::ImageDef::secure_exe();

/// The PLL of an RP2040's cores at 200 MHz, for which the chip is certified at a core voltage of 1.15 V (release
/// notes of the Pico SDK 2.1.1).
#[cfg(rp2040)]
const PLL_SYS_200MHZ: PLLConfig = PLLConfig {
    vco_freq: HertzU32::MHz(1200),
    refdiv: 1,
    post_div1: 6,
    post_div2: 1,
};

/// Raises the core voltage to 1.15 V, and waits for at least a millisecond.
#[cfg(rp2040)]
pub fn raise_voltage(mut regulator: VREG_AND_CHIP_RESET) {
    set_voltage(&mut regulator, VSEL_A::VOLTAGE1_15);
    // As many cycles as a millisecond has at 200 MHz. The clock is slower, unless a debugger has left the last one.
    cortex_m::asm::delay(200_000);
}

/// Starts the clocks as the function of this name in `rp2040-hal` does, but with the cores at 200 MHz.
#[cfg(rp2040)]
pub fn init_clocks_and_plls(
    crystal: u32,
    oscillator: XOSC,
    clocks: CLOCKS,
    cores: PLL_SYS,
    usb: PLL_USB,
    resets: &mut RESETS,
    watchdog: &mut Watchdog,
) -> Result<ClocksManager, InitError> {
    let crystal = setup_xosc_blocking(oscillator, crystal.Hz()).map_err(InitError::XoscErr)?;
    let frequency = crystal.operating_frequency();
    watchdog.enable_tick_generation(frequency.to_MHz() as u8);
    let mut clocks = ClocksManager::new(clocks);
    let cores = setup_pll_blocking(cores, frequency, PLL_SYS_200MHZ, &mut clocks, resets)
        .map_err(InitError::PllError)?;
    let usb = setup_pll_blocking(usb, frequency, PLL_USB_48MHZ, &mut clocks, resets)
        .map_err(InitError::PllError)?;
    clocks
        .init_default(&crystal, &cores, &usb)
        .map_err(InitError::ClockError)?;
    Ok(clocks)
}
