//! Renders one pixel or a whole picture of the reference, with all threads. This file knows nothing of
//! lights.

use std::vec::Vec;

use rayon::prelude::*;

use super::model::{Vector, View, quantised};
use super::prepared::{self, Prepared};
use super::{Camera, Scene, Shading, trace};

/// A picture with three channels of 8 bits for each pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Number of pixels in a row.
    pub width: u32,
    /// Height of the picture in pixels.
    pub height: u32,
    /// Red, green and blue of `width` × `height` pixels, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
}

/// Returns the linear colour of one pixel, before it is clamped and rounded: column `x`, row `y` from
/// the top, of a picture of `width` × `height`.
///
/// The path ends after `reflections` reflections, and light beyond them counts as black. Any number is
/// allowed; each reflection on the path takes 32 bytes until the pixel is done.
///
/// # Panics
///
/// A shape names a material that the scene does not have.
///
/// ```
/// use reflet::host::reference::{Camera, Scene, Shading, pixel};
///
/// let scene = Scene { background: [0.25, 1.5, 0.0], ..Scene::default() };
/// let camera =
///     Camera { position: [0.0; 3], target: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], fov: 50.0 };
/// let color = pixel(&scene, &camera, (320, 240), (7, 9), 4, Shading::Phong);
/// assert_eq!(color, scene.background);
/// ```
pub fn pixel(
    scene: &Scene,
    camera: &Camera,
    (width, height): (u32, u32),
    (x, y): (u32, u32),
    reflections: u32,
    shading: Shading,
) -> [f64; 3] {
    let ray = View::new(&prepared::camera(camera), (width, height)).ray(x, y);
    let prepared = Prepared::new(scene);
    let Vector(color) = trace::color(&prepared.scene(), ray, reflections, shading);
    color
}

/// Renders a whole picture with all threads of the machine. The bytes do not depend on their number.
///
/// Each channel c is clamped to 0 to 1 and stored as round(255 c).
///
/// # Panics
///
/// A shape names a material that the scene does not have.
///
/// ```
/// use reflet::host::reference::{Camera, Scene, Shading, render};
///
/// let scene = Scene { background: [0.25, 1.5, 0.0], ..Scene::default() };
/// let camera =
///     Camera { position: [0.0; 3], target: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], fov: 50.0 };
/// let picture = render(&scene, &camera, 4, 3, 0, Shading::BlinnPhong);
/// assert_eq!(picture.pixels, [[64, 255, 0]; 12]);
/// ```
pub fn render(
    scene: &Scene,
    camera: &Camera,
    width: u32,
    height: u32,
    reflections: u32,
    shading: Shading,
) -> Picture {
    sampled(scene, camera, [width, height, 1], reflections, shading)
}

/// Renders a picture as [`render`] does, with n × n samples for each pixel: each is clamped to 0 to 1, then the mean is
/// taken, then it is rounded. `size` is width, height and n, which is at least 1.
///
/// # Panics
///
/// A shape names a material that the scene does not have.
///
/// ```
/// use reflet::host::reference::{Camera, Scene, Shading, sampled};
///
/// let scene = Scene { background: [0.25, 1.5, 0.0], ..Scene::default() };
/// let camera =
///     Camera { position: [0.0; 3], target: [0.0, 1.0, 0.0], up: [0.0, 0.0, 1.0], fov: 50.0 };
/// let picture = sampled(&scene, &camera, [4, 3, 2], 0, Shading::BlinnPhong);
/// assert_eq!(picture.pixels, [[64, 255, 0]; 12]);
/// ```
pub fn sampled(
    scene: &Scene,
    camera: &Camera,
    [width, height, samples]: [u32; 3],
    reflections: u32,
    shading: Shading,
) -> Picture {
    let prepared = Prepared::new(scene);
    let scene = prepared.scene();
    let view = View::new(
        &prepared::camera(camera),
        (width * samples, height * samples),
    );
    let mean = |scene: &_, view: &View, x: u32, y: u32| {
        let mut sum = Vector([0.0; 3]);
        for place in 0..samples * samples {
            let (right, down) = (place % samples, place / samples);
            let ray = view.ray(x * samples + right, y * samples + down);
            let Vector(color) = trace::color(scene, ray, reflections, shading);
            sum += Vector(color.map(|it| it.clamp(0.0, 1.0)));
        }
        quantised(sum * (1.0 / f64::from(samples * samples)))
    };
    let row = |y| {
        let (scene, view) = (&scene, &view);
        (0..width).map(move |x| mean(scene, view, x, y))
    };
    let pixels = (0..height).into_par_iter().flat_map_iter(row).collect();
    Picture {
        width,
        height,
        pixels,
    }
}

#[cfg(test)]
mod tests;
