//! Tests that culling never changes a picture: candidate sets of shapes, and lights that planes hide.

use super::{BuiltIn, Castle, NAMES, Visitor, visit};
use crate::accel::light_occluders::{self, LightOccluders};
use crate::accel::light_visibility::LightVisibility;
use crate::accel::screen_bounds::ScreenBounds;
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{Beside, Scene, Static, World};
use crate::host::file::{FileScene, built};
use crate::host::reference;
use crate::number::sweep::Sweep;
use crate::number::{Length, Unit};
use crate::qualities::Fast;
use crate::ray::{REACH, ScaledPoint, ScaledRay};
use crate::scene::Room;
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::nearest::any_ahead;
use crate::scene::query::{nearest_hit, occluded};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{RuntimeScene, Surface};
use crate::shade::BlinnPhong;
use crate::shape::MaterialId;
use crate::shape::bounded::{Bounded, Range};
use crate::shape::plane::{PreparedPlane, Side};
use crate::trace::{Pixel, Stops, Tracer};
use crate::vector::{Direction, Point, Position};
use crate::{Camera, Material};

const SIZE: (u32, u32) = (40, 32);

/// Asserts for every pixel that the traced sum with screen culling equals the sum without, for which
/// every ray tests every shape: through its centre, and through a place near one of its corners.
fn compare<W: World>(world: &W, camera: &Camera, name: &str) {
    let generator = camera.generator(SIZE.0, SIZE.1);
    let from = world.parts().grid.place(camera.description().position);
    let view = LightVisibility::new(world, from);
    let everything = ScreenBounds::<W::Room>::empty();
    let bounds = from.is_near().then(|| {
        let mut bounds = everything;
        bounds.look(world, &camera.screen_axes(&generator, from.point));
        bounds
    });
    for y in 0..SIZE.1 {
        let row = generator.row_plane(y, from.point);
        let tracer = |bounds, is_full| {
            let culling = ScreenCulling::new::<true>(bounds, (from, row), y, is_full);
            Tracer::<W, BlinnPhong, Fast>::new(world, &view, (culling, *ShapeSet::ALL), 3)
        };
        let mut some = tracer(bounds.as_ref(), false);
        let mut all = tracer(Some(&everything), true);
        let mut unbounded = tracer(None, true);
        let directions = generator.row(y);
        let mut beside = Beside::NONE;
        for x in 0..SIZE.0 {
            let [found, exact] = [&mut some, &mut all].map(|it| {
                let window = it.advance(x / 4 * 4, x / 4 * 4 + 4);
                let mut stops = Stops::NONE;
                it.trace(
                    Pixel::Center(&window, x),
                    (directions.of(x), None),
                    (&mut stops, true),
                )
                .sum
            });
            assert_eq!(found, exact, "{name}: pixel {x}, {y} of {camera:?}");
            let [right, down] = [x, y].map(|it| if it % 2 == 0 { -63 } else { 63 });
            let direction = generator.through([x, y], [right, down]);
            let [found, exact] = [&mut some, &mut unbounded].map(|it| {
                let mut stops = Stops::NONE;
                let pixel = Pixel::Beside(&mut beside, x);
                it.trace(pixel, (direction, None), (&mut stops, false)).sum
            });
            assert_eq!(found, exact, "{name}: beside pixel {x}, {y} of {camera:?}");
        }
    }
}

fn from_all_sides<W: World>(world: &W, camera: &Camera, name: &str) {
    for (azimuth, elevation) in [(0, 0), (35, 10), (100, -20), (180, 5), (-75, -8)] {
        if let Ok(camera) = camera.orbited(azimuth, elevation) {
            compare(world, &camera, name);
        }
    }
}

#[test]
fn rows_of_the_built_in_scenes_miss_no_shape() {
    from_all_sides(&Static::<Castle>::new(), &Castle::CAMERA, "castle");
    for name in NAMES {
        let (scene, camera) = at_run_time(name);
        from_all_sides(&scene.tabled(), &camera, name);
    }
}

