//! Floor 2: point lights.

use crate::color::Color;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::material::is_color;
use crate::number::Number;
use crate::ray::ScaledPoint;
use crate::vector::Position;

/// A point light as it is described: it shines evenly to all sides and does not fall off with
/// distance.
///
/// ```
/// use reflet::description::Light;
/// use reflet::{Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(lights: 1)>::new();
/// scene.add_light([3, -4, 6], [1.0, 0.5, 0.0])?;
/// let [Light { position, color }] = *scene.description().lights else { unreachable!() };
/// assert_eq!(position, Position::new([3.0, -4.0, 6.0]));
/// assert_eq!(color, [1.0, 0.5, 0.0].map(Number::new));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Light {
    /// Where it stands.
    pub position: Position,
    /// Its colour, 0 to 16 a component.
    pub color: [Number; 3],
}

impl Light {
    pub(crate) const NONE: Self = Self {
        position: Position::ORIGIN,
        color: [Number::ZERO; 3],
    };

    /// What is wrong with it.
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

/// A light as the kernels read it.
#[derive(Clone, Copy, Debug)]
pub struct PreparedLight {
    pub(crate) place: ScaledPoint,
    pub(crate) color: Color,
    /// Whether it stands near and outside of all spheres, so that what is hidden from it can be told
    /// by how it sees the shapes.
    pub(crate) is_plain: bool,
}

impl PreparedLight {
    /// Fills the room of a light that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self {
        place: ScaledPoint::ORIGIN,
        color: Color::BLACK,
        is_plain: false,
    };

    /// A light laid on a grid; whether it is plain depends on the shapes.
    pub(crate) const fn new(light: &Light, grid: &Grid) -> Self {
        Self {
            place: grid.place(light.position),
            color: Color::from_numbers(light.color),
            ..Self::NONE
        }
    }
}
