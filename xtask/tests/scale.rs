//! What a frame takes grows far slower than the number of its shapes. Executed instructions are
//! counted, not timed, so the same code always comes to the same figures.

use std::process::Command;

use benchmark::Order;
use xtask::{
    measure::{cores::Core, figures::Figures},
    scale::{BAR, FEW, MANY, SIZE, count},
};

fn measured(spheres: usize, order: Order) -> Figures {
    let core = Core::find("m3").unwrap();
    count(core, SIZE, spheres, order).unwrap_or_else(|error| panic!("{error:#}"))
}

#[test]
fn sixteen_times_the_spheres_cost_less_than_six_times_as_much() {
    assert_eq!((MANY / FEW, BAR), (16, 6.0));
    let [few, many] = [FEW, MANY].map(|spheres| measured(spheres, Order::Spiral));
    let times = many.instructions_per_pixel / few.instructions_per_pixel;
    assert!(times < BAR, "{times:.2} times\n{few:?}\n{many:?}");
}

#[test]
fn order_of_the_spheres_does_not_change_the_picture() {
    let [one, other] = [Order::Spiral, Order::Shuffled].map(|order| measured(MANY, order));
    assert_eq!(one.hash, other.hash);
}

#[test]
fn mistakes_are_one_line_and_exit_code_2() {
    let mistakes = [
        ("--core m5", "invalid value 'm5' for '--core <CORE>'"),
        ("--size 0x3", "not a width and a height from 1 to 65535"),
        ("--size", "a value is required for '--size <WxH>'"),
        ("castle", "unexpected argument 'castle' found"),
        ("--json --all", "unexpected argument '--all' found"),
    ];
    for (arguments, words) in mistakes {
        let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
            .arg("scale")
            .args(arguments.split_whitespace())
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
        assert_eq!(
            (said.lines().count(), output.stdout.len()),
            (1, 0),
            "{said}"
        );
        assert!(
            said.starts_with("error: ") && said.contains(words),
            "{said}"
        );
    }
}
