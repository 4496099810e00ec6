//! What all chips have in common: registers, pins, and what an access brings about.

pub mod bus_time;
pub mod rp;
pub mod rp2040;
pub mod rp2350;
pub mod stm32f411;

use self::bus_time::BusTime;
use crate::fault::Fault;
use crate::memory::Memory;
use crate::wires::{Pin, Pins, Sent};

#[derive(Clone, Copy, Debug)]
pub struct Access {
    pub address: u32,
    /// Bytes: 1, 2 or 4.
    pub size: usize,
    pub core: usize,
    /// Time in cycles.
    pub now: u64,
}

/// What a write brings about outside of the registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    None,
    /// Pins may have changed.
    Pins,
    /// The SPI sends a byte.
    Sent(Sent),
    /// A core that waits for an event goes on.
    Wake(usize),
    /// The second core is switched off.
    Stop,
    /// The second core starts with this vector table, stack and entry.
    Start([u32; 3]),
}

pub trait Chip: Pins {
    fn read(&mut self, access: Access) -> Result<u32, Fault>;
    fn write(&mut self, access: Access, value: u32) -> Result<Effect, Fault>;
    /// Whether a byte is on its way.
    fn is_sending(&self, now: u64) -> bool;
    /// Sets the level at an input from outside.
    fn set_input(&mut self, pin: Pin, level: bool);
    /// Returns the time of the bus so far.
    fn bus_time(&self) -> BusTime;
    /// Lets what works beside the cores work until now. Returns the next byte that it sends.
    fn advance(&mut self, memory: &Memory, now: u64) -> Result<Option<Sent>, Fault>;
}
