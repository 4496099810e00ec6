//! Counts executed instructions.

use core::hint::black_box;

/// A running count of instructions.
pub struct Clock {
    /// What reading it twice costs.
    overhead: u32,
}

impl Clock {
    /// Starts to count.
    pub fn start() -> Self {
        source::start();
        let mut clock = Self { overhead: 0 };
        clock.overhead = clock.count(|| ()).0;
        clock
    }

    /// The instructions that `work` takes, up to 1.3 thousand million, and its result.
    #[inline(always)]
    pub fn count<R>(&self, work: impl FnOnce() -> R) -> (u32, R) {
        let start = source::now();
        let result = black_box(work());
        let ticks = source::now().wrapping_sub(start);
        (source::instructions(ticks) - self.overhead, result)
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
