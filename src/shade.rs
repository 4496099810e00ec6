//! Floor 4: the light at one hit: ambient, diffuse, specular, and the question whether a light is
//! hidden. Knows no reflection.

use core::marker::PhantomData;

use crate::color::{Color, Lighting, halved};
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{
    Brightness, Exponent, Length, Unit, absolute, bit_modulo_32, even_power, high_unsigned, lit,
    narrowed, offset_modulo_2_32, power, ratio, root_of_unit, scaled_by_unit, unsigned,
    whole_power,
};
use crate::quality::Quality;
use crate::ray::{PathSignature, ScaledPoint, ScaledRay};
use crate::scene::far;
use crate::scene::query::{Shape, ShapeId, blocked, blocked_from, for_first_four};
use crate::scene::view::{LightVisibility, Visible};
use crate::scene::{Occluders, Shininess, World};
use crate::vector::Direction;

/// A point on a surface, seen along a ray, from which rays may leave.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    /// Where rays leave: epsilon above the surface, on the side of the viewer.
    pub(crate) place: ScaledPoint,
    /// The normal on the side of the viewer.
    pub(crate) normal: Direction,
    /// The direction the surface was seen along.
    pub(crate) view: Direction,
    /// The cosine between the normal and the way back to the viewer, 0 to 1.
    pub(crate) facing: Unit,
    /// The shape it belongs to.
    pub(crate) shape: ShapeId,
    /// Whether it is seen from the inside, or against a plane's normal.
    pub(crate) is_inside: bool,
    material: &'a PreparedMaterial,
}

/// How far the cosine at a curved surface may be wrong: 2⁻¹⁶.
const RIM: Unit = Unit::from_bits(1 << 14);

impl<'a> Surface<'a> {
    /// The surface of a shape at a place that was seen along `view`; `None` where there is no such
    /// shape.
    #[inline(always)]
    pub(crate) fn new<W: World>(
        world: &'a W,
        at: ScaledPoint,
        shape: ShapeId,
        view: Direction,
    ) -> Option<Self> {
        let parts = world.parts();
        let (outward, material) = match parts.shape(shape)? {
            Shape::Sphere(sphere) => (sphere.normal(at.point), sphere.material),
            Shape::Cylinder(cylinder) => (cylinder.normal(at.point), cylinder.material),
            Shape::Plane(plane) => (plane.normal, plane.material),
        };
        let climb = view.short_dot(outward);
        // At the rim of a shape rounding must not turn its outside into its inside.
        let (is_inside, epsilon) = match parts.is_plane(shape) {
            true => (climb > Unit::ZERO, parts.epsilon),
            false if climb > RIM => (true, parts.inner_epsilon),
            false => (false, parts.epsilon),
        };
        let normal = outward.reversed_if(is_inside);
        Some(Self {
            place: at.lifted(normal, epsilon),
            normal,
            view,
            // Within ±1.0001.
            facing: Unit::from_bits(absolute(climb.to_bits())),
            shape,
            is_inside,
            material: parts.material(material),
        })
    }

    /// What it is made of: a constant in a constant scene of one material.
    #[inline(always)]
    pub(crate) fn material<W: World>(&self, world: &'a W) -> &'a PreparedMaterial {
        match world.parts().materials {
            [only] => only,
            _ => self.material,
        }
    }

    /// The shape, unless it may be met again by a ray that leaves it here: from inside of a sphere or
    /// cylinder.
    #[inline(always)]
    pub(crate) fn left<W: World>(&self, world: &W) -> ShapeId {
        match self.is_inside && !world.parts().is_plane(self.shape) {
            true => ShapeId::NONE,
            false => self.shape,
        }
    }

    /// Turns a path that met the surface into the mirrored one.
    #[inline(never)]
    pub(crate) fn reflect<W: World>(&self, world: &W, path: &mut ScaledRay) {
        let cosine = Unit::from_bits(-self.facing.to_bits());
        let direction = self.view.reflected(self.normal, cosine);
        // A curved surface's normal has a length of one but for 2⁻¹⁶, or 2⁻¹⁴ far away; four times as
        // much is what the direction's is off by.
        let direction = match world.parts().is_plane(self.shape) {
            true => direction,
            false => direction.renormalised(),
        };
        *path = ScaledRay::new(self.place, direction);
    }
}

/// How the colour of a surface is found. Choose with [`crate::Frame::shading`].
pub trait Shading: sealed::Shading {}

impl<T: sealed::Shading> Shading for T {}

pub(crate) mod sealed {
    use super::{Color, LightVisibility, PathSignature, Quality, Surface, World};

