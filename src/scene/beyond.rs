//! What a ray shows that hits nothing: the disc of a sun, or the background.

use super::access::Parts;
use crate::background::Beyond;
use crate::number::{Unit, unit_product};
use crate::vector::Direction;

impl Parts<'_> {
    /// Tests whether rays that hit nothing show different colours: there is a sky, or the disc of a sun.
    pub(crate) const fn has_sky(&self) -> bool {
        let mut index = 0;
        while index < self.lights.len() && self.lights[index].disc().is_none() {
            index += 1;
        }
        self.background.is_sky() || index < self.lights.len()
    }

    /// Returns what a ray in a direction shows that hits nothing. `has_sky` says whether there can be a sky or a disc:
    /// if not, the direction is not read.
    #[inline(always)]
    pub(crate) fn beyond(&self, direction: Direction, has_sky: bool) -> Beyond {
        let discs = if has_sky { self.lights } else { &[] };
        for (index, light) in discs.iter().enumerate() {
            let holds = |&(center, cosine): &(Direction, Unit)| direction.dot(center) >= cosine;
            if light.disc().filter(holds).is_some() {
                return Beyond::of_disc(index, light.color.in_levels());
            }
        }
        self.background.beyond(direction, has_sky)
    }

    /// Tests whether all directions between two are surely on one side of the edge of each disc, if both are.
    /// `turn` is the length of their difference, at most 1/2.
    ///
    /// A point p of the straight line between the two directions has a product with the disc's direction of at most
    /// the larger one of theirs. Its length is at least √(1 - turn² / 4), which is above 1 - turn² / 7. A disc
    /// is convex, so all directions lie in it if both do.
    pub(crate) fn keeps_discs(&self, ends: [Direction; 2], turn: Unit) -> bool {
        /// More than what a cosine is off by: 2⁻²².
        const OFF: i32 = 1 << 8;
        let square = unit_product(turn, turn).to_bits();
        let bulge = (square >> 3) + (square >> 5) + OFF;
        let mut discs = self.lights.iter().filter_map(|it| it.disc());
        discs.all(|(center, cosine)| {
            let [one, other] = ends.map(|end| end.dot(center).to_bits());
            let cosine = cosine.to_bits();
            one.max(other) < cosine - bulge || one.min(other) > cosine + OFF
        })
    }
}
