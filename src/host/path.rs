//! What the path of a pixel meets, step by step, and what each surface adds to the pixel's colour. The colours are those
//! that the quality `Exact` computes; this file only converts them to doubles, which loses no bit.

use alloc::vec::Vec;

use crate::accel::any_scene::AnyScene;
use crate::color::{Color, Sum};
use crate::number::{Brightness, Number, Unit, power_of_two};
use crate::qualities::Exact;
use crate::ray::ScaledPoint;
use crate::render::Rows;
use crate::scene::access::{KIND_NAMES, Parts, SceneAccess, ShapeId};
use crate::shade::Shading;
pub use crate::trace::End;
use crate::trace::{Met, Walked};

/// The path of a pixel: c = Σᵢ (1 − αᵢ) · (Π over k < i of αₖ) · cᵢ, term by term. [`path_of`] returns it.
///
/// All colours are linear; white is `[1.0; 3]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The surfaces that the path meets, in order.
    pub steps: Vec<Step>,
    /// Directions of the rays: that of the camera, then one for each reflection. Their lengths are one to within
    /// 2⁻²⁶. A ray that surely meets nothing is not followed and has none.
    pub rays: Vec<[f64; 3]>,
    /// The reason why the path ends.
    pub end: End,
    /// Colour of the background that the last ray shows, if it hits nothing. Its weight is that after the
    /// last step.
    pub background: Option<[f64; 3]>,
    /// Colour of the pixel, before it is clamped and rounded.
    pub sum: [f64; 3],
    /// Red, green and blue that `Exact` draws.
    pub pixel: [u8; 3],
    /// Largest component of any colour that a path of this scene can meet.
    pub brightest: f64,
}

/// A surface on the path of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Kind of the shape, such as `sphere`.
    pub kind: &'static str,
    /// Index of the shape among those of its kind.
    pub index: usize,
    /// Index of the material of the shape.
    pub material: usize,
    /// Whether the ray meets the shape from inside, or a plane against its normal.
    pub is_inside: bool,
    /// Share αᵢ of the light that the surface mirrors.
    pub alpha: f64,
    /// Weight of the path before the surface: Π over k < i of αₖ.
    pub weight: f64,
    /// Weight of the path after the surface.
    pub weight_after: f64,
    /// Colour cᵢ of the surface without reflections; black for a perfect mirror, which has no colour of its own.
    pub color: [f64; 3],
    /// Indices of the lights that shine on the surface; empty for a perfect mirror. Of more than 32 lights, light 32
    /// is listed as light 0, light 33 as light 1, and so on.
    pub lights: Vec<usize>,
    /// Sum of the path up to this surface.
    pub sum: [f64; 3],
    /// Upper bound of what the path after this surface can add to a component of the pixel's colour:
    /// `weight_after` times [`Path::brightest`].
    pub bound: f64,
    /// The point where the ray starts that meets the surface, in scene units.
    pub from: [f64; 3],
    /// The point where rays leave the surface: epsilon above it, in scene units.
    pub to: [f64; 3],
}

/// Returns the path of pixel (`x`, `y`), as `Exact` computes it. `None` outside of the picture.
///
/// ```
/// use embedded_graphics::prelude::Size;
/// use reflet::host::path::{End, path_of};
/// use reflet::quality::Exact;
/// use reflet::{Camera, Material, scene};
///
/// const GLASS: Material = Material::new([1.0, 0.5, 0.0]).ambient(1.0).mirror(0.5);
/// scene! {
///     struct Floor {
///         plane([0.0; 3], [0.0, 0.0, 1.0], GLASS);
///         background([0.0, 0.0, 1.0]);
///     }
/// }
///
/// let camera = Camera::look_at([0.0, 0.0, 2.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
/// let frame = Floor::frame(&camera).quality::<Exact>().prepare(Size::new(1, 1));
/// let path = path_of(&frame.on(&Floor)?, (0, 0)).unwrap();
/// let step = &path.steps[0];
/// assert_eq!((step.kind, step.index, step.alpha, step.weight), ("plane", 0, 0.5, 1.0));
/// assert_eq!((path.end, path.pixel), (End::Missed, [128, 64, 128]));
/// // The camera's ray. Nothing is above the floor, so no mirrored ray is followed.
/// assert_eq!(path.rays, [[0.0, 0.0, -1.0]]);
/// # Ok::<(), reflet::Error>(())
/// ```
pub fn path_of<S: AnyScene, K: Shading>(
    rows: &Rows<'_, S, Exact, K>,
    (x, y): (u32, u32),
) -> Option<Path> {
    let [width, height] = rows.sides();
    let is_inside = x < width && y < height;
    is_inside.then(|| paths(rows, y, x, x + 1).pop()).flatten()
}

