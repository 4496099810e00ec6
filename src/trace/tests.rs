mod accumulation;
mod inside;
mod leaving;
mod light;
mod series;

use crate::scene::Room;
use std::vec::Vec;

use crate::qualities::{Exact, Fast, Small};

use super::*;
use crate::accel::Scene;
use crate::accel::screen_bounds::ScreenBounds;
use crate::camera::Camera;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::ray::{ScaledPoint, ScaledRay};
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::query::nearest_hit;
use crate::scene::{RuntimeScene, Surface};
use crate::shade::{BlinnPhong, Normals};
use crate::vector::{Position, Vector};

/// Room for the scenes of these tests: with one type, the path is compiled once.
type Scenery = RuntimeScene<Room<4, 2, 1, 0, 7>>;

/// Step of a throughput: 2⁻³⁰.
const ULP: f64 = 1.0 / (1 << 30) as f64;

/// Returns a scene of a closed sphere of radius 1 around the origin. It shines evenly with `brightness`
/// and reflects the share `alpha`.
fn room(brightness: f64, alpha: f64) -> Scene<Room<1, 0, 0, 0, 1>> {
    let mut scene = RuntimeScene::<Room<1, 0, 0, 0, 1>>::new();
    let shining = Material::from_numbers([brightness; 3], 1, 0, (0, 1), alpha).unwrap();
    let shining = scene.add_material(shining).unwrap();
    scene.add_sphere([0, 0, 0], 1, shining).unwrap();
    scene.build().unwrap()
}

/// Returns the ray from a point in a direction.
fn path(from: ScaledPoint, towards: [f64; 3]) -> ScaledRay {
    ScaledRay::new(from, Position::new(towards).direction().unwrap())
}

/// Returns the first hit of a ray: point and shape. Tests every shape.
fn first<W: World>(world: &W, ray: &ScaledRay, skip: ShapeId) -> Option<(ScaledPoint, ShapeId)> {
    nearest_hit(world, ray, skip)
}

/// The result of one path.
#[derive(Clone, Copy, Debug)]
struct Followed {
    sum: Sum,
    rays: u32,
    cut_off: Unit,
}

