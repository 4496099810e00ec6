//! A scene read from lines of text, with `core` alone: no allocation and no float.

use core::fmt;

use heapless::Vec;
use reflet::{Error, Material, MaterialId, Number, RuntimeScene, Scene, room};

/// Room for the scenes that may arrive.
type Room = room!(spheres: 4, planes: 2, lights: 2, materials: 4);
/// The scene on the display.
pub type Shown = Scene<Room>;

/// Why a scene is refused.
#[derive(Clone, Copy, Debug)]
pub enum Wrong {
    /// The line has another form, or the scene has no end.
    Form,
    /// A part, or the whole scene, is wrong.
    Part(Error),
}

impl From<Error> for Wrong {
    fn from(error: Error) -> Self {
        Self::Part(error)
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form => formatter.write_str(
                "expected material, sphere, plane or light with 8, 5, 7 or 6 numbers, then end",
            ),
            Self::Part(error) => error.fmt(formatter),
        }
    }
}

/// Reads a scene up to the line `end`. The error has the number of the wrong line, counted from 1.
pub fn read<'a>(lines: impl Iterator<Item = &'a str>) -> Result<Shown, (u32, Wrong)> {
    let (mut scene, mut ids, mut wrong) = (RuntimeScene::new(), Vec::new(), None);
    for (number, line) in (1..).zip(lines) {
        match (line.trim(), wrong) {
            ("end", Some(wrong)) => return Err(wrong),
            ("end", None) => return scene.build().map_err(|it| (number, it.into())),
            (_, Some(_)) => {} // Skip the rest of a wrong scene.
            (line, None) => wrong = add(&mut scene, &mut ids, line).err().map(|it| (number, it)),
        }
    }
    Err(wrong.unwrap_or((0, Wrong::Form)))
}

/// Adds the part that a line describes.
fn add(to: &mut RuntimeScene<Room>, ids: &mut Vec<MaterialId, 4>, line: &str) -> Result<(), Wrong> {
    let mut words = line.split_ascii_whitespace();
    let (kind, mut numbers) = (words.next(), Vec::<Number, 8>::new());
    for word in words {
        numbers.push(word.parse()?).map_err(|_| Wrong::Form)?;
    }
    // Materials have numbers from 0 on, in the order in which they arrive.
    let id = |material| {
        let mut numbered = (0..).map(Number::from).zip(&*ids);
        let found = numbered.find(|(number, _)| *number == material);
        found.map(|(_, id)| *id).ok_or(Wrong::Form)
    };
    match (kind, &*numbers) {
        (Some("material"), &[r, g, b, ambient, diffuse, specular, shininess, mirror]) => {
            let highlight = (specular, shininess);
            let made = Material::from_numbers([r, g, b], ambient, diffuse, highlight, mirror)?;
            ids.push(to.add_material(made)?).map_err(|_| Wrong::Form)
        }
        (Some("sphere"), &[x, y, z, radius, of]) => {
            Ok(to.add_sphere([x, y, z], radius, id(of)?).map(drop)?)
        }
        (Some("plane"), &[x, y, z, a, b, c, of]) => {
            Ok(to.add_plane([x, y, z], [a, b, c], id(of)?)?)
        }
        (Some("light"), &[x, y, z, r, g, b]) => Ok(to.add_light([x, y, z], [r, g, b]).map(drop)?),
        _ => Err(Wrong::Form),
    }
}
