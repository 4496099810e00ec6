//! Triangles as the user describes them: corners, and normals at the corners.

use crate::error_kind::ErrorKind;
use crate::number::{Number, square_root, unsigned};
use crate::shape::{Extent, MaterialId};
use crate::vector::{Position, Vector, leading_shift};

/// Triangle as the user describes it.
///
/// ```
/// use reflet::description::{Corners, Normals, Triangle};
/// use reflet::{Material, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(triangles: 2)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0]];
/// scene.add_triangle(corners, None, tin)?;
/// scene.add_triangle(corners, [[0, 0, 1], [1, 0, 1], [0, 1, 1]], tin)?;
/// let [Triangle { corners: flat, normals, material, .. }, round] = *scene.description().triangles else {
///     unreachable!()
/// };
/// assert_eq!((flat, normals, material), (Corners::from(corners), Normals(None), tin));
/// assert!(round.normals.0.is_some());
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Triangle {
    /// The three corners. They must not lie on one line: the smallest altitude must be at least 2⁻²⁰ of the longest
    /// side, and 2⁻²² of the scene's extent.
    pub corners: Corners,
    /// Normals at the corners, if the triangle is shaded as a part of a curved surface.
    pub normals: Normals,
    /// Material of the triangle.
    pub material: MaterialId,
}

/// The three corners of a [`Triangle`], in scene units.
///
/// ```
/// use reflet::Position;
/// use reflet::description::Corners;
///
/// let corners = Corners::from([[0, 0, 0], [3, 0, 0], [0, 4, 0]]);
/// assert_eq!(corners.positions()[2], Position::new([0.0, 4.0, 0.0]));
/// assert_eq!(corners, Corners::new([[0.0; 3], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0]]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corners {
    positions: [Position; 3],
    /// Ball around the corners and smallest altitude. All are 0 if the corners lie on one line, or almost.
    extent: Extent,
}

/// The normals at the corners of a [`Triangle`], each of any length but 0; `None` for a flat triangle.
///
/// Between the corners, the normal is the sum of the three by areas, as in Phong, "Illumination for Computer
/// Generated Pictures", 1975. It is turned to the viewer's side of the flat triangle. Where a mirror would reflect the
/// view into the triangle, the normal is bent until the reflection runs along it: Keller et al., "The Iray Light
/// Transport Simulation and Rendering System", 2017, A.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Normals(pub Option<[Position; 3]>);

impl Corners {
    /// Creates corners from decimal numbers.
    pub const fn new([one, two, three]: [[f64; 3]; 3]) -> Self {
        Self::of([Position::new(one), Position::new(two), Position::new(three)])
    }

    const fn of(positions: [Position; 3]) -> Self {
        Self {
            positions,
            extent: extent_of(positions),
        }
    }

    /// Returns the three positions.
    pub const fn positions(&self) -> [Position; 3] {
        self.positions
    }
}

impl<P: Into<Position>> From<[P; 3]> for Corners {
    fn from(positions: [P; 3]) -> Self {
        Self::of(positions.map(Into::into))
    }
}

impl Normals {
    /// Creates normals from decimal numbers.
    pub const fn new(normals: Option<[[f64; 3]; 3]>) -> Self {
        match normals {
            Some([one, two, three]) => Self(Some([
                Position::new(one),
                Position::new(two),
                Position::new(three),
            ])),
            None => Self(None),
        }
    }
}

impl<P: Into<Position>> From<[P; 3]> for Normals {
    fn from(normals: [P; 3]) -> Self {
        Self(Some(normals.map(Into::into)))
    }
}

impl From<Option<[[f64; 3]; 3]>> for Normals {
    fn from(normals: Option<[[f64; 3]; 3]>) -> Self {
        Self::new(normals)
    }
}

impl Triangle {
    /// Placeholder for an unused slot in a list of described triangles.
    pub(crate) const NONE: Self = Self {
        corners: Corners {
            positions: [Position::ORIGIN; 3],
            extent: NO_EXTENT,
        },
        normals: Normals(None),
        material: MaterialId(0),
    };

