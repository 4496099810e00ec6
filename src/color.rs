//! Floor 1: linear colour, the sum of colours over reflections, and the one function that quantises a
//! colour.

mod levels;
mod parabola;

pub use levels::{Levels, Mixture};
pub use parabola::{LONGEST, Parabola};

use crate::number::{
    Brightness, Number, Unit, add_high_positive, high_positive, narrowed, offset_modulo_2_32,
    scaled_by_unit, to_u8, unsigned, wide_positive,
};

/// Linear colour: red, green and blue in Q6.26, each from 0 to below 32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Color([Brightness; 3]);

impl Color {
    /// Black: all components are 0.
    pub const BLACK: Self = Self([Brightness::ZERO; 3]);

    /// Largest component that a description may have: 16.
    pub const MAX: i64 = 16;

    /// Creates a colour from red, green and blue.
    pub const fn new(components: [Brightness; 3]) -> Self {
        Self(components)
    }

    /// Converts red, green and blue to a colour, rounded to 2⁻²⁶. The caller has checked that each is
    /// within 0 to [`Color::MAX`].
    pub const fn from_numbers([red, green, blue]: [Number; 3]) -> Self {
        Self([brightness(red), brightness(green), brightness(blue)])
    }

    /// Scales the colour by 255/256, rounded up. A [`Sum`] adds such colours, so that its upper bits are
    /// 8-bit display levels.
    pub const fn in_levels(self) -> Self {
        const fn part(component: Brightness) -> Brightness {
            let bits = component.to_bits();
            Brightness::from_bits(bits - (bits >> 8))
        }
        let [red, green, blue] = self.0;
        Self([part(red), part(green), part(blue)])
    }

    /// Returns red, green and blue.
    pub const fn components(self) -> [Brightness; 3] {
        self.0
    }

    /// Returns the largest of the three components.
    pub const fn largest(self) -> Brightness {
        let [red, green, blue] = self.0;
        larger(larger(red, green), blue)
    }

    /// Tests whether all three components have the same brightness.
    pub(crate) const fn is_grey(self) -> bool {
        let [red, green, blue] = self.0;
        red.to_bits() == green.to_bits() && green.to_bits() == blue.to_bits()
    }

    /// Returns the colour at a share, 0 to 1, of the way to another. Rounded down to 2⁻²⁶.
    #[inline(always)]
    pub(crate) fn towards(self, other: Self, share: Unit) -> Self {
        let part = |from: Brightness, to: Brightness| {
            let change = scaled_by_unit(to.to_bits() - from.to_bits(), share);
            Brightness::from_bits(from.to_bits() + change)
        };
        let ([r, g, b], [red, green, blue]) = (self.0, other.0);
        Self([part(r, red), part(g, green), part(b, blue)])
    }

    /// Returns the colour that has, in each component, the larger of this and of another colour.
    pub(crate) const fn at_least(self, other: Self) -> Self {
        let ([r, g, b], [red, green, blue]) = (self.0, other.0);
        Self([larger(r, red), larger(g, green), larger(b, blue)])
    }

    /// Creates a grey: all three components have the same brightness.
    pub const fn grey(brightness: Brightness) -> Self {
        Self([brightness; 3])
    }
}

/// Light that a surface reflects, before it is multiplied by the surface's colour. Below 32, in Q12.20,
/// or in Q6.26 if `PRECISE`.
#[derive(Clone, Copy, Debug)]
pub struct Lighting<const PRECISE: bool>([i32; 3]);

impl<const PRECISE: bool> Lighting<PRECISE> {
    /// Number of fraction bits of a component.
    const PLACES: u32 = if PRECISE { 26 } else { 20 };

    /// Creates grey light: all three components have the same brightness, rounded to nearest.
    #[inline(always)]
    pub fn grey(brightness: Brightness) -> Self {
        let bits = brightness.to_bits();
        let rounded = if PRECISE { bits } else { (bits + (1 << 5)) >> 6 };
        Self([rounded; 3])
    }

    /// Adds the light `color` · `strength`, neither of which is below 0. `strength` is the share of the
    /// light that the surface reflects. Rounds to nearest, or down to 2⁻²⁶ if `PRECISE`.
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

