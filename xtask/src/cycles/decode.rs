//! Decodes Arm Thumb instructions, as far as their timing depends on them.

use anyhow::{Context, Result};
use capstone::arch::arm::ArmReg::*;
use capstone::arch::arm::{ArchExtraMode, ArchMode, ArmOperand, ArmOperandType};
use capstone::arch::{BuildsCapstone, BuildsCapstoneExtraMode, DetailsArchInsn};
use capstone::{Capstone, RegId};
use object::{Object, ObjectSection, SectionKind};

use super::timing::Step;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// Size in bytes: 2 or 4.
    pub size: u32,
    pub kind: Kind,
    /// Registers that the instruction writes: bit n is register n.
    pub sets: u16,
    /// Registers that the instruction uses in an address: bit n is register n.
    pub address: u16,
}

impl Instruction {
    /// Tests whether the instruction writes the program counter as a register, not by branching.
    pub fn sets_counter(&self) -> bool {
        self.sets & COUNTER != 0
    }
}

/// Bit of the program counter in a register set.
const COUNTER: u16 = 1 << 15;

/// Kinds of instructions that take different times on at least one core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One operation on data, or a no-operation.
    Plain,
    /// Operation on data that also shifts, rotates or extends an operand, or that works on parts of
    /// registers.
    Combined,
    Multiply,
    MultiplyAdd,
    LongMultiply,
    LongMultiplyAdd,
    Divide,
    Load,
    LoadMany(u32),
    /// Store with an immediate offset.
    Store,
    /// Store with an offset from a register.
    StoreIndexed,
    StoreMany(u32),
    /// Branch to a fixed address, with or without a condition.
    Branch,
    /// Call of a fixed address.
    Call,
    /// Branch or call to an address in a register.
    Jump,
    /// Branch by a table of offsets (TBB, TBH).
    TableJump,
    /// Read or write of a special register.
    Special,
    Barrier,
    Float,
    FloatMultiplyAdd,
    FloatDivideOrRoot,
    /// Move of two words between core registers and float registers.
    FloatMovePair,
    FloatLoad(u32),
    FloatStore(u32),
    /// Load or store of this many words, from a list of float registers.
    FloatMany(u32),
}

pub struct Code {
    start: u32,
    bytes: Vec<u8>,
    /// Instructions that have been decoded so far; one entry for each half word.
    decoded: Vec<Option<Instruction>>,
}

impl Code {
    /// Reads the code of an Arm program. All its instructions must be Thumb instructions.
    pub fn of(program: &object::File) -> Result<Self> {
        let text = program
            .sections()
            .find(|section| section.kind() == SectionKind::Text && section.size() > 0)
            .context("the program has no code")?;
        let bytes = text.data()?.to_vec();
        Ok(Self {
            start: text.address() as u32,
            decoded: vec![None; bytes.len() / 2],
            bytes,
        })
    }

    pub fn size(&self, address: u32) -> u32 {
        let offset = address.wrapping_sub(self.start) as usize;
        // Armv7-M Architecture Reference Manual, A5.1.
        match self.bytes.get(offset + 1) {
            Some(high) if high >> 3 >= 0b11101 => 4,
            _ => 2,
        }
    }

    /// Tests whether the instruction at an address calls a function: BL, or BLX with a register.
    pub fn calls(&self, address: u32) -> bool {
        let offset = address.wrapping_sub(self.start) as usize;
        let mut half_words = self.bytes.get(offset..).unwrap_or(&[]).chunks_exact(2);
        let mut next = || Some(u16::from_le_bytes(half_words.next()?.try_into().ok()?));
        // Armv7-M Architecture Reference Manual, A7.7.18 and A7.7.19.
        match (next(), next()) {
            (Some(first), _) if first & 0xff80 == 0x4780 => true,
            (Some(first), Some(second)) => first & 0xf800 == 0xf000 && second & 0xd000 == 0xd000,
            _ => false,
        }
    }

    /// Returns the instruction executed at `now`, with the instruction before it and whether it
    /// jumps. `next` is the address executed after it.
    pub fn step(&mut self, before: Option<u32>, now: u32, next: u32) -> Result<Step> {
        let previous = before.map(|before| self.at(before)).transpose()?;
        let instruction = self.at(now)?;
        Ok(Step {
            instruction,
            previous,
            jumps: next != now + instruction.size,
        })
    }

    fn at(&mut self, address: u32) -> Result<Instruction> {
        let offset = address.wrapping_sub(self.start) as usize;
        let unknown = || format!("there is no instruction at {address:#x}");
        let bytes = self.bytes.get(offset..).with_context(unknown)?;
        let place = self.decoded.get_mut(offset / 2).with_context(unknown)?;
        if let Some(instruction) = place {
            return Ok(*instruction);
        }
        let instruction = decode(bytes).with_context(unknown)?;
        Ok(*place.insert(instruction))
    }
}

