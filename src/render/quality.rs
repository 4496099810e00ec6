//! Floor 7: qualities: types that say how exact a picture is. The choice costs no time while a frame is
//! drawn.
//!
//! Each floor declares its own part of a quality. [`Quality`] joins them for users.

use core::marker::PhantomData;

use crate::accel::{Culling, CullingQuality};
use crate::number::Unit;
use crate::shade::LightQuality;
use crate::trace::PathQuality;

/// A quality: how exact a frame is, as a type. [`FrameBuilder::quality`](crate::FrameBuilder::quality)
/// sets it.
///
/// [`Fast`] suits most programs. A type of your own may be more exact, or less:
///
/// ```
/// use reflet::Unit;
/// use reflet::quality::Quality;
///
/// /// As [`Fast`], but every pixel is traced, and no mirror is followed for less than a sixteenth.
/// struct Calm;
///
/// impl Quality for Calm {
///     const SMALLEST_WEIGHT: Unit = Unit::from_bits(1 << 26);
///     const TOLERANCE: Unit = Unit::ZERO;
/// }
/// assert!(!Calm::IS_SMALL && !Calm::IS_PRECISE);
/// ```
pub trait Quality {
    /// Smallest contribution that a path is followed for, as a share of white, 0 to 1.
    ///
    /// A path ends when its throughput times the brightest colour of the scene falls below this share,
    /// so the light left out is less. If no colour of the scene is brighter than white, the throughput
    /// itself is compared.
    const SMALLEST_WEIGHT: Unit;

    /// Tolerance of interpolated pixels, as a share of white, 0 to 1. If it is 0, every pixel is traced.
    ///
    /// A pixel is interpolated only if its path is certain to meet the same shapes, lit by the same lights, as two
    /// traced pixels beside it: no shape, shadow or highlight is lost, however thin. The tolerance bounds by how much
    /// the colours of traced pixels may differ from a parabola.
    const TOLERANCE: Unit;

    /// Whether frames leave out most code and tables for speed, to save flash. Defaults to `false`.
    ///
    /// If `true`, every pixel is traced, whatever [`Quality::TOLERANCE`] says. Only short lists say which
    /// shapes a row of pixels can show, and which lie in each direction from a light of a constant scene.
    /// They take a few hundred bytes.
    const IS_SMALL: bool = false;

    /// Whether points and light are rounded more finely, and shadows are exact where shapes touch.
    /// Defaults to `false`.
    ///
    /// If `true`, near hit points are rounded to the nearest step of the grid, and the light of each
    /// lamp on a surface to 2⁻²⁶ of white. If `false`, points are rounded down to an even step, and
    /// light to the nearest 2⁻²⁰ of white. The constant has no effect if [`Quality::IS_SMALL`] is
    /// `true`.
    const IS_PRECISE: bool = false;

    /// How smooth edges are: 1, 2 or 4. Defaults to 1: they are jagged. [`Smooth`] sets it.
    const SMOOTHNESS: u32 = 1;
}

/// A quality with smooth edges: each pixel is the mean of what its area shows, as far as the corners of pixels tell. `K` is 2
/// or 4. With 4, edges are found more finely, and rows that show shapes thinner than four pixels have twice as many
/// corners.
///
/// Each colour is clamped to 0 to 1, then the mean is taken, then it is rounded. `Q` says how exact a colour is. It needs no
/// frame buffer. Rows that are asked for one by one take a [`Seam`](crate::quality::Seam) along, or about twice the time.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use reflet::quality::{Fast, Smooth};
/// use reflet::scenes::{BuiltIn, Mirror1};
///
/// let size = Size::new(64, 64);
/// let jagged = Mirror1::frame(&Mirror1::CAMERA).prepare(size);
/// let smooth = Mirror1::frame(&Mirror1::CAMERA).quality::<Smooth<2, Fast>>().prepare(size);
/// let mut rows = [[Rgb888::BLACK; 64]; 2];
/// let one = jagged.on(&Mirror1)?.row(32, 0, &mut rows[0]);
/// let other = smooth.on(&Mirror1)?.row(32, 0, &mut rows[1]);
/// assert!(rows[0] != rows[1] && other.rays > one.rays);
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Smooth<const K: u32, Q = Fast>(PhantomData<Q>);

impl<const K: u32, Q: Quality> Quality for Smooth<K, Q> {
    const SMALLEST_WEIGHT: Unit = Q::SMALLEST_WEIGHT;
    const TOLERANCE: Unit = Q::TOLERANCE;
    const IS_SMALL: bool = Q::IS_SMALL;
    const IS_PRECISE: bool = Q::IS_PRECISE;
    const SMOOTHNESS: u32 = {
        assert!(K == 2 || K == 4, "K of Smooth<K> is 2 or 4");
        K
    };
}

/// The default quality: the approximations are expected to change an 8-bit channel by at most one level.
///
/// A path ends when the light it can still add is less than one 8-bit level. Pixels are interpolated to about
/// one level where it is certain what they show.
#[derive(Clone, Copy, Debug)]
pub struct Fast;

impl Quality for Fast {
    const SMALLEST_WEIGHT: Unit = Unit::from_bits(1 << 22);
    const TOLERANCE: Unit = Unit::from_bits(1 << 22);
}

/// The quality that takes the least flash: at least as exact as [`Fast`], but without most of the code and
/// the tables for speed.
///
/// Every pixel is traced. Short lists leave out shapes that a ray cannot hit. A path ends when the light
/// it can still add is less than one 8-bit level.
#[derive(Clone, Copy, Debug)]
pub struct Small;

impl Quality for Small {
    const SMALLEST_WEIGHT: Unit = <Fast as Quality>::SMALLEST_WEIGHT;
    const TOLERANCE: Unit = Unit::ZERO;
    const IS_SMALL: bool = true;
}

/// The most exact quality: every pixel is traced, and points and light are rounded more finely than in
/// the other qualities.
///
/// A path ends when its throughput is exactly zero or the reflections of the frame are used up. Use it
/// for scenes in which a single pixel at an edge matters, and to compare other qualities with.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl Quality for Exact {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const TOLERANCE: Unit = Unit::ZERO;
    const IS_PRECISE: bool = true;
}

impl<Q: Quality> LightQuality for Q {
    const IS_PRECISE: bool = <Q as Quality>::IS_PRECISE;
}

impl<Q: Quality> CullingQuality for Q {
    const CULLING: Culling = match Q::IS_SMALL {
        true => Culling::LISTS,
        false => Culling::ALL,
    };
}

impl<Q: Quality> PathQuality for Q {
    const SMALLEST_WEIGHT: Unit = <Q as Quality>::SMALLEST_WEIGHT;
    const TOLERANCE: Unit = <Q as Quality>::TOLERANCE;
}

#[cfg(test)]
mod tests;
