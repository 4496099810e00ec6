//! Scenes filled and cameras made while the program runs.

use std::error::Error;

use reflet::{
    Camera, CameraError, Fault, Material, MaterialId, Number, Position, RuntimeScene, SceneError,
};

type Scenery = RuntimeScene<2, 2, 2, 2, 2>;
type Triple = [f64; 3];

const NAN: f64 = f64::NAN;
const INFINITE: f64 = f64::INFINITY;
/// The largest coordinate, 2³⁰, and what is just beyond it.
const LIMIT: f64 = 1_073_741_824.0;
const BEYOND: f64 = LIMIT + 0.001;
/// What no number in a scene may be.
const UNHEARD_OF: [f64; 4] = [NAN, INFINITE, -INFINITE, 1e300];

const COORDINATE: &str =
    "coordinates and sizes must be finite and within -2^30 to 2^30 scene units";

/// One thing of every kind, and the material they are made of.
fn furnished() -> (Scenery, MaterialId) {
    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0, 0, 0], 1, white).unwrap();
    scene.add_plane([0, 0, -1], [0, 0, 1], white).unwrap();
    scene
        .add_cylinder([3, 0, 0], [0, 0, 1], 1, 2, white)
        .unwrap();
    scene.add_light([0, -9, 9], [1, 1, 1]).unwrap();
    (scene, white)
}

/// Fails unless something is refused with this error and these words, and the scene is as it was.
#[track_caller]
fn assert_refused<T: std::fmt::Debug>(
    refuse: impl Fn(&mut Scenery, MaterialId) -> Result<T, SceneError>,
    error: SceneError,
    words: &str,
) {
    let (mut scene, white) = furnished();
    let before = format!("{:?}", scene.description());
    let refused = refuse(&mut scene, white).unwrap_err();
    assert_eq!((refused, refused.fault()), (error, error.fault()));
    assert_eq!(refused.to_string(), words);
    assert_eq!(format!("{:?}", scene.description()), before);
    assert!(scene.build().is_ok());
}

#[track_caller]
fn assert_accepted<T: std::fmt::Debug>(
    accept: impl Fn(&mut Scenery, MaterialId) -> Result<T, SceneError>,
) {
    let (mut scene, white) = furnished();
    let before = format!("{:?}", scene.description());
    accept(&mut scene, white).unwrap();
    assert_ne!(format!("{:?}", scene.description()), before);
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
    for at in bad_triples() {
        let sphere = |scene: &mut Scenery, id| scene.add_sphere(at, 1, id);
        let words = format!("sphere 1: {COORDINATE}");
        assert_refused(sphere, SceneError::Sphere(1, Fault::Coordinate), &words);

        let words = format!("plane 1: {COORDINATE}");
        let plane = |scene: &mut Scenery, id| scene.add_plane(at, [0, 0, 1], id);
        assert_refused(plane, SceneError::Plane(1, Fault::Coordinate), &words);
        let plane = |scene: &mut Scenery, id| scene.add_plane([0, 0, 0], at, id);
        assert_refused(plane, SceneError::Plane(1, Fault::Coordinate), &words);

        let words = format!("cylinder 1: {COORDINATE}");
        let tube = |scene: &mut Scenery, id| scene.add_cylinder(at, [0, 0, 1], 1, 1, id);
        assert_refused(tube, SceneError::Cylinder(1, Fault::Coordinate), &words);
        let tube = |scene: &mut Scenery, id| scene.add_cylinder([0, 0, 0], at, 1, 1, id);
        assert_refused(tube, SceneError::Cylinder(1, Fault::Coordinate), &words);

        let words = format!("light 1: {COORDINATE}");
        let light = |scene: &mut Scenery, _| scene.add_light(at, [1, 1, 1]);
        assert_refused(light, SceneError::Light(1, Fault::Coordinate), &words);
    }
    for at in GOOD_TRIPLES {
        assert_accepted(|scene, id| scene.add_sphere(at, 1, id));
        assert_accepted(|scene, id| scene.add_plane(at, [0, 0, 1], id));
        assert_accepted(|scene, id| scene.add_plane([0, 0, 0], at, id));
        assert_accepted(|scene, id| scene.add_cylinder(at, at, 1, 1, id));
        assert_accepted(|scene, _| scene.add_light(at, [1, 1, 1]));
    }
}

