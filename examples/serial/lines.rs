//! A scene read from lines of text, with `core` alone: no allocation and no float.

use heapless::Vec;
use reflet::{Fault, Material, MaterialId, Number, RuntimeScene, Scene};

/// Room for spheres, planes, cylinders, lights and materials.
type Incoming = RuntimeScene<4, 2, 0, 2, 4>;
pub type Shown = Scene<4, 2, 0, 2, 4>;

/// Reads a scene up to the line `end`, or says which line is wrong, from 1, and why.
pub fn read<'a>(lines: impl Iterator<Item = &'a str>) -> Result<Shown, (u32, &'static str)> {
    let (mut scene, mut ids, mut wrong) = (Incoming::new(), Vec::new(), None);
    for (number, line) in (1..).zip(lines) {
        match (line.trim(), wrong) {
            ("end", Some(wrong)) => return Err(wrong),
            ("end", None) => return scene.build().map_err(|it| (number, it.fault().words())),
            (_, Some(_)) => {} // What follows a wrong line is not the next scene.
            (line, None) => wrong = add(&mut scene, &mut ids, line).err().map(|it| (number, it)),
        }
    }
    Err((0, "there is no end"))
}

fn add(to: &mut Incoming, ids: &mut Vec<MaterialId, 4>, line: &str) -> Result<(), &'static str> {
    const FORM: &str = "line must be material, sphere, plane or light with 8, 5, 7 or 6 numbers";
    let mut words = line.split_ascii_whitespace();
    let (kind, mut numbers) = (words.next(), Vec::<Number, 8>::new());
    for word in words {
        let number = word.parse().map_err(Fault::words)?;
        numbers.push(number).map_err(|_| FORM)?;
    }
    // Materials are numbered from 0 as they come.
    let id = |material| {
        let mut numbered = (0..).map(Number::from).zip(&*ids);
        let found = numbered.find(|(number, _)| *number == material);
        found.map_or(Err(Fault::UnknownMaterial.words()), |(_, id)| Ok(*id))
    };
    let added = match (kind, &*numbers) {
        (Some("material"), &[r, g, b, ambient, diffuse, specular, shininess, mirror]) => {
            let highlight = (specular, shininess);
            let made = Material::from_numbers([r, g, b], ambient, diffuse, highlight, mirror);
            let added = to.add_material(made.map_err(Fault::words)?);
            // There is room for as many as in the scene.
            added.map(|id| ids.push(id).unwrap_or_default())
        }
        (Some("sphere"), &[x, y, z, radius, of]) => to.add_sphere([x, y, z], radius, id(of)?),
        (Some("plane"), &[x, y, z, a, b, c, of]) => to.add_plane([x, y, z], [a, b, c], id(of)?),
        (Some("light"), &[x, y, z, r, g, b]) => to.add_light([x, y, z], [r, g, b]),
        _ => return Err(FORM),
    };
    added.map_err(|it| it.fault().words())
}
