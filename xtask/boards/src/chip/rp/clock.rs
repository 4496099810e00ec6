//! The clock of the cores: what their PLL gives, and whether the core voltage is high enough for it.

use super::layout::{Kind, Layout};
use crate::fault::{Fault, require};
use crate::registers::Registers;

/// Frequency of the crystal in MHz.
const CRYSTAL: u32 = 12;

/// Bits of CLK_SYS_CTRL that select the source: 1 is the PLL of the cores.
const SOURCE: u32 = 0xe1;

/// Tests that the cores, which begin to run from their PLL, have the frequency that the emulator counts in. `control` is
/// the CLK_SYS_CTRL of the cores.
pub fn check(registers: &Registers<Kind>, layout: &Layout, control: u32) -> Result<(), Fault> {
    require!(control & SOURCE == 1, "the cores do not run from their PLL");
    let [before, _, factor, after] = [0, 4, 8, 12].map(|it| registers.get(layout.pll + it));
    let divider = (before & 63) * (after >> 16 & 7) * (after >> 12 & 7);
    let [clock, expected] = [
        CRYSTAL * factor / divider.max(1),
        (layout.clock / 1_000_000) as u32,
    ];
    require!(
        clock == expected,
        "the PLL gives {clock} MHz, and the emulator counts in {expected} MHz"
    );
    let is_enough = |(register, least)| registers.get(register) >> 4 & 15 >= least;
    require!(
        layout.voltage.is_none_or(is_enough),
        "{clock} MHz need a higher core voltage: raise VSEL"
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
        let mut said = |settings: &[(u32, u32)]| {
            settings.iter().for_each(|(register, value)| {
                registers.set(*register, *value);
            });
            check(&registers, &RP2040, 1).map_err(|fault| fault.to_string())
        };
        let pll = RP2040.pll;
        let wrong = "the PLL gives 125 MHz, and the emulator counts in 200 MHz";
        let found = said(&[(pll, 1), (pll + 8, 125), (pll + 12, 0x62000)]);
        assert_eq!(found, Err(wrong.to_owned()));
        let low = "200 MHz need a higher core voltage: raise VSEL";
        assert_eq!(
            said(&[(pll + 8, 100), (pll + 12, 0x61000)]),
            Err(low.to_owned())
        );
        assert_eq!(said(&[(RP2040.voltage.unwrap().0, 0xc1)]), Ok(()));
    }
}
