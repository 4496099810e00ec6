//! Random scenes and cameras, made from arbitrary bytes, and their pictures. The fuzzer and the long
//! runs draw them.
//!
//! Numbers have every size that a description allows. Often they are difficult ones: zero, one, a
//! power of two, or the number before, so that shapes touch, coincide or contain each other. The
//! library may refuse a scene. A scene that it accepts must be drawn without a panic or an overflow,
//! with no more rays than a frame may follow, and without a cut-off if nothing mirrors.
#![deny(missing_docs)]

mod draw;
mod number;

use arbitrary::Unstructured;
use embedded_graphics::geometry::Size;
use number::Numbers;
use reflet::{Camera, Error, Material, MaterialId, RuntimeScene, room};

pub use draw::Drawn;

/// A scene with enough room for what a few hundred bytes describe.
pub type Scenery = RuntimeScene<
    room!(spheres: 6, planes: 4, cylinders: 4, discs: 4, triangles: 4, lights: 4, materials: 4),
>;

/// A described scene, and how to draw it.
#[derive(Clone, Debug)]
pub struct Wild {
    /// The description of the scene.
    pub scene: Scenery,
    /// Camera of a random scene.
    pub camera: Camera,
    /// Largest number of reflections, 0 to 255.
    pub reflections: u8,
    /// Size of the picture: a few pixels.
    pub size: Size,
    /// Number that selects shading and quality.
    pub kind: u8,
    /// Whether any material mirrors.
    pub mirrors: bool,
}

/// Why no scene is made: there are too few bytes, or the library refuses a part.
struct Refused;

impl From<arbitrary::Error> for Refused {
    fn from(_: arbitrary::Error) -> Self {
        Self
    }
}

impl From<Error> for Refused {
    fn from(_: Error) -> Self {
        Self
    }
}

type Result<T> = core::result::Result<T, Refused>;

impl Wild {
    /// Makes a scene from bytes. `None` if the library refuses one of its parts, or if there are too
    /// few bytes.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        Self::described(&mut Unstructured::new(bytes), false).ok()
    }

    /// Makes a scene from bytes whose lights fall off. It is another one than [`Wild::read`] makes of them.
    pub fn read_with_ranges(bytes: &[u8]) -> Option<Self> {
        Self::described(&mut Unstructured::new(bytes), true).ok()
    }

    fn described(bytes: &mut Unstructured, has_ranges: bool) -> Result<Self> {
        let kind = bytes.arbitrary()?;
        let reflections = match bytes.int_in_range(0..=3)? {
            0 => bytes.arbitrary()?,
            _ => bytes.int_in_range(0..=8)?,
        };
        let size = Size::new(bytes.int_in_range(1..=12)?, bytes.int_in_range(1..=6)?);
        let mut numbers = Numbers::read(bytes, has_ranges)?;
        let camera = Camera::new(
            numbers.place(bytes)?,
            numbers.place(bytes)?,
            numbers.way(bytes)?,
            number::field_of_view(bytes)?,
        )?;
        let is_the_scenes_own = bytes.arbitrary()?;
        let (mut scene, mirrors) = filled(bytes, &mut numbers)?;
        if is_the_scenes_own {
            scene.set_camera(camera);
        }
        Ok(Self {
            scene,
            camera,
            reflections,
            size,
            kind,
            mirrors,
        })
    }
}

/// Fills a scene from bytes, and tells whether a material mirrors.
fn filled(bytes: &mut Unstructured, numbers: &mut Numbers) -> Result<(Scenery, bool)> {
    let (mut scene, mut mirrors) = (Scenery::new(), false);
    let mut ids = Vec::new();
    for _ in 0..bytes.int_in_range(1..=3)? {
        if let Some(material) = material(bytes, numbers.unit, &mut mirrors)? {
            ids.push(scene.add_material(material)?);
        }
    }
    if !ids.is_empty() {
        add_all(bytes, numbers, &mut scene, &ids)?;
        add_discs(bytes, numbers, &mut scene, &ids)?;
        add_triangles(bytes, numbers, &mut scene, &ids)?;
    }
    Ok((scene, mirrors))
}

