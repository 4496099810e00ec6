//! Tools for the desktop: the double-precision reference, picture comparison, scene files, and the path
//! of one pixel. This module uses the ray tracer; the ray tracer never uses this module.
//!
//! The feature `files` has scene files ([`mod@file`]), the descriptions that they are read into
//! ([`mod@reference`]) and the path of a pixel ([`path`]). It needs `alloc`, so that a page of a
//! browser can use it, too. The feature `host` adds the rest and needs `std`.

#[macro_use]
mod shapes;

#[cfg(feature = "host")]
pub mod compare;
pub mod file;
pub mod line;
#[cfg(feature = "host")]
mod painted;
pub mod path;
pub mod reference;

#[cfg(feature = "host")]
pub use self::painted::painted;

#[cfg(feature = "host")]
use crate::number::Number;
#[cfg(feature = "host")]
use crate::scene::access::SceneAccess;

/// Returns the facts about a prepared scene that the rounding analysis needs: the step and the middle of
/// its grid, in scene units, and its dimness.
///
/// ```
/// use reflet::host::precision;
/// use reflet::{Material, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let chalk = scene.add_material(Material::new([0.9; 3]))?;
/// scene.add_sphere([3, 0, 0], 1, chalk)?;
/// let grid = precision(&scene.build()?);
/// assert_eq!((grid.step, grid.middle, grid.dimness), (2f64.powi(-28), [3.0, 0.0, 0.0], 1.0));
/// # Ok::<(), reflet::Error>(())
/// ```
#[cfg(feature = "host")]
pub fn precision(world: &impl SceneAccess) -> reference::bound::Precision {
    let grid = world.parts().grid;
    reference::bound::Precision {
        step: f64::exp2(f64::from(-grid.fraction_bits())),
        middle: grid.middle().0.map(Number::to_f64),
        dimness: world.parts().dimness.to_num(),
    }
}
