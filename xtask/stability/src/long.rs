//! Draws random scenes for a long time, with every overflow checked.

use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use stability::random;
use wild::Wild;

use crate::{Failure, print};

/// Factor on width and height of the fuzzer's pictures, because rays are wanted more than scenes.
const LARGER: u32 = 8;

/// Draws random scenes until this many rays have been followed. Fails without overflow checks.
pub fn run(rays: u64, seed: u64) -> Result<bool, Failure> {
    if !cfg!(debug_assertions) {
        let call = "cargo run --profile checked --package stability -- --rays N";
        return Err(format!("--rays needs every overflow checked: {call}").into());
    }
    let start = Instant::now();
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let bar = ProgressBar::new(rays).with_style(ProgressStyle::with_template(
        "{wide_bar} {percent:>3} % {eta:>4}",
    )?);
    let (mut followed, mut scenes, mut refused) = (0, 0_u64, 0_u64);
    let mut random = random::scenes(bytes, Wild::read);
    while followed < rays {
        let drawn = random.next().flatten().and_then(|mut wild| {
            wild.size *= LARGER;
            wild.draw()
        });
        match drawn {
            Some(rays) => {
                scenes += 1;
                followed += rays;
                bar.set_position(followed);
            }
            None => refused += 1,
        }
    }
    bar.finish_and_clear();
    print(&format!(
        "{followed} rays in {scenes} random scenes ({refused} refused), every overflow of sums, \
         products and shifts checked: none, no panic. Seed {seed}, {:.0} s",
        start.elapsed().as_secs_f64()
    ));
    Ok(true)
}
