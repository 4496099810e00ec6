//! Stream 3 of DMA2, which sends bytes from memory to SPI1.

use super::table::{DMA, Kind, SPI, STREAM};
use crate::fault::{Fault, fault, require};
use crate::memory::Memory;
use crate::registers::Registers;

const CONTROL: u32 = STREAM;
const COUNT: u32 = STREAM + 0x04;
const TARGET: u32 = STREAM + 0x08;
const SOURCE: u32 = STREAM + 0x0c;
const FIFO: u32 = STREAM + 0x14;

/// Flags of the streams 0 to 3, and the register that clears them.
const FLAGS: u32 = DMA;
const CLEARED: u32 = DMA + 0x08;

/// Flags of stream 3: the mask of all, and the one that is set when a transfer is complete.
const OWN_FLAGS: u32 = 0x3d << 22;
const COMPLETE: u32 = 1 << 27;

const ENABLED: u32 = 1;

/// The bits of the stream's settings that are checked, and how they must be: channel 3, from memory to a peripheral, bytes,
/// one buffer, no bursts; the address in memory is incremented, that of the peripheral is not.
const MASK: u32 = 0x0fe4_7fe0;
const WANTED: u32 = 3 << 25 | 1 << 10 | 1 << 6;

/// Bit of the FIFO's settings: the FIFO collects bytes before they are sent.
const WAITS: u32 = 1 << 2;

/// Writes a register of the DMA.
pub fn write(it: &mut Registers<Kind>, address: u32, value: u32) -> Result<(), Fault> {
    let rests = it.get(CONTROL) & ENABLED == 0;
    require!(
        rests || address < STREAM,
        "the DMA is changed while it works"
    );
    if address == CLEARED {
        it.set(FLAGS, it.get(FLAGS) & !value);
        return Ok(());
    }
    if address == CONTROL && value & ENABLED != 0 {
        let is_plain = value & MASK == WANTED && it.get(FIFO) & WAITS == 0;
        require!(is_plain, "the DMA does not send bytes one after another");
        let flags = it.get(FLAGS) & OWN_FLAGS;
        require!(flags == 0, "the DMA's flags are not cleared");
        let (target, data) = (it.get(TARGET), SPI + super::SPI_DATA);
        require!(target == data, "the DMA sends to {target:#010x}");
        require!(it.get(COUNT) > 0, "the DMA has nothing to send");
    }
    it.set(address, value);
    Ok(())
}

/// Returns the next byte that the stream sends. `None` if the stream is idle.
pub fn next(it: &mut Registers<Kind>, memory: &Memory) -> Result<Option<u8>, Fault> {
    if it.get(CONTROL) & ENABLED == 0 {
        return Ok(None);
    }
    let source = it.get(SOURCE);
    let byte = memory.read(source, 1);
    let byte = byte.ok_or_else(|| fault!("the DMA reads {source:#010x}"))?;
    it.set(SOURCE, source + 1);
    let left = it.get(COUNT) - 1;
    it.set(COUNT, left);
    if left == 0 {
        it.set(CONTROL, it.get(CONTROL) & !ENABLED);
        it.set(FLAGS, it.get(FLAGS) | COMPLETE);
    }
    Ok(Some(byte as u8))
}
