//! Floor 6: what a pixel covers of a surface.
//!
//! The footprint of a pixel is the parallelogram on the tangent plane of a hit that the pixel's two sides lead to: how the
//! ray changes from one pixel to the next is carried along the path (Igehy, "Tracing Ray Differentials", SIGGRAPH 1999). A
//! curved mirror changes the angle between neighbouring rays, but, here, not the plane that they lie in.

use crate::accel::World;
use crate::camera::PixelSides;
use crate::checker::Area;
use crate::color::Color;
use crate::number::{Unit, divide, narrowed, scaled_by_unit, share, shifted, unsigned, wide};
use crate::qualities::Quality;
use crate::ray::{PathSignature, ScaledRay, shift_of};
use crate::scene::Surface;
use crate::scene::access::Parts;
use crate::scene::surface::checker_of;
use crate::shade::Lit;
use crate::vector::Direction;

/// What a pixel covers at the latest hit of a path.
#[derive(Clone, Copy)]
pub(crate) struct Footprint {
    /// The changes to the next pixel to the right, and to the next one below.
    sides: [Side; 2],
    /// Sizes are in steps of 2^`scale`.
    scale: u32,
    /// Which part of the pixel the path shows: one of 2^n equal parts along each side. If `None`, it shows a point, and the
    /// footprint is that of the whole pixel.
    parts: Option<[u32; 2]>,
}

/// How a ray changes from one pixel to the next.
#[derive(Clone, Copy)]
struct Side {
    /// Where to, across the ray.
    across: Direction,
    /// By which angle.
    turn: Unit,
    /// How far, at the latest hit.
    size: i32,
}

/// What a path shows of checkers.
pub(super) struct SeenCells {
    /// `None` if the path shows points only, or if it changes too much from pixel to pixel.
    footprint: Option<Footprint>,
    /// Whether the path meets an odd number of cells with their checker's colour, and an odd number of cells that are odd along
    /// [`PreparedChecker::axis_aside`](crate::checker::PreparedChecker::axis_aside).
    is_odd: [bool; 2],
    /// Whether some cells are less than two pixels wide.
    is_fine: bool,
}

/// Longest side of a footprint, and longest part of it along the ray, in steps.
const LONGEST: i32 = 1 << 29;

/// Largest angle of a [`Side`].
const MOST: Unit = Unit::from_bits(1 << 28);

impl Footprint {
    /// Creates the footprint of a camera's ray that shows one of 2^`parts` equal parts of a pixel along each side, or a point of the
    /// pixel if there are none.
    pub(crate) fn new(pixel: &PixelSides, direction: Direction, parts: Option<[u32; 2]>) -> Self {
        let turn = share(pixel.width, pixel.ahead.dot(direction).max(Unit::ZERO));
        let [right, down] = parts.unwrap_or([0; 2]);
        let side = |side: usize, part: u32| Side {
            across: pixel.sides[side],
            turn: turn >> part,
            size: 0,
        };
        Self {
            sides: [side(0, right), side(1, down)],
            scale: 0,
            parts,
        }
    }

    /// Follows a ray to a surface.
    fn reach(&mut self, ray: &ScaledRay, surface: &Surface<'_>) {
        let (way, scale) = ray.from().to(surface.place);
        // A quarter always fits.
        let (way, scale) = (way.quarter_dot(ray.direction()).max(0), scale + 2);
        let largest = self.scale.max(scale);
        let way = way >> shift_of(largest - scale);
        for side in &mut self.sides {
            let before = side.size >> shift_of(largest - self.scale);
            let size = before + scaled_by_unit(way, side.turn);
            side.size = size.clamp(-LONGEST, LONGEST);
        }
        self.scale = largest;
    }

    /// Returns the footprint behind a mirror. `None` if the mirror's normal turns too much from pixel to pixel.
    ///
    /// A mirror turns a ray by twice the angle by which its normal turns.
    fn mirrored(mut self, parts: &Parts<'_>, mirror: &Surface<'_>) -> Option<Self> {
        let bend = parts.bend(mirror)?;
        for side in &mut self.sides {
            let turn = bend.over(side.across, (side.size, self.scale))?;
            side.turn += turn + turn;
            if side.turn.abs() > MOST {
                return None;
            }
            let climb = side.across.dot(mirror.normal);
            side.across = side.across.reflected(mirror.normal, climb);
        }
        Some(self)
    }

