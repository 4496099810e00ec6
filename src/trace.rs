//! Floor 6: one ray to one colour: the accumulation over reflections, its weight and its stop.
//!
//! c = Σᵢ (1 - αᵢ) (Π over k < i of αₖ) cᵢ, in a loop: the weight Π αₖ is carried along, and the
//! path ends where it is spent, where nothing is met, or after the last reflection.

use crate::color::Sum;
use crate::number::{Unit, unit_product};
use crate::quality::Quality;
use crate::ray::Path;
use crate::scene::World;
use crate::scene::mask::Mask;
use crate::scene::query::nearest;
use crate::scene::sight::Sight;
use crate::shade::{Surface, sealed::Shading};

/// The colour of one path and what is known about it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Traced {
    pub(crate) sum: Sum,
    /// How many rays were followed, those to the lights apart.
    pub(crate) rays: u32,
    /// The weight with which the path would have gone on.
    pub(crate) cut_off: Unit,
}

/// Follows a path for at most `reflections` reflections.
#[inline(never)]
pub(crate) fn trace<'a, W: World, K: Shading, Q: Quality>(
    world: &'a W,
    sight: &mut Sight<'a>,
    column: u32,
    mut path: Path,
    reflections: u8,
) -> Traced {
    let mut sum = Sum::ZERO;
    let mut weight = Unit::ONE;
    let mut left = None;
    let mut rays = 0;
    loop {
        rays += 1;
        let mask = match (rays, left) {
            (1, _) => sight.first(column),
            (2, Some(plane)) => sight.mirrored(world, plane, column),
            _ => Mask::ALL,
        };
        let Some(hit) = nearest(world, mask, &path, left) else {
            sum.add(weight, K::missed(world));
            return Traced {
                sum,
                rays,
                cut_off: Unit::ZERO,
            };
        };
        let surface = Surface::new(world, &hit, path.direction);
        let reflected = if K::REFLECTS {
            unit_product(weight, surface.material.mirror)
        } else {
            Unit::ZERO
        };
        if reflected < weight {
            sum.add(weight - reflected, K::color(world, &surface));
        }
        weight = reflected;
        if weight < Q::SMALLEST_WEIGHT || rays > u32::from(reflections) {
            return Traced {
                sum,
                rays,
                cut_off: weight,
            };
        }
        path = surface.reflection();
        left = surface.plane;
    }
}

#[cfg(test)]
mod tests;
