use super::*;
use crate::accel::Scene;
use crate::camera::Camera;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::ray::ScaledRay;
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::query::{nearest_hit, occluded};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Room, RuntimeScene, Surface};

type Built = Scene<Room<3, 1, 2, 1, 1, 2, 2>>;

/// Returns the last column to which a light surely shines as in `column`.
fn until(scene: &Built, shadow: Shadow<'_>, column: u32) -> u32 {
    borders_from(column, scene, shadow)
        .until(column)
        .unwrap_or(column)
}

/// Distance of a light that is a sun.
const SUN: f64 = 1e6;

/// Returns a scene of shapes over a floor, some of which cut it, and a light at a distance.
fn scene(sweep: &mut Sweep, far: f64) -> Built {
    let mut scene = RuntimeScene::<Room<3, 1, 2, 1, 1, 2, 2>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    let mut place = |height: f64| {
        let [x, y, z] = sweep.place();
        (
            [2.0 * x, 2.0 * y, height * (1.0 + z)],
            0.1 + 0.2 * (1.0 + x),
        )
    };
    for height in [0.2, 0.6, 1.0] {
        let (center, radius) = place(height);
        scene.add_sphere(center, radius, white).unwrap();
    }
    for height in [0.5, 0.9] {
        let ((center, radius), (axis, length)) = (place(height), place(1.0));
        let height = 4.0 * length;
        scene
            .add_cylinder(center, axis, 0.4 * radius, height, white)
            .unwrap();
        let ((center, radius), (normal, _)) = (place(height), place(1.0));
        scene.add_disc(center, normal, radius, white).unwrap();
        let corners = [0.8, 0.2, 0.5].map(|height| place(height).0);
        scene.add_triangle(corners, None, white).unwrap();
    }
    scene.add_plane([0, 0, 0], [0, 0, 1], white).unwrap();
    let (towards, size) = place(0.6);
    let light = towards.map(|it| it * far + size);
    match far == SUN {
        true => scene.add_sun(light, [1.0; 3], 0).unwrap(),
        false => scene.add_light(light, [1.0; 3]).unwrap(),
    };
    scene.build().unwrap()
}

/// Returns whether the floor is lit where a pixel shows it, by the plain path. `None` if it shows a shape.
fn is_lit(scene: &Built, from: ScaledPoint, direction: crate::vector::Direction) -> Option<bool> {
    let (ray, parts) = (ScaledRay::new(from, direction), scene.parts());
    let (at, shape) = nearest_hit(scene, &ray, ShapeId::NONE)?;
    parts.plane(shape)?;
    let surface = Surface::new(scene, at, shape, direction)?;
    let light = parts.lights[0].place;
    let (way, scale) = surface.place.to(light);
    let (towards, distance) = way.direction_and_length();
    let ray = ScaledRay::new(surface.place, towards);
    let to_light = (light, distance, scale);
    Some(!occluded(
        scene,
        ShapeSet::ALL,
        &ray,
        surface.skip(scene),
        to_light,
    ))
}

