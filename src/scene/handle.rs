//! Handles: typed indices of the parts of a scene that can be moved.

use core::marker::PhantomData;

use crate::number::{to_u16, to_u32};

/// The name of a part that can be moved in its scene: `Handle<Sphere>` names a sphere.
///
/// [`RuntimeScene`](crate::RuntimeScene) returns a handle for each part that can be moved.
/// [`scene!`](crate::scene) declares a constant for each named part. A handle holds an index, but no
/// reference to its scene. A scene that has no such part refuses the handle.
///
/// ```
/// use reflet::description::Sphere;
/// use reflet::{ErrorKind, Handle, Material, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(spheres: 2)>::new();
/// scene.set_motion([-2, -2, -2], [2, 2, 2])?;
/// let chalk = scene.add_material(Material::new([0.9; 3]))?;
/// scene.add_sphere([0, 0, 0], 1, chalk)?;
/// let mut one = scene.build()?;
/// let second: Handle<Sphere> = scene.add_sphere([1, 0, 0], 1, chalk)?;
/// assert_eq!(second.index(), 1);
///
/// let mut two = scene.build()?;
/// two.set_sphere(second, [-1, 0, 0], 1)?;
/// let refused = one.set_sphere(second, [-1, 0, 0], 1);
/// assert_eq!(refused.unwrap_err().kind(), ErrorKind::UnknownHandle);
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handle<T> {
    index: u16,
    part: PhantomData<fn() -> T>,
}

impl<T> Handle<T> {
    /// Creates the handle of the part with this index among those of its kind.
    pub(crate) const fn new(index: usize) -> Self {
        Self {
            index: to_u16(to_u32(index)),
            part: PhantomData,
        }
    }

    /// Returns the handle of the part called `name` in a list of kinds and names, for
    /// [`scene!`](crate::scene).
    #[doc(hidden)]
    pub const fn named(parts: &[(&str, &str)], name: &str) -> Self {
        let mut named = 0;
        while named < parts.len() && !super::capacity::is_same(parts[named].1, name) {
            named += 1;
        }
        let (mut index, mut part) = (0, 0);
        while part < named {
            if super::capacity::is_same(parts[part].0, parts[named].0) {
                index += 1;
            }
            part += 1;
        }
        Self::new(index)
    }

    /// Returns the index of the part among those of its kind, counted from 0.
    pub const fn index(self) -> usize {
        self.index as usize
    }
}

#[cfg(test)]
mod tests;
