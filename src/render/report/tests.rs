use super::*;

/// Returns the text of a report with these shares of 1.
fn text(cut_off: f64, brightest: f64) -> std::string::String {
    std::format!(
        "{}",
        Report {
            rays: 8933,
            cut_off: Unit::from_num(cut_off),
            brightest: Brightness::from_num(brightest * 255.0 / 256.0),
        }
    )
}

#[test]
fn text_has_the_rays_and_the_levels_that_can_be_missing() {
    assert_eq!(text(0.0, 30.0), "8933 rays, no reflection cut off");
    let missing = |cut_off, brightest| {
        let text = text(cut_off, brightest);
        let start = "8933 rays, reflections cut off: at most ";
        let (_, rest) = text.split_once(start).unwrap();
        std::string::String::from(rest)
    };
    // 0.0308 · 255 = 7.85 levels.
    assert_eq!(missing(0.0308, 1.0), "7.9 of 255 levels missing");
    assert_eq!(missing(0.0308, 0.5), "4.0 of 255 levels missing");
    assert_eq!(missing(0.0308, 3.0), "23.6 of 255 levels missing");
}

#[test]
fn levels_are_rounded_up_and_end_at_white() {
    assert!(text(1e-9, 1.0).ends_with("at most 0.1 of 255 levels missing"));
    assert!(text(1.0, 30.0).ends_with("at most 255.0 of 255 levels missing"));
}
