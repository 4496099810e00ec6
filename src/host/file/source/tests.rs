//! The names in the source. That a source compiles and draws the same is tested where it is compiled.

use super::names::{constants, type_name};
use alloc::borrow::ToOwned;

#[test]
fn types_are_named_in_camel_case_and_apart_from_the_imports() {
    let named = [
        ("castle", "Castle"),
        ("shading_lights", "ShadingLights"),
        ("my scene-2", "MyScene2"),
        ("2 balls", "Scene2Balls"),
        ("camera", "CameraScene"),
        ("self", "SelfScene"),
        ("été", "T"),
        ("", "TheScene"),
        ("雪", "TheScene"),
    ];
    for (name, expected) in named {
        assert_eq!(type_name(name), expected, "{name}");
    }
}

#[test]
fn constants_are_shouted_and_all_different() {
    let names = ["gold", "Gold", "old gold", "2", "", "雪", "camera", "Box"].map(str::to_owned);
    let expected = "GOLD GOLD_2 OLD_GOLD MATERIAL_2 MATERIAL MATERIAL_3 CAMERA_2 BOX_2";
    assert_eq!(constants(&names, "BOX").join(" "), expected);
}
