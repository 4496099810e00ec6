//! Tests that any valid scene is drawn like the double-precision reference draws it, and that no pixel
//! is further off than its bound.

use std::cell::{Cell, RefCell};

use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use reflet::__private::Drawable;
use reflet::host::compare::{Difference, compare};
use reflet::host::painted;
use reflet::host::precision;
use reflet::host::reference::bound::Paths;
use reflet::host::reference::{self, Vector, render};
use reflet::quality::{Exact, Fast, Quality};
use reflet::shading::{Normals, Phong};
use reflet::{Camera, Error, FrameBuilder, Material, MaterialId, RuntimeScene, room};

#[path = "../../common/bound.rs"]
mod held;

use held::{ending, held};

const SIDE: u32 = 48;

/// Smallest share of the pixels within 8 of the reference in every scene; `WITHIN_1` is that within
/// 1. They are below 1 because a ray at a rim may miss the shape. In most scenes no pixel differs.
const WITHIN_8: f64 = 0.99;
const WITHIN_1: f64 = 0.98;

type Triple = [f64; 3];
type Scenery =
    RuntimeScene<room!(spheres: 16, planes: 4, cylinders: 6, discs: 4, lights: 4, materials: 4)>;

/// A scene in a cube of ±1, and the size and position to which the cube is scaled and moved.
#[derive(Clone, Debug)]
struct Recipe {
    materials: Vec<Surface>,
    spheres: Vec<(Triple, f64, usize)>,
    planes: Vec<(Triple, Triple, usize)>,
    cylinders: Vec<(Triple, Triple, (f64, f64), usize)>,
    discs: Vec<(Triple, Triple, f64, usize)>,
    lights: Vec<(Triple, f64, Triple)>,
    /// Whether lights fall off, with ranges that depend on their red.
    fades: bool,
    background: Triple,
    /// Direction straight up, and the colours below and above: the background is that at the horizon.
    sky: Option<(Triple, Triple, Triple)>,
    eye: Eye,
    target: Triple,
    up: Triple,
    scale: f64,
    offset: Triple,
    reflections: u8,
    shading: reference::Shading,
}

#[derive(Clone, Debug)]
struct Surface {
    color: Triple,
    ambient: f64,
    diffuse: f64,
    specular: f64,
    shininess: f64,
    mirror: f64,
    /// Colour and size of the cells of a checker.
    checker: Option<(Triple, Triple)>,
}

/// Position of the camera relative to the scene's cube, and its field of view in degrees.
#[derive(Clone, Debug)]
enum Eye {
    /// Puts the camera at a random place among the shapes.
    Within(Triple, f64),
    /// In the sphere of this number, or at a fixed point if there are no spheres.
    InSphere(usize, f64),
    /// In this direction, at this distance in sizes of the scene.
    Away(Triple, f64, f64),
}

fn triple(range: std::ops::Range<f64>) -> impl Strategy<Value = Triple> {
    prop::array::uniform3(range)
}

fn surface() -> impl Strategy<Value = Surface> {
    let shininess = prop_oneof![
        (0..=16_i32).prop_map(f64::from),
        prop::sample::select(vec![32.0, 50.0, 128.0]),
        0.0..200.0,
    ];
    let mirror = prop_oneof![3 => Just(0.0), 3 => 0.0..1.0, 1 => Just(1.0)];
    let shares = (0.0..0.3, 0.0..1.0, 0.0..1.0);
    let cells = prop_oneof![
        triple(0.1..1.0),
        (0.1..1.0).prop_map(|size| [size, size, 0.0])
    ];
    let checker = prop::option::weighted(0.3, (triple(0.0..1.0), cells));
    (triple(0.0..1.0), shares, shininess, mirror, checker).prop_map(
        |(color, (ambient, diffuse, specular), shininess, mirror, checker)| Surface {
            color,
            ambient,
            diffuse,
            specular,
            shininess,
            mirror,
            checker,
        },
    )
}

