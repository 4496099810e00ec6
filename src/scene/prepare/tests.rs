use super::*;
use crate::camera::Camera;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::ray::BALL;
use crate::scene::Room;
use crate::scene::RuntimeScene;
use crate::vector::Position;

type Scenery = RuntimeScene<Room<4, 4, 4, 4, 4>>;

/// Returns a prepared scene of one white material, whose shapes `fill` has added.
fn scenery<T>(fill: impl FnOnce(&mut Scenery, crate::shape::MaterialId) -> T) -> Scenery {
    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    fill(&mut scene, white);
    scene
}

/// Returns a scene with a sphere of radius 1 at the origin, and the parts that `add` has added.
fn marble<T>(fill: impl FnOnce(&mut Scenery, crate::shape::MaterialId) -> T) -> Scenery {
    scenery(|scene, white| {
        scene.add_sphere([0, 0, 0], 1, white).unwrap();
        fill(scene, white);
    })
}

/// Returns the number of fraction bits of the scene's grid: a step is 2 to the power of minus this.
fn fraction_bits(scene: &Scenery) -> i32 {
    scene.plain().unwrap().grid.fraction_bits()
}

fn middle(scene: &Scenery) -> [f64; 3] {
    let Position(coordinates) = scene.plain().unwrap().grid.middle();
    coordinates.map(Number::to_f64)
}

#[test]
fn shapes_fill_the_ball_but_for_less_than_half() {
    let mut sweep = Sweep::new(1);
    for _ in 0..2000 {
        let factor = 2f64.powi(sweep.within(-26, 6));
        let scene = scenery(|scene, white| {
            scene.set_epsilon(factor).unwrap();
            for _ in 0..sweep.within(1, 4) {
                let center = sweep.triple(1000).map(|it| f64::from(it) * factor);
                let radius = f64::from(sweep.within(10, 1000)) * factor;
                scene.add_sphere(center, radius, white).unwrap();
            }
        });
        let grid = scene.plain().unwrap().grid;
        let furthest = scene.description().spheres.iter().map(|sphere| {
            let place = grid.place(sphere.center);
            assert!(place.is_near());
            let square = place.point.to_vector().square() as f64;
            square.sqrt() + f64::from(grid.length(sphere.radius).to_bits())
        });
        let furthest = furthest.fold(0.0, f64::max);
        // Rounding moves a coordinate and a radius by half a step each.
        let ball = f64::from(BALL);
        assert!(
            (ball * 0.499..ball + 2.0).contains(&furthest),
            "{furthest}: {scene:?}"
        );
    }
}

#[test]
fn middle_is_that_of_the_box_around_the_shapes() {
    let scene = scenery(|scene, white| {
        scene.add_sphere([10, 20, 30], 2, white).unwrap();
        // From 19 to 31, 17.5 to 29.5 and 15.5 to 27.5: half the height counts on every axis.
        let (center, axis) = ([25.0, 23.5, 21.5], [0, 0, 1]);
        scene.add_cylinder(center, axis, 1, 10, white).unwrap();
        scene.add_plane([900, 900, 900], [1, 2, 3], white).unwrap();
        scene.add_light([-900, 900, 900], [1, 1, 1]).unwrap();
    });
    assert_eq!(
        middle(&scene),
        [(8.0 + 31.0) / 2.0, (17.5 + 29.5) / 2.0, (15.5 + 32.0) / 2.0]
    );
}

#[test]
fn light_near_the_shapes_is_given_its_place_in_the_ball() {
    // Radius 1 takes 28 bits; a light up to 2, 4, 8, 16 and 32 times as far takes one more each.
    for (x, is_near, bits) in [
        (0.5, true, 28),
        (1.5, true, 27),
        (3.0, true, 26),
        (7.9, true, 25),
        (8.1, true, 24),
        (16.1, true, 23),
        (31.9, true, 23),
        (32.1, false, 28),
        (1e6, false, 28),
    ] {
        let scene = marble(|scene, _| scene.add_light([x, 0.0, 0.0], [1, 1, 1]).unwrap());
        let prepared = scene.plain().unwrap();
        assert_eq!(prepared.lights[0].place.is_near(), is_near, "{x}");
        assert_eq!(fraction_bits(&scene), bits, "{x}");
    }
}

