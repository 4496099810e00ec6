//! Makes a missing linker script an error. Without one, the linker would keep nothing of the program
//! and link an empty firmware.

unsafe extern "C" {
    /// Where the stack begins: a symbol of cortex-m-rt's linker script, and of nothing else.
    static _stack_start: u32;
}

/// Where a linker without a script begins. With the script the program begins at its reset handler,
/// and this is left out.
#[unsafe(export_name = "_start")]
extern "C" fn start() -> *const u32 {
    &raw const _stack_start
}
