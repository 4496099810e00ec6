//! Smooth edges in random scenes, against four samples at every pixel.

use command_line::{Quality, four_samples};
use embedded_graphics::geometry::Size;
use lost::families::{Family, scene_of_run};
use reflet::host::compare::compare;
use reflet::host::reference::{Picture, Shading, sampled};

const SEED: u64 = 1;
const SIZE: Size = Size::new(160, 120);
const SCENES: usize = 20;

/// Prints the PSNR of each scene.
#[test]
#[ignore = "takes twenty seconds"]
fn corners_are_better_than_four_samples_on_average() {
    let mut gain = 0.0;
    for index in 0..SCENES {
        let (_, case) = scene_of_run(&Family::ALL, SEED, index);
        let (fine, n) = ([SIZE.width, SIZE.height, 9], case.reflections.into());
        let truth = sampled(&case.scene, &case.camera, fine, n, Shading::BlinnPhong);
        let psnr = |picture: &Picture| compare(picture, &truth).unwrap().psnr;
        let four = psnr(&four_samples(&case.truth(SIZE * 8)));
        let source = case.source().unwrap();
        let drawn = |quality| source.drawn(SIZE, case.settings(quality));
        let [two, more] = [Quality::Smooth2, Quality::Smooth4].map(|it| psnr(&drawn(it)));
        println!(
            "{:>20}: four samples {four:.1}, Smooth<2> {two:.1}, Smooth<4> {more:.1} dB",
            case.name
        );
        assert!(two.min(more) >= four - 1.5, "{}", case.name);
        gain += two - four;
    }
    gain /= SCENES as f64;
    println!("Smooth<2> is better by {gain:.1} dB on average");
    assert!(gain > 0.0);
}
