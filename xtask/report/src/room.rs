//! A closed room of mirrors, where theory says exactly what every number of reflections shows:
//! c (1 − α^(N+1)).

use std::ops::Add;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use plotters::prelude::*;
use reflet::{Camera, Exact, Material, RuntimeScene};

use crate::plot::{BLUE, GREEN, PURPLE, VERMILLION};
use command_line::Failure;

const ALPHAS: [f64; 4] = [0.5, 0.9, 0.99, 0.999];

/// What the walls glow with, in all channels.
const COLOR: f64 = 1.0;

/// One room with one number of reflections.
pub struct Seen {
    pub alpha: f64,
    pub reflections: u8,
    /// The channels of the picture that are furthest from the formula, of 255.
    pub measured: u8,
    pub expected: f64,
}

/// All rooms with all numbers.
pub fn measure() -> Result<Vec<Seen>, Failure> {
    let camera = Camera::new([0.3, -0.4, 0.2], [1.0, 1.3, 0.7], [0, 0, 1], 80)?;
    let mut seen = Vec::new();
    for alpha in ALPHAS {
        let mut room = RuntimeScene::<0, 6, 0, 0, 1>::new();
        let glass = room.add_material(Material::from_numbers([COLOR; 3], 1, 0, (0, 1), alpha)?)?;
        for axis in 0..3 {
            for side in [-1, 1] {
                let mut wall = [0; 3];
                wall[axis] = 2 * side;
                room.add_plane(wall, wall, glass)?;
            }
        }
        let room = room.build()?;
        for reflections in 0..=u8::MAX {
            let frame = room
                .frame(&camera)
                .reflections(reflections)
                .quality::<Exact>();
            let picture = frame.sized(Size::new(8, 8));
            let expected = 255.0 * COLOR * (1.0 - alpha.powi(i32::from(reflections) + 1));
            let mut row = [Rgb888::BLACK; 8];
            let mut worst = None::<u8>;
            let far = |level: u8| (f64::from(level) - expected).abs();
            for y in 0..8 {
                picture.row(y, 0, &mut row);
                let levels = row
                    .iter()
                    .flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b()]);
                let all = levels.chain(worst);
                worst = all.max_by(|a, b| far(*a).total_cmp(&far(*b)));
            }
            seen.push(Seen {
                alpha,
                reflections,
                measured: worst.unwrap_or(0),
                expected,
            });
        }
    }
    Ok(seen)
}

/// The furthest that any is from the formula, of 255.
pub fn furthest(seen: &[Seen]) -> f64 {
    let far = |it: &Seen| (f64::from(it.measured) - it.expected).abs();
    seen.iter().map(far).fold(0.0, f64::max)
}

/// The plot of all rooms.
pub fn plot(seen: &[Seen]) -> Result<String, Failure> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, (760, 420)).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption("A closed room of mirrors", ("sans-serif", 18))
            .margin(8)
            .x_label_area_size(44)
            .y_label_area_size(56)
            .build_cartesian_2d((0.9..300.0).log_scale(), 0.0..350.0)?;
        chart
            .configure_mesh()
            .light_line_style(WHITE)
            .label_style(("sans-serif", 14))
            .axis_desc_style(("sans-serif", 15))
            .x_desc("N + 1 (logarithmic): what is met on a path")
            .y_desc("level of 255")
            .x_label_formatter(&|x| format!("{x}"))
            .y_label_formatter(&|y| match *y > 255.0 {
                true => String::new(),
                false => format!("{y:.0}"),
            })
            .draw()?;
        let colors = [BLUE, VERMILLION, GREEN, PURPLE];
        for (index, (alpha, color)) in ALPHAS.into_iter().zip(colors).enumerate() {
            let own = || seen.iter().filter(move |it| it.alpha == alpha);
            let steps = |it: &Seen| f64::from(it.reflections) + 1.0;
            let line = own().map(|it| (steps(it), it.expected));
            chart.draw_series(LineSeries::new(line, color.stroke_width(2)))?;
            let is_marked = |it: &&Seen| {
                let next = u32::from(it.reflections) + 1;
                next.is_power_of_two() || next % 3 == 0 && (next / 3).is_power_of_two()
            };
            let at = |it: &Seen| (steps(it), f64::from(it.measured));
            chart
                .draw_series(
                    own()
                        .filter(is_marked)
                        .map(|it| marker(index, at(it), color)),
                )?
                .label(format!("α = {alpha}: dots measured, line c (1 − α^(N+1))"))
                .legend(move |at| marker(index, (at.0 + 10, at.1), color));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .label_font(("sans-serif", 15))
            .draw()?;
        root.present()?;
    }
    Ok(svg)
}

/// A path around a place of a plot.
type Marker<'a, C> = <EmptyElement<C, SVGBackend<'a>> as Add<PathElement<(i32, i32)>>>::Output;

/// A shape of its own for each room: a square, a triangle, a cross, a diamond.
fn marker<'a, C>(index: usize, at: C, color: RGBColor) -> Marker<'a, C> {
    let path = match index {
        0 => vec![(-4, -4), (4, -4), (4, 4), (-4, 4), (-4, -4)],
        1 => vec![(-5, 4), (0, -5), (5, 4), (-5, 4)],
        2 => vec![(-5, -5), (5, 5), (0, 0), (-5, 5), (5, -5)],
        _ => vec![(0, -6), (6, 0), (0, 6), (-6, 0), (0, -6)],
    };
    EmptyElement::at(at) + PathElement::new(path, color.stroke_width(2))
}
