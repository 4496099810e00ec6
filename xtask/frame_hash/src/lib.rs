//! Hash by which frames of different machines are compared: FNV-1a with 64 bits, over the RGB8
//! bytes, row by row from the top.
//!
//! It is small and has no tables, so that it runs on every core. It is no cryptographic hash.
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

/// FNV-1a hash of a frame, to which pixels are added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameHash(u64);

impl FrameHash {
    /// The hash of no bytes.
    pub const NONE: Self = Self(0xcbf2_9ce4_8422_2325);

    /// Adds the bytes of one pixel.
    ///
    /// ```
    /// use frame_hash::FrameHash;
    ///
    /// let mut hash = FrameHash::NONE;
    /// hash.add(*b"foo");
    /// hash.add(*b"bar");
    /// assert_eq!(hash.value(), 0x8594_4171_f739_67e8); // published for "foobar"
    /// ```
    pub fn add(&mut self, pixel: [u8; 3]) {
        for byte in pixel {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// Returns the hash of these pixels.
    pub fn of(pixels: impl IntoIterator<Item = [u8; 3]>) -> u64 {
        let mut hash = Self::NONE;
        pixels.into_iter().for_each(|pixel| hash.add(pixel));
        hash.value()
    }

    /// Returns the hash of all bytes added so far.
    pub const fn value(self) -> u64 {
        self.0
    }
}