/// Returns the paths of all pixels of row `y`, from the left; none below the picture.
///
/// ```
/// use embedded_graphics::prelude::Size;
/// use reflet::host::path::{path_of, paths_of_row};
/// use reflet::quality::Exact;
/// use reflet::scenes::{BuiltIn, Mirror2};
///
/// let frame = Mirror2::frame(&Mirror2::CAMERA).quality::<Exact>().prepare(Size::new(16, 12));
/// let rows = frame.on(&Mirror2)?;
/// let paths = paths_of_row(&rows, 6);
/// assert_eq!(paths.len(), 16);
/// assert_eq!(Some(&paths[3]), path_of(&rows, (3, 6)).as_ref());
/// # Ok::<(), reflet::Error>(())
/// ```
pub fn paths_of_row<S: AnyScene, K: Shading>(rows: &Rows<'_, S, Exact, K>, y: u32) -> Vec<Path> {
    let [width, height] = rows.sides();
    if y < height { paths(rows, y, 0, width) } else { Vec::new() }
}

/// Returns the paths of the columns from `first` to the one before `end` of a row.
fn paths<S: AnyScene, K: Shading>(
    rows: &Rows<'_, S, Exact, K>,
    y: u32,
    first: u32,
    end: u32,
) -> Vec<Path> {
    match rows.walk(y, first..end) {
        Some(walked) => walked.iter().map(|it| path(rows.world(), it)).collect(),
        None => vec![empty(rows); (end - first) as usize],
    }
}

/// Returns the path of every pixel in a scene without shapes and without a sky.
fn empty<S: AnyScene, K: Shading>(rows: &Rows<'_, S, Exact, K>) -> Path {
    let sum = rows.only_sum().unwrap_or(Sum::DARK);
    let walked = Walked {
        steps: Vec::new(),
        rays: Vec::new(),
        end: End::Missed,
        missed: None,
        sum,
    };
    let mut path = path(rows.world(), &walked);
    path.background = Some(path.sum);
    path
}

fn path<W: SceneAccess>(world: &W, walked: &Walked) -> Path {
    Path {
        steps: walked.steps.iter().map(|it| step(world, it)).collect(),
        rays: walked
            .rays
            .iter()
            .map(|it| it.components().map(Unit::to_num))
            .collect(),
        end: walked.end,
        background: walked.missed.map(shares),
        sum: shares_of(walked.sum),
        pixel: walked.sum.to_rgb8(),
        brightest: share(world.parts().brightest),
    }
}

fn step<W: SceneAccess>(world: &W, met: &Met) -> Step {
    let parts = world.parts();
    let (kind, index) = shape_of(&parts, met.shape);
    let [weight, weight_after] = met.throughput.map(Unit::to_num::<f64>);
    let shines = |light: &usize| met.lights >> light & 1 == 1;
    Step {
        kind,
        index,
        material: parts.material_of(met.shape).map_or(0, |it| it.index()),
        is_inside: met.is_inside,
        alpha: met.mirror.to_num(),
        weight,
        weight_after,
        color: shares(met.color),
        lights: (0..parts.lights.len().min(32)).filter(shines).collect(),
        sum: shares_of(met.sum),
        bound: weight_after * share(parts.brightest),
        from: place_of(world, met.from),
        to: place_of(world, met.to),
    }
}

/// Shares of white from colours of the core, where white is 255/256.
const SCALE: f64 = 256.0 / 255.0;

/// Converts a component of a colour to a share of white.
fn share(brightness: Brightness) -> f64 {
    brightness.to_num::<f64>() * SCALE
}

/// Converts a colour to shares of white.
fn shares(color: Color) -> [f64; 3] {
    color.components().map(share)
}

/// Converts the sum of a path to shares of white.
fn shares_of(sum: Sum) -> [f64; 3] {
    let step = SCALE / f64::from(1 << 24);
    sum.to_bits().map(|bits| f64::from(bits) * step)
}

/// Converts a point to scene units.
fn place_of<W: SceneAccess>(world: &W, ScaledPoint { point, scale }: ScaledPoint) -> [f64; 3] {
    let grid = world.parts().grid;
    let step = power_of_two(scale as i32 - grid.fraction_bits());
    let middle = grid.middle().0.map(Number::to_f64);
    let steps = [point.x, point.y, point.z];
    [0, 1, 2].map(|axis| middle[axis] + f64::from(steps[axis]) * step)
}

/// Returns the kind of a shape, and its index among those of its kind.
fn shape_of(parts: &Parts<'_>, shape: ShapeId) -> (&'static str, usize) {
    let mut index = shape.index();
    for (kind, length) in KIND_NAMES.iter().zip(parts.lengths()) {
        if index < length {
            return (kind, index);
        }
        index -= length;
    }
    ("plane", index)
}

#[cfg(all(feature = "host", feature = "scenes"))]
#[cfg(test)]
mod tests;