fn decode(code: &[u8]) -> Result<Instruction> {
    // Each instruction needs a new decoder: Capstone remembers the condition of an IT instruction
    // for the instructions that follow, and the next address to decode can be anywhere.
    let decoder = Capstone::new()
        .arm()
        .mode(ArchMode::Thumb)
        .extra_mode([ArchExtraMode::MClass, ArchExtraMode::V8].into_iter())
        .detail(true)
        .build()?;
    let decoded = decoder.disasm_count(code, 0, 1)?;
    let decoded = decoded.first().context("not decoded")?;
    let name = decoder.insn_name(decoded.id()).context("it has no name")?;
    let detail = decoder.insn_detail(decoded)?;
    let detail = detail.arch_detail();
    let operands: Vec<_> = detail.arm().context("not Arm")?.operands().collect();
    let (mut kind, first) = (kind(&name, &operands), registers(operands.first()));
    if kind == Kind::Plain && is_combined(decoded.bytes()) {
        kind = Kind::Combined;
    }
    let sets = match kind {
        Kind::LoadMany(_) => registers(&operands[bases(&name)..]),
        Kind::LongMultiply | Kind::LongMultiplyAdd => registers(&operands[..2]),
        Kind::Store | Kind::StoreIndexed | Kind::StoreMany(_) => 0,
        _ if matches!(&*name, "cmp" | "cmn" | "tst" | "teq") => 0,
        _ => first,
    };
    let address = match &*name {
        "ldm" | "ldmdb" | "stm" | "stmdb" | "push" | "pop" => first,
        _ => addressed(&operands),
    };
    Ok(Instruction {
        size: decoded.bytes().len() as u32,
        kind,
        sets,
        address,
    })
}

/// Returns the kind of an instruction. `name` has neither a condition nor a suffix.
fn kind(name: &str, operands: &[ArmOperand]) -> Kind {
    let listed = (operands.len() - bases(name)) as u32;
    match name {
        "umull" | "smull" => Kind::LongMultiply,
        "umlal" | "umaal" => Kind::LongMultiplyAdd,
        _ if name.starts_with("smlal") => Kind::LongMultiplyAdd,
        "mla" | "mls" => Kind::MultiplyAdd,
        "mul" => Kind::Multiply,
        _ if name.starts_with("smm") || name.starts_with("smul") || name.starts_with("smla") => {
            Kind::Multiply
        }
        "udiv" | "sdiv" => Kind::Divide,
        "ldrd" => Kind::LoadMany(2),
        "ldm" | "ldmdb" | "pop" => Kind::LoadMany(listed),
        _ if name.starts_with("ldr") => Kind::Load,
        "strd" => Kind::StoreMany(2),
        "stm" | "stmdb" | "push" => Kind::StoreMany(listed),
        _ if name.starts_with("str") && addressed(operands).count_ones() > 1 => Kind::StoreIndexed,
        _ if name.starts_with("str") => Kind::Store,
        "tbb" | "tbh" => Kind::TableJump,
        "bx" | "blx" => Kind::Jump,
        "bl" => Kind::Call,
        "b" | "cbz" | "cbnz" => Kind::Branch,
        "mrs" | "msr" | "cps" => Kind::Special,
        "dmb" | "dsb" | "isb" => Kind::Barrier,
        "vldr" => Kind::FloatLoad(words(&operands[..1])),
        "vstr" => Kind::FloatStore(words(&operands[..1])),
        "vldmia" | "vldmdb" | "vstmia" | "vstmdb" | "vpush" | "vpop" => {
            Kind::FloatMany(words(operands))
        }
        "vdiv" | "vsqrt" => Kind::FloatDivideOrRoot,
        "vmla" | "vmls" | "vnmla" | "vnmls" => Kind::FloatMultiplyAdd,
        "vfma" | "vfms" | "vfnma" | "vfnms" => Kind::FloatMultiplyAdd,
        "vmov" if operands.len() > 2 => Kind::FloatMovePair,
        // Capstone's names for VMRS, and for VMOV of a constant or of half a register.
        "fmstat" | "fconsts" | "fconstd" | "fmdhr" | "fmdlr" => Kind::Float,
        _ if name.starts_with('v') => Kind::Float,
        _ => Kind::Plain,
    }
}

