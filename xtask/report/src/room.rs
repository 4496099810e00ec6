//! Measures a closed room of mirrors, for which theory gives the exact level after N reflections: c
//! (1 − α^(N+1)).

use anyhow::Result;
use embedded_graphics::geometry::Size;
use reflet::host::painted;
use reflet::quality::Exact;
use reflet::{Camera, Material, RuntimeScene, room};

use crate::svg::{self, Axis, Chart};

/// Shares of light that the mirrors of the rooms reflect.
const ALPHAS: [f64; 4] = [0.5, 0.9, 0.99, 0.999];

/// One room drawn with one number of reflections.
pub struct Seen {
    alpha: f64,
    reflections: u8,
    /// The channel of the picture that is furthest from the formula, in levels of 255.
    measured: f64,
    expected: f64,
}

/// Measures all rooms with all numbers of reflections. The walls have the colour c = 1 in all
/// channels.
pub fn measure() -> Result<Vec<Seen>> {
    let camera = Camera::new([0.3, -0.4, 0.2], [1.0, 1.3, 0.7], [0, 0, 1], 80)?;
    let mut seen = Vec::new();
    for alpha in ALPHAS {
        let mut room = RuntimeScene::<room!(planes: 6, materials: 1)>::new();
        let glass = room.add_material(Material::from_numbers([1; 3], 1, 0, (0, 1), alpha)?)?;
        for axis in 0..3 {
            for side in [-1, 1] {
                let mut wall = [0; 3];
                wall[axis] = 2 * side;
                room.add_plane(wall, wall, glass)?;
            }
        }
        let room = room.build()?;
        for reflections in 0..=u8::MAX {
            let frame = room.frame(&camera).reflections(reflections);
            let frame = frame.quality::<Exact>().prepare(Size::new(8, 8));
            let picture = painted(&frame.on(&room)?);
            let expected = 255.0 * (1.0 - alpha.powi(i32::from(reflections) + 1));
            let far = |level: &f64| (level - expected).abs();
            let levels = picture.pixels.into_iter().flatten().map(f64::from);
            let worst = levels.max_by(|a, b| far(a).total_cmp(&far(b)));
            seen.push(Seen {
                alpha,
                reflections,
                measured: worst.unwrap_or(0.0),
                expected,
            });
        }
    }
    Ok(seen)
}

/// Returns the largest difference between a measured level and the formula, in levels of 255.
pub fn furthest(seen: &[Seen]) -> f64 {
    let far = seen.iter().map(|it| (it.measured - it.expected).abs());
    far.fold(0.0, f64::max)
}

pub fn plot(seen: &[Seen]) -> String {
    let x = Axis::logarithmic("N + 1: what is met on a path", 0.9..300.0);
    let y = Axis::linear("level of 255", 0.0..260.0, 50.0);
    let mut chart = Chart::new("A closed room of mirrors", x, y);
    let styles = [
        (svg::SQUARE, svg::BLUE),
        (svg::OPEN_TRIANGLE, svg::VERMILLION),
        (svg::CROSS, svg::GREEN),
        (svg::DIAMOND, svg::PURPLE),
    ];
    for (alpha, (mark, color)) in ALPHAS.into_iter().zip(styles) {
        let steps = |it: &Seen| f64::from(it.reflections) + 1.0;
        // Marks the values 2, 3, 4, 6, 8, 12 and so on.
        let is_marked = |it: &&Seen| {
            let next = u32::from(it.reflections) + 1;
            next.is_power_of_two() || next % 3 == 0 && (next / 3).is_power_of_two()
        };
        let own = seen.iter().filter(|it| it.alpha == alpha);
        chart.line(color, false, own.clone().map(|it| (steps(it), it.expected)));
        let label = format!("α = {alpha}: line c (1 − α^(N+1)), marks measured");
        let marked = own.filter(is_marked).map(|it| (steps(it), it.measured));
        chart.marks(mark, color, marked, &label);
    }
    chart.finish(&[])
}
