//! The cores that can be measured, and the emulated machines that have them.

use clap::builder::{PossibleValuesParser, TypedValueParser};

use crate::{cycles::Timing, emulator::qemu::Qemu, toolchain};

#[derive(Debug, PartialEq, Eq)]
pub struct Core {
    pub name: &'static str,
    /// Name of the processor core in text, such as `Cortex-M3`.
    pub title: &'static str,
    pub target: &'static str,
    /// Timings that Arm publishes for the core, to estimate cycles; `None` if there are none.
    pub timing: Option<Timing>,
    machine: Machine,
}

#[derive(Debug, PartialEq, Eq)]
enum Machine {
    Arm(&'static str),
    Riscv,
}

/// Every instruction of an Arm core takes 2^7 ns of the machine's time, by which a timer of its board
/// goes; `xtask/firmware/src/clock.rs` reads it.
const TIMER_SHIFT: u8 = 7;

/// All of them. QEMU has no Cortex-M0 with a timer fine enough, so the M0's instructions run on an
/// M3, which executes them all and counts them alike.
pub const CORES: [Core; 6] = [
    Core {
        name: "m0",
        title: "Cortex-M0",
        target: toolchain::M0,
        timing: Some(Timing::M0Plus),
        machine: Machine::Arm("mps2-an385"),
    },
    Core {
        name: "m3",
        title: "Cortex-M3",
        target: toolchain::M3,
        timing: Some(Timing::M3),
        machine: Machine::Arm("mps2-an385"),
    },
    Core {
        name: "m4f",
        title: "Cortex-M4F",
        target: toolchain::M4F,
        timing: Some(Timing::M4),
        machine: Machine::Arm("mps2-an386"),
    },
    Core {
        name: "m33",
        title: "Cortex-M33",
        target: toolchain::M33,
        timing: Some(Timing::M33),
        machine: Machine::Arm("mps2-an505"),
    },
    Core {
        name: "m7",
        title: "Cortex-M7",
        target: toolchain::M4F,
        timing: None,
        machine: Machine::Arm("mps2-an500"),
    },
    Core {
        name: "rv32",
        title: "RV32IMAC",
        target: toolchain::RV32IMAC,
        timing: None,
        machine: Machine::Riscv,
    },
];

impl Core {
    /// The core that commands take unless another is named.
    pub const M3: &Self = &CORES[1];

    pub fn find(name: &str) -> Option<&'static Self> {
        CORES.iter().find(|core| core.name == name)
    }

    pub fn parser() -> impl TypedValueParser<Value = &'static Self> {
        let find = |name: String| Self::find(&name).expect("it is one of the possible values");
        PossibleValuesParser::new(CORES.map(|core| core.name)).map(find)
    }

    pub fn emulator(&self) -> Qemu {
        match self.machine {
            Machine::Arm(machine) => Qemu::arm(machine),
            Machine::Riscv => Qemu::riscv32(),
        }
    }

    /// A machine with this core that counts instructions the way the firmware reads them.
    pub fn counting_emulator(&self) -> Qemu {
        self.emulator().counting_instructions(match self.machine {
            Machine::Arm(_) => TIMER_SHIFT,
            // The core's own count is in nanoseconds of the machine's time.
            Machine::Riscv => 0,
        })
    }
}