#[test]
fn camera_is_near_if_small_shapes_and_epsilon_keep_their_bits() {
    // Epsilon is a thousandth of the radius and keeps 6 bits, so the camera is near up to 4194 radii. A small sphere keeps
    // 12 bits.
    for (away, small, is_near, bits) in [
        (31.0, 1.0, true, 23),
        (33.0, 1.0, true, 22),
        (4000.0, 1.0, true, 16),
        (4200.0, 1.0, false, 28),
        (60.0, 0.001, true, 22),
        (70.0, 0.001, false, 28),
    ] {
        let scene = marble(|scene, white| {
            scene.add_sphere([0, 0, 0], small, white).unwrap();
            let camera = Camera::new([away, 0.0, 0.0], [0, 0, 0], [0, 0, 1], 1).unwrap();
            scene.set_camera(camera);
        });
        let grid = scene.plain().unwrap().grid;
        let position = Position::from([away, 0.0, 0.0]);
        assert_eq!(grid.place(position).is_near(), is_near, "{away}");
        assert_eq!(fraction_bits(&scene), bits, "{away}");
    }
}

#[test]
fn far_light_costs_the_shapes_no_bits() {
    let alone = fraction_bits(&marble(|_, _| {}));
    for far in [100.0, 1e5, 1e9] {
        let scene = marble(|scene, _| scene.add_light([0.0, far, 0.0], [1, 1, 1]).unwrap());
        assert_eq!(fraction_bits(&scene), alone, "{far}");
    }
}

#[test]
fn far_plane_costs_the_shapes_no_bits_but_those_of_any_plane() {
    // Beside a plane the ball is eight times larger than the shapes need.
    let through = marble(|scene, white| {
        scene.add_plane([1e9, 0.5, 1e9], [0, 3, 0], white).unwrap();
    });
    let alone = fraction_bits(&marble(|_, _| {}));
    assert_eq!(fraction_bits(&through), alone - 3);
    for (away, bits) in [
        (1.5, 1),
        (31.9, 5),
        (32.1, 0),
        (100.0, 0),
        (1e5, 0),
        (1e9, 0),
    ] {
        let scene = marble(|scene, white| {
            scene.add_plane([0.0, away, 0.0], [0, 3, 0], white).unwrap();
        });
        assert_eq!(fraction_bits(&scene), alone - 3 - bits, "{away}");
    }
}

#[test]
fn scene_of_planes_alone_goes_by_the_nearest() {
    // 5 needs 3 bits before the point, and the ball is 256 times larger than that.
    for (away, bits) in [
        (5.0, 17),
        (7.9, 17),
        (8.1, 16),
        // 256 times 159 would leave a thousandth fewer steps than are wanted: 2^22 times that do.
        (159.0, 15),
        (161.0, 17),
        (1e9, 17),
    ] {
        let scene = scenery(|scene, white| {
            // A plane through the middle does not affect the size.
            scene.add_plane([1e9, 0.0, 7.0], [0, 1, 0], white).unwrap();
            scene.add_plane([0, 0, 5], [0, 0, 1], white).unwrap();
            scene.add_plane([away, 0.0, 0.0], [1, 0, 0], white).unwrap();
        });
        assert_eq!(fraction_bits(&scene), bits, "{away}");
    }
}

#[test]
fn scene_without_shapes_is_laid_around_its_lights_and_camera() {
    assert_eq!(fraction_bits(&scenery(|_, _| {})), 28);
    let lit = scenery(|scene, white| {
        scene.add_light([10, 0, 0], [1, 1, 1]).unwrap();
        scene.add_light([14, 0, 0], [1, 1, 1]).unwrap();
        scene.add_plane([0, 0, 5], [0, 0, 1], white).unwrap();
    });
    assert_eq!(middle(&lit), [12.0, 0.0, 0.0]);
    // The plane is 5 from the middle, the lights 2: 5 needs 3 bits before the point. Without shapes
    // the ball is 256 times larger than that.
    assert_eq!(fraction_bits(&lit), 25 - 8);
}

