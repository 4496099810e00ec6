//! Scenes filled and cameras made while the program runs.

use reflet::{
    Camera, Error, ErrorKind, Material, MaterialId, Number, Position, RuntimeScene, room,
};

type Scenery = RuntimeScene<
    room!(spheres: 2, planes: 2, cylinders: 2, discs: 2, triangles: 2, lights: 2, materials: 2),
>;
type Triple = [f64; 3];

const NAN: f64 = f64::NAN;
const INFINITE: f64 = f64::INFINITY;
/// The largest coordinate, 2³⁰, and what is just beyond it.
const LIMIT: f64 = 1_073_741_824.0;
const BEYOND: f64 = LIMIT + 0.001;
/// Values that no number in a scene may have.
const UNHEARD_OF: [f64; 4] = [NAN, INFINITE, -INFINITE, 1e300];
const ORIGIN: Triple = [0.0; 3];
const UP: Triple = [0.0, 0.0, 1.0];

/// Part, index and kind of an error.
type Expected = (&'static str, Option<usize>, ErrorKind);

/// Fails unless this is the error, and says its part and what is wrong with it.
#[track_caller]
fn assert_error(found: Option<Error>, expected: Expected) {
    let found = found.unwrap_or_else(|| panic!("it is accepted: {expected:?}"));
    assert_eq!((found.part(), found.index(), found.kind()), expected);
    let part = match expected {
        (part, Some(index), _) => format!("{part} {index}"),
        (part, None, _) => part.to_owned(),
    };
    let message = expected.2.message();
    assert_eq!(found.to_string(), format!("{part}: {message}"));
}

/// Adds something to a scene, of this material.
type Add = Box<dyn Fn(&mut Scenery, MaterialId) -> Result<(), Error>>;

/// Something to be added to a scene, and how errors name it there.
struct Addition {
    part: &'static str,
    index: Option<usize>,
    add: Add,
}

/// Returns an addition to a scene that has one part of each kind: an error names number 1, or none for scene and sky.
fn addition<T, A>(part: &'static str, add: A) -> Addition
where
    A: Fn(&mut Scenery, MaterialId) -> Result<T, Error> + 'static,
{
    Addition {
        part,
        index: (part != "scene" && part != "sky").then_some(1),
        add: Box::new(move |scene, id| add(scene, id).map(drop)),
    }
}

fn sphere(center: Triple, radius: f64) -> Addition {
    addition("sphere", move |it, id| it.add_sphere(center, radius, id))
}

fn plane(point: Triple, normal: Triple) -> Addition {
    addition("plane", move |it, id| it.add_plane(point, normal, id))
}

fn cylinder(center: Triple, axis: Triple, radius: f64, height: f64) -> Addition {
    let add = move |it: &mut Scenery, id| it.add_cylinder(center, axis, radius, height, id);
    addition("cylinder", add)
}

fn disc(center: Triple, normal: Triple, radius: f64) -> Addition {
    addition("disc", move |it, id| {
        it.add_disc(center, normal, radius, id)
    })
}

fn triangle(corners: [Triple; 3], normals: Option<[Triple; 3]>) -> Addition {
    addition("triangle", move |it, id| {
        it.add_triangle(corners, normals, id)
    })
}

/// Corners of a triangle.
const CORNERS: [Triple; 3] = [ORIGIN, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn light(position: Triple, color: Triple) -> Addition {
    addition("light", move |it, _| it.add_light(position, color))
}

fn light_with_range(range: f64) -> Addition {
    addition("light", move |it, _| {
        it.add_light_with_range(ORIGIN, [1.0; 3], range)
    })
}

fn sun(direction: Triple, degrees: f64) -> Addition {
    addition("sun", move |it, _| it.add_sun(direction, [1.0; 3], degrees))
}

fn material(material: Material) -> Addition {
    addition("material", move |it, _| it.add_material(material))
}

fn background(color: Triple) -> Addition {
    addition("scene", move |it, _| it.set_background(color))
}

fn sky(up: Triple, colors: [Triple; 3]) -> Addition {
    addition("sky", move |it, _| it.set_sky(up, colors))
}

fn epsilon(epsilon: f64) -> Addition {
    addition("scene", move |it, _| it.set_epsilon(epsilon))
}

/// One thing of every kind, and the material they are made of.
fn furnished() -> (Scenery, MaterialId) {
    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    for part in [
        sphere(ORIGIN, 1.0),
        plane([0.0, 0.0, -1.0], UP),
        cylinder([3.0, 0.0, 0.0], UP, 1.0, 2.0),
        disc([3.0, 0.0, 1.0], UP, 1.0),
        triangle(CORNERS, None),
        light([0.0, -9.0, 9.0], [1.0; 3]),
    ] {
        (part.add)(&mut scene, white).unwrap();
    }
    (scene, white)
}

/// Fails unless each of some things is refused with an error of this kind, and the scene is as it was.
#[track_caller]
fn assert_refused(kind: ErrorKind, additions: impl IntoIterator<Item = Addition>) {
    assert_refused_with(furnished().1, kind, additions);
}

#[track_caller]
fn assert_refused_with(
    material: MaterialId,
    kind: ErrorKind,
    additions: impl IntoIterator<Item = Addition>,
) {
    for Addition { part, index, add } in additions {
        let (mut scene, _) = furnished();
        let before = format!("{:?}", scene.description());
        assert_error(add(&mut scene, material).err(), (part, index, kind));
        assert_eq!(format!("{:?}", scene.description()), before, "{part}");
        assert!(scene.build().is_ok(), "{part}");
    }
}

#[track_caller]
fn assert_accepted(additions: impl IntoIterator<Item = Addition>) {
    for Addition { part, add, .. } in additions {
        let (mut scene, white) = furnished();
        let before = format!("{:?}", scene.description());
        add(&mut scene, white).unwrap();
        assert_ne!(format!("{:?}", scene.description()), before, "{part}");
    }
}

/// Every value of a coordinate that is refused, put on each of the three axes.
fn bad_triples() -> impl Iterator<Item = Triple> {
    let bad = UNHEARD_OF.into_iter().chain([BEYOND, -BEYOND, 1e30]);
    bad.flat_map(|value| [[value, 0.0, 1.0], [0.0, value, 1.0], [0.0, 1.0, value]])
}

/// The edges of what is accepted.
const GOOD_TRIPLES: [Triple; 3] = [
    [LIMIT, -LIMIT, 1.0],
    [1.0, LIMIT, LIMIT],
    [0.0, 0.0, -LIMIT],
];

#[test]
fn coordinates_beyond_the_format_are_refused() {
    let kind = ErrorKind::Coordinate;
    for at in bad_triples() {
        assert_refused(kind, placed(at));
        assert_refused(kind, [triangle([at, CORNERS[1], CORNERS[2]], None)]);
        assert_refused(kind, directed(at));
        assert_refused(kind, [triangle(CORNERS, Some([UP, at, UP]))]);
    }
    for at in GOOD_TRIPLES {
        assert_accepted(placed(at));
        assert_accepted([cylinder(at, at, 1.0, 1.0), disc(at, at, 1.0)]);
        assert_accepted([plane(ORIGIN, at)]);
    }
}

/// Returns parts at this place.
fn placed(at: Triple) -> [Addition; 5] {
    [
        sphere(at, 1.0),
        plane(at, UP),
        cylinder(at, UP, 1.0, 1.0),
        disc(at, UP, 1.0),
        light(at, [1.0; 3]),
    ]
}

/// Returns shapes with this normal or axis.
fn directed(direction: Triple) -> [Addition; 3] {
    [
        plane(ORIGIN, direction),
        cylinder(ORIGIN, direction, 1.0, 1.0),
        disc(ORIGIN, direction, 1.0),
    ]
}

#[test]
fn sizes_must_be_greater_than_zero_and_fit_the_format() {
    let wide = |radius| {
        [
            sphere(ORIGIN, radius),
            cylinder(ORIGIN, UP, radius, 1.0),
            disc(ORIGIN, UP, radius),
        ]
    };
    let high = |height| [cylinder(ORIGIN, UP, 1.0, height)];
    for size in [0.0, -0.0, -1e-9, -1.0, -1e9] {
        assert_refused(ErrorKind::Radius, wide(size));
        assert_refused(ErrorKind::Height, high(size));
    }
    for size in UNHEARD_OF.into_iter().chain([BEYOND, 1e30]) {
        assert_refused(ErrorKind::Coordinate, wide(size));
        assert_refused(ErrorKind::Coordinate, high(size));
    }
    for size in [1e-12, 1.0, LIMIT] {
        assert_accepted(wide(size));
        assert_accepted(high(size));
    }
}

#[test]
fn normals_and_axes_must_point_somewhere() {
    // What is below half of 2^-64 is zero in the format.
    for zero in [[0.0; 3], [-0.0; 3], [1e-30, -1e-30, 0.0]] {
        let [plane, cylinder, disc] = directed(zero);
        let triangle = triangle(CORNERS, Some([UP, UP, zero]));
        assert_refused(ErrorKind::Normal, [plane, disc, triangle]);
        assert_refused(ErrorKind::Axis, [cylinder]);
    }
    for short in [[1e-15, 0.0, 0.0], [0.0, -1e-19, 0.0]] {
        assert_accepted(directed(short));
    }
}

#[test]
fn corners_must_not_lie_on_one_line() {
    let [one, other, _] = CORNERS;
    let with = |third| triangle([one, other, third], None);
    let between = [0.5, 0.0, 0.0];
    let line = [one, other, between, [-3.0, 0.0, 0.0], [0.5, 1e-7, 0.0]];
    assert_refused(ErrorKind::Corners, line.map(with));
    assert_accepted([[0.5, 1e-4, 0.0], [-90.0, 1.0, 0.0], UP].map(with));
    let normals = [UP, [1e-15, 0.0, 0.0], [0.0, -9.0, 0.0]];
    assert_accepted([triangle(CORNERS, Some(normals))]);
}

#[test]
fn colours_must_be_within_zero_to_sixteen() {
    for value in UNHEARD_OF.into_iter().chain([-1e-9, 16.000_001, 1e9]) {
        for channel in 0..3 {
            let mut color = [0.5; 3];
            color[channel] = value;
            assert_refused(ErrorKind::Color, [light(ORIGIN, color)]);
            assert_refused(ErrorKind::Background, [background(color)]);
            for place in 0..3 {
                let mut colors = [[0.5; 3]; 3];
                colors[place] = color;
                assert_refused(ErrorKind::Color, [sky(UP, colors)]);
            }
        }
    }
    let color = [0.0, 0.5, 16.0];
    assert_accepted([light(ORIGIN, color), background(color), sky(UP, [color; 3])]);
}

#[test]
fn cells_of_a_checker_must_have_a_size() {
    let fault = |color: Triple, size: Triple| {
        let made = Material::new([0.5; 3]).with_checker(color, size);
        made.err().map(|error| (error.part(), error.kind()))
    };
    let grey = [0.5; 3];
    for size in [[0.0; 3], [1.0, -1e-9, 0.0], [0.0, BEYOND, 0.0]] {
        assert_eq!(fault(grey, size), Some(("material", ErrorKind::Checker)));
    }
    let bright = fault([0.0, 0.0, 17.0], grey);
    assert_eq!(bright, Some(("material", ErrorKind::Color)));
    assert_eq!(fault(grey, [0.0, 1e-9, 0.0]), None);
}

#[test]
fn up_of_a_sky_must_have_a_length() {
    let of = |up| sky(up, [[0.5; 3]; 3]);
    assert_refused(ErrorKind::Sky, [of([0.0, -0.0, 0.0])]);
    assert_refused(ErrorKind::Coordinate, [of([0.0, BEYOND, 1.0])]);
    assert_accepted([of([0.0, 1e-9, 0.0])]);
}

#[test]
fn epsilon_must_be_greater_than_zero_and_smaller_than_the_scene() {
    let values = UNHEARD_OF.into_iter().chain([0.0, -1e-9, BEYOND]);
    assert_refused(ErrorKind::Epsilon, values.map(epsilon));
    assert_accepted([epsilon(1e-9)]);
    // How large the scene is shows when it is built.
    let (mut scene, _) = furnished();
    scene.set_epsilon(1000).unwrap();
    assert_error(scene.build().err(), ("scene", None, ErrorKind::Epsilon));
}

/// Fails unless a scene of one sphere, and of what else is added, is built with the first number and
/// refused with the second.
#[track_caller]
fn assert_limit(
    [taken, refused]: [f64; 2],
    error: Expected,
    add: impl Fn(&mut Scenery, MaterialId, f64) -> Result<(), Error>,
) {
    let built = |number| {
        let mut scene = Scenery::new();
        let made = Material::from_numbers([1.0; 3], 16.0, 0.5, (0.0, 1.0), 0.0)?;
        let id = scene.add_material(made)?;
        add(&mut scene, id, number)?;
        scene.build().map(drop)
    };
    assert_eq!(built(taken).err(), None, "{taken}");
    assert_error(built(refused).err(), error);
}

#[test]
fn limits_of_a_whole_scene_are_sharp() {
    // The planet of radius 2^20 fills the ball of 2^28 steps, so the smallest radius, 64 steps, is a
    // quarter.
    let (planet, beside) = (f64::from(1 << 20), [1.0, 2.0, 3.0]);
    let tiny = |part, index| (part, Some(index), ErrorKind::Tiny);
    assert_limit([0.25, 0.248], tiny("sphere", 1), |scene, id, radius| {
        scene.add_sphere(ORIGIN, planet, id)?;
        scene.add_sphere(beside, radius, id).map(drop)
    });
    assert_limit([0.5, 0.496], tiny("cylinder", 0), |scene, id, height| {
        scene.add_sphere(ORIGIN, planet, id)?;
        scene.add_cylinder(beside, UP, 1.0, height, id).map(drop)
    });
    let least = 2f64.powi(-30);
    let of_scene = |kind| ("scene", None, kind);
    let lonely = |scene: &mut Scenery, id, radius| {
        scene.add_sphere(ORIGIN, radius, id)?;
        scene.set_epsilon(radius * 1e-3)
    };
    for taken in [least, LIMIT] {
        assert_limit([taken, 0.99 * least], of_scene(ErrorKind::Extent), lonely);
    }
    for limits in [[0.999, 1.0], [1e-19, 1e12]] {
        let error = of_scene(ErrorKind::Epsilon);
        assert_limit(limits, error, |scene, id, epsilon| {
            scene.add_sphere(ORIGIN, 1.0, id)?;
            scene.set_epsilon(epsilon)
        });
    }
    // Ambient 16, and 28 times half of it by the light.
    let bright = ("material", Some(0), ErrorKind::Brightness);
    let share = |light: f64| [light / 2.0; 3];
    assert_limit([13.9 * 2.0, 14.1 * 2.0], bright, |scene, id, light| {
        scene.add_sphere(ORIGIN, 1.0, id)?;
        scene.add_light([3.0; 3], share(light))?;
        scene.add_light([-3.0; 3], share(light)).map(drop)
    });
}

#[test]
fn more_than_the_room_is_refused() {
    let (mut scene, id) = furnished();
    let additions = |at: f64| {
        let (up, grey) = ([0.0, 1.0, 0.0], Material::new([0.1 * at; 3]));
        [
            (sphere([at; 3], 1.0), ErrorKind::TooManySpheres),
            (plane([at; 3], up), ErrorKind::TooManyPlanes),
            (cylinder([at; 3], up, 1.0, 1.0), ErrorKind::TooManyCylinders),
            (disc([at; 3], up, 1.0), ErrorKind::TooManyDiscs),
            (
                triangle([[at; 3], UP, ORIGIN], None),
                ErrorKind::TooManyTriangles,
            ),
            (light([at; 3], [1.0; 3]), ErrorKind::TooManyLights),
            (material(grey), ErrorKind::TooManyMaterials),
        ]
    };
    for (addition, _) in additions(1.0) {
        (addition.add)(&mut scene, id).unwrap();
    }
    let before = format!("{:?}", scene.description());
    for (Addition { part, add, .. }, kind) in additions(2.0) {
        assert_error(add(&mut scene, id).err(), (part, Some(2), kind));
    }
    assert_eq!(format!("{:?}", scene.description()), before);
    assert!(scene.build().is_ok());
}

#[test]
fn material_of_another_scene_is_refused() {
    let foreign = furnished().0.add_material(Material::new([0.5; 3])).unwrap();
    let kind = ErrorKind::UnknownMaterial;
    assert_refused_with(foreign, kind, [sphere(ORIGIN, 1.0)]);
    assert_refused_with(foreign, kind, directed(UP));
}

#[test]
fn what_shows_in_the_whole_scene_is_refused_when_it_is_built() {
    let small = CORNERS.map(|corner| corner.map(|it| 1e-9 * it));
    let bright = Material::from_numbers([16, 0, 0], 1, 1, (0, 1), 0).unwrap();
    for (Addition { part, index, add }, kind) in [
        (sphere(ORIGIN, 1e-9), ErrorKind::Tiny),
        (disc(ORIGIN, UP, 1e-9), ErrorKind::Tiny),
        (triangle(small, None), ErrorKind::Tiny),
        (material(bright), ErrorKind::Brightness),
    ] {
        let (mut scene, white) = furnished();
        add(&mut scene, white).unwrap();
        assert_error(scene.build().err(), (part, index, kind));
    }

    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0; 3], 1e-10, white).unwrap();
    assert_error(scene.build().err(), ("scene", None, ErrorKind::Extent));
}

#[test]
fn fields_of_a_material_are_named() {
    let fields = [
        (ErrorKind::Color, 16.0),
        (ErrorKind::Color, 16.0),
        (ErrorKind::Color, 16.0),
        (ErrorKind::Ambient, 16.0),
        (ErrorKind::Diffuse, 16.0),
        (ErrorKind::Specular, 16.0),
        (ErrorKind::Shininess, 1_048_576.0),
        (ErrorKind::Mirror, 1.0),
    ];
    let made = |field: usize, value: f64| {
        let mut values = [0.5; 8];
        values[field] = value;
        let [r, g, b, ambient, diffuse, specular, shininess, mirror] = values;
        Material::from_numbers([r, g, b], ambient, diffuse, (specular, shininess), mirror)
    };
    for (field, (kind, most)) in fields.into_iter().enumerate() {
        for value in UNHEARD_OF.into_iter().chain([-1e-9, most + 1e-9]) {
            let error = made(field, value).unwrap_err();
            assert_eq!((error.part(), error.index()), ("material", None));
            assert_eq!(error.kind(), kind, "{value}");
        }
        assert_eq!(kind.to_string(), kind.message());
        for value in [0.0, -0.0, most] {
            assert!(made(field, value).is_ok(), "{kind:?} {value}");
        }
    }
}

#[track_caller]
fn assert_no_camera(made: Result<Camera, Error>, kind: ErrorKind) {
    assert_error(made.err(), ("camera", None, kind));
}

#[test]
fn camera_coordinates_must_fit_the_format() {
    let error = ErrorKind::Coordinate;
    let (position, target) = ([0.0, -5.0, 0.0], [0.0; 3]);
    for bad in bad_triples() {
        assert_no_camera(Camera::new(bad, target, UP, 50), error);
        assert_no_camera(Camera::new(position, bad, UP, 50), error);
        assert_no_camera(Camera::new(position, target, bad, 50), error);
    }
    for good in GOOD_TRIPLES {
        assert!(Camera::new(good, target, [0.1, 0.2, 0.3], 50).is_ok());
        assert!(Camera::new(position, good, [0.1, 0.2, 0.3], 50).is_ok());
    }
}

#[test]
fn camera_must_look_somewhere() {
    for at in [[0.0; 3], [1.5, -2.5, 1e9]] {
        assert_no_camera(Camera::new(at, at, UP, 50), ErrorKind::View);
    }
    assert!(Camera::new(ORIGIN, [0.0, 1e-15, 0.0], UP, 50).is_ok());
}

#[test]
fn camera_up_must_not_be_zero_or_parallel_to_the_view() {
    let target = [0.0, -5.0, 2.0];
    for up in [
        [0.0; 3],
        target,
        [0.0, 5.0, -2.0],
        [0.0, -1.25, 0.5],
        [0.0, -5e-9, 2e-9],
        [0.0, 5e6, -2e6],
        [1e-8, -5.0, 2.0],
    ] {
        assert_no_camera(Camera::new(ORIGIN, target, up, 50), ErrorKind::Up);
    }
    for up in [[0.0, 0.0, 1e-9], [1e-3, -5.0, 2.0], [1e-5, -5.0, 2.0]] {
        assert!(Camera::new(ORIGIN, target, up, 50).is_ok(), "{up:?}");
    }
}

#[test]
fn camera_fov_must_be_between_its_limits() {
    let made = |fov: f64| Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], fov);
    let narrow = [0.0, -0.0, 0.000_999_9, -50.0];
    let wide = [179.999_01, 180.0, 180.001, 360.0];
    for fov in UNHEARD_OF.into_iter().chain(narrow).chain(wide) {
        assert_no_camera(made(fov), ErrorKind::FieldOfView);
    }
    for fov in [0.001, 50.0, 179.999] {
        assert!(made(fov).is_ok(), "{fov}");
    }
}