/// Tests whether an operation on data does more than one thing. The sections are those of the Armv7-M
/// Architecture Reference Manual.
fn is_combined(bytes: &[u8]) -> bool {
    let &[a, b, c, d] = bytes else {
        return false;
    };
    let (first, second) = (u16::from_le_bytes([a, b]), u16::from_le_bytes([c, d]));
    let has_operand = first & 15 != 15;
    match first >> 7 {
        // A5.3.1: a constant of 8 bits that is rotated.
        _ if first & 0xfa00 == 0xf000 => {
            second >> 15 == 0 && (first >> 10 & 1 | second >> 14 & 1) == 1
        }
        // A5.3.11: a shifted register. LSL by 0 to 2 is for addresses.
        _ if first & 0xfe00 == 0xea00 => {
            has_operand && (second & 0x7000 != 0 || second & 0x30 != 0 || second & 0xc0 == 0xc0)
        }
        // A5.3.12: extends and adds. Without an addition, it is a move.
        0b1_1111_0100 => second & 0x80 != 0 && has_operand,
        // A5.3.13 and A5.3.14: parallel and saturating additions.
        0b1_1111_0101 => second & 0x80 == 0 || first & 0x10 == 0,
        _ => false,
    }
}

/// Returns the number of operands that come before the register list: 1 for LDM and STM, else 0.
fn bases(name: &str) -> usize {
    usize::from(matches!(name, "ldm" | "ldmdb" | "stm" | "stmdb"))
}

/// Returns the core registers among the operands: bit n is register n.
fn registers<'a>(operands: impl IntoIterator<Item = &'a ArmOperand>) -> u16 {
    let bits = operands.into_iter().map(|operand| match operand.op_type {
        ArmOperandType::Reg(register) => bit(register),
        _ => 0,
    });
    bits.fold(0, |set, bit| set | bit)
}

/// Returns the core registers that the operands' addresses use: bit n is register n.
fn addressed(operands: &[ArmOperand]) -> u16 {
    let bits = operands.iter().map(|operand| match operand.op_type {
        ArmOperandType::Mem(memory) => bit(memory.base()) | bit(memory.index()),
        _ => 0,
    });
    bits.fold(0, |set, bits| set | bits)
}

/// Returns the bit of a core register in a register set, or 0 for any other register.
fn bit(register: RegId) -> u16 {
    match register.0.into() {
        ARM_REG_SP => 1 << 13,
        ARM_REG_LR => 1 << 14,
        ARM_REG_PC => COUNTER,
        register @ ARM_REG_R0..=ARM_REG_R12 => 1 << (register - ARM_REG_R0),
        _ => 0,
    }
}

