//! Floor 3: scenes: their description, checks and preparation, and the two queries of a ray ([`query`]):
//! the nearest hit, and whether a light is occluded.
//!
//! Each scene has a grid of its own. Its shapes fill a ball of 2²⁸ steps, whatever their size in scene
//! units, so users never choose a binary point.

#[macro_use]
pub(crate) mod access;
mod beyond;
mod brightness;
mod builder;
mod capacity;
mod description;
pub(crate) mod far;
#[cfg(test)]
mod fixture;
pub(crate) mod handle;
mod layout;
mod lights;
mod list;
mod macros;
mod motion;
pub(crate) mod nearest;
mod needs;
pub(crate) mod planes;
mod prepare;
pub(crate) mod query;
mod runtime;
pub(crate) mod shape_set;
pub(crate) mod surface;

pub(crate) use access::Parts;
pub use builder::SceneBuilder;
#[cfg(test)]
pub(crate) use builder::tests as built;
pub(crate) use capacity::Array;
pub use capacity::{Capacity, Counts, Room};
pub use description::Description;
pub use handle::Handle;
pub use macros::{SceneLines, described};
pub(crate) use needs::FEW;
pub use needs::{Mirrors, MostReflections, Need, Needs, NeedsLimit, Shininess};
pub(crate) use prepare::PlainScene;
#[cfg(feature = "files")]
pub(crate) use prepare::extent_of;
pub use runtime::RuntimeScene;
pub(crate) use surface::Surface;

/// Returns the first `count` items, or all items if there are fewer. Never panics.
#[inline(always)]
pub(crate) const fn used<T>(items: &[T], count: usize) -> &[T] {
    match items.split_at_checked(count) {
        Some((used, _)) => used,
        None => items,
    }
}
