//! Compares the built-in scenes and the double-precision reference with what the scenes' authors wrote and
//! rendered.
//!
//! Their files are in the folder `REFLET_COURSE`, or else next to the repository.

use std::{env, fs, path::Path, path::PathBuf};

use reflet::host::compare::compare;
use reflet::host::file::SceneFile;
use reflet::host::reference::{Camera, Picture, Scene, Shading, render};
use reflet::scenes::{BuiltIn, NAMES, Visitor, visit};

/// Returns the folder of the authors and their scenes, or `None` if there is no such folder.
fn course() -> Option<(PathBuf, String)> {
    let folder = env::var_os("REFLET_COURSE").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/course"),
        PathBuf::from,
    );
    if !folder.is_dir() {
        println!("skipped: there is no folder {}", folder.display());
        return None;
    }
    let text = fs::read_to_string(folder.join("scenes.json")).unwrap();
    Some((folder, text))
}

#[test]
fn castle_is_the_authors_picture() {
    assert_agrees("castle", 4, 0.998);
}

#[test]
fn columns_are_the_authors_picture() {
    assert_agrees("columns", 0, 0.995);
}

/// Fails if fewer than this share of the pixels are within 1 of 255 of the authors' picture.
///
/// The shares are below 1 because the authors lift rays off surfaces by other rules, which shows at
/// the edges of shadows and mirrors.
fn assert_agrees(name: &str, reflections: u32, bar: f64) {
    let Some((course, text)) = course() else {
        return;
    };
    let file = SceneFile::parse(&text, Some(name)).unwrap();
    let (scene, camera) = file.reference();
    let authors = picture(&course.join(format!("{name}_blinn_phong_{reflections}.png")));
    let (width, height) = (authors.width, authors.height);
    assert_eq!((width, height), (640, 640));
    let shading = Shading::BlinnPhong;
    let own = render(&scene, &camera, width, height, reflections, shading);
    let difference = compare(&own, &authors).unwrap();
    println!("{name}: {difference:?}");
    assert!(difference.within1 >= bar, "{name}: {difference:?}");
}

fn picture(path: &Path) -> Picture {
    let image = image::open(path).unwrap().to_rgb8();
    Picture {
        width: image.width(),
        height: image.height(),
        pixels: image.pixels().map(|pixel| pixel.0).collect(),
    }
}

#[test]
fn every_built_in_scene_has_the_figures_of_its_source() {
    let Some((_, text)) = course() else {
        return;
    };
    let sources = SceneFile::parse_all(&text).unwrap();
    let names: Vec<_> = sources.iter().filter_map(SceneFile::name).collect();
    assert_eq!(names, NAMES);
    for (name, source) in NAMES.into_iter().zip(&sources) {
        let (scene, camera) = source.reference();
        let (built_in, its_camera) = visit(name, Describe).unwrap();
        assert_eq!(camera, its_camera, "{name}");
        assert_eq!(parts(&built_in), parts(&scene), "{name}");
    }
}

/// Returns a scene as lines: one with the numbers of the whole scene, and one for each of its parts. A shape's line
/// has its material, because two scenes may list the same materials in another order.
fn parts(scene: &Scene) -> Vec<String> {
    let whole = format!("{:?} {:?} {}", scene.background, scene.sky, scene.epsilon);
    let shapes = scene.shapes().map(|it| {
        let material = &scene.materials[it.material];
        format!("{} {:?} {material:?}", it.kind, it.fields)
    });
    let lights = scene.lights.iter().map(|it| format!("{it:?}"));
    [whole].into_iter().chain(shapes).chain(lights).collect()
}

/// Converts a built-in scene to that of a file.
struct Describe;

impl Visitor for Describe {
    type Output = (Scene, Camera);

    fn visit<S: BuiltIn>(self) -> Self::Output {
        S::with_description(|scene| {
            assert_eq!(scene.camera.as_ref(), Some(&S::CAMERA));
            (Scene::from(&scene), Camera::from(&S::CAMERA))
        })
    }
}
