//! The registers of a chip: a table names each, and those that need no function keep what is written.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

use crate::fault::{Fault, fault, require};

/// One register, or several that repeat at a stride.
#[derive(Clone, Copy, Debug)]
pub struct Register {
    offset: u32,
    reset: u32,
    count: u32,
    stride: u32,
}

/// A register with its value after a reset.
pub const fn register(offset: u32, reset: u32) -> Register {
    Register {
        offset,
        reset,
        count: 1,
        stride: 4,
    }
}

/// Registers one after another, 0 after a reset.
pub const fn registers(offset: u32, count: u32) -> Register {
    Register {
        count,
        ..register(offset, 0)
    }
}

impl Register {
    /// The register repeats at a stride in bytes.
    pub const fn repeated(self, count: u32, stride: u32) -> Self {
        Self {
            count,
            stride,
            ..self
        }
    }
}

/// What has to be switched on before a block answers: bits of a register, and their wanted value.
#[derive(Clone, Copy, Debug)]
pub struct Gate {
    pub register: u32,
    pub mask: u32,
    pub open: u32,
    /// What is missing if the gate is shut.
    pub missing: &'static str,
}

/// Registers of one peripheral. `kind` tells the chip which.
#[derive(Clone, Copy, Debug)]
pub struct Block<K: 'static> {
    pub name: &'static str,
    pub kind: K,
    pub base: u32,
    pub gate: Option<Gate>,
    pub registers: &'static [Register],
}

/// Returns a block that always answers, without registers.
pub const fn block<K>(name: &'static str, kind: K, base: u32) -> Block<K> {
    Block {
        name,
        kind,
        base,
        gate: None,
        registers: &[],
    }
}

impl<K: Copy> Block<K> {
    pub const fn with(self, registers: &'static [Register]) -> Self {
        Self { registers, ..self }
    }

    pub const fn behind(self, gate: Gate) -> Self {
        let gate = Some(gate);
        Self { gate, ..self }
    }
}

/// Where an address lies: the kind of the block, and the offset in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place<K> {
    pub kind: K,
    pub offset: u32,
}

struct Cell<K: 'static> {
    block: &'static Block<K>,
    value: u32,
}

/// All registers of a chip, with their values.
pub struct Registers<K: 'static> {
    cells: HashMap<u32, Cell<K>, BuildHasherDefault<AddressHasher>>,
}

impl<K: Copy> Registers<K> {
    /// Creates the registers of a table as they are after a reset.
    pub fn new(blocks: &'static [Block<K>]) -> Self {
        let mut cells = HashMap::default();
        for block in blocks {
            for it in block.registers {
                for index in 0..it.count {
                    let address = block.base + it.offset + index * it.stride;
                    let value = it.reset;
                    cells.insert(address, Cell { block, value });
                }
            }
        }
        Self { cells }
    }

    /// Finds an address. It is a fault if no table names it, or if its block is not switched on.
    pub fn find(&self, address: u32) -> Result<Place<K>, Fault> {
        let cell = self.cells.get(&address);
        let Cell { block, .. } = cell.ok_or_else(|| fault!("no register at {address:#010x}"))?;
        if let Some(gate) = block.gate {
            require!(
                self.get(gate.register) & gate.mask == gate.open,
                "{} at {address:#010x}: {}",
                block.name,
                gate.missing
            );
        }
        Ok(Place {
            kind: block.kind,
            offset: address - block.base,
        })
    }

    /// Returns a value. Registers that no table names are 0.
    pub fn get(&self, address: u32) -> u32 {
        self.cells.get(&address).map_or(0, |cell| cell.value)
    }

    /// Sets a value. Returns the old one.
    pub fn set(&mut self, address: u32, value: u32) -> u32 {
        match self.cells.get_mut(&address) {
            Some(cell) => std::mem::replace(&mut cell.value, value),
            None => 0,
        }
    }
}

/// Hashes an address by a product: a firmware looks at registers a million times.
#[derive(Default)]
struct AddressHasher(u64);

impl Hasher for AddressHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.write_u32((*byte).into()));
    }

    fn write_u32(&mut self, address: u32) {
        // 2^64 divided by the golden ratio.
        let product = (self.0 ^ u64::from(address)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = product ^ product >> 32;
    }
}
