//! Handles: the names of parts of a scene that can be changed in place.

use core::marker::PhantomData;

use crate::number::{to_u16, to_u32};

/// Names a part of a scene that can be changed in place: a sphere for `Handle<Sphere>`.
///
/// [`RuntimeScene`](crate::RuntimeScene) returns one for each part that is added.
/// [`scene!`](crate::scene) makes a constant of each named part. A handle is an index; it does not know
/// its scene. A scene without such a part refuses it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handle<T> {
    index: u16,
    part: PhantomData<fn() -> T>,
}

impl<T> Handle<T> {
    /// Names the part with this index among those of its kind.
    pub(crate) const fn new(index: usize) -> Self {
        Self {
            index: to_u16(to_u32(index)),
            part: PhantomData,
        }
    }

    /// Finds a named part in a list of kinds and names; for [`scene!`](crate::scene).
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
mod tests {
    use super::*;
    use crate::shape::sphere::Sphere;

    #[test]
    fn named_part_has_its_index_among_its_kind() {
        const PARTS: &[(&str, &str)] = &[
            ("sphere", ""),
            ("plane", ""),
            ("disc", "LID"),
            ("sphere", "BALL"),
        ];
        assert_eq!(Handle::<Sphere>::named(PARTS, "BALL").index(), 1);
        assert_eq!(
            Handle::<crate::shape::disc::Disc>::named(PARTS, "LID").index(),
            0
        );
    }
}
