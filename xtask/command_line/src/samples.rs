//! Four samples for each pixel, which smooth edges are compared with.

use reflet::host::reference::Picture;

/// Number of columns, and of rows, that the fine picture has for each pixel.
const FINE: u32 = 8;

/// Where the samples lie in a pixel of the fine picture: a rotated grid.
const PLACES: [[u32; 2]; 4] = [[1, 5], [3, 1], [5, 7], [7, 3]];

/// Returns the picture in which each pixel is the mean of four samples on a rotated grid. They are taken from a picture
/// of eight times the width and eight times the height.
pub fn four_samples(fine: &Picture) -> Picture {
    let [width, height] = [fine.width, fine.height].map(|side| side / FINE);
    let pixel = |index: u32| {
        let (x, y) = (FINE * (index % width), FINE * (index / width));
        let samples = PLACES.map(|[right, down]| {
            fine.pixels[((y + down) * fine.width + x + right) as usize].map(u32::from)
        });
        [0, 1, 2].map(|part| {
            let sum: u32 = samples.iter().map(|sample| sample[part]).sum();
            ((sum + 2) / 4) as u8
        })
    };
    Picture {
        width,
        height,
        pixels: (0..width * height).map(pixel).collect(),
    }
}
