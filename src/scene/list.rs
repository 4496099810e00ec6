//! Lists of parts with a fixed capacity, filled by constant code or by a running program.

use super::capacity::Array;
use super::used;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::material::Material;
use crate::number::{to_u16, to_u32};
use crate::shape::MaterialId;

/// A list with a fixed capacity: an array, of which the first `len` items are used.
#[derive(Clone, Copy, Debug)]
pub struct List<A> {
    items: A,
    pub(super) len: usize,
}

impl<T: Copy, const N: usize> List<[T; N]> {
    /// Creates an empty list, whose unused items are `none`.
    pub(super) const fn new(none: T) -> Self {
        Self {
            items: [none; N],
            len: 0,
        }
    }

    pub(super) const fn as_slice(&self) -> &[T] {
        used(&self.items, self.len)
    }

    /// Panics with the error `too_many` if the list is full. In a constant, this stops the compiler.
    #[track_caller]
    pub(super) const fn refuse_more(&self, part: &'static str, too_many: ErrorKind) {
        if self.len == N {
            Error::at(part, self.len, too_many).stop();
        }
    }

    /// Adds an item to a list that is not full, in constant code.
    pub(super) const fn push(&mut self, item: T) {
        self.items[self.len] = item;
        self.len += 1;
    }
}

impl<const N: usize> List<[Material; N]> {
    /// Returns the number of a material, in constant code. Adds the material only if the list lacks it.
    #[track_caller]
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
    /// Adds a part at run time and returns its index.
    ///
    /// # Errors
    /// `fault`, if it is `Some`; `too_many`, if the list is full. The list is then unchanged.
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

/// Returns the identifier of the material with this index, which must be below 2¹⁶.
pub(super) const fn id(index: usize) -> MaterialId {
    MaterialId(to_u16(to_u32(index)))
}
