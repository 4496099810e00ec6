//! Tests: the light at one hit, with and without culling.

use super::*;
use crate::color::Color;
use crate::scene::Room;
use crate::shade::{Phong, Visibility};
use crate::trace::visibility::{Culled, Plain};

pub(super) type Scenery = RuntimeScene<Room<2, 2, 1, 4, 2>>;
type Built = Scene<Room<2, 2, 1, 4, 2>>;

/// Step of a colour: Q6.26.
const STEP: f64 = 1.0 / (1 << 26) as f64;

/// Largest error of a product of two colours: it is rounded down to this.
const TINT: f64 = 1.0 / (1 << 20) as f64;

/// Error of the length of a normal where a sphere with a radius of 2²⁴ steps is hit head-on along an
/// axis. A distance is known to one or two steps, and a coordinate is rounded to an even one.
const LENGTH: f64 = 4.0 / (1 << 24) as f64;

/// Largest error of a colour if the light comes from straight ahead and half of it is scattered. It is
/// multiplied by the light and by the material. The cosine is one, apart from the error of the normal's
/// length.
const STRAIGHT: f64 = 2.0 * TINT + 0.5 * LENGTH;

fn scenery<T>(material: Material, fill: impl FnOnce(&mut Scenery) -> T) -> Built {
    let mut scene = Scenery::new();
    let made = scene.add_material(material).unwrap();
    scene.add_sphere([0, 0, 0], 1, made).unwrap();
    fill(&mut scene);
    scene.build().unwrap()
}

/// Returns a colour divided by 255/256: the levels of a colour are 255 of 256 parts.
fn whole(color: Color) -> [f64; 3] {
    color
        .components()
        .map(|it| it.to_num::<f64>() * 256.0 / 255.0)
}

/// Returns the colour of a surface, with culling and by the plain path.
pub(super) fn colors<K: Shading, W: World>(
    world: &W,
    view: &LightVisibility,
    surface: &Surface<'_>,
) -> [Color; 2] {
    [
        K::color::<W, Fast, _>(world, surface, &Culled::<W, Fast>::new(world, view)).color,
        K::color::<W, Small, _>(world, surface, &Plain::<W, Small>::new(world)).color,
    ]
}

/// Returns the colour of the surface that a ray from `from` in direction `towards` hits.
fn seen<K: Shading>(scene: &Built, from: [f64; 3], towards: [f64; 3]) -> [f64; 3] {
    let parts = scene.parts();
    let from = parts.grid.place(Position::new(from));
    let direction = Position::new(towards).direction().unwrap();
    let path = ScaledRay::new(from, direction);
    let (at, shape) = first(scene, &path, ShapeId::NONE).unwrap();
    let surface = Surface::new(scene, at, shape, direction).unwrap();
    let view = LightVisibility::new(scene, from);
    let [fast, small] = colors::<K, _>(scene, &view, &surface).map(whole);
    for (fast, small) in fast.into_iter().zip(small) {
        assert!((fast - small).abs() < 1e-6, "{fast}, small {small}");
    }
    fast
}

/// Returns the colour of the sphere's point that is nearest to (5, 0, 0), seen from there.
fn facing<K: Shading>(scene: &Built) -> [f64; 3] {
    seen::<K>(scene, [5.0, 0.0, 0.0], [-1.0, 0.0, 0.0])
}

fn assert_color(found: [f64; 3], truth: [f64; 3], bound: f64) {
    for channel in 0..3 {
        let off = (found[channel] - truth[channel]).abs();
        assert!(off <= bound, "{found:?}, not {truth:?}");
    }
}

const RED: Material = Material::new([1.0, 0.25, 0.0]).ambient(0.125).diffuse(0.5);

#[test]
fn surface_without_light_shows_its_ambient_share() {
    let scene = scenery(RED, |_| {});
    assert_color(facing::<BlinnPhong>(&scene), [0.125, 0.03125, 0.0], 0.0);
    assert_color(facing::<Phong>(&scene), [0.125, 0.03125, 0.0], 0.0);
}

#[test]
fn light_overhead_is_scattered_whole() {
    let scene = scenery(RED, |scene| {
        scene.add_light([9, 0, 0], [1.0, 1.0, 0.5]).unwrap()
    });
    assert_eq!(scene.parts().grid.fraction_bits(), 24);
    assert_color(
        facing::<BlinnPhong>(&scene),
        [0.625, 0.15625, 0.0],
        STRAIGHT,
    );
}

