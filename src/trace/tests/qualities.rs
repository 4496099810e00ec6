//! The qualities of the path tests. They equal those of `render` with the same names, without the
//! fields that only `render` reads. A test there checks that.

use crate::accel::{Culling, CullingQuality};
use crate::number::Unit;
use crate::shade::LightQuality;
use crate::trace::PathQuality;

macro_rules! qualities {
    ($($name:ident: $smallest:expr, $culling:ident, $is_precise:expr;)*) => {
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
            }
        )*
    };
}

qualities! {
    Fast: Unit::from_bits(1 << 22), ALL, false;
    Small: Unit::from_bits(1 << 22), NONE, false;
    Fine: Unit::DELTA, ALL, false;
    Exact: Unit::DELTA, ALL, true;
}
