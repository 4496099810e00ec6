//! Cases of range: the largest and smallest accepted numbers, and the errors beyond them.

use reflet::{Camera, Error, ErrorKind, Material, MaterialId, RuntimeScene, room};

use super::draft::Draft;
use super::{Case, claim, picture};

type Room = RuntimeScene<room!(spheres: 2, planes: 1, cylinders: 1, lights: 1, materials: 1)>;

/// Largest coordinate, radius or length of a description: 2³⁰.
const MOST: f64 = (1 << 30) as f64;

/// Smallest length that a direction of a description may have: 2⁻⁶⁴.
const SHORTEST: f64 = 1.0 / (1_u128 << 64) as f64;

type Triple = [f64; 3];
type Added = Result<(), Error>;

/// An error as a case expects it: its part, the index of the part, and its kind.
type Refusal = (&'static str, Option<usize>, ErrorKind);

const ORIGIN: Triple = [0.0; 3];
const UP: Triple = [0.0, 0.0, 1.0];

/// A number, and the error that a constructor must return for it; `None` if it must accept the
/// number.
type Limit = (f64, Option<Refusal>);

/// Checks for each number that it is accepted, or refused with the given fault.
fn held<T>(
    what: &str,
    limits: &[Limit],
    made: impl Fn(f64) -> Result<T, Error>,
) -> Result<String, String> {
    let mut words = Vec::new();
    for (number, expected) in limits {
        let found = made(*number).err();
        if found.map(refusal) != *expected {
            return Err(format!("{what} {number:e}: {found:?}, not {expected:?}"));
        }
        words.push(match found {
            None => format!("{number:e} is taken"),
            Some(error) => format!("{number:e}: \"{error}\""),
        });
    }
    Ok(format!("{what}: {}", words.join("; ")))
}

/// Returns what a case expects of an error.
fn refusal(error: Error) -> Refusal {
    (error.part(), error.index(), error.kind())
}

/// Returns a scene with one material to which `add` adds something.
fn alone(add: impl FnOnce(&mut Room, MaterialId) -> Added) -> Result<Room, Error> {
    let mut scene = Room::new();
    let id = scene.add_material(Material::new([0.9; 3]))?;
    add(&mut scene, id)?;
    Ok(scene)
}

/// Returns the error of adding something to an empty scene, or of building the scene.
fn built(add: impl FnOnce(&mut Room, MaterialId) -> Added) -> Added {
    alone(add)?.build().map(|_| ())
}

fn sphere(center: Triple, radius: f64) -> Added {
    alone(|scene, id| scene.add_sphere(center, radius, id).map(drop)).map(drop)
}

fn plane(point: Triple, normal: Triple) -> Added {
    alone(|scene, id| scene.add_plane(point, normal, id)).map(drop)
}

fn cylinder(center: Triple, axis: Triple, radius: f64, height: f64) -> Added {
    let add = |scene: &mut Room, id| {
        scene
            .add_cylinder(center, axis, radius, height, id)
            .map(drop)
    };
    alone(add).map(drop)
}

fn camera(position: Triple, target: Triple, up: Triple, fov: f64) -> Result<(), Error> {
    Camera::new(position, target, up, fov).map(|_| ())
}

fn coordinates() -> Result<String, String> {
    let limits = |part| {
        let beyond = Some((part, Some(0), ErrorKind::Coordinate));
        [
            (MOST, None),
            (-MOST, None),
            (MOST + 1.0, beyond),
            (-MOST - 1.0, beyond),
            (f64::INFINITY, beyond),
            (f64::NAN, beyond),
        ]
    };
    let spheres = limits("sphere");
    let words = held("sphere center", &spheres, |x| sphere([x, 0.0, 0.0], 1.0))?;
    let planes = limits("plane");
    held("plane center", &planes, |y| plane([0.0, y, 0.0], UP))?;
    let cylinders = limits("cylinder");
    held("cylinder center", &cylinders, |z| {
        cylinder([0.0, 0.0, z], UP, 1.0, 1.0)
    })?;
    held("light position", &limits("light"), |x| {
        Room::new().add_light([x, 0.0, 0.0], [1.0; 3])
    })?;
    let cameras = [
        (MOST, None),
        (MOST + 1.0, Some(("camera", None, ErrorKind::Coordinate))),
    ];
    held("camera position", &cameras, |x| {
        camera([x, 1.0, 0.0], ORIGIN, UP, 50.0)
    })?;
    Ok(format!(
        "{words}; the same of planes, cylinders, lights and cameras"
    ))
}

fn sizes() -> Result<String, String> {
    let least = 2f64.powi(-64);
    let limits = |part, kind| {
        [
            (least, None),
            (MOST, None),
            (0.0, Some((part, Some(0), kind))),
            (-1.0, Some((part, Some(0), kind))),
            (MOST + 1.0, Some((part, Some(0), ErrorKind::Coordinate))),
        ]
    };
    let spheres = limits("sphere", ErrorKind::Radius);
    let words = held("sphere radius", &spheres, |radius| sphere(ORIGIN, radius))?;
    let wide = limits("cylinder", ErrorKind::Radius);
    held("cylinder radius", &wide, |radius| {
        cylinder(ORIGIN, UP, radius, 1.0)
    })?;
    let high = limits("cylinder", ErrorKind::Height);
    held("cylinder height", &high, |height| {
        cylinder(ORIGIN, UP, 1.0, height)
    })?;
    Ok(format!(
        "{words}; the same of a cylinder's radius and height"
    ))
}

fn ratio() -> Result<String, String> {
    // The planet of radius 2^20 fills the ball of 2^28 steps, so the smallest radius, 64 steps, is a
    // quarter.
    let (planet, beside) = (f64::from(1 << 20), [1.0, 2.0, 3.0]);
    let tiny = Some(("sphere", Some(1), ErrorKind::Tiny));
    let radii = [(0.25, None), (0.248, tiny)];
    let radius = held("radius beside one of 2^20", &radii, |radius| {
        built(|scene, id| {
            scene.add_sphere(ORIGIN, planet, id)?;
            scene.add_sphere(beside, radius, id).map(drop)
        })
    })?;
    let tiny = Some(("cylinder", Some(0), ErrorKind::Tiny));
    let heights = [(0.5, None), (0.496, tiny)];
    let height = held("height beside it", &heights, |height| {
        built(|scene, id| {
            scene.add_sphere(ORIGIN, planet, id)?;
            scene.add_cylinder(beside, UP, 1.0, height, id).map(drop)
        })
    })?;
    Ok(format!("{radius}. {height}"))
}

fn extent() -> Result<String, String> {
    let least = 2f64.powi(-30);
    let beyond = Some(("scene", None, ErrorKind::Extent));
    let limits = [(least, None), (MOST, None), (0.99 * least, beyond)];
    held("radius of a lonely sphere", &limits, |radius| {
        built(|scene, id| {
            scene.add_sphere(ORIGIN, radius, id)?;
            scene.set_epsilon(radius * 1e-3)
        })
    })
}

fn epsilon() -> Result<String, String> {
    let beyond = Some(("scene", None, ErrorKind::Epsilon));
    let limits = [
        (1e-19, None),
        (0.999, None),
        (0.0, beyond),
        (-1.0, beyond),
        (1.0, beyond),
        (1e12, beyond),
    ];
    held("epsilon beside a radius of 1", &limits, |epsilon| {
        built(|scene, id| {
            scene.add_sphere(ORIGIN, 1.0, id)?;
            scene.set_epsilon(epsilon)
        })
    })
}

fn coefficients() -> Result<String, String> {
    let fields = [
        ("color", 16.0, ErrorKind::Color),
        ("ambient", 16.0, ErrorKind::Ambient),
        ("diffuse", 16.0, ErrorKind::Diffuse),
        ("specular", 16.0, ErrorKind::Specular),
        ("shininess", f64::from(1 << 20), ErrorKind::Shininess),
        ("mirror", 1.0, ErrorKind::Mirror),
    ];
    let mut words = Vec::new();
    for (place, (name, most, kind)) in fields.into_iter().enumerate() {
        let beyond = Some(("material", None, kind));
        let above = 1.000_001 * most;
        let limits = [(0.0, None), (most, None), (-1e-6, beyond), (above, beyond)];
        words.push(held(name, &limits, |number| {
            let mut numbers = [0.5, 0.2, 0.8, 0.1, 4.0, 0.3];
            numbers[place] = number;
            let [color, ambient, diffuse, specular, shininess, mirror] = numbers;
            let highlight = (specular, shininess);
            Material::from_numbers([color; 3], ambient, diffuse, highlight, mirror).map(|_| ())
        })?);
    }
    Ok(words.join(". "))
}

fn lights() -> Result<String, String> {
    let limits = |beyond: Refusal| {
        let beyond = Some(beyond);
        [
            (0.0, None),
            (16.0, None),
            (-1e-6, beyond),
            (16.000_001, beyond),
        ]
    };
    let light = limits(("light", Some(0), ErrorKind::Color));
    let colors = held("light color", &light, |color| {
        Room::new().add_light([1.0; 3], [color; 3])
    })?;
    let background = limits(("scene", None, ErrorKind::Background));
    let behind = held("background", &background, |color| {
        Room::new().set_background([color; 3])
    })?;
    Ok(format!("{colors}. {behind}"))
}

fn brightness() -> Result<String, String> {
    let ambient = "ambient beside diffuse 14 under a light of 1";
    held(ambient, &[(15.9, None), (16.0, None)], |ambient| {
        lit(ambient, 14.0)
    })?;
    let beyond = Some(("material", Some(0), ErrorKind::Brightness));
    let diffuse = "diffuse beside ambient 16 under a light of 1";
    held(diffuse, &[(14.0, None), (14.1, beyond)], |diffuse| {
        lit(16.0, diffuse)
    })
}

fn lit(ambient: f64, diffuse: f64) -> Result<(), Error> {
    let mut scene = Room::new();
    let material = Material::from_numbers([1.0; 3], ambient, diffuse, (0.0, 1.0), 0.0);
    let id = scene.add_material(material?)?;
    scene.add_sphere([0.0; 3], 1.0, id)?;
    scene.add_light([3.0; 3], [1.0; 3])?;
    scene.build().map(|_| ())
}

fn field_of_view() -> Result<String, String> {
    let beyond = Some(("camera", None, ErrorKind::FieldOfView));
    let limits = [
        (0.001, None),
        (179.999, None),
        (0.000_999, beyond),
        (179.9991, beyond),
        (180.0, beyond),
    ];
    held("fov", &limits, |fov| {
        camera([0.0, -5.0, 0.0], ORIGIN, UP, fov)
    })
}

fn directions() -> Result<String, String> {
    let refused = |part, kind| {
        let beyond = Some((part, Some(0), kind));
        [(SHORTEST, None), (-MOST, None), (0.0, beyond)]
    };
    let normal = refused("plane", ErrorKind::Normal);
    let normal = held("length of a normal", &normal, |z| {
        plane(ORIGIN, [0.0, 0.0, z])
    })?;
    let axis = refused("cylinder", ErrorKind::Axis);
    let axis = held("of an axis", &axis, |x| {
        cylinder(ORIGIN, [x, 0.0, 0.0], 1.0, 1.0)
    })?;
    let beyond = Some(("camera", None, ErrorKind::View));
    let view = [(SHORTEST, None), (-MOST, None), (0.0, beyond)];
    let view = held("from a camera to its target", &view, |y| {
        camera(ORIGIN, [0.0, y, 0.0], UP, 50.0)
    })?;
    Ok([normal, axis, view].join(". "))
}

fn room_for() -> Result<String, String> {
    let fill = |what, most: f64, beyond, add: fn(&mut Room, MaterialId) -> Added| {
        held(what, &[(most, None), (most + 1.0, Some(beyond))], |count| {
            let fill = |room: &mut Room, id| (0..count as u32).try_for_each(|_| add(room, id));
            alone(fill).map(|_| ())
        })
    };
    let spheres = ("sphere", Some(2), ErrorKind::TooManySpheres);
    let planes = ("plane", Some(1), ErrorKind::TooManyPlanes);
    let cylinders = ("cylinder", Some(1), ErrorKind::TooManyCylinders);
    let lights = ("light", Some(1), ErrorKind::TooManyLights);
    let words = [
        fill("spheres", 2.0, spheres, |room, id| {
            room.add_sphere(ORIGIN, 1.0, id).map(drop)
        })?,
        fill("planes", 1.0, planes, |room, id| {
            room.add_plane(ORIGIN, UP, id)
        })?,
        fill("cylinders", 1.0, cylinders, |room, id| {
            room.add_cylinder(ORIGIN, UP, 1.0, 1.0, id).map(drop)
        })?,
        fill("lights", 1.0, lights, |room, _| {
            room.add_light(ORIGIN, [1.0; 3]).map(drop)
        })?,
    ];
    let expected = ("sphere", Some(0), ErrorKind::UnknownMaterial);
    let unknown = alone(|_, id| Room::new().add_sphere(ORIGIN, 1.0, id).map(drop)).err();
    let Some(unknown) = unknown.filter(|error| refusal(*error) == expected) else {
        return Err(format!("a material of another scene: {unknown:?}"));
    };
    let words = words.join(". ");
    Ok(format!(
        "{words}. A material that is not there: \"{unknown}\""
    ))
}

fn up() -> Result<String, String> {
    let beyond = Some(("camera", None, ErrorKind::Up));
    let limits = [(1.0, None), (1e-6, None), (1e-9, beyond), (0.0, beyond)];
    held("sine between view and up", &limits, |sine| {
        camera(ORIGIN, UP, [0.0, sine, 1.0], 50.0)
    })
}

/// Returns the cases of the chapter "Range".
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

/// Returns a sphere with a light and a camera at distances of about its radius. For the largest
/// sphere, the eye is at the largest coordinate.
fn lonely(radius: f64) -> Draft {
    let at = |at: [f64; 3]| at.map(|it| it * radius);
    Draft::seen_from(at([1.0, -1.0, 0.5]), [0.0; 3])
        .light(at([1.0, -0.5, 1.0]))
        .sphere([0.0; 3], radius, "gold")
        .epsilon(1e-3 * radius)
}

/// Returns a scene with a background and a material of 16, under the brightest light that the
/// material "white" allows.
fn glaring() -> Draft {
    Draft::seen_from([0.5, -4.0, 1.5], [0.0, 0.0, 0.5])
        .material("dim", [0.1, 0.05, 0.08], [16.0, 0.8, 0.0, 1.0, 0.0])
        .shining([3.0, -5.0, 4.0], [14.0; 3])
        .sphere([0.0, 0.0, 0.6], 0.6, "dim")
        .before([16.0, 0.0, 0.5])
}
