//! Floor 2: what a ray shows that hits nothing: one colour, or a sky.

use crate::color::Color;
use crate::error_kind::ErrorKind;
use crate::material::is_color;
use crate::number::{Number, Unit, to_u32};
use crate::vector::{Direction, Position};

/// Sky as the user describes it: the colour of a ray that hits nothing depends on how steep it is.
///
/// A ray in direction d shows horizon + (above − horizon) · d · up, or horizon + (below − horizon) · −d · up
/// if it points below the horizon.
///
/// ```
/// use reflet::description::Sky;
/// use reflet::{Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(lights: 1)>::new();
/// scene.set_sky([0, 0, 1], [[0.3, 0.2, 0.1], [0.9, 0.9, 1.0], [0.2, 0.4, 0.9]])?;
/// let Some(Sky { up, below, above, .. }) = scene.description().sky else { unreachable!() };
/// assert_eq!((up, below[0]), (Position::new([0.0, 0.0, 1.0]), Number::new(0.3)));
/// assert_eq!(above[2], Number::new(0.9));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Sky {
    /// Direction straight up, of any length above 0.
    pub up: Position,
    /// Colour straight down: red, green and blue, 0 to 16 each.
    pub below: [Number; 3],
    /// Colour at the horizon.
    pub horizon: [Number; 3],
    /// Colour straight up.
    pub above: [Number; 3],
}

impl Sky {
    /// Tests whether all its colours are in range.
    const fn has_colors(&self) -> bool {
        is_color(self.below) && is_color(self.horizon) && is_color(self.above)
    }
}

/// Background as it is described.
#[derive(Clone, Copy, Debug)]
pub struct Background {
    /// Colour that a ray shows where it hits nothing. Black if there is a sky.
    pub(crate) color: [Number; 3],
    pub(crate) sky: Option<Sky>,
}

impl Background {
    /// A black background.
    pub(crate) const BLACK: Self = Self::of_color([Number::ZERO; 3]);

    /// Creates a background of one colour.
    pub(crate) const fn of_color(color: [Number; 3]) -> Self {
        Self { color, sky: None }
    }

    /// Creates a sky, with its colours below, at the horizon and above.
    pub(crate) const fn of_sky(up: Position, [below, horizon, above]: [[Number; 3]; 3]) -> Self {
        Self {
            sky: Some(Sky {
                up,
                below,
                horizon,
                above,
            }),
            ..Self::BLACK
        }
    }

    /// Returns what is wrong, and the part that is: a colour out of range, or an `up` of length zero.
    pub(crate) const fn fault(&self) -> Option<(&'static str, ErrorKind)> {
        match &self.sky {
            None if !is_color(self.color) => Some(("scene", ErrorKind::Background)),
            Some(sky) if !sky.up.is_in_range() => Some(("sky", ErrorKind::Coordinate)),
            Some(sky) if sky.up.magnitude() == 0 => Some(("sky", ErrorKind::Sky)),
            Some(sky) if !sky.has_colors() => Some(("sky", ErrorKind::Color)),
            _ => None,
        }
    }
}

/// Background as the kernels read it.
#[derive(Clone, Copy, Debug)]
pub struct PreparedBackground {
    /// Direction straight up; `None` without a sky. All three colours are then the same.
    up: Option<Direction>,
    below: Color,
    /// Colour at the horizon, or of all rays if there is no sky.
    horizon: Color,
    above: Color,
}

/// What a ray shows where it hits nothing.
#[derive(Clone, Copy, Debug)]
pub struct Beyond {
    pub(crate) color: Color,
    /// Number that a path's signature notes: no shape has it. It tells the two sides of a horizon apart, where the
    /// colours have a kink, and the discs of suns.
    note: u32,
}

/// The note of a ray above the horizon. Below it is one less, and that of a disc is less by at least two.
const ABOVE: u32 = u32::MAX;

impl Beyond {
    /// Creates what all rays show where there is no sky.
    pub(crate) const fn of_one_color(color: Color) -> Self {
        Self { color, note: ABOVE }
    }

    /// Creates what rays show that meet the disc of a sun, by the sun's index among the lights.
    pub(crate) fn of_disc(light: usize, color: Color) -> Self {
        Self {
            color,
            note: ABOVE - 2 - (to_u32(light) & 0xff),
        }
    }

    /// Returns the number that a path's signature notes: no shape has it.
    pub(crate) fn note(&self) -> u32 {
        self.note
    }
}

impl PreparedBackground {
    /// Prepares a background that was checked.
    pub(crate) const fn new(background: &Background) -> Self {
        let (up, [below, horizon, above]) = match &background.sky {
            Some(sky) => (sky.up.direction(), [sky.below, sky.horizon, sky.above]),
            None => (None, [background.color; 3]),
        };
        Self {
            up,
            below: level(below),
            horizon: level(horizon),
            above: level(above),
        }
    }

    /// Tests whether rays in different directions show different colours.
    pub(crate) const fn is_sky(&self) -> bool {
        self.up.is_some()
    }

    /// Returns the colours between which all that can be seen lie.
    pub(crate) const fn colors(&self) -> [Color; 3] {
        [self.below, self.horizon, self.above]
    }

    /// Returns what a ray in a direction shows. `has_sky` says whether there can be a sky: if
    /// not, the direction is not read.
    #[inline(always)]
    pub(crate) fn beyond(&self, direction: Direction, has_sky: bool) -> Beyond {
        let Some(up) = self.up.filter(|_| has_sky) else {
            return Beyond::of_one_color(self.horizon);
        };
        let rise = direction.dot(up).to_bits();
        let is_below = rise < 0;
        let end = if is_below { self.below } else { self.above };
        // The cosine may be above 1 by rounding. A component could then be below 0.
        let share = Unit::from_bits(rise.abs().min(Unit::ONE.to_bits()));
        Beyond {
            color: self.horizon.towards(end, share),
            note: ABOVE - u32::from(is_below),
        }
    }
}

const fn level(color: [Number; 3]) -> Color {
    Color::from_numbers(color).in_levels()
}
