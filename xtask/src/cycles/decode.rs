//! What the instructions of a program are, as far as their timing depends on it.

use anyhow::{Context, Result, anyhow};
use capstone::{
    Capstone,
    arch::{
        BuildsCapstone, BuildsCapstoneExtraMode,
        arm::{ArchExtraMode, ArchMode},
    },
};
use object::{Object, ObjectSection, SectionKind};

use super::timing::Step;

/// An instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// In bytes.
    pub size: u32,
    pub kind: Kind,
    /// The registers it writes, a bit each.
    pub sets: u16,
    /// The registers it makes an address of.
    pub address: u16,
}

impl Instruction {
    /// Whether it writes the program counter other than by branching.
    pub fn sets_counter(&self) -> bool {
        self.sets & COUNTER != 0
    }
}

/// The program counter among the registers.
const COUNTER: u16 = 1 << 15;

/// Kinds of instructions that take different times on some core.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// One operation on data, or none.
    Plain,
    Multiply,
    MultiplyAdd,
    LongMultiply,
    LongMultiplyAdd,
    Divide,
    Load,
    /// Of so many words.
    LoadMany(u32),
    /// With an immediate offset.
    Store,
    /// With an offset from a register.
    StoreIndexed,
    /// Of so many words.
    StoreMany(u32),
    /// To a fixed address, always or on a condition.
    Branch,
    /// To a fixed address, to return.
    Call,
    /// To an address in a register.
    Jump,
    /// By a table of offsets.
    TableJump,
    /// To or from a special register.
    Special,
    Barrier,
    Float,
    FloatMultiplyAdd,
    FloatDivideOrRoot,
    /// Of two words between the register files.
    FloatMovePair,
    /// Of so many words.
    FloatLoad(u32),
    /// Of so many words.
    FloatStore(u32),
    /// Of so many words.
    FloatMany(u32),
}

/// The code of a program.
pub struct Code {
    start: u32,
    bytes: Vec<u8>,
    /// What has been decoded, by half words.
    decoded: Vec<Option<Instruction>>,
}

impl Code {
    /// The code of an Arm program in Thumb instructions.
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

    /// The size of the instruction at an address.
    pub fn size(&self, address: u32) -> u32 {
        let offset = address.wrapping_sub(self.start) as usize;
        // Armv7-M Architecture Reference Manual, A5.1.
        match self.bytes.get(offset + 1) {
            Some(high) if high >> 3 >= 0b11101 => 4,
            _ => 2,
        }
    }

    /// Whether the instruction at an address calls a function: BL, or BLX with a register.
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

