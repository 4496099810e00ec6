//! Instructions of the emulated cores, with results that were computed from the architecture's
//! manual, so that a changed crate is noticed.

use boards::{ChipKind, execute};

/// Values of the registers 0 to 3 before each instruction. The flags are clear.
const BEFORE: [u32; 4] = [0x89ab_cdef, 0x0123_4567, 0xfedc_ba98, 0x7654_3210];

/// Name, halfwords, registers 0 and 1 afterwards, and the flags that are set.
type Row = (&'static str, &'static [u16], u32, u32, &'static str);

#[rustfmt::skip]
/// Instructions of all cores.
const ON_ALL: &[Row] = &[
    ("muls", &[0x4350], 0xad05_ebe8, 0x0123_4567, "N"),
    ("adcs", &[0x4150], 0x8888_8887, 0x0123_4567, "NC"),
    ("sbcs", &[0x4190], 0x8acf_1356, 0x0123_4567, "N"),
    ("rors", &[0x41d0], 0xabcd_ef89, 0x0123_4567, "NC"),
    ("rev", &[0xba10], 0x98ba_dcfe, 0x0123_4567, ""),
    ("revsh", &[0xbad0], 0xffff_98ba, 0x0123_4567, ""),
    ("sxth", &[0xb210], 0xffff_ba98, 0x0123_4567, ""),
    ("lsrs", &[0x09d0], 0x01fd_b975, 0x0123_4567, ""),
    ("asrs", &[0x11d0], 0xfffd_b975, 0x0123_4567, "N"),
    ("cmp", &[0x429a], 0x89ab_cdef, 0x0123_4567, "NC"),
    ("mvns", &[0x43d0], 0x0123_4567, 0x0123_4567, ""),
];

#[rustfmt::skip]
/// Instructions of a Cortex-M33 and a Cortex-M4.
const ON_M33: &[Row] = &[
    ("smull", &[0xfb82, 0x0103], 0x541d_5980, 0xff79_5e36, ""),
    ("umull", &[0xfba2, 0x0103], 0x541d_5980, 0x75cd_9046, ""),
    ("smlal", &[0xfbc2, 0x0103], 0xddc9_276f, 0x009c_a39d, ""),
    ("umlal", &[0xfbe2, 0x0103], 0xddc9_276f, 0x76f0_d5ad, ""),
    ("smmul", &[0xfb52, 0xf003], 0xff79_5e36, 0x0123_4567, ""),
    ("smmulr", &[0xfb52, 0xf013], 0xff79_5e36, 0x0123_4567, ""),
    ("smmla", &[0xfb52, 0x1003], 0x009c_a39d, 0x0123_4567, ""),
    ("mls", &[0xfb02, 0x1013], 0xad05_ebe7, 0x0123_4567, ""),
    ("smulbb", &[0xfb12, 0xf003], 0xf26d_5980, 0x0123_4567, ""),
    ("smulwb", &[0xfb32, 0xf003], 0xffc7_0a3d, 0x0123_4567, ""),
    ("sdiv", &[0xfb92, 0xf0f3], 0x0000_0000, 0x0123_4567, ""),
    ("udiv", &[0xfbb2, 0xf0f3], 0x0000_0002, 0x0123_4567, ""),
    ("clz", &[0xfab2, 0xf082], 0x0000_0000, 0x0123_4567, ""),
    ("rbit", &[0xfa92, 0xf0a2], 0x195d_3b7f, 0x0123_4567, ""),
    ("rev16", &[0xfa92, 0xf092], 0xdcfe_98ba, 0x0123_4567, ""),
    ("ssat", &[0xf302, 0x0007], 0xffff_ff80, 0x0123_4567, "Q"),
    ("usat", &[0xf382, 0x0008], 0x0000_0000, 0x0123_4567, "Q"),
    ("ubfx", &[0xf3c2, 0x1008], 0x0000_01a9, 0x0123_4567, ""),
    ("sbfx", &[0xf342, 0x1008], 0xffff_ffa9, 0x0123_4567, ""),
    ("bfi", &[0xf362, 0x100b], 0x89ab_c98f, 0x0123_4567, ""),
    ("qadd", &[0xfa83, 0xf082], 0x7530_eca8, 0x0123_4567, ""),
    ("qsub", &[0xfa83, 0xf0a2], 0x8888_8888, 0x0123_4567, ""),
    ("sxtab", &[0xfa42, 0xf083], 0xfedc_baa8, 0x0123_4567, ""),
    ("adcs, shifted", &[0xeb52, 0x00c3], 0xb17e_4b18, 0x0123_4567, "NC"),
    ("ands, rotated", &[0xea12, 0x0073], 0x3a08_1808, 0x0123_4567, ""),
    ("rsbs", &[0xf1d2, 0x0005], 0x0123_456d, 0x0123_4567, ""),
];

fn test(chip: ChipKind, rows: &[Row]) {
    for (name, code, first, second, flags) in rows {
        let mut registers = [0; 8];
        registers[..4].copy_from_slice(&BEFORE);
        let (after, bits) = execute(chip, code, registers).unwrap();
        let letters = "NZCVQ".chars().enumerate();
        let set = letters.filter(|(place, _)| bits << place >> 31 == 1);
        let set: String = set.map(|(_, letter)| letter).collect();
        let found = (after[0], after[1], &*set);
        assert_eq!(found, (*first, *second, *flags), "{name}");
        assert_eq!(after[2..4], BEFORE[2..], "{name}");
    }
}

#[test]
fn instructions_of_a_cortex_m0_plus_give_their_results() {
    test(ChipKind::Rp2040, ON_ALL);
}

#[test]
fn instructions_of_a_cortex_m33_give_their_results() {
    for chip in [ChipKind::Rp2350, ChipKind::Stm32f411] {
        test(chip, ON_ALL);
        test(chip, ON_M33);
    }
}

/// `lda r0, [r4]` and `stl r2, [r4]`: the crate executes them as something else, so they are replaced.
#[test]
fn accesses_with_acquire_and_release_are_plain_ones() {
    // r4 = 0x20 << 24
    let code = [0x2420, 0x0624, 0xe8c4, 0x2faf, 0xe8d4, 0x0faf];
    let registers = [0, 0, 0xfedc_ba98, 0, 0, 0, 0, 0];
    let (after, _) = execute(ChipKind::Rp2350, &code, registers).unwrap();
    assert_eq!(after[0], 0xfedc_ba98);
}

#[test]
fn instruction_that_the_crate_executes_incorrectly_is_refused() {
    // pkhbt, pkhtb, usat16, uadd8
    for code in [
        [0xeac2, 0x0003],
        [0xeac2, 0x0023],
        [0xf3a2, 0x0004],
        [0xfa82, 0xf043],
    ] {
        let refusal = execute(ChipKind::Rp2350, &code, [0; 8]).unwrap_err();
        let is_named = refusal.to_string().starts_with("the emulated core has no ");
        assert!(is_named, "{refusal}");
    }
}

#[test]
fn address_without_a_register_or_memory_is_named_with_its_instruction() {
    // r0 = 0x4f << 24, or 0x60 << 24; r0 = the word at r0
    for (top, fault) in [
        (0x204f, "no register at 0x4f000000, at 0x1000000c of core 0"),
        (0x2060, "no memory at 0x60000000, at 0x1000000c of core 0"),
    ] {
        let refusal = execute(ChipKind::Rp2350, &[top, 0x0600, 0x6800], [0; 8]).unwrap_err();
        assert_eq!(refusal.to_string(), fault);
    }
}

#[test]
fn peripheral_that_is_not_switched_on_is_named() {
    // r0 = the word at r0
    let in_reset = "SPI1 at 0x40088000: it is still in reset, at 0x10000008 of core 0";
    let no_clock = "SPI1 at 0x40013000: its clock is not enabled, at 0x08000008 of core 0";
    for (chip, address, expected) in [
        (ChipKind::Rp2350, 0x4008_8000, in_reset),
        (ChipKind::Stm32f411, 0x4001_3000, no_clock),
    ] {
        let registers = [address, 0, 0, 0, 0, 0, 0, 0];
        let refusal = execute(chip, &[0x6800], registers).unwrap_err();
        assert_eq!(refusal.to_string(), expected);
    }
}
