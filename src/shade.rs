//! Floor 5: the light at one hit: ambient, diffuse, specular, and the question whether a light is
//! hidden. Knows no reflection.

use crate::color::{Color, halved};
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Unit, lit, power, reciprocal_root, scaled_by_unit};
use crate::ray::{Path, Place};
use crate::scene::query::{Hit, blocked};
use crate::scene::{Lamp, World};
use crate::shape::plane::PreparedPlane;
use crate::vector::Direction;

/// A point on a surface, seen along a ray, from which rays may leave.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    /// Where rays leave: epsilon above the surface, on the side of the viewer.
    pub(crate) place: Place,
    /// The normal on the side of the viewer.
    pub(crate) normal: Direction,
    /// The direction the surface was seen along.
    pub(crate) view: Direction,
    /// The cosine between the normal and the way back to the viewer, 0 to 1.
    pub(crate) facing: Unit,
    /// The plane it lies on, if it lies on one.
    pub(crate) plane: Option<&'a PreparedPlane>,
    pub(crate) material: &'a PreparedMaterial,
}

impl<'a> Surface<'a> {
    /// The surface at a hit of a ray that came along `view`.
    pub(crate) fn new<W: World>(world: &'a W, hit: &Hit<'a>, view: Direction) -> Self {
        let outward = hit.shape.normal(hit.at);
        let climb = view.dot(outward).to_bits();
        let (normal, facing) = if climb > 0 {
            (outward.reversed(), climb)
        } else {
            (outward, -climb)
        };
        Self {
            place: hit.at.lifted(normal, world.parts().epsilon),
            normal,
            view,
            facing: Unit::from_bits(facing),
            plane: hit.shape.plane(),
            material: world
                .parts()
                .materials
                .get(hit.shape.material().index())
                .unwrap_or(const { &PreparedMaterial::NONE }),
        }
    }

    /// The mirrored path.
    pub(crate) fn reflection(&self) -> Path {
        let cosine = Unit::from_bits(-self.facing.to_bits());
        Path {
            from: self.place,
            direction: self.view.reflected(self.normal, cosine),
        }
    }
}

/// How the colour of a surface is found. Choose with [`crate::Frame::shading`].
pub trait Shading: sealed::Shading {}

impl<T: sealed::Shading> Shading for T {}

pub(crate) mod sealed {
    use super::{Color, Surface, World};

    pub trait Shading {
        /// Whether mirrors are followed.
        const REFLECTS: bool;

        /// The colour of a surface without reflections.
        #[allow(private_interfaces)]
        fn color<W: World>(world: &W, surface: &Surface<'_>) -> Color;

        /// What a ray that meets nothing adds.
        fn missed<W: World>(world: &W) -> Color;
    }
}

/// The default: highlights by the half-way vector (Blinn, "Models of Light Reflection for Computer
/// Synthesized Pictures", SIGGRAPH 1977).
#[derive(Clone, Copy, Debug)]
pub struct BlinnPhong;

/// Highlights by the mirrored light direction (Phong, "Illumination for Computer Generated
/// Pictures", CACM 18(6), 1975).
#[derive(Clone, Copy, Debug)]
pub struct Phong;

/// Shows the first surface's normal as (n + 1) / 2, and blue where nothing is met.
#[derive(Clone, Copy, Debug)]
pub struct Normals;

impl sealed::Shading for BlinnPhong {
    const REFLECTS: bool = true;

    #[allow(private_interfaces)]
    fn color<W: World>(world: &W, surface: &Surface<'_>) -> Color {
        lit_color(world, surface, half_way_cosine)
    }

    fn missed<W: World>(world: &W) -> Color {
        world.parts().background
    }
}

impl sealed::Shading for Phong {
    const REFLECTS: bool = true;

    #[allow(private_interfaces)]
    fn color<W: World>(world: &W, surface: &Surface<'_>) -> Color {
        lit_color(world, surface, mirrored_cosine)
    }

    fn missed<W: World>(world: &W) -> Color {
        world.parts().background
    }
}

impl sealed::Shading for Normals {
    const REFLECTS: bool = false;

    #[allow(private_interfaces)]
    fn color<W: World>(_: &W, surface: &Surface<'_>) -> Color {
        Color::new(surface.normal.components().map(halved))
    }

    fn missed<W: World>(_: &W) -> Color {
        Color::new([Brightness::ZERO, Brightness::ZERO, Brightness::ONE])
    }
}

/// The angles at a surface that a highlight depends on, as cosines.
struct Cosines {
    /// normal · light
    light: Unit,
    /// normal · viewer
    viewer: Unit,
    /// light · viewer
    between: Unit,
}

/// h · n, where h is the unit vector half way between light and viewer: the half-way vector is
/// not built, its length is √(2 + 2 l·v).
fn half_way_cosine(cosines: &Cosines) -> Unit {
    let sum = (i64::from(cosines.light.to_bits()) + i64::from(cosines.viewer.to_bits())) / 2;
    // (1 + l·v) / 2 in Q30; at least one step, as rounding may leave nothing.
    let square = (((1 << 30) + i64::from(cosines.between.to_bits())) / 2).clamp(1, 1 << 30) as u32;
    let zeros = square.leading_zeros() & !1;
    let root = i64::from(reciprocal_root(square << zeros));
    // Q30 · Q31 · 2^(zeros / 2)
    let cosine = (sum * root) >> (31 - zeros / 2);
    Unit::from_bits(cosine.clamp(0, 1 << 30) as i32)
}

/// r · v, where r is the light direction mirrored in the normal: 2 (n·l) (n·v) - l·v.
fn mirrored_cosine(cosines: &Cosines) -> Unit {
    let product = scaled_by_unit(cosines.light.to_bits(), cosines.viewer);
    let cosine = 2 * i64::from(product) - i64::from(cosines.between.to_bits());
    Unit::from_bits(cosine.clamp(0, 1 << 30) as i32)
}

/// ambient + Σ (diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ) · light, all times the material's colour.
fn lit_color<W: World>(world: &W, surface: &Surface<'_>, highlight: fn(&Cosines) -> Unit) -> Color {
    let material = surface.material;
    let mut received = Color::grey(material.ambient);
    for lamp in world.parts().lamps {
        if let Some(strength) = strength(world, surface, lamp, highlight) {
            received = received.plus(lamp.light.color.times(strength));
        }
    }
    received.filtered(material.color)
}

/// What the surface sends on of one light; `None` where the light is behind it or hidden.
fn strength<W: World>(
    world: &W,
    surface: &Surface<'_>,
    lamp: &Lamp,
    highlight: fn(&Cosines) -> Unit,
) -> Option<Brightness> {
    let (way, scale) = surface.place.to(lamp.light.place);
    let (direction, distance) = way.direction_and_length();
    let cosine = surface.normal.dot(direction);
    if cosine <= Unit::ZERO {
        return None;
    }
    let path = Path {
        from: surface.place,
        direction,
    };
    if blocked(world, &path, surface.plane, lamp, distance, scale) {
        return None;
    }
    let material = surface.material;
    let mut strength = lit(cosine, material.diffuse);
    if material.specular > Brightness::ZERO {
        let cosines = Cosines {
            light: cosine,
            viewer: surface.facing,
            between: Unit::from_bits(-surface.view.dot(direction).to_bits()),
        };
        strength += lit(
            power(highlight(&cosines), material.shininess),
            material.specular,
        );
    }
    Some(strength)
}

#[cfg(test)]
mod tests;
