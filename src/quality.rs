//! Floor 0: how exact a picture is, as a type, so that the choice costs nothing while it runs.

use crate::number::Unit;

/// How many pixels lie from one that is always traced to the next, where those between are taken
/// from their colours if they can be.
pub(crate) const STRIDE: u32 = 4;

/// What a frame may leave out. Choose with [`crate::Frame::quality`].
pub trait Quality {
    /// A path whose weight has fallen below this is not followed further. The colour it loses is
    /// below this weight times the brightest colour of the scene.
    const SMALLEST_WEIGHT: Unit;

    /// Whether pixels between two whose paths went alike are taken from their colours.
    const INTERPOLATES: bool;
}

/// The default: a path ends when it can no longer change an 8-bit channel by more than a step
/// (weights below 1/256, for colours up to one).
#[derive(Clone, Copy, Debug)]
pub struct Fast;

impl Quality for Fast {
    const SMALLEST_WEIGHT: Unit = Unit::from_bits(1 << 22);
    const INTERPOLATES: bool = true;
}

/// Leaves nothing out: a path ends when its weight is exactly zero.
#[derive(Clone, Copy, Debug)]
pub struct Fine;

impl Quality for Fine {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const INTERPOLATES: bool = false;
}
