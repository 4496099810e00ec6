//! The qualities of the path tests. They equal those of `render` with the same names, without the
//! fields that only `render` reads. A test there checks that.

use crate::accel::{Culling, CullingQuality};
use crate::number::Unit;
use crate::shade::LightQuality;
use crate::trace::PathQuality;

macro_rules! qualities {
    ($($name:ident: $smallest:expr, $tolerance:expr, $culling:ident, $is_precise:expr;)*) => {
        $(
            pub(crate) struct $name;

            impl LightQuality for $name {
                const IS_PRECISE: bool = $is_precise;
            }

            impl CullingQuality for $name {
                const CULLING: Culling = Culling::$culling;
            }

            impl PathQuality for $name {
                const SMALLEST_WEIGHT: Unit = $smallest;
                const TOLERANCE: Unit = $tolerance;
            }
        )*
    };
}

qualities! {
    Fast: Unit::from_bits(1 << 22), Unit::from_bits(1 << 22), ALL, false;
    Small: Unit::from_bits(1 << 22), Unit::ZERO, LISTS, false;
    Exact: Unit::DELTA, Unit::ZERO, ALL, true;
}
