//! Floor 2: qualities: types that say how exact a picture is. The choice costs no time while a frame is drawn.

use core::marker::PhantomData;

use crate::number::Unit;

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

    /// Culling techniques that frames of this quality use.
    #[doc(hidden)]
    const CULLING: Culling = if Self::IS_SMALL { Culling::LISTS } else { Culling::ALL };
}

/// Switches of the culling techniques.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Culling {
    /// Whether the shapes are prepared for the views from the camera and from the lights: camera rays test only those whose
    /// [`screen_bounds`](crate::accel::screen_bounds) contain the pixel, and shadows are computed from the light's side ([`light_occluders`](crate::accel::light_occluders),
    /// [`light_visibility`](crate::accel::light_visibility)).
    pub(crate) views: bool,
    /// Whether shadow rays test only the shapes that [`light_table`](crate::accel::light_table) lists for their direction.
    pub(crate) light_tables: bool,
    /// Whether rays that no table covers test only the shapes in the balls of the [`hierarchy`](crate::accel::hierarchy) that they
    /// meet.
    pub(crate) hierarchy: bool,
    /// Whether the plain path tests only the shapes that a row can show ([`row_list`](crate::accel::row_list)) and those in a
    /// light's direction ([`light_lists`](crate::accel::light_lists)). Techniques above replace it.
    pub(crate) lists: bool,
}

impl Culling {
    /// Switches with every technique on.
    pub(crate) const ALL: Self = Self {
        views: true,
        light_tables: true,
        hierarchy: true,
        lists: false,
    };

    /// Switches with every technique off: the plain path, which tests every shape.
    pub(crate) const NONE: Self = Self {
        views: false,
        light_tables: false,
        hierarchy: false,
        lists: false,
    };

    /// Switches of the plain path with its lists of candidates.
    pub(crate) const LISTS: Self = Self {
        lists: true,
        ..Self::NONE
    };

    /// Tests whether a technique is on that replaces the plain path. The lists do not.
    pub(crate) const fn is_any(self) -> bool {
        self.views || self.light_tables || self.hierarchy
    }
}

/// A quality with smooth edges: each pixel is the mean of what its area shows, as far as the corners of pixels tell. `K` is 2
/// or 4. With 4, edges are found more finely. Rows that show shapes thinner than four pixels have twice as many corners.
///
/// The colours of a checker's cells are mixed by their shares of what a pixel shows, in mirrors too.
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
    const SMALLEST_WEIGHT: Unit = Fast::SMALLEST_WEIGHT;
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
