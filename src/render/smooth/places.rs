//! Floor 7: where a pixel is sampled.

use crate::number::to_u32;

/// Side of a pixel, in the steps of a [`Place`].
pub(super) const PIXEL: i32 = 64;

/// How far a point of a pixel lies to the right of the upper left corner, and below it, in 64ths of a pixel.
pub(super) type Place = [i32; 2];

/// The centre of a pixel.
pub(super) const CENTER: &[Place] = &[[32, 32]];

/// Two, four, eight and sixteen places. No two of a set share a column or a row. Of all such sets that are alike when
/// turned half round, these have about the least error for straight edges at any place and angle.
const SETS: [&[Place]; 4] = [
    &[[53, 21], [11, 43]],
    &[[19, 13], [58, 26], [6, 38], [45, 51]],
    &[
        [53, 7],
        [18, 14],
        [39, 21],
        [4, 28],
        [60, 36],
        [25, 43],
        [46, 50],
        [11, 57],
    ],
    MOST,
];

/// The largest set.
const MOST: &[Place] = &[
    [55, 4],
    [13, 8],
    [43, 11],
    [24, 15],
    [2, 19],
    [58, 23],
    [36, 26],
    [17, 30],
    [47, 34],
    [28, 38],
    [6, 41],
    [62, 45],
    [40, 49],
    [21, 53],
    [51, 56],
    [9, 60],
];

/// Returns the fewest places of which each stands for at most `tolerance` of a contrast, both in 8-bit levels; the most if
/// none are enough.
pub(super) fn enough(contrast: u32, tolerance: u32) -> &'static [Place] {
    let is_enough = |places: &&&[Place]| to_u32(places.len()) * tolerance >= contrast;
    SETS.iter().find(is_enough).unwrap_or(&MOST)
}