#[test]
fn size_below_64_steps_is_too_tiny() {
    // The large sphere's radius of 2^20 units is 2^28 steps: a step is 2^-8.
    let with = |radius: f64| {
        let scene = scenery(|scene, white| {
            scene.add_sphere([0, 0, 0], 1 << 20, white).unwrap();
            scene.add_sphere([1, 2, 3], radius, white).unwrap();
        });
        scene.plain().map(|_| ())
    };
    assert_eq!(with(64.0 / 256.0), Ok(()));
    assert_eq!(
        with(63.49 / 256.0),
        Err(Error::at("sphere", 1, ErrorKind::Tiny))
    );
    let with = |radius: f64, height: f64| {
        let scene = scenery(|scene, white| {
            scene.add_sphere([0, 0, 0], 1 << 20, white).unwrap();
            let (center, axis) = ([1, 2, 3], [1, 0, 0]);
            scene
                .add_cylinder(center, axis, radius, height, white)
                .unwrap();
        });
        scene.plain().map(|_| ())
    };
    assert_eq!(with(64.0 / 256.0, 128.0 / 256.0), Ok(()));
    assert_eq!(
        with(63.49 / 256.0, 1.0),
        Err(Error::at("cylinder", 0, ErrorKind::Tiny))
    );
    assert_eq!(
        with(1.0, 126.9 / 256.0),
        Err(Error::at("cylinder", 0, ErrorKind::Tiny))
    );
}

#[test]
fn scene_smaller_than_the_format_is_refused() {
    let with = |radius: f64| {
        let scene = scenery(|scene, white| scene.add_sphere([5, 5, 5], radius, white).unwrap());
        // Epsilon must stay below the ball.
        let mut scene = scene;
        scene.set_epsilon(2f64.powi(-40)).unwrap();
        scene.plain().map(|scene| scene.grid.fraction_bits())
    };
    assert_eq!(with(2f64.powi(-30)), Ok(58));
    assert_eq!(
        with(2f64.powi(-30) * 0.99),
        Err(Error::of("scene", ErrorKind::Extent))
    );
}

#[test]
fn epsilon_is_at_least_what_a_hit_may_be_off() {
    let with = |epsilon: f64| {
        let mut scene = marble(|_, _| {});
        scene.set_epsilon(epsilon).unwrap();
        scene.plain().map(|scene| scene.epsilon.to_bits())
    };
    let step = 2f64.powi(-28);
    assert_eq!(with(1000.0 * step), Ok(1000));
    // A ray that leaves a surface must not hit it again; the tests of shading check this.
    assert_eq!(with(step), Ok(SMALLEST_EPSILON));
    let more = SMALLEST_EPSILON + 1;
    assert_eq!(with(f64::from(more) * step), Ok(more));
    assert_eq!(with(1.0 - step), Ok(BALL - 1));
    assert_eq!(with(1.0), Err(Error::of("scene", ErrorKind::Epsilon)));
    assert_eq!(with(1e9), Err(Error::of("scene", ErrorKind::Epsilon)));
}

#[test]
fn shape_below_the_default_epsilon_is_at_fault() {
    let with = |epsilon: f64| {
        let mut scene = scenery(|scene, white| {
            scene.add_plane([0, 0, 0], [0, 0, 1], white).unwrap();
            scene.add_sphere([0, 0, 1], 1e-9, white).unwrap();
        });
        scene.set_epsilon(epsilon).unwrap();
        scene.plain().map(|_| ())
    };
    let fault = Err(Error::at("sphere", 0, ErrorKind::BelowEpsilon));
    assert_eq!(with(0.001), fault);
    assert_eq!(with(1e-7), fault);
    assert_eq!(with(1e-10), Ok(()));
    assert_eq!(with(0.0011), Err(Error::of("scene", ErrorKind::Epsilon)));
}

