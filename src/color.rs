//! Floor 1: linear colour, its sum over reflections, and the one place where it is quantised.

use crate::number::{
    Brightness, Number, Unit, add_high_positive, high_positive, narrowed, offset_modulo_2_32,
    to_u8, unsigned, wide_positive,
};

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

    /// 255 of its 256 parts, rounded up: what a [`Sum`] adds up, so that its upper bits are 8-bit levels.
    pub const fn in_levels(self) -> Self {
        const fn part(component: Brightness) -> Brightness {
            let bits = component.to_bits();
            Brightness::from_bits(bits - (bits >> 8))
        }
        let [red, green, blue] = self.0;
        Self([part(red), part(green), part(blue)])
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
}

/// The light that a surface sends on before it takes the surface's colour, below 32: Q12.20, or
/// Q6.26 where `PRECISE`.
#[derive(Clone, Copy, Debug)]
pub struct Lighting<const PRECISE: bool>([i32; 3]);

impl<const PRECISE: bool> Lighting<PRECISE> {
    /// How many fraction bits it has.
    const PLACES: u32 = if PRECISE { 26 } else { 20 };

    /// The same brightness in all three components, rounded to nearest.
    #[inline(always)]
    pub fn grey(brightness: Brightness) -> Self {
        let bits = brightness.to_bits();
        let rounded = if PRECISE {
            bits
        } else {
            (bits + (1 << 5)) >> 6
        };
        Self([rounded; 3])
    }

    /// Adds a light's colour times how much of it is sent on, neither below zero: rounded to nearest,
    /// or down to 2⁻²⁶ where `PRECISE`.
    #[inline(always)]
    pub fn add(&mut self, color: Color, strength: Brightness) {
        let ([r, g, b], [red, green, blue]) = (self.0, color.0);
        let with = |sum: i32, light: Brightness| {
            let (light, strength) = (light.to_bits(), strength.to_bits());
            if PRECISE {
                sum + narrowed(wide_positive(light, strength) >> Self::PLACES)
            } else {
                add_high_positive(sum, light, strength)
            }
        };
        self.0 = [with(r, red), with(g, green), with(b, blue)];
    }

    /// Component by component, rounded down to 2⁻²⁶; the products must stay below 32.
    #[inline(always)]
    pub fn filtered(self, color: Color) -> Color {
        let ([r, g, b], [red, green, blue]) = (self.0, color.0);
        let tinted = |light: i32, color: Brightness| {
            let product = wide_positive(light, color.to_bits());
            Brightness::from_bits(narrowed(product >> Self::PLACES))
        };
        Color([tinted(r, red), tinted(g, green), tinted(b, blue)])
    }
}

/// A checked number as a brightness, rounded to nearest.
pub(crate) const fn brightness(number: Number) -> Brightness {
    Brightness::from_bits(number.quantised(26))
}

/// The sum of weighted colours along one path, each [`Color::in_levels`]: Q8.24.
///
/// With weights that sum to at most one and colours below 32 it stays below 32. Every term is
/// rounded down to 2⁻²⁴, so that 256 of them lose less than 2⁻¹⁶, a 256th of an 8-bit step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sum([i32; 3]);

impl Sum {
    /// Nothing yet.
    pub const ZERO: Self = Self([0; 3]);

    /// Adds `weight` · `color`, neither below zero.
    #[inline(always)]
    pub fn add(&mut self, weight: Unit, color: Color) {
        let ([r, g, b], [red, green, blue]) = (self.0, color.0);
        let share = |color: Brightness| high_positive(weight.to_bits(), color.to_bits());
        // Red last: the compiler moves fewer registers then.
        let green = g + share(green);
        let blue = b + share(blue);
        let red = r + share(red);
        self.0 = [red, green, blue];
    }

    /// The sums a quarter, half and three quarters of the way to another one, after this one itself:
    /// along the cubic through both that bends so much at each (Lagrange's, where the bends are
    /// [`Bend::of`] the sums before and behind).
    #[inline(always)]
    pub fn towards(self, end: Self, [first, last]: [Bend; 2]) -> [Self; 4] {
        let mut sums = [self; 4];
        for axis in 0..3 {
            let (start, way) = (self.0[axis], end.0[axis] - self.0[axis]);
            // A bend is within ±2³⁰, so a 32nd of it leaves room for twelve.
            let (first, last) = (first.0[axis] >> 5, last.0[axis] >> 5);
            // A line, less (u - u²) / 6 · ((2 - u) first + (1 + u) last).
            let both = 5 * (first + last);
            sums[1].0[axis] = start + (way >> 2) - ((both + 2 * first) >> 2);
            sums[2].0[axis] = start + (way >> 1) - (2 * (first + last));
            sums[3].0[axis] = end.0[axis] - (way >> 2) - ((both + 2 * last) >> 2);
        }
        sums
    }

