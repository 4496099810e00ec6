//! Number type of the float port, and the functions on it that `core` does not have.

/// Number type of all computations.
pub type Real = f32;

/// Whether shapes use the reference's careful formulas. No: those of the textbook take fewer
/// instructions, and a slower competitor would flatter the library.
pub const IS_CAREFUL: bool = false;

/// Returns the square root, by the core's own instruction.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline]
pub fn square_root(value: f32) -> f32 {
    unsafe extern "C" {
        // C's own function. The compiler knows it and emits `vsqrt.f32`, and for negative numbers a
        // call behind a branch that is never taken.
        safe fn sqrtf(value: f32) -> f32;
    }
    sqrtf(value)
}

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
pub use libm::sqrtf as square_root;
pub use libm::{powf as power, tanf as tangent};
