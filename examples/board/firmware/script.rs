//! Makes a missing linker script an error. Without one, the linker would leave out the whole program
//! and link an empty firmware.

unsafe extern "C" {
    /// Start of the stack: a symbol that only cortex-m-rt's linker script defines.
    static _stack_start: u32;
}

/// Entry point for a linker without a script. With the script, the program starts at its reset
/// handler, and this function is left out.
#[unsafe(export_name = "_start")]
extern "C" fn start() -> *const u32 {
    &raw const _stack_start
}
