//! `cargo xtask playground`: builds the page in which people try reflet in a browser.
//!
//! The page is one file that needs no network: [`page`] fills it with its scripts, its data and the
//! library, compiled to WebAssembly. `command_line` writes the built-in scenes as scene files, [`data`]
//! gathers what the page shows, and [`serve`] shows the page on this machine.

mod data;
mod page;
mod serve;

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

    /// Serves the page on this machine until Ctrl+C [default port: 8000]
    #[arg(long, value_name = "PORT", num_args = 0..=1, default_missing_value = "8000")]
    serve: Option<u16>,
}

/// The package that is compiled to WebAssembly.
const PACKAGE: &str = "xtask/playground";

pub fn run(arguments: &Arguments) -> Result<()> {
    let default = || toolchain::target_directory().join("playground");
    let folder = arguments.out.clone().unwrap_or_else(default);
    make(&folder)?;
    // Before the build, because the port may be taken.
    let server = arguments.serve.map(serve::open).transpose()?;
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
    ))?;
    server.map_or(Ok(()), |server| server.run(&page))
}

/// Makes the folder, unless it is there.
fn make(folder: &Path) -> Result<(), Misuse> {
    let refused = |error| Misuse::new(format!("--out {}: {error}", folder.display()));
    fs::create_dir_all(folder).map_err(refused)
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
    fn file_as_folder_and_a_port_in_use_are_mistakes() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        let port = taken.local_addr().unwrap().port();
        let folder = tempfile::tempdir().unwrap();
        for (out, serve, words) in [
            (file.path(), None, "--out "),
            (folder.path(), Some(port), "--serve "),
        ] {
            let out = Some(out.to_owned());
            let error = run(&Arguments { out, serve }).unwrap_err();
            assert!(error.is::<Misuse>(), "{error:#}");
            assert!(error.to_string().starts_with(words), "{error:#}");
        }
    }
}
