//! Executes a few instructions, without a firmware.

use crate::board::{Board, ChipKind};
use crate::core::Core;
use crate::core::m0::M0;
use crate::core::m33::M33;
use crate::elf::Firmware;
use crate::fault::Failure;
use crate::machine::Machine;
use crate::run::Script;

/// Registers 0 to 7 and the flags N, Z, C, V and Q in the highest bits.
pub type Registers = ([u32; 8], u32);

/// Bytes of the vector table before the instructions.
const VECTORS: u32 = 8;

/// Executes instructions, given as halfwords, on the core of a chip. Registers 0 to 7 begin with
/// these values.
///
/// # Errors
/// An instruction that the core has not, or that accesses what is not there.
pub fn execute(chip: ChipKind, code: &[u16], registers: [u32; 8]) -> Result<Registers, Failure> {
    let board = match chip {
        ChipKind::Rp2040 => Board::PICO,
        ChipKind::Rp2350 => Board::PICO_2,
        ChipKind::Stm32f411 => Board::BLACK_PILL,
    };
    let base = chip.vectors();
    let start = base + VECTORS;
    let vectors = [0x2000_1000, start | 1].map(u32::to_le_bytes);
    let code = code.iter().flat_map(|it| it.to_le_bytes());
    let bytes: Vec<u8> = vectors.into_iter().flatten().chain(code).collect();
    let end = base + bytes.len() as u32;
    let firmware = Firmware {
        parts: vec![(base, bytes)],
        rtt: None,
    };
    match chip {
        ChipKind::Rp2040 => execute_on::<M0>(&board, &firmware, registers, end),
        _ => execute_on::<M33>(&board, &firmware, registers, end),
    }
}

fn execute_on<C: Core>(
    board: &Board,
    firmware: &Firmware,
    registers: [u32; 8],
    end: u32,
) -> Result<Registers, Failure> {
    let mut machine = Machine::<C>::new(board, firmware, &Script::default())?;
    let executed = machine.execute(registers, end);
    executed.map_err(|fault| machine.failure(fault))
}
