//! The shading models: how the colour of a surface is found, and the shape of highlights.

mod cosines;

use core::marker::PhantomData;

pub(crate) use cosines::Cosines;

use super::smooth::{Glance, Samples, Turns, begins_sharply, may_begin, quarter, samples};
use super::{Lit, Visibility, lit_color, strength_of};
use crate::background::Beyond;
use crate::color::{Color, halved};
use crate::number::{Brightness, Exponent, Unit, even_power, power, root_of_unit, whole_power};
use crate::qualities::Quality;
use crate::scene::access::SceneAccess;
use crate::scene::{Shininess, Surface};
use crate::vector::{Direction, Vector};

/// A shading model. Choose one with [`crate::FrameBuilder::shading`].
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use reflet::scenes::{BuiltIn, Corner1};
/// use reflet::shading::{BlinnPhong, Normals, Phong, Shading, Unshadowed};
///
/// fn middle<K: Shading>() -> Rgb888 {
///     let frame = Corner1::frame(&Corner1::CAMERA).shading::<K>().prepare(Size::new(65, 65));
///     let mut pixel = [Rgb888::BLACK];
///     frame.on(&Corner1).unwrap().row(32, 32, &mut pixel);
///     pixel[0]
/// }
/// assert_ne!(middle::<Normals>(), middle::<BlinnPhong>());
/// assert!(middle::<Unshadowed<Phong>>().r() >= middle::<Phong>().r());
/// ```
pub trait Shading: sealed::Shading {}

impl<T: sealed::Shading> Shading for T {}

pub(crate) mod sealed {
    use super::super::smooth::{Glance, Samples, Turns};
    use super::super::{Lit, Visibility};
    use crate::background::Beyond;
    use crate::number::Exponent;
    use crate::qualities::Quality;
    use crate::scene::Surface;
    use crate::scene::access::SceneAccess;
    use crate::vector::Direction;

    pub trait Shading {
        /// Whether paths are reflected at mirrors.
        const REFLECTS: bool;

        /// Whether shapes cast shadows.
        const SHADOWS: bool;

        /// Power of two by which a highlight changes faster than the half-way vector.
        const TURNS: u32;

        /// Returns the colour of a surface without reflections, and the lights that shine on it.
        fn color<W: SceneAccess, Q: Quality, V: Visibility>(
            world: &W,
            surface: &Surface<'_>,
            visibility: &V,
        ) -> Lit;

        /// Tests whether a light shines on a surface. Defaults to `false`: a view of normals has no lights.
        fn shines<W: SceneAccess, Q: Quality, V: Visibility>(
            _world: &W,
            _surface: &Surface<'_>,
            _visibility: &V,
            _light: (&V::Light, usize),
        ) -> bool {
            false
        }

        /// Returns how many pixels show how the highlight of a light changes between two points of a surface.
        fn samples(ends: &[Glance; 2], turns: &Turns, shininess: Exponent) -> Samples;

        /// Returns what a ray in a direction shows that hits nothing.
        fn missed<W: SceneAccess>(world: &W, direction: Direction) -> Beyond;
    }
}

/// Blinn-Phong shading, the default: highlights by the half-way vector (Blinn, "Models of Light
/// Reflection for Computer Synthesized Pictures", SIGGRAPH 1977).
#[derive(Clone, Copy, Debug)]
pub struct BlinnPhong;

/// Phong shading: highlights by the mirrored light direction (Phong, "Illumination for Computer
/// Generated Pictures", CACM 18(6), 1975).
#[derive(Clone, Copy, Debug)]
pub struct Phong;

/// View of normals: the first surface's normal as the colour (n + 1) / 2, and blue where nothing is
/// hit.
#[derive(Clone, Copy, Debug)]
pub struct Normals;

/// Shading by `K`, [`BlinnPhong`] or [`Phong`], without shadows: a light shines on every surface that
/// faces it, even if a shape lies between them.
///
/// `xtask/report` shows what a scene costs without its shadows, and what is lost.
#[derive(Clone, Copy, Debug)]
pub struct Unshadowed<K = BlinnPhong>(PhantomData<K>);

impl<K: Highlight> Highlight for Unshadowed<K> {
    const SHADOWS: bool = false;
    const TURNS: u32 = K::TURNS;

    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit {
        K::highlight(cosines, shininess, kind)
    }

    fn deviation(glance: &Glance) -> Vector {
        K::deviation(glance)
    }

    fn width(glance: &Glance) -> Unit {
        K::width(glance)
    }
}

impl<H: Highlight> sealed::Shading for H {
    const REFLECTS: bool = true;
    const SHADOWS: bool = <H as Highlight>::SHADOWS;
    const TURNS: u32 = <H as Highlight>::TURNS;

    #[inline(always)]
    fn color<W: SceneAccess, Q: Quality, V: Visibility>(
        world: &W,
        surface: &Surface<'_>,
        visibility: &V,
    ) -> Lit {
        if Q::IS_PRECISE {
            lit_color::<W, V, Self, true>(world, surface, visibility)
        } else {
            lit_color::<W, V, Self, false>(world, surface, visibility)
        }
    }