/// Returns a built-in scene in a type that has room for all of them, and its camera. Tests of many
/// scenes then compile the path once.
fn at_run_time(name: &str) -> (std::boxed::Box<FileScene>, Camera) {
    struct Describe;
    impl Visitor for Describe {
        type Output = (std::boxed::Box<FileScene>, Camera);
        fn visit<S: BuiltIn>(self) -> Self::Output {
            let scene = S::with_description(|scene| reference::Scene::from(&scene));
            let scene = built(&scene, &reference::Camera::from(&S::CAMERA));
            (scene.expect("a built-in scene is valid"), S::CAMERA)
        }
    }
    visit(name, Describe).expect("a built-in scene")
}

/// A scene of `S` spheres and `C` cylinders, with up to two planes, two lights and one material.
type Crowd<const S: usize, const C: usize> = Scene<Room<S, 2, C, 2, 1>>;

/// The run-time scene of a [`Crowd`], before it is built.
type Description<const S: usize, const C: usize> = RuntimeScene<Room<S, 2, C, 2, 1>>;

/// Returns a run-time scene of random mirroring spheres and cylinders and two lights, one among the
/// shapes, and the id of its only material.
fn described<const S: usize, const C: usize>(
    random: &mut Sweep,
    (spheres, cylinders): (usize, usize),
) -> (Description<S, C>, MaterialId) {
    let mut scene = Description::new();
    let glass = Material::new([0.9, 0.8, 0.7]).mirror(0.5);
    let glass = scene.add_material(glass).unwrap();
    for _ in 0..spheres {
        let radius = 0.02 + 0.08 * random.share().abs();
        scene.add_sphere(random.place(), radius, glass).unwrap();
    }
    for _ in 0..cylinders {
        let (radius, height) = (0.01 + 0.03 * random.share().abs(), random.share().abs());
        let (center, axis) = (random.place(), random.place());
        scene
            .add_cylinder(center, axis, radius, height + 0.01, glass)
            .unwrap();
    }
    for place in [random.place(), random.place().map(|x| 4.0 * x)] {
        scene.add_light(place, [0.5, 0.5, 0.5]).unwrap();
    }
    (scene, glass)
}

/// Returns a random scene of `S` spheres and `C` cylinders with two mirroring planes.
fn crowd<const S: usize, const C: usize>(random: &mut Sweep) -> Crowd<S, C> {
    let (mut scene, glass) = described(random, (S, C));
    scene
        .add_plane([0.0, 0.0, -1.1], [0.0, 0.0, 1.0], glass)
        .unwrap();
    scene
        .add_plane(random.place().map(|x| 3.0 * x), random.place(), glass)
        .unwrap();
    scene.build().unwrap()
}

/// Returns a random scene of 18 spheres and 9 cylinders whose type has room for more of each kind.
fn roomy_crowd(random: &mut Sweep) -> Crowd<40, 24> {
    let (mut scene, glass) = described(random, (18, 9));
    scene
        .add_plane([0.0, 0.0, -1.1], [0.0, 0.0, 1.0], glass)
        .unwrap();
    scene.build().unwrap()
}

/// Returns a camera at `position` that looks at the origin, the middle of a crowd, with a random field
/// of view.
fn camera(random: &mut Sweep, position: [f64; 3]) -> Camera {
    let fov = 60.0 + 50.0 * random.share();
    Camera::new(position, [0.0; 3], [0.1, 0.2, 1.0], fov).unwrap()
}

#[test]
fn rows_of_crowded_scenes_miss_no_shape() {
    let mut random = Sweep::new(0x9e37_79b9_7f4a_7c15);
    for round in 0..6 {
        // `many` has more shapes than a mask has bits and a row's list has places; `few` fits both.
        let (many, few) = (crowd::<100, 40>(&mut random), crowd::<24, 8>(&mut random));
        let (tubes, roomy) = (crowd::<0, 12>(&mut random), roomy_crowd(&mut random));
        let position = random.place().map(|x| 2.5 * x);
        let camera = camera(&mut random, position);
        compare(&many.tabled(), &camera, &format!("crowd {round}"));
        compare(&few.tabled(), &camera, &format!("small crowd {round}"));
        compare(
            &tubes.tabled(),
            &camera,
            &format!("crowd of cylinders {round}"),
        );
        compare(
            &roomy.tabled(),
            &camera,
            &format!("crowd with room {round}"),
        );
    }
}

