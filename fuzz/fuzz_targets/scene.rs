//! Any bytes as a scene and a camera: the picture is drawn, or the scene refused.
#![no_main]

use libfuzzer_sys::{Corpus, fuzz_target};
use wild::Wild;

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let ranged = Wild::read_with_ranges(bytes).and_then(|wild| wild.draw());
    match Wild::read(bytes).and_then(|wild| wild.draw()).or(ranged) {
        Some(_) => Corpus::Keep,
        None => Corpus::Reject,
    }
});
