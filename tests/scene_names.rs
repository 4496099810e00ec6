//! Tests that `scene!` and `room!` take any name: no word of the macros meets a name of the user.

#![allow(
    non_camel_case_types,
    non_snake_case,
    non_upper_case_globals,
    reason = "names are what is tested"
)]

use reflet::Camera;

const CAMERA: Camera = Camera::look_at([0.0, -5.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);

/// Declares a scene of each name in a module of its own, and a test that views all of them.
macro_rules! scenes_named {
    ($test:ident: $($name:ident)*) => {
        mod $test {
            $(pub mod $name {
                ::reflet::scene! {
                    pub struct $name {
                        motion([-1.0, -1.0, 0.0], [1.0, 1.0, 6.0]);
                        sphere $name([0.0, 0.0, 1.0], 1.0, ::reflet::Material::new([0.9, 0.1, 0.1]));
                        light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
                    }
                }
            })*
        }

        #[test]
        fn $test() {
            $({
                let _ = $test::$name::$name::frame(&CAMERA);
                let spheres = $test::$name::$name::with_description(|it| it.spheres.len());
                assert_eq!(spheres, 1, stringify!($name));
                assert_eq!($test::$name::$name::$name.index(), 0, stringify!($name));
            })*
        }
    };
}

scenes_named! {
    scene_has_a_name_of_the_library:
    Camera Error ErrorKind FrameBuilder Handle Material MaterialId MovingScene Number Position
    PreparedFrame Report Rows RuntimeScene Scene SceneBuilder Unit
    budget description display host needs quality room scene scenes shading
    Budgeted CameraDescription Choice Corners Cylinder Description Disc Light Limited Need Needs NeedsLimit
    Normals Plane Sphere Tabled Triangle
}

scenes_named! {
    scene_has_a_name_that_the_macros_use:
    Apart BUILDER COUNTS Capacity Clone Copy Counts Debug Everything FnOnce INSTANCE
    LargestRoom NAMES PARTS R Room SCENE SceneLines StaticScene T
    build camera concat counts described f moves_as name named new of_fields other parameter parts
    read stringify with_counts
    S P C L M D F
}

scenes_named! {
    scene_has_a_name_of_rust:
    Box Default Err Fn FnMut Formatter From Into Iterator None Ok Option Result Some String ToOwned Vec
    alloc array bool char core f32 f64 i32 isize mem reflet slice std str u16 u32 u64 u8 usize
}

scenes_named! {
    scene_has_a_name_of_a_part:
    background cylinder disc epsilon light motion plane sky sphere spheres planes cylinders discs lights
    materials triangle triangles
}

/// Macros, traits and constants of a user that have the names of words in the macros.
mod user {
    #[allow(unused_macros, reason = "no macro of the library may call it")]
    macro_rules! concat {
        ($($word:tt)*) => {
            compile_error!("the user's macro")
        };
    }
    #[allow(unused_macros, reason = "no macro of the library may call it")]
    macro_rules! stringify {
        ($($word:tt)*) => {
            compile_error!("the user's macro")
        };
    }

    #[allow(dead_code, reason = "no macro of the library may call it")]
    trait Meets: Sized {
        fn build(self) {}
        fn counts(self) {}
        fn description(self) {}
        fn parameter(self, _: &str) {}
    }
    impl<T> Meets for T {}

    const BUILDER: f64 = 1.0;
    const COUNTS: f64 = 2.0;
    const NAMES: f64 = 3.0;
    const Room: f64 = 4.0;
    const SCENE: f64 = 5.0;
    const INSTANCE: f64 = 6.0;

    reflet::scene! {
        pub struct Named {
            sphere([BUILDER, COUNTS, NAMES], Room, reflet::Material::new([0.5; 3]));
            light([SCENE, INSTANCE, 9.0], [1.0; 3]);
        }
    }

    pub type Held = reflet::RuntimeScene<reflet::room!(spheres: COUNTS as usize, lights: 1)>;
}

#[test]
fn arguments_see_the_users_constants() {
    let (center, radius) = user::Named::with_description(|it| {
        let center = it.spheres[0].center;
        (center, it.spheres[0].radius)
    });
    assert_eq!(center, reflet::Position::new([1.0, 2.0, 3.0]));
    assert_eq!(radius, reflet::Number::new(4.0));
    let mut scene = user::Held::new();
    let chalk = scene.add_material(reflet::Material::new([0.9; 3])).unwrap();
    scene.add_sphere([0, 0, 0], 1, chalk).unwrap();
    scene.add_sphere([1, 0, 0], 1, chalk).unwrap();
    assert!(scene.add_sphere([2, 0, 0], 1, chalk).is_err());
}
