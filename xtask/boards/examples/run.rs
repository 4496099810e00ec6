//! Runs a firmware on a board until its first picture: `run BOARD ELF`, with the board `pico`,
//! `pico2` or `blackpill`. Prints what the firmware said, and the counts.

use std::path::PathBuf;
use std::time::Instant;

use boards::{Board, Script};

fn main() {
    let mut arguments = std::env::args().skip(1);
    let mut next = || arguments.next().expect("run BOARD ELF");
    let board = match next().as_str() {
        "pico" => Board::PICO,
        "pico2" => Board::PICO_2,
        "blackpill" => Board::BLACK_PILL,
        other => panic!("no board {other}"),
    };
    let firmware = PathBuf::from(next());
    let start = Instant::now();
    match board.run(&firmware, &Script::default().picture(&[])) {
        Ok(run) => {
            run.said.iter().for_each(|line| println!("{line}"));
            println!("{} cycles, {} instructions", run.cycles, run.instructions);
        }
        Err(failure) => println!("{failure}"),
    }
    println!("{:.2} s of emulation", start.elapsed().as_secs_f64());
}
