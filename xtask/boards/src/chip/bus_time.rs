//! How long the SPI sends, and for how much of that a core waits for it.

/// Cycles after which a core that has not looked at the bus again does something else.
const STAYS: u64 = 64;

/// Time of the bus in cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct BusTime {
    /// The SPI sends.
    pub sending: u64,
    /// The SPI sends, and a core does nothing but feed it or wait for it.
    pub waiting: u64,
    /// When a core looked at the bus last.
    looked: u64,
}

impl BusTime {
    /// A core reads or writes a register of the SPI or the DMA. `end` is when the SPI has sent all that it has.
    pub fn look(&mut self, now: u64, end: u64) {
        if now.saturating_sub(self.looked) <= STAYS {
            self.waiting += now.min(end).saturating_sub(self.looked);
        }
        self.looked = now;
    }

    /// Returns the time since an earlier one.
    #[must_use]
    pub fn since(self, earlier: Self) -> Self {
        Self {
            sending: self.sending - earlier.sending,
            waiting: self.waiting - earlier.waiting,
            ..self
        }
    }

    /// Share of the time of sending in which the cores do something else, 0 to 1.
    #[must_use]
    pub fn hidden(self) -> f64 {
        1.0 - self.waiting as f64 / self.sending.max(1) as f64
    }
}
