//! The functions that stand at an address of a program, inlined ones too, by its debug
//! information.

use std::{collections::BTreeSet, fs, ops::Range, path::Path};

use addr2line::Loader;
use anyhow::{Context, Result, anyhow};
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};

use crate::root;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Its path, without the hash.
    pub name: String,
    /// The file and line in it, where the debug information says them.
    pub line: Option<String>,
}

pub struct Names {
    debug: Loader,
    /// First address and size of each function, in order.
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
            // The lowest bit of an address says Thumb.
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

    /// The linked function that an address lies in: where it starts and what it is called.
    pub fn function(&self, address: u32) -> Option<(u32, &str)> {
        let after = self
            .functions
            .partition_point(|(start, _, _)| *start <= address);
        let (start, size, name) = self.functions.get(after.checked_sub(1)?)?;
        (address - start < *size).then_some((*start, name.as_str()))
    }

    /// All functions of which anything is left in the program, inlined ones too.
    ///
    /// # Errors
    /// Debug information that cannot be read.
    pub fn all(&self) -> Result<BTreeSet<String>> {
        let mut names = BTreeSet::new();
        for address in self.code.clone().step_by(2) {
            if self.function(address).is_some() {
                names.extend(self.frames(address)?.into_iter().map(|frame| frame.name));
            }
        }
        Ok(names)
    }

    /// The functions that stand at an address, the innermost first, the linked one last.
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
            // Assembly, and what the compiler brings, have nothing but a symbol.
            frames.extend(self.function(address).map(|(_, name)| Frame {
                name: name.to_owned(),
                line: None,
            }));
        }
        Ok(frames)
    }
}

/// A symbol as Rust spells it, without the hash.
fn demangled(symbol: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol))
}
