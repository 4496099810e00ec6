//! Scenes as JSON scene files and pictures as PNG files, as bytes. Never opens a file.

use command_line::scene_file;
use image::{ImageFormat, RgbImage};

use crate::case::{Case, Lost};

/// Colour of lost pixels in pictures.
const MAGENTA: [u8; 3] = [255, 0, 255];

/// Returns the text of a scene file. Materials are named by their numbers. Files do not hold the
/// number of reflections.
pub fn json(case: &Case) -> String {
    let materials = 0..case.scene.materials.len();
    let materials: Vec<_> = materials.map(|index| index.to_string()).collect();
    scene_file::text(&case.name, &materials, &case.scene, &case.camera)
}

/// Returns the bytes of a PNG file with the picture of a quality. Lost pixels are magenta.
///
/// # Errors
///
/// The picture cannot be encoded.
pub fn png(lost: &Lost) -> image::ImageResult<Vec<u8>> {
    let mut picture = RgbImage::new(lost.picture.width, lost.picture.height);
    let pixels = lost.picture.pixels.iter().zip(&lost.is_lost);
    for (target, (pixel, is_lost)) in picture.pixels_mut().zip(pixels) {
        target.0 = if *is_lost { MAGENTA } else { *pixel };
    }
    let mut bytes = Vec::new();
    picture.write_to(&mut std::io::Cursor::new(&mut bytes), ImageFormat::Png)?;
    Ok(bytes)
}