    /// What is executed at `now`, after what is at `before` and before what is at `next`.
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

/// Decodes the first instruction of some code.
fn decode(code: &[u8]) -> Result<Instruction> {
    // A new one every time: it remembers the condition of one instruction for the next ones, and
    // what comes next is anywhere.
    let decoder = Capstone::new()
        .arm()
        .mode(ArchMode::Thumb)
        .extra_mode([ArchExtraMode::MClass, ArchExtraMode::V8].into_iter())
        .build()
        .map_err(|error| anyhow!("no decoder: {error}"))?;
    let decoded = decoder
        .disasm_count(code, 0, 1)
        .map_err(|error| anyhow!("not decoded: {error}"))?;
    let decoded = decoded.first().context("not decoded")?;
    let mnemonic = decoded.mnemonic().context("it has no name")?;
    let operands = decoded.op_str().unwrap_or_default();
    Ok(instruction(
        mnemonic,
        operands,
        decoded.bytes().len() as u32,
    ))
}

fn instruction(mnemonic: &str, operands: &str, size: u32) -> Instruction {
    let mnemonic = mnemonic.trim_end_matches(".w");
    let kind = kind(mnemonic, operands);
    let (outside, inside) = match operands.split_once('[') {
        Some((outside, inside)) => (outside, inside),
        None => (operands, ""),
    };
    let list = operands.split_once('{').map_or("", |(_, list)| list);
    let first = outside.split(',').next().unwrap_or("");
    let sets = match kind {
        Kind::LoadMany(_) => registers(if list.is_empty() { outside } else { list }),
        Kind::LongMultiply | Kind::LongMultiplyAdd => {
            registers(&outside.split(',').take(2).collect::<Vec<_>>().join(","))
        }
        Kind::Store | Kind::StoreIndexed | Kind::StoreMany(_) => 0,
        _ if ["cmp", "cmn", "tst", "teq", "b", "cb"]
            .iter()
            .any(|it| is(mnemonic, it)) =>
        {
            0
        }
        _ => registers(first),
    };
    let address = match kind {
        Kind::LoadMany(_) | Kind::StoreMany(_) if !list.is_empty() => registers(first),
        _ => registers(inside),
    };
    Instruction {
        size,
        kind,
        sets,
        address,
    }
}

fn kind(mnemonic: &str, operands: &str) -> Kind {
    let starts = |beginning: &str| mnemonic.starts_with(beginning);
    let count = |width: u32| {
        let list = operands.split_once('{').map_or("", |(_, list)| list);
        width
            * list
                .split(',')
                .filter(|item| !item.trim().is_empty())
                .count() as u32
    };
    match mnemonic {
        _ if starts("v") => float_kind(mnemonic, operands),
        _ if starts("umull") || starts("smull") => Kind::LongMultiply,
        _ if starts("umlal") || starts("smlal") || starts("umaal") => Kind::LongMultiplyAdd,
        _ if starts("mla") || starts("mls") => Kind::MultiplyAdd,
        _ if starts("mul") => Kind::Multiply,
        _ if starts("udiv") || starts("sdiv") => Kind::Divide,
        _ if starts("ldrd") => Kind::LoadMany(2),
        _ if starts("ldm") || starts("pop") => Kind::LoadMany(count(1)),
        _ if starts("ldr") => Kind::Load,
        _ if starts("strd") => Kind::StoreMany(2),
        _ if starts("stm") || starts("push") => Kind::StoreMany(count(1)),
        _ if starts("str") => match operands.split_once('[') {
            Some((_, inside)) if registers(inside).count_ones() > 1 => Kind::StoreIndexed,
            _ => Kind::Store,
        },
        _ if starts("tbb") || starts("tbh") => Kind::TableJump,
        _ if is(mnemonic, "bx") || is(mnemonic, "blx") => Kind::Jump,
        _ if is(mnemonic, "bl") => Kind::Call,
        _ if is(mnemonic, "b") || starts("cbz") || starts("cbnz") => Kind::Branch,
        _ if starts("mrs") || starts("msr") || starts("cps") => Kind::Special,
        "dmb" | "dsb" | "isb" => Kind::Barrier,
        _ => Kind::Plain,
    }
}

fn float_kind(mnemonic: &str, operands: &str) -> Kind {
    let starts = |beginning: &str| mnemonic.starts_with(beginning);
    let width = |register: &str| {
        if register.trim().starts_with('d') {
            2
        } else {
            1
        }
    };
    let words = || {
        let list = operands.split_once('{').map_or(operands, |(_, list)| list);
        let registers = list.trim_end_matches('}').split(',');
        registers.map(width).sum()
    };
    let is_multiply_add = ["vmla", "vmls", "vfm", "vfnm", "vnmla", "vnmls"];
    match mnemonic {
        _ if starts("vldr") => Kind::FloatLoad(width(operands)),
        _ if starts("vstr") => Kind::FloatStore(width(operands)),
        _ if ["vldm", "vstm", "vpush", "vpop"]
            .iter()
            .any(|it| starts(it)) =>
        {
            Kind::FloatMany(words())
        }
        _ if starts("vdiv") || starts("vsqrt") => Kind::FloatDivideOrRoot,
        _ if is_multiply_add.iter().any(|it| starts(it)) => Kind::FloatMultiplyAdd,
        _ if starts("vmov") && operands.split(',').count() > 2 => Kind::FloatMovePair,
        _ => Kind::Float,
    }
}

/// Whether a mnemonic is this one, with or without a condition.
fn is(mnemonic: &str, name: &str) -> bool {
    const CONDITIONS: [&str; 17] = [
        "", "eq", "ne", "hs", "cs", "lo", "cc", "mi", "pl", "vs", "vc", "hi", "ls", "ge", "lt",
        "gt", "le",
    ];
    let condition = mnemonic.strip_prefix(name);
    condition.is_some_and(|condition| CONDITIONS.contains(&condition))
}

/// The core's registers that a text names, a bit each.
fn registers(text: &str) -> u16 {
    let words = text.split(|letter: char| !letter.is_ascii_alphanumeric());
    let number = |word: &str| match word {
        "sb" => Some(9),
        "sl" => Some(10),
        "fp" => Some(11),
        "ip" => Some(12),
        "sp" => Some(13),
        "lr" => Some(14),
        "pc" => Some(15),
        _ => word
            .strip_prefix('r')?
            .parse()
            .ok()
            .filter(|&number| number < 16),
    };
    words
        .filter_map(number)
        .fold(0, |set, number: u32| set | 1 << number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_are_told_apart() {
        let kinds = [
            ("adds", "r0, r1, r2", Kind::Plain),
            ("bics", "r0, r1", Kind::Plain),
            ("it", "eq", Kind::Plain),
            ("muls", "r0, r1, r0", Kind::Multiply),
            ("smull", "r0, r1, r2, r3", Kind::LongMultiply),
            ("smlal", "r0, r1, r2, r3", Kind::LongMultiplyAdd),
            ("mls", "r0, r1, r2, r3", Kind::MultiplyAdd),
            ("udiv", "r0, r1, r2", Kind::Divide),
            ("ldrb.w", "r0, [r1, #4]", Kind::Load),
            ("ldrd", "r0, r1, [sp, #4]", Kind::LoadMany(2)),
            ("pop", "{r4, r5, pc}", Kind::LoadMany(3)),
            ("push.w", "{r4, lr}", Kind::StoreMany(2)),
            ("stm.w", "sp, {r0, r1, r2, r3}", Kind::StoreMany(4)),
            ("str", "r0, [r1, #4]", Kind::Store),
            ("str", "r0, [r1, r2]", Kind::StoreIndexed),
            ("b", "#0x42", Kind::Branch),
            ("bls", "#0x42", Kind::Branch),
            ("cbnz", "r0, #0x42", Kind::Branch),
            ("bl", "#0x42", Kind::Call),
            ("bx", "lr", Kind::Jump),
            ("blx", "r3", Kind::Jump),
            ("mrs", "r0, primask", Kind::Special),
            ("vadd.f32", "s0, s1, s2", Kind::Float),
            ("vfma.f32", "s0, s1, s2", Kind::FloatMultiplyAdd),
            ("vsqrt.f32", "s0, s1", Kind::FloatDivideOrRoot),
            ("vldr", "s0, [sp, #4]", Kind::FloatLoad(1)),
            ("vldr", "d0, [sp, #4]", Kind::FloatLoad(2)),
            ("vpush", "{d8, d9}", Kind::FloatMany(4)),
            ("vmov", "r0, s1", Kind::Float),
            ("vmov", "r0, r1, d1", Kind::FloatMovePair),
        ];
        for (mnemonic, operands, expected) in kinds {
            let found = instruction(mnemonic, operands, 2);
            assert_eq!(found.kind, expected, "{mnemonic} {operands}");
        }
    }

    #[test]
    fn registers_are_told_from_addresses() {
        let sets = |mnemonic, operands| {
            let found = instruction(mnemonic, operands, 2);
            (found.sets, found.address)
        };
        assert_eq!(sets("ldr", "r0, [r1, sb, lsl #2]"), (1, 1 << 1 | 1 << 9));
        assert_eq!(sets("str", "r0, [r1, #4]"), (0, 1 << 1));
        assert_eq!(sets("adds", "r3, r1, r2"), (1 << 3, 0));
        assert_eq!(sets("umull", "r3, ip, r2, r1"), (1 << 3 | 1 << 12, 0));
        assert_eq!(sets("cmp", "r3, r1"), (0, 0));
        assert_eq!(sets("ldm", "r4!, {r0, r1}"), (3, 1 << 4));
        assert!(instruction("pop", "{r4, pc}", 2).sets_counter());
        assert!(instruction("mov", "pc, r4", 2).sets_counter());
        assert!(!instruction("bx", "lr", 2).sets_counter());
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