    #[inline(always)]
    fn shines<W: SceneAccess, Q: Quality, V: Visibility>(
        world: &W,
        surface: &Surface<'_>,
        visibility: &V,
        light: (&V::Light, usize),
    ) -> bool {
        let strength = if Q::IS_PRECISE {
            strength_of::<W, V, Self, true>(world, surface, visibility, light)
        } else {
            strength_of::<W, V, Self, false>(world, surface, visibility, light)
        };
        strength > Brightness::ZERO
    }

    fn samples(ends: &[Glance; 2], turns: &Turns, shininess: Exponent) -> Samples {
        let [one, other] = ends.each_ref().map(H::width);
        let Some(bend) = turns.bend(one.min(other)) else {
            return Samples::All;
        };
        let (ends, bend) = (ends.each_ref().map(H::deviation), bend << (2 * Self::TURNS));
        if begins_sharply::<H>(shininess) && may_begin(ends, bend) {
            Samples::All
        } else {
            samples(ends, bend, shininess)
        }
    }

    #[inline(always)]
    fn missed<W: SceneAccess>(world: &W, direction: Direction) -> Beyond {
        world.parts().beyond(direction, W::NEEDS.sky)
    }
}

impl sealed::Shading for Normals {
    const REFLECTS: bool = false;
    const SHADOWS: bool = false;
    const TURNS: u32 = 0;

    fn color<W: SceneAccess, Q: Quality, V: Visibility>(
        _: &W,
        surface: &Surface<'_>,
        _: &V,
    ) -> Lit {
        Lit {
            color: Color::new(surface.normal.components().map(halved)).in_levels(),
            lights: 0,
            cell: None,
        }
    }

    fn samples(_: &[Glance; 2], _: &Turns, _: Exponent) -> Samples {
        Samples::Three
    }

    fn missed<W: SceneAccess>(_: &W, _: Direction) -> Beyond {
        let color = Color::new([Brightness::ZERO, Brightness::ZERO, Brightness::ONE]);
        Beyond::of_one_color(color.in_levels())
    }
}

/// A highlight: the power of a cosine that says how near the viewer is to the mirrored light.
pub(crate) trait Highlight {
    /// Whether shapes cast shadows in this shading.
    const SHADOWS: bool = true;

    /// Power of two by which the highlight changes faster than the half-way vector.
    const TURNS: u32 = 0;

    /// Returns the strength of a highlight, 0 to 1. `kind` says which powers occur in the scene.
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit;

    /// Returns the difference of the two unit vectors whose cosine is raised to a power, in Q4.28.
    fn deviation(glance: &Glance) -> Vector;

    /// Returns the squared length of half the sum of the directions to light and viewer if the highlight depends on the
    /// direction of that sum; otherwise 1.
    fn width(_: &Glance) -> Unit {
        Unit::ONE
    }
}

/// The highlight (h · n)ˢʰⁱⁿⁱⁿᵉˢˢ, where h is the unit vector half way between light and viewer.
///
/// h is not computed. The square of the length of light + viewer is 2 + 2 l·v, so (h · n)² is a
/// quotient. An even shininess needs only this square.
impl Highlight for BlinnPhong {
    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit {
        let square = cosines.half_way_square();
        if kind <= Shininess::Even || shininess.is_even() {
            even_power(square, shininess)
        } else {
            power_of(root_of_unit(square), shininess, kind)
        }
    }

    fn deviation(glance: &Glance) -> Vector {
        glance.half_way().minus(quarter(glance.normal))
    }

    fn width(glance: &Glance) -> Unit {
        glance.half_square()
    }
}

/// The highlight (r · v)ˢʰⁱⁿⁱⁿᵉˢˢ, where r is the light direction mirrored in the normal.
impl Highlight for Phong {
    const TURNS: u32 = 1;

    #[inline(always)]
    fn highlight(cosines: &Cosines, shininess: Exponent, kind: Shininess) -> Unit {
        let cosine = cosines.mirrored();
        // If the mirrored light points away from the viewer, there is no highlight, not even for
        // shininess 0.
        if cosine == Unit::ZERO {
            return cosine;
        }
        power_of(cosine, shininess, kind)
    }

    fn deviation(glance: &Glance) -> Vector {
        // The light's direction is that from the light to the surface, mirrored it leaves the surface.
        let cosine = glance.along.dot(glance.normal);
        let mirrored = glance.along.reflected(glance.normal, cosine);
        quarter(mirrored).plus(quarter(glance.view))
    }
}

/// Returns `base` to the power `shininess`. `kind` says which powers occur in the scene.
#[inline(always)]
fn power_of(base: Unit, shininess: Exponent, kind: Shininess) -> Unit {
    match kind {
        Shininess::Real => power(base, shininess),
        _ => whole_power(base, shininess),
    }
}

#[cfg(test)]
mod tests;
