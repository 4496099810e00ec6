//! Tests: rays that leave a surface from outside do not hit it again at any angle, and their directions
//! have length one.

use super::light::{Scenery, colors};
use super::*;
use crate::number::Brightness;
use crate::shape::MaterialId;

/// The kind of shape that rays are sent at.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Sphere,
    Cylinder,
    Plane,
}

/// Largest error in steps of a hit and a radius together: a hit is known to two steps and a radius to
/// half a step.
///
/// The normal of a small shape may be wrong by this over the radius. If a ray hits it at a smaller
/// cosine, its outside may be taken for its inside.
const FEW: f64 = 4.0;

/// Radius in steps above which [`RIM`] covers the error of the normal.
const SMALL: f64 = FEW * 65_536.0;

/// Largest difference in steps that rounding may hide: of a light's height over the tangent plane, and
/// of a point's distance from the light compared with the light's tangents to the shape.
///
/// Rounding then decides whether the point is dark. Its cosine is below this over the distance, or over
/// the radius, in steps.
const LEVEL: f64 = 1.0;

/// Counts what happened to rays that left a shape from outside.
#[derive(Debug, Default)]
struct Fate {
    /// Rays that hit the shape.
    seen: u64,
    /// Hits at an angle below 6 degrees to the surface.
    grazed: u64,
    /// Hits whose outside was taken for the inside.
    turned: u64,
    /// Hits whose outside was taken for the inside at the rim of a shape too small to tell.
    unsure: u64,
    /// Hits that must be lit: the light is above the surface.
    lit: u64,
    /// Lit hits where the light came at an angle below 6 degrees to the surface.
    grazed_by_light: u64,
    /// Hits that must be lit by a light that is clear to the culling.
    clear: u64,
    /// Number of hits that must be lit but were black, with culling tables or without them.
    dark: u64,
    /// Mirrored rays that hit the shape again.
    met_again: u64,
}

type Triple = [f64; 3];

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns `a` + `b` times `factor`.
fn plus(a: Triple, b: Triple, factor: f64) -> Triple {
    [0, 1, 2].map(|axis| a[axis] + b[axis] * factor)
}

fn unit(a: Triple) -> Triple {
    a.map(|it| it / dot(a, a).sqrt())
}

fn cross(a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        a[next] * b[last] - a[last] * b[next]
    })
}

/// Returns a random direction.
fn any_direction(sweep: &mut Sweep) -> Triple {
    unit(sweep.triple(1000).map(|it| f64::from(it) + 0.5))
}

/// Returns a number from 2^-`octaves` to 1. Small numbers are as frequent as large ones.
fn small(sweep: &mut Sweep, octaves: u32) -> f64 {
    f64::from(sweep.octaves(0, octaves)) / 2f64.powi(octaves as i32)
}

/// Middle of the tested shape.
const MIDDLE: Triple = [-0.53, 0.53, -0.53];

/// The tested shape. A plane has a normal in place of an axis.
struct Shaped {
    kind: Kind,
    radius: f64,
    half_height: f64,
    axis: Triple,
}

impl Shaped {
    /// Returns a shape of random size, 64 steps or more.
    fn any(kind: Kind, sweep: &mut Sweep) -> Self {
        let radius = f64::from(sweep.octaves(6, 26)) / f64::from(1 << 28);
        let height = radius * f64::from(sweep.within(2, 60));
        Self {
            kind,
            radius,
            half_height: height.min(0.8) / 2.0,
            axis: any_direction(sweep),
        }
    }

    fn add_to(&self, scene: &mut Scenery, material: MaterialId) {
        let (axis, height) = (self.axis, 2.0 * self.half_height);
        match self.kind {
            Kind::Sphere => scene.add_sphere(MIDDLE, self.radius, material).map(drop),
            Kind::Cylinder => scene
                .add_cylinder(MIDDLE, axis, self.radius, height, material)
                .map(drop),
            Kind::Plane => scene.add_plane(MIDDLE, axis, material),
        }
        .unwrap();
    }

