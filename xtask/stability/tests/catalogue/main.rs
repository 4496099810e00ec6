//! Tests of stiff and extreme cases: every case of the catalogue meets its bar, the page is up to
//! date, and pictures preserve energy, symmetry and continuity.

mod corpus;
mod kept;
mod symmetry;

use std::collections::BTreeSet;
use std::fs;

use stability::catalogue::draft::{EYE, TARGET, still_life};
use stability::catalogue::judge::judge;
use stability::catalogue::{BAR, Bar, Case, Measured, Trial, chapters};
use stability::report::Tried;
use stability::{page, random, report};
use wild::Wild;

#[test]
fn every_case_meets_its_bar_and_the_page_says_so() {
    let tried: Vec<_> = report::try_all().collect();
    let failures = report::failures(&tried);
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    assert!(report::Compared::of(&tried).is_aim_met());
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../docs/internals/stability.md"
    );
    let written = fs::read_to_string(path).unwrap();
    let words = "docs/internals/stability.md is old: cargo run --release --package stability";
    assert!(written == page::page(&tried), "{words}");
}

#[test]
fn no_two_cases_have_one_name() {
    let mut names = BTreeSet::new();
    for case in chapters().into_iter().flat_map(|(_, cases)| cases) {
        assert!(names.insert(case.name.clone()), "{}", case.name);
    }
}

fn case(trial: Trial) -> Case {
    Case::new("a case", "", trial)
}

#[test]
fn verdicts_can_fail() {
    let scene = || still_life(EYE, TARGET, 50.0);
    let compared = |draft, bar| judge(&case(Trial::Picture(draft, bar)));
    let picture = |draft, share| compared(draft, Bar::Pixels(share));
    assert!(picture(scene(), BAR).is_met);
    assert!(!picture(scene(), 1.01).is_met);
    // A scene that the library refuses must not count as drawn well.
    let refused = scene().sphere([0.0; 3], -1.0, "gold");
    assert!(!picture(refused, 0.0).is_met);
    assert!(!compared(scene(), Bar::Color([0.5; 3])).is_met);
    let measured = |trial| [Tried::new("a chapter", case(Trial::Measured(trial)))];
    assert_eq!(report::failures(&measured(|| found(0.5, 0.5))).len(), 0);
    assert_eq!(report::failures(&measured(|| found(2.0, 3.0))).len(), 1);
    // Worse without a reason, and 0 of 1 cases misses the aim.
    let worse = measured(|| found(0.5, 0.25));
    assert_eq!(report::failures(&worse).len(), 1);
    assert!(!report::Compared::of(&worse).is_aim_met());
    assert!(!judge(&case(Trial::Claim(|| Err("no".to_owned())))).is_met);
}

fn found(fixed: f64, single: f64) -> Measured {
    Measured {
        reference: "",
        unit: "",
        fixed,
        single,
        bar: 1.0,
        note: String::new(),
    }
}

/// Runs with every overflow checked, like all tests. `stability --rays` follows more rays.
#[test]
fn random_scenes_overflow_nowhere() {
    overflow_nowhere(Wild::read, 100_000);
    overflow_nowhere(Wild::read_with_ranges, 50_000);
}

#[test]
#[ignore = "long: more rays"]
fn many_more_rays_overflow_nowhere() {
    overflow_nowhere(Wild::read, 1_000_000);
    overflow_nowhere(Wild::read_with_ranges, 500_000);
}

fn overflow_nowhere(read: fn(&[u8]) -> Option<Wild>, most: u64) {
    let (mut rays, mut scenes) = (0, 0);
    let mut drawn = random::scenes([7; 32], read).filter_map(|wild| wild?.draw());
    while rays < most {
        rays += drawn.next().unwrap_or(0);
        scenes += 1;
    }
    println!("{rays} rays in {scenes} scenes");
    assert!(scenes > most / 1000, "{scenes} scenes are too few");
}
