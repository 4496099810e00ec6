//! Bounds the rounding error of one pixel along its path, by the formulas of the table in the parent
//! module. This file uses the core's formats but none of its code.

use std::vec::Vec;

use super::edges::{cell, disc, mixed, open_cell};
use super::largest;
use crate::host::reference::Shading;
use crate::host::reference::model::{Light, Ray, Scene, Surface, Vector};

/// The grid and the dimness of a prepared scene, which the rounding analysis needs. It comes from
/// [`crate::host::precision`].
#[derive(Clone, Copy, Debug)]
pub struct Precision {
    /// Step of the scene's grid, in scene units.
    pub step: f64,
    /// Middle of the scene's grid, in scene units.
    pub middle: [f64; 3],
    /// Factor for the smallest weight of a quality: 1 / the brightest colour of the scene, at most 1.
    pub dimness: f64,
}

/// A path of the reference, with the state after each reflection that was followed.
#[derive(Clone, Debug, Default)]
pub struct Followed {
    /// State after 0, 1, 2 … reflections. The list is shorter if the path ended early.
    pub stages: Vec<Stage>,
}

/// The state of a path after a number of reflections: its colour, weight, error bound and trail.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Sum of the colours so far, before it is clamped.
    pub color: [f64; 3],
    /// Weight of the next colour on the path: Π αₖ, or 0 at the end of the path.
    pub weight: f64,
    /// Bound of the rounding error of `color`, in any channel.
    pub rounding: f64,
    /// Hash of the decisions on the path so far: the shapes that were hit, their sides, and the lights
    /// that shine on them.
    pub trail: u64,
    /// The same hash without the cells of planes, which divide no stretch of pixels.
    pub(super) open_trail: u64,
    /// For each of the first hits whether it shows a plane's checker's colour, and by how much more light its cell sends
    /// along the path than one of the other kind.
    pub(super) cells: [(bool, Vector); FIRST],
    /// Whether rounding may change a decision, so that the bound may not hold.
    pub is_unsure: bool,
}

/// Number of hits that fixed point stores to find out what lies between two paths.
const FIRST: usize = 5;

impl Followed {
    /// Returns the stage at which fixed point ends the path: after `reflections` reflections, or where
    /// the weight falls below `smallest_weight`, or at the last stage.
    pub fn ended(&self, reflections: usize, smallest_weight: f64) -> &Stage {
        let stages = &self.stages;
        let cut = stages.iter().position(|it| it.weight < smallest_weight);
        let last = stages.len() - 1;
        &stages[cut.unwrap_or(last).min(reflections).min(last)]
    }
}

impl Stage {
    /// State of a path before its first hit.
    const START: Self = Self {
        color: [0.0; 3],
        weight: 1.0,
        rounding: 0.0,
        trail: 0,
        open_trail: 0,
        cells: [(false, Vector::ZERO); FIRST],
        is_unsure: false,
    };

    /// Adds a hit to both trails: its shape and lights, and the cell of its checker. `open_trail` leaves out an open cell.
    fn note(&mut self, met: [u64; 2], cell: u64, is_open: bool) {
        let with = |trail, cell| mixed(met.into_iter().fold(trail, mixed), cell);
        self.trail = with(self.trail, cell);
        self.open_trail = with(self.open_trail, if is_open { 0 } else { cell });
    }

    /// Returns the stage after a ray in a direction hits nothing: adds the background, and ends the path. The
    /// direction is off by at most `drift`, and its length by up to 2⁻¹⁶.
    fn missed(self, scene: &Scene, direction: Vector, drift: f64) -> Self {
        let background = scene.beyond(direction);
        let (disc, is_at_edge) = disc(scene, direction, drift + to_the_minus(15));
        let is_below = scene.sky.is_some_and(|sky| direction.dot(sky.up) < 0.0);
        let error = slope(scene) * (drift + to_the_minus(16));
        let met = |trail| mixed(mixed(trail, u64::MAX - u64::from(is_below)), disc);
        Self {
            color: (Vector(self.color) + background * self.weight).0,
            weight: 0.0,
            rounding: self.rounding + (to_the_minus(24) + self.weight * (to_the_minus(25) + error)),
            trail: met(self.trail),
            open_trail: met(self.open_trail),
            is_unsure: self.is_unsure || is_at_edge,
            ..self
        }
    }

