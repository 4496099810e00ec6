//! What differs between the RP2040 of a Pico and the RP2350 of a Pico 2.

#[cfg(rp2350)]
pub use rp235x_hal as hal;
#[cfg(rp2040)]
pub use rp2040_hal as hal;

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
