//! A board that runs: gives the cores their turns, presses keys and captures pictures.

use std::sync::Arc;

use rp2350_emu::threaded::CoreAtomics;

use crate::board::{Board, ChipKind};
use crate::chip::bus_time::BusTime;
use crate::core::Core;
use crate::elf::Firmware;
use crate::fault::{Failure, Fault, fault};
use crate::keys::Presses;
use crate::rtt::Rtt;
use crate::run::{Display, Picture, Run, Script};
use crate::system::{Private, System};
use crate::wires::Wires;

/// Cycles of a core's turn.
const TURN: u64 = 64;

/// Turns after which keys and prints are looked at.
const LOOK: u64 = 64;

struct Runner<C> {
    core: C,
    is_on: bool,
    /// Time in cycles.
    time: u64,
    instructions: u64,
}

pub struct Machine<C> {
    runners: Vec<Runner<C>>,
    system: System,
    presses: Presses,
    rtt: Rtt,
    /// Number of rows of the picture that are drawn while the panel is lit, from the top.
    rows: usize,
    /// Time of the bus when the first row of the picture was finished.
    bus: BusTime,
    /// A picture that is complete and not yet captured.
    complete: Option<Picture>,
    pictures: Vec<Picture>,
}

impl<C: Core> Machine<C> {
    /// Switches a board on whose flash has this firmware.
    pub fn new(board: &Board, firmware: &Firmware, script: &Script) -> Result<Self, Failure> {
        let mut memory = board.memory();
        for (address, bytes) in &firmware.parts {
            let fits = memory.program(*address, bytes);
            fits.ok_or_else(|| Failure::Program(format!("no flash at {address:#010x}")))?;
        }
        let atomics = Arc::new(CoreAtomics::default());
        let system = System {
            memory,
            chip: board.peripherals(script.cores),
            wires: Wires::new(board.wiring),
            now: 0,
            core: 0,
            pc: 0,
            fault: None,
            start: None,
            private: [Private::default(), Private::default()],
            atomics: Arc::clone(&atomics),
            microsecond: board.clock() / 1_000_000,
            aligned: board.chip == ChipKind::Rp2040,
        };
        let cores = C::all(board.chip, &atomics);
        let mut machine = Self {
            runners: cores.into_iter().map(Runner::new).collect(),
            system,
            presses: Presses::default(),
            rtt: Rtt::new(firmware.rtt),
            rows: 0,
            bus: BusTime::default(),
            complete: None,
            pictures: vec![],
        };
        machine.reset(board.chip);
        Ok(machine)
    }

    /// Starts the first core as the boot ROM does.
    fn reset(&mut self, chip: ChipKind) {
        let vectors = chip.vectors();
        let word = |at| self.system.memory.read(vectors + at, 4).unwrap_or(0);
        let start = [vectors, word(0), word(4)];
        self.runners[0].core.start(&mut self.system, start);
        self.runners[0].is_on = true;
    }

    /// Executes instructions of the first core until it reaches an address. The first 8 registers
    /// begin with these values. Returns them at the end, and the flags.
    pub fn execute(&mut self, registers: [u32; 8], end: u32) -> Result<([u32; 8], u32), Fault> {
        let Self {
            runners, system, ..
        } = self;
        let core = &mut runners[0].core;
        core.registers()[..8].copy_from_slice(&registers);
        while core.pc() != end {
            system.pc = core.pc();
            core.step(system)?;
            system.check()?;
            core.check(system)?;
        }
        let registers = core.registers().first_chunk().copied();
        Ok((registers.unwrap_or_default(), core.flags()))
    }

    /// Runs until the last picture is captured.
    pub fn run(mut self, board: &Board, script: &Script) -> Result<Run, Failure> {
        let limit = script.seconds * board.clock();
        for keys in &script.pictures {
            for key in keys {
                let pin = board.pin(*key);
                let pin = pin.ok_or_else(|| Failure::Program(format!("no key {key:?}")))?;
                self.presses.add(pin);
            }
            let drawn = self.draw(script, limit);
            drawn.map_err(|fault| self.failure(fault))?;
        }
        let panel = &self.system.wires.panel;
        Ok(Run {
            cycles: self.runners[0].time,
            instructions: self.instructions(),
            said: self.rtt.lines(),
            display: Display {
                inverted: panel.is_inverted(),
                address_mode: panel.address_mode(),
            },
            pictures: self.pictures,
        })
    }