/// Returns the number of words in the float registers among the operands.
fn words(operands: &[ArmOperand]) -> u32 {
    let words = operands.iter().map(|operand| match operand.op_type {
        ArmOperandType::Reg(RegId(register)) => match register.into() {
            ARM_REG_S0..=ARM_REG_S31 => 1,
            ARM_REG_D0..=ARM_REG_D31 => 2,
            _ => 0,
        },
        _ => 0,
    });
    words.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Decodes an instruction. `code` is a half word, or two half words of which the upper one is
    /// first in memory.
    fn instruction(code: u32) -> Instruction {
        let [second, first] = [code as u16, (code >> 16) as u16].map(u16::to_le_bytes);
        let bytes = match code >> 16 {
            0 => second.to_vec(),
            _ => [first, second].concat(),
        };
        let instruction = decode(&bytes).unwrap();
        assert_eq!(instruction.size as usize, bytes.len());
        instruction
    }

    #[test]
    fn instructions_are_told_apart() {
        let kinds = [
            (0x1888, "adds r0, r1, r2", Kind::Plain),
            (0x4388, "bics r0, r1", Kind::Plain),
            (0xbf08, "it eq", Kind::Plain),
            (0xeb01_0002, "add.w r0, r1, r2", Kind::Plain),
            (0xeb01_00c2, "add.w r0, r1, r2, lsl #3", Kind::Combined),
            (0xea40_0022, "orr.w r0, r0, r2, asr #32", Kind::Combined),
            (0xea4f_00d1, "lsr.w r0, r1, #3", Kind::Plain),
            (0xf001_00ff, "and r0, r1, #255", Kind::Plain),
            (0xf04f_4080, "mov.w r0, #0x40000000", Kind::Combined),
            (0xf241_2034, "movw r0, #4660", Kind::Plain),
            (0xfa11_f081, "uxtah r0, r1, r1", Kind::Combined),
            (0xfa1f_f081, "uxth.w r0, r1", Kind::Plain),
            (0xfab1_f081, "clz r0, r1", Kind::Plain),
            (0xfa81_f082, "qadd r0, r2, r1", Kind::Combined),
            (0x4348, "muls r0, r1, r0", Kind::Multiply),
            (0xfb51_f002, "smmul r0, r1, r2", Kind::Multiply),
            (0xfb82_0103, "smull r0, r1, r2, r3", Kind::LongMultiply),
            (0xfbc2_0103, "smlal r0, r1, r2, r3", Kind::LongMultiplyAdd),
            (0xfb01_3012, "mls r0, r1, r2, r3", Kind::MultiplyAdd),
            (0xfbb1_f0f2, "udiv r0, r1, r2", Kind::Divide),
            (0xf891_0004, "ldrb.w r0, [r1, #4]", Kind::Load),
            (0xe9dd_0101, "ldrd r0, r1, [sp, #4]", Kind::LoadMany(2)),
            (0xbd30, "pop {r4, r5, pc}", Kind::LoadMany(3)),
            (0xe92d_4010, "push.w {r4, lr}", Kind::StoreMany(2)),
            (
                0xe88d_000f,
                "stm.w sp, {r0, r1, r2, r3}",
                Kind::StoreMany(4),
            ),
            (0x6048, "str r0, [r1, #4]", Kind::Store),
            (0x5088, "str r0, [r1, r2]", Kind::StoreIndexed),
            (0xe01f, "b #0x42", Kind::Branch),
            (0xd91f, "bls #0x42", Kind::Branch),
            (0xb9f8, "cbnz r0, #0x42", Kind::Branch),
            (0xf000_f81f, "bl #0x42", Kind::Call),
            (0x4770, "bx lr", Kind::Jump),
            (0x4798, "blx r3", Kind::Jump),
            (0xf3ef_8010, "mrs r0, primask", Kind::Special),
            (0xee30_0a81, "vadd.f32 s0, s1, s2", Kind::Float),
            (0xeef1_fa10, "vmrs apsr_nzcv, fpscr", Kind::Float),
            (0xeeb7_0a00, "vmov.f32 s0, #1.0", Kind::Float),
            (0xeea0_0a81, "vfma.f32 s0, s1, s2", Kind::FloatMultiplyAdd),
            (0xeeb1_0ae0, "vsqrt.f32 s0, s1", Kind::FloatDivideOrRoot),
            (0xed9d_0a01, "vldr s0, [sp, #4]", Kind::FloatLoad(1)),
            (0xed9d_0b01, "vldr d0, [sp, #4]", Kind::FloatLoad(2)),
            (0xed2d_8b04, "vpush {d8, d9}", Kind::FloatMany(4)),
            (0xee10_0a90, "vmov r0, s1", Kind::Float),
            (0xec51_0b11, "vmov r0, r1, d1", Kind::FloatMovePair),
        ];
        for (code, text, kind) in kinds {
            assert_eq!(instruction(code).kind, kind, "{text}");
        }
    }

    #[test]
    fn registers_are_told_from_addresses() {
        for (code, text, sets, address) in [
            (
                0xf851_0029,
                "ldr.w r0, [r1, sb, lsl #2]",
                1,
                1 << 1 | 1 << 9,
            ),
            (0x6048, "str r0, [r1, #4]", 0, 1 << 1),
            (0x188b, "adds r3, r1, r2", 1 << 3, 0),
            (0xfba2_3c01, "umull r3, ip, r2, r1", 1 << 3 | 1 << 12, 0),
            (0x428b, "cmp r3, r1", 0, 0),
            (0xcc03, "ldm r4!, {r0, r1}", 3, 1 << 4),
        ] {
            let found = instruction(code);
            assert_eq!((found.sets, found.address), (sets, address), "{text}");
        }
        assert!(instruction(0xbd10).sets_counter(), "pop {{r4, pc}}");
        assert!(instruction(0x46a7).sets_counter(), "mov pc, r4");
        assert!(!instruction(0x4770).sets_counter(), "bx lr");
    }

    #[test]
    fn calls_are_told_from_jumps() {
        let code = |bytes: &[u8]| Code {
            start: 0x100,
            bytes: bytes.to_vec(),
            decoded: Vec::new(),
        };
        for (bytes, is_call) in [
            (&[0xff, 0xf7, 0xfe, 0xff][..], true), // bl
            (&[0x98, 0x47], true),                 // blx r3
            (&[0xff, 0xf7, 0xfe, 0xbf], false),    // b.w
            (&[0x70, 0x47], false),                // bx lr
            (&[0x7f, 0xf5, 0xfe, 0xaf], false),    // bpl.w
            (&[0xef, 0xf3, 0x10, 0x80], false),    // mrs
            (&[0xff, 0xf7], false),                // half of one
        ] {
            assert_eq!(code(bytes).calls(0x100), is_call, "{bytes:x?}");
        }
        assert!(!code(&[0x98, 0x47]).calls(0x102));
        assert!(!code(&[0x98, 0x47]).calls(0xfe));
    }
}
