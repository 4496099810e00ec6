//! The rays that the fixed-point core follows through one pixel, and the path of a pixel step by step, converted to
//! doubles. This file knows no colours.

mod steps;

pub use self::steps::{End, Path, Step, path_of, paths_of_row};

use alloc::vec::Vec;

use crate::accel::drawable::Drawable;
use crate::camera::Camera;
use crate::number::{Number, power_of_two};
use crate::ray::{ScaledPoint, ScaledRay};
use crate::scene::Surface;
use crate::scene::access::{KIND_NAMES, Parts, SceneAccess, ShapeId};
use crate::scene::query::nearest_hit;

/// A ray of the fixed-point core, converted to doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Point where the ray starts, in scene units.
    pub origin: [f64; 3],
    /// Direction of the ray. Its length is one to within 2⁻²⁶.
    pub direction: [f64; 3],
}

/// Returns the rays that the core follows through pixel (`x`, `y`): the camera ray, then one ray for
/// each reflection, at most `reflections` of them.
///
/// Every surface counts as a mirror, whatever its material. A reflected ray starts epsilon above the
/// surface that was hit. The list ends at the first ray that hits nothing.
///
/// ```
/// use reflet::host::path::{Ray, follow};
/// use reflet::{Camera, Material, scene};
///
/// const GLASS: Material = Material::new([1.0; 3]).mirror(1.0);
/// scene! {
///     struct Floor {
///         plane([0.0; 3], [0.0, 0.0, 1.0], GLASS);
///     }
/// }
///
/// let camera = Camera::look_at([0.0, 0.0, 2.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
/// let rays = follow(&Floor, &camera, (1, 1), (0, 0), 9);
/// assert_eq!(rays[0], Ray { origin: [0.0, 0.0, 2.0], direction: [0.0, 0.0, -1.0] });
/// assert_eq!(rays.len(), 2);
/// assert_eq!(rays[1].direction, [0.0, 0.0, 1.0]);
/// // Two steps of the scene's grid, 2^-20 each.
/// assert!((rays[1].origin[2] - 1e-3).abs() <= 2.0 / f64::from(1 << 20));
/// ```
pub fn follow<S: Drawable>(
    scene: &S,
    camera: &Camera,
    (width, height): (u32, u32),
    (x, y): (u32, u32),
    reflections: u32,
) -> Vec<Ray> {
    let world = &scene.world();
    let grid = world.parts().grid;
    let from = grid.place(camera.description().position);
    let direction = camera.generator(width, height).row(y).of(x);
    let mut path = ScaledRay::new(from, direction);
    let mut left = ShapeId::NONE;
    let mut rays = vec![plain(world, &path)];
    for _ in 0..reflections {
        let hit = nearest_hit(world, &path, left);
        let Some((at, shape)) = hit else {
            break;
        };
        let Some(surface) = Surface::new(world, at, shape, path.direction()) else {
            break;
        };
        surface.reflect(world, &mut path);
        left = surface.skip(world);
        rays.push(plain(world, &path));
    }
    rays
}

fn plain<W: SceneAccess>(world: &W, path: &ScaledRay) -> Ray {
    let units = path.direction().components();
    Ray {
        origin: place_of(world, path.from()),
        direction: units.map(|unit| unit.to_num()),
    }
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
