//! Range: the largest and the smallest numbers that are taken, and what is refused beyond.

use reflet::{Camera, CameraError, Fault, Material, MaterialId, RuntimeScene, SceneError};

use super::draft::Draft;
use super::{Case, claim, picture};

type Room = RuntimeScene<2, 1, 1, 1, 1>;

const MOST: f64 = (1 << 30) as f64;

/// The smallest length that a number of a description may be: 2⁻⁶⁴.
const SHORTEST: f64 = 1.0 / (1_u128 << 64) as f64;

/// A number, and what a constructor is to say of it.
type Limit<E> = (f64, Option<E>);

/// Whether each number is taken, or refused for the fault that is named.
fn held<E: PartialEq + std::fmt::Debug + std::fmt::Display>(
    what: &str,
    limits: &[Limit<E>],
    made: impl Fn(f64) -> Result<(), E>,
) -> Result<String, String> {
    let mut words = Vec::new();
    for (number, expected) in limits {
        let found = made(*number).err();
        if found != *expected {
            return Err(format!("{what} {number:e}: {found:?}, not {expected:?}"));
        }
        words.push(match found {
            None => format!("{number:e} is taken"),
            Some(error) => format!("{number:e}: \"{error}\""),
        });
    }
    Ok(format!("{what}: {}", words.join("; ")))
}

fn room() -> (Room, MaterialId) {
    let mut scene = Room::new();
    let id = scene.add_material(Material::new([0.9; 3]));
    (scene, id.expect("there is room"))
}