#[test]
fn sizes_must_be_greater_than_zero_and_fit_the_format() {
    let sphere = |radius: f64| move |scene: &mut Scenery, id| scene.add_sphere([0; 3], radius, id);
    let wide = |radius: f64| {
        move |scene: &mut Scenery, id| scene.add_cylinder([0; 3], [0, 0, 1], radius, 1, id)
    };
    let high = |height: f64| {
        move |scene: &mut Scenery, id| scene.add_cylinder([0; 3], [0, 0, 1], 1, height, id)
    };
    for size in [0.0, -0.0, -1e-9, -1.0, -1e9] {
        let fault = SceneError::Sphere(1, Fault::Radius);
        assert_refused(
            sphere(size),
            fault,
            "sphere 1: radius must be greater than 0",
        );
        let fault = SceneError::Cylinder(1, Fault::Radius);
        assert_refused(
            wide(size),
            fault,
            "cylinder 1: radius must be greater than 0",
        );
        let fault = SceneError::Cylinder(1, Fault::Height);
        assert_refused(
            high(size),
            fault,
            "cylinder 1: height must be greater than 0",
        );
    }
    for size in UNHEARD_OF.into_iter().chain([BEYOND, 1e30]) {
        let words = format!("sphere 1: {COORDINATE}");
        assert_refused(
            sphere(size),
            SceneError::Sphere(1, Fault::Coordinate),
            &words,
        );
        let words = format!("cylinder 1: {COORDINATE}");
        assert_refused(
            wide(size),
            SceneError::Cylinder(1, Fault::Coordinate),
            &words,
        );
        assert_refused(
            high(size),
            SceneError::Cylinder(1, Fault::Coordinate),
            &words,
        );
    }
    for size in [1e-12, 1.0, LIMIT] {
        assert_accepted(sphere(size));
        assert_accepted(wide(size));
        assert_accepted(high(size));
    }
}

#[test]
fn normals_and_axes_must_point_somewhere() {
    // What is below half of 2^-64 is zero in the format.
    for zero in [[0.0; 3], [-0.0; 3], [1e-30, -1e-30, 0.0]] {
        let plane = |scene: &mut Scenery, id| scene.add_plane([0; 3], zero, id);
        let fault = SceneError::Plane(1, Fault::Normal);
        assert_refused(plane, fault, "plane 1: normal must not be zero");
        let tube = |scene: &mut Scenery, id| scene.add_cylinder([0; 3], zero, 1, 1, id);
        let fault = SceneError::Cylinder(1, Fault::Axis);
        assert_refused(tube, fault, "cylinder 1: axis must not be zero");
    }
    for short in [[1e-15, 0.0, 0.0], [0.0, -1e-19, 0.0]] {
        assert_accepted(|scene, id| scene.add_plane([0; 3], short, id));
        assert_accepted(|scene, id| scene.add_cylinder([0; 3], short, 1, 1, id));
    }
}

#[test]
fn colours_must_be_within_zero_to_sixteen() {
    for value in UNHEARD_OF.into_iter().chain([-1e-9, 16.000_001, 1e9]) {
        for channel in 0..3 {
            let mut color = [0.5; 3];
            color[channel] = value;
            let light = |scene: &mut Scenery, _| scene.add_light([0; 3], color);
            let fault = SceneError::Light(1, Fault::Color);
            assert_refused(
                light,
                fault,
                "light 1: color components must be within 0 to 16",
            );
            let background = |scene: &mut Scenery, _| scene.set_background(color);
            let fault = SceneError::Scene(Fault::Background);
            let words = "scene: background components must be within 0 to 16";
            assert_refused(background, fault, words);
        }
    }
    assert_accepted(|scene, _| scene.add_light([0; 3], [0.0, 0.5, 16.0]));
    assert_accepted(|scene, _| scene.set_background([0.0, 0.5, 16.0]));
}

#[test]
fn epsilon_must_be_greater_than_zero_and_smaller_than_the_scene() {
    let words = "scene: epsilon must be greater than 0 and smaller than the scene";
    let fault = SceneError::Scene(Fault::Epsilon);
    for value in UNHEARD_OF.into_iter().chain([0.0, -1e-9, BEYOND]) {
        assert_refused(|scene, _| scene.set_epsilon(value), fault, words);
    }
    assert_accepted(|scene, _| scene.set_epsilon(1e-9));
    // How large the scene is shows when it is built.
    let (mut scene, _) = furnished();
    scene.set_epsilon(1000).unwrap();
    assert_eq!(scene.build().unwrap_err(), fault);
    assert_eq!(scene.build().unwrap_err().to_string(), words);
}

