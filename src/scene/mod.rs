//! Floor 3: the bounded scene, checked and prepared once when it is built, and the two questions
//! a ray asks it ([`query`]): what it hits first, and whether a light is occluded.
//!
//! A scene is laid on a grid of its own: its shapes fill a ball of 2²⁸ steps, whatever their size
//! in scene units, so the binary point is never the user's concern.

pub(crate) mod access;
mod brightness;
mod builder;
mod capacity;
mod description;
pub(crate) mod far;
#[cfg(test)]
mod fixture;
pub(crate) mod handle;
mod layout;
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
pub(crate) use needs::FEW;
pub use needs::{Mirrors, MostReflections, Need, Needs, NeedsLimit, Shininess};
pub(crate) use prepare::PlainScene;
pub use runtime::RuntimeScene;
pub(crate) use surface::Surface;

/// The first `count` items; all of them, rather than a panic, should there be fewer.
#[inline(always)]
pub(crate) const fn used<T>(items: &[T], count: usize) -> &[T] {
    match items.split_at_checked(count) {
        Some((used, _)) => used,
        None => items,
    }
}
