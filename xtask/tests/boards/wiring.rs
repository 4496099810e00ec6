//! Wrong wirings are found, each in one clear line.

use boards::{Failure, GROUND, Pin, Script, Wiring};

use super::{BLACK_PILL, Copied, PICO, PICO_2};

/// Returns the fault of the right firmware on a board that is wired wrongly.
fn fault(copied: &Copied, wire: impl FnOnce(&mut Wiring)) -> String {
    let mut board = copied.board().clone();
    wire(&mut board.wiring);
    let script = Script::default().picture(&[]).rows(2).limit(5);
    match board.run(copied.firmware(), &script) {
        Err(Failure::Firmware { fault, .. }) => fault.to_string(),
        Err(failure) => panic!("{failure}"),
        Ok(_) => panic!("the wrong wiring is not noticed"),
    }
}

/// Tests five wrong wirings of a board. `unused` is a pin that the firmware does not use, with its
/// name and what it does; `select` and `data_command` are the names of CS and D/C.
fn test(
    copied: &Copied,
    (unused, name, idle): (Pin, &str, &str),
    [select, data_command]: [&str; 2],
) {
    let found = |wire: fn(&mut Wiring, Pin)| fault(copied, |it| wire(it, unused));
    assert_eq!(
        found(|it, unused| it.data_command = unused),
        format!("the panel's D/C is wired to {name}, which is {idle}, not an output")
    );
    assert_eq!(
        found(|it, _| it.chip_select = GROUND),
        "CS has never risen before the first pixels"
    );
    assert_eq!(
        found(|it, _| std::mem::swap(&mut it.chip_select, &mut it.data_command)),
        format!(
            "the panel's CS is wired to {data_command}, which is Output(true), \
             not an output that is low while a byte is sent"
        )
    );
    assert_eq!(
        found(|it, _| it.reset = it.chip_select),
        format!(
            "the panel's reset is wired to {select}, which is Output(false), \
             not an output that is high"
        )
    );
    assert_eq!(
        found(|it, unused| it.clock = unused),
        format!("the panel's clock is wired to {name}, which is {idle}, not the clock of the SPI")
    );
}

#[test]
fn wrong_wirings_of_a_pico_are_found() {
    let unused = (22, "GP22", "Idle");
    test(&PICO, unused, ["GP9", "GP8"]);
}

#[test]
fn wrong_wirings_of_a_pico_2_are_found() {
    let unused = (22, "GP22", "Idle");
    test(&PICO_2, unused, ["GP9", "GP8"]);
}

#[test]
fn wrong_wirings_of_a_black_pill_are_found() {
    let unused = (8, "PA8", "Input");
    test(&BLACK_PILL, unused, ["PA4", "PB0"]);
}