fn eye() -> impl Strategy<Value = Eye> {
    let any = || triple(-1.0..1.0);
    prop_oneof![
        3 => (any(), 30.0..120.0).prop_map(|(at, fov)| Eye::Within(at, fov)),
        1 => (0..16_usize, 30.0..120.0).prop_map(|(at, fov)| Eye::InSphere(at, fov)),
        4 => (any(), 2.0..5.0, 30.0..70.0).prop_map(|(to, far, fov)| Eye::Away(to, far, fov)),
        1 => (any(), 15.0..100.0, 1.0..8.0).prop_map(|(to, far, fov)| Eye::Away(to, far, fov)),
    ]
}

fn recipe() -> impl Strategy<Value = Recipe> {
    let any = || triple(-1.0..1.0);
    let spheres = prop::collection::vec((any(), 0.02..0.4, 0..4_usize), 1..16);
    let planes = prop::collection::vec((triple(-2.0..2.0), any(), 0..4_usize), 0..4);
    let sizes = (0.02..0.3, 0.05..2.0);
    let cylinders = prop::collection::vec((any(), any(), sizes, 0..4_usize), 0..6);
    let discs = prop::collection::vec((any(), any(), 0.05..0.6, 0..4_usize), 0..4);
    // Near lights and far lights.
    let away = prop_oneof![4 => 0.5..3.0, 1 => 10.0..1000.0, 1 => Just(5e3)];
    let lights = prop::collection::vec((any(), away, triple(0.0..1.0)), 1..4);
    // 10^-3 to 10^5
    let scale = prop_oneof![1 => Just(1.0), 3 => (-3.0..5.0).prop_map(|it: f64| 10f64.powf(it))];
    let offset = prop_oneof![2 => Just([0.0; 3]), 1 => triple(-100.0..100.0)];
    let shading = prop::sample::select(vec![
        reference::Shading::BlinnPhong,
        reference::Shading::Phong,
        reference::Shading::Normals,
    ]);
    let things = (spheres, planes, cylinders, discs, lights);
    let surfaces = prop::collection::vec(surface(), 4);
    let view = (eye(), triple(-0.3..0.3), any());
    let color = || triple(0.0..1.0);
    let sky = (triple(-1.0..1.0), color(), color());
    let background = (color(), prop::option::weighted(0.3, sky));
    let place = (scale, offset, background, 0..9_u8, shading);
    (surfaces, things, view, place).prop_map(
        |(materials, (spheres, planes, cylinders, discs, lights), (eye, target, up), place)| {
            Recipe {
                materials,
                spheres,
                planes,
                cylinders,
                discs,
                lights,
                fades: false,
                eye,
                target,
                up,
                scale: place.0,
                offset: place.1,
                background: place.2.0,
                sky: place.2.1,
                reflections: place.3,
                shading: place.4,
            }
        },
    )
}

impl Recipe {
    /// Converts a point of the cube to a point of the scene.
    fn placed(&self, at: Triple) -> Triple {
        ((Vector(at) + Vector(self.offset)) * self.scale).0
    }

    fn scene(&self) -> Result<Scenery, Error> {
        let mut scene = Scenery::new();
        let made = self.materials.iter().map(|it| {
            let highlight = (it.specular, it.shininess);
            let made =
                Material::from_numbers(it.color, it.ambient, it.diffuse, highlight, it.mirror);
            match it.checker {
                Some((color, size)) => {
                    let size = size.map(|it| it * self.scale);
                    made.unwrap().with_checker(color, size).unwrap()
                }
                None => made.unwrap(),
            }
        });
        let ids = made.map(|it| scene.add_material(it));
        let ids: Vec<MaterialId> = ids.collect::<Result<_, _>>()?;
        for &(center, radius, id) in &self.spheres {
            scene.add_sphere(self.placed(center), radius * self.scale, ids[id])?;
        }
        for &(point, normal, id) in &self.planes {
            scene.add_plane(self.placed(point), normal, ids[id])?;
        }
        for &(center, axis, (radius, height), id) in &self.cylinders {
            let (radius, height) = (radius * self.scale, height * self.scale);
            scene.add_cylinder(self.placed(center), axis, radius, height, ids[id])?;
        }
        for &(center, normal, radius, id) in &self.discs {
            scene.add_disc(self.placed(center), normal, radius * self.scale, ids[id])?;
        }
        for &(towards, away, color) in &self.lights {
            let position = self.placed(towards.map(|it| it * away));
            match self.fades {
                true => {
                    let range = away * self.scale * (0.02 + 3.0 * color[0] * color[0]);
                    scene.add_light_with_range(position, color, range)?
                }
                false => scene.add_light(position, color)?,
            };
        }
        match self.sky {
            Some((up, below, above)) => scene.set_sky(up, [below, self.background, above])?,
            None => scene.set_background(self.background)?,
        }
        scene.set_epsilon(1e-4 * self.scale)?;
        Ok(scene)
    }

