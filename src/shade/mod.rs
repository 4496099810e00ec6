//! Floor 4: the light at one hit: ambient, diffuse, specular. It knows no reflection, and not how the
//! visibility of a light is found.

pub(crate) mod highlight;
mod smooth;
mod visibility;

pub(crate) use smooth::{Glance, Samples, Turns, begins_sharply, is_little};

pub use highlight::{BlinnPhong, Normals, Phong, Shading, Unshadowed};
pub use visibility::Visibility;

use highlight::{Cosines, Highlight};

use crate::color::{Color, Lighting};
use crate::light::PreparedLight;
use crate::number::{Brightness, Length, Unit, bit_modulo_32, lit};
use crate::ray::{REACH, ScaledPoint, ScaledRay};
use crate::scene::Surface;
use crate::scene::access::SceneAccess;
use crate::scene::planes::for_first_four;
use crate::vector::Direction;

/// The colour of a surface without reflections, and the lights that shine on it.
pub struct Lit {
    pub(crate) color: Color,
    /// One bit for each light that shines on the surface, of 32. With more lights, two may share a bit.
    pub(crate) lights: u32,
    /// If the material has a checker: whether the surface lies in a cell of the checker's colour, and the colour that it
    /// would have in a cell of the other kind.
    pub(crate) cell: Option<(bool, Color)>,
}

/// Returns the light that a surface sends to the viewer: (ambient + Σ (diffuse n·l + specular
/// sˢʰⁱⁿⁱⁿᵉˢˢ) · light) · colour of the material. The sum is over all visible lights. `PRECISE` is
/// [`Quality::IS_PRECISE`](crate::quality::Quality::IS_PRECISE).
#[inline(always)]
fn lit_color<W: SceneAccess, V: Visibility, H: Highlight, const PRECISE: bool>(
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
    let shown = |color| {
        let filtered = received.light.filtered(color);
        // Without colours, the compiler computes one of the three channels.
        if W::NEEDS.colors { filtered } else { Color::grey(filtered.components()[0]) }
    };
    let (color, cell) = match surface.cell(world) {
        Some((true, color)) => (color, Some((true, material.color))),
        cell => (material.color, cell),
    };
    Lit {
        color: shown(color),
        lights: received.lights,
        cell: cell.map(|(holds, other)| (holds, shown(other))),
    }
}

/// The light that a surface receives and sends on to the viewer, without the colour of its material.
struct Received<const PRECISE: bool> {
    light: Lighting<PRECISE>,
    /// One bit for each light that shines on the surface, as in [`Lit::lights`].
    lights: u32,
}

impl<const PRECISE: bool> Received<PRECISE> {
    /// Adds the light that a surface sends on from one light. Adds nothing if the light is hidden.
    #[inline(always)]
    fn ask<W: SceneAccess, V: Visibility, H: Highlight>(
        &mut self,
        world: &W,
        surface: &Surface<'_>,
        visibility: &V,
        (light, index): (&V::Light, usize),
    ) {
        let strength = strength_of::<W, V, H, PRECISE>(world, surface, visibility, (light, index));
        if strength > Brightness::ZERO {
            self.light.add(V::light(light).color, strength);
            self.lights |= bit_modulo_32(index);
        }
    }
}

/// Returns how much of a light a surface sends to the viewer. Returns 0 if the light is behind the surface or hidden.
#[inline(always)]
fn strength_of<W: SceneAccess, V: Visibility, H: Highlight, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
    (light, index): (&V::Light, usize),
) -> Brightness {
    if !V::IS_KNOWN {
        strength::<W, V, H>(world, surface, visibility, (light, index))
    } else if W::NEEDS.near_lights && visibility.is_clear(index) && surface.place.is_near() {
        near_strength::<W, V, H, PRECISE>(world, surface, visibility, (light, index))
    } else if H::SHADOWS && visibility.is_hidden(index) {
        Brightness::ZERO
    } else if W::NEEDS.far_lights
        && visibility.is_open(index)
        && !V::light(light).place.is_near()
        && surface.place.is_near()
    {
        far_strength::<W, V, H>(world, surface, visibility, light)
    } else {
        strength::<W, V, H>(world, surface, visibility, (light, index))
    }
}

/// Returns how much of a clear light a near surface sends to the viewer. Returns 0 if the light is
/// behind the surface or occluded.
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
    let sent = sent_on::<W, H>(world, surface, back, cosine);
    weakened::<W>(V::light(light), sent, (distance, 0))
}

/// Returns how much of an open far light a near surface sends to the viewer. Returns 0 if the light is
/// behind the surface or occluded. All bounded shapes that a ray meets lie before the light.
#[inline(never)]
fn far_strength<W: SceneAccess, V: Visibility, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
    light: &V::Light,
) -> Brightness {
    let light = V::light(light);
    let ScaledPoint { point, scale } = light.place;
    let (direction, distance) = match light.sun() {
        Some(direction) => (direction, REACH),
        None => {
            let way = surface.place.point.coarser(scale.min(31)).to(point);
            way.direction_and_length()
        }
    };
    if surface.normal.dot(direction) <= Unit::ZERO {
        return Brightness::ZERO;
    }
    if W::NEEDS.shadows && H::SHADOWS && visibility.is_occluded_ahead(surface, direction) {
        return Brightness::ZERO;
    }
    let cosine = surface.normal.short_dot(direction).max(Unit::ZERO);
    let sent = sent_on::<W, H>(world, surface, direction.reversed(), cosine);
    weakened::<W>(light, sent, (distance, scale))
}

/// Returns how much of a light a surface sends to the viewer, wherever both are. Returns 0 if the light is behind the
/// surface or occluded.
#[inline(never)]
fn strength<W: SceneAccess, V: Visibility, H: Highlight>(
    world: &W,
    surface: &Surface<'_>,
    visibility: &V,
    (light, index): (&V::Light, usize),
) -> Brightness {
    let place = V::light(light).place;
    // A scene without far lights links no code for suns.
    let sun = V::light(light).sun().filter(|_| W::NEEDS.far_lights);
    let (direction, distance, scale) = match sun {
        Some(direction) => (direction, REACH, place.scale),
        None => {
            let (way, scale) = surface.place.to(place);
            let (direction, distance) = way.direction_and_length();
            (direction, distance, scale)
        }
    };
    if surface.normal.dot(direction) <= Unit::ZERO {
        return Brightness::ZERO;
    }
    let ray = ScaledRay::new(surface.place, direction);
    let way = (place, distance, scale);
    if W::NEEDS.shadows && H::SHADOWS && visibility.is_occluded(surface, &ray, index, way) {
        return Brightness::ZERO;
    }
    let cosine = surface.normal.short_dot(direction).max(Unit::ZERO);
    let sent = sent_on::<W, H>(world, surface, direction.reversed(), cosine);
    weakened::<W>(V::light(light), sent, (distance, scale))
}

/// Returns `sent` as [`PreparedLight::weakened`] does, for a light at a distance in steps of 2^`scale`. A scene without
/// lights that fall off links no code for it.
#[inline(always)]
fn weakened<W: SceneAccess>(
    light: &PreparedLight,
    sent: Brightness,
    (distance, scale): (Length, u32),
) -> Brightness {
    if W::NEEDS.ranges { light.weakened(sent, distance, scale) } else { sent }
}

/// Returns diffuse n·l + specular sˢʰⁱⁿⁱⁿᵉˢˢ for light that arrives above the surface along a
/// direction. `cosine` is n·l.
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
