//! Cases of displays: the narrowest and the widest. Pictures partly outside of a display are in
//! `tests/scenes/drawing.rs`.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::RgbColor;
use reflet::host::reference::{self, Shading};
use reflet::quality::Fast;

use super::draft::Setting;
use super::scene::Scene;
use super::{Case, claim};

fn still_life() -> Scene {
    Scene::read(&Setting::HERE.still_life().text()).expect("the scene is accepted")
}

/// Returns the share of the pixels in some rows that are within 8 of 255 of the reference.
fn within8(size: (u32, u32), lines: &[u32]) -> f64 {
    let scene = still_life();
    let frame = scene.built.frame(&scene.camera).quality::<Fast>();
    let frame = frame.prepare(Size::new(size.0, size.1));
    let rows = frame.on(&*scene.built).expect("the frame is this scene's");
    let mut row = vec![Rgb888::BLACK; size.0 as usize];
    let (mut near, mut all) = (0, 0);
    // For a very wide display, 512 to 1023 columns are enough.
    let step = (size.0 / 512).max(1);
    for &y in lines {
        rows.row(y, 0, &mut row);
        for x in (0..size.0).step_by(step as usize) {
            let color = reference::pixel(
                &scene.exact,
                &scene.eye,
                size,
                (x, y),
                4,
                Shading::BlinnPhong,
            );
            let found = row[x as usize];
            let found = [found.r(), found.g(), found.b()];
            let is_near = [0, 1, 2].into_iter().all(|it| {
                let truth = (255.0 * color[it].clamp(0.0, 1.0)).round();
                (truth - f64::from(found[it])).abs() <= 8.0
            });
            near += u32::from(is_near);
            all += 1;
        }
    }
    f64::from(near) / f64::from(all)
}

fn shown(size: (u32, u32), rows: &[u32]) -> Result<String, String> {
    let share = within8(size, rows);
    let words = format!("{}x{}: {:.2} % within 8", size.0, size.1, 100.0 * share);
    match share >= super::BAR {
        true => Ok(words),
        false => Err(words),
    }
}

fn narrow() -> Result<String, String> {
    let all: Vec<u32> = (0..100).collect();
    let found = [
        shown((1, 1), &[0])?,
        shown((2, 1), &[0])?,
        shown((100, 1), &[0])?,
        shown((1, 100), &all)?,
        shown((3, 100), &all)?,
    ];
    Ok(found.join(", "))
}

fn wide() -> Result<String, String> {
    let found = [
        shown((65_535, 3), &[0, 1, 2])?,
        shown((65_535, 65_535), &[0, 32_767, 65_534])?,
        shown((5, 65_535), &(0..65_535).step_by(1000).collect::<Vec<_>>())?,
    ];
    Ok(found.join(", "))
}

/// Returns the cases of the chapter "Displays".
pub fn cases() -> Vec<Case> {
    let small =
        "there may be no pixel beside the first, and angles between rows are as wide as the view";
    let large = "columns times steps reach the last bit of their format";
    vec![
        claim("1x1, 2x1, 100x1, 1x100, 3x100", small, narrow),
        claim("65535 wide, high and both", large, wide),
    ]
}
