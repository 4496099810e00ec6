//! Floor 5: the light at one hit: ambient, diffuse, specular, and the question whether a light is
//! hidden. Knows no reflection.

use core::marker::PhantomData;

use crate::color::{Color, halved};
use crate::material::PreparedMaterial;
use crate::number::{
    Brightness, Exponent, Unit, even_power, high_unsigned, lit, power, ratio, root_of_unit,
    scaled_by_unit,
};
use crate::ray::{Path, Place, Trail};
use crate::scene::query::{Shape, ShapeNumber, blocked, blocked_from, for_first_four};
use crate::scene::view::{Standing, View};
use crate::scene::{Lamp, LampParts, World};
use crate::shape::cylinder::PreparedCylinder;
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
    /// The shape it belongs to.
    pub(crate) shape: ShapeNumber,
    /// Whether it is seen from the inside, or against a plane's normal.
    pub(crate) is_inside: bool,
    /// The cylinder whose outside it is, if it is one.
    pub(crate) cylinder: Option<&'a PreparedCylinder>,
    pub(crate) material: &'a PreparedMaterial,
}

/// How far the cosine at a curved surface may be wrong: 2⁻¹⁶.
const RIM: Unit = Unit::from_bits(1 << 14);

impl<'a> Surface<'a> {
    /// The surface of a shape at a place that was seen along `view`; `None` where there is no such
    /// shape.
    #[inline(always)]
    pub(crate) fn new<W: World>(
        world: &'a W,
        at: Place,
        shape: ShapeNumber,
        view: Direction,
    ) -> Option<Self> {
        let parts = world.parts();
        let (outward, material, cylinder) = match parts.shape(shape)? {
            Shape::Sphere(sphere) => (sphere.normal(at.point), sphere.material, None),
            Shape::Cylinder(cylinder) => {
                (cylinder.normal(at.point), cylinder.material, Some(cylinder))
            }
            Shape::Plane(plane) => (plane.normal, plane.material, None),
        };
        let climb = view.short_dot(outward);
        // At the rim of a shape rounding must not turn its outside into its inside.
        let is_inside = match parts.is_plane(shape) {
            true => climb > Unit::ZERO,
            false => climb > RIM,
        };
        let normal = outward.reversed_if(is_inside);
        Some(Self {
            place: at.lifted(normal, parts.epsilon),
            normal,
            view,
            facing: climb.wrapping_abs(),
            shape,
            is_inside,
            cylinder: cylinder.filter(|_| !is_inside),
            material: parts.material(material),
        })
    }

    /// The shape, unless it may be met again by a ray that leaves it here: from inside of a sphere or
    /// cylinder.
    #[inline(always)]
    pub(crate) fn left<W: World>(&self, world: &W) -> ShapeNumber {
        match self.is_inside && !world.parts().is_plane(self.shape) {
            true => ShapeNumber::NONE,
            false => self.shape,
        }
    }

    /// Turns a path that met the surface into the mirrored one.
    #[inline(never)]
    pub(crate) fn reflect<W: World>(&self, world: &W, path: &mut Path) {
        let cosine = Unit::from_bits(-self.facing.to_bits());
        let direction = self.view.reflected(self.normal, cosine);
        // A curved surface's normal has a length of one but for 2⁻¹⁶.
        let direction = match world.parts().is_plane(self.shape) {
            true => direction,
            false => direction.renormalised(),
        };
        *path = Path::new(self.place, direction);
    }
}

/// How the colour of a surface is found. Choose with [`crate::Frame::shading`].
pub trait Shading: sealed::Shading {}

impl<T: sealed::Shading> Shading for T {}

pub(crate) mod sealed {
    use super::{Color, Surface, Trail, View, World};

    pub trait Shading {
        /// Whether mirrors are followed.
        const REFLECTS: bool;