#[test]
fn light_aside_is_scattered_by_its_cosine() {
    // 60 degrees aside, so far that the distance does not matter.
    let (x, y) = (1e6, 1e6 * 3f64.sqrt());
    let scene = scenery(RED, |scene| {
        scene.add_light([x, y, 0.0], [1, 1, 1]).unwrap()
    });
    // The sphere's radius of 1 is 2^-21 of the distance. The material's colour is multiplied, too.
    assert_color(
        facing::<Phong>(&scene),
        [0.375, 0.09375, 0.0],
        2f64.powi(-21) + 2.0 * TINT,
    );
}

#[test]
fn light_behind_the_surface_adds_nothing() {
    for position in [[-9, 0, 0], [-9, 8, 0], [0, 9, 0], [0, 0, -9], [1, 9, 0]] {
        let scene = scenery(RED, |scene| scene.add_light(position, [1, 1, 1]).unwrap());
        assert_color(facing::<BlinnPhong>(&scene), [0.125, 0.03125, 0.0], 0.0);
    }
}

#[test]
fn lights_add_up() {
    let lit = |count: usize| {
        let scene = scenery(RED, |scene| {
            for _ in 0..count {
                scene.add_light([9, 1, 2], [0.5, 0.25, 0.125]).unwrap();
            }
        });
        facing::<BlinnPhong>(&scene)
    };
    let (none, one) = (lit(0), lit(1));
    for count in 2..=4 {
        let sum = [0, 1, 2].map(|it| none[it] + (one[it] - none[it]) * count as f64);
        // On one side, each light is multiplied by the colour separately.
        assert_color(lit(count), sum, (count + 1) as f64 * TINT);
    }
}

#[test]
fn black_surface_absorbs_everything() {
    let black = Material::new([0.0; 3])
        .ambient(1.0)
        .diffuse(16.0)
        .specular(12.0, 3.0);
    let scene = scenery(black, |scene| {
        scene.add_light([9, 0, 0], [1, 1, 1]).unwrap()
    });
    assert_eq!(facing::<BlinnPhong>(&scene), [0.0; 3]);
    assert_eq!(facing::<Phong>(&scene), [0.0; 3]);
}

#[test]
fn light_of_one_colour_shows_nothing_of_another() {
    let scene = scenery(RED.ambient(0.0), |scene| {
        scene.add_light([9, 0, 0], [0, 0, 1]).unwrap()
    });
    assert_eq!(facing::<BlinnPhong>(&scene), [0.0; 3]);
}

#[test]
fn surface_sends_out_no_more_than_its_share_of_the_light() {
    let chalk = Material::new([1.0; 3])
        .ambient(0.0)
        .diffuse(0.75)
        .specular(0.25, 0.5);
    let mut sweep = Sweep::new(1);
    for _ in 0..20_000 {
        let light = sweep.triple(1000).map(|it| f64::from(it) / 100.0);
        let from = sweep.triple(1000).map(|it| f64::from(it) / 100.0);
        if from.into_iter().all(|it| it.abs() < 1.0) {
            continue;
        }
        let scene = scenery(chalk, |scene| scene.add_light(light, [1, 1, 1]).unwrap());
        let towards = from.map(|it| -it);
        for [red, ..] in [
            seen::<BlinnPhong>(&scene, from, towards),
            seen::<Phong>(&scene, from, towards),
        ] {
            // A cosine of one is known to 2^-27.
            assert!(
                (0.0..=1.0 + 4.0 * STEP).contains(&red),
                "{red}: {light:?} {from:?}"
            );
        }
    }
}

/// Returns how bright a white floor at z = 0 is at the origin, seen from (0, 3, 4).
fn floor_lit_from<T>(light: [f64; 3], fill: impl FnOnce(&mut Scenery) -> T) -> f64 {
    let mut scene = Scenery::new();
    let white = Material::new([1.0; 3]).ambient(0.0).diffuse(1.0);
    let white = scene.add_material(white).unwrap();
    scene.add_plane([0, 0, 0], [0, 0, 1], white).unwrap();
    scene.add_sphere([0, 0, -7], 1, white).unwrap();
    scene.add_light(light, [1, 1, 1]).unwrap();
    fill(&mut scene);
    seen::<BlinnPhong>(&scene.build().unwrap(), [0.0, 3.0, 4.0], [0.0, -3.0, -4.0])[0]
}

