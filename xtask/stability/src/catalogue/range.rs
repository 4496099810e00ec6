//! Cases of range: the smallest and largest scenes, and the errors beyond them. The limits of single
//! numbers are in `tests/bad_scenes`.

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

fn cylinder(axis: Triple, radius: f64, height: f64) -> Result<Room, Error> {
    alone(|scene, id| {
        let added = scene.add_cylinder(ORIGIN, axis, radius, height, id);
        added.map(drop)
    })
}

/// Checks the shortest sizes and directions of each kind of part.
fn shortest() -> Result<String, String> {
    let sized = |part, kind| [(SHORTEST, None), (0.0, Some((part, Some(0), kind)))];
    let found = [
        held(
            "sphere radius",
            &sized("sphere", ErrorKind::Radius),
            |radius| alone(|scene, id| scene.add_sphere(ORIGIN, radius, id).map(drop)),
        )?,
        held(
            "cylinder radius",
            &sized("cylinder", ErrorKind::Radius),
            |radius| cylinder(UP, radius, 1.0),
        )?,
        held(
            "cylinder height",
            &sized("cylinder", ErrorKind::Height),
            |height| cylinder(UP, 1.0, height),
        )?,
        held("plane normal", &sized("plane", ErrorKind::Normal), |z| {
            alone(|scene, id| scene.add_plane(ORIGIN, [0.0, 0.0, z], id))
        })?,
        held("cylinder axis", &sized("cylinder", ErrorKind::Axis), |x| {
            cylinder([x, 0.0, 0.0], 1.0, 1.0)
        })?,
    ];
    let blind = Some(("camera", None, ErrorKind::View));
    let view = held("view", &[(SHORTEST, None), (0.0, blind)], |y| {
        Camera::new(ORIGIN, [0.0, y, 0.0], UP, 50)
    })?;
    Ok([&found[..], &[view]].concat().join(". "))
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

fn lit(ambient: f64, diffuse: f64) -> Added {
    let material = Material::from_numbers([1.0; 3], ambient, diffuse, (0.0, 1.0), 0.0)?;
    let mut scene = Room::new();
    let id = scene.add_material(material)?;
    scene.add_sphere(ORIGIN, 1.0, id)?;
    scene.add_light([3.0; 3], [1.0; 3])?;
    scene.build().map(drop)
}

fn up() -> Result<String, String> {
    let beyond = Some(("camera", None, ErrorKind::Up));
    let limits = [(1.0, None), (1e-6, None), (1e-9, beyond), (0.0, beyond)];
    held("sine between view and up", &limits, |sine| {
        Camera::new(ORIGIN, UP, [0.0, sine, 1.0], 50)
    })
}

/// Returns the cases of the chapter "Range".
pub fn cases() -> Vec<Case> {
    let edge = "the last number that is taken must be drawn truly, and the next be refused by name";
    vec![
        claim("shortest sizes and directions", edge, shortest),
        claim("sizes beside the scene's extent", edge, ratio),
        claim("extent of a scene", edge, extent),
        claim("epsilon", edge, epsilon),
        claim("brightness", edge, brightness),
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