    fn radius_in(&self, step: f64) -> f64 {
        match self.kind {
            Kind::Plane => f64::INFINITY,
            _ => self.radius / step,
        }
    }

    /// Returns a point outside of the shape, as near as the shape is large, or as far away as near rays
    /// can start.
    fn beside(&self, sweep: &mut Sweep) -> Triple {
        let away = any_direction(sweep);
        match self.kind {
            Kind::Plane => {
                let along = cross(self.axis, away);
                let height = 1.5 * small(sweep, 20);
                plus(plus(MIDDLE, along, 1.5), self.axis, height)
            }
            _ => {
                let size = 1.2 * (self.radius + self.half_height);
                let most = (2.2 / size).max(1.0);
                plus(MIDDLE, away, size * most.powf(small(sweep, 3)))
            }
        }
    }

    /// Returns a point where rays from another point almost touch the shape.
    fn touched(&self, from: Triple, sweep: &mut Sweep) -> Triple {
        let part = f64::from(sweep.within(-1000, 1000)) / 1000.0;
        let (base, way, aside) = match self.kind {
            Kind::Cylinder => {
                let base = plus(MIDDLE, self.axis, part * self.half_height);
                let way = plus(from, base, -1.0);
                let way = plus(way, self.axis, -dot(way, self.axis));
                let side = if sweep.within(0, 1) == 0 { 1.0 } else { -1.0 };
                (base, way, cross(self.axis, way).map(|it| it * side))
            }
            _ => {
                let way = plus(from, MIDDLE, -1.0);
                (MIDDLE, way, cross(way, any_direction(sweep)))
            }
        };
        let sine = (self.radius / dot(way, way).sqrt()).min(1.0);
        let cosine = (1.0 - sine * sine).sqrt();
        let touched = plus(base, unit(way), self.radius * sine);
        let short = self.radius * (1.0 - 0.5 * small(sweep, 26));
        let touched = plus(touched, unit(aside), short * cosine);
        plus(touched, unit(way), self.radius * small(sweep, 26))
    }

    /// Returns a point to aim at, on the shape or near it.
    fn aim(&self, eye: Triple, light: Triple, sweep: &mut Sweep) -> Triple {
        if self.kind == Kind::Plane {
            let along = cross(self.axis, any_direction(sweep));
            return plus(MIDDLE, along, 1.5 * small(sweep, 20));
        }
        match sweep.within(0, 2) {
            0 => self.touched(eye, sweep),
            1 => self.touched(light, sweep),
            _ => {
                let aside = sweep.triple(1000).map(|it| f64::from(it) / 1000.0);
                plus(MIDDLE, aside, self.radius.max(self.half_height))
            }
        }
    }

    /// Tests whether a ray that hits the shape enters through the wall and not through an open end of a
    /// cylinder. Returns `false` if a few steps decide.
    fn is_entered(&self, from: Triple, direction: Triple, step: f64) -> bool {
        if self.kind != Kind::Cylinder {
            return true;
        }
        let across = |it: Triple| plus(it, self.axis, -dot(it, self.axis));
        let way = plus(from, MIDDLE, -1.0);
        let (flat, start) = (across(direction), across(way));
        let (square, half) = (dot(flat, flat), dot(flat, start));
        let sine = square.sqrt();
        let least = self.half_height - 8.0 * step / sine;
        // The distance from the axis is computed times the sine, unless that is small.
        let few = FEW * step / sine.max(0.25);
        [-few, few].into_iter().all(|wider| {
            let radius = self.radius + wider;
            let root = half * half - square * (dot(start, start) - radius * radius);
            let distance = (-half - root.max(0.0).sqrt()) / square;
            dot(plus(way, direction, distance), self.axis).abs() < least
        })
    }
}

