//! The numbers of the reference, and what `core` lacks of them.

pub(super) use super::Real;

/// Whether the chord of a ray in a round shape is found by the distance of the shape's middle from the
/// ray, which keeps the chord's digits however far away the shape is, or by the textbook's
/// discriminant.
pub const IS_CAREFUL: bool = true;

pub fn square_root(value: Real) -> Real {
    value.sqrt()
}

pub fn power(base: Real, exponent: Real) -> Real {
    base.powf(exponent)
}

pub fn tangent(angle: Real) -> Real {
    angle.tan()
}
