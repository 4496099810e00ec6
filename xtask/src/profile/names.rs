//! Finds the functions at an address of a program, inlined ones too, from its debug information.

use std::{collections::BTreeSet, fs, ops::Range, path::Path};

use addr2line::Loader;
use anyhow::{Context, Result, anyhow};
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};

use crate::root;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Path of the function, without the hash of its symbol.
    pub name: String,
    /// File and line of the instruction, `FILE:LINE`, if the debug information has them.
    pub line: Option<String>,
}

pub struct Names {
    debug: Loader,
    /// The linked functions, sorted by address: first address, size in bytes, and name.
    functions: Vec<(u32, u32, String)>,
    pub code: Range<u32>,
}

impl Names {
    pub fn read(program: &Path) -> Result<Self> {
        let unreadable = || format!("cannot read {}", program.display());
        let bytes = fs::read(program).with_context(unreadable)?;
        let file = object::File::parse(&*bytes).with_context(unreadable)?;
        let symbols = file
            .symbols()
            .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0);
        let function = |symbol: object::Symbol| {
            let name = demangled(symbol.name().ok()?);
            // The lowest bit of a symbol's address marks Thumb code.
            Some((symbol.address() as u32 & !1, symbol.size() as u32, name))
        };
        let mut functions: Vec<_> = symbols.filter_map(function).collect();
        functions.sort_unstable();
        let debug = Loader::new(program).map_err(|error| anyhow!("{error}"));
        let text = file.sections().filter(|it| it.kind() == SectionKind::Text);
        let ends = |it: object::Section| [it.address(), it.address().saturating_add(it.size())];
        let ends: Vec<_> = text.flat_map(ends).map(|end| end as u32).collect();
        let [start, end] = [ends.iter().min(), ends.iter().max()].map(|end| end.copied());
        Ok(Self {
            debug: debug.with_context(unreadable)?,
            functions,
            code: start.unwrap_or(0)..end.unwrap_or(0),
        })
    }

    /// Returns the linked function that contains an address: its first address and its name.
    pub fn function(&self, address: u32) -> Option<(u32, &str)> {
        let after = self
            .functions
            .partition_point(|(start, _, _)| *start <= address);
        let (start, size, name) = self.functions.get(after.checked_sub(1)?)?;
        (address - start < *size).then_some((*start, name.as_str()))
    }

    /// Returns the names of all functions that have instructions in the program, inlined ones too.
    pub fn all(&self) -> Result<BTreeSet<String>> {
        let mut names = BTreeSet::new();
        for address in self.code.clone().step_by(2) {
            if self.function(address).is_some() {
                names.extend(self.frames(address)?.into_iter().map(|frame| frame.name));
            }
        }
        Ok(names)
    }

    /// Returns the functions at an address: the innermost first, the linked function last.
    pub fn frames(&self, address: u32) -> Result<Vec<Frame>> {
        let unknown = || format!("the debug information of {address:#x} is broken");
        let found = self.debug.find_frames(u64::from(address));
        let mut found = found
            .map_err(|error| anyhow!("{error}"))
            .with_context(unknown)?;
        let mut frames = Vec::new();
        while let Some(frame) = found.next()? {
            let Some(function) = &frame.function else {
                continue;
            };
            let name = demangled(&function.raw_name().with_context(unknown)?);
            let line = frame.location.and_then(|location| {
                let (file, line) = (Path::new(location.file?), location.line?);
                let file = file.strip_prefix(root()).unwrap_or(file);
                Some(format!("{}:{line}", file.display()))
            });
            frames.push(Frame { name, line });
        }
        if frames.is_empty() {
            // Assembly, and functions that the compiler adds, have a symbol but no debug
            // information.
            frames.extend(self.function(address).map(|(_, name)| Frame {
                name: name.to_owned(),
                line: None,
            }));
        }
        Ok(frames)
    }
}

/// Converts a symbol to Rust's spelling, without the hash.
fn demangled(symbol: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol))
}
