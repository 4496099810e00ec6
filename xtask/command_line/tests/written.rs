//! Files that commands write: they replace what the user named, and a scene is read again as it was.

use std::fs;
use std::path::Path;

use command_line::{OutputFile, are_same_file, scene_file};
use reflet::host::file::SceneFile;

#[test]
fn names_are_the_same_however_they_lead_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("a")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink(path("a"), path("link")).unwrap();
    assert!(are_same_file(&path("x"), &path("./x")));
    assert!(are_same_file(&path("x"), &path("a/../x")));
    #[cfg(unix)]
    assert!(are_same_file(&path("a/x"), &path("link/x")));
    assert!(!are_same_file(&path("x"), &path("a/x")));
    assert!(!are_same_file(&path("x"), &path("y")));
    assert!(are_same_file("-".as_ref(), "-".as_ref()));
    assert!(!are_same_file("./-".as_ref(), "-".as_ref()));
}

#[test]
fn name_without_a_number_comes_first() {
    let folder = tempfile::tempdir().unwrap();
    let castle = folder.path().join("castle.png");
    for name in ["castle.png", "castle-2.png", "castle-3.png"] {
        let written = OutputFile::free_png(&castle).unwrap().write(b"dots");
        assert_eq!(written.unwrap(), folder.path().join(name));
    }
}

#[test]
fn nothing_is_left_where_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    drop((OutputFile::png_at(&path), OutputFile::free_png(&path)));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn file_that_the_user_named_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    for dots in ["many old dots", "dots"] {
        let written = OutputFile::png_at(&path).unwrap().write(dots.as_bytes());
        assert_eq!(written.unwrap(), path);
        assert_eq!(fs::read_to_string(&path).unwrap(), dots);
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn file_that_cannot_be_replaced_leaves_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    let file = OutputFile::png_at(&path).unwrap();
    // A folder has taken the name since.
    fs::create_dir(&path).unwrap();
    file.write(b"dots").unwrap_err();
    assert!(path.is_dir());
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn file_behind_a_link_is_replaced_and_keeps_its_permissions() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("pictures")).unwrap();
    fs::write(path("pictures/a.png"), "old dots").unwrap();
    fs::set_permissions(path("pictures/a.png"), PermissionsExt::from_mode(0o600)).unwrap();
    symlink("pictures/a.png", path("link.png")).unwrap();
    let written = OutputFile::png_at(&path("link.png"))
        .unwrap()
        .write(b"dots");
    written.unwrap();
    assert!(path("link.png").is_symlink());
    assert_eq!(fs::read(path("pictures/a.png")).unwrap(), b"dots");
    let mode = path("pictures/a.png")
        .metadata()
        .unwrap()
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
}

#[test]
fn name_of_another_format_is_refused() {
    let refused = OutputFile::png_at(Path::new("a.jpg"))
        .unwrap_err()
        .to_string();
    let expected = "a.jpg: pictures are written as PNG only: name it a.png";
    assert_eq!(refused, expected);
}

#[test]
fn scene_with_everything_is_read_again_as_it_was() {
    let file = r#"{
  "name": "still life",
  "camera": { "position": [1, -5, 2.5], "target": [0, 0, 1], "up": [0, 0.5, 1], "fov": 40.25 },
  "materials": [
    { "name": "old clay", "color": [0.5, 0.25, 0.125], "ambient": 0.3, "mirror": 0.5, "checker": { "color": [0, 0, 1], "size": [1, 0, 2] } }
  ],
  "lights": [
    { "position": [3, -4, 6], "color": [1, 0.5, 0.25] }
  ],
  "suns": [
    { "direction": [1, 0, 2], "color": [1, 1, 0.5], "disc": 0.5 },
    { "direction": [0, -1, 1], "color": [0.25, 0, 0] }
  ],
  "spheres": [
    { "center": [10, 0, 1.05], "radius": 1, "material": "old clay" }
  ],
  "planes": [
    { "center": [0, 0, -1], "normal": [0, 0, 2], "material": "old clay" }
  ],
  "cylinders": [
    { "center": [2, 0, 1], "axis": [0, 0, 3], "radius": 0.5, "height": 2, "material": "old clay" }
  ],
  "discs": [
    { "center": [2, 0, 3], "normal": [0, 0, 4], "radius": 0.75, "material": "old clay" }
  ],
  "triangles": [
    { "corners": [[0, 0, 0], [1, 0, 0], [0, 0, 1.5]], "material": "old clay" },
    { "corners": [[0, 1, 0], [1, 1, 0], [0, 1, 1]], "normals": [[0, -1, 0], [0.5, -1, 0], [0, -1, 0.5]], "material": "old clay" }
  ],
  "sky": { "up": [0, 0, 5], "below": [0.125, 0.25, 0.375], "horizon": [0.5, 1, 2], "above": [0.0625, 0, 1] },
  "epsilon": 0.0078125
}
"#;
    let read = SceneFile::parse(file, None).unwrap();
    let (scene, camera) = read.reference();
    let text = scene_file::text("still life", read.materials(), &scene, &camera);
    assert_eq!(text, file);
}