/// Adds triangles, after the discs.
fn add_triangles(
    bytes: &mut Unstructured,
    numbers: &mut Numbers,
    scene: &mut Scenery,
    ids: &[MaterialId],
) -> Result<()> {
    for _ in 0..bytes.int_in_range(0..=4)? {
        let mut corner = || numbers.place(bytes);
        let corners = [corner()?, corner()?, corner()?];
        let mut way = || numbers.way(bytes);
        let normals = [way()?, way()?, way()?];
        let id = *bytes.choose(ids)?;
        match bytes.arbitrary()? {
            true => scene.add_triangle(corners, normals, id)?,
            false => scene.add_triangle(corners, None, id)?,
        };
    }
    Ok(())
}

/// Adds discs. They are read after all other parts, so that the bytes of older inputs still make the
/// same other parts.
fn add_discs(
    bytes: &mut Unstructured,
    numbers: &mut Numbers,
    scene: &mut Scenery,
    ids: &[MaterialId],
) -> Result<()> {
    for _ in 0..bytes.int_in_range(0..=4)? {
        let (center, normal) = (numbers.place(bytes)?, numbers.way(bytes)?);
        let (radius, id) = (numbers.size(bytes)?, *bytes.choose(ids)?);
        scene.add_disc(center, normal, radius, id)?;
    }
    Ok(())
}

fn add_all(
    bytes: &mut Unstructured,
    numbers: &mut Numbers,
    scene: &mut Scenery,
    ids: &[MaterialId],
) -> Result<()> {
    let count = |bytes: &mut Unstructured, most: usize| bytes.int_in_range(0..=most);
    for _ in 0..count(bytes, 6)? {
        let (center, radius) = (numbers.place(bytes)?, numbers.size(bytes)?);
        scene.add_sphere(center, radius, *bytes.choose(ids)?)?;
    }
    for _ in 0..count(bytes, 4)? {
        let (point, normal) = (numbers.place(bytes)?, numbers.way(bytes)?);
        scene.add_plane(point, normal, *bytes.choose(ids)?)?;
    }
    for _ in 0..count(bytes, 4)? {
        let (center, axis) = (numbers.place(bytes)?, numbers.way(bytes)?);
        let (radius, height) = (numbers.size(bytes)?, numbers.size(bytes)?);
        scene.add_cylinder(center, axis, radius, height, *bytes.choose(ids)?)?;
    }
    for _ in 0..count(bytes, 4)? {
        let color = number::brightness(bytes)? * 2.0;
        let place = numbers.place(bytes)?;
        match numbers.has_ranges {
            true => scene.add_light_with_range(place, [color; 3], numbers.size(bytes)?)?,
            false => scene.add_light(place, [color; 3])?,
        };
    }
    scene.set_background([number::brightness(bytes)?; 3])?;
    match bytes.arbitrary()? {
        true => scene.set_epsilon(numbers.size(bytes)?)?,
        false => scene.set_epsilon(1e-4 * numbers.unit)?,
    }
    // Last, so that a stored input stays the same scene: where the bytes have ended, there is no sky.
    if bytes.ratio(3, 4)? {
        return Ok(());
    }
    let mut color = || -> Result<[f64; 3]> {
        Ok([number::brightness(bytes)?, number::brightness(bytes)?, 1.0])
    };
    let (colors, sun) = ([color()?, color()?, color()?], color()?);
    scene.set_sky(numbers.way(bytes)?, colors)?;
    // Under a sky there may be a sun with a disc. If there are lights enough, it is refused.
    if bytes.ratio(1, 2)? {
        let degrees = 90.0 * number::share(bytes)?;
        let _ = scene.add_sun(numbers.way(bytes)?, sun, degrees);
    }
    Ok(())
}

fn material(bytes: &mut Unstructured, unit: f64, mirrors: &mut bool) -> Result<Option<Material>> {
    let mut part = || number::brightness(bytes);
    let color = [part()?, part()?, part()?];
    let (ambient, diffuse, specular) = (part()?, part()?, part()?);
    let mirror = number::share(bytes)?;
    let shininess = number::shininess(bytes)?;
    *mirrors |= mirror > 0.0;
    let made = Material::from_numbers(color, ambient, diffuse, (specular, shininess), mirror);
    // What is bluer than red has a checker. No more bytes are read, so a stored input keeps its shapes.
    let [red, green, blue] = color;
    Ok(match made {
        Ok(made) if red < blue => {
            let size = unit * (0.05 + green);
            let up = if diffuse < specular { size } else { 0.0 };
            made.with_checker([blue, green, red], [size, size, up]).ok()
        }
        made => made.ok(),
    })
}
