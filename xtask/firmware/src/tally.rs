//! What the rows of a frame took.

use crate::report;

/// Instructions of the rows so far.
pub struct Tally {
    /// Of the even rows and of the odd ones: two cores draw a frame so. Row 0 is the top one.
    halves: [u64; 2],
    /// The row that took the most, the upper one of equals, and how many.
    worst: (u32, u32),
}

impl Tally {
    pub const NONE: Self = Self {
        halves: [0; 2],
        worst: (0, 0),
    };

    /// Counts the next row further down.
    pub fn add(&mut self, row: u32, instructions: u32) {
        self.halves[row as usize % 2] += u64::from(instructions);
        if instructions > self.worst.1 {
            self.worst = (row, instructions);
        }
    }

    pub fn report(&self) {
        report::number(" even=", self.halves[0]);
        report::number(" odd=", self.halves[1]);
        report::number(" worst_row=", u64::from(self.worst.0));
        report::number(" worst=", u64::from(self.worst.1));
    }
}
