use super::*;
use crate::shape::sphere::Sphere;

#[test]
fn named_part_has_its_index_among_its_kind() {
    const PARTS: &[(&str, &str)] = &[
        ("sphere", ""),
        ("plane", ""),
        ("disc", "LID"),
        ("sphere", "BALL"),
    ];
    assert_eq!(Handle::<Sphere>::named(PARTS, "BALL").index(), 1);
    assert_eq!(
        Handle::<crate::shape::disc::Disc>::named(PARTS, "LID").index(),
        0
    );
}
