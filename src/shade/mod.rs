//! Floor 4: the light at one hit: ambient, diffuse, specular. Knows no reflection, and not how a light
//! is found to be visible.

pub(crate) mod highlight;

pub use highlight::{BlinnPhong, Normals, Phong, Shading, Unshadowed};

use highlight::{Cosines, Highlight};

use crate::color::{Color, Lighting};
use crate::light::PreparedLight;
use crate::number::{Brightness, Length, Unit, bit_modulo_32, lit};
use crate::ray::{ScaledPoint, ScaledRay};
use crate::scene::Surface;
use crate::scene::access::SceneAccess;
use crate::scene::planes::for_first_four;
use crate::vector::Direction;

/// How exactly light is computed.
pub trait LightQuality {
    /// Whether light is kept to 2⁻²⁶ of white, and shadows are told exactly where shapes touch.
    const IS_PRECISE: bool;
}

/// The answer whether a light is visible from a surface.
pub trait Visibility {
    /// A light, with what is known about it.
    type Light;

    /// The lights.
    fn lights(&self) -> &[Self::Light];

    /// The light itself.
    fn light(light: &Self::Light) -> &PreparedLight;

    /// Whether the light with a number is hidden from all that the camera or a mirror shows.
    fn is_hidden(&self, index: usize) -> bool;

    /// Whether [`Visibility::is_occluded_from`] can tell if the light with a number is occluded.
    fn is_clear(&self, index: usize) -> bool;

    /// Whether a shape lies between such a light and a near surface; `direction` and `distance` lead from
    /// the light to the surface.
    fn is_occluded_from<const PRECISE: bool>(
        &self,
        surface: &Surface<'_>,
        light: (&Self::Light, usize),
        ray: (Direction, Length),
    ) -> bool;

    /// Whether anything lies between a surface and the light with a number, which stands at a point, so
    /// far away in steps of 2ˢᶜᵃˡᵉ. The ray leads to the light.
    fn is_occluded(
        &self,
        surface: &Surface<'_>,
        ray: &ScaledRay,
        index: usize,
        light: (ScaledPoint, Length, u32),
    ) -> bool;
}

/// The colour of a surface without reflections.
pub struct Lit {
    pub(crate) color: Color,
    /// A bit for each light that shines on it, of 32; one of them may be two lights.
    pub(crate) lights: u32,
}

/// ambient + Σ (diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ) · light, all times the material's colour.
#[inline(always)]
fn lit_color<W: SceneAccess, Q: LightQuality, V: Visibility, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
) -> Lit {
    match Q::IS_PRECISE {
        true => lit_color_by::<W, V, H, true>(world, surface, visibility),
        false => lit_color_by::<W, V, H, false>(world, surface, visibility),
    }
}

#[inline(always)]
fn lit_color_by<W: SceneAccess, V: Visibility, H: Highlight, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
) -> Lit {
    let material = surface.material(world);
    let mut received = Received {
        light: Lighting::<PRECISE>::grey(material.ambient),
        lights: 0,
    };
    for_first_four(visibility.lights(), |index, light| {
        received.ask::<W, V, H>(world, surface, visibility, (light, index));
    });
    for (index, light) in visibility.lights().iter().enumerate().skip(4) {
        received.ask::<W, V, H>(world, surface, visibility, (light, index));
    }
    let color = received.light.filtered(material.color);
    Lit {
        color: match W::NEEDS.colors {
            true => color,
            // Of the three channels, the compiler keeps one.
            false => Color::grey(color.components()[0]),
        },
        lights: received.lights,
    }
}

/// The light that comes to a surface and is sent on.
struct Received<const PRECISE: bool> {
    light: Lighting<PRECISE>,
    /// [`Lit::lights`]
    lights: u32,
}

impl<const PRECISE: bool> Received<PRECISE> {
    /// Adds what is sent on of a light.
    #[inline(always)]
    fn ask<W: SceneAccess, V: Visibility, H: Highlight>(
        &mut self,
        world: &W,
        surface: &Surface<'_>,
        visibility: &V,
        (light, index): (&V::Light, usize),
    ) {
        let strength = if visibility.is_clear(index) && surface.place.is_near() {
            near_strength::<W, V, H, PRECISE>(world, surface, visibility, (light, index))
        } else if H::SHADOWS && visibility.is_hidden(index) {
            return;
        } else {
            strength::<W, V, H>(world, surface, visibility, (light, index))
        };
        if strength > Brightness::ZERO {
            self.light.add(V::light(light).color, strength);
            self.lights |= bit_modulo_32(index);
        }
    }
}

/// What a near surface sends on of a clear light; 0 where the light is behind it or occluded.
#[inline(never)]
fn near_strength<W: SceneAccess, V: Visibility, H: Highlight, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
    (light, index): (&V::Light, usize),
) -> Brightness {
    let way = surface.place.point.to(V::light(light).place.point);
    let height = way.dot(surface.normal);
    if height <= 0 {
        return Brightness::ZERO;
    }
    let (direction, distance, cosine) = way.direction_length_and_share(height);
    let back = direction.reversed();
    if W::NEEDS.shadows
        && H::SHADOWS
        && visibility.is_occluded_from::<PRECISE>(surface, (light, index), (back, distance))
    {
        return Brightness::ZERO;
    }
    sent_on::<W, H>(world, surface, back, cosine)
}

/// What a surface sends on of a light, wherever both are; rarely asked.
#[cold]
#[inline(never)]
fn strength<W: SceneAccess, V: Visibility, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
    (light, index): (&V::Light, usize),
) -> Brightness {
    let place = V::light(light).place;
    let (way, scale) = surface.place.to(place);
    let (direction, distance) = way.direction_and_length();
    if surface.normal.dot(direction) <= Unit::ZERO {
        return Brightness::ZERO;
    }
    let ray = ScaledRay::new(surface.place, direction);
    let light = (place, distance, scale);
    if W::NEEDS.shadows && H::SHADOWS && visibility.is_occluded(surface, &ray, index, light) {
        return Brightness::ZERO;
    }
    let cosine = surface.normal.short_dot(direction).max(Unit::ZERO);
    sent_on::<W, H>(world, surface, direction.reversed(), cosine)
}

/// diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ, for light that comes along a direction from above the surface,
/// and its n·l.
#[inline(always)]
fn sent_on<W: SceneAccess, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    along: Direction,
    cosine: Unit,
) -> Brightness {
    let material = surface.material(world);
    let strength = lit(cosine, material.diffuse);
    if !W::NEEDS.highlights || material.specular == Brightness::ZERO {
        return strength;
    }
    let cosines = Cosines {
        light: cosine,
        viewer: surface.facing,
        between: surface.view.short_dot(along),
    };
    let highlight = H::highlight(&cosines, material.shininess, W::NEEDS.shininess);
    strength + lit(highlight, material.specular)
}
