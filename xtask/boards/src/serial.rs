//! The time that a byte takes on a serial line: how many bytes wait, and how many came back.

/// The shift register of an SPI unit and the buffers at both of its ends.
#[derive(Clone, Copy, Debug, Default)]
pub struct Serial {
    /// Cycle at which the last byte is sent.
    end: u64,
    /// Cycles that a byte takes.
    cycles: u64,
    sent: u64,
    taken: u64,
}

impl Serial {
    /// Queues a byte at a time in cycles. It takes that many `cycles`.
    pub fn send(&mut self, now: u64, cycles: u64) {
        self.cycles = cycles;
        self.end = self.end.max(now) + cycles;
        self.sent += 1;
    }

    /// Cycle at which the last byte is sent.
    pub fn end(&self) -> u64 {
        self.end
    }

    /// Number of bytes that are not sent, the one in the shift register included.
    pub fn waiting(&self, now: u64) -> u64 {
        match self.cycles {
            0 => 0,
            cycles => self.end.saturating_sub(now).div_ceil(cycles),
        }
    }

    /// Number of bytes that came back and were not taken. As many come back as are sent.
    pub fn received(&self, now: u64) -> u64 {
        (self.sent - self.taken).saturating_sub(self.waiting(now))
    }

    pub fn take(&mut self, now: u64) {
        self.taken += self.received(now).min(1);
    }

    /// Drops received bytes beyond those that a buffer holds.
    pub fn overflow(&mut self, now: u64, buffer: u64) {
        self.taken += self.received(now).saturating_sub(buffer);
    }
}
