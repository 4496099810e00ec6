use std::string::{String, ToString};
use std::vec::Vec;

use super::*;

/// Returns a file with a light and these suns.
fn with(suns: &Value) -> String {
    let mut scene = scene();
    scene["suns"] = suns.clone();
    scene.to_string()
}

fn sun(direction: [f64; 3], disc: f64) -> Value {
    json!({ "direction": direction, "color": [1, 0.5, 0], "disc": disc })
}

/// Suns follow the lights, and the Rust source says the same.
#[test]
fn suns_of_a_file_are_lights_with_a_direction() {
    let low = json!({ "direction": [1, 0, 0.25], "color": [0, 0, 1] });
    let text = with(&json!([sun([3.0, -4.0, 5.0], 0.5), low]));
    let file = SceneFile::parse(&text, None).unwrap();
    let (scene, _) = file.reference();
    let suns = scene.lights.iter().map(|it| it.sun);
    assert_eq!(suns.collect::<Vec<_>>(), [None, Some(0.5), Some(0.0)]);
    let source = file.rust_source().text();
    for line in [
        "sun_with_disc([3.0, -4.0, 5.0], [1.0, 0.5, 0.0], 0.5);",
        "sun([1.0, 0.0, 0.25], [0.0, 0.0, 1.0]);",
    ] {
        assert!(source.contains(line), "{source}");
    }
}

#[test]
fn mistakes_in_suns_name_the_sun_and_the_fix() {
    let good = sun([3.0, -4.0, 5.0], 0.5);
    let fix = "direction must not be zero, and disc must be within 0 to 90 degrees";
    for (suns, message) in [
        (
            json!([good, sun([0.0; 3], 0.0)]),
            &*std::format!("suns[1]: {fix}"),
        ),
        (
            json!([sun([0.0, 0.0, 1.0], 91.0)]),
            &*std::format!("suns[0]: {fix}"),
        ),
        (
            json!([good, good, good]),
            "suns[2]: there is room for 2 suns at most",
        ),
    ] {
        let file = SceneFile::parse(&with(&suns), None).unwrap();
        let error = file.build().unwrap_err().to_string();
        assert!(error.contains(message), "{error}");
    }
}
