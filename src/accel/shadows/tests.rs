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

type Built = Scene<Room<3, 1, 2, 1, 1, 2>>;

/// Returns a scene of shapes over a floor, some of which cut it, and a light at a distance.
fn scene(sweep: &mut Sweep, far: f64) -> Built {
    let mut scene = RuntimeScene::<Room<3, 1, 2, 1, 1, 2>>::new();
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
    }
    scene.add_plane([0, 0, 0], [0, 0, 1], white).unwrap();
    let (towards, size) = place(0.6);
    let light = towards.map(|it| it * far + size);
    scene.add_light(light, [1.0; 3]).unwrap();
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
    for round in 0..400 {
        let far = [4.0, 40.0, 400.0, 4000.0][round % 4];
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
                let until = until(&scene, &pencil, &parts.planes[0], light, column).min(95);
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