    /// Returns the area that the footprint covers on the surface that was hit.
    ///
    /// A side v across the ray leads to the tangent plane along the ray: to v - (n · v) / (n · d) d, with the normal n and the
    /// ray's direction d.
    fn area(&self, surface: &Surface<'_>) -> Area {
        let side = |side: Side| {
            let climb = wide(side.size, side.across.dot(surface.normal).to_bits());
            let along = divide(climb.unsigned_abs(), unsigned(surface.facing.to_bits()));
            let along = shifted(along.mantissa.into(), along.exponent.clamp(-63, 0));
            let along = narrowed(along.min(LONGEST.into()));
            let along = if climb < 0 { -along } else { along };
            let along = surface.view.raw_times(along);
            side.across.raw_times(side.size).plus(along)
        };
        Area {
            middle: surface.place,
            sides: self.sides.map(side),
            scale: self.scale,
        }
    }
}

impl SeenCells {
    /// Nothing is shown yet of a pixel with this footprint.
    #[inline(always)]
    pub(super) fn new(footprint: Option<Footprint>) -> Self {
        Self {
            footprint,
            is_odd: [false; 2],
            is_fine: false,
        }
    }

    /// Follows a ray to a surface.
    #[inline(always)]
    pub(super) fn reach<W: World>(&mut self, ray: &ScaledRay, surface: &Surface<'_>) {
        if let Some(footprint) = self.footprint.as_mut().filter(|_| W::NEEDS.checkers) {
            footprint.reach(ray, surface);
        }
    }

    /// Goes on behind a mirror.
    #[inline(always)]
    pub(super) fn turn<W: World>(&mut self, world: &W, mirror: &Surface<'_>) {
        if W::NEEDS.checkers {
            let mirrored = |it: Footprint| it.mirrored(&world.parts(), mirror);
            self.footprint = self.footprint.and_then(mirrored);
        }
    }

    /// Returns the colour that a surface adds to a path: that of its cell, or the mean over the footprint. Keeps which cells are
    /// met; cells whose borders are edges go into the signature at once.
    #[inline(always)]
    pub(super) fn color<W: World, Q: Quality>(
        &mut self,
        world: &W,
        (surface, lit): (&Surface<'_>, &Lit),
        signature: &mut PathSignature,
    ) -> Color {
        let Some((holds, other)) = lit.cell else {
            return lit.color;
        };
        if Q::SMOOTHNESS > 1 {
            return self.smooth_color(world, (surface, lit, (holds, other)), signature);
        }
        self.is_odd[0] ^= holds;
        lit.color
    }

    /// Does what [`SeenCells::color`] does for a pixel with smooth edges.
    #[inline(never)]
    fn smooth_color<W: World>(
        &mut self,
        world: &W,
        (surface, lit, (holds, other)): (&Surface<'_>, &Lit, (bool, Color)),
        signature: &mut PathSignature,
    ) -> Color {
        let checker = checker_of(world, surface.shape);
        let (Some(footprint), Some(checker)) = (&self.footprint, checker) else {
            // The borders of these cells are edges.
            signature.note(holds.into());
            return lit.color;
        };
        let area = footprint.area(surface);
        if footprint.parts.is_none() {
            self.is_odd[0] ^= holds;
            self.is_odd[1] ^= checker.is_odd_aside(surface.place, surface.normal);
            self.is_fine |= checker.is_fine_on(&area);
            return lit.color;
        }
        let share = checker.share_on(&area);
        let [own, checked] = if holds { [other, lit.color] } else { [lit.color, other] };
        own.towards(checked, share)
    }

    /// Returns the final signature of the path.
    #[inline(always)]
    pub(super) fn marked(&self, signature: PathSignature) -> PathSignature {
        signature.across(self.is_odd).in_fine_cells(self.is_fine)
    }
}
