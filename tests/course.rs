//! Compares pictures of the double-precision reference with those that the scenes' authors rendered.
//!
//! The authors' pictures are in the folder `REFLET_COURSE`, or else next to the repository.

use std::{
    env, fs,
    path::{Path, PathBuf},
};

use reflet::host::compare::compare;
use reflet::host::file::SceneFile;
use reflet::host::reference::{Picture, Shading, render};

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
    let course = env::var_os("REFLET_COURSE").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/course"),
        PathBuf::from,
    );
    if !course.is_dir() {
        println!("skipped: there is no folder {}", course.display());
        return;
    }
    let text = fs::read_to_string(course.join("scenes.json")).unwrap();
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
