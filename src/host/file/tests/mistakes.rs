//! Tests that what is wrong in a scene file is named: the place, the mistake and the fix.

use super::*;

#[test]
fn broken_text_is_reported_with_line_and_column() {
    let ends = "the file ends too early: a bracket or a quote is not closed";
    let cases = [
        ("", &*format!("line 1, column 0: {ends}")),
        (
            "{\n  \"camera\": }",
            "line 2, column 13: camera: a value is missing here, or is not JSON",
        ),
        ("{\n\n  \"camera", &format!("line 3, column 9: {ends}")),
        ("{} {}", "line 1, column 2: the scene has no camera: add it"),
        (
            "3",
            "line 1, column 1: a scene must be an object, in { }, not the number 3",
        ),
        (
            "[{\n \"spheres\": 7 }]",
            "line 2, column 13: [0].spheres must be a list, in [ ], not the number 7",
        ),
        (
            "{ \"spheres\": [ { \"center\": [0, 0] } ] }",
            "line 1, column 33: spheres[0].center must be a list of 3 numbers, not 2",
        ),
        (
            "{ \"epsilon\": 1e999 }",
            "line 1, column 18: epsilon: the number is too large",
        ),
        (
            "{ \"epsilon\": NaN }",
            "line 1, column 14: epsilon: a value is missing here, or is not JSON",
        ),
        (
            "{ \"epsilon\": 1, \"epsilon\": 2 }",
            "line 1, column 25: the scene has epsilon twice: remove one",
        ),
        (
            "{ \"epsilon\":\n true }",
            "line 2, column 5: epsilon must be a number, not true",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(complaint(text), expected, "{text}");
    }
}

#[test]
fn triangle_with_two_or_four_corners_is_told_to_have_three() {
    let point = json!([0, 0, 0]);
    for (pointer, count, expected) in [
        (
            "/triangles/0/corners",
            2,
            "triangles[0].corners must be 3 lists of 3 numbers, one for each corner, not 2",
        ),
        (
            "/triangles/0/normals",
            4,
            "triangles[0].normals has more than 3 lists: remove the rest",
        ),
    ] {
        let found = complaint(&scene_with(pointer, vec![point.clone(); count]));
        assert!(found.ends_with(expected), "{found}");
    }
    let found = complaint(&scene_with("/triangles/0/corners/1", json!([0, 0])));
    assert!(
        found.ends_with("triangles[0].corners[1] must be a list of 3 numbers, not 2"),
        "{found}"
    );
}

#[test]
fn unknown_key_is_named() {
    let found = complaint("{ \"sheres\": [] }");
    assert!(
        found.starts_with(
            "line 1, column 10: the scene cannot have the key sheres, only $schema, name"
        ),
        "{found}"
    );
}

#[test]
fn every_key_but_the_optional_ones_is_required() {
    let objects = [
        "/camera",
        "/materials/0",
        "/lights/0",
        "/spheres/0",
        "/planes/0",
        "/cylinders/0",
        "/discs/0",
        "/triangles/0",
    ];
    for pointer in objects {
        let object = scene();
        let object = object.pointer(pointer).and_then(Value::as_object).unwrap();
        let optional = [
            "ambient",
            "diffuse",
            "specular",
            "shininess",
            "mirror",
            "normals",
        ];
        for key in object.keys().filter(|it| !optional.contains(&it.as_str())) {
            let found = complaint(&scene_without(pointer, key));
            assert!(
                found.ends_with(&format!(" has no {key}: add it")),
                "{found}"
            );
        }
    }
}

#[test]
fn unknown_material_is_named_with_its_shape() {
    for list in ["spheres", "planes", "cylinders", "discs", "triangles"] {
        let found = complaint(&scene_with(&format!("/{list}/0/material"), "brass"));
        let expected = format!(
            "scene still life: {list}[0].material: there is no material brass: add it to materials"
        );
        assert_eq!(found, expected);
    }
}

#[test]
fn repeated_material_is_named_with_both_places() {
    let expected = "scene still life: materials[1] has the name clay of materials[0]";
    assert_eq!(
        complaint(&scene_with("/materials/1/name", "clay")),
        expected
    );
}

#[test]
fn what_the_core_refuses_is_reported_with_its_place() {
    let camera = &format!("camera: {}", ErrorKind::FieldOfView);
    let cases = [
        (
            "/spheres/0/radius",
            json!(0),
            "spheres[0]: radius must be greater than 0",
        ),
        (
            "/cylinders/0/radius",
            json!(-1),
            "cylinders[0]: radius must be greater than 0",
        ),
        (
            "/cylinders/0/height",
            json!(0),
            "cylinders[0]: height must be greater than 0",
        ),
        (
            "/cylinders/0/axis",
            json!([0, 0, 0]),
            "cylinders[0]: axis must not be zero",
        ),
        (
            "/discs/0/radius",
            json!(0),
            "discs[0]: radius must be greater than 0",
        ),
        (
            "/discs/0/normal",
            json!([0, 0, 0]),
            "discs[0]: normal must not be zero",
        ),
        (
            "/triangles/0/corners/2",
            json!([6, 0, 1]),
            "triangles[0]: corners must not lie on one line: make the smallest altitude at least 2^-20 of the \
             longest side",
        ),
        (
            "/triangles/0/normals/1",
            json!([0, 0, 0]),
            "triangles[0]: normal must not be zero",
        ),
        (
            "/planes/0/normal",
            json!([0, 0, 0]),
            "planes[0]: normal must not be zero",
        ),
        (
            "/lights/0/color",
            json!([0, -1, 0]),
            "lights[0]: color components must be within 0 to 16, where white is 1",
        ),
        (
            "/materials/1/mirror",
            json!(1.5),
            "materials[1]: mirror must be within 0 to 1",
        ),
        (
            "/background",
            json!([0, 0, 17]),
            "background components must be within 0 to 16",
        ),
        (
            "/epsilon",
            json!(0),
            "epsilon must be greater than 0 and smaller than the scene",
        ),
        (
            "/epsilon",
            json!(1e12),
            "epsilon must be greater than 0 and smaller than the scene",
        ),
        ("/camera/fov", json!(180), camera),
        (
            "/camera/up",
            json!([1e300, 0, 0]),
            &format!("camera: {}", ErrorKind::Coordinate),
        ),
        (
            "/spheres/0/center/1",
            json!(1e300),
            &format!("spheres[0]: {}", ErrorKind::Coordinate),
        ),
        (
            "/spheres/0/radius",
            json!(1e-12),
            &format!(
                "spheres[0]: {}; here the extent is 4 and the least 0.0000009537",
                ErrorKind::Tiny
            ),
        ),
    ];
    for (pointer, value, expected) in cases {
        let expected = format!("scene still life: {expected}");
        assert_eq!(
            complaint(&scene_with(pointer, value)),
            expected,
            "{pointer}"
        );
    }
}

/// The scene of `examples/scenes/harbour.json`.
const HARBOUR: &str = include_str!("../../../../examples/scenes/harbour.json");

/// Mistakes in the harbour: the text, what a person writes instead, and the words of the error after
/// the position or the name of the scene.
const MISTAKES: &[(&str, &str, &str)] = &[
    (
        "\"camera\"",
        "\"camara\"",
        "the scene cannot have the key camara, only $schema, name, camera",
    ),
    (
        "\"radius\"",
        "\"raduis\"",
        "spheres[0] cannot have the key raduis, only center, radius, material",
    ),
    (
        "\"color\": [0.7",
        "\"colour\": [0.7",
        "materials[0] cannot have the key colour, only name, color, ",
    ),
    (
        "\"color\": [0.6, 0.8, 1], ",
        "",
        "materials[1] has no color: add it",
    ),
    (
        "\"normal\": [0, 0, 1], ",
        "",
        "planes[0] has no normal: add it",
    ),
    (
        "\"radius\": 1",
        "\"radius\": \"1\"",
        "spheres[0].radius must be a number, not the text \"1\"",
    ),
    (
        "\"radius\": 1",
        "\"radius\": null",
        "spheres[0].radius must be a number, not null",
    ),
    ("\"harbour\"", "5", "name must be a text, not the number 5"),
    (
        "\"material\": \"gold\"",
        "\"material\": 0",
        "spheres[0].material must be a text, not the number 0",
    ),
    (
        "[0.7, 0.6, 0]",
        "[0.7, 0.6]",
        "materials[0].color must be a list of 3 numbers, not 2",
    ),
    (
        "[0.7, 0.6, 0]",
        "[0.7, 0.6, 0, 1]",
        "materials[0].color has more than 3 numbers: remove the rest",
    ),
    (
        "[0.7, 0.6, 0]",
        "\"#b29900\"",
        "materials[0].color must be a list of 3 numbers, not the text",
    ),
    (
        "[0.7, 0.6, 0]",
        "[178, 153, 0]",
        "materials[0]: color components must be within 0 to 16, where white is 1",
    ),
    (
        "[{ \"position\": [3, -4, 6], \"color\": [1, 1, 1] }]",
        "{ \"position\": [3, -4, 6] }",
        "lights must be a list, in [ ], not an object",
    ),
    (
        "{ \"position\": [3",
        "{ \"light\": [3",
        "lights[0] cannot have the key light, only position, color",
    ),
    (
        "\"fov\": 50",
        "\"lights\": []",
        "camera cannot have the key lights, only position, target, up, fov",
    ),
    (
        "\"radius\": 1,",
        "\"radius\": 1",
        "spheres[0]: a comma or a closing } is missing before this",
    ),
    (
        "0.6]\n",
        "0.6],\n",
        "the comma after the last value must go",
    ),
    (
        "  \"name\": \"h",
        "  // \"name\": \"h",
        "a key must be a text in double quotes; JSON has no comments",
    ),
    (
        "\"mirror\": 0.4",
        "\"mirror\": .4",
        "materials[0].mirror: a value is missing here, or is not JSON",
    ),
    (
        "\"material\": \"gold\"",
        "\"material\": \"golden\"",
        "spheres[0].material: there is no material golden: add it to materials",
    ),
    (
        "\"radius\": 1",
        "\"radius\": -1",
        "spheres[0]: radius must be greater than 0",
    ),
    (
        "\"radius\": 1",
        "\"radius\": 1e-9",
        "spheres[0]: radius and height must be larger than epsilon, which is 0.001 by default",
    ),
    (
        "\"fov\": 50",
        "\"fov\": 200",
        "camera: fov must be between 0.001 and 179.999 degrees",
    ),
    (
        "\"up\": [0, 0, 1]",
        "\"up\": [0, 5, -1]",
        "camera: up must not be zero or parallel to the view direction",
    ),
];

#[test]
fn mistakes_of_people_are_named_with_part_and_fix() {
    for (right, wrong, words) in MISTAKES {
        let text = HARBOUR.replacen(right, wrong, 1);
        assert_ne!(text, HARBOUR, "{right}");
        let found = complaint(&text);
        let after = match found.strip_prefix("line ") {
            Some(position) => position.split_once(": ").expect("a position").1,
            None => found.strip_prefix("scene harbour: ").expect("its name"),
        };
        assert!(after.starts_with(words), "{found}\nshould say {words}");
    }
}
