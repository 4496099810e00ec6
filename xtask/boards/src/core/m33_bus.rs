//! The bus of a Cortex-M33, as the crate rp2350-emu wants it.

use std::sync::Arc;

use rp2350_emu::core::CoreBus;
use rp2350_emu::threaded::CoreAtomics;

use crate::fault::fault;
use crate::system::System;

/// The instruction CLREX, which forgets what LDREX has marked.
const CLREX: [u16; 2] = [0xf3bf, 0x8f2f];

/// Address at which only CLREX is: the crate has no other way to forget.
pub const CLREX_AT: u32 = 0x0000_0100;

/// Functions of the coprocessor of the RP2350's pins, which is not modelled: a read is 0, a write is a fault.
macro_rules! no_coprocessor {
    ($($read:ident)*; $($write:ident)*) => {
        $(fn $read(&self) -> u32 {
            0
        })*

        $(fn $write(&mut self, _: u32) {
            let fault = fault!("the coprocessor of the pins is not modelled");
            self.fault.get_or_insert(fault);
        })*
    };
}

impl CoreBus for System {
    fn read8(&mut self, address: u32, _: u8) -> u8 {
        self.read(address, 1) as u8
    }

    #[inline]
    fn read16(&mut self, address: u32, _: u8) -> u16 {
        match address.wrapping_sub(CLREX_AT) {
            0 => CLREX[0],
            2 => CLREX[1],
            _ => self.read(address, 2) as u16,
        }
    }

    #[inline]
    fn read32(&mut self, address: u32, _: u8) -> u32 {
        self.read(address, 4)
    }

    fn write8(&mut self, address: u32, value: u8, _: u8) {
        self.write(address, value.into(), 1);
    }

    fn write16(&mut self, address: u32, value: u16, _: u8) {
        self.write(address, value.into(), 2);
    }

    #[inline]
    fn write32(&mut self, address: u32, value: u32, _: u8) {
        self.write(address, value, 4);
    }

    fn atomics(&self) -> &Arc<CoreAtomics> {
        &self.atomics
    }

    // Faults end the run, so the core never sees one.
    fn bus_fault(&self, _: u8) -> bool {
        false
    }

    fn bus_fault_addr(&self, _: u8) -> u32 {
        0
    }

    fn clear_bus_fault(&mut self, _: u8) {}
    fn set_active_pc(&mut self, _: u32, _: u8) {}
    fn set_burst_mode(&mut self, _: bool) {}

    // The flash takes no time: a cache is in front of it.
    fn add_extra_wait_states(&mut self, _: u32) {}

    fn take_extra_wait_states(&mut self) -> u32 {
        0
    }

    fn extra_wait_states(&self) -> u32 {
        0
    }

    fn reset_extra_wait_states(&mut self) {}

    // The crate adds a cycle for a jump into some banks of the RAM, by the lower bits of the address
    // alone. Here code is in the flash, so each fetch follows the one before.
    fn last_fetch_addr(&self) -> u32 {
        self.pc.wrapping_sub(2)
    }

    fn set_last_fetch_addr(&mut self, _: u32) {}

    fn mmio_trace_enabled(&self) -> bool {
        false
    }

    fn emit_mmio_trace(&mut self, _: char, _: u32, _: u32, _: u32, _: u8) {}

    no_coprocessor! {
        gpio_read_out gpio_read_oe gpio_read_in;
        gpio_write_out gpio_set_out gpio_clear_out gpio_xor_out gpio_write_oe gpio_set_oe gpio_clear_oe gpio_xor_oe
    }
}