    /// Returns a fault with its place and what the firmware said.
    pub fn failure(&mut self, fault: Fault) -> Failure {
        self.rtt.poll(&mut self.system.memory);
        Failure::Firmware {
            fault,
            pc: self.system.pc,
            core: self.system.core,
            said: self.rtt.lines(),
        }
    }

    /// Runs until one more picture is captured.
    fn draw(&mut self, script: &Script, limit: u64) -> Result<(), Fault> {
        let captured = self.pictures.len();
        let is_last = captured + 1 == script.pictures.len();
        let pause = script.pauses[usize::from(is_last)];
        let mut turns = 0_u64;
        while self.pictures.len() == captured {
            self.turn(script.rows)?;
            turns += 1;
            if pause == 0 && self.presses.are_finished() {
                self.pictures.extend(self.complete.take());
            }
            if turns.is_multiple_of(LOOK) {
                self.look(pause);
                if self.runners[0].time > limit {
                    return Err(fault!("the limit of the run is reached"));
                }
            }
        }
        self.rows = 0;
        Ok(())
    }

    /// Presses keys, reads prints, and captures a complete picture.
    fn look(&mut self, pause: u64) {
        let time = self.runners[0].time / self.system.microsecond;
        // Nobody presses a key of a board that shows nothing, and its firmware may not listen yet.
        if !self.system.wires.is_lit() {
            self.presses.wait(time);
        }
        if self.presses.advance(&mut *self.system.chip, time) {
            self.rows = 0;
            self.complete = None;
        }
        self.rtt.poll(&mut self.system.memory);
        let is_due = |it: &Picture| it.cycles / self.system.microsecond + pause <= time;
        if self.presses.are_finished() && self.complete.as_ref().is_some_and(is_due) {
            self.pictures.extend(self.complete.take());
        }
    }

    /// Gives each core a turn.
    fn turn(&mut self, rows: usize) -> Result<(), Fault> {
        let end = self.runners[0].time + TURN;
        for number in 0..self.runners.len() {
            self.system.core = number;
            self.turn_of(number, end, rows)?;
        }
        self.system.now = end;
        self.system.advance()
    }

    fn turn_of(&mut self, number: usize, end: u64, rows: usize) -> Result<(), Fault> {
        let is_on = self.runners[number].is_on;
        if is_on && !self.runners[number].core.is_asleep(&mut self.system) {
            self.runners[number].core.begin_turn(&mut self.system);
            self.step_until(number, end, rows)?;
        }
        let runner = &mut self.runners[number];
        runner.time = runner.time.max(end);
        Ok(())
    }

    fn step_until(&mut self, number: usize, end: u64, rows: usize) -> Result<(), Fault> {
        loop {
            let Self {
                runners, system, ..
            } = self;
            let runner = &mut runners[number];
            system.now = runner.time;
            system.pc = runner.core.pc();
            runner.time += runner.core.step(system)?;
            runner.instructions += 1;
            system.check()?;
            runner.core.check(system)?;
            let is_asleep = runner.core.is_asleep(system);
            let is_over = runner.time >= end || is_asleep;
            if let Some(start) = system.start.take() {
                self.switch_second(start);
            }
            self.notice(rows);
            if is_over {
                return Ok(());
            }
        }
    }

    fn switch_second(&mut self, start: Option<[u32; 3]>) {
        let [first, second] = &mut self.runners[..] else {
            return;
        };
        second.is_on = start.is_some();
        if let Some(start) = start {
            second.core.start(&mut self.system, start);
            second.time = first.time;
        }
    }

    /// Notices a row that is finished, and the picture with it.
    fn notice(&mut self, rows: usize) {
        let Some(y) = self.system.wires.panel.take_finished_row() else {
            return;
        };
        let is_lit = self.system.wires.is_lit();
        let bus = self.system.chip.bus_time();
        if is_lit && y == 0 {
            (self.rows, self.bus) = (0, bus);
        }
        self.rows += usize::from(is_lit && y == self.rows);
        if self.rows >= rows {
            self.complete = Some(Picture {
                pixels: self.system.wires.panel.picture().to_vec(),
                cycles: self.runners[self.system.core].time,
                instructions: self.instructions(),
                bus: bus.since(self.bus),
            });
        }
    }

    fn instructions(&self) -> u64 {
        self.runners.iter().map(|it| it.instructions).sum()
    }
}

impl<C> Runner<C> {
    fn new(core: C) -> Self {
        Self {
            core,
            is_on: false,
            time: 0,
            instructions: 0,
        }
    }
}