#[test]
fn epsilon_inside_is_at_least_eight_steps_or_sixteen_with_cylinders() {
    let with = |scene: &mut Scenery, steps: f64| {
        scene.set_epsilon(steps * 2f64.powi(-28)).unwrap();
        let scene = scene.plain().unwrap();
        [scene.epsilon, scene.inner_epsilon].map(Length::to_bits)
    };
    let mut scene = marble(|_, _| {});
    assert_eq!(with(&mut scene, 5.4), [5, 8]);
    assert_eq!(with(&mut scene, 8.6), [9, 9]);
    // The cylinder lies in the marble: the grid is the same.
    let mut scene = marble(|scene, white| {
        scene
            .add_cylinder([0; 3], [0, 0, 1], 0.25, 0.5, white)
            .unwrap();
    });
    assert_eq!(with(&mut scene, 5.4), [5, 16]);
    assert_eq!(with(&mut scene, 17.0), [17, 17]);
}

#[test]
fn scene_of_planes_alone_takes_any_epsilon() {
    for epsilon in [1e-15, 1e-3, 1.0, 2f64.powi(30)] {
        let mut scene = scenery(|scene, white| {
            scene.add_plane([0, 0, -1], [0, 0, 1], white).unwrap();
        });
        scene.set_epsilon(epsilon).unwrap();
        let steps = scene.plain().unwrap().epsilon.to_bits();
        assert!((SMALLEST_EPSILON..BALL).contains(&steps), "{steps}");
        let too_much = scene.set_epsilon(2f64.powi(30) * 1.01);
        assert_eq!(too_much, Err(Error::of("scene", ErrorKind::Epsilon)));
    }
}

#[test]
fn light_further_than_four_million_epsilons_is_far() {
    let is_near = |epsilon: f64| {
        let mut scene = marble(|scene, _| scene.add_light([0, 0, 20], [1, 1, 1]).unwrap());
        scene.set_epsilon(epsilon).unwrap();
        scene.plain().unwrap().lights[0].place.is_near()
    };
    let epsilon = 20.0 * 2f64.powi(-22);
    assert!(is_near(1.01 * epsilon));
    assert!(!is_near(0.99 * epsilon));
}

#[test]
fn material_may_shine_up_to_thirty() {
    let with = |color: f64, ambient: f64, diffuse: f64, specular: f64, lights: &[f64]| {
        let mut scene = Scenery::new();
        let highlight = (specular, 4);
        let made = Material::from_numbers([color; 3], ambient, diffuse, highlight, 0);
        scene.add_material(made.unwrap()).unwrap();
        for &light in lights {
            scene.add_light([1, 2, 3], [0.0, light, 0.0]).unwrap();
        }
        scene.plain().map(|_| ())
    };
    let too_bright = Err(Error::at("material", 0, ErrorKind::Brightness));
    assert_eq!(with(1.0, 16.0, 14.0, 0.0, &[1.0]), Ok(()));
    assert_eq!(with(1.0, 16.0, 13.0, 1.0, &[1.0]), Ok(()));
    assert_eq!(with(1.0, 16.0, 13.0, 1.1, &[1.0]), too_bright);
    assert_eq!(with(1.0, 2.0, 14.0, 0.0, &[1.0, 1.0]), Ok(()));
    assert_eq!(with(1.0, 2.1, 14.0, 0.0, &[1.0, 1.0]), too_bright);
    assert_eq!(with(2.0, 1.0, 14.0, 0.0, &[1.0]), Ok(()));
    assert_eq!(with(2.1, 1.0, 14.0, 0.0, &[1.0]), too_bright);
    // The sum before the multiplication by the colour is limited, too, even if the colour is dark.
    assert_eq!(with(0.01, 1.0, 2.0, 0.0, &[16.0]), too_bright);
    assert_eq!(with(0.01, 1.0, 15.0, 16.0, &[0.1]), too_bright);
    // What is black shines nowhere.
    assert_eq!(with(0.0, 1.0, 15.0, 16.0, &[0.1]), Ok(()));
    assert_eq!(with(16.0, 1.8, 16.0, 16.0, &[]), too_bright);
}

#[test]
fn brightest_scene_that_is_allowed_does_not_overflow() {
    let mut scene = Scenery::new();
    let made = Material::from_numbers([1, 1, 1], 2, 7, (7, 0), 0).unwrap();
    let bright = scene.add_material(made).unwrap();
    scene.add_plane([0, 0, 0], [0, 0, 1], bright).unwrap();
    scene.add_light([0, 0, 1], [1, 1, 1]).unwrap();
    scene.add_light([0, 0, 1], [1, 1, 1]).unwrap();
    assert!(scene.plain().is_ok());
}

