//! Counts executed instructions.

/// Counter of executed instructions; it starts with the program.
pub struct Clock {
    /// Instructions between two readings of the clock in a row, which every difference contains.
    overhead: u32,
}

#[derive(Clone, Copy)]
pub struct Reading(u32);

impl Clock {
    /// Starts the clock, which counts executed instructions.
    pub fn start() -> Self {
        source::start();
        let mut clock = Self { overhead: 0 };
        clock.overhead = clock.since(clock.now());
        clock
    }

    #[inline(always)]
    pub fn now(&self) -> Reading {
        Reading(source::now())
    }

    /// Returns the instructions since a reading, up to 1.3 thousand million. The caller must keep the
    /// measured work between the readings with [`core::hint::black_box`].
    #[inline(always)]
    pub fn since(&self, start: Reading) -> u32 {
        let ticks = source::now().wrapping_sub(start.0);
        source::instructions(ticks) - self.overhead
    }
}

#[cfg(target_arch = "arm")]
mod source {
    //! The first timer of an MPS2 board, 32 bits wide.
    //!
    //! QEMU runs with `-icount shift=7`: the machine's clock advances by 128 ns with every
    //! instruction, so this timer ticks more than twice, and rounding gives the exact count.

    use core::ptr;

    /// Whether the board is the AN505 with its Cortex-M33.
    const AN505: bool = cfg!(an505);

    const TIMER: *mut u32 = if AN505 { 0x5000_0000 } else { 0x4000_0000 } as *mut u32;
    const CONTROL: usize = 0;
    const VALUE: usize = 1;
    const RELOAD: usize = 2;

    const NANOSECONDS_PER_TICK: u64 = if AN505 { 50 } else { 40 };
    const NANOSECONDS_PER_INSTRUCTION: u64 = 1 << 7;

    pub fn start() {
        // Sound: these are the timer's registers, and nobody else uses them.
        unsafe {
            TIMER.add(RELOAD).write_volatile(u32::MAX);
            TIMER.add(VALUE).write_volatile(u32::MAX);
            TIMER.add(CONTROL).write_volatile(1);
        }
    }

    #[inline(always)]
    pub fn now() -> u32 {
        // It counts down. Sound: reading it changes nothing.
        u32::MAX - unsafe { ptr::read_volatile(TIMER.add(VALUE)) }
    }

    pub fn instructions(ticks: u32) -> u32 {
        let nanoseconds = u64::from(ticks) * NANOSECONDS_PER_TICK;
        ((nanoseconds + NANOSECONDS_PER_INSTRUCTION / 2) / NANOSECONDS_PER_INSTRUCTION) as u32
    }
}

#[cfg(target_arch = "riscv32")]
mod source {
    //! The core's own count.

    pub fn start() {}

    #[inline(always)]
    pub fn now() -> u32 {
        riscv::register::minstret::read() as u32
    }

    pub fn instructions(ticks: u32) -> u32 {
        ticks
    }
}
