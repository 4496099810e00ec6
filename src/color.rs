//! Floor 1: linear colour, its sum over reflections, and the one place where it is quantised.

use crate::number::{Brightness, Number, Unit, tinted};

/// A linear colour: red, green and blue in Q6.26, 0 to below 32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color([Brightness; 3]);

impl Color {
    /// No light.
    pub const BLACK: Self = Self([Brightness::ZERO; 3]);

    /// The largest component a description may name: 16.
    pub const MAX: i64 = 16;

    /// From red, green and blue.
    pub const fn new(components: [Brightness; 3]) -> Self {
        Self(components)
    }

    /// From numbers that have been checked to lie in 0 to [`Color::MAX`], rounded to 2⁻²⁶.
    pub const fn from_numbers([red, green, blue]: [Number; 3]) -> Self {
        Self([brightness(red), brightness(green), brightness(blue)])
    }

    /// Red, green and blue.
    pub const fn components(self) -> [Brightness; 3] {
        self.0
    }

    /// The largest component.
    pub const fn largest(self) -> Brightness {
        let [red, green, blue] = self.0;
        let most = if red.to_bits() > green.to_bits() {
            red
        } else {
            green
        };
        if most.to_bits() > blue.to_bits() {
            most
        } else {
            blue
        }
    }

    /// The same brightness in all three components.
    pub const fn grey(brightness: Brightness) -> Self {
        Self([brightness; 3])
    }

    /// The sum; it must stay below 32.
    pub fn plus(self, other: Self) -> Self {
        let ([r, g, b], [dr, dg, db]) = (self.0, other.0);
        Self([r + dr, g + dg, b + db])
    }

    /// Every component times `brightness`; the products must stay below 32.
    pub fn times(self, brightness: Brightness) -> Self {
        Self(self.0.map(|component| tinted(component, brightness)))
    }

    /// Component by component; the products must stay below 32.
    pub fn filtered(self, other: Self) -> Self {
        let ([r, g, b], [dr, dg, db]) = (self.0, other.0);
        Self([tinted(r, dr), tinted(g, dg), tinted(b, db)])
    }
}

/// A checked number as a brightness, rounded to nearest.
pub(crate) const fn brightness(number: Number) -> Brightness {
    Brightness::from_bits(number.quantised(26))
}

/// The sum of weighted colours along one path: Q8.56, so that nothing is rounded while it grows.
///
/// With weights that sum to at most one and colours below 32 it stays below 32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sum([i64; 3]);

impl Sum {
    /// Nothing yet.
    pub const ZERO: Self = Self([0; 3]);

    /// Adds `weight` · `color`, exactly.
    pub fn add(&mut self, weight: Unit, color: Color) {
        for (sum, component) in self.0.iter_mut().zip(color.0) {
            *sum += i64::from(weight.to_bits()) * i64::from(component.to_bits());
        }
    }

    /// Clamped to 0 to 1 and rounded to 8 bits: round(255 c).
    pub fn to_rgb8(self) -> [u8; 3] {
        self.0.map(|sum| {
            // Q24 is enough to round by; 255 · 2²⁴ fits 32 bits.
            let clamped = ((sum >> 32) as i32).clamp(0, 1 << 24) as u32;
            ((clamped * 255 + (1 << 23)) >> 24) as u8
        })
    }
}

/// (1 + `unit`) / 2 as a brightness: how the normals view shows a coordinate.
///
/// The coordinate is rounded to 2⁻²⁰ first, so that one that is zero but for rounding lands on the
/// same side of level 127.5 everywhere.
pub fn halved(unit: Unit) -> Brightness {
    let rounded = (unit.to_bits() + (1 << 9)) >> 10 << 10;
    Brightness::from_bits((rounded >> 5) + (1 << 25))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quantised(value: f64) -> u8 {
        let mut sum = Sum::ZERO;
        sum.add(Unit::ONE, Color::grey(brightness(Number::new(value))));
        sum.to_rgb8()[0]
    }

    #[test]
    fn every_level_is_hit_in_its_middle() {
        for level in 0..=255_u8 {
            assert_eq!(quantised(f64::from(level) / 255.0), level);
        }
    }

    #[test]
    fn levels_change_half_way_between() {
        for level in 0..255_u8 {
            let edge = (f64::from(level) + 0.5) / 255.0;
            assert_eq!(quantised(edge - 1e-6), level);
            assert_eq!(quantised(edge + 1e-6), level + 1);
        }
    }

    #[test]
    fn what_is_brighter_than_white_is_white() {
        assert_eq!(quantised(16.0), 255);
    }
}