/// Returns a random position near the centre of a sphere: on each axis at most `share` times the radius away.
fn about<W: World>(world: &W, random: &mut Sweep, share: f64, sphere: usize) -> [f64; 3] {
    let (parts, aside) = (world.parts(), random.place());
    let (center, radius) = parts.spheres[sphere].ball();
    let center = [center.x, center.y, center.z].map(f64::from);
    let aside = aside.map(|it| share * it * f64::from(radius));
    let step = 2_f64.powi(-parts.grid.fraction_bits());
    let middle = parts.grid.middle().0.map(|it| it.to_f64());
    [0, 1, 2].map(|it| middle[it] + step * (center[it] + aside[it]))
}

#[test]
fn rows_that_show_a_rim_large_miss_no_shape() {
    let mut random = Sweep::new(0xa54f_f53a_5f1d_36f1);
    for round in 0..40 {
        let scene = crowd::<24, 8>(&mut random);
        let position = random.place().map(|x| 2.5 * x);
        let target = about(&scene, &mut random, 1.2, round % 24);
        // With this field of view one sphere is wider than the picture.
        let camera = Camera::new(position, target, [0.1, 0.2, 1.0], 0.6).unwrap();
        compare(&scene.tabled(), &camera, &format!("rim {round}"));
    }
}

#[test]
fn rows_seen_from_far_away_miss_no_shape() {
    let mut random = Sweep::new(0x6a09_e667_f3bc_c908);
    for round in 0..3 {
        let scene = crowd::<24, 8>(&mut random);
        let camera = Camera::new([900.0, 700.0, 500.0], [0.0; 3], [0.0, 0.0, 1.0], 0.2).unwrap();
        let from = scene.parts().grid.place(camera.description().position);
        assert!(!from.is_near());
        compare(&scene.tabled(), &camera, &format!("far crowd {round}"));
    }
}

#[test]
fn rows_seen_from_inside_a_sphere_miss_no_shape() {
    let mut random = Sweep::new(0xbb67_ae85_84ca_a73b);
    for round in 0..4 {
        // The camera is inside one of the spheres of the crowd, which overlaps others.
        let scene = crowd::<100, 40>(&mut random);
        let position = about(&scene, &mut random, 0.5, round);
        let inside = camera(&mut random, position);
        is_inside(&scene, &inside);
        compare(
            &scene.tabled(),
            &inside,
            &format!("inside of the crowd {round}"),
        );

        // The camera is inside a sphere that surrounds all shapes and hides what is outside.
        let (mut scene, glass) = described::<100, 40>(&mut random, (60, 20));
        scene.add_sphere([0.1, 0.2, 0.3], 3.5, glass).unwrap();
        scene
            .add_plane([0.0, 0.0, -0.8], [0.0, 0.1, 1.0], glass)
            .unwrap();
        let scene = scene.build().unwrap();
        let position = random.place().map(|x| 1.5 * x);
        let inside = camera(&mut random, position);
        is_inside(&scene, &inside);
        compare(&scene.tabled(), &inside, &format!("crowd inside {round}"));
    }
}

/// Asserts that a camera is inside a sphere of the scene.
fn is_inside<W: World>(world: &W, camera: &Camera) {
    let from = world.parts().grid.place(camera.description().position);
    let mut spheres = world.parts().spheres.iter();
    assert!(spheres.any(|sphere| sphere.seen_from(from.point).is_around()));
}

/// Tests whether any sphere or cylinder blocks the ray from a light to the point at `distance` in a
/// direction. It gives the result of [`light_occluders::occluded`], but tests every shape. `left` is a
/// cylinder to skip.
fn occluded_by_any<W: World>(
    world: &W,
    light: &LightOccluders<W::Room>,
    direction: Direction,
    distance: Length,
    left: Option<usize>,
) -> bool {
    let parts = world.parts();
    let light = light.light().place.point;
    let mut spheres = parts.spheres.iter();
    spheres.any(|sphere| sphere.seen_from(light).is_before(direction, distance))
        || parts.cylinders.iter().enumerate().any(|(index, cylinder)| {
            let seen = cylinder.seen_from(light);
            let range = Range {
                start: parts.epsilon,
                reach: distance,
            };
            let met = cylinder.intersect_from(&seen, &direction, range);
            left != Some(index) && met.is_some()
        })
}