/// Sends rays at shapes of any size in steps, with the smallest epsilon, from all sides. The ray or the
/// light often grazes the shape.
fn left_outside(kind: Kind, rounds: u32, seed: u64) -> Fate {
    let mut sweep = Sweep::new(seed);
    let mut fate = Fate::default();
    for round in 0..rounds {
        let shaped = Shaped::any(kind, &mut sweep);
        let (eye, light) = (shaped.beside(&mut sweep), shaped.beside(&mut sweep));
        let (to_eye, to_light) = (plus(eye, MIDDLE, -1.0), plus(light, MIDDLE, -1.0));
        let light = match round % 2 {
            0 => light,
            // A distant light, as the sun is.
            _ => plus(MIDDLE, to_light, 1e4),
        };
        let mut scene = Scenery::new();
        let white = Material::new([1.0; 3]).ambient(0.0).diffuse(1.0);
        let white = scene.add_material(white).unwrap();
        shaped.add_to(&mut scene, white);
        // A sphere behind the shape, in no direction that is tested, makes the ball large.
        let behind = unit(plus(unit(to_eye), unit(to_light), 1.0));
        scene
            .add_sphere(plus(MIDDLE, behind, -1.5), 0.01, white)
            .unwrap();
        if kind == Kind::Plane {
            let below = plus(MIDDLE, shaped.axis, -0.02);
            scene.add_sphere(below, 0.01, white).unwrap();
        }
        // So bright that its light along the surface is not rounded to zero.
        scene.add_light(light, [4, 4, 4]).unwrap();
        scene.set_epsilon(1e-15).unwrap();
        let scene = scene.build().unwrap();
        let parts = scene.parts();
        let own = match kind {
            Kind::Sphere => ShapeId::at(0),
            _ => ShapeId::at(parts.spheres.len()),
        };
        let step = 2f64.powi(-parts.grid.fraction_bits());
        let from = parts.grid.place(Position::new(eye));
        let view = LightVisibility::new(&scene, from);
        for _ in 0..10 {
            let aim = shaped.aim(eye, light, &mut sweep);
            let aim = parts.grid.place(Position::new(aim));
            let (direction, _) = from.to(aim).0.direction_and_length();
            let path = ScaledRay::new(from, direction);
            let Some((at, shape)) = first(&scene, &path, ShapeId::NONE) else {
                continue;
            };
            let along = direction.components().map(|it| it.to_num::<f64>());
            if shape != own || !shaped.is_entered(eye, along, step) {
                continue;
            }
            let surface = Surface::new(&scene, at, shape, direction).unwrap();
            fate.note(&scene, &view, &surface, (path, shaped.radius_in(step)));
        }
    }
    fate
}

impl Fate {
    /// Counts what happens to rays that leave the outside of a shape. Its radius is given in steps.
    fn note<W: World>(
        &mut self,
        world: &W,
        view: &LightVisibility,
        surface: &Surface<'_>,
        (mut path, radius): (ScaledRay, f64),
    ) {
        self.seen += 1;
        let facing = surface.facing.to_num::<f64>();
        self.grazed += u64::from(facing < 0.1);
        let is_turned = surface.is_inside;
        if is_turned && facing * radius < FEW && radius < SMALL {
            self.unsure += 1;
            return;
        }
        self.turned += u64::from(is_turned);
        let (way, scale) = surface.place.to(world.parts().lights[0].place);
        let (to_light, distance) = way.direction_and_length();
        let distance = f64::from(distance.to_bits()) * 2f64.powi(scale as i32);
        let height = surface.normal.dot(to_light).to_num::<f64>();
        if height > 1e-6 && height * distance.min(radius) > LEVEL {
            self.lit += 1;
            self.grazed_by_light += u64::from(height < 0.1);
            self.clear += u64::from(view.is_clear(0));
            let [fast, small] = colors::<BlinnPhong, _>(world, view, surface);
            self.dark += u64::from(fast.largest().min(small.largest()) <= Brightness::ZERO);
        }
        surface.reflect(world, &mut path);
        // The ray skips the shape it leaves from outside. Only a shape whose outside was taken for its
        // inside can be hit again.
        let met = first(world, &path, surface.skip(world));
        self.met_again += u64::from(met.is_some_and(|(_, it)| it == surface.shape));
    }
}

