//! The boards: which chip, and what is wired to which pin.

use std::path::Path;

use crate::chip::Chip;
use crate::chip::rp::Rp;
use crate::chip::rp2040::RP2040;
use crate::chip::rp2350::RP2350;
use crate::chip::stm32f411::{self, Stm32f411};
use crate::core::m0::M0;
use crate::core::m33::M33;
use crate::elf::Firmware;
use crate::fault::Failure;
use crate::keys::Key;
use crate::machine::Machine;
use crate::memory::Memory;
use crate::run::{Run, Script};
use crate::wires::{Pin, Wiring};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChipKind {
    Rp2040,
    Rp2350,
    Stm32f411,
}

impl ChipKind {
    /// Address of the vector table in the flash: on an RP2040 the second stage of the boot loader is
    /// before it.
    pub(crate) fn vectors(self) -> u32 {
        match self {
            Self::Rp2040 => 0x1000_0100,
            Self::Rp2350 => 0x1000_0000,
            Self::Stm32f411 => 0x0800_0000,
        }
    }
}

/// A board with a panel and keys. The fields may be changed, to wire it wrongly.
#[derive(Clone, Debug)]
pub struct Board {
    pub chip: ChipKind,
    pub wiring: Wiring,
    /// Pins that the keys connect to ground.
    pub keys: &'static [(Key, Pin)],
}

const PICO_WIRING: Wiring = Wiring {
    clock: 10,
    data: 11,
    data_command: 8,
    chip_select: 9,
    reset: 12,
    backlight: 13,
};

/// Keys of the Pico-LCD-1.3.
const PICO_KEYS: [(Key, Pin); 5] = [
    (Key::Up, 2),
    (Key::Down, 18),
    (Key::Left, 16),
    (Key::Right, 20),
    (Key::Select, 3),
];

/// Number of the first pin of port B.
const B: Pin = 16;

impl Board {
    /// Raspberry Pi Pico, wired as in `examples/pico`.
    pub const PICO: Self = Self {
        chip: ChipKind::Rp2040,
        wiring: PICO_WIRING,
        keys: &PICO_KEYS,
    };

    /// Raspberry Pi Pico 2, wired as in `examples/pico`.
    pub const PICO_2: Self = Self {
        chip: ChipKind::Rp2350,
        ..Self::PICO
    };

    /// Black Pill, wired as in `examples/blackpill`.
    pub const BLACK_PILL: Self = Self {
        chip: ChipKind::Stm32f411,
        wiring: Wiring {
            clock: 5,
            data: 7,
            data_command: B,
            chip_select: 4,
            reset: B + 1,
            backlight: B + 10,
        },
        keys: &[(Key::Select, 0)],
    };

    /// Runs a firmware from the reset until its last picture is drawn.
    ///
    /// # Errors
    /// A firmware that cannot be read, and the first fault of the firmware or of the wiring.
    pub fn run(&self, elf: &Path, script: &Script) -> Result<Run, Failure> {
        let firmware = Firmware::read(elf)?;
        match self.chip {
            ChipKind::Rp2040 => Machine::<M0>::new(self, &firmware, script)?.run(self, script),
            _ => Machine::<M33>::new(self, &firmware, script)?.run(self, script),
        }
    }

    /// Frequency of the cores in Hz.
    pub fn clock(&self) -> u64 {
        match self.chip {
            ChipKind::Rp2040 => RP2040.clock,
            ChipKind::Rp2350 => RP2350.clock,
            ChipKind::Stm32f411 => stm32f411::CLOCK,
        }
    }

    pub(crate) fn pin(&self, key: Key) -> Option<Pin> {
        let found = self.keys.iter().find(|it| it.0 == key);
        found.map(|it| it.1)
    }

    pub(crate) fn memory(&self) -> Memory {
        match self.chip {
            ChipKind::Rp2040 => Memory::new((0x1000_0000, 2 << 20), (0x2000_0000, 264 << 10)),
            ChipKind::Rp2350 => Memory::new((0x1000_0000, 4 << 20), (0x2000_0000, 520 << 10)),
            ChipKind::Stm32f411 => Memory::new((0x0800_0000, 512 << 10), (0x2000_0000, 128 << 10)),
        }
    }

    pub(crate) fn peripherals(&self, cores: usize) -> Box<dyn Chip> {
        match self.chip {
            ChipKind::Rp2040 => Box::new(Rp::new(&RP2040, cores)),
            ChipKind::Rp2350 => Box::new(Rp::new(&RP2350, cores)),
            ChipKind::Stm32f411 => Box::new(Stm32f411::new()),
        }
    }
}