    /// Checks the triangle. Returns the first fault, or `None` if corners and normals are allowed.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !are_in_range(&self.corners.positions) {
            return Some(ErrorKind::Coordinate);
        }
        if let Some(normals) = &self.normals.0 {
            if !are_in_range(normals) {
                return Some(ErrorKind::Coordinate);
            }
            let [one, two, three] = normals;
            if one.magnitude() == 0 || two.magnitude() == 0 || three.magnitude() == 0 {
                return Some(ErrorKind::Normal);
            }
        }
        match self.corners.extent.smallest.to_bits() {
            0 => Some(ErrorKind::Corners),
            _ => None,
        }
    }

    /// Returns a ball around the triangle, and its smallest altitude.
    pub(crate) const fn extent(&self) -> Extent {
        self.corners.extent
    }
}

const NO_EXTENT: Extent = Extent {
    center: Position::ORIGIN,
    radius: Number::ZERO,
    smallest: Number::ZERO,
};

const fn are_in_range(positions: &[Position; 3]) -> bool {
    positions[0].is_in_range() && positions[1].is_in_range() && positions[2].is_in_range()
}

/// Smallest altitude of a triangle as a share of its longest side: 2^-`THINNEST`.
const THINNEST: u32 = 20;

/// Returns the extent of a triangle: a ball around it, and its smallest altitude, which is a relative 2⁻⁸ exact for
/// the thinnest triangle.
const fn extent_of(positions: [Position; 3]) -> Extent {
    if !are_in_range(&positions) {
        return NO_EXTENT;
    }
    let [one, two, three] = positions;
    let (first, second) = (two.minus(one), three.minus(one));
    let (magnitude, other) = (first.magnitude(), second.magnitude());
    let magnitude = if magnitude > other { magnitude } else { other };
    if magnitude == 0 {
        return NO_EXTENT;
    }
    let shift = leading_shift(magnitude);
    let (first, second) = (first.coarser(shift), second.coarser(shift));
    let longest = unsigned(square_root(furthest(Vector::ZERO, first, second))) as u64;
    let longest = larger(
        longest,
        unsigned(square_root(first.minus(second).square())) as u64,
    );
    let (crossed, up) = Vector::leading(first.cross_wide(second), 30);
    let altitude = ((unsigned(square_root(crossed.square())) as u64) << up) / (longest | 1);
    if altitude << THINNEST < longest {
        return NO_EXTENT;
    }
    let (center, square) = middle(first, second);
    // Rounding moves the centre and a corner by less than one each, and the root by 2⁻²⁷ of it.
    let radius = unsigned(square_root(square)) as u64 + 8;
    Extent {
        center: moved(one, center, shift),
        radius: Number::from_bits(scaled(radius as i128, shift)),
        smallest: Number::from_bits(scaled(altitude as i128, shift) | 1),
    }
}

/// Returns the centre of a small ball around a triangle, and the square of its radius: the centroid or the middle of
/// a side. The first corner is at the origin.
const fn middle(first: Vector, second: Vector) -> (Vector, u64) {
    let both = first.plus(second);
    let centers = [
        Vector::new(both.x / 3, both.y / 3, both.z / 3),
        first.coarser(1),
        second.coarser(1),
        both.coarser(1),
    ];
    let mut best = (centers[0], furthest(centers[0], first, second));
    let mut index = 1;
    while index < centers.len() {
        let square = furthest(centers[index], first, second);
        if square < best.1 {
            best = (centers[index], square);
        }
        index += 1;
    }
    best
}

/// Returns the square of the distance from a centre to the furthest corner.
const fn furthest(center: Vector, first: Vector, second: Vector) -> u64 {
    let sides = larger(center.minus(first).square(), center.minus(second).square());
    larger(center.square(), sides)
}

pub(super) const fn larger(a: u64, b: u64) -> u64 {
    if a > b { a } else { b }
}

/// Returns `value` · 2^`shift`, in the raw bits of a number.
const fn scaled(value: i128, shift: i32) -> i128 {
    if shift >= 0 { value << shift } else { value >> -shift }
}

/// Returns the position at the end of a vector in units of 2^`shift`.
const fn moved(from: Position, way: Vector, shift: i32) -> Position {
    let [x, y, z] = from.0;
    Position([
        Number::from_bits(x.to_bits() + scaled(way.x as i128, shift)),
        Number::from_bits(y.to_bits() + scaled(way.y as i128, shift)),
        Number::from_bits(z.to_bits() + scaled(way.z as i128, shift)),
    ])
}
