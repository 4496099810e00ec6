//! Floor 2: one file a shape. Each has the shape as it is described, the shape as the kernels
//! read it (`Prepared…`), and the kernels: where a ray meets it, whether it blocks a ray, and its
//! normal. Knows no scene.

pub(crate) mod bounded;
pub mod cylinder;
pub mod disc;
#[cfg(test)]
mod fixture;
pub mod plane;
pub mod sphere;

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

/// Names a material of one scene.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MaterialId(pub(crate) u16);

impl MaterialId {
    /// The material that was added first.
    pub(crate) const FIRST: Self = Self(0);

    /// Its place in the scene's list of materials.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// A ball that holds a shape as it is described.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub(crate) center: Position,
    pub(crate) radius: Number,
    /// The smallest of the shape's sizes: a radius, or half a height.
    pub(crate) smallest: Number,
}

/// The smallest radius and half height a shape may have, in steps: its hits are known to about two,
/// and so its normals to a 32nd.
const SMALLEST: i32 = 64;

/// A size must be greater than 0 and within the range of a coordinate.
pub(crate) const fn size_fault(size: Number, fault: ErrorKind) -> Option<ErrorKind> {
    if size.to_bits() <= 0 {
        Some(fault)
    } else if !size.is_within(0, Position::MAX_COORDINATE) {
        Some(ErrorKind::Coordinate)
    } else {
        None
    }
}

/// Divides vectors of one length by that length: turns the way from a centre into a normal.
#[derive(Clone, Copy, Debug)]
struct Normaliser {
    /// How far a vector of the length is shifted left to have 2²⁹ to 2³⁰.
    lift: u32,
    /// 2⁶⁰ / (length << lift), above 2³⁰, below 2³¹.
    inverse: i32,
}

/// Vectors shorter than 2¹⁸ steps, which are lifted by more than this, are made as long as one by
/// their own length: rounded coordinates do not have the length of the shape any more.
const LIFT: u32 = 11;

impl Normaliser {
    const fn new(length: Length) -> Self {
        let length = unsigned(length.to_bits());
        let lift = length.leading_zeros() - 2;
        let lifted = length << lift;
        let quotient = divide(1 << 60, lifted);
        let estimate = (quotient.mantissa >> -quotient.exponent) as i64;
        // One Newton step leaves the last bit.
        let residue = (1_i64 << 60) - lifted as i64 * estimate;
        let inverse = estimate + (((residue >> 8) * estimate + (1 << 51)) >> 52);
        Self {
            lift,
            inverse: if inverse > i32::MAX as i64 {
                i32::MAX
            } else {
                narrowed(inverse)
            },
        }
    }

    /// The direction of `vector`, whose length is the one given, but for a few steps; its length is
    /// within 2⁻¹⁶ of one. A cylinder that is met 2²⁹ steps away is met a dozen steps off: about 2⁻¹⁴.
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

    /// The same for short vectors.
    #[cold]
    const fn precise_direction(&self, vector: Vector) -> Direction {
        let Vector { x, y, z } = vector;
        Vector::new(x << self.lift, y << self.lift, z << self.lift).precise_direction()
    }

    #[inline(always)]
    const fn coordinate(&self, raw: i32) -> Unit {
        Unit::from_bits(high(raw << self.lift, self.inverse) << 2)
    }
}