#[test]
fn more_than_the_room_is_refused() {
    let full = |scene: &mut Scenery, id: MaterialId| {
        scene.add_sphere([1, 1, 1], 1, id).unwrap();
        scene.add_plane([1, 1, 1], [0, 1, 0], id).unwrap();
        scene.add_cylinder([1, 1, 1], [0, 1, 0], 1, 1, id).unwrap();
        scene.add_light([1, 1, 1], [1, 1, 1]).unwrap();
        scene.add_material(Material::new([0.5; 3])).unwrap();
    };
    let (mut scene, id) = furnished();
    full(&mut scene, id);
    let before = format!("{:?}", scene.description());
    let refusals = [
        (
            scene.add_sphere([2, 2, 2], 1, id).unwrap_err(),
            "sphere 2: too many spheres",
            "first",
        ),
        (
            scene.add_plane([2, 2, 2], [0, 1, 0], id).unwrap_err(),
            "plane 2: too many planes",
            "second",
        ),
        (
            scene
                .add_cylinder([2, 2, 2], [0, 1, 0], 1, 1, id)
                .unwrap_err(),
            "cylinder 2: too many cylinders",
            "third",
        ),
        (
            scene.add_light([2, 2, 2], [1, 1, 1]).unwrap_err(),
            "light 2: too many lights",
            "fourth",
        ),
        (
            scene.add_material(Material::new([0.1; 3])).unwrap_err(),
            "material 2: too many materials",
            "fifth",
        ),
    ];
    for (error, words, bound) in refusals {
        assert_eq!(
            error.to_string(),
            format!("{words}: raise the scene type's {bound} bound")
        );
    }
    let faults = refusals.map(|(error, ..)| error.fault());
    let expected = [
        Fault::TooManySpheres,
        Fault::TooManyPlanes,
        Fault::TooManyCylinders,
        Fault::TooManyLights,
        Fault::TooManyMaterials,
    ];
    assert_eq!(faults, expected);
    assert_eq!(format!("{:?}", scene.description()), before);
    assert!(scene.build().is_ok());
}

#[test]
fn material_of_another_scene_is_refused() {
    let (mut other, _) = furnished();
    let foreign = other.add_material(Material::new([0.5; 3])).unwrap();
    let words = "material does not exist in this scene: add it first";
    let unknown = Fault::UnknownMaterial;
    let sphere = |scene: &mut Scenery, _| scene.add_sphere([0; 3], 1, foreign);
    assert_refused(
        sphere,
        SceneError::Sphere(1, unknown),
        &format!("sphere 1: {words}"),
    );
    let plane = |scene: &mut Scenery, _| scene.add_plane([0; 3], [0, 0, 1], foreign);
    assert_refused(
        plane,
        SceneError::Plane(1, unknown),
        &format!("plane 1: {words}"),
    );
    let tube = |scene: &mut Scenery, _| scene.add_cylinder([0; 3], [0, 0, 1], 1, 1, foreign);
    assert_refused(
        tube,
        SceneError::Cylinder(1, unknown),
        &format!("cylinder 1: {words}"),
    );
}

#[test]
fn what_shows_in_the_whole_scene_is_refused_when_it_is_built() {
    let (mut scene, white) = furnished();
    scene.add_sphere([0; 3], 1e-9, white).unwrap();
    let error = scene.build().unwrap_err();
    assert_eq!(error, SceneError::Sphere(1, Fault::Tiny));
    let words = "sphere 1: radius and half the height must be at least 2^-22 of the scene's extent: \
                 enlarge it or shrink the scene";
    assert_eq!(error.to_string(), words);

    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0; 3], 1e-10, white).unwrap();
    let error = scene.build().unwrap_err();
    assert_eq!(error, SceneError::Scene(Fault::Extent));
    let words = "scene: the scene must be larger than 2^-30 scene units: scale it up";
    assert_eq!(error.to_string(), words);

    let (mut scene, _) = furnished();
    let made = Material::from_numbers([16, 0, 0], 1, 1, (0, 1), 0).unwrap();
    scene.add_material(made).unwrap();
    let error = scene.build().unwrap_err();
    assert_eq!(error, SceneError::Material(1, Fault::Brightness));
    let words = "material 1: color * (ambient + the sum over lights of (diffuse + specular) * \
                 light color), with and without color, must stay below 30: dim the material or \
                 the lights";
    assert_eq!(error.to_string(), words);
}

