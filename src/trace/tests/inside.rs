//! Tests: rays that leave the inside of a curved surface hit the next wall. They do not hit the wall
//! they left, and do not pass through it.

use super::light::{Scenery, colors};
use super::*;
use crate::vector::Point;

/// Counts what happened to rays inside of a shape.
#[derive(Debug, Default)]
struct Fate {
    /// Rays that hit a wall.
    met: u64,
    /// Rays that hit no wall, or a wall from outside, without having come to an open end.
    lost: u64,
    /// Rays that came to an open end.
    left_by_end: u64,
    /// Number of rays that left a cylinder's wall and wrongly hit it again in the same place.
    met_again: u64,
    /// Hits that were dark although a light is inside.
    dark: u64,
}

/// The cylinder around the rays, in steps.
struct Tube {
    center: Point,
    axis: [f64; 3],
    radius: f64,
    half_height: f64,
}

impl Tube {
    /// Tests whether a ray from inside hits the wall further from an end than the rounding error.
    fn keeps(&self, path: &ScaledRay) -> bool {
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let Vector { x, y, z } = self.center.to(path.ray.origin);
        let start = [x, y, z].map(f64::from);
        let way = path.direction().components().map(|it| it.to_num::<f64>());
        let (rise, climb) = (dot(start, self.axis), dot(way, self.axis));
        let square = 1.0 - climb * climb;
        let half = dot(start, way) - rise * climb;
        let outside = dot(start, start) - rise * rise - self.radius * self.radius;
        let root = half * half - square * outside;
        let distance = (-half + root.max(0.0).sqrt()) / square;
        // The distance is divided by the square of the sine, unless that is small.
        let sine = square.sqrt();
        let unsure = 8.0 / (sine * sine.max(0.25));
        (rise + distance * climb).abs() + unsure < self.half_height
    }
}

/// Follows mirrored rays inside of spheres or very long cylinders of any size in steps, anywhere in the
/// ball.
fn followed_inside(rounds: u32, is_sphere: bool, seed: u64) -> Fate {
    let mut sweep = Sweep::new(seed);
    let mut fate = Fate::default();
    for _ in 0..rounds {
        let steps = sweep.octaves(6, 26);
        let radius = f64::from(steps) / f64::from(1 << 28);
        let mut scene = Scenery::new();
        let mirror = Material::new([1.0; 3])
            .ambient(0.0)
            .diffuse(1.0)
            .mirror(1.0);
        let mirror = scene.add_material(mirror).unwrap();
        // Two shapes keep the ball at its size.
        let end = sweep.triple(1000).map(|it| f64::from(it) * 3.0e-4);
        let axis = sweep.triple(1000).map(|it| f64::from(it) + 0.5);
        let height = (radius * f64::from(sweep.within(2, 60))).min(0.8);
        if is_sphere {
            scene.add_sphere(end, radius, mirror).map(drop)
        } else {
            scene
                .add_cylinder(end, axis, radius, height, mirror)
                .map(drop)
        }
        .unwrap();
        scene.add_sphere([0.0; 3], 0.999, mirror).unwrap();
        let aside = |sweep: &mut Sweep, part: f64| {
            let aside = sweep
                .triple(1000)
                .map(|it| f64::from(it) * 5.7e-4 * part * radius);
            [0, 1, 2].map(|axis| end[axis] + aside[axis])
        };
        scene.add_light(aside(&mut sweep, 0.9), [1, 1, 1]).unwrap();
        scene.set_epsilon(1e-15).unwrap();
        let scene = scene.build().unwrap();
        let grid = scene.parts().grid;
        assert!((27..=28).contains(&grid.fraction_bits()));
        // A ball that is a little larger than 2²⁸ finer steps has half as many of these steps.
        let steps = steps >> (28 - grid.fraction_bits());
        let long = axis.iter().map(|it| it * it).sum::<f64>().sqrt();
        let tube = Tube {
            center: grid.place(Position::new(end)).point,
            axis: axis.map(|it| it / long),
            radius: f64::from(steps),
            half_height: height / 2.0 * 2f64.powi(grid.fraction_bits()),
        };
        let number = if is_sphere {
            ShapeId::at(0)
        } else {
            ShapeId::at(scene.parts().spheres.len())
        };
        for _ in 0..8 {
            let from = grid.place(Position::new(aside(&mut sweep, 0.9)));
            let view = LightVisibility::new(&scene, from);
            let [x, y, z] = sweep.triple(1 << 28);
            let way = Vector::new(x, y, z).precise_direction();
            let mut path = ScaledRay::new(from, way);
            let mut left = ShapeId::NONE;
            for bounce in 0..16 {
                let met = first(&scene, &path, left).filter(|(_, shape)| *shape == number);
                let Some((at, shape)) = met else {
                    if is_sphere || tube.keeps(&path) {
                        fate.lost += 1
                    } else {
                        fate.left_by_end += 1
                    }
                    break;
                };
                fate.met += 1;
                let surface = Surface::new(&scene, at, shape, path.direction()).unwrap();
                fate.lost += u64::from(!surface.is_inside);
                let gone = path.ray.origin.to(at.point).direction_and_length().1;
                // A chord is as long as twice the radius times the cosine, and longer along a cylinder.
                let cosine = surface.facing.to_num::<f64>();
                let chord = 2.0 * f64::from(steps) * cosine;
                if bounce > 0 && cosine > 0.05 && f64::from(gone.to_bits()) < 0.5 * chord {
                    fate.met_again += 1;
                }
                let [color, _] = colors::<BlinnPhong, _>(&scene, &view, &surface);
                let to_light = surface
                    .place
                    .to(scene.parts().lights[0].place)
                    .0
                    .direction_and_length()
                    .0;
                let height = surface.normal.dot(to_light).to_num::<f64>();
                if is_sphere && height > 0.05 && color.largest() < 0.01 {
                    fate.dark += 1;
                }
                surface.reflect(&scene, &mut path);
                left = surface.skip(&scene);
            }
        }
    }
    fate
}

fn assert_kept_inside(rounds: u32, is_sphere: bool, seed: u64) {
    let fate = followed_inside(rounds, is_sphere, seed);
    println!("{fate:?}");
    assert!(fate.met > 20 * u64::from(rounds), "{fate:?}");
    assert!(
        is_sphere || fate.left_by_end > u64::from(rounds),
        "{fate:?}"
    );
    assert_eq!(
        (fate.lost, fate.met_again, fate.dark),
        (0, 0, 0),
        "{fate:?}"
    );
}

#[test]
fn inside_of_a_sphere_keeps_its_rays() {
    assert_kept_inside(4000, true, 1);
}

#[test]
fn inside_of_a_cylinder_does_not_stop_what_leaves_it() {
    assert_kept_inside(4000, false, 2);
}

#[test]
#[ignore = "long: 22 million bounces"]
fn insides_keep_ten_million_rays() {
    assert_kept_inside(50_000, true, 3);
    assert_kept_inside(200_000, false, 4);
}