    /// Returns the scene with its own camera. While proptest shrinks a failure, the recipe may
    /// become invalid; then the case is rejected.
    fn seen(&self) -> Result<(Scenery, Camera), TestCaseError> {
        let (scene, camera) = (self.scene(), self.camera());
        let mut scene = scene.map_err(|error| TestCaseError::reject(error.to_string()))?;
        let camera = camera.map_err(|error| TestCaseError::reject(error.to_string()))?;
        scene.set_camera(camera);
        Ok((scene, camera))
    }

    fn camera(&self) -> Result<Camera, Error> {
        let (position, fov) = match self.eye {
            Eye::Within(at, fov) => (at, fov),
            Eye::InSphere(index, fov) if !self.spheres.is_empty() => {
                let (center, radius, _) = self.spheres[index % self.spheres.len()];
                (center.map(|it| it + 0.3 * radius), fov)
            }
            Eye::InSphere(_, fov) => ([0.5; 3], fov),
            Eye::Away(towards, far, fov) => {
                let length = Vector(towards).length();
                (towards.map(|it| it / length * far), fov)
            }
        };
        let (position, target) = (self.placed(position), self.placed(self.target));
        Camera::new(position, target, self.up, fov)
    }
}

/// Returns a test runner that tries the same cases every time.
fn runner(cases: u32) -> TestRunner {
    let mut config = Config::with_cases(cases);
    config.failure_persistence = None;
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

#[test]
fn any_valid_scene_is_painted_as_double_precision_paints_it() {
    are_painted_as_double_precision_paints_them(2000, false);
}

#[test]
fn lights_that_fall_off_are_painted_as_double_precision_paints_them() {
    are_painted_as_double_precision_paints_them(600, true);
}

fn are_painted_as_double_precision_paints_them(cases: u32, fades: bool) {
    let results = RefCell::new(Vec::new());
    let outcome = runner(cases).run(&recipe(), |recipe| {
        let recipe = Recipe { fades, ..recipe };
        let (scene, camera) = recipe.seen()?;
        let built = scene.build();
        let built = built.map_err(|error| TestCaseError::reject(error.to_string()))?;
        let frame = built.frame(&camera).reflections(recipe.reflections);
        let (frame, size) = (frame.quality::<Exact>(), Size::new(SIDE, SIDE));
        let picture = match recipe.shading {
            reference::Shading::BlinnPhong => painted(&frame.prepare(size).on(&built).unwrap()),
            reference::Shading::Phong => {
                painted(&frame.shading::<Phong>().prepare(size).on(&built).unwrap())
            }
            reference::Shading::Normals => {
                painted(&frame.shading::<Normals>().prepare(size).on(&built).unwrap())
            }
        };
        let (truth, camera) = ((&scene.description()).into(), (&camera).into());
        let n = u32::from(recipe.reflections);
        let truth = render(&truth, &camera, SIDE, SIDE, n, recipe.shading);
        let found = compare(&picture, &truth).unwrap();
        let mut colors = picture.pixels;
        colors.sort_unstable();
        colors.dedup();
        results.borrow_mut().push((found, colors.len()));
        let is_near = found.within8 >= WITHIN_8 && found.within1 >= WITHIN_1;
        prop_assert!(is_near, "{found:?}");
        Ok(())
    });
    let (differences, colors): (Vec<_>, Vec<_>) = results.into_inner().into_iter().unzip();
    let worst = |share: fn(&Difference) -> f64| differences.iter().map(share).fold(1.0, f64::min);
    let (within8, within1) = (worst(|found| found.within8), worst(|found| found.within1));
    let close = differences.iter().filter(|found| found.max <= 1).count();
    let seen = differences.len();
    println!("{close} of {seen} pictures are within 1 everywhere");
    println!("the worst is within 8 on {within8:.4}, within 1 on {within1:.4} of its pixels");
    outcome.unwrap_or_else(|error| panic!("{error}"));
    // The pictures must show enough for the comparison to be useful.
    let colorful = colors.iter().filter(|count| **count > 50).count();
    assert!(
        2 * colorful > seen,
        "only {colorful} of {seen} pictures show much"
    );
}

#[test]
fn no_pixel_of_any_scene_is_further_off_than_its_bound() {
    no_pixel_is_further_off_than_its_bound(400, false);
}

#[test]
fn no_pixel_under_lights_that_fall_off_is_further_off_than_its_bound() {
    no_pixel_is_further_off_than_its_bound(200, true);
}

fn no_pixel_is_further_off_than_its_bound(cases: u32, fades: bool) {
    /// Width and height of a picture in pixels.
    const SIDE: u32 = 32;
    /// Number of reflections after which nothing is left of a path, unless its mirrors reflect all
    /// light.
    const ALL: usize = 200;
    // For each quality: the number of pixels, of sure pixels, and of pixels that exceed their bound.
    let counts = Cell::new([[0_usize; 3]; 2]);
    let outcome = runner(cases).run(&recipe(), |recipe| {
        let recipe = Recipe { fades, ..recipe };
        let (scene, camera) = recipe.seen()?;
        let built = scene.build();
        let built = built.map_err(|error| TestCaseError::reject(error.to_string()))?;
        // Normals are not light, so they have no bound.
        let shading = match recipe.shading {
            reference::Shading::Phong => reference::Shading::Phong,
            _ => reference::Shading::BlinnPhong,
        };
        let frame = || built.frame(&camera).reflections(recipe.reflections);
        let reflections = recipe.reflections;
        let pictures = [
            lit(&built, frame().quality::<Fast>(), SIDE, shading),
            lit(&built, frame().quality::<Exact>(), SIDE, shading),
        ];
        let endings = [
            ending::<Fast>(reflections, SIDE),
            ending::<Exact>(reflections, SIDE),
        ];
        let (exact, camera) = ((&scene.description()).into(), (&camera).into());
        let precision = precision(&built);
        let paths = Paths::follow(&exact, &camera, (SIDE, SIDE), ALL, shading, &precision);
        let mut sums = counts.get();
        for (sums, (picture, ending)) in sums.iter_mut().zip(pictures.iter().zip(endings)) {
            let held = held(&paths, &ending, picture, ALL);
            prop_assert!(held.broken == 0, "{held:?}");
            sums[0] += held.pixels;
            sums[1] += held.sure;
            sums[2] += held.decided;
        }
        counts.set(sums);
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
    for [all, sure, decided] in counts.get() {
        let words = format!("of {all} pixels {sure} are sure, {decided} were decided otherwise");
        println!("{words}");
        assert!(2 * sure > all && MOST_DECIDED * decided < all, "{words}");
    }
}

/// Only one in this many pixels may exceed its bound, because rounding changed what its path hits.
const MOST_DECIDED: usize = 10_000;

/// Draws a lit picture with the highlights of one shading.
fn lit<S: Drawable, Q: Quality>(
    scene: &S,
    frame: FrameBuilder<'_, S, Q>,
    side: u32,
    shading: reference::Shading,
) -> reference::Picture {
    let size = Size::new(side, side);
    match shading {
        reference::Shading::Phong => {
            painted(&frame.shading::<Phong>().prepare(size).on(scene).unwrap())
        }
        _ => painted(&frame.prepare(size).on(scene).unwrap()),
    }
}