#[test]
fn plane_goes_through_its_point() {
    let mut sweep = Sweep::new(2);
    for _ in 0..2000 {
        let point = sweep.triple(1000).map(|it| f64::from(it) / 2048.0);
        let normal = sweep.triple(1000).map(|it| f64::from(it) + 0.5);
        let scene = marble(|scene, white| scene.add_plane(point, normal, white).unwrap());
        let prepared = scene.plain().unwrap();
        let at = prepared.grid.place(Position::new(point)).point;
        // The point lies on the grid and in the ball, and the offset is rounded down to 2^-30 steps.
        let height = prepared.planes[0].height(at);
        assert!((0..=1).contains(&height), "{height}: {point:?} {normal:?}");
    }
}

#[test]
fn brightest_is_what_a_material_sends_on_of_all_lights() {
    let mut scene = Scenery::new();
    let dark = Material::new([0.5, 0.25, 0.0]).ambient(0.5).diffuse(0.0);
    let bright = Material::new([0.5, 1.0, 0.25])
        .ambient(0.25)
        .diffuse(1.0)
        .specular(0.5, 9.0);
    for material in [dark, bright] {
        scene.add_material(material).unwrap();
    }
    for color in [[1, 2, 1], [4, 1, 4]] {
        scene.add_light([0, 0, 9], color).unwrap();
    }
    let prepared = scene.plain().unwrap();
    let brightest = prepared.brightest.to_num::<f64>() * 256.0 / 255.0;
    // Green: (0.25 + 1.5 * 3) * 1; red: (0.25 + 1.5 * 5) * 0.5.
    assert!((4.75..4.751).contains(&brightest), "{brightest}");
}

#[test]
fn background_may_be_the_brightest() {
    let mut scene = marble(|_, _| {});
    scene.set_background([1, 7, 2]).unwrap();
    let brightest = scene.plain().unwrap().brightest.to_num::<f64>();
    assert!(
        (brightest - 7.0 * 255.0 / 256.0).abs() < 1e-6,
        "{brightest}"
    );
}

#[test]
fn dimness_is_one_over_the_brightest_rounded_down_to_eight_bits() {
    let mut sweep = Sweep::new(33);
    let edges = [1 << 26, (1 << 26) + 1, 30 << 26, i32::MAX];
    let swept = (0..1000).map(|_| sweep.octaves(20, 30));
    for bits in edges.into_iter().chain(swept) {
        let brightest = Brightness::from_bits(bits);
        let (dimness, most) = (
            dimness(brightest).to_num::<f64>(),
            brightest.to_num::<f64>(),
        );
        let exact = 1.0 / most.max(1.0);
        assert!(
            dimness <= exact && dimness > exact * (1.0 - 1.0 / 128.0),
            "{most}: {dimness}"
        );
    }
}

#[test]
fn sphere_touches_what_epsilon_may_lift_points_from() {
    let touches = |fill: &dyn Fn(&mut Scenery, crate::shape::MaterialId)| {
        let scene = marble(|scene, white| fill(scene, white)).plain().unwrap();
        touches_another(&scene.parts(), 0)
    };
    // Epsilon is 0.001.
    for (gap, is_touching) in [(-0.5, true), (0.001, true), (0.01, false), (1.0, false)] {
        let far = 2.0 + gap;
        assert_eq!(
            touches(&|scene, white| {
                scene.add_sphere([far, 0.0, 0.0], 1, white).unwrap();
            }),
            is_touching,
            "{gap}"
        );
        assert_eq!(
            touches(&|scene, white| {
                let below = [0.0, 0.0, -1.0 - gap];
                scene.add_plane(below, [0, 0, 1], white).unwrap();
            }),
            is_touching,
            "{gap}"
        );
    }
    // The test compares the ball around a cylinder.
    for (away, is_touching) in [(2.0, true), (2.4, true), (2.5, false)] {
        let touches = touches(&|scene, white| {
            let center = [away, 0.0, 0.0];
            scene.add_cylinder(center, [0, 0, 1], 1, 2, white).unwrap();
        });
        assert_eq!(touches, is_touching, "{away}");
    }
}
