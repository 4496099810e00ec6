//! Floor 6: one ray to one colour: the accumulation over reflections, its weight and its stop.
//!
//! c = Σᵢ (1 - αᵢ) (Π over k < i of αₖ) cᵢ, in a loop: the weight Π αₖ is carried along, and the
//! path ends where it is spent, where nothing is met, or after the last reflection.

use crate::color::Sum;
use crate::number::{Unit, unit_product};
use crate::quality::Quality;
use crate::ray::Path;
use crate::scene::Parts;
use crate::scene::query::nearest;
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
pub(crate) fn trace<K: Shading, Q: Quality>(
    parts: &Parts<'_>,
    mut path: Path,
    reflections: u8,
) -> Traced {
    let mut sum = Sum::ZERO;
    let mut weight = Unit::ONE;
    let mut left = None;
    let mut rays = 0;
    loop {
        rays += 1;
        let Some(hit) = nearest(parts, &path, left) else {
            sum.add(weight, K::missed(parts));
            return Traced {
                sum,
                rays,
                cut_off: Unit::ZERO,
            };
        };
        let surface = Surface::new(parts, &hit, path.direction);
        let reflected = if K::REFLECTS {
            unit_product(weight, surface.material.mirror)
        } else {
            Unit::ZERO
        };
        if reflected < weight {
            sum.add(weight - reflected, K::color(parts, &surface));
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