    /// Returns the stage after the ray hits a surface: adds its `own` colour and multiplies the weight
    /// by `alpha`. `error` bounds the error of `own`; `reflection` is the number of reflections before.
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

/// Error bounds of the current ray of a path: P and D of the table in the parent module.
#[derive(Clone, Copy)]
struct Drift {
    place: f64,
    direction: f64,
}

/// Returns by how much the colour of a sky changes at most with the direction; 0 without a sky.
fn slope(scene: &Scene) -> f64 {
    scene.sky.map_or(0.0, |sky| {
        let changes = [sky.above, sky.below].map(|end| largest(end - sky.horizon));
        changes[0].max(changes[1])
    })
}

/// Weight below which a path is not followed further: far too small to change a pixel.
const NOTHING: f64 = 1e-12;

/// Returns 2 to the power of minus `bits`.
fn to_the_minus(bits: i32) -> f64 {
    f64::exp2(f64::from(-bits))
}

/// Follows a ray for at most `reflections` reflections and returns the stage after each.
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
            stages.push(stage.missed(scene, ray.direction, drift.direction));
            break;
        };
        let at = Hit::new(scene, &surface, &ray, drift, step);
        let (lights, error) = at.light(scene, &surface, shading, precision);
        let own = scene.own_color(&surface, shading);
        let open = open_cell(scene, &surface, own, shading).filter(|_| reflection < FIRST);
        if let Some((holds, change)) = open {
            let share = stage.weight * (1.0 - surface.material.mirror);
            stage.cells[reflection] = (holds, change * share);
        }
        stage = stage.lit(own, error, reflection, surface.material.mirror);
        let shape = scene.number(surface.shape) as u64;
        // A perfect mirror has no colour of its own, so it does not matter which lights shine on it.
        let lights = lights * u64::from(surface.material.mirror < 1.0);
        let (cell, is_near_another) = cell(&surface, at.place);
        let side = 2 * shape + u64::from(surface.is_inside);
        stage.note([side, lights], cell, open.is_some());
        stage.is_unsure |= at.is_unsure || is_near_another;
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

/// Error bounds at the hit of a ray: of the point, the normal and the viewing direction.
struct Hit {
    /// Error bound of the point epsilon above the surface where rays start, in scene units.
    place: f64,
    /// Error bound of the normal, in radians.
    normal: f64,
    /// Error bound of the incoming ray's direction, in radians.
    view: f64,
    is_unsure: bool,
}

impl Hit {
    fn new(scene: &Scene, surface: &Surface, ray: &Ray, drift: Drift, step: f64) -> Self {
        let (distance, curvature) = (surface.distance, scene.shape(surface.shape).curvature());
        let cosine = -surface.normal.dot(ray.direction);
        let aside = drift.place + distance * drift.direction + 6.0 * step;
        let slide = aside / cosine + distance * to_the_minus(26);
        let normal = if curvature > 0.0 {
            (slide + 6.0 * step) * curvature + to_the_minus(16)
        } else {
            to_the_minus(29)
        };
        Self {
            place: slide + scene.epsilon * normal + 2.0 * step,
            normal,
            view: drift.direction,
            // The error may change the cosine at the hit, or make the ray miss the shape.
            is_unsure: slide * curvature > cosine / 64.0 || cosine < to_the_minus(16),
        }
    }

    /// Returns a bit for each light that shines on the surface, and an error bound of the surface's own
    /// colour, in any channel.
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
            let Some(arrival) = scene.arrival(surface, lamp) else {
                continue;
            };
            // Even if nothing is sent on: a highlight fades out smoothly.
            lights |= 1_u64.wrapping_shl(index as u32);
            let sent = Scene::sent_on(surface, arrival, shading);
            if sent <= 0.0 {
                continue;
            }
            let (towards, distance) = lamp.seen_from(surface.outside);
            let light = (self.place + 3.0 * precision.step) / distance + to_the_minus(26);
            let diffuse = self.normal + light + to_the_minus(28);
            let gleam = self.gleam(surface, towards, light, shading);
            let strength_error = material.diffuse * diffuse + material.specular * gleam;
            // A change of the distance by a part of it changes the share by up to 2 (1 - share) of that part.
            let share = lamp.range.map_or(1.0, |it| Light::share_at(it, distance));
            let rounding = lamp.range.map_or(0.0, |_| to_the_minus(24));
            let share_error = 2.0 * share * (1.0 - share) * light + rounding;
            let strength_error = strength_error * share + sent * share_error;
            let lit = sent * share;
            received += lamp.color * lit;
            let rounded = strength_error + to_the_minus(22) + lit * to_the_minus(25);
            error += lamp.color * rounded + Vector::grey(to_the_minus(20));
        }
        let tinted =
            material.color_at(surface.outside).filtered(error) + received * to_the_minus(25);
        (lights, largest(tinted) + to_the_minus(20))
    }

    /// Returns an error bound of the highlight's power, before the specular coefficient. `error` is the
    /// bound of the light's direction, in radians.
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
                // The error of a quotient in Q2.30 with the divisor (1 + l·v) / 2.
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
