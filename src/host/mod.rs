//! What only a desktop needs, beside the stack and never under it: the double-precision
//! reference, the comparison of pictures, scene files, and where a ray goes.

#[macro_use]
mod shapes;

pub mod compare;
pub mod file;
pub mod line;
mod painted;
pub mod path;
pub mod reference;

pub use self::painted::painted;

use crate::number::Number;
use crate::scene::access::SceneAccess;

/// The grid that a scene was laid on and how dim it is, as the analysis of rounding wants it.
pub fn precision(world: &impl SceneAccess) -> reference::bound::Precision {
    let grid = world.parts().grid;
    reference::bound::Precision {
        step: f64::exp2(f64::from(-grid.fraction_bits())),
        middle: grid.middle().0.map(Number::to_f64),
        dimness: world.parts().dimness.to_num(),
    }
}
