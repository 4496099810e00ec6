//! The cosines between normal, light and viewer, and those that highlights are powers of.

use crate::number::{
    Unit, high_unsigned, narrowed, offset_modulo_2_32, ratio, scaled_by_unit, unsigned,
};

/// Cosines of the angles at a surface that a highlight depends on.
pub(crate) struct Cosines {
    /// Cosine between the normal and the direction to the light.
    pub(in crate::shade) light: Unit,
    /// Cosine between the normal and the direction to the viewer.
    pub(in crate::shade) viewer: Unit,
    /// Cosine between the directions to the light and to the viewer.
    pub(in crate::shade) between: Unit,
}

impl Cosines {
    /// Returns the squared cosine of the half-way vector: (h · n)² = ((n·l + n·v) / 2)² / ((1 + l·v) / 2).
    #[inline(always)]
    pub(super) fn half_way_square(&self) -> Unit {
        let sum = unsigned(self.light.to_bits()) + unsigned(self.viewer.to_bits());
        // Q30: (2 Q30)² / 4
        let numerator = high_unsigned(sum, sum);
        // 1 + l·v is 0 to 2, up to rounding in the last place. If rounding makes it negative, it becomes a
        // large unsigned number here.
        let denominator = offset_modulo_2_32(self.between.to_bits(), 1 << 30) >> 1;
        if numerator >= denominator {
            return Unit::ONE;
        }
        Unit::from_bits(ratio(numerator, denominator))
    }

    /// Returns the cosine between the mirrored light and the viewer: r · v = 2 (n·l) (n·v) - l·v, at least
    /// 0.
    pub(super) fn mirrored(&self) -> Unit {
        let product = scaled_by_unit(self.light.to_bits(), self.viewer);
        let cosine = 2 * i64::from(product) - i64::from(self.between.to_bits());
        Unit::from_bits(narrowed(cosine.clamp(0, 1 << 30)))
    }
}
