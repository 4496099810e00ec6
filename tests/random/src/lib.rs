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

use std::error::Error;

use arbitrary::Unstructured;
use embedded_graphics::geometry::Size;
use number::{Numbers, three};
use reflet::{Camera, Material, MaterialId, RuntimeScene, room};

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

/// An error says that there are too few bytes, or that the library refuses a part.
type Result<T> = std::result::Result<T, Box<dyn Error>>;

impl Wild {
    /// Makes a scene from bytes. `None` if the library refuses one of its parts, or if there are too
    /// few bytes.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        Self::described(Unstructured::new(bytes), false).ok()
    }

    /// Makes a scene from bytes whose lights fall off. It is another one than [`Wild::read`] makes of them.
    pub fn read_with_ranges(bytes: &[u8]) -> Option<Self> {
        Self::described(Unstructured::new(bytes), true).ok()
    }

    fn described(mut bytes: Unstructured, has_ranges: bool) -> Result<Self> {
        let kind = bytes.arbitrary()?;
        let reflections = match bytes.int_in_range(0..=3)? {
            0 => bytes.arbitrary()?,
            _ => bytes.int_in_range(0..=8)?,
        };
        let size = Size::new(bytes.int_in_range(1..=12)?, bytes.int_in_range(1..=6)?);
        let mut numbers = Numbers::read(bytes)?;
        let (position, target) = (numbers.place()?, numbers.place()?);
        let (up, fov) = (numbers.way()?, numbers.field_of_view()?);
        let camera = Camera::new(position, target, up, fov)?;
        let is_the_scenes_own = numbers.bytes.arbitrary()?;
        let (mut scene, mirrors) = filled(&mut numbers, has_ranges)?;
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

/// Fills a scene, and tells whether a material mirrors.
fn filled(numbers: &mut Numbers, has_ranges: bool) -> Result<(Scenery, bool)> {
    let (mut scene, mut mirrors) = (Scenery::new(), false);
    let mut ids = Vec::new();
    for _ in 0..numbers.bytes.int_in_range(1..=3)? {
        if let Some(material) = material(numbers, &mut mirrors)? {
            ids.push(scene.add_material(material)?);
        }
    }
    if !ids.is_empty() {
        add_shapes(numbers, &mut scene, &ids)?;
        add_light(numbers, &mut scene, has_ranges)?;
        add_discs(numbers, &mut scene, &ids)?;
        add_triangles(numbers, &mut scene, &ids)?;
    }
    Ok((scene, mirrors))
}

fn add_shapes(numbers: &mut Numbers, scene: &mut Scenery, ids: &[MaterialId]) -> Result<()> {
    for _ in 0..numbers.count(6)? {
        let (center, radius) = (numbers.place()?, numbers.size()?);
        scene.add_sphere(center, radius, *numbers.bytes.choose(ids)?)?;
    }
    for _ in 0..numbers.count(4)? {
        let (point, normal) = (numbers.place()?, numbers.way()?);
        scene.add_plane(point, normal, *numbers.bytes.choose(ids)?)?;
    }
    for _ in 0..numbers.count(4)? {
        let (center, axis) = (numbers.place()?, numbers.way()?);
        let (radius, height) = (numbers.size()?, numbers.size()?);
        scene.add_cylinder(center, axis, radius, height, *numbers.bytes.choose(ids)?)?;
    }
    Ok(())
}

/// Adds lights, a background, the epsilon and a sky.
fn add_light(numbers: &mut Numbers, scene: &mut Scenery, has_ranges: bool) -> Result<()> {
    for _ in 0..numbers.count(4)? {
        let color = [numbers.brightness()? * 2.0; 3];
        let place = numbers.place()?;
        if has_ranges {
            scene.add_light_with_range(place, color, numbers.size()?)?
        } else {
            scene.add_light(place, color)?
        };
    }
    scene.set_background([numbers.brightness()?; 3])?;
    if numbers.bytes.arbitrary()? {
        scene.set_epsilon(numbers.size()?)?
    } else {
        scene.set_epsilon(1e-4 * numbers.unit)?
    }
    // Last, so that a stored input stays the same scene: where the bytes have ended, there is no sky.
    if numbers.bytes.ratio(3, 4)? {
        return Ok(());
    }
    let mut color = || Ok([numbers.brightness()?, numbers.brightness()?, 1.0]);
    let (colors, sun) = (three(&mut color)?, color()?);
    scene.set_sky(numbers.way()?, colors)?;
    // Half of the skies get a sun with a disc. The sun is refused if the scene's list of lights is full.
    if numbers.bytes.ratio(1, 2)? {
        let degrees = 90.0 * numbers.share()?;
        let _ = scene.add_sun(numbers.way()?, sun, degrees);
    }
    Ok(())
}

/// Adds discs. They are read after all other parts, so that the bytes of older inputs still make the
/// same other parts.
fn add_discs(numbers: &mut Numbers, scene: &mut Scenery, ids: &[MaterialId]) -> Result<()> {
    for _ in 0..numbers.count(4)? {
        let (center, normal) = (numbers.place()?, numbers.way()?);
        let (radius, id) = (numbers.size()?, *numbers.bytes.choose(ids)?);
        scene.add_disc(center, normal, radius, id)?;
    }
    Ok(())
}

/// Adds triangles, after the discs.
fn add_triangles(numbers: &mut Numbers, scene: &mut Scenery, ids: &[MaterialId]) -> Result<()> {
    for _ in 0..numbers.count(4)? {
        let corners = three(|| numbers.place())?;
        let normals = three(|| numbers.way())?;
        let id = *numbers.bytes.choose(ids)?;
        if numbers.bytes.arbitrary()? {
            scene.add_triangle(corners, normals, id)?
        } else {
            scene.add_triangle(corners, None, id)?
        };
    }
    Ok(())
}

fn material(numbers: &mut Numbers, mirrors: &mut bool) -> Result<Option<Material>> {
    let color = three(|| numbers.brightness())?;
    let [ambient, diffuse, specular] = three(|| numbers.brightness())?;
    let (mirror, shininess) = (numbers.share()?, numbers.shininess()?);
    *mirrors |= mirror > 0.0;
    let made = Material::from_numbers(color, ambient, diffuse, (specular, shininess), mirror);
    // What is bluer than red has a checker. No more bytes are read, so a stored input keeps its shapes.
    let [red, green, blue] = color;
    Ok(match made {
        Ok(made) if red < blue => {
            let size = numbers.unit * (0.05 + green);
            let up = if diffuse < specular { size } else { 0.0 };
            made.with_checker([blue, green, red], [size, size, up]).ok()
        }
        made => made.ok(),
    })
}
