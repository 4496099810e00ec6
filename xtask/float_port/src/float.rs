//! What `core` lacks of `f32`.

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

/// The square root.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
pub fn square_root(value: f32) -> f32 {
    libm::sqrtf(value)
}

pub use libm::{powf as power, tanf as tangent};
