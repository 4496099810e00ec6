//! Selects the executed instructions to count: those of some functions, and of all functions they
//! call.

use object::{Object, ObjectSymbol};

use super::decode::Code;

/// Returns the addresses of the functions whose symbols are `wanted`.
pub fn functions(program: &object::File, wanted: impl Fn(&str) -> bool) -> Vec<u32> {
    let symbols = program.symbols();
    let found = symbols.filter(|symbol| symbol.name().is_ok_and(&wanted));
    // The lowest bit of a symbol's address marks Thumb code.
    found.map(|symbol| symbol.address() as u32 & !1).collect()
}

/// Follows the stream of executed addresses, and tells which belong to the watched functions.
#[derive(Default)]
pub struct Watch {
    functions: Vec<u32>,
    last: u32,
    /// Return address of the watched function that is running; `None` outside of watched functions.
    back: Option<u32>,
}

impl Watch {
    /// Watches some functions. Code outside of this list must call them.
    pub fn over(functions: Vec<u32>) -> Self {
        Self {
            functions,
            ..Self::default()
        }
    }

    /// Takes the next executed address, and tests whether it belongs to a watched function or its
    /// callees.
    pub fn sees(&mut self, address: u32, code: &Code) -> bool {
        match self.back {
            Some(back) if back == address => self.back = None,
            None if self.functions.contains(&address) => {
                self.back = Some(self.last + code.size(self.last));
            }
            _ => {}
        }
        self.last = address;
        self.back.is_some()
    }
}
