//! Normals between the corners of a triangle.

use super::Face;
use crate::number::{Unit, narrowed, signed_wide, unsigned};
use crate::vector::{Direction, Position, Vector};

/// Normals at the corners of a triangle, and what finds the weights between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Smooth {
    /// The weights of the second and the third corner at a point p are p · gradient · 2^-shift, Q2.30. p leads from
    /// the first corner to the point, in steps.
    gradients: [Vector; 2],
    shifts: [u32; 2],
    normals: [Direction; 3],
}

impl Smooth {
    /// Prepares normals. `None` if one is zero.
    pub(super) const fn new(face: &Face, [one, two, three]: [Position; 3]) -> Option<Self> {
        let (Some(one), Some(two), Some(three)) =
            (one.direction(), two.direction(), three.direction())
        else {
            return None;
        };
        let [first, second] = face.lifted;
        let [first_lift, second_lift] = face.lifts;
        // The second corner's weight is 0 along the side to the third, and grows at right angles to it.
        Some(Self {
            gradients: [gradient(face, second, true), gradient(face, first, false)],
            shifts: [face.shift - first_lift - 2, face.shift - second_lift - 2],
            normals: [one, two, three],
        })
    }

    /// Returns the normal of a point that lies `at` from the first corner: on the side of `flat`, and such that the
    /// mirrored `view` does not lead below it. `flat` faces the viewer.
    #[inline(never)]
    pub(super) fn bent(&self, at: Vector, flat: Direction, view: Direction) -> Direction {
        let weight = |index: usize, most: i32| {
            let weight = at.dot_raw(self.gradients[index]) >> self.shifts[index];
            narrowed(weight.max(0).min(i64::from(most)))
        };
        let one = Unit::ONE.to_bits();
        let second = weight(0, one);
        let third = weight(1, one - second);
        let weights = [one - second - third, second, third];
        let sum = [0, 1, 2].map(|corner| self.normals[corner].raw_times(weights[corner]));
        let sum = sum[0].plus(sum[1]).plus(sum[2]);
        // Opposite normals have no sum.
        if sum.square() < 1 << 40 {
            return flat;
        }
        let (normal, _) = sum.normalised();
        let normal = normal.reversed_if(normal.dot(flat) < Unit::ZERO);
        above(normal, flat, view)
    }
}

/// Returns the gradient of a weight that is 0 along a lifted side. With the area a of [`Face`], it is the side times the
/// normal, over a, in units of 2²⁸.
const fn gradient(face: &Face, side: Vector, is_to_the_right: bool) -> Vector {
    let inverse = signed_wide((1 << 58) / (unsigned(face.area) | 1) as u64);
    let inverse = narrowed(if is_to_the_right { -inverse } else { inverse });
    face.normal
        .crossed_with(side)
        .part(Unit::from_bits(inverse))
}

/// Bends a normal until a view that it mirrors does not lead below the surface `flat`.
fn above(normal: Direction, flat: Direction, view: Direction) -> Direction {
    let mirrored = view.reflected(normal, view.dot(normal));
    let height = mirrored.dot(flat);
    if height >= Unit::ZERO {
        return normal;
    }
    let along = mirrored.raw().without(flat, height.to_bits());
    let (along, _) = along.normalised();
    // Half of each, so that the difference fits.
    let between = along.raw().coarser(1).minus(view.raw().coarser(1));
    if between.square() < 1 << 36 { flat } else { between.normalised().0 }
}
