//! Tests that the cost of a frame grows far slower than the number of its shapes. Instructions are
//! counted, not timed, so the same code always gives the same figures.

use benchmark::{Mirrors, Order};
use xtask::measure::{Core, Figures};
use xtask::root;
use xtask::scale::{BAR, FEW, MANY, MIRRORS_BAR, SIZE, count};

mod common;

fn measured(spheres: usize, mirrors: Mirrors, order: Order) -> Figures {
    count(Core::M3, SIZE, (spheres, mirrors), order).unwrap_or_else(|error| panic!("{error:#}"))
}

#[test]
fn sixteen_times_the_spheres_cost_less_than_six_times_as_much() {
    assert_eq!((MANY / FEW, BAR), (16, 6.0));
    let spiral = |spheres| measured(spheres, Mirrors::EveryOther, Order::Spiral);
    let [few, many] = [FEW, MANY].map(spiral);
    let times = many.instructions_per_pixel / few.instructions_per_pixel;
    assert!(times < BAR, "{times:.2} times\n{few:?}\n{many:?}");
}

#[test]
fn sixteen_times_the_mirrors_cost_at_most_three_and_a_half_times_as_much() {
    assert_eq!(MIRRORS_BAR, 3.5);
    for order in [Order::Spiral, Order::Shuffled] {
        let [few, many] = [FEW, MANY].map(|spheres| measured(spheres, Mirrors::All, order));
        let times = many.instructions_per_pixel / few.instructions_per_pixel;
        assert!(times < MIRRORS_BAR, "{times:.2} times\n{few:?}\n{many:?}");
    }
}

#[test]
fn order_of_the_spheres_does_not_change_the_picture() {
    for mirrors in [Mirrors::EveryOther, Mirrors::All] {
        let any = |order| measured(MANY, mirrors, order);
        let [one, other] = [Order::Spiral, Order::Shuffled].map(any);
        assert_eq!(one.hash, other.hash);
    }
}

#[test]
fn mistakes_are_one_line_and_exit_code_2() {
    let mistakes = "
scale --core m5 => invalid value 'm5' for '--core <CORE>'
scale --size 0x3 => not a width and a height from 1 to 65535
scale --size => a value is required for '--size <WxH>'
scale castle => unexpected argument 'castle' found
scale --json --all => unexpected argument '--all' found";
    common::assert_mistakes(&root(), mistakes);
}