/// Follows one path. Every ray tests every shape of the scene.
fn followed_by<K: Shading, Q: Quality, W: World>(
    world: &W,
    path: ScaledRay,
    reflections: u8,
) -> Followed {
    let view = LightVisibility::new(world, path.from());
    let bounds = ScreenBounds::empty();
    // Every shape is tested, so the plane of the row does not matter.
    let camera = Camera::look_at([1.0, 0.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let row = camera.generator(1, 1).row_plane(0, path.from().point);
    let culling = ScreenCulling::new::<true>(Some(&bounds), (path.from(), row), 0, true);
    let mut tracer = Tracer::<_, K, Q>::new(world, &view, (culling, *ShapeSet::ALL), reflections);
    let window = tracer.advance(0, 0);
    let mut stops = Stops::NONE;
    Followed {
        sum: tracer
            .trace(
                Pixel::Center(&window, 0),
                (path.direction(), None),
                (&mut stops, true),
            )
            .sum,
        rays: tracer.rays,
        cut_off: tracer.cut_off,
    }
}

/// Follows paths from inside of the room in many directions. Returns one result for each.
fn followed<Q: Quality>(room: &Scene<Room<1, 0, 0, 0, 1>>, reflections: u8) -> Vec<Followed> {
    let parts = room.parts();
    let mut sweep = Sweep::new(u64::from(reflections));
    let paths = (0..40).map(|_| {
        let from = sweep.triple(1000).map(|it| f64::from(it) / 2000.0);
        let towards = sweep.triple(1000).map(|it| f64::from(it) + 0.5);
        path(parts.grid.place(Position::new(from)), towards)
    });
    paths
        .map(|path| followed_by::<BlinnPhong, Q, _>(room, path, reflections))
        .collect()
}

const ALPHAS: [f64; 7] = [0.0, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0];

const REFLECTIONS: [u8; 8] = [0, 1, 2, 4, 16, 63, 254, 255];

#[test]
fn closed_mirrored_room_shines_as_the_sum_of_its_series() {
    for alpha in ALPHAS {
        for brightness in [1.0, 0.6] {
            let room = room(brightness, alpha);
            for reflections in REFLECTIONS {
                // c Σ (1 - α) αⁱ for i up to N
                let truth = brightness * (1.0 - alpha.powi(i32::from(reflections) + 1)) * 255.0;
                for traced in followed::<Exact>(&room, reflections) {
                    for channel in traced.sum.to_rgb8() {
                        // Rounded to an integer. Throughputs that are off by 2^-22 may change it by
                        // one.
                        let off = f64::from(channel) - truth;
                        assert!(
                            off.abs() <= 0.501,
                            "{channel}, not {truth}: α {alpha}, N {reflections}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn weight_cut_off_is_the_product_of_the_shares() {
    for alpha in ALPHAS {
        let room = room(1.0, alpha);
        let held = Unit::from_num(alpha).to_num::<f64>();
        for reflections in REFLECTIONS {
            let steps = i32::from(reflections) + 1;
            for traced in followed::<Exact>(&room, reflections) {
                // Every product is rounded down by less than a last place. Each later α weakens what
                // was rounded off. α itself is rounded to half a last place.
                let lost = held.powi(steps) - traced.cut_off.to_num::<f64>();
                let weakened: f64 = (0..steps).map(|step| held.powi(step)).sum();
                let bound = weakened * ULP;
                assert!(
                    -ULP <= lost && lost <= bound + ULP,
                    "{lost:e} of {alpha}^{steps} is lost, not 0 to {bound:e}"
                );
            }
        }
    }
}

#[test]
fn weight_of_half_mirrors_is_exact() {
    let room = room(1.0, 0.5);
    for reflections in 0..30 {
        for traced in followed::<Exact>(&room, reflections) {
            assert_eq!(
                traced.cut_off.to_bits(),
                1 << (29 - reflections),
                "N {reflections}"
            );
            assert_eq!(traced.rays, u32::from(reflections) + 1);
        }
    }
}

#[test]
fn path_stops_where_its_weight_is_spent() {
    // 2^-30 is the smallest throughput, and half of it is 0: the 31st ray is the last.
    for (alpha, rays) in [
        (0.0, 1),
        (0.5, 31),
        (0.25, 16),
        (2f64.powi(-30), 2),
        (1.0, 256),
    ] {
        for traced in followed::<Exact>(&room(1.0, alpha), 255) {
            assert_eq!(traced.rays, rays, "α {alpha}");
            let cut_off = if alpha == 1.0 { Unit::ONE } else { Unit::ZERO };
            assert_eq!(traced.cut_off, cut_off, "α {alpha}");
        }
    }
}

#[test]
fn perfect_mirrors_show_nothing_of_themselves() {
    for traced in followed::<Exact>(&room(1.0, 1.0), 255) {
        assert_eq!(traced.sum.to_rgb8(), [0; 3]);
    }
}

#[test]
fn number_of_reflections_bounds_the_rays() {
    for reflections in REFLECTIONS {
        for traced in followed::<Exact>(&room(1.0, 0.999), reflections) {
            assert_eq!(traced.rays, u32::from(reflections) + 1);
        }
    }
}

#[test]
fn fast_path_stops_at_a_weight_that_cannot_be_seen() {
    for (alpha, rays) in [
        (0.5, 9),
        (0.25, 5),
        (0.03, 2),
        (0.9, 53),
        (0.0, 1),
        (1.0, 256),
    ] {
        for traced in followed::<Fast>(&room(1.0, alpha), 255) {
            // The first power of α below 2^-8.
            assert_eq!(traced.rays, rays, "α {alpha}");
            let cut_off = traced.cut_off.to_num::<f64>();
            let truth = alpha.powi(rays as i32);
            assert!(
                (cut_off - truth).abs() <= 70.0 * ULP,
                "{cut_off}, not {truth}: α {alpha}"
            );
        }
    }
}

#[test]
fn fast_path_in_a_bright_room_is_followed_until_less_than_a_level_is_left() {
    // The first power of 1/2 below 2⁻⁸ / 4, the brightness being rounded up.
    for traced in followed::<Fast>(&room(4.0, 0.5), 255) {
        assert_eq!(traced.rays, 11);
    }
}

#[test]
fn fast_differs_from_exact_by_no_more_than_the_weight_it_reports() {
    for alpha in ALPHAS {
        let room = room(1.0, alpha);
        for reflections in REFLECTIONS {
            let pairs = followed::<Fast>(&room, reflections)
                .into_iter()
                .zip(followed::<Exact>(&room, reflections));
            for (fast, exact) in pairs {
                assert!(
                    fast.rays <= exact.rays && fast.cut_off >= exact.cut_off,
                    "{fast:?} {exact:?}"
                );
                let bound = (fast.cut_off.to_num::<f64>() * 255.0).ceil() as u8;
                for (low, high) in fast.sum.to_rgb8().into_iter().zip(exact.sum.to_rgb8()) {
                    assert!(low <= high && high - low <= bound, "{fast:?} {exact:?}");
                }
            }
        }
    }
}

#[test]
fn path_that_meets_nothing_adds_the_background_with_its_weight() {
    let mut scene = RuntimeScene::<Room<1, 0, 0, 0, 1>>::new();
    let mirror = Material::from_numbers([1, 1, 1], 0, 0, (0, 1), 0.5).unwrap();
    let mirror = scene.add_material(mirror).unwrap();
    scene.add_sphere([0, 0, 0], 1, mirror).unwrap();
    scene.set_background([1.0, 0.5, 0.0]).unwrap();
    let scene = scene.build().unwrap();
    let parts = scene.parts();
    let from = parts.grid.place(Position::new([0.0, -3.0, 0.0]));
    let path = |towards| path(from, towards);
    let past = followed_by::<BlinnPhong, Exact, _>(&scene, path([1.0, 0.0, 0.0]), 9);
    assert_eq!(
        (past.sum.to_rgb8(), past.rays, past.cut_off),
        ([255, 128, 0], 1, Unit::ZERO)
    );
    let mirrored = followed_by::<BlinnPhong, Exact, _>(&scene, path([0.0, 1.0, 0.0]), 9);
    assert_eq!(
        (mirrored.sum.to_rgb8(), mirrored.rays, mirrored.cut_off),
        ([128, 64, 0], 2, Unit::ZERO)
    );
    let cut = followed_by::<BlinnPhong, Exact, _>(&scene, path([0.0, 1.0, 0.0]), 0);
    assert_eq!(
        (cut.sum.to_rgb8(), cut.rays, cut.cut_off.to_bits()),
        ([0; 3], 1, 1 << 29)
    );
}

#[test]
fn normals_are_seen_in_no_mirror() {
    let room = room(1.0, 1.0);
    let parts = room.parts();
    let path = path(parts.grid.place(Position::ORIGIN), [0.0, 1.0, 0.0]);
    let traced = followed_by::<Normals, Exact, _>(&room, path, 255);
    assert_eq!((traced.rays, traced.cut_off), (1, Unit::ZERO));
    assert_eq!(traced.sum.to_rgb8(), [128, 0, 128]);
}

#[test]
fn path_between_facing_mirrors_stays_between_them() {
    // No path leaves, and no plane is hit twice in a row.
    let mut scene = Scenery::new();
    let shining = Material::from_numbers([1, 1, 1], 1, 0, (0, 1), 0.875).unwrap();
    let shining = scene.add_material(shining).unwrap();
    scene.add_plane([0, 0, 0], [0, 0, 1], shining).unwrap();
    scene.add_plane([0, 0, 1], [0, 0, 1], shining).unwrap();
    let scene = scene.build().unwrap();
    let parts = scene.parts();
    let from = parts.grid.place(Position::new([0.0, 0.0, 0.5]));
    for towards in [
        [0.0, 0.0, 1.0],
        [1.0, 2.0, 9.0],
        [1.0, 0.0, 1.0],
        [9.0, 0.0, -1.0],
    ] {
        let traced = followed_by::<BlinnPhong, Exact, _>(&scene, path(from, towards), 100);
        assert_eq!(traced.rays, 101, "{towards:?}");
        assert_eq!(traced.sum.to_rgb8(), [255; 3], "{towards:?}");
    }
}

/// A sloping mirror lies less than a step below the camera, so only the far kernels hit it. Another
/// plane is hit so far out that the far kernels are called. The reflection must begin at the mirror,
/// not where the near kernels hit the other plane.
#[test]
fn mirror_that_the_camera_almost_lies_in_shows_all_that_is_before_other_planes() {
    let mut scene = Scenery::new();
    let mut material = |color: [f64; 3], alpha: f64| {
        let made = Material::from_numbers(color, 1, 0, (0, 1), alpha).unwrap();
        scene.add_material(made).unwrap()
    };
    let [red, green, mirror] = [
        material([1.0, 0.0, 0.0], 0.0),
        material([0.0, 1.0, 0.0], 0.0),
        material([1.0; 3], 1.0),
    ];
    // A step is 2⁻²⁴, and the camera 0.3 of one above the mirror, which has a slope of 2⁻²⁰.
    let slope = 2f64.powi(-20);
    let below = 0.3 * 2f64.powi(-24) / slope;
    scene.set_epsilon(2f64.powi(-20)).unwrap();
    scene.add_sphere([0, 0, 0], 16, red).unwrap();
    scene.add_plane([15.5, 0.0, 0.0], [1, 0, 0], green).unwrap();
    scene
        .add_plane([0.0, -16.0, -16.0 - below], [0.0, 1.0, slope], mirror)
        .unwrap();
    let scene = scene.build().unwrap();
    assert_eq!(scene.parts().grid.fraction_bits(), 24);
    let from = scene.parts().grid.place(Position::new([-16.0; 3]));
    let followed = |y: f64| {
        let path = path(from, [0.75, y, 0.59]);
        let followed = followed_by::<BlinnPhong, Exact, _>(&scene, path, 1);
        (followed.rays, followed.sum.to_rgb8())
    };
    // Away from the mirror, and towards it.
    assert_eq!(followed(0.277), (1, [255, 0, 0]));
    assert_eq!(followed(-0.277), (2, [255, 0, 0]));
}

/// A ray that climbs to a mirror by less than 2⁻²⁸ of its length does not hit it, however long it is.
/// The surface would take it for a ray that does not climb, and show its other side.
#[test]
fn mirror_is_met_from_below_only_by_rays_that_climb() {
    let mut scene = Scenery::new();
    let mirror = Material::from_numbers([1; 3], 0, 0, (0, 1), 1).unwrap();
    let mirror = scene.add_material(mirror).unwrap();
    scene.add_sphere([0, 0, 3], 1, mirror).unwrap();
    scene.add_plane([0, 0, 0], [0, 0, 1], mirror).unwrap();
    let scene = scene.build().unwrap();
    let step = 2f64.powi(-scene.parts().grid.fraction_bits());
    let from = scene.parts().grid.place(Position::new([-11.0, 0.0, -step]));
    assert!(from.is_near());
    for climb in 1..9 {
        let direction = Direction::from_raw(Vector::new(1 << 30, 0, climb));
        let followed =
            followed_by::<BlinnPhong, Exact, _>(&scene, ScaledRay::new(from, direction), 1);
        assert_eq!(followed.rays, if climb < 4 { 1 } else { 2 }, "{climb}");
    }
}

/// Four mirrors with random shares α stand before a background. All have full brightness. Whatever a
/// path hits, the shares of its light add up to exactly one, so every pixel is exactly white.
#[test]
fn weights_add_up_to_exactly_one() {
    let mut sweep = Sweep::new(3);
    let (mut rays, mut whole) = (0, 0);
    for number in 0..400 {
        let mut scene = Scenery::new();
        let mut mirror = || {
            // A share from 0 to just below 1; both ends occur often.
            let bits = sweep.within(-(1 << 28), 5 << 28).clamp(0, (1 << 30) - 1);
            let mirror = f64::from(bits) / f64::from(1 << 30);
            scene
                .add_material(Material::from_numbers([1; 3], 1, 0, (0, 1), mirror).unwrap())
                .unwrap()
        };
        let ids: [_; 7] = core::array::from_fn(|_| mirror());
        for (id, at) in ids
            .into_iter()
            .zip([[0, 0, 0], [2, 0, 0], [1, 2, 0], [1, 1, 1]])
        {
            scene.add_sphere(at, 0.9, id).unwrap();
        }
        scene.add_plane([0, 0, -1], [0, 0, 1], ids[4]).unwrap();
        scene.add_plane([0, 4, 0], [0, 1, 0], ids[5]).unwrap();
        scene
            .add_cylinder([-2, 0, 0], [0.1, 0.2, 1.0], 0.7, 2, ids[6])
            .unwrap();
        scene.set_background([1; 3]).unwrap();
        let scene = scene.build().unwrap();
        let from = scene.parts().grid.place(Position::new([0.7, -3.0, 0.5]));
        for _ in 0..20 {
            let towards = sweep.triple(1000).map(|it| f64::from(it) / 700.0);
            let path = path(from, [towards[0], 1.0, towards[2]]);
            let traced = followed_by::<BlinnPhong, Exact, _>(&scene, path, 255);
            // Only what is cut off after 255 reflections may be missing.
            if traced.cut_off == Unit::ZERO {
                assert_eq!(
                    traced.sum.to_rgb8(),
                    [255; 3],
                    "scene {number}, {towards:?}"
                );
                whole += 1;
            }
            rays += traced.rays;
        }
    }
    assert!(rays > 12_000 && whole > 7900, "{rays} rays, {whole} paths");
}
