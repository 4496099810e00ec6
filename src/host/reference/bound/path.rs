//! How far rounding may move one pixel, worked out along its path as the room above derives it. It
//! knows the core's formats and none of its code.

use std::vec::Vec;

use super::largest;
use crate::host::reference::Shading;
use crate::host::reference::model::{Ray, Scene, Surface, Vector};

/// The grid that a scene was laid on, in scene units: [`crate::host::precision`] tells.
#[derive(Clone, Copy, Debug)]
pub struct Precision {
    /// A step of the grid.
    pub step: f64,
    /// Its middle.
    pub middle: [f64; 3],
    /// The smallest weights of a quality are multiplied by this: 1 / the brightest colour, at most 1.
    pub dimness: f64,
}

/// A path of the reference, as far as it was followed, reflection by reflection.
#[derive(Clone, Debug, Default)]
pub struct Followed {
    /// What is known after 0, 1, 2 … reflections; shorter where the path ended before.
    pub stages: Vec<Stage>,
}

/// What is known of a path after so many reflections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// The colour so far, before it is clamped.
    pub color: [f64; 3],
    /// The weight with which the path goes on: Π αₖ; 0 where it ends.
    pub weight: f64,
    /// How far rounding may have moved the colour, in any channel.
    pub rounding: f64,
    /// A number made of all that was decided: shapes, sides, lights.
    pub trail: u64,
    /// Whether rounding may have decided otherwise, so that nothing is promised.
    pub is_unsure: bool,
}

impl Followed {
    /// The stage at which fixed point ends the path: by the number of reflections, or by the smallest
    /// weight that its quality follows.
    pub fn ended(&self, reflections: usize, smallest_weight: f64) -> &Stage {
        let stages = &self.stages;
        let cut = stages.iter().position(|it| it.weight < smallest_weight);
        let last = stages.len() - 1;
        &stages[cut.unwrap_or(last).min(reflections).min(last)]
    }
}

impl Stage {
    /// Before anything was met.
    const START: Self = Self {
        color: [0.0; 3],
        weight: 1.0,
        rounding: 0.0,
        trail: 0,
        is_unsure: false,
    };

    /// The path meets nothing, and ends.
    fn missed(self, background: Vector) -> Self {
        Self {
            color: (Vector(self.color) + background * self.weight).0,
            weight: 0.0,
            rounding: self.rounding + (to_the_minus(24) + self.weight * to_the_minus(26)),
            trail: mixed(self.trail, u64::MAX),
            ..self
        }
    }

    /// The path meets a surface with a colour of its `own`, which may be off by `error`, after so many
    /// reflections, and is reflected by the share `alpha`.
    fn lit(self, own: Vector, error: f64, reflection: usize, alpha: f64) -> Self {
        let share = self.weight * (1.0 - alpha);
        let rounding = share * error
            + to_the_minus(24)
            + largest(own) * (reflection as f64 + 2.0) * to_the_minus(30);
        Self {
            color: (Vector(self.color) + own * share).0,
            weight: self.weight * alpha,
            rounding: self.rounding + rounding,
            ..self
        }
    }
}

/// Error so far along a path.
#[derive(Clone, Copy)]
struct Drift {
    place: f64,
    direction: f64,
}

/// A weight that no display shows.
const NOTHING: f64 = 1e-12;

/// Two to the power of minus `bits`.
fn to_the_minus(bits: i32) -> f64 {
    f64::exp2(f64::from(-bits))
}

/// Follows a ray for at most `reflections` reflections.
pub(super) fn follow(
    scene: &Scene,
    mut ray: Ray,
    reflections: usize,
    shading: Shading,
    precision: &Precision,
) -> Followed {
    let step = precision.step;
    let away = ray.origin - Vector(precision.middle);
    let mut drift = Drift {
        place: 2.0 * step + away.length() * to_the_minus(28),
        direction: to_the_minus(26),
    };
    let mut stages = Vec::new();
    let mut stage = Stage::START;
    for reflection in 0..=reflections {
        let Some(surface) = scene.nearest(&ray) else {
            stages.push(stage.missed(scene.background));
            break;
        };
        let at = Hit::new(scene, &surface, &ray, drift, step);
        let (lights, error) = at.light(scene, &surface, shading, precision);
        let own = scene.own_color(&surface, shading);
        stage = stage.lit(own, error, reflection, surface.material.mirror);
        let shape = scene.number(surface.shape) as u64;
        stage.trail = mixed(
            mixed(stage.trail, 2 * shape + u64::from(surface.is_inside)),
            lights,
        );
        stage.is_unsure |= at.is_unsure;
        stages.push(stage);
        if stage.weight < NOTHING {
            break;
        }
        ray = surface.reflected();
        drift = Drift {
            place: at.place,
            direction: drift.direction + 2.0 * at.normal + to_the_minus(26),
        };
    }
    Followed { stages }
}