#[test]
fn floor_darkens_evenly_to_black_where_the_light_sinks_into_it() {
    // The ray to the light starts epsilon above the floor. Its cosine is that of the remaining height.
    for height in [4.0, 1.0, 0.5, 0.1, 0.01, 0.002, 0.0011] {
        let rest: f64 = height - 0.001;
        let cosine = rest / (16.0 + rest * rest).sqrt();
        let found = floor_lit_from([-4.0, 0.0, height], |_| {});
        // The colours of the light and of the material are multiplied, and the factor of the light's
        // colour is rounded down to 2^-24. Epsilon and the light's height are rounded to half a step of
        // 2^-21, which counts a quarter at a distance of 4.
        assert!(
            (found - cosine).abs() <= 2.0 * TINT + 3.0 * 2f64.powi(-24) + 2f64.powi(-28),
            "{found}, not {cosine}, at {height}"
        );
    }
    for height in [0.001 - 1e-6, 0.0, -0.1, -4.0] {
        assert_eq!(
            floor_lit_from([-4.0, 0.0, height], |_| {}),
            0.0,
            "at {height}"
        );
    }
}

#[test]
fn floor_is_dark_where_something_hides_the_light() {
    let dot = |x: f64| {
        floor_lit_from([-4.0, 0.0, 4.0], |scene| {
            let white = scene.description().planes[0].material;
            scene
                .add_sphere([-2.0 + x, 0.0, 2.0 + x], 0.125, white)
                .unwrap();
        })
    };
    assert_eq!(dot(0.0), 0.0);
    // The sphere moves by x along two axes, so its centre is √2 · x from the ray to the light.
    let rim = 0.125 * 0.5_f64.sqrt();
    for (x, hides) in [
        (rim - 1e-3, true),
        (rim + 1e-3, false),
        (1e-3 - rim, true),
        (-rim - 1e-3, false),
    ] {
        assert_eq!(dot(x) == 0.0, hides, "{x} aside");
    }
}

#[test]
fn surface_is_hidden_from_a_light_behind_its_own_sphere() {
    // Seen from (5, 0, 0), a point low on the sphere; the light is high, over the horizon of it.
    let scene = scenery(RED, |scene| scene.add_light([1, 0, 9], [1, 1, 1]).unwrap());
    let low = seen::<BlinnPhong>(&scene, [5.0, 0.0, -0.5], [-1.0, 0.0, 0.0]);
    assert_color(low, [0.125, 0.03125, 0.0], 0.0);
    let [high, ..] = seen::<BlinnPhong>(&scene, [5.0, 0.0, 0.5], [-1.0, 0.0, 0.0]);
    assert!(high > 0.3, "{high}");
}

#[test]
fn light_in_the_plane_of_a_surface_makes_no_highlight() {
    let lit = |height: f64| {
        let mut scene = Scenery::new();
        let glossy = Material::new([1.0; 3]).ambient(0.0).diffuse(0.0);
        let glossy = scene.add_material(glossy.specular(0.5, 0.0)).unwrap();
        scene.add_plane([0, 0, 0], [0, 0, 1], glossy).unwrap();
        scene.add_light([-4.0, 0.0, height], [1, 1, 1]).unwrap();
        scene.add_sphere([0, 0, -7], 1, glossy).unwrap();
        scene.set_epsilon(1.0 / 1024.0).unwrap();
        let scene = scene.build().unwrap();
        seen::<BlinnPhong>(&scene, [0.0, 3.0, 4.0], [0.0, -3.0, -4.0])[0]
    };
    // The ray to the light starts epsilon above the surface.
    assert_eq!(lit(1.0 / 1024.0), 0.0);
    assert_eq!(lit(1.1 / 1024.0), 0.5);
}

#[test]
fn shape_nearer_to_a_surface_than_epsilon_casts_no_shadow_on_it() {
    let lit = |epsilon: f64| {
        let mut scene = Scenery::new();
        let white = Material::new([1.0; 3]).ambient(0.0).diffuse(0.5);
        let white = scene.add_material(white).unwrap();
        scene.add_plane([0, 0, 0], [0, 0, 1], white).unwrap();
        // Between the origin and the light, and below a height of 0.04.
        scene.add_sphere([0.02, 0.0, 0.02], 0.01, white).unwrap();
        scene.add_light([4, 0, 4], [1, 1, 1]).unwrap();
        scene.set_epsilon(epsilon).unwrap();
        let scene = scene.build().unwrap();
        seen::<BlinnPhong>(&scene, [-3.0, 0.0, 3.0], [1.0, 0.0, -1.0])[0] > 0.0
    };
    assert!(!lit(0.001));
    assert!(lit(0.03));
}