        /// The colour of a surface without reflections; notes which lights it is lit by.
        #[allow(private_interfaces)]
        fn color<W: World>(
            world: &W,
            view: &View,
            surface: &Surface<'_>,
            trail: &mut Trail,
        ) -> Color;

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

/// Shaded by `K`, [`BlinnPhong`] or [`Phong`], but nothing throws a shadow: a light shines on every
/// surface that faces it, whatever stands between them.
///
/// What a scene takes without its shadows, and what it loses, `examples/report` shows.
#[derive(Clone, Copy, Debug)]
pub struct Unshadowed<K = BlinnPhong>(PhantomData<K>);

impl<K: sealed::Shading + Highlight> sealed::Shading for Unshadowed<K> {
    const REFLECTS: bool = true;

    #[allow(private_interfaces)]
    fn color<W: World>(world: &W, view: &View, surface: &Surface<'_>, trail: &mut Trail) -> Color {
        lit_color::<W, Self>(world, view, surface, trail)
    }

    fn missed<W: World>(world: &W) -> Color {
        K::missed(world)
    }
}

impl<K: Highlight> Highlight for Unshadowed<K> {
    const SHADOWS: bool = false;

    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent) -> Unit {
        K::highlight(cosines, shininess)
    }
}

impl sealed::Shading for BlinnPhong {
    const REFLECTS: bool = true;

    #[allow(private_interfaces)]
    fn color<W: World>(world: &W, view: &View, surface: &Surface<'_>, trail: &mut Trail) -> Color {
        lit_color::<W, Self>(world, view, surface, trail)
    }

    fn missed<W: World>(world: &W) -> Color {
        world.parts().background
    }
}

impl sealed::Shading for Phong {
    const REFLECTS: bool = true;

    #[allow(private_interfaces)]
    fn color<W: World>(world: &W, view: &View, surface: &Surface<'_>, trail: &mut Trail) -> Color {
        lit_color::<W, Self>(world, view, surface, trail)
    }

    fn missed<W: World>(world: &W) -> Color {
        world.parts().background
    }
}

impl sealed::Shading for Normals {
    const REFLECTS: bool = false;

    #[allow(private_interfaces)]
    fn color<W: World>(_: &W, _: &View, surface: &Surface<'_>, _: &mut Trail) -> Color {
        Color::new(surface.normal.components().map(halved))
    }

    fn missed<W: World>(_: &W) -> Color {
        Color::new([Brightness::ZERO, Brightness::ZERO, Brightness::ONE])
    }
}

/// The angles at a surface that a highlight depends on, as cosines.
pub(crate) struct Cosines {
    /// normal · light
    light: Unit,
    /// normal · viewer
    viewer: Unit,
    /// light · viewer
    between: Unit,
}

/// A highlight: the power of a cosine that says how near the viewer is to the mirror direction.
pub(crate) trait Highlight {
    /// Whether shapes throw shadows.
    const SHADOWS: bool = true;

    fn highlight(cosines: &Cosines, shininess: Exponent) -> Unit;
}

/// (h · n)ˢʰⁱⁿⁱⁿᵉˢˢ, where h is the unit vector half way between light and viewer. It is not built:
/// the square of its length is 2 + 2 l·v, and the square of the cosine a quotient, which is all
/// that an even shininess needs.
impl Highlight for BlinnPhong {
    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent) -> Unit {
        let square = half_way_square(cosines);
        if shininess.is_even() {
            even_power(square, shininess)
        } else {
            power(root_of_unit(square), shininess)
        }
    }
}

/// (r · v)ˢʰⁱⁿⁱⁿᵉˢˢ, where r is the light direction mirrored in the normal.
impl Highlight for Phong {
    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent) -> Unit {
        power(mirrored_cosine(cosines), shininess)
    }
}

/// (h · n)² = ((n·l + n·v) / 2)² / ((1 + l·v) / 2)
#[inline(always)]
fn half_way_square(cosines: &Cosines) -> Unit {
    let sum = (cosines.light.to_bits() as u32) + (cosines.viewer.to_bits() as u32);
    // Q30: (2 Q30)² / 4
    let numerator = high_unsigned(sum, sum);
    let denominator = (((1_u32 << 30) as i32).wrapping_add(cosines.between.to_bits()) as u32) >> 1;
    if numerator >= denominator {
        return Unit::ONE;
    }
    Unit::from_bits(ratio(numerator, denominator))
}