/// A light shines on the floor alike in all columns that are said to be alike, pixel by pixel against the plain
/// path. Lights are from near to 2000 times as far away as the scene is wide.
#[test]
fn light_shines_alike_up_to_the_border_of_a_shadow() {
    let mut sweep = Sweep::new(61);
    let (mut alike, mut borders, mut shaded, mut far_lights) = (0, 0, 0, 0);
    for round in 0..500 {
        let far = [4.0, 40.0, 400.0, 4000.0, SUN][round % 5];
        let scene = scene(&mut sweep, far);
        let [x, y, z] = sweep.place();
        let camera = Camera::look_at([4.0 * x, -5.0 + y, 1.6 + z], [0.0; 3], [0.1 * x, 0.0, 1.0]);
        let (parts, generator) = (scene.parts(), camera.generator(96, 64));
        let from = parts.grid.place(camera.description().position);
        let light = parts.lights[0].place;
        far_lights += u32::from(!light.is_near());
        for row in [20, 31, 40, 52, 63] {
            let (plane, directions) = (generator.row_plane(row, from.point), generator.row(row));
            let pencil = Pencil {
                eye: from.point,
                row: plane,
            };
            let lit = |column| is_lit(&scene, from, directions.of(column));
            let mut column = 0;
            while column < 96 {
                let Some(is_lit) = lit(column) else {
                    column += 1;
                    continue;
                };
                let until = until(&scene, (&pencil, &parts.planes[0], light), column).min(95);
                shaded += u32::from(!is_lit);
                for other in column..=until {
                    let same = lit(other).is_none_or(|other| other == is_lit);
                    assert!(
                        same,
                        "round {round}, row {row}: {column}, {other} of {until}"
                    );
                }
                alike += until - column;
                borders += u32::from(until < 95);
                column = until + 1;
            }
        }
    }
    assert!(
        alike > 100_000 && borders > 2_000 && shaded > 500 && far_lights > 150,
        "{alike} {borders} {shaded} {far_lights}"
    );
}

/// The borders of a whole row, kept, say at each column what borders from that column on say.
#[test]
fn shadows_kept_for_a_row_end_where_those_of_a_column_end() {
    let mut sweep = Sweep::new(67);
    let mut compared = 0;
    for _ in 0..60 {
        let scene = scene(&mut sweep, 400.0);
        let [x, y, z] = sweep.place();
        let camera = Camera::look_at([4.0 * x, -5.0 + y, 1.6 + z], [0.0; 3], [0.1 * x, 0.0, 1.0]);
        let (parts, generator) = (scene.parts(), camera.generator(96, 64));
        let from = parts.grid.place(camera.description().position);
        for row in [31, 40, 52] {
            let pencil = Pencil {
                eye: from.point,
                row: generator.row_plane(row, from.point),
            };
            let (plane, light) = (&parts.planes[0], parts.lights[0].place);
            let cast = Cast {
                mirror: ShapeId::NONE,
                plane: ShapeId::at(parts.bounded()),
                light: 0,
            };
            let mut shadows = RowShadows::NONE;
            for column in 0..96 {
                let kept = shadows.of(&scene, cast, (&pencil, plane, light));
                let anew = until(&scene, (&pencil, plane, light), column);
                if let Some(kept) = kept.until(column) {
                    assert_eq!(kept, anew, "row {row}, column {column}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}

/// Each plane, mirror and light has shadows of its own: what is kept for one is not told of another.
#[test]
fn shadows_of_another_light_are_found_anew() {
    let mut scene = RuntimeScene::<Room<1, 1, 0, 2, 1, 0>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0, 0, 1], 0.5, white).unwrap();
    scene.add_plane([0, 0, 0], [0, 0, 1], white).unwrap();
    scene.add_light([-4000, 0, 4000], [1.0; 3]).unwrap();
    scene.add_light([0, 4000, 1000], [1.0; 3]).unwrap();
    let scene: Scene<Room<1, 1, 0, 2, 1, 0>> = scene.build().unwrap();
    let camera = Camera::look_at([0.0, -5.0, 2.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let (parts, generator) = (scene.parts(), camera.generator(96, 64));
    let from = parts.grid.place(camera.description().position);
    let pencil = Pencil {
        eye: from.point,
        row: generator.row_plane(32, from.point),
    };
    let mut shadows = RowShadows::NONE;
    let mut of = |light: usize| {
        let cast = Cast {
            mirror: ShapeId::NONE,
            plane: ShapeId::at(1),
            light,
        };
        let shadow = (&pencil, &parts.planes[0], parts.lights[light].place);
        let borders = shadows.of(&scene, cast, shadow);
        borders.until(0)
    };
    let [one, other] = [of(0), of(1)];
    assert_ne!(one, other);
    assert_eq!([of(0), of(1)], [one, other]);
}
