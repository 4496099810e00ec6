//! The clock of the cores: what their PLL gives, and whether the core voltage is high enough for it.

use super::layout::{Kind, Layout};
use crate::fault::{Fault, require};
use crate::registers::Registers;

/// Frequency of the crystal in Hz.
const CRYSTAL: u64 = 12_000_000;

/// Bits of CLK_SYS_CTRL that select the source: 1 is the PLL of the cores.
const SOURCE: u32 = 0xe1;

/// Tests that the cores, which begin to run from their PLL, have the frequency that the emulator counts in. `control` is
/// the CLK_SYS_CTRL of the cores.
pub fn check(registers: &Registers<Kind>, layout: &Layout, control: u32) -> Result<(), Fault> {
    require!(control & SOURCE == 1, "the cores do not run from their PLL");
    let [before, factor, after] = [0, 8, 12].map(|it| u64::from(registers.get(layout.pll + it)));
    let divider = (before & 63) * (after >> 16 & 7) * (after >> 12 & 7);
    let (clock, expected) = (CRYSTAL * factor / divider.max(1), layout.clock);
    require!(
        clock == expected,
        "the PLL gives {clock} Hz, not {expected} Hz"
    );
    let is_enough = |(register, least)| registers.get(register) >> 4 & 15 >= least;
    require!(
        layout.voltage.is_none_or(is_enough),
        "{clock} Hz need a higher core voltage: raise VSEL"
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chip::rp2040::RP2040;

    #[test]
    fn wrong_clock_and_low_voltage_are_found() {
        let mut registers = Registers::new(RP2040.blocks);
        let mut said = |control: u32, settings: &[(u32, u32)]| {
            for (register, value) in settings {
                registers.set(*register, *value);
            }
            check(&registers, &RP2040, control).map_err(|fault| fault.to_string())
        };
        let (pll, voltage) = (RP2040.pll, RP2040.voltage.unwrap().0);
        let slow = said(1, &[(pll, 1), (pll + 8, 125), (pll + 12, 0x62000)]).unwrap_err();
        assert_eq!(slow, "the PLL gives 125000000 Hz, not 200000000 Hz");
        let low = said(1, &[(pll + 8, 100), (pll + 12, 0x61000)]).unwrap_err();
        assert_eq!(low, "200000000 Hz need a higher core voltage: raise VSEL");
        assert_eq!(said(1, &[(voltage, 0xc1)]), Ok(()));
        let usb = said(0x21, &[]).unwrap_err();
        assert_eq!(usb, "the cores do not run from their PLL");
    }
}
