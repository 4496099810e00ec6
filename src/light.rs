//! Floor 2: lights: lamps, which are points, and suns, which are directions.

use crate::color::Color;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::material::is_color;
use crate::number::{Number, Unit, sine_and_cosine_of};
use crate::ray::ScaledPoint;
use crate::vector::{Direction, Position, Vector};

/// Light as the user describes it: a lamp or a sun. A lamp is a point. It shines equally in all directions and does
/// not fall off with distance. A sun shines everywhere from the same direction, and everything on its way blocks it.
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
}

impl Light {
    /// Placeholder for an unused slot in a list of described lights.
    pub(crate) const NONE: Self = Self {
        position: Position::ORIGIN,
        color: [Number::ZERO; 3],
        sun: None,
    };

    /// Describes a lamp.
    pub(crate) const fn lamp(position: Position, color: [Number; 3]) -> Self {
        Self {
            position,
            color,
            sun: None,
        }
    }

    /// Describes a sun, with the angle of its disc in degrees.
    pub(crate) const fn sun(direction: Position, color: [Number; 3], disc: Number) -> Self {
        Self {
            position: direction,
            color,
            sun: Some(disc),
        }
    }

    /// Returns `"light"` or `"sun"`, as an error names the light.
    pub(crate) const fn kind(&self) -> &'static str {
        match self.sun {
            None => "light",
            Some(_) => "sun",
        }
    }

    /// Checks the light. Returns the first fault, or `None` if all numbers are in range.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !self.position.is_in_range() {
            Some(ErrorKind::Coordinate)
        } else if !is_color(self.color) {
            Some(ErrorKind::Color)
        } else {
            match self.sun {
                Some(disc) if self.position.magnitude() == 0 || !disc.is_within(0, 90) => {
                    Some(ErrorKind::Sun)
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
    /// `None` for a lamp. Of a sun, the cosine of half the angle of its disc; above 1 if no disc is seen.
    sun: Option<Unit>,
}

/// More than any cosine.
const NO_DISC: Unit = Unit::from_bits(i32::MAX);

impl PreparedLight {
    /// Placeholder for an unused slot: a scene's type may allow more lights than the scene has.
    pub(crate) const NONE: Self = Self {
        place: ScaledPoint::ORIGIN,
        color: Color::BLACK,
        is_plain: false,
        sun: None,
    };

    /// Converts a described light to the scene's grid. `is_plain` stays `false`, because it depends on
    /// the shapes.
    pub(crate) const fn new(light: &Light, grid: &Grid) -> Self {
        let new = Self {
            color: Color::from_numbers(light.color),
            sun: match light.sun {
                None => None,
                Some(disc) if disc.to_bits() == 0 => Some(NO_DISC),
                Some(disc) => Some(sine_and_cosine_of(Number::from_bits(disc.to_bits() / 2)).1),
            },
            ..Self::NONE
        };
        new.moved(light.position, grid)
    }

    /// Returns the light at another position, or the sun in another direction.
    pub(crate) const fn moved(self, position: Position, grid: &Grid) -> Self {
        Self {
            place: match (self.sun, position.direction()) {
                (Some(_), Some(direction)) => ScaledPoint::beyond(direction),
                _ => grid.place(position),
            },
            ..self
        }
    }

    /// Returns the direction towards a sun, `None` for a lamp.
    #[inline(always)]
    pub(crate) const fn sun(&self) -> Option<Direction> {
        let Vector { x, y, z } = self.place.point.to_vector();
        match self.sun {
            Some(_) => Some(Direction::from_raw(Vector::new(x << 2, y << 2, z << 2))),
            None => None,
        }
    }

    /// Returns the direction towards a sun whose disc is seen, and the cosine of half of its angle.
    pub(crate) const fn disc(&self) -> Option<(Direction, Unit)> {
        match (self.sun(), self.sun) {
            (Some(direction), Some(cosine)) if cosine.to_bits() < NO_DISC.to_bits() => {
                Some((direction, cosine))
            }
            _ => None,
        }
    }
}
