//! Random scenes without end, the same for the same seed.

use std::iter;

use proptest::prelude::RngCore;
use proptest::test_runner::{RngAlgorithm, TestRng};
use wild::Wild;

/// Number of random bytes from which a scene is made.
const BYTES: usize = 600;

/// Returns what `read` makes of random bytes: `None` where the library refuses a part.
pub fn scenes(
    seed: [u8; 32],
    read: fn(&[u8]) -> Option<Wild>,
) -> impl Iterator<Item = Option<Wild>> {
    let mut random = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut bytes = [0; BYTES];
    iter::repeat_with(move || {
        random.fill_bytes(&mut bytes);
        read(&bytes)
    })
}
