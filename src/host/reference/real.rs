//! The number type of the reference, and the functions on it that `core` does not have.

pub(super) use super::Real;

/// Selects the formula for the chord of a ray in a sphere or cylinder.
///
/// `true`: from the distance between the ray and the shape's centre (for a cylinder: its axis), which
/// keeps the digits of the chord however far away the shape is. `false`: from the textbook's
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
