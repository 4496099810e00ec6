//! The falling edges that pins remember. The status of 8 pins is in one register, of 4 bits a pin.

use crate::wires::Pin;

/// Bit of a falling edge in the 4 bits of a pin.
const FALL: u32 = 4;

pub struct Edges {
    /// Offset of the first register of edges, and of the first that enables those of the first core.
    offsets: [u32; 2],
    /// Falling edges of pins that are not cleared.
    falls: u32,
}

impl Edges {
    pub fn new(offsets: [u32; 2]) -> Self {
        Self { offsets, falls: 0 }
    }

    pub fn fall(&mut self, pin: Pin) {
        self.falls |= 1 << pin;
    }

    /// Reads a register of edges or of the first core's enabled edges; `None` for another one.
    /// `register` reads what is written in one.
    pub fn read(&self, offset: u32, register: impl Fn(u32) -> u32) -> Option<u32> {
        let [raw, enabled] = self.offsets;
        let count = (enabled - raw) / 4;
        let index = offset.checked_sub(raw)? / 4;
        // Raw edges; those that are enabled; those that are forced; those that are both.
        match index / count {
            0 => Some(self.falls_of(index)),
            3 => {
                let index = index % count;
                Some(self.falls_of(index) & register(enabled + 4 * index))
            }
            _ => None,
        }
    }

    /// Forgets the edges that are written to a register.
    pub fn clear(&mut self, offset: u32, value: u32) {
        let index = offset.wrapping_sub(self.offsets[0]) / 4;
        if index < 4 {
            let pins = (0..8).filter(|pin| value >> (4 * pin) & FALL != 0);
            pins.for_each(|pin| self.falls &= !(1 << (index * 8 + pin)));
        }
    }

    fn falls_of(&self, index: u32) -> u32 {
        let falls = self.falls.checked_shr(8 * index).unwrap_or(0);
        let pins = (0..8).filter(|pin| falls >> pin & 1 == 1);
        pins.map(|pin| FALL << (4 * pin)).sum()
    }
}
