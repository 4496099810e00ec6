//! The words for a fault; they end the emulation.

use crate::report;

#[cfg(target_arch = "arm")]
mod arm {
    use cortex_m_rt::{ExceptionFrame, exception};

    #[exception]
    unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
        super::end("HardFault", frame.pc())
    }

    #[exception]
    unsafe fn DefaultHandler(_: i16) -> ! {
        super::end("an exception nobody handles", 0)
    }
}

#[cfg(target_arch = "riscv32")]
#[unsafe(export_name = "ExceptionHandler")]
fn exception(_: &riscv_rt::TrapFrame) -> ! {
    end("an exception", riscv::register::mepc::read() as u32)
}

fn end(name: &str, at: u32) -> ! {
    report::text("fault: ");
    report::text(name);
    report::number(" at ", u64::from(at));
    report::text("\n");
    semihosting::process::exit(1)
}