    /// Multiplies the light by the surface's colour, component by component, rounded down to 2⁻²⁶. The
    /// products must stay below 32.
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

/// Converts a number to a brightness, rounded to nearest. The caller has checked its range.
pub(crate) const fn brightness(number: Number) -> Brightness {
    Brightness::from_bits(number.quantised(26))
}

/// Returns the larger of two components.
const fn larger(one: Brightness, other: Brightness) -> Brightness {
    if one.to_bits() > other.to_bits() { one } else { other }
}

/// Half of an 8-bit level, as a part of a [`Sum`].
const HALF: i32 = 1 << 15;

/// Sum of weighted colours along one path, in Q8.24. Every colour comes from [`Color::in_levels`].
///
/// If the weights sum to at most one and colours are below 32, the sum stays below 32. Every term is
/// rounded down to 2⁻²⁴. So 256 terms lose less than 2⁻¹⁶, which is 1/256 of an 8-bit step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sum([i32; 3]);

impl Sum {
    /// No difference of two sums.
    pub const ZERO: Self = Self([0; 3]);

    /// No light. It holds half of an 8-bit level, so that [`Sum::to_rgb8`] only has to cut.
    pub const DARK: Self = Self([HALF; 3]);

    /// Adds `weight` · `color`, rounded down to 2⁻²⁴. Neither factor is below 0.
    #[inline(always)]
    pub fn add(&mut self, weight: Unit, color: Color) {
        let ([r, g, b], [red, green, blue]) = (self.0, color.0);
        let share = |color: Brightness| high_positive(weight.to_bits(), color.to_bits());
        // Red comes last, because the compiler then moves fewer registers.
        let green = g + share(green);
        let blue = b + share(blue);
        let red = r + share(red);
        self.0 = [red, green, blue];
    }

    /// Interpolates the sum half way between this sum and `end`. `bend` is the second difference of the
    /// three.
    #[inline(always)]
    pub fn half_way(self, end: Self, bend: Bend) -> Self {
        let middle = self.each(end, |start, end| (start + end) >> 1);
        middle.each(bend, |middle, bend| middle - (bend >> 1))
    }

    /// Subtracts another sum of a pixel's colour, channel by channel.
    #[inline(always)]
    pub fn less(self, other: Self) -> Self {
        self.each(other, |sum, other| sum - other)
    }

    /// Tests whether every component is within ±`most`, in steps of 2⁻²⁴.
    #[inline(always)]
    pub fn is_within(self, most: i32) -> bool {
        self.0
            .iter()
            .all(|&sum| offset_modulo_2_32(sum, most) <= 2 * unsigned(most))
    }

    /// Combines two sums, component by component, with the function `of`.
    #[inline(always)]
    fn each(self, other: Self, of: impl Fn(i32, i32) -> i32) -> Self {
        let ([r, g, b], [red, green, blue]) = (self.0, other.0);
        Self([of(r, red), of(g, green), of(b, blue)])
    }

    /// Returns red, green and blue in steps of 2⁻²⁴.
    #[cfg(any(test, feature = "files"))]
    pub(crate) fn to_bits(self) -> [i32; 3] {
        self.0.map(|sum| sum - HALF)
    }

    /// Converts the sum to 8 bits per component: clamped to 0 to 1, then round(255 c).
    #[inline(always)]
    pub fn to_rgb8(self) -> [u8; 3] {
        let level = |sum: i32| to_u8(unsigned((sum >> 16).clamp(0, 255)));
        let [red, green, blue] = self.0;
        [level(red), level(green), level(blue)]
    }
}

/// Second difference of three sums at equal distances: their deviation from a straight line.
pub type Bend = Sum;

/// Converts a coordinate of a normal to a brightness: (1 + `unit`) / 2. The view of normals shows it.
///
/// A coordinate just beyond ±1 counts as ±1. The coordinate is first rounded to 2⁻²⁰. So a coordinate
/// that is 0 except for rounding is on the same side of level 127.5 in every picture.
pub fn halved(unit: Unit) -> Brightness {
    let held = unit.to_bits().clamp(-(1 << 30), 1 << 30);
    let rounded = (held + (1 << 9)) >> 10 << 10;
    Brightness::from_bits((rounded >> 5) + (1 << 25))
}

#[cfg(test)]
mod tests;
