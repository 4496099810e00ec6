//! Smooth edges in random scenes, against four samples at every pixel.

use clap::ValueEnum;
use command_line::{Quality, Settings, Shading};
use embedded_graphics::geometry::Size;
use lost::families::{Family, scene_of_run};
use reflet::host::compare::compare;
use reflet::host::reference::{self, Picture, render, sampled};

const SEED: u64 = 1;
const SIZE: [u32; 2] = [160, 120];
const SCENES: usize = 20;

/// Returns the picture of four samples a pixel, on a rotated grid, from one with 8 x 8 pixels for each.
fn four_of(fine: &Picture) -> Picture {
    const PLACES: [[u32; 2]; 4] = [[1, 5], [3, 1], [5, 7], [7, 3]];
    let [width, height] = SIZE;
    let pixel = |index: u32| {
        let (x, y) = (8 * (index % width), 8 * (index / width));
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

/// Prints the PSNR of each scene.
#[test]
#[ignore = "takes twenty seconds"]
fn two_rows_are_about_as_good_as_four_samples() {
    let shading = reference::Shading::BlinnPhong;
    let [width, height] = SIZE;
    for index in 0..SCENES {
        let (_, case) = scene_of_run(Family::value_variants(), SEED, index);
        let (scene, camera, n) = (&case.scene, &case.camera, case.reflections.into());
        let truth = sampled(scene, camera, [width, height, 9], n, shading);
        let four = four_of(&render(scene, camera, 8 * width, 8 * height, n, shading));
        let four = compare(&four, &truth).unwrap().psnr;
        let source = case.source().unwrap();
        let [two, more] = [Quality::Smooth2, Quality::Smooth4].map(|quality| {
            let settings = Settings {
                reflections: case.reflections,
                shading: Shading::BlinnPhong,
                quality,
            };
            let drawn = source.drawn(Size::new(width, height), settings);
            compare(&drawn, &truth).unwrap().psnr
        });
        println!(
            "{:>20}: four samples {four:.1}, two rows {two:.1}, four rows {more:.1} dB",
            case.name
        );
        assert!(two >= four - 1.5, "{}", case.name);
        assert!(more >= four + 2.5, "{}", case.name);
    }
}
