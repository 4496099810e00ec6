//! `cargo xtask playground`: builds the page in which people try reflet in a browser.
//!
//! The page is one file that needs no network: [`page`] fills it with its scripts, its data and the
//! library, compiled to WebAssembly. `command_line` writes the built-in scenes as scene files, and [`data`]
//! gathers what the page shows.

mod data;
mod page;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::Result;
use clap::Args;
use flate2::{Compression, write::GzEncoder};

use crate::{misuse::Misuse, print, root, toolchain};

/// Builds the playground: a page that draws scenes in a browser, as a folder of static files.
#[derive(Args, Debug)]
pub struct Arguments {
    /// Folder for the files [default: playground in cargo's target folder]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The package that is compiled to WebAssembly.
const PACKAGE: &str = "xtask/playground";

pub fn run(arguments: &Arguments) -> Result<()> {
    let default = || toolchain::target_directory().join("playground");
    let folder = arguments.out.clone().unwrap_or_else(default);
    let refused = |error| Misuse::new(format!("--out {}: {error}", folder.display()));
    fs::create_dir_all(&folder).map_err(refused)?;
    let wasm = fs::read(toolchain::build_wasm(Path::new(PACKAGE))?)?;
    let page = page::fill(&root().join(PACKAGE).join("page"), &wasm, &data::json()?)?;
    let file = folder.join("index.html");
    let refused = |error| Misuse::new(format!("cannot write {}: {error}", file.display()));
    fs::write(&file, &page).map_err(refused)?;
    let (whole, alone) = (zipped(page.as_bytes())?, zipped(&wasm)?);
    print(format!(
        "{}: {} bytes, {whole} gzipped; the wasm alone: {} bytes, {alone} gzipped\n",
        file.display(),
        page.len(),
        wasm.len(),
    ))
}

/// Returns the number of bytes after compression, as web servers compress.
fn zipped(bytes: &[u8]) -> Result<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_as_folder_is_a_mistake() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let out = Some(file.path().to_owned());
        let error = run(&Arguments { out }).unwrap_err();
        assert!(error.is::<Misuse>(), "{error:#}");
        assert!(error.to_string().starts_with("--out "), "{error:#}");
    }
}
