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
fn corners_are_better_than_four_samples_on_average() {
    let shading = reference::Shading::BlinnPhong;
    let [width, height] = SIZE;
    let mut gain = 0.0;
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
            "{:>20}: four samples {four:.1}, Smooth<2> {two:.1}, Smooth<4> {more:.1} dB",
            case.name
        );
        // What is thinner than a pixel and lies between all corners is missed: in fences, and far away.
        assert!(two >= four - 5.0, "{}", case.name);
        assert!(more >= four - 1.5, "{}", case.name);
        gain += two - four;
    }
    gain /= SCENES as f64;
    println!("Smooth<2> is better by {gain:.1} dB on average");
    assert!(gain > 0.0);
}
