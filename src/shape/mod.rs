//! Floor 2: one file for each kind of shape. Each file has the shape as the user describes it, the shape
//! as the kernels read it (`Prepared…`), and the kernels: the distance at which a ray hits the shape,
//! whether the shape blocks a ray, and the normal at a point. Knows no scene.

pub(crate) mod bordered;
pub(crate) mod bounded;
pub mod cylinder;
pub mod disc;
#[cfg(test)]
mod fixture;
mod flat;
pub mod plane;
pub(crate) mod rays;
pub mod sphere;
pub mod triangle;

use crate::error_kind::ErrorKind;
use crate::number::{Length, Number, Unit, divide, high, narrowed, unsigned};
use crate::vector::{Direction, Position, Vector};

macro_rules! exports {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $($more:tt)* })*
    ) => {
        $(pub use $kind::{$described, $prepared};)*
    };
}
kinds!(exports);
pub use triangle::{Corners, Normals};

/// Identifier of a material of one scene.
///
/// ```
/// use reflet::{Material, MaterialId, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let red: MaterialId = scene.add_material(Material::new([0.9, 0.1, 0.1]))?;
/// scene.add_sphere([0, 0, 0], 1, red)?;
/// let described = scene.description();
/// assert_eq!(described.spheres[0].material, red);
/// assert_eq!(described.materials[red.index()], Material::new([0.9, 0.1, 0.1]));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(pub(crate) u16);

impl MaterialId {
    /// Identifier of the material that was added first.
    pub(crate) const FIRST: Self = Self(0);

    /// Returns the index of the material in the scene's list of materials.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Bounding ball of a described shape, and the smallest size of the shape, in scene units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Extent {
    pub(crate) center: Position,
    pub(crate) radius: Number,
    /// Smallest size of the shape: its radius or half its height, whichever is smaller, or the smallest altitude.
    pub(crate) smallest: Number,
}

/// Smallest radius, half height and altitude that a shape may have, in steps. Hits are known to about two steps,
/// so normals are known to about 1/32.
const SMALLEST: i32 = 64;

/// Checks a size of a shape. Returns `fault` if the size is not greater than 0, and
/// [`ErrorKind::Coordinate`] if it is larger than a coordinate may be. Returns `None` if the size is
/// allowed.
pub(crate) const fn size_fault(size: Number, fault: ErrorKind) -> Option<ErrorKind> {
    if size.to_bits() <= 0 {
        Some(fault)
    } else if !size.is_within(0, Position::MAX_COORDINATE) {
        Some(ErrorKind::Coordinate)
    } else {
        None
    }
}

/// Stored reciprocal of one length. It turns vectors of that length into directions without a division:
/// a vector from a shape's centre to a hit becomes the normal.
#[derive(Clone, Copy, Debug)]
struct Normaliser {
    /// Left shift that brings the length to 2²⁹ to 2³⁰ steps.
    lift: u32,
    /// Reciprocal of the shifted length: 2⁶⁰ / (length << lift), above 2³⁰ and below 2³¹.
    inverse: i32,
}

/// Largest shift for which [`Normaliser`] uses the stored reciprocal. Lengths below 2¹⁸ steps need a
/// larger shift. Such a vector is divided by its own length, because rounding to whole steps changes the
/// length of a short vector too much.
const LIFT: u32 = 11;

impl Normaliser {
    /// Computes the shift and the reciprocal for vectors of `length`.
    const fn new(length: Length) -> Self {
        let length = unsigned(length.to_bits());
        let lift = length.leading_zeros() - 2;
        let lifted = length << lift;
        let quotient = divide(1 << 60, lifted);
        let estimate = (quotient.mantissa >> -quotient.exponent) as i64;
        // One Newton step corrects all but the last bit.
        let residue = (1_i64 << 60) - lifted as i64 * estimate;
        let inverse = estimate + (((residue >> 8) * estimate + (1 << 51)) >> 52);
        Self {
            lift,
            inverse: if inverse > i32::MAX as i64 { i32::MAX } else { narrowed(inverse) },
        }
    }

    /// Returns the direction of `vector`, whose length is within a few steps of the stored length. The
    /// result's length is within 2⁻¹⁶ of one. A hit on a cylinder 2²⁹ steps away is about a dozen steps
    /// off; its normal's length is within about 2⁻¹⁴ of one.
    #[inline(always)]
    const fn direction(&self, vector: Vector) -> Direction {
        if self.lift > LIFT {
            return self.precise_direction(vector);
        }
        Direction {
            x: self.coordinate(vector.x),
            y: self.coordinate(vector.y),
            z: self.coordinate(vector.z),
        }
    }

    /// Returns the direction of a vector shorter than 2¹⁸ steps. Divides the vector by its own length,
    /// because rounded coordinates no longer have the length of the shape.
    #[cold]
    const fn precise_direction(&self, vector: Vector) -> Direction {
        vector.lifted(self.lift).precise_direction()
    }

    /// Divides one coordinate, in steps, by the stored length. Rounded down to 2⁻²⁸.
    #[inline(always)]
    const fn coordinate(&self, raw: i32) -> Unit {
        Unit::from_bits(high(raw << self.lift, self.inverse) << 2)
    }
}