/// How far things may be off where a ray meets a surface.
struct Hit {
    /// The point above the surface where rays leave, in scene units.
    place: f64,
    /// The normal, in radians.
    normal: f64,
    /// The ray that came, in radians.
    view: f64,
    is_unsure: bool,
}

impl Hit {
    fn new(scene: &Scene, surface: &Surface, ray: &Ray, drift: Drift, step: f64) -> Self {
        let (distance, curvature) = (surface.distance, scene.shape(surface.shape).curvature());
        let cosine = -surface.normal.dot(ray.direction);
        let aside = drift.place + distance * drift.direction + 6.0 * step;
        let slide = aside / cosine + distance * to_the_minus(26);
        let normal = match curvature > 0.0 {
            true => (slide + 6.0 * step) * curvature + to_the_minus(16),
            false => to_the_minus(29),
        };
        Self {
            place: slide + scene.epsilon * normal + 2.0 * step,
            normal,
            view: drift.direction,
            // The cosine may be another, or the ray pass by.
            is_unsure: slide * curvature > cosine / 64.0 || cosine < to_the_minus(16),
        }
    }

    /// Which lights shine on the surface, and how far its colour may be off.
    fn light(
        &self,
        scene: &Scene,
        surface: &Surface,
        shading: Shading,
        precision: &Precision,
    ) -> (u64, f64) {
        let material = surface.material;
        let mut lights = 0;
        let mut received = Vector::grey(material.ambient);
        let mut error = Vector::grey(to_the_minus(20));
        for (index, lamp) in scene.lights.iter().enumerate() {
            let lit = scene.strength(surface, lamp, shading);
            if lit <= 0.0 {
                continue;
            }
            lights |= 1_u64.wrapping_shl(index as u32);
            let way = lamp.position - surface.outside;
            let distance = way.length();
            let light = (self.place + 3.0 * precision.step) / distance + to_the_minus(26);
            let diffuse = self.normal + light + to_the_minus(28);
            let gleam = self.gleam(surface, way * (1.0 / distance), light, shading);
            let strength_error = material.diffuse * diffuse + material.specular * gleam;
            received += lamp.color * lit;
            let rounded = strength_error + to_the_minus(22) + lit * to_the_minus(25);
            error += lamp.color * rounded + Vector::grey(to_the_minus(20));
        }
        let tinted = material.color.filtered(error) + received * to_the_minus(25);
        (lights, largest(tinted) + to_the_minus(20))
    }

    /// How far the highlight may be off.
    fn gleam(&self, surface: &Surface, light: Vector, error: f64, shading: Shading) -> f64 {
        let shininess = surface.material.shininess;
        let cosine = surface.gleam(light, shading).max(0.0);
        let (square, spread) = match shading {
            Shading::Phong => {
                let spread = 2.0 * self.normal + error + self.view + to_the_minus(27);
                (cosine * cosine, 2.0 * cosine * spread + spread * spread)
            }
            _ => {
                let half = (light + surface.viewer).length().max(to_the_minus(20));
                let turn = (error + self.view) / half + self.normal;
                // A quotient of Q2.30 by (1 + l·v) / 2.
                let quotient = to_the_minus(25) + to_the_minus(28) * 4.0 / (half * half);
                (
                    cosine * cosine,
                    2.0 * cosine * turn + turn * turn + quotient,
                )
            }
        };
        let power = |square: f64| square.clamp(0.0, 1.0).powf(shininess / 2.0);
        let (most, least) = (power(square + spread), power(square - spread));
        let here = power(square);
        let own = (shininess + 4.0) * to_the_minus(28);
        (most - here).max(here - least) + own
    }
}

/// FNV-1a, a word at a time.
fn mixed(trail: u64, word: u64) -> u64 {
    (trail ^ word.wrapping_add(0x9e37_79b9_7f4a_7c15))
        .wrapping_mul(0x0100_0000_01b3)
        .rotate_left(23)
}