/// Returns a surface on the outside of a cylinder, or of no shape. Only the fields that a shadow test
/// reads are meaningful.
fn outside_of<W: World>(world: &W, cylinder: Option<usize>) -> Surface<'_> {
    let parts = world.parts();
    let plane = ShapeId::at(parts.bounded());
    let mut surface = Surface::new(world, ScaledPoint::ORIGIN, plane, Direction::X).unwrap();
    surface.is_inside = false;
    surface.shape = cylinder.map_or(ShapeId::NONE, |it| ShapeId::at(parts.spheres.len() + it));
    surface
}

/// Asserts in many directions that the shadow test with light tables equals the one with every shape.
/// Returns how often a light was visible and how often it was hidden.
fn asked<W: World>(world: &W, random: &mut Sweep) -> [u32; 2] {
    let mut counts = [0; 2];
    let cylinders = world.parts().cylinders.len();
    let lights = world.tables().light_occluders.iter().enumerate();
    for (index, light) in lights.filter(|(_, it)| it.light().is_plain) {
        for round in 0..4000 {
            // Half of the rays go in any direction as far as a ray reaches, half to a point among the
            // shapes.
            let from = light.light().place;
            let (direction, reach) = match round % 2 {
                0 => (Position::new(random.place()).direction().unwrap(), REACH),
                _ => {
                    let place = world.parts().grid.place(Position::new(random.place()));
                    from.to(place).0.direction_and_length()
                }
            };
            let left = Some(round % (2 * cylinders + 1)).filter(|&it| it < cylinders);
            let all = occluded_by_any(world, light, direction, reach, left);
            let surface = outside_of(world, left);
            let ray = (direction, reach);
            let some =
                light_occluders::occluded::<_, Fast, false>(world, &surface, (light, index), ray);
            assert_eq!(some, all, "{direction:?} {reach:?} {left:?}");
            counts[usize::from(all)] += 1;
        }
    }
    counts
}

#[test]
fn light_tables_miss_no_shape() {
    let mut random = Sweep::new(0x2545_f491_4f6c_dd1d);
    // Four forms of sets: runs of shapes; one bit for each shape, also with room for more; and so few
    // shapes that all are tested.
    let mut counts = [[0; 2]; 4];
    for _ in 0..6 {
        let asked = [
            asked(&crowd::<100, 40>(&mut random).tabled(), &mut random),
            asked(&crowd::<24, 8>(&mut random).tabled(), &mut random),
            asked(&roomy_crowd(&mut random).tabled(), &mut random),
            asked(&crowd::<2, 1>(&mut random).tabled(), &mut random),
        ];
        for (sum, counts) in counts.iter_mut().zip(asked) {
            *sum = [0, 1].map(|it| sum[it] + counts[it]);
        }
    }
    let [runs, bits, roomy, few] = counts.map(|[clear, hidden]| clear.min(hidden));
    assert!(
        runs > 4000 && bits > 2000 && roomy > 500 && few > 20,
        "too few to say anything: {counts:?}"
    );
}

/// Returns the point and the shape of a ray's nearest hit, by the plain path that tests every shape.
fn first<W: World>(world: &W, ray: &ScaledRay, skip: ShapeId) -> Option<(ScaledPoint, ShapeId)> {
    nearest_hit(world, ray, skip)
}

/// Returns the surface that a ray hits in a random direction, `None` if it hits nothing.
fn hit_at_random<'a, W: World>(
    world: &'a W,
    random: &mut Sweep,
    from: ScaledPoint,
) -> Option<Surface<'a>> {
    let towards = world.parts().grid.place(Position::new(random.place()));
    let (direction, _) = from.to(towards).0.direction_and_length();
    let (at, shape) = first(world, &ScaledRay::new(from, direction), ShapeId::NONE)?;
    Some(Surface::new(world, at, shape, direction).unwrap())
}

