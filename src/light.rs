//! Floor 2: lights: lamps, which are points, and suns, which are directions.

use crate::color::Color;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::material::is_color;
use crate::number::{
    Brightness, Length, Number, Unit, leading_zeros, lit, narrowed, narrowed_unsigned,
    narrowed_unsigned_128, ratio, signed, sine_and_cosine_of, to_u8, unsigned, unsigned_128,
    wide_positive,
};
use crate::ray::{ScaledPoint, shift_of};
use crate::vector::{Direction, Position, Vector};

/// Light as the user describes it: a lamp or a sun. A lamp is a point. It shines equally in all directions, and falls
/// off with distance if it has a range. A sun shines everywhere from the same direction, and everything on its way
/// blocks it.
///
/// ```
/// use reflet::description::Light;
/// use reflet::{Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(lights: 1)>::new();
/// scene.add_light([3, -4, 6], [1.0, 0.5, 0.0])?;
/// let [Light { position, color, .. }] = *scene.description().lights else { unreachable!() };
/// assert_eq!(position, Position::new([3.0, -4.0, 6.0]));
/// assert_eq!(color, [1.0, 0.5, 0.0].map(Number::new));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Light {
    /// Position of a lamp, in scene units. Of a sun, the direction towards it, of any length above 0.
    pub position: Position,
    /// Colour of the light, each component from 0 to 16.
    pub color: [Number; 3],
    /// `None` for a lamp. Of a sun, the angle of its disc in the sky, in degrees: 0 to 90. 0 shows none.
    pub sun: Option<Number>,
    /// Range r of a lamp that falls off: at the distance d its strength is 1 / (1 + (d / r)²), so it is a half at r. In
    /// scene units, above 0, at most 2³⁰. `None` for a lamp that does not fall off, and for a sun.
    pub range: Option<Number>,
}

impl Light {
    /// Placeholder for an unused slot in a list of described lights.
    pub(crate) const NONE: Self = Self::lamp(Position::ORIGIN, [Number::ZERO; 3]);

    /// Describes a lamp.
    pub(crate) const fn lamp(position: Position, color: [Number; 3]) -> Self {
        Self {
            position,
            color,
            sun: None,
            range: None,
        }
    }

    /// Describes a lamp that falls off.
    pub(crate) const fn ranged(position: Position, color: [Number; 3], range: Number) -> Self {
        Self {
            range: Some(range),
            ..Self::lamp(position, color)
        }
    }

    /// Describes a sun, with the angle of its disc in degrees.
    pub(crate) const fn sun(direction: Position, color: [Number; 3], disc: Number) -> Self {
        Self {
            sun: Some(disc),
            ..Self::lamp(direction, color)
        }
    }

    /// Returns `"light"` or `"sun"`, as an error names the light.
    pub(crate) const fn kind(&self) -> &'static str {
        if self.sun.is_some() { "sun" } else { "light" }
    }

    /// Checks the light. Returns the first fault, or `None` if all numbers are in range.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !self.position.is_in_range() {
            Some(ErrorKind::Coordinate)
        } else if !is_color(self.color) {
            Some(ErrorKind::Color)
        } else {
            match (self.sun, self.range) {
                (Some(disc), _) if self.position.magnitude() == 0 || !disc.is_within(0, 90) => {
                    Some(ErrorKind::Sun)
                }
                (_, Some(range)) if range.to_bits() <= 0 || !range.is_within(0, 1 << 30) => {
                    Some(ErrorKind::Range)
                }
                _ => None,
            }
        }
    }
}

/// Light as the kernels read it: position in steps of the grid, and colour.
#[derive(Clone, Copy, Debug)]
pub struct PreparedLight {
    /// Position of a lamp. A sun is so far away that rays from all near points to it are parallel.
    pub(crate) place: ScaledPoint,
    pub(crate) color: Color,
    /// Whether shadows can be tested with the values that are prepared for each pair of light and shape.
    /// The light must be near and outside of all spheres.
    pub(crate) is_plain: bool,
    /// Whether a sphere is so small for its distance from the light that its tangents do not tell what it hides.
    pub(crate) has_small: bool,
    kind: Kind,
}

/// The kinds of lights, with what a kernel needs to know of each. It takes eight bytes.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// A lamp that does not fall off.
    Lamp,
    /// A lamp with a range of `mantissa` · 2^(97 - `drop`) steps of the grid. The mantissa is 2³⁰ to 2³¹ - 1.
    Ranged { drop: u8, mantissa: i32 },
    /// The cosine of half the angle of a sun's disc; above 1 if no disc is seen.
    Sun(Unit),
}

impl Kind {
    const fn new(light: &Light, grid: &Grid) -> Self {
        match (light.sun, light.range) {
            (None, None) => Self::Lamp,
            (None, Some(range)) => Self::ranged(range, grid),
            (Some(disc), _) if disc.to_bits() == 0 => Self::Sun(NO_DISC),
            (Some(disc), _) => {
                Self::Sun(sine_and_cosine_of(Number::from_bits(disc.to_bits() / 2)).1)
            }
        }
    }