#[test]
fn errors_are_errors_as_the_language_knows_them() {
    let (mut scene, white) = furnished();
    let mut fill = || -> Result<(), Box<dyn std::error::Error>> {
        Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], 50)?;
        Material::from_numbers([1, 1, 1], 1, 1, (0, 1), 0)?;
        scene.add_sphere([0; 3], -1, white)?;
        Ok(())
    };
    let said = fill().unwrap_err().to_string();
    assert_eq!(said, "sphere 1: radius must be greater than 0");
    assert_eq!(Number::new(NAN), Number::OUT_OF_RANGE);
    assert!(!Position::new([0.0, INFINITE, 0.0]).is_in_range());
}

#[test]
fn suns_have_a_direction_and_a_disc_of_at_most_ninety_degrees() {
    let suns = [(ORIGIN, 0.0), (UP, -0.1), (UP, 90.1), (UP, INFINITE)];
    assert_refused(ErrorKind::Sun, suns.map(|(up, degrees)| sun(up, degrees)));
    assert_refused(ErrorKind::Coordinate, [sun([0.0, NAN, 1.0], 1.0)]);
    assert_accepted([sun([1e-9, 0.0, 0.0], 0.0), sun(UP, 90.0)]);
}

#[test]
fn range_of_a_light_must_be_above_zero() {
    let low = [0.0, -0.0, -1.0, 1e-30];
    let ranges = UNHEARD_OF.into_iter().chain(low).chain([LIMIT + 0.5]);
    assert_refused(ErrorKind::Range, ranges.map(light_with_range));
    assert_accepted([1e-19, 0.5, LIMIT].map(light_with_range));
}