#[test]
fn sphere_does_not_shadow_itself_however_small_epsilon_is() {
    // Seen from the largest distance of near rays, where a hit is rounded most. The scene is as large
    // as two small spheres at its ends make it.
    let mut scene = Scenery::new();
    let white = Material::new([1.0; 3]).ambient(0.0).diffuse(1.0);
    let white = scene.add_material(white).unwrap();
    scene.add_sphere([-0.55; 3], 0.04, white).unwrap();
    scene.add_sphere([0.55; 3], 0.04, white).unwrap();
    scene.add_light([90, 90, 80], [1, 1, 1]).unwrap();
    scene.set_epsilon(1e-15).unwrap();
    let scene = scene.build().unwrap();
    let from = [1.49, 1.49, 1.2];
    let mut sweep = Sweep::new(4);
    for _ in 0..50_000 {
        let aim = sweep.triple(1000).map(|it| f64::from(it) * 1e-5 - 0.55);
        let towards = [0, 1, 2].map(|axis| aim[axis] - from[axis]);
        let [brightness, ..] = seen::<BlinnPhong>(&scene, from, towards);
        // The hit lies at most half a radius aside, and the light stands 2 degrees aside.
        assert!(brightness > 0.8, "{brightness}: {aim:?}");
    }
}

#[test]
fn inside_of_a_surface_is_lit_from_inside() {
    for (light, truth) in [([0, 0, 0], 0.625), ([9, 0, 0], 0.125)] {
        let scene = scenery(RED, |scene| scene.add_light(light, [1, 1, 1]).unwrap());
        let [red, ..] = seen::<BlinnPhong>(&scene, [0.5, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert!((red - truth).abs() <= STRAIGHT, "{red}, not {truth}");
    }
}

#[test]
fn highlight_without_shininess_is_everywhere_the_light_is() {
    let glossy = Material::new([1.0; 3])
        .ambient(0.0)
        .diffuse(0.0)
        .specular(0.5, 0.0);
    let scene = scenery(glossy, |scene| {
        scene.add_light([9, 9, 0], [1, 1, 1]).unwrap()
    });
    assert_eq!(facing::<BlinnPhong>(&scene), [0.5; 3]);
    assert_eq!(facing::<Phong>(&scene), [0.5; 3]);
}

#[test]
fn phong_highlight_of_shininess_0_ends_where_the_mirrored_light_points_away() {
    let even = Material::new([1.0; 3])
        .ambient(0.0)
        .diffuse(0.0)
        .specular(0.5, 0.0);
    // The point (1, 0, 0) is seen at 60 degrees; a light on the viewer's own side, at 20 and at 60.
    for (degrees, phong) in [(20.0_f64, 0.5), (60.0, 0.0)] {
        let light = [
            1.0 + 9.0 * degrees.to_radians().cos(),
            9.0 * degrees.to_radians().sin(),
            0.0,
        ];
        let scene = scenery(even, |scene| scene.add_light(light, [1, 1, 1]).unwrap());
        let eye = [1.0 + 0.5, 0.75_f64.sqrt(), 0.0];
        let towards = [-0.5, -(0.75_f64.sqrt()), 0.0];
        assert_eq!(seen::<Phong>(&scene, eye, towards), [phong; 3], "{degrees}");
        assert_eq!(seen::<BlinnPhong>(&scene, eye, towards), [0.5; 3]);
    }
}

#[test]
fn highlight_is_whole_in_the_mirror_direction_and_for_all_kinds() {
    let glossy = Material::new([1.0; 3])
        .ambient(0.0)
        .diffuse(0.0)
        .specular(0.5, 9.5);
    let scene = scenery(glossy, |scene| {
        scene.add_light([9, 0, 0], [1, 1, 1]).unwrap()
    });
    assert_eq!(scene.parts().grid.fraction_bits(), 24);
    // A cosine of 1 is known to 2^-27, and its power ten times worse. Two products follow. The error of
    // the normal's length counts once in the half-way cosine, and four times in 2 (n·l) (n·v) - l·v.
    let bound = |times: f64| 16.0 * STEP + 2.0 * TINT + 0.5 * 9.5 * times * LENGTH;
    assert_color(facing::<BlinnPhong>(&scene), [0.5; 3], bound(1.0));
    assert_color(facing::<Phong>(&scene), [0.5; 3], bound(4.0));
}

#[test]
fn normals_are_shown_as_colours() {
    let scene = scenery(RED, |_| {});
    assert_color(facing::<Normals>(&scene), [1.0, 0.5, 0.5], 2f64.powi(-20));
    let above = seen::<Normals>(&scene, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    assert_color(above, [0.5, 0.5, 1.0], 2f64.powi(-20));
    let inside = seen::<Normals>(&scene, [0.0; 3], [0.0, 1.0, 0.0]);
    assert_color(inside, [0.5, 0.0, 0.5], 2f64.powi(-20));
}

#[test]
fn miss_is_the_background_and_blue_among_normals() {
    let scene = scenery(RED, |scene| scene.set_background([0.5, 0.25, 2.0]).unwrap());
    let ahead = Position::new([0.0, 1.0, 0.0]).direction().unwrap();
    let missed = [
        <BlinnPhong as Shading>::missed(&scene, ahead),
        <Phong as Shading>::missed(&scene, ahead),
        <Normals as Shading>::missed(&scene, ahead),
    ];
    let background = [0.5, 0.25, 2.0];
    let expected = [background, background, [0.0, 0.0, 1.0]];
    assert_eq!(missed.map(|it| whole(it.color)), expected);
}

/// The horizon, straight up, straight down, and 30 degrees above.
#[test]
fn miss_is_the_sky_in_the_direction_of_the_ray() {
    let (below, horizon, above) = ([0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 0.25, 2.0]);
    let scene = scenery(RED, |scene| {
        scene.set_sky([0, 0, 4], [below, horizon, above]).unwrap();
    });
    let seen = |z: f64| {
        let direction = Position::new([(1.0 - z * z).sqrt(), 0.0, z]).direction();
        let seen = <Phong as Shading>::missed(&scene, direction.unwrap());
        (
            seen.color
                .components()
                .map(|it| it.to_num::<f64>() * 256.0 / 255.0),
            seen.note(),
        )
    };
    let half_way = [0.5, 0.375, 1.0];
    for (z, color) in [(0.0, horizon), (1.0, above), (-1.0, below), (0.5, half_way)] {
        let (found, _) = seen(z);
        for axis in 0..3 {
            assert!(
                (found[axis] - color[axis]).abs() < 2f64.powi(-18),
                "{z}: {found:?}"
            );
        }
    }
    // Paths that end in the sky above and below the horizon have different signatures.
    assert_ne!(seen(0.01).1, seen(-0.01).1);
}

/// A sphere may be so small for its distance from the light that the length of its tangents does not tell what it hides.
/// It hides the points behind it all the same, and no others. The light still counts as plain.
#[test]
fn a_small_sphere_far_from_a_light_hides_what_is_behind_it() {
    let mut scene = RuntimeScene::<Room<2, 1, 0, 1, 1>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    let (radius, far) = (0.0003, 1.0);
    scene.add_sphere([0, 0, 0], radius, white).unwrap();
    scene.add_sphere([0, 3, 0], 1, white).unwrap();
    scene.add_plane([2, 0, 0], [-1, 0, 0], white).unwrap();
    scene.add_light([-far, 0.0, 0.0], [1, 1, 1]).unwrap();
    let scene = scene.build().unwrap();
    let (parts, lights) = (scene.parts(), scene.tables().light_occluders);
    let light = lights[0].light();
    assert!(light.is_plain && light.has_small);
    let visibility = LightVisibility::new(&&scene, ScaledPoint::at(light.place.point));
    assert!(visibility.is_clear(0));
    let floor = ShapeId::at(parts.bounded());
    let mut surface = Surface::new(&scene, ScaledPoint::ORIGIN, floor, Direction::X).unwrap();
    for aside in [0, 9, 10, 15, 17, 25] {
        // How far from the sphere's centre the ray passes. It is given in sixteenths of the radius.
        let aside = radius * f64::from(aside) / 16.0;
        for (x, is_behind) in [
            (-far / 2.0, false),
            (-2.0 * radius, false),
            (2.0 * radius, true),
            (far / 2.0, true),
        ] {
            surface.place = parts
                .grid
                .place(Position::new([x, aside * (far + x) / far, 0.0]));
            let ray = light
                .place
                .point
                .to(surface.place.point)
                .direction_and_length();
            let hides = is_behind && aside < radius;
            let light = (&lights[0], 0);
            assert_eq!(
                Culled::<_, Fast>::new(&&scene, &visibility)
                    .is_occluded_from::<false>(&surface, light, ray),
                hides,
                "{aside} {x}"
            );
            assert_eq!(
                Culled::<_, Exact>::new(&&scene, &visibility)
                    .is_occluded_from::<true>(&surface, light, ray),
                hides,
                "{aside} {x}"
            );
        }
    }
}