    /// Converts a range above 0 to the grid. Its leading 31 bits are kept.
    const fn ranged(range: Number, grid: &Grid) -> Self {
        let bits = unsigned_128(range.to_bits());
        let zeros = bits.leading_zeros();
        let leading = narrowed_unsigned_128((bits << zeros) >> 97);
        Self::Ranged {
            drop: to_u8(zeros + grid.drop()),
            mantissa: signed(narrowed_unsigned(leading)),
        }
    }
}

/// More than any cosine.
const NO_DISC: Unit = Unit::from_bits(i32::MAX);

impl PreparedLight {
    /// Placeholder for an unused slot: a scene's type may allow more lights than the scene has.
    pub(crate) const NONE: Self = Self {
        place: ScaledPoint::ORIGIN,
        color: Color::BLACK,
        is_plain: false,
        has_small: false,
        kind: Kind::Lamp,
    };

    /// Converts a described light to the scene's grid. `is_plain` stays `false`, because it depends on
    /// the shapes.
    pub(crate) const fn new(light: &Light, grid: &Grid) -> Self {
        let new = Self {
            color: Color::from_numbers(light.color),
            kind: Kind::new(light, grid),
            ..Self::NONE
        };
        new.moved(light.position, grid)
    }

    /// Returns the light at another position, or the sun in another direction.
    pub(crate) const fn moved(self, position: Position, grid: &Grid) -> Self {
        Self {
            place: match (self.kind, position.direction()) {
                (Kind::Sun(_), Some(direction)) => ScaledPoint::beyond(direction),
                _ => grid.place(position),
            },
            ..self
        }
    }

    /// Returns the direction towards a sun, `None` for a lamp.
    #[inline(always)]
    pub(crate) const fn sun(&self) -> Option<Direction> {
        let Vector { x, y, z } = self.place.point.to_vector();
        match self.kind {
            Kind::Sun(_) => Some(Direction::from_raw(Vector::new(x << 2, y << 2, z << 2))),
            Kind::Lamp | Kind::Ranged { .. } => None,
        }
    }

    /// Returns the direction towards a sun, and the cosine of half the angle of its disc. `None` if no disc is
    /// seen.
    pub(crate) const fn disc(&self) -> Option<(Direction, Unit)> {
        match (self.sun(), self.kind) {
            (Some(direction), Kind::Sun(cosine)) if cosine.to_bits() < NO_DISC.to_bits() => {
                Some((direction, cosine))
            }
            _ => None,
        }
    }

    /// Tests whether the light falls off with distance.
    pub(crate) const fn is_ranged(&self) -> bool {
        matches!(self.kind, Kind::Ranged { .. })
    }

    /// Returns the strength with which the light arrives at a distance, in steps of 2^`scale`: `strength` times 1 /
    /// (1 + (d / r)²), or `strength` if the light does not fall off. The factor is known to 2⁻²⁴, and the product is
    /// rounded down to 2⁻²⁴.
    #[inline(always)]
    pub(crate) const fn weakened(
        &self,
        strength: Brightness,
        distance: Length,
        scale: u32,
    ) -> Brightness {
        match self.kind {
            Kind::Ranged { drop, mantissa } => lit(
                falloff((mantissa, 97 - drop as i32), distance, scale),
                strength,
            ),
            Kind::Lamp | Kind::Sun(_) => strength,
        }
    }
}

/// Returns 1 / (1 + (d / r)²) = r² / (r² + d²) in Q2.30, from 0 to 1. r is `mantissa` · 2^`exponent` steps, d is
/// `distance` in steps of 2^`scale`, above 0.
///
/// The error is below 2⁻²⁴: both squares are brought to the same scale and cut to the leading 27 bits of their sum,
/// which takes up to 2⁻²⁶. The quotient is known to 2⁻²⁶, and d to 2⁻²⁷ of itself. If d is a few steps, its own
/// rounding by a step adds up to 0.65 / r, in steps.
#[inline(never)]
const fn falloff((range, exponent): (i32, i32), distance: Length, scale: u32) -> Unit {
    let distance = unsigned(distance.to_bits());
    // The distance gets 31 bits, like the range.
    let up = leading_zeros(distance) - 1;
    let distance = signed(distance << up);
    let gap = exponent + signed(up) - signed(scale);
    let (range, distance) = if gap > 0 {
        (range, distance >> shift_of(unsigned(gap)))
    } else {
        (range >> shift_of(unsigned(-gap)), distance)
    };
    let square = wide_positive(range, range);
    let sum = square + wide_positive(distance, distance);
    // One more, so that the sum is larger even where it is as good as r².
    let [square, sum] = [square >> 33, (sum >> 33) + 1];
    Unit::from_bits(ratio(unsigned(narrowed(square)), unsigned(narrowed(sum))))
}

#[cfg(test)]
mod tests;
