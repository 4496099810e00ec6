//! Counts the executed instructions by address, by the calls that led to them, and by the ray that
//! they serve.

use std::{collections::HashMap, ops::Range, path::Path};

use anyhow::{Context, Result};

use super::calls::{Calls, Way};
use super::names::{Frame, Names};
use super::stages::{Ray, Rule};
use crate::cycles::Executed;
use crate::emulator::qemu::Qemu;
use crate::{cycles, measure};

#[derive(Debug)]
struct Known {
    frames: Vec<Frame>,
    /// Rule of the innermost function that has one.
    rule: Option<Rule>,
    /// First address of the linked function that contains the instruction.
    function: Option<u32>,
}

#[derive(Debug)]
pub struct Record {
    pub calls: Calls,
    start: u32,
    /// What is known of each executed instruction, by half words from `start`; `None` before it is
    /// executed.
    known: Vec<Option<Known>>,
    /// How often each instruction was executed, by half words from `start`; one list for each pair
    /// of call chain and ray.
    counts: Vec<Vec<u64>>,
    places: HashMap<(Way, Ray), usize>,
}

impl Record {
    /// Runs a measurement firmware and counts the instructions of its measured part.
    pub fn of(emulator: Qemu, program: &Path, names: &Names) -> Result<Self> {
        let emulator = emulator.limit(measure::RUN_LIMIT);
        let mut record = Self::empty(names);
        let mut ray = Ray::default();
        let mut current = ((Way::ROOT, ray), record.place(Way::ROOT, ray));
        cycles::watch(emulator, program, measure::is_counted, |code, executed| {
            let Executed { before, now, .. } = executed;
            let index = record.know(now, names)?;
            match before {
                None => record.calls.end(),
                Some(before) => {
                    let back = before + code.size(before);
                    if now != back {
                        record.jump(before, now, code.calls(before).then_some(back));
                    }
                }
            }
            let known = record.known.get(index).and_then(Option::as_ref);
            ray = ray.after(known.and_then(|known| known.rule));
            let surroundings = (record.calls.way(), ray);
            if surroundings != current.0 {
                current = (surroundings, record.place(surroundings.0, ray));
            }
            record.counts[current.1][index] += 1;
            Ok(())
        })?;
        Ok(record)
    }

    /// Returns every executed instruction: its call chain, its ray, its address, and how often it
    /// was executed.
    pub fn all(&self) -> impl Iterator<Item = (Way, Ray, u32, u64)> {
        self.places.iter().flat_map(|(&(way, ray), &place)| {
            let counts = self.counts[place].iter().zip((self.start..).step_by(2));
            let executed = counts.filter(|(count, _)| **count > 0);
            executed.map(move |(&count, address)| (way, ray, address, count))
        })
    }

    /// Returns the functions that an instruction belongs to, the innermost first: those at its
    /// address, then those at the call that led there, and so on.
    pub fn frames(&self, mut way: Way, address: u32) -> Vec<&Frame> {
        let at = |address| self.at(address).map_or(&[][..], |known| &known.frames);
        let mut frames: Vec<_> = at(address).iter().collect();
        while let Some(call) = self.calls.call(way) {
            frames.extend(at(call.site));
            way = call.way;
        }
        frames
    }

    fn empty(names: &Names) -> Self {
        let Range { start, end } = names.code;
        let known = (start..end).step_by(2).map(|_| None).collect();
        Self {
            calls: Calls::default(),
            start,
            known,
            counts: Vec::new(),
            places: HashMap::new(),
        }
    }

    /// Records a jump as a call, a return or a tail call. `back` is the return address if the jump
    /// is a call instruction. A call instruction whose target is inside the same function is only a
    /// long jump: a Cortex-M0 has no other way to jump so far.
    fn jump(&mut self, from: u32, to: u32, back: Option<u32>) {
        let function = |address| self.at(address).and_then(|known| known.function);
        let (left, entered) = (function(from), function(to));
        let is_entry = entered.is_none_or(|start| start == to);
        match back {
            Some(back) if is_entry => self.calls.enter(from, to, back),
            _ if self.calls.leave(to) => {}
            _ if is_entry && left != entered => self.calls.replace(from, to),
            _ => {}
        }
    }

    fn at(&self, address: u32) -> Option<&Known> {
        let index = address.checked_sub(self.start)? / 2;
        self.known.get(index as usize)?.as_ref()
    }

    /// Returns the index of an address in `known`. Looks the address up in the debug information the
    /// first time.
    fn know(&mut self, address: u32, names: &Names) -> Result<usize> {
        let index = (address.wrapping_sub(self.start) / 2) as usize;
        let known = self.known.get_mut(index);
        let known = known.with_context(|| format!("there is no code at {address:#x}"))?;
        if known.is_none() {
            let frames = names.frames(address)?;
            *known = Some(Known {
                rule: frames.iter().find_map(|frame| Rule::of(&frame.name)),
                frames,
                function: names.function(address).map(|(start, _)| start),
            });
        }
        Ok(index)
    }

    fn place(&mut self, way: Way, ray: Ray) -> usize {
        let (counts, size) = (&mut self.counts, self.known.len());
        *self.places.entry((way, ray)).or_insert_with(|| {
            counts.push(vec![0; size]);
            counts.len() - 1
        })
    }
}