/// r · v = 2 (n·l) (n·v) - l·v
fn mirrored_cosine(cosines: &Cosines) -> Unit {
    let product = scaled_by_unit(cosines.light.to_bits(), cosines.viewer);
    let cosine = 2 * i64::from(product) - i64::from(cosines.between.to_bits());
    Unit::from_bits(cosine.clamp(0, 1 << 30) as i32)
}

/// ambient + Σ (diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ) · light, all times the material's colour.
#[inline(always)]
fn lit_color<W: World, H: Highlight>(
    world: &W,
    view: &View,
    surface: &Surface<'_>,
    trail: &mut Trail,
) -> Color {
    let material = surface.material;
    let mut lights = 0_u32;
    let mut received = Color::grey(material.ambient);
    let mut receive = |index: usize, spot: &W::Lamp| {
        let strength = match view.standing(index) {
            Standing::Hidden if H::SHADOWS => return,
            Standing::Clear if surface.place.is_near() => {
                clear_strength::<W, H>(world, surface, spot)
            }
            _ => strength::<W, H>(world, surface, spot.lamp()),
        };
        if strength > Brightness::ZERO {
            received = received.plus(spot.lamp().light.color.times(strength));
            lights |= 1_u32.wrapping_shl(index as u32);
        }
    };
    for_first_four(world.lamps(), &mut receive);
    for (index, spot) in world.lamps().iter().enumerate().skip(4) {
        receive(index, spot);
    }
    trail.note(lights);
    received.filtered(material.color)
}

/// What a near surface sends on of a light that stands clear; 0 where the light is behind it or
/// hidden.
#[inline(never)]
fn clear_strength<W: World, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    spot: &W::Lamp,
) -> Brightness {
    let way = surface.place.point.to(spot.lamp().light.place.point);
    let height = way.dot(surface.normal);
    if height <= 0 {
        return Brightness::ZERO;
    }
    let (direction, distance, cosine) = way.direction_length_and_share(height);
    let is_blocked = || {
        let towards = direction.reversed();
        blocked_from(world, spot, towards, distance, surface.cylinder)
    };
    if H::SHADOWS && is_blocked() {
        return Brightness::ZERO;
    }
    surface.sent_on::<H>(direction, cosine)
}

/// What a surface sends on of a light, wherever both are.
#[cold]
#[inline(never)]
fn strength<W: World, H: Highlight>(world: &W, surface: &Surface<'_>, lamp: &Lamp) -> Brightness {
    let (way, scale) = surface.place.to(lamp.light.place);
    let (direction, distance) = way.direction_and_length();
    let path = Path::new(surface.place, direction);
    let is_blocked = || blocked(world, &path, surface.shape, lamp, distance, scale);
    if surface.normal.dot(direction) <= Unit::ZERO || H::SHADOWS && is_blocked() {
        return Brightness::ZERO;
    }
    let cosine = surface.normal.short_dot(direction).max(Unit::ZERO);
    surface.sent_on::<H>(direction, cosine)
}

impl Surface<'_> {
    /// diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ, for a light in a direction above the surface, and its n·l.
    #[inline(always)]
    fn sent_on<H: Highlight>(&self, light: Direction, cosine: Unit) -> Brightness {
        let material = self.material;
        let strength = lit(cosine, material.diffuse);
        if material.specular == Brightness::ZERO {
            return strength;
        }
        let cosines = Cosines {
            light: cosine,
            viewer: self.facing,
            between: Unit::from_bits(-self.view.short_dot(light).to_bits()),
        };
        strength
            + lit(
                H::highlight(&cosines, material.shininess),
                material.specular,
            )
    }
}

#[cfg(test)]
mod leaving;
#[cfg(test)]
mod tests;