fn coordinates() -> Result<String, String> {
    let limits = |error: fn(usize, Fault) -> SceneError| {
        let beyond = Some(error(0, Fault::Coordinate));
        [
            (MOST, None),
            (-MOST, None),
            (MOST + 1.0, beyond),
            (-MOST - 1.0, beyond),
            (f64::INFINITY, beyond),
            (f64::NAN, beyond),
        ]
    };
    let sphere = held("sphere center", &limits(SceneError::Sphere), |x| {
        let (mut scene, id) = room();
        scene.add_sphere([x, 0.0, 0.0], 1.0, id)
    })?;
    held("plane center", &limits(SceneError::Plane), |x| {
        let (mut scene, id) = room();
        scene.add_plane([0.0, x, 0.0], [0.0, 0.0, 1.0], id)
    })?;
    held("cylinder center", &limits(SceneError::Cylinder), |x| {
        let (mut scene, id) = room();
        scene.add_cylinder([0.0, 0.0, x], [0.0, 0.0, 1.0], 1.0, 1.0, id)
    })?;
    held("light position", &limits(SceneError::Light), |x| {
        let (mut scene, _) = room();
        scene.add_light([x, 0.0, 0.0], [1.0; 3])
    })?;
    held(
        "camera position",
        &[(MOST, None), (MOST + 1.0, Some(CameraError::Coordinate))],
        |x| Camera::new([x, 1.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 50.0).map(|_| ()),
    )?;
    Ok(format!(
        "{sphere}; the same of planes, cylinders, lights and cameras"
    ))
}

fn sizes() -> Result<String, String> {
    let least = 2f64.powi(-64);
    let sphere = |fault| Some(SceneError::Sphere(0, fault));
    let tube = |fault| Some(SceneError::Cylinder(0, fault));
    let radius = held(
        "sphere radius",
        &[
            (least, None),
            (MOST, None),
            (0.0, sphere(Fault::Radius)),
            (-1.0, sphere(Fault::Radius)),
            (MOST + 1.0, sphere(Fault::Coordinate)),
        ],
        |radius| {
            let (mut scene, id) = room();
            scene.add_sphere([0.0; 3], radius, id)
        },
    )?;
    held(
        "cylinder radius",
        &[
            (least, None),
            (MOST, None),
            (0.0, tube(Fault::Radius)),
            (MOST + 1.0, tube(Fault::Coordinate)),
        ],
        |radius| {
            let (mut scene, id) = room();
            scene.add_cylinder([0.0; 3], [0.0, 0.0, 1.0], radius, 1.0, id)
        },
    )?;
    held(
        "cylinder height",
        &[
            (least, None),
            (MOST, None),
            (0.0, tube(Fault::Height)),
            (MOST + 1.0, tube(Fault::Coordinate)),
        ],
        |height| {
            let (mut scene, id) = room();
            scene.add_cylinder([0.0; 3], [0.0, 0.0, 1.0], 1.0, height, id)
        },
    )?;
    Ok(format!(
        "{radius}; the same of a cylinder's radius and height"
    ))
}

fn ratio() -> Result<String, String> {
    // A planet of 2^20 fills the ball of 2^28 steps: 64 of them are a quarter.
    let beside_a_planet = || -> Result<(Room, MaterialId), SceneError> {
        let (mut scene, id) = room();
        scene.add_sphere([0.0; 3], f64::from(1 << 20), id)?;
        Ok((scene, id))
    };
    let radius = held(
        "radius beside one of 2^20",
        &[
            (0.25, None),
            (0.248, Some(SceneError::Sphere(1, Fault::Tiny))),
        ],
        |radius| {
            let (mut scene, id) = beside_a_planet()?;
            scene.add_sphere([1.0, 2.0, 3.0], radius, id)?;
            scene.build().map(|_| ())
        },
    )?;
    let height = held(
        "height beside it",
        &[
            (0.5, None),
            (0.496, Some(SceneError::Cylinder(0, Fault::Tiny))),
        ],
        |height| {
            let (mut scene, id) = beside_a_planet()?;
            scene.add_cylinder([1.0, 2.0, 3.0], [0.0, 0.0, 1.0], 1.0, height, id)?;
            scene.build().map(|_| ())
        },
    )?;
    Ok(format!("{radius}. {height}"))
}

fn extent() -> Result<String, String> {
    let least = 2f64.powi(-30);
    held(
        "radius of a lonely sphere",
        &[
            (least, None),
            (MOST, None),
            (0.99 * least, Some(SceneError::Scene(Fault::Extent))),
        ],
        |radius| {
            let (mut scene, id) = room();
            scene.add_sphere([0.0; 3], radius, id)?;
            scene.set_epsilon(radius * 1e-3)?;
            scene.build().map(|_| ())
        },
    )
}

fn epsilon() -> Result<String, String> {
    let beyond = Some(SceneError::Scene(Fault::Epsilon));
    held(
        "epsilon beside a radius of 1",
        &[
            (1e-19, None),
            (0.999, None),
            (0.0, beyond),
            (-1.0, beyond),
            (1.0, beyond),
            (1e12, beyond),
        ],
        |epsilon| {
            let (mut scene, id) = room();
            scene.add_sphere([0.0; 3], 1.0, id)?;
            scene.set_epsilon(epsilon)?;
            scene.build().map(|_| ())
        },
    )
}

fn coefficients() -> Result<String, String> {
    let made = |[color, ambient, diffuse, specular, shininess, mirror]: [f64; 6]| {
        let highlight = (specular, shininess);
        Material::from_numbers([color; 3], ambient, diffuse, highlight, mirror).map(|_| ())
    };
    let good = [0.5, 0.2, 0.8, 0.1, 4.0, 0.3];
    let fields = [
        ("color", 16.0, Fault::Color),
        ("ambient", 16.0, Fault::Ambient),
        ("diffuse", 16.0, Fault::Diffuse),
        ("specular", 16.0, Fault::Specular),
        ("shininess", f64::from(1 << 20), Fault::Shininess),
        ("mirror", 1.0, Fault::Mirror),
    ];
    let mut words = Vec::new();
    for (place, (name, most, fault)) in fields.into_iter().enumerate() {
        let beyond = Some(fault);
        let limits = [
            (0.0, None),
            (most, None),
            (-1e-6, beyond),
            (1.000_001 * most, beyond),
        ];
        words.push(held(name, &limits, |number| {
            let mut numbers = good;
            numbers[place] = number;
            made(numbers)
        })?);
    }
    Ok(words.join(". "))
}

fn lights() -> Result<String, String> {
    let limits = |beyond: SceneError| {
        [
            (0.0, None),
            (16.0, None),
            (-1e-6, Some(beyond)),
            (16.000_001, Some(beyond)),
        ]
    };
    let light = SceneError::Light(0, Fault::Color);
    let colors = held("light color", &limits(light), |color| {
        room().0.add_light([1.0; 3], [color; 3])
    })?;
    let background = SceneError::Scene(Fault::Background);
    let behind = held("background", &limits(background), |color| {
        room().0.set_background([color; 3])
    })?;
    Ok(format!("{colors}. {behind}"))
}

fn brightness() -> Result<String, String> {
    held(
        "ambient beside diffuse 14 under a light of 1",
        &[(15.9, None), (16.0, None)],
        |ambient| lit(ambient, 14.0),
    )?;
    held(
        "diffuse beside ambient 16 under a light of 1",
        &[
            (14.0, None),
            (14.1, Some(SceneError::Material(0, Fault::Brightness))),
        ],
        |diffuse| lit(16.0, diffuse),
    )
}

fn lit(ambient: f64, diffuse: f64) -> Result<(), SceneError> {
    let mut scene = Room::new();
    let material = Material::from_numbers([1.0; 3], ambient, diffuse, (0.0, 1.0), 0.0);
    let id = scene.add_material(material.map_err(|fault| SceneError::Material(0, fault))?)?;
    scene.add_sphere([0.0; 3], 1.0, id)?;
    scene.add_light([3.0; 3], [1.0; 3])?;
    scene.build().map(|_| ())
}

fn field_of_view() -> Result<String, String> {
    let beyond = Some(CameraError::FieldOfView);
    held(
        "fov",
        &[
            (0.001, None),
            (179.999, None),
            (0.000_999, beyond),
            (179.9991, beyond),
            (180.0, beyond),
        ],
        |fov| Camera::new([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], fov).map(|_| ()),
    )
}

fn directions() -> Result<String, String> {
    let refused = |fault: SceneError| [(SHORTEST, None), (-MOST, None), (0.0, Some(fault))];
    let normal = SceneError::Plane(0, Fault::Normal);
    let normal = held("length of a normal", &refused(normal), |z| {
        let (mut scene, id) = room();
        scene.add_plane([0.0; 3], [0.0, 0.0, z], id)
    })?;
    let axis = SceneError::Cylinder(0, Fault::Axis);
    let axis = held("of an axis", &refused(axis), |x| {
        let (mut scene, id) = room();
        scene.add_cylinder([0.0; 3], [x, 0.0, 0.0], 1.0, 1.0, id)
    })?;
    let view = [
        (SHORTEST, None),
        (-MOST, None),
        (0.0, Some(CameraError::View)),
    ];
    let view = held("from a camera to its target", &view, |y| {
        Camera::new([0.0; 3], [0.0, y, 0.0], [0.0, 0.0, 1.0], 50.0).map(|_| ())
    })?;
    Ok([normal, axis, view].join(". "))
}

fn room_for() -> Result<String, String> {
    let fill =
        |what, most: f64, fault, add: fn(&mut Room, MaterialId) -> Result<(), SceneError>| {
            held(what, &[(most, None), (most + 1.0, Some(fault))], |count| {
                let (mut scene, id) = room();
                (0..count as u32).try_for_each(|_| add(&mut scene, id))
            })
        };
    let spheres = SceneError::Sphere(2, Fault::TooManySpheres);
    let planes = SceneError::Plane(1, Fault::TooManyPlanes);
    let cylinders = SceneError::Cylinder(1, Fault::TooManyCylinders);
    let lights = SceneError::Light(1, Fault::TooManyLights);
    let words = [
        fill("spheres", 2.0, spheres, |room, id| {
            room.add_sphere([0.0; 3], 1.0, id)
        })?,
        fill("planes", 1.0, planes, |room, id| {
            room.add_plane([0.0; 3], [0.0, 0.0, 1.0], id)
        })?,
        fill("cylinders", 1.0, cylinders, |room, id| {
            room.add_cylinder([0.0; 3], [0.0, 0.0, 1.0], 1.0, 1.0, id)
        })?,
        fill("lights", 1.0, lights, |room, _| {
            room.add_light([0.0; 3], [1.0; 3])
        })?,
    ];
    let mut other = Room::new();
    let unknown = other.add_sphere([0.0; 3], 1.0, room().1).err();
    let expected = Some(SceneError::Sphere(0, Fault::UnknownMaterial));
    if unknown != expected {
        return Err(format!("a material of another scene: {unknown:?}"));
    }
    Ok(format!(
        "{}. A material that is not there: \"{}\"",
        words.join(". "),
        SceneError::Sphere(0, Fault::UnknownMaterial)
    ))
}

fn up() -> Result<String, String> {
    let beyond = Some(CameraError::Up);
    held(
        "sine between view and up",
        &[(1.0, None), (1e-6, None), (1e-9, beyond), (0.0, beyond)],
        |sine| Camera::new([0.0; 3], [0.0, 0.0, 1.0], [0.0, sine, 1.0], 50.0).map(|_| ()),
    )
}

/// The cases of the chapter.
pub fn cases() -> Vec<Case> {
    let edge = "the last number that is taken must be drawn truly, and the next be refused by name";
    vec![
        claim("coordinates", edge, coordinates),
        claim("radii and heights", edge, sizes),
        claim("sizes beside the scene's extent", edge, ratio),
        claim("extent of a scene", edge, extent),
        claim("normals, axes and views", edge, directions),
        claim("room in a scene", edge, room_for),
        claim("epsilon", edge, epsilon),
        claim("materials", edge, coefficients),
        claim("light and background", edge, lights),
        claim("brightness", edge, brightness),
        claim("field of view", edge, field_of_view),
        claim("up", edge, up),
        picture("drawn: radius of 2^30", edge, lonely(MOST)),
        picture("drawn: radius of 2^-29", edge, lonely(2f64.powi(-29))),
        picture("drawn: light of 14, material of 16", edge, glaring()),
    ]
}

/// A sphere and a light of its size, seen from as near as one may look at it. The eye of the largest
/// stands at the largest coordinate.
fn lonely(radius: f64) -> Draft {
    let at = |at: [f64; 3]| at.map(|it| it * radius);
    Draft::seen_from(at([1.0, -1.0, 0.5]), [0.0; 3])
        .light(at([1.0, -0.5, 1.0]))
        .sphere([0.0; 3], radius, "gold")
        .epsilon(1e-3 * radius)
}

/// A background and a material of 16, under the brightest light that the material white may have.
fn glaring() -> Draft {
    Draft::seen_from([0.5, -4.0, 1.5], [0.0, 0.0, 0.5])
        .material("dim", [0.1, 0.05, 0.08], [16.0, 0.8, 0.0, 1.0, 0.0])
        .shining([3.0, -5.0, 4.0], [14.0; 3])
        .sphere([0.0, 0.0, 0.6], 0.6, "dim")
        .before([16.0, 0.0, 0.5])
}
