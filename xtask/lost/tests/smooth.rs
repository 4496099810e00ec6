//! Smooth edges in random scenes, against four samples at every pixel.

use command_line::{Quality, Settings, four_samples};
use embedded_graphics::geometry::Size;
use lost::families::{Family, scene_of_run};
use reflet::host::compare::compare;
use reflet::host::reference::{self, render, sampled};

const SEED: u64 = 1;
const SIZE: [u32; 2] = [160, 120];
const SCENES: usize = 20;

/// Prints the PSNR of each scene.
#[test]
#[ignore = "takes twenty seconds"]
fn two_rows_are_about_as_good_as_four_samples() {
    let shading = reference::Shading::BlinnPhong;
    let [width, height] = SIZE;
    for index in 0..SCENES {
        let (_, case) = scene_of_run(&Family::ALL, SEED, index);
        let (scene, camera, n) = (&case.scene, &case.camera, case.reflections.into());
        let truth = sampled(scene, camera, [width, height, 9], n, shading);
        let four = four_samples(&render(scene, camera, 8 * width, 8 * height, n, shading));
        let four = compare(&four, &truth).unwrap().psnr;
        let source = case.source().unwrap();
        let [two, more] = [Quality::Smooth2, Quality::Smooth4].map(|quality| {
            let settings = Settings::blinn_phong(quality, case.reflections);
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
