//! `cargo xtask accuracy`: measures every built-in scene against the double-precision reference
//! and writes what the command line prints into `docs/accuracy.md`.

use std::fmt::Write as _;
use std::time::Duration;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::{command::Program, kept};

const PAGE: &str = "docs/accuracy.md";
const SIZE: &str = "320x320";
const REFLECTIONS: &str = "4";

pub fn run() -> Result<()> {
    let mut page = format!(
        "# How near to the truth\n\n\
         Written by `cargo xtask accuracy` from what `render --check --json` printed: every \
         built-in scene at {SIZE} with {REFLECTIONS} reflections, against the double-precision \
         reference. `same` and `within 1` are the shares of the pixels whose three 8-bit channels \
         all are; PSNR is over all channels (∞: no channel differs); `largest` is the largest \
         difference of a channel.\n\n\
         In `corner1` the rays of a few pixels go exactly through the line where two planes meet: \
         either plane is right there.\n"
    );
    for shading in ["blinn-phong", "phong"] {
        for quality in ["fast", "fine", "small", "exact"] {
            write!(
                page,
                "\n## {shading}, {quality}\n\n\
                 | scene | same | within 1 | PSNR in dB | largest |\n|---|---|---|---|---|\n"
            )?;
            for scene in reflet::scenes::NAMES {
                let row = measure(scene, shading, quality)?;
                println!("{shading} {quality} {row}");
                writeln!(page, "{row}")?;
            }
        }
    }
    kept::write(PAGE.as_ref(), &page)
}

fn measure(scene: &str, shading: &str, quality: &str) -> Result<String> {
    let render = "run --quiet --release --example render --";
    let printed = Program::new("cargo")
        .args(render.split(' '))
        .args([scene, "--size", SIZE, "--reflections", REFLECTIONS])
        .args(["--shading", shading, "--quality", quality])
        .args(["--check", "--json"])
        .limit(Duration::from_secs(600))
        .read()?;
    let figures: Value = serde_json::from_str(&printed)
        .with_context(|| format!("render printed something else than JSON: {printed}"))?;
    let share = |key: &str| -> Result<f64> {
        figures[key]
            .as_f64()
            .with_context(|| format!("render --json printed no `{key}`"))
    };
    let psnr = figures["psnr"]
        .as_f64()
        .map_or_else(|| "∞".to_owned(), |psnr| format!("{psnr:.1}"));
    Ok(format!(
        "| {scene} | {:.3} % | {:.3} % | {psnr} | {} |",
        100.0 * share("same")?,
        100.0 * share("within1")?,
        share("max")?
    ))
}