/// Asserts that the shadow test from a clear light's side agrees with the plain shadow ray to the light,
/// at random hits of camera rays in a scene without planes.
///
/// Returns three counts: lights that both find visible, lights that both find hidden, and differences. A
/// difference counts as rounding if moving the point by at most 64 steps a coordinate removes it; any
/// other difference fails.
fn told<W: World>(world: &W, random: &mut Sweep) -> [u32; 3] {
    let parts = world.parts();
    let mut counts = [0; 3];
    let from = parts
        .grid
        .place(Position::new(random.place().map(|x| 2.5 * x)));
    let view = LightVisibility::new(world, from);
    for _ in 0..10_000 {
        let Some(surface) = hit_at_random(world, random, from) else {
            continue;
        };
        for (index, occluders) in world.tables().light_occluders.iter().enumerate() {
            if !view.is_clear(index) {
                continue;
            }
            let (light, table) = (occluders.light(), &world.tables().light_tables[index]);
            let to_light = |from: ScaledPoint| {
                let (direction, distance) = from.to(light.place).0.direction_and_length();
                (ScaledRay::new(from, direction), distance)
            };
            let general = |from: ScaledPoint| {
                let (ray, distance) = to_light(from);
                let set = table.at(ray.direction().reversed());
                let skip = surface.skip(world);
                occluded(world, set, &ray, skip, (light.place, distance, 0))
            };
            let (ray, distance) = to_light(surface.place);
            if surface.normal.dot(ray.direction()) <= Unit::ZERO {
                continue;
            }
            let way = (ray.direction().reversed(), distance);
            let hidden = light_occluders::occluded::<_, Fast, false>(
                world,
                &surface,
                (occluders, index),
                way,
            );
            if general(surface.place) == hidden {
                counts[usize::from(hidden)] += 1;
                continue;
            }
            counts[2] += 1;
            // The difference is rounding if the plain test agrees at a point a few steps beside.
            let Point { x, y, z } = surface.place.point;
            let aside = (0..200).any(|_| {
                let [dx, dy, dz] = random.place().map(|it| (it * 64.0) as i32);
                general(ScaledPoint::new(Point::new(x + dx, y + dy, z + dz), 0)) == hidden
            });
            assert!(aside, "{hidden}: {surface:?} {light:?}");
        }
    }
    counts
}

#[test]
fn clear_lights_are_hidden_by_what_blocks_the_way_to_them() {
    let mut random = Sweep::new(0x510e_527f_ade6_82d1);
    let mut counts = [0; 3];
    for _ in 0..20 {
        let (mut many, _) = described::<100, 40>(&mut random, (100, 40));
        let (mut few, _) = described::<5, 12>(&mut random, (5, 12));
        many.set_epsilon(1e-6).unwrap();
        few.set_epsilon(1e-6).unwrap();
        let told = [
            told(&many.build().unwrap().tabled(), &mut random),
            told(&few.build().unwrap().tabled(), &mut random),
        ];
        for told in told {
            counts = [0, 1, 2].map(|it| counts[it] + told[it]);
        }
    }
    let [clear, hidden, close] = counts;
    assert!(
        clear > 10_000 && hidden > 10_000 && close < 10,
        "{counts:?}"
    );
}

/// Asserts that [`any_ahead`] agrees with the plain shadow ray to a far light, at random hits of camera rays. Returns how
/// many of them see the light, and how many do not.
fn ahead<W: World>(world: &W, random: &mut Sweep, sun: Position) -> [u32; 2] {
    let (parts, mut counts) = (world.parts(), [0; 2]);
    let place = parts.grid.place(sun);
    let from = parts
        .grid
        .place(Position::new(random.place().map(|x| 2.5 * x)));
    for _ in 0..2000 {
        let Some(surface) = hit_at_random(world, random, from) else {
            continue;
        };
        let (way, scale) = surface.place.to(place);
        let (direction, distance) = way.direction_and_length();
        let (ray, skip) = (
            ScaledRay::new(surface.place, direction),
            surface.skip(world),
        );
        let light = (place, distance, scale);
        let is_hidden = occluded(world, ShapeSet::ALL, &ray, skip, light);
        assert_eq!(any_ahead(world, &ray.ray, skip), is_hidden, "{surface:?}");
        counts[usize::from(is_hidden)] += 1;
    }
    counts
}

#[test]
fn far_lights_are_hidden_by_what_lies_ahead() {
    let mut random = Sweep::new(0x1f83_d9ab_fb41_bd6c);
    let mut counts = [0; 2];
    for round in 0..90 {
        let (scene, _) = described::<5, 12>(&mut random, (5, 12));
        let far = [100.0, 1e4, 1e9][round % 3];
        let sun = Position::new(random.place().map(|x| far * x));
        let own = ahead(&scene.build().unwrap().tabled(), &mut random, sun);
        counts = [0, 1].map(|it| counts[it] + own[it]);
    }
    assert!(counts.iter().all(|&it| it > 500), "{counts:?}");
}

mod balls;
mod planes;
mod switches;
