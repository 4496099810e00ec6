//! Floor 2: point lights.

use crate::color::Color;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::material::is_color;
use crate::number::Number;
use crate::ray::ScaledPoint;
use crate::vector::Position;

/// Point light as the user describes it. It shines equally in all directions and does not fall off with
/// distance.
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
    /// Position of the light, in scene units.
    pub position: Position,
    /// Colour of the light, each component from 0 to 16.
    pub color: [Number; 3],
}

impl Light {
    /// Placeholder for an unused slot in a list of described lights.
    pub(crate) const NONE: Self = Self {
        position: Position::ORIGIN,
        color: [Number::ZERO; 3],
    };

    /// Checks the light. Returns the first fault, or `None` if position and colour are in range.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !self.position.is_in_range() {
            Some(ErrorKind::Coordinate)
        } else if !is_color(self.color) {
            Some(ErrorKind::Color)
        } else {
            None
        }
    }
}

/// Light as the kernels read it: position in steps of the grid, and colour.
#[derive(Clone, Copy, Debug)]
pub struct PreparedLight {
    pub(crate) place: ScaledPoint,
    pub(crate) color: Color,
    /// Whether shadows can be tested with the values that are prepared for each pair of light and shape.
    /// The light must be near and outside of all spheres.
    pub(crate) is_plain: bool,
}

impl PreparedLight {
    /// Placeholder for an unused slot: a scene's type may allow more lights than the scene has.
    pub(crate) const NONE: Self = Self {
        place: ScaledPoint::ORIGIN,
        color: Color::BLACK,
        is_plain: false,
    };

    /// Converts a described light to the scene's grid. `is_plain` stays `false`, because it depends on
    /// the shapes.
    pub(crate) const fn new(light: &Light, grid: &Grid) -> Self {
        Self {
            place: grid.place(light.position),
            color: Color::from_numbers(light.color),
            ..Self::NONE
        }
    }
}
