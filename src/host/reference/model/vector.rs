//! The vector of three numbers: a point, a direction or a linear colour. This file knows no shapes.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

use super::{Real, square_root};

/// A vector of three numbers: a point, a direction, or a linear colour.
///
/// ```
/// use reflet::host::reference::Vector;
///
/// let [eye, target] = [Vector([1.0, 2.0, 3.0]), Vector([1.0, 5.0, 7.0])];
/// let forward = (target - eye).unit();
/// assert_eq!((target - eye).length(), 5.0);
/// assert!((forward - Vector([0.0, 0.6, 0.8])).length() < 1e-15);
/// assert_eq!(eye + Vector([0.0, 3.0, 4.0]) * 2.0, Vector([1.0, 8.0, 11.0]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector(pub [Real; 3]);

impl Vector {
    /// The zero vector: the origin, or black.
    pub const ZERO: Self = Self([0.0; 3]);

    /// Returns the vector with `value` in all three components: a grey.
    #[inline]
    pub fn grey(value: Real) -> Self {
        Self([value; 3])
    }

    /// Returns the scalar product of two vectors.
    ///
    /// ```
    /// # use reflet::host::reference::Vector;
    /// assert_eq!(Vector([1.0, 2.0, 3.0]).dot(Vector([4.0, -5.0, 6.0])), 12.0);
    /// ```
    #[inline]
    pub fn dot(self, other: Self) -> Real {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    /// Returns the vector product of two vectors; it is right-handed.
    ///
    /// ```
    /// # use reflet::host::reference::Vector;
    /// let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector);
    /// assert_eq!(x.cross(y), z);
    /// ```
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// Returns the Euclidean length. It is zero or infinite if the sum of the squares is.
    #[inline]
    pub fn length(self) -> Real {
        square_root(self.dot(self))
    }

    /// Returns the vector scaled to length one. The components are not numbers for the zero vector.
    #[inline]
    pub fn unit(self) -> Self {
        self * (1.0 / self.length())
    }

    /// Returns the product component by component, as a surface's colour filters light.
    ///
    /// ```
    /// # use reflet::host::reference::Vector;
    /// let orange = Vector([1.0, 0.5, 0.0]);
    /// assert_eq!(orange.filtered(Vector::grey(0.5)), Vector([0.5, 0.25, 0.0]));
    /// assert_eq!(orange.filtered(Vector::ZERO), Vector::ZERO);
    /// ```
    #[inline]
    pub fn filtered(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a * x, b * y, c * z])
    }

    /// Returns the part of the vector that is perpendicular to the unit vector `axis`.
    ///
    /// ```
    /// # use reflet::host::reference::Vector;
    /// let up = Vector([0.0, 0.0, 1.0]);
    /// assert_eq!(Vector([3.0, 5.0, -2.0]).across(up), Vector([3.0, 5.0, 0.0]));
    /// ```
    #[inline]
    pub fn across(self, axis: Self) -> Self {
        self - axis * self.dot(axis)
    }

    /// Returns the direction mirrored about the unit normal of a surface. Both directions point away
    /// from the surface.
    ///
    /// ```
    /// # use reflet::host::reference::Vector;
    /// let up = Vector([0.0, 0.0, 1.0]);
    /// assert_eq!(Vector([3.0, 5.0, 2.0]).mirrored(up), Vector([-3.0, -5.0, 2.0]));
    /// ```
    #[inline]
    pub fn mirrored(self, normal: Self) -> Self {
        normal * (2.0 * normal.dot(self)) - self
    }
}

impl Add for Vector {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl AddAssign for Vector {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Vector {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }
}

impl Mul<Real> for Vector {
    type Output = Self;

    #[inline]
    fn mul(self, factor: Real) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}

impl Neg for Vector {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(self.0.map(|component| -component))
    }
}

/// Converts a linear colour to bytes: each channel c is clamped to 0 to 1 and becomes round(255 c).
#[inline]
pub fn quantised(color: Vector) -> [u8; 3] {
    // `as` cuts off the fraction and clamps to 0 to 255.
    color.0.map(|channel| (255.0 * channel + 0.5) as u8)
}
