//! Follows one path as [`Tracer::trace`] does, with the same parts and to the same bits, and hands out each step. For
//! tools that explain a pixel; nothing that draws calls it.

use alloc::vec::Vec;

use super::Tracer;
use super::bounce::{Bounce, Pixel};
use crate::accel::World;
use crate::color::{Color, Sum};
use crate::number::Unit;
use crate::qualities::Quality;
use crate::ray::{ScaledPoint, ScaledRay};
use crate::scene::access::ShapeId;
use crate::shade::highlight::sealed::Shading;
use crate::vector::Direction;

/// A surface that a path meets, and the colour that it adds.
pub(crate) struct Met {
    pub(crate) shape: ShapeId,
    pub(crate) is_inside: bool,
    /// Where the ray starts that met the surface.
    pub(crate) from: ScaledPoint,
    /// Where rays leave the surface.
    pub(crate) to: ScaledPoint,
    /// Share of the light that the surface mirrors.
    pub(crate) mirror: Unit,
    /// Throughput before and after the surface.
    pub(crate) throughput: [Unit; 2],
    /// The surface's own colour; black for a perfect mirror.
    pub(crate) color: Color,
    /// The lights that shine on the surface, as in [`crate::shade::Lit`].
    pub(crate) lights: u32,
    /// Sum along the path up to here.
    pub(crate) sum: Sum,
}

/// A path.
pub(crate) struct Walked {
    pub(crate) steps: Vec<Met>,
    /// Directions of the rays that were followed.
    pub(crate) rays: Vec<Direction>,
    pub(crate) end: End,
    /// Colour that the path adds where it hits nothing.
    pub(crate) missed: Option<Color>,
    pub(crate) sum: Sum,
}

/// The reason why a path ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// A ray hits nothing and shows the background.
    Missed,
    /// What the path could still add has no weight.
    NoWeight,
    /// The path has as many reflections as the frame allows.
    LastReflection,
}

impl<'a, W: World, K: Shading, Q: Quality> Tracer<'a, W, K, Q> {
    /// Follows the path of a pixel.
    pub(crate) fn walk(&mut self, mut pixel: Pixel<'_>, direction: Direction) -> Walked {
        let (world, mut steps, mut rays) = (self.world, Vec::new(), Vec::new());
        let mut ray = ScaledRay::new(self.visibility.from, direction);
        let (mut sum, mut throughput, mut bounce) = (Sum::DARK, Unit::ONE, Bounce::NONE);
        let end = loop {
            rays.push(ray.direction());
            let Some(surface) = self.surface(&mut pixel, &ray, &bounce) else {
                break End::Missed;
            };
            let reflected = Self::reflected(world, &surface, throughput);
            let (mut color, mut lights) = (Color::BLACK, 0);
            if reflected < throughput && Self::has_own(world, &surface) {
                let lit = self.shade(&surface);
                (color, lights) = (lit.color, lit.lights);
                sum.add(throughput - reflected, color);
            }
            steps.push(Met {
                shape: surface.shape,
                is_inside: surface.is_inside,
                from: ray.from(),
                to: surface.place,
                mirror: surface.material(world).mirror,
                throughput: [throughput, reflected],
                color,
                lights,
                sum,
            });
            throughput = reflected;
            if throughput == Unit::ZERO || self.is_cut_off(throughput, bounce.count) {
                break Self::end(world, throughput);
            }
            bounce.count += 1;
            if !W::NEEDS.mirrored {
                break End::Missed;
            }
            surface.reflect(world, &mut ray);
            (bounce.mirror, bounce.skip) = (surface.shape, surface.skip(world));
        };
        let missed = (end == End::Missed).then(|| K::missed(world, ray.direction()).color);
        if let Some(color) = missed {
            sum.add(throughput, color);
        }
        Walked {
            steps,
            rays,
            end,
            missed,
            sum,
        }
    }

    /// Returns why a path ends that has this throughput and follows no further ray.
    fn end(world: &W, throughput: Unit) -> End {
        let least = world.parts().smallest_weight(Q::SMALLEST_WEIGHT);
        if throughput == Unit::ZERO || throughput < least {
            End::NoWeight
        } else {
            End::LastReflection
        }
    }
}
