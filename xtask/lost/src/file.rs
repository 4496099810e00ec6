//! Scenes as JSON scene files and pictures as PNG files, as bytes. Never opens a file.

use image::{ImageFormat, RgbImage};
use reflet::host::reference::Scene;
use serde_json::{Value, json};

use crate::case::{Case, Judged, Lost};

/// Colour of lost pixels in pictures.
const MAGENTA: [u8; 3] = [255, 0, 255];

macro_rules! lists {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $($more:tt)*
    })*) => {
        /// Writes the lists of shapes. The point of a plane is called its center.
        fn write_shapes(target: &mut Value, scene: &Scene) {
            $(
                let shapes = scene.$list.iter().map(|it| {
                    let mut shape = json!({"material": it.material.to_string()});
                    $(shape[key(stringify!($field))] = json!(it.$field);)*
                    shape
                });
                target[stringify!($list)] = shapes.collect();
            )*
        }
    };
}
kinds!(shapes, lists);

fn key(field: &str) -> &str {
    match field {
        "point" => "center",
        other => other,
    }
}

/// Returns the text of a scene file. Materials are named by their numbers. Files do not hold the
/// number of reflections.
pub fn json(case: &Case) -> String {
    let (scene, camera) = (&case.scene, &case.camera);
    let mut file = json!({
        "name": case.name,
        "camera": {
            "position": camera.position, "target": camera.target, "up": camera.up, "fov": camera.fov,
        },
        "background": scene.background,
        "epsilon": scene.epsilon,
    });
    if let Some(it) = &scene.sky {
        file["sky"] = json!({
            "up": it.up, "below": it.below, "horizon": it.horizon, "above": it.above,
        });
        file.as_object_mut().map(|file| file.remove("background"));
    }
    let materials = scene.materials.iter().enumerate().map(|(index, it)| {
        let checker = it.checker.as_ref();
        json!({
            "name": index.to_string(), "color": it.color, "ambient": it.ambient,
            "diffuse": it.diffuse, "specular": it.specular, "shininess": it.shininess,
            "mirror": it.mirror,
            "checker": checker.map(|it| json!({ "color": it.color, "size": it.size })),
        })
    });
    file["materials"] = materials.collect();
    let lights = scene.lights.iter();
    file["lights"] = lights
        .map(|it| json!({"position": it.position, "color": it.color}))
        .collect();
    write_shapes(&mut file, scene);
    format!("{file:#}\n")
}

/// Returns the bytes of a PNG file with the picture of a quality. Lost pixels are magenta.
///
/// # Errors
///
/// The picture cannot be encoded.
pub fn png(judged: &Judged, lost: &Lost) -> image::ImageResult<Vec<u8>> {
    let mut picture = RgbImage::new(judged.size.width, judged.size.height);
    let pixels = lost.pixels.iter().zip(&lost.causes);
    for (target, (pixel, cause)) in picture.pixels_mut().zip(pixels) {
        target.0 = cause.map_or(*pixel, |_| MAGENTA);
    }
    let mut bytes = Vec::new();
    picture.write_to(&mut std::io::Cursor::new(&mut bytes), ImageFormat::Png)?;
    Ok(bytes)
}
