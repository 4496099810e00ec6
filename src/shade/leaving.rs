//! Tests: rays that leave a curved surface do not meet it again, and have length one.

use super::*;
use crate::material::Material;
use crate::number::Length;
use crate::number::sweep::Sweep;
use crate::quality::Fast;
use crate::scene::query::first;
use crate::scene::{RuntimeScene, World};
use crate::shape::MaterialId;
use crate::vector::Position;

type Scenery = RuntimeScene<2, 2, 1, 4, 2>;

/// Counts what is seen of a shape that a function adds at one end of a scene, from as far as near
/// rays start and with the smallest epsilon; and how often a light is hidden there by the very place
/// that it should light, and a mirrored ray stopped by the one it has left.
fn stopped_by_itself(
    light: [f64; 3],
    add: impl Fn(&mut Scenery, MaterialId, &mut Sweep, [f64; 3]),
) -> [u32; 3] {
    let mut sweep = Sweep::new(9);
    let mut counts = [0; 3];
    for _ in 0..4000 {
        let mut scene = Scenery::new();
        let white = Material::new([1.0; 3]).ambient(0.0).diffuse(1.0);
        let white = scene.add_material(white).unwrap();
        let end = [-0.53, 0.53, -0.53];
        add(&mut scene, white, &mut sweep, end);
        // Out of the way at the other end.
        let other_end = end.map(|it| -it);
        scene.add_sphere(other_end, 0.01, white).unwrap();
        scene.add_light(light, [1, 1, 1]).unwrap();
        scene.set_epsilon(1e-15).unwrap();
        let scene = scene.build().unwrap();
        let grid = scene.parts().grid;
        assert_eq!(grid.fraction_bits(), 28);
        let from = grid.place(Position::new([1.49, 1.49, 1.2]));
        let view = View::new(&scene, from);
        let light = scene.parts().lights[0].place;
        for _ in 0..10 {
            let aside = sweep.triple(1000).map(|it| f64::from(it) * 3e-5);
            let aim = grid.place(Position::new([0, 1, 2].map(|it| end[it] + aside[it])));
            let (direction, _) = from.to(aim).0.direction_and_length();
            let path = Path::new(from, direction);
            let Some((at, shape)) = first(&scene, &path, ShapeNumber::NONE) else {
                continue;
            };
            let surface = Surface::new(&scene, at, shape, direction).unwrap();
            counts[0] += 1;
            // Far enough above the surface to have left it; what is in the way from there is another
            // place.
            let is_free = |direction: Direction| {
                let away = surface
                    .place
                    .point
                    .along(direction, Length::from_bits(4000));
                let path = Path::new(Place::new(away, 0), direction);
                first(&scene, &path, ShapeNumber::NONE).is_none()
            };
            let (to_light, _) = surface.place.to(light).0.direction_and_length();
            if surface.normal.dot(to_light) > 0.1 && is_free(to_light) {
                let color = <BlinnPhong as sealed::Shading>::color::<_, Fast>(
                    &scene,
                    &view,
                    &surface,
                    &mut Trail::new(),
                );
                counts[1] += u32::from(color.largest() < 0.05);
            }
            let mut mirrored = path;
            surface.reflect(&scene, &mut mirrored);
            if surface.facing > 0.1 && is_free(mirrored.direction()) {
                counts[2] += u32::from(first(&scene, &mirrored, shape).is_some());
            }
        }
    }
    counts
}

/// A light beside the shapes, and a sun.
const LIGHTS: [[f64; 3]; 2] = [[0.3, 0.5, 0.6], [9000.0, 9200.0, 9100.0]];

#[test]
fn sphere_does_not_stop_what_leaves_it_however_small_epsilon_is() {
    for light in LIGHTS {
        let [seen, shadowed, mirrored] = stopped_by_itself(light, |scene, white, _, end| {
            scene.add_sphere(end, 0.04, white).unwrap();
        });
        assert!(seen > 20_000, "{seen}");
        assert_eq!((shadowed, mirrored), (0, 0), "of {seen}: {light:?}");
    }
}

#[test]
fn cylinder_does_not_stop_what_leaves_it_however_small_epsilon_is() {
    for light in LIGHTS {
        let [seen, shadowed, mirrored] = stopped_by_itself(light, |scene, white, sweep, end| {
            let axis = sweep.triple(1000).map(f64::from);
            scene.add_cylinder(end, axis, 0.02, 0.1, white).unwrap();
        });
        assert!(seen > 20_000, "{seen}");
        assert_eq!((shadowed, mirrored), (0, 0), "of {seen}: {light:?}");
    }
}

#[test]
fn mirrored_direction_has_a_length_of_one() {
    let mut sweep = Sweep::new(5);
    let mut seen = 0;
    for round in 0..20_000 {
        // Small and large, seen from far away, where a hit is rounded most.
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
            let path = Path::new(from, direction);
            let Some((at, shape)) = first(&scene, &path, ShapeNumber::NONE) else {
                continue;
            };
            let surface = Surface::new(&scene, at, shape, direction).unwrap();
            let mut mirrored = path;
            surface.reflect(&scene, &mut mirrored);
            let square = mirrored.direction().raw().square() as f64;
            let long = square.sqrt() / 2f64.powi(30) - 1.0;
            // What every direction promises.
            assert!(
                long.abs() <= 2f64.powi(-26),
                "{long:e}: {radius} {surface:?}"
            );
            seen += 1;
        }
    }
    assert!(seen > 50_000, "{seen}");
}
