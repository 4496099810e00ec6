//! Floor 7: how exact a picture is, as a type, so that the choice costs nothing while it runs.
//!
//! Each floor declares its own part of a quality; what users see joins them.

use crate::accel::{Culling, CullingQuality};
use crate::number::Unit;
use crate::shade::LightQuality;
use crate::trace::PathQuality;

/// What a frame may leave out. Choose with [`crate::FrameBuilder::quality`].
///
/// [`Fast`] and [`Fine`] are those that most need. A quality of one's own may be more exact, or less:
///
/// ```
/// use reflet::Unit;
/// use reflet::quality::{Fast, Quality};
///
/// /// As [`Fast`], but that every second pixel is traced, and no mirror is followed for less than a
/// /// sixteenth.
/// struct Calm;
///
/// impl Quality for Calm {
///     const SMALLEST_WEIGHT: Unit = Unit::from_bits(1 << 26);
///     const STRIDE: u32 = 2;
///     const TOLERANCE: Unit = Fast::TOLERANCE;
/// }
/// ```
pub trait Quality {
    /// A path ends when its weight times the brightest colour of the scene falls below this share of
    /// white: what is left out is less. In a scene without a colour brighter than white the weight
    /// itself is compared.
    const SMALLEST_WEIGHT: Unit;

    /// How many columns lie from one pixel that is traced to the next at most: 1, 2 or 4.
    ///
    /// Those between two whose paths met the same are taken from their colours if that is exact to
    /// [`Quality::TOLERANCE`]. What is narrower than a stride and met by no ray of those that are
    /// traced may be lost: the tip of a shadow, a highlight, the end of an open cylinder, a
    /// reflection in a curved mirror. Spheres seen directly or in a plane are not, up to 60 degrees
    /// from the middle of the picture; nor is anything in a scene of planes, which has a stride of 4
    /// whatever is said here, unless it is 1. Pixels that are known to meet nothing are not traced.
    const STRIDE: u32;

    /// How exactly the colours along a row must follow a curve where pixels are taken from it, as a
    /// share of white.
    ///
    /// That is: the bend of the curve changes by no more than the tolerance, or is no more than twice
    /// the tolerance where only one side of it is known; or a pixel traced half way is no further than
    /// the tolerance from it; or the colours on both sides of a single pixel differ by no more than
    /// three times the tolerance, or bend by no more than four times it.
    const TOLERANCE: Unit;

    /// Whether flash is scarcer than time; not so unless it is said.
    ///
    /// Then every ray goes the general way: every pixel is traced, whatever [`Quality::STRIDE`] says,
    /// every shape is asked, and nothing is prepared of what the pixels of a row or the lights can
    /// see, neither in flash nor in RAM.
    const IS_SMALL: bool = false;

    /// Whether near points that rays meet are rounded to the nearest step of the grid, each light on a
    /// surface is kept to 2⁻²⁶ of white, and shadows are told exactly where shapes touch. Defaults to
    /// `false`: points are rounded down to an even step, and each light to the nearest 2⁻²⁰ of white.
    /// Nothing changes where [`Quality::IS_SMALL`].
    const IS_PRECISE: bool = false;
}

/// The default: nothing that is left out is expected to change an 8-bit channel by more than a step.
///
/// A path ends when the light it can still add is less than one 8-bit level. At least every fourth pixel
/// is traced, every second where a path was mirrored in something round, and the others are exact to a
/// step, or to one and a half where only the pixels on both sides are known.
#[derive(Clone, Copy, Debug)]
pub struct Fast;

impl Quality for Fast {
    const SMALLEST_WEIGHT: Unit = Unit::from_bits(1 << 22);
    const STRIDE: u32 = 4;
    const TOLERANCE: Unit = Unit::from_bits(1 << 22);
}

/// The smallest in flash: exact as [`Fast`] or more, but without the code and the tables that make it
/// fast.
///
/// Traces every pixel. A path ends when the light it can still add is less than one 8-bit level.
#[derive(Clone, Copy, Debug)]
pub struct Small;

impl Quality for Small {
    const SMALLEST_WEIGHT: Unit = <Fast as Quality>::SMALLEST_WEIGHT;
    const STRIDE: u32 = 1;
    const TOLERANCE: Unit = Unit::ZERO;
    const IS_SMALL: bool = true;
}

/// For what is looked at closely: a path ends when its weight is exactly zero, at least every second
/// pixel is traced, and the others are exact to a quarter of an 8-bit step.
#[derive(Clone, Copy, Debug)]
pub struct Fine;

impl Quality for Fine {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const STRIDE: u32 = 2;
    const TOLERANCE: Unit = Unit::from_bits(1 << 20);
}

/// Leaves out nothing: every pixel is traced, and every path until its weight is exactly zero or the
/// frame's reflections are used up. Points and light are rounded more finely than in the others.
///
/// For scenes in which a single pixel at an edge counts, and to compare other qualities with.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl Quality for Exact {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const STRIDE: u32 = 1;
    const TOLERANCE: Unit = Unit::ZERO;
    const IS_PRECISE: bool = true;
}

impl<Q: Quality> LightQuality for Q {
    const IS_PRECISE: bool = <Q as Quality>::IS_PRECISE;
}

impl<Q: Quality> CullingQuality for Q {
    const CULLING: Culling = match Q::IS_SMALL {
        true => Culling::NONE,
        false => Culling::ALL,
    };
}

impl<Q: Quality> PathQuality for Q {
    const SMALLEST_WEIGHT: Unit = <Q as Quality>::SMALLEST_WEIGHT;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::tests::qualities;

    #[test]
    fn paths_are_tested_with_these_qualities() {
        fn known_to_paths<Q: PathQuality>() -> (Unit, Culling, bool) {
            (Q::SMALLEST_WEIGHT, Q::CULLING, Q::IS_PRECISE)
        }
        let these = [
            known_to_paths::<Fast>(),
            known_to_paths::<Small>(),
            known_to_paths::<Fine>(),
            known_to_paths::<Exact>(),
        ];
        let tested = [
            known_to_paths::<qualities::Fast>(),
            known_to_paths::<qualities::Small>(),
            known_to_paths::<qualities::Fine>(),
            known_to_paths::<qualities::Exact>(),
        ];
        assert_eq!(these, tested);
    }
}
