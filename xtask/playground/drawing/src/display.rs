//! The colours of displays, and how a screen shows them. Dithering and colour types are the library's and
//! embedded-graphics'.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888};
use reflet::display::dither;

/// Returns the colour that a display of this number shows for `color` at a point, as a screen shows it.
pub(crate) fn shown(display: u32, color: Rgb888, at: Point) -> Rgb888 {
    match display {
        1 => Rgb565::from(color).into(),
        2 => Gray4::from(color).into(),
        3 => dither::<BinaryColor>(color, at).into(),
        4 => dither::<Rgb565>(color, at).into(),
        5 => dither::<Gray4>(color, at).into(),
        _ => color,
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::pixelcolor::RgbColor;

    use super::*;

    const ORANGE: Rgb888 = Rgb888::new(250, 130, 7);

    fn shades(display: u32) -> Vec<Rgb888> {
        let at = |place: i32| Point::new(place % 8, place / 8);
        (0..64).map(|it| shown(display, ORANGE, at(it))).collect()
    }

    #[test]
    fn a_display_shows_only_its_own_colours() {
        let is_grey = |it: &Rgb888| it.r() == it.g() && it.g() == it.b();
        assert!(shades(0).iter().all(|it| *it == ORANGE));
        let greys = [shades(2), shades(5)].concat();
        assert!(greys.iter().all(|it| is_grey(it) && it.r() % 17 == 0));
        let ends = [Rgb888::BLACK, Rgb888::WHITE];
        assert!(shades(3).iter().all(|it| ends.contains(it)));
        for display in [1, 4] {
            let are_kept = |it: &Rgb888| Rgb888::from(Rgb565::from(*it)) == *it;
            assert!(shades(display).iter().all(are_kept));
        }
    }

    #[test]
    fn only_dithered_displays_show_two_colours_for_one() {
        let is_mixed = |display| shades(display).iter().any(|it| *it != shades(display)[0]);
        let mixed: Vec<_> = (0..6).filter(|display| is_mixed(*display)).collect();
        assert_eq!(mixed, [3, 4, 5]);
    }
}
