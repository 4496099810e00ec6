//! A list of parts with a fixed room, which the compiler can fill as well as a program.

use super::capacity::Array;
use super::used;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::material::Material;
use crate::number::{to_u16, to_u32};
use crate::shape::MaterialId;

/// The first items of an array.
#[derive(Clone, Copy, Debug)]
pub struct List<A> {
    items: A,
    pub(super) len: usize,
}

impl<T: Copy, const N: usize> List<[T; N]> {
    /// Nothing, in a room that is filled with something.
    pub(super) const fn new(none: T) -> Self {
        Self {
            items: [none; N],
            len: 0,
        }
    }

    pub(super) const fn as_slice(&self) -> &[T] {
        used(&self.items, self.len)
    }

    /// Stops the compiler unless there is room for another item.
    pub(super) const fn refuse_more(&self, part: &'static str, too_many: ErrorKind) {
        if self.len == N {
            Error::at(part, self.len, too_many).stop();
        }
    }

    /// Adds an item where there is room for it; for constants.
    pub(super) const fn push(&mut self, item: T) {
        self.items[self.len] = item;
        self.len += 1;
    }
}

impl<const N: usize> List<[Material; N]> {
    /// The number of a material, which is kept once however often it is used; for constants.
    pub(super) const fn id_of(&mut self, material: Material) -> MaterialId {
        let mut index = 0;
        while index < self.len {
            if self.items[index].same(&material) {
                return id(index);
            }
            index += 1;
        }
        self.refuse_more("material", ErrorKind::TooManyMaterials);
        self.push(material);
        id(index)
    }
}

impl<A> List<A> {
    /// Adds a part that has no fault and for which there is room.
    pub(super) fn add<T>(
        &mut self,
        part: T,
        fault: Option<ErrorKind>,
        name: &'static str,
        too_many: ErrorKind,
    ) -> Result<usize, Error>
    where
        A: Array<T>,
    {
        let index = self.len;
        if let Some(fault) = fault {
            return Err(Error::at(name, index, fault));
        }
        let free = self.items.as_mut().get_mut(index);
        *free.ok_or(Error::at(name, index, too_many))? = part;
        self.len += 1;
        Ok(index)
    }
}

/// Names the material with a number, which is below 2¹⁶.
pub(super) const fn id(index: usize) -> MaterialId {
    MaterialId(to_u16(to_u32(index)))
}
