//! The numbers of a board: `f32`, and what `core` lacks of it.

/// What is computed in.
pub type Real = f32;

/// No: the textbook's discriminant takes fewer instructions than the reference's, and a rival that is
/// slower than need be would flatter the library.
pub const IS_CAREFUL: bool = false;

/// The square root: the core's own instruction.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub fn square_root(value: f32) -> f32 {
    unsafe extern "C" {
        // C's own. The compiler knows it: it becomes `vsqrt.f32`, and a call behind a branch that
        // is never taken, for what is negative.
        safe fn sqrtf(value: f32) -> f32;
    }
    sqrtf(value)
}

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
pub use libm::sqrtf as square_root;
pub use libm::{powf as power, tanf as tangent};