fn assert_left(kind: Kind, rounds: u32, seed: u64) -> u64 {
    let fate = left_outside(kind, rounds, seed);
    println!("{kind:?} {fate:?}");
    let Fate { seen, lit, .. } = fate;
    assert!(seen > 5 * u64::from(rounds) && 2 * lit > seen, "{fate:?}");
    assert!(
        5 * fate.grazed > seen && 5 * fate.grazed_by_light > lit,
        "{fate:?}"
    );
    assert_eq!(
        (fate.turned, fate.dark, fate.met_again),
        (0, 0, 0),
        "{fate:?}"
    );
    assert!(20 * fate.clear > lit, "{fate:?}");
    assert!(500 * fate.unsure < seen, "{fate:?}");
    seen
}

#[test]
fn sphere_does_not_stop_what_leaves_it_however_small_epsilon_is() {
    assert!(assert_left(Kind::Sphere, 20_000, 1) > 100_000);
}

#[test]
fn cylinder_does_not_stop_what_leaves_it_however_small_epsilon_is() {
    assert!(assert_left(Kind::Cylinder, 20_000, 2) > 100_000);
}

#[test]
fn plane_does_not_stop_what_leaves_it_however_small_epsilon_is() {
    assert!(assert_left(Kind::Plane, 12_000, 3) > 100_000);
}

#[test]
#[ignore = "long: 12 million rays"]
fn outsides_let_ten_million_rays_go() {
    let kinds = [Kind::Sphere, Kind::Cylinder, Kind::Plane].into_iter();
    let seen: u64 = kinds
        .zip(4..)
        .map(|(kind, seed)| assert_left(kind, 600_000, seed))
        .sum();
    assert!(seen > 10_000_000, "{seen}");
}

#[test]
fn mirrored_direction_has_a_length_of_one() {
    let mut sweep = Sweep::new(5);
    let mut seen = 0;
    for round in 0..20_000 {
        // Small and large spheres, seen from far away, where a hit is rounded most.
        let radius = f64::from(sweep.octaves(6, 25)) / f64::from(1 << 28);
        let mut scene = Scenery::new();
        let white = scene.add_material(Material::new([1.0; 3])).unwrap();
        let end = [-0.5, 0.5, -0.5];
        if round % 2 == 0 {
            scene.add_sphere(end, radius, white).unwrap();
        } else {
            let axis = sweep.triple(1000).map(f64::from);
            scene
                .add_cylinder(end, axis, radius, 2.0 * radius, white)
                .unwrap();
        }
        scene.add_sphere(end.map(|it| -it), 0.01, white).unwrap();
        let scene = scene.build().unwrap();
        let grid = scene.parts().grid;
        let from = grid.place(Position::new([1.49, 1.49, 1.2]));
        for _ in 0..10 {
            let aside = sweep.triple(1000).map(|it| f64::from(it) / 1000.0 * radius);
            let aim = grid.place(Position::new([0, 1, 2].map(|it| end[it] + aside[it])));
            let (direction, _) = from.to(aim).0.direction_and_length();
            let path = ScaledRay::new(from, direction);
            let Some((at, shape)) = first(&scene, &path, ShapeId::NONE) else {
                continue;
            };
            let surface = Surface::new(&scene, at, shape, direction).unwrap();
            let mut mirrored = path;
            surface.reflect(&scene, &mut mirrored);
            let square = mirrored.direction().raw().square() as f64;
            let long = square.sqrt() / 2f64.powi(30) - 1.0;
            // The length that every direction promises.
            assert!(
                long.abs() <= 2f64.powi(-26),
                "{long:e}: {radius} {surface:?}"
            );
            seen += 1;
        }
    }
    assert!(seen > 50_000, "{seen}");
}
