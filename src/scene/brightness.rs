//! An upper bound on the colours of a scene. It tells how much a path that is cut off can still lose.

use super::access::Parts;
use crate::color::Color;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{
    Brightness, Unit, narrowed, narrowed_unsigned, narrowed_unsigned_128, signed, unsigned,
};

/// Returns the largest component of (ambient + Σ over the lights of (diffuse + specular) · light) ·
/// colour, in steps of 2⁻²⁶. Rounded up.
const fn brightest_of(material: &PreparedMaterial, color: Color, lights: &[PreparedLight]) -> u64 {
    let strongest = bits(material.diffuse) + bits(material.specular);
    // The cosines and powers of the kernels may exceed 1 by rounding, but by far less than 2⁻¹⁵.
    let strongest = strongest + strongest.div_ceil(1 << 15);
    let mut most = 0;
    let mut axis = 0;
    while axis < 3 {
        let mut light = 0;
        let mut index = 0;
        while index < lights.len() {
            light += bits(lights[index].color.components()[axis]);
            index += 1;
        }
        let received = (light as u128 * strongest as u128).div_ceil(1 << 26);
        // Each light and the ambient share may be rounded up by half of 2⁻²⁰.
        let rounding = (lights.len() as u128 + 1) << 5;
        let all = received + bits(material.ambient) as u128 + rounding;
        let color = bits(color.components()[axis]) as u128;
        most = larger(most, narrowed_unsigned_128((all * color).div_ceil(1 << 26)));
        axis += 1;
    }
    most
}

/// Returns a brightness in steps of 2⁻²⁶. No brightness is negative.
const fn larger(a: u64, b: u64) -> u64 {
    if a > b { a } else { b }
}

const fn bits(brightness: Brightness) -> u64 {
    unsigned(brightness.to_bits()) as u64
}

/// Returns 1 / `brightest`, at most 1, rounded down to eight leading bits. Arm compares with such a
/// number in one instruction.
pub(super) const fn dimness(brightest: Brightness) -> Unit {
    if brightest.to_bits() <= 1 << 26 {
        return Unit::ONE;
    }
    // Q0.56 / Q6.26. Since `brightest` is below 32, the result is 2²⁵ to 2³⁰.
    let inverse = narrowed((1_i64 << 56) / brightest.to_bits() as i64);
    let rest = 24 - inverse.leading_zeros();
    Unit::from_bits(inverse >> rest << rest)
}

impl Parts<'_> {
    /// Returns the largest component of any colour that a path can hit: the background's, or a material's
    /// at its brightest. Rounded up.
    pub(super) const fn brightest_color(&self) -> Brightness {
        let mut most = 0;
        let (colors, mut index) = (self.background.colors(), 0);
        while index < colors.len() {
            most = larger(most, bits(colors[index].largest()));
            index += 1;
        }
        index = 0;
        while index < self.lights.len() {
            if self.lights[index].disc().is_some() {
                most = larger(most, bits(self.lights[index].color.in_levels().largest()));
            }
            index += 1;
        }
        index = 0;
        while index < self.materials.len() && index < self.checkers.len() {
            let (material, checker) = (&self.materials[index], &self.checkers[index]);
            let color = material.color.at_least(checker.color);
            most = larger(most, brightest_of(material, color, self.lights));
            index += 1;
        }
        // No material is brighter than 30, and no background than 16.
        Brightness::from_bits(signed(narrowed_unsigned(most)))
    }

    /// Tests whether nothing lights the scene: no light, no ambient light, and a surface that scatters
    /// light.
    pub(crate) const fn lacks_light(&self) -> bool {
        if !self.lights.is_empty() || (self.bounded() == 0 && self.planes.is_empty()) {
            return false;
        }
        let mut scatters = false;
        let mut index = 0;
        while index < self.materials.len() {
            let material = &self.materials[index];
            if bits(material.ambient) > 0 {
                return false;
            }
            scatters |= bits(material.diffuse) > 0 || bits(material.specular) > 0;
            index += 1;
        }
        scatters
    }
}