#[test]
fn fields_of_a_material_are_named() {
    let cases = [
        (
            0,
            Fault::Color,
            "color components must be within 0 to 16",
            16.0,
        ),
        (
            1,
            Fault::Color,
            "color components must be within 0 to 16",
            16.0,
        ),
        (
            2,
            Fault::Color,
            "color components must be within 0 to 16",
            16.0,
        ),
        (3, Fault::Ambient, "ambient must be within 0 to 16", 16.0),
        (4, Fault::Diffuse, "diffuse must be within 0 to 16", 16.0),
        (5, Fault::Specular, "specular must be within 0 to 16", 16.0),
        (
            6,
            Fault::Shininess,
            "shininess must be within 0 to 2^20",
            1_048_576.0,
        ),
        (7, Fault::Mirror, "mirror must be within 0 to 1", 1.0),
    ];
    let made = |field: usize, value: f64| {
        let mut values = [0.5; 8];
        values[field] = value;
        let [
            red,
            green,
            blue,
            ambient,
            diffuse,
            specular,
            shininess,
            mirror,
        ] = values;
        let highlight = (specular, shininess);
        Material::from_numbers([red, green, blue], ambient, diffuse, highlight, mirror)
    };
    for (field, fault, words, most) in cases {
        for value in UNHEARD_OF.into_iter().chain([-1e-9, most + 1e-9]) {
            assert_eq!(made(field, value), Err(fault), "{value}");
        }
        assert_eq!(fault.to_string(), words);
        for value in [0.0, -0.0, most] {
            assert!(made(field, value).is_ok(), "{fault:?} {value}");
        }
    }
}

#[track_caller]
fn assert_no_camera(made: Result<Camera, CameraError>, error: CameraError, words: &str) {
    assert_eq!(made, Err(error));
    assert_eq!(error.to_string(), words);
}

#[test]
fn camera_coordinates_must_fit_the_format() {
    let words = "camera coordinates must be finite and within -2^30 to 2^30 scene units";
    let (position, target, up) = ([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    for bad in bad_triples() {
        let error = CameraError::Coordinate;
        assert_no_camera(Camera::new(bad, target, up, 50), error, words);
        assert_no_camera(Camera::new(position, bad, up, 50), error, words);
        assert_no_camera(Camera::new(position, target, bad, 50), error, words);
    }
    for good in GOOD_TRIPLES {
        assert!(Camera::new(good, target, [0.1, 0.2, 0.3], 50).is_ok());
        assert!(Camera::new(position, good, [0.1, 0.2, 0.3], 50).is_ok());
    }
}

#[test]
fn camera_must_look_somewhere() {
    let words = "camera target must differ from its position";
    for at in [[0.0; 3], [1.5, -2.5, 1e9]] {
        assert_no_camera(
            Camera::new(at, at, [0.0, 0.0, 1.0], 50),
            CameraError::View,
            words,
        );
    }
    assert!(Camera::new([0.0; 3], [0.0, 1e-15, 0.0], [0.0, 0.0, 1.0], 50).is_ok());
}

#[test]
fn camera_up_must_not_be_zero_or_parallel_to_the_view() {
    let words = "camera up must not be zero or parallel to the view direction";
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
        assert_no_camera(
            Camera::new([0.0; 3], target, up, 50),
            CameraError::Up,
            words,
        );
    }
    for up in [[0.0, 0.0, 1e-9], [1e-3, -5.0, 2.0]] {
        assert!(Camera::new([0.0; 3], target, up, 50).is_ok(), "{up:?}");
    }
}

#[test]
fn camera_fov_must_be_between_its_limits() {
    let words = "camera fov must be between 0.001 and 179.999 degrees";
    let made = |fov: f64| Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], fov);
    for fov in UNHEARD_OF.into_iter().chain([
        0.0,
        -0.0,
        0.000_999_9,
        -50.0,
        179.999_01,
        180.0,
        180.001,
        360.0,
    ]) {
        assert_no_camera(made(fov), CameraError::FieldOfView, words);
    }
    for fov in [0.001, 50.0, 179.999] {
        assert!(made(fov).is_ok(), "{fov}");
    }
}

#[test]
fn faults_are_errors_as_the_language_knows_them() {
    let (mut scene, white) = furnished();
    let mut fill = || -> Result<(), Box<dyn Error>> {
        Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], 50)?;
        Material::from_numbers([1, 1, 1], 1, 1, (0, 1), 0)?;
        scene.add_sphere([0; 3], -1, white)?;
        Ok(())
    };
    assert_eq!(
        fill().unwrap_err().to_string(),
        "sphere 1: radius must be greater than 0"
    );
    assert_eq!(Number::new(NAN), Number::OUT_OF_RANGE);
    assert!(!Position::new([0.0, INFINITE, 0.0]).is_in_range());
}