    pub trait Shading {
        /// Whether mirrors are followed.
        const REFLECTS: bool;

        /// The colour of a surface without reflections; notes which lights it is lit by.
        #[allow(private_interfaces)]
        fn color<W: World, Q: Quality>(
            world: &W,
            view: &LightVisibility,
            surface: &Surface<'_>,
            signature: &mut PathSignature,
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
/// What a scene takes without its shadows, and what it loses, `xtask/report` shows.
#[derive(Clone, Copy, Debug)]
pub struct Unshadowed<K = BlinnPhong>(PhantomData<K>);

impl<K: Highlight> Highlight for Unshadowed<K> {
    const SHADOWS: bool = false;

    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit {
        K::highlight(cosines, shininess, kind)
    }
}

impl<H: Highlight> sealed::Shading for H {
    const REFLECTS: bool = true;

    #[allow(private_interfaces)]
    #[inline(always)]
    fn color<W: World, Q: Quality>(
        world: &W,
        view: &LightVisibility,
        surface: &Surface<'_>,
        signature: &mut PathSignature,
    ) -> Color {
        lit_color::<W, Q, Self>(world, view, surface, signature)
    }

    fn missed<W: World>(world: &W) -> Color {
        world.parts().background
    }
}

impl sealed::Shading for Normals {
    const REFLECTS: bool = false;

    #[allow(private_interfaces)]
    fn color<W: World, Q: Quality>(
        _: &W,
        _: &LightVisibility,
        surface: &Surface<'_>,
        _: &mut PathSignature,
    ) -> Color {
        Color::new(surface.normal.components().map(halved)).in_levels()
    }

    fn missed<W: World>(_: &W) -> Color {
        Color::new([Brightness::ZERO, Brightness::ZERO, Brightness::ONE]).in_levels()
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

    /// For a shininess of a kind that may occur in the scene.
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit;
}

/// (h · n)ˢʰⁱⁿⁱⁿᵉˢˢ, where h is the unit vector half way between light and viewer. It is not built:
/// the square of its length is 2 + 2 l·v, and the square of the cosine a quotient, which is all
/// that an even shininess needs.
impl Highlight for BlinnPhong {
    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit {
        let square = half_way_square(cosines);
        if kind <= Shininess::Even || shininess.is_even() {
            even_power(square, shininess)
        } else {
            power_of(root_of_unit(square), shininess, kind)
        }
    }
}

/// (r · v)ˢʰⁱⁿⁱⁿᵉˢˢ, where r is the light direction mirrored in the normal.
impl Highlight for Phong {
    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit {
        let cosine = mirrored_cosine(cosines);
        // Where the mirrored light points away from the viewer there is no highlight, not even one of
        // shininess 0.
        if cosine == Unit::ZERO {
            return cosine;
        }
        power_of(cosine, shininess, kind)
    }
}

/// A power of a kind that may occur in the scene.
#[inline(always)]
fn power_of(base: Unit, shininess: Exponent, kind: Shininess) -> Unit {
    match kind {
        Shininess::Real => power(base, shininess),
        _ => whole_power(base, shininess),
    }
}

/// (h · n)² = ((n·l + n·v) / 2)² / ((1 + l·v) / 2)
#[inline(always)]
fn half_way_square(cosines: &Cosines) -> Unit {
    let sum = unsigned(cosines.light.to_bits()) + unsigned(cosines.viewer.to_bits());
    // Q30: (2 Q30)² / 4
    let numerator = high_unsigned(sum, sum);
    // 1 + l·v is 0 to 2 but for a last place: below zero, as one without a sign, it is a large one.
    let denominator = offset_modulo_2_32(cosines.between.to_bits(), 1 << 30) >> 1;
    if numerator >= denominator {
        return Unit::ONE;
    }
    Unit::from_bits(ratio(numerator, denominator))
}

/// r · v = 2 (n·l) (n·v) - l·v
fn mirrored_cosine(cosines: &Cosines) -> Unit {
    let product = scaled_by_unit(cosines.light.to_bits(), cosines.viewer);
    let cosine = 2 * i64::from(product) - i64::from(cosines.between.to_bits());
    Unit::from_bits(narrowed(cosine.clamp(0, 1 << 30)))
}

/// ambient + Σ (diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ) · light, all times the material's colour.
#[inline(always)]
fn lit_color<W: World, Q: Quality, H: Highlight>(
    world: &W,
    view: &LightVisibility,
    surface: &Surface<'_>,
    signature: &mut PathSignature,
) -> Color {
    match Q::IS_PRECISE {
        true => lit_color_by::<W, Q, H, true>(world, view, surface, signature),
        false => lit_color_by::<W, Q, H, false>(world, view, surface, signature),
    }
}

#[inline(always)]
fn lit_color_by<W: World, Q: Quality, H: Highlight, const PRECISE: bool>(
    world: &W,
    view: &LightVisibility,
    surface: &Surface<'_>,
    signature: &mut PathSignature,
) -> Color {
    let material = surface.material(world);
    let mut received = Received {
        light: Lighting::<PRECISE>::grey(material.ambient),
        lights: 0,
    };
    if Q::IS_SMALL {
        for (index, light) in world.parts().lights.iter().enumerate() {
            let strength = general_strength::<W, Q, H>(world, surface, (light, index));
            received.add(index, light, strength);
        }
    } else {
        for_first_four(world.lamps(), |index, lamp| {
            received.ask::<W, Q, H>(world, view, surface, (lamp, index));
        });
        for (index, lamp) in world.lamps().iter().enumerate().skip(4) {
            received.ask::<W, Q, H>(world, view, surface, (lamp, index));
        }
    }
    if !Q::IS_SMALL {
        signature.note(received.lights);
    }
    let color = received.light.filtered(material.color);
    match W::NEEDS.colors {
        true => color,
        // Of the three channels, the compiler keeps one.
        false => Color::grey(color.components()[0]),
    }
}

/// The light that comes to a surface and is sent on.
struct Received<const PRECISE: bool> {
    light: Lighting<PRECISE>,
    /// A bit for each light that is not hidden.
    lights: u32,
}

impl<const PRECISE: bool> Received<PRECISE> {
    #[inline(always)]
    fn add(&mut self, index: usize, light: &PreparedLight, strength: Brightness) {
        if strength > Brightness::ZERO {
            self.light.add(light.color, strength);
            // Which of 32 lights; a signature may take two for one.
            self.lights |= bit_modulo_32(index);
        }
    }

    /// Adds what is sent on of a light.
    #[inline(always)]
    fn ask<W: World, Q: Quality, H: Highlight>(
        &mut self,
        world: &W,
        view: &LightVisibility,
        surface: &Surface<'_>,
        (lamp, index): (&W::LightOccluders, usize),
    ) {
        let light = lamp.light();
        let strength = match view.standing(index) {
            Visible::Hidden if H::SHADOWS => return,
            Visible::Clear if surface.place.is_near() => {
                clear_strength::<W, H, PRECISE>(world, surface, (lamp, index))
            }
            _ => strength::<W, Q, H>(world, surface, (light, index)),
        };
        self.add(index, light, strength);
    }
}

/// What a near surface sends on of a light that stands clear; 0 where the light is behind it or
/// hidden.
#[inline(never)]
fn clear_strength<W: World, H: Highlight, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    (lamp, index): (&W::LightOccluders, usize),
) -> Brightness {
    let way = surface.place.point.to(lamp.light().place.point);
    let height = way.dot(surface.normal);
    if height <= 0 {
        return Brightness::ZERO;
    }
    let (direction, distance, cosine) = way.direction_length_and_share(height);
    let back = direction.reversed();
    if W::NEEDS.shadows
        && H::SHADOWS
        && is_hidden::<W, PRECISE>(world, surface, (lamp, index), back, distance)
    {
        return Brightness::ZERO;
    }
    surface.sent_on::<W, H>(world, back, cosine)
}

/// Shadow test for a near surface and a light that no plane hides: whether a sphere or cylinder
/// occludes the light. `direction` and `distance` lead from the light to the surface.
///
/// Where `PRECISE`, a point that epsilon lifts into a sphere is in its shadow. A shape does not occlude
/// a point on its own surface: hits are known to a few steps, so the shadow ray ends that much earlier.
#[inline(always)]
fn is_hidden<W: World, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    light: (&W::LightOccluders, usize),
    direction: Direction,
    distance: Length,
) -> bool {
    let reach = match PRECISE {
        true => distance.surely_less(),
        false => distance,
    };
    blocked_from(
        world,
        light,
        (direction, reach),
        |cylinder| cylinder == surface.shape && !surface.is_inside,
        |number, sphere, seen| {
            seen.is_before(direction, reach)
                || PRECISE
                    && seen.may_hold_the_end(sphere.ball().1, reach)
                    && number != surface.shape
                    && sphere.holds_lifted(surface.place.point)
        },
    )
}

/// What a surface sends on of a light, wherever both are; rarely asked.
#[cold]
#[inline(never)]
fn strength<W: World, Q: Quality, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    light: (&PreparedLight, usize),
) -> Brightness {
    general_strength::<W, Q, H>(world, surface, light)
}

/// What a surface sends on of a light, wherever both are.
#[inline(always)]
fn general_strength<W: World, Q: Quality, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    (light, index): (&PreparedLight, usize),
) -> Brightness {
    let (way, scale) = surface.place.to(light.place);
    let (direction, distance) = way.direction_and_length();
    let path = ScaledRay::new(surface.place, direction);
    if surface.normal.dot(direction) <= Unit::ZERO {
        return Brightness::ZERO;
    }
    let is_blocked = if !(W::NEEDS.shadows && H::SHADOWS) {
        false
    } else if Q::IS_SMALL {
        far::ends_before(world, &path, surface.left(world), light.place)
    } else {
        let cells = match W::NEEDS.sets {
            true => world.cells().get(index),
            false => None,
        };
        let light = (light.place, cells);
        blocked(world, &path, surface.left(world), light, distance, scale)
    };
    if is_blocked {
        return Brightness::ZERO;
    }
    let cosine = surface.normal.short_dot(direction).max(Unit::ZERO);
    surface.sent_on::<W, H>(world, direction.reversed(), cosine)
}

impl Surface<'_> {
    /// diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ, for light that comes along a direction from above the surface,
    /// and its n·l.
    #[inline(always)]
    fn sent_on<W: World, H: Highlight>(
        &self,
        world: &W,
        along: Direction,
        cosine: Unit,
    ) -> Brightness {
        let material = self.material(world);
        let strength = lit(cosine, material.diffuse);
        if !W::NEEDS.highlights || material.specular == Brightness::ZERO {
            return strength;
        }
        let cosines = Cosines {
            light: cosine,
            viewer: self.facing,
            between: self.view.short_dot(along),
        };
        let highlight = H::highlight(&cosines, material.shininess, W::NEEDS.shininess);
        strength + lit(highlight, material.specular)
    }
}

#[cfg(test)]
mod inside;
#[cfg(test)]
mod leaving;
#[cfg(test)]
mod tests;
