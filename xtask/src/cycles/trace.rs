//! Which part of what a core executes is looked at: some functions, with all that they call.

use object::{Object, ObjectSymbol};

use super::decode::Code;

/// The addresses of the functions with symbols that are `wanted`.
pub fn functions(program: &object::File, wanted: impl Fn(&str) -> bool) -> Vec<u32> {
    let symbols = program.symbols();
    let found = symbols.filter(|symbol| symbol.name().is_ok_and(&wanted));
    // The lowest bit of an address says Thumb.
    found.map(|symbol| symbol.address() as u32 & !1).collect()
}

/// Looks at a stream of executed addresses.
#[derive(Default)]
pub struct Watch {
    functions: Vec<u32>,
    last: u32,
    /// Where the function that is looked at returns to.
    back: Option<u32>,
}

impl Watch {
    /// Over functions that are called from elsewhere.
    pub fn over(functions: Vec<u32>) -> Self {
        Self {
            functions,
            ..Self::default()
        }
    }

    /// Takes the next address; whether it belongs to what is looked at.
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