    /// The sum half way to another one, along the same cubic.
    #[inline(always)]
    pub fn half_way(self, end: Self, [first, last]: [Bend; 2]) -> Self {
        let bend = first.each(last, |first, last| (first >> 4) + (last >> 4));
        let middle = self.each(end, |start, end| (start + end) >> 1);
        middle.less(bend)
    }

    /// This sum and three quarters of another one.
    #[inline(always)]
    pub fn with_most_of(self, other: Self) -> Self {
        self.each(other, |sum, other| sum + other - (other >> 2))
    }

    /// How much more it is than another one.
    #[inline(always)]
    pub fn less(self, other: Self) -> Self {
        self.each(other, |sum, other| sum - other)
    }

    /// Whether no channel is further from zero than so much.
    #[inline(always)]
    pub fn is_within(self, most: i32) -> bool {
        self.0
            .iter()
            .all(|&sum| offset_modulo_2_32(sum, most) <= 2 * unsigned(most))
    }

    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(i32, i32) -> i32) -> Self {
        let ([r, g, b], [red, green, blue]) = (self.0, other.0);
        Self([of(r, red), of(g, green), of(b, blue)])
    }

    /// Red, green and blue in steps of 2⁻²⁴.
    #[cfg(test)]
    pub(crate) fn to_bits(self) -> [i32; 3] {
        self.0
    }

    /// Clamped to 0 to 1 and rounded to 8 bits: round(255 c).
    #[inline(always)]
    pub fn to_rgb8(self) -> [u8; 3] {
        let level = |sum: i32| to_u8(unsigned(((sum + (1 << 15)) >> 16).clamp(0, 255)));
        let [red, green, blue] = self.0;
        [level(red), level(green), level(blue)]
    }
}

/// How much three sums at the same distance from each other deviate from a straight line: the second
/// difference.
pub type Bend = Sum;

impl Bend {
    /// Of three sums.
    #[inline(always)]
    pub fn of(before: Sum, middle: Sum, after: Sum) -> Self {
        let ends = before.each(after, |before, after| before + after);
        ends.each(middle, |ends, middle| ends - 2 * middle)
    }

    /// Of three sums of which the last is half as far from the middle as the first, at the last's
    /// distance, but for a sixteenth.
    #[inline(always)]
    pub fn of_uneven(before: Sum, middle: Sum, after: Sum) -> Self {
        let ends = before.each(after, |before, after| before + 2 * after);
        ends.each(middle, |ends, middle| {
            let bends = ends - 3 * middle;
            // A third.
            (bends >> 2) + (bends >> 4)
        })
    }
}

/// (1 + `unit`) / 2 as a brightness: how the normals view shows a coordinate.
///
/// A coordinate a last place beyond ±1 is taken for ±1. The coordinate is rounded to 2⁻²⁰ first, so that
/// one that is zero but for rounding lands on the same side of level 127.5 everywhere.
pub fn halved(unit: Unit) -> Brightness {
    let held = unit.to_bits().clamp(-(1 << 30), 1 << 30);
    let rounded = (held + (1 << 9)) >> 10 << 10;
    Brightness::from_bits((rounded >> 5) + (1 << 25))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quantised(value: f64) -> u8 {
        let mut sum = Sum::ZERO;
        let color = Color::grey(brightness(Number::new(value)));
        sum.add(Unit::ONE, color.in_levels());
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

    #[test]
    fn three_sums_at_uneven_distances_tell_how_much_a_parabola_bends() {
        // At 0, 2 and 3, at the distance of one: the second difference is twice the factor of x².
        for factor in [-(1 << 24), -123_457, -1, 0, 1, 98_765, 1 << 24] {
            let at = |x: i32| Sum([0, 7, -9].map(|slope| factor * x * x + slope * x + 1_000));
            let Sum(bends) = Bend::of_uneven(at(0), at(2), at(3));
            let truth = 2 * factor;
            for bend in bends {
                // A sixteenth less, and two shifts rounded down.
                let short = (truth - bend).abs();
                assert!(short <= truth.abs() / 16 + 2, "{bend}, not {truth}");
            }
        }
    }
}
