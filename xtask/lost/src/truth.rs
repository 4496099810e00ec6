//! Draws pictures in double precision with the reference's own formulas, and notes how each path was
//! reflected. The reference's files are compiled once more, because it does not tell its paths.

// Only the functions that follow a ray are called.
#![allow(dead_code, unused_imports)]

#[path = "../../../src/host/reference/model/mod.rs"]
mod model;
#[path = "../../../src/host/reference/prepared.rs"]
mod prepared;
#[path = "../../../src/host/reference/real.rs"]
mod real;

use reflet::host::reference::*;

use self::model::{Surface, Vector};
use self::prepared::{Prepared, camera};

/// Number type of all computations.
type Real = f64;

/// A picture in double precision, drawn twice, with the class of each path.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// Colours in Blinn-Phong shading: the picture of the reference.
    pub lit: Vec<[u8; 3]>,
    /// Colours without shadows and without highlights.
    pub plain: Vec<[u8; 3]>,
    /// Whether the path was reflected off a curved shape, or off more than one flat shape.
    pub is_apart: Vec<bool>,
}

/// One pixel of a [`Truth`].
struct Pixel {
    lit: Vector,
    plain: Vector,
    is_apart: bool,
}

/// A surface on a path: how much it mirrors, and its own colour in both pictures.
struct Step {
    alpha: f64,
    lit: Vector,
    plain: Vector,
}

/// Draws a scene in double precision, on this thread alone.
///
/// # Panics
///
/// A shape names a material that the scene does not have.
pub fn truth(scene: &Scene, eye: &Camera, (width, height): (u32, u32), reflections: u32) -> Truth {
    let prepared = Prepared::new(scene);
    let scene = prepared.scene();
    let view = model::View::new(&camera(eye), (width, height));
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = places.map(|(x, y)| follow(&scene, view.ray(x, y), reflections));
    let mut truth = Truth {
        lit: Vec::new(),
        plain: Vec::new(),
        is_apart: Vec::new(),
    };
    for pixel in pixels {
        truth.lit.push(model::quantised(pixel.lit));
        truth.plain.push(model::quantised(pixel.plain));
        truth.is_apart.push(pixel.is_apart);
    }
    truth
}

/// Follows a path to its end. A reflection counts if the path goes on after it.
fn follow(scene: &model::Scene, mut ray: model::Ray, reflections: u32) -> Pixel {
    let mut steps = Vec::new();
    let mut end = Vector::ZERO;
    let (mut flat, mut curved) = (0, 0);
    for reflection in 0..=reflections {
        let Some(surface) = scene.nearest(&ray) else {
            end = scene.beyond(ray.direction);
            break;
        };
        let alpha = surface.material.mirror;
        steps.push(Step {
            alpha,
            lit: scene.own_color(&surface, Shading::BlinnPhong),
            plain: plain_color(scene, &surface),
        });
        if alpha == 0.0 {
            break;
        }
        let goes_on = u32::from(reflection < reflections);
        match scene.shape(surface.shape).curvature() > 0.0 {
            true => curved += goes_on,
            false => flat += goes_on,
        }
        ray = surface.reflected();
    }
    let sum = |own: fn(&Step) -> Vector| {
        let back = steps.iter().rev();
        back.fold(end, |next, it| own(it) * (1.0 - it.alpha) + next * it.alpha)
    };
    Pixel {
        lit: sum(|it| it.lit),
        plain: sum(|it| it.plain),
        is_apart: curved > 0 || flat > 1,
    }
}

/// Returns the ambient and diffuse light of a surface, as if nothing blocked a light.
fn plain_color(scene: &model::Scene, surface: &Surface) -> Vector {
    let material = surface.material;
    let mut light = Vector::grey(material.ambient);
    for lamp in scene.lights {
        let (to_lamp, _) = lamp.seen_from(surface.outside);
        // For a light exactly at this point the maximum is 0, not NaN.
        let facing = surface.normal.dot(to_lamp).max(0.0);
        light += lamp.color * (material.diffuse * facing);
    }
    material.color.filtered(light)
}
