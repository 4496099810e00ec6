//! Cases of displays: the narrowest and the widest. Pictures partly outside of a display are in
//! `tests/scenes/drawing.rs`.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::RgbColor;
use lost::case::{VISIBLE, difference};

use super::draft::Setting;
use super::scene::Scene;
use super::{Case, Trial};

/// Returns the share of the pixels in some rows that are within 8 of 255 of the reference.
fn within8(size: Size, lines: &[u32]) -> f64 {
    let scene = Scene::read(&Setting::HERE.still_life()).expect("the scene is accepted");
    let (built, camera) = (scene.source.scene(), scene.source.camera());
    let frame = built.frame(&camera).prepare(size);
    let rows = frame.on(built).expect("the frame is this scene's");
    let mut row = vec![Rgb888::BLACK; size.width as usize];
    // For a very wide display, 512 to 1023 columns are enough.
    let step = (size.width / 512).max(1);
    let mut are_near = Vec::new();
    for &y in lines {
        rows.row(y, 0, &mut row);
        for (x, found) in (0..).zip(&row).step_by(step as usize) {
            let truth = scene.case.true_pixel(size, (x, y));
            let found = [found.r(), found.g(), found.b()];
            are_near.push(difference(found, truth) <= VISIBLE);
        }
    }
    let near = are_near.iter().filter(|is_near| **is_near).count();
    near as f64 / are_near.len() as f64
}

/// Tells the shares of these sizes and rows. Fails at the first that misses the bar.
fn shown(displays: &[((u32, u32), Vec<u32>)]) -> Result<String, String> {
    let words = displays.iter().map(|((width, height), rows)| {
        let share = within8(Size::new(*width, *height), rows);
        let words = format!("{width}x{height}: {:.2} % within 8", 100.0 * share);
        if share >= super::BAR { Ok(words) } else { Err(words) }
    });
    Ok(words.collect::<Result<Vec<_>, _>>()?.join(", "))
}

fn narrow() -> Result<String, String> {
    let all = || (0..100).collect();
    shown(&[
        ((1, 1), vec![0]),
        ((2, 1), vec![0]),
        ((100, 1), vec![0]),
        ((1, 100), all()),
        ((3, 100), all()),
    ])
}

fn wide() -> Result<String, String> {
    shown(&[
        ((65_535, 3), vec![0, 1, 2]),
        ((65_535, 65_535), vec![0, 32_767, 65_534]),
        ((5, 65_535), (0..65_535).step_by(1000).collect()),
    ])
}

pub fn cases() -> Vec<Case> {
    let small =
        "there may be no pixel beside the first, and angles between rows are as wide as the view";
    let large = "columns times steps reach the last bit of their format";
    let sizes = "1x1, 2x1, 100x1, 1x100, 3x100";
    vec![
        Case::new(sizes, small, Trial::Claim(narrow)),
        Case::new("65535 wide, high and both", large, Trial::Claim(wide)),
    ]
}
