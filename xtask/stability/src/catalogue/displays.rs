//! Cases of displays: the narrowest, the widest, and pictures partly outside of them.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::RgbColor;
use embedded_graphics::primitives::{PointsIter, Rectangle};
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::Camera;
use reflet::host::file::{FileScene, SceneFile};
use reflet::host::reference::{self, Shading};
use reflet::quality::Fine;

use super::draft::Setting;
use super::{Case, claim};

fn still_life() -> (SceneFile, Box<FileScene>, Camera) {
    let text = Setting::HERE.still_life().text();
    let file = SceneFile::parse(&text, None).expect("the scene is well formed");
    let (_, camera) = file.runtime().expect("the camera is accepted");
    let built = file.build().expect("the scene is accepted");
    (file, built, camera)
}

/// Returns the share of the pixels in some rows that are within 8 of 255 of the reference.
fn within8(size: (u32, u32), lines: &[u32]) -> f64 {
    let (file, built, camera) = still_life();
    let (scene, eye) = file.reference();
    let frame = built.frame(&camera).quality::<Fine>();
    let frame = frame.prepare(Size::new(size.0, size.1));
    let rows = frame.on(&built).expect("the frame is this scene's");
    let mut row = vec![Rgb888::BLACK; size.0 as usize];
    let (mut near, mut all) = (0, 0);
    // For a very wide display, 512 to 1023 columns are enough.
    let step = (size.0 / 512).max(1);
    for &y in lines {
        rows.row(y, 0, &mut row);
        for x in (0..size.0).step_by(step as usize) {
            let color = reference::pixel(&scene, &eye, size, (x, y), 4, Shading::BlinnPhong);
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

/// Checks that every part of a picture equals the same part of the whole, wherever it is drawn.
fn aside() -> Result<String, String> {
    let (_, built, camera) = still_life();
    let frame = built.frame(&camera).prepare(Size::new(40, 30));
    let rows = frame.on(&built).expect("the frame is this scene's");
    let drawn = |at| {
        let mut display = SimulatorDisplay::<Rgb888>::new(Size::new(40, 30));
        let all = Rectangle::new(Point::zero(), rows.size());
        let drawn = rows.draw_area(all, at, &mut display);
        drawn.expect("the simulator takes every pixel");
        display
    };
    let whole = drawn(Point::zero());
    for (x, y) in [
        (-13, -7),
        (25, 11),
        (-39, 29),
        (-40, 0),
        (1000, 1000),
        (-2000, 5),
    ] {
        let at = Point::new(x, y);
        let moved = drawn(at);
        for point in Rectangle::new(Point::zero(), Size::new(40, 30)).points() {
            let source = point - at;
            let is_inside = (0..40).contains(&source.x) && (0..30).contains(&source.y);
            let expected = is_inside.then(|| whole.get_pixel(source));
            if moved.get_pixel(point) != expected.unwrap_or(Rgb888::BLACK) {
                return Err(format!("moved by {at}: {point} differs"));
            }
        }
    }
    Ok("moved to six places, three of them outside: what is seen is the same".to_owned())
}

/// Checks that no ray is traced for displays and areas without a pixel.
fn nothing() -> Result<String, String> {
    let (_, built, camera) = still_life();
    let frame = built.frame(&camera);
    let prepared = frame.prepare(Size::new(40, 30));
    let rows = prepared.on(&built).expect("the frame is this scene's");
    let mut rays = 0;
    for size in [Size::zero(), Size::new(0, 9), Size::new(9, 0)] {
        let mut display = SimulatorDisplay::<Rgb888>::new(size);
        rays += frame.draw(&mut display).expect("it takes every pixel").rays;
    }
    let mut display = SimulatorDisplay::<Rgb888>::new(Size::new(40, 30));
    for area in [
        Rectangle::new(Point::new(3, 3), Size::zero()),
        Rectangle::new(Point::new(40, 0), Size::new(9, 9)),
        Rectangle::new(Point::new(-9, -9), Size::new(9, 9)),
    ] {
        let drawn = rows.draw_area(area, Point::zero(), &mut display);
        rays += drawn.expect("it takes every pixel").rays;
    }
    rays += rows.row(30, 0, &mut [Rgb888::BLACK; 4]).rays;
    rays += rows.row(0, 40, &mut [Rgb888::BLACK; 4]).rays;
    rays += rows.row(0, 0, &mut [Rgb888::BLACK; 0]).rays;
    match rays {
        0 => Ok("no ray is followed for displays and areas without a pixel".to_owned()),
        rays => Err(format!("{rays} rays for nothing")),
    }
}

/// Returns the cases of the chapter "Displays".
pub fn cases() -> Vec<Case> {
    let small =
        "there may be no pixel beside the first, and angles between rows are as wide as the view";
    let large = "columns times steps reach the last bit of their format";
    let part = "a part must be what it is in the whole";
    vec![
        claim("1x1, 2x1, 100x1, 1x100, 3x100", small, narrow),
        claim("65535 wide, high and both", large, wide),
        claim("partly outside", part, aside),
        claim("no area", "nothing to be divided by", nothing),
    ]
}
