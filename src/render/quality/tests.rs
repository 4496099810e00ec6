use super::*;
use crate::trace::tests::qualities;

#[test]
fn paths_are_tested_with_these_qualities() {
    fn known_to_paths<Q: PathQuality>() -> (Unit, Unit, Culling, bool) {
        let (weight, tolerance) = (Q::SMALLEST_WEIGHT, Q::TOLERANCE);
        (weight, tolerance, Q::CULLING, Q::IS_PRECISE)
    }
    let these = [
        known_to_paths::<Fast>(),
        known_to_paths::<Small>(),
        known_to_paths::<Exact>(),
    ];
    let tested = [
        known_to_paths::<qualities::Fast>(),
        known_to_paths::<qualities::Small>(),
        known_to_paths::<qualities::Exact>(),
    ];
    assert_eq!(these, tested);
}
