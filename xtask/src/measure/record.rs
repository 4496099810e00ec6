//! The figures that are kept in the repository: every built-in scene on every core, a file a core
//! in `docs/measured`, and the page `docs/boards.md` made of them.

use std::{
    fs,
    path::{Path, PathBuf},
    thread,
};

use anyhow::{Context, Result, bail};
use reflet::scenes;

use super::{
    cores::{CORES, Core},
    figures::Figures,
    measure, page,
    scene::Scene,
    task::{Quality, Settings, Shading, Size, Task},
};
use crate::root;

/// How everything is measured, but for the quality.
const SIZE: Size = Size {
    width: 64,
    height: 64,
};
const REFLECTIONS: u8 = 4;
const SHADING: Shading = Shading::BlinnPhong;

/// Measures one core or all of them again, and writes their files and the page.
pub fn renew(core: Option<&'static Core>) -> Result<()> {
    let is_meant = |it: &&Core| core.is_none_or(|core| core == *it);
    // Cores of different targets are built in different places, so they do not wait for each other.
    let renewed: Vec<Result<()>> = thread::scope(|scope| {
        let cores = CORES.iter().filter(is_meant);
        let threads: Vec<_> = cores.map(|core| scope.spawn(|| renew_core(core))).collect();
        let results = threads.into_iter().map(|thread| thread.join());
        results
            .map(|result| result.expect("no measurement panics"))
            .collect()
    });
    renewed.into_iter().collect::<Result<()>>()?;
    let rows = CORES.iter().map(read).collect::<Result<Vec<_>>>()?;
    write(&root().join("docs/boards.md"), &page::write(&rows.concat()))
}

fn renew_core(core: &'static Core) -> Result<()> {
    let mut lines = String::new();
    for task in tasks(core) {
        let figures = measure(&task)?;
        println!(
            "{:<4} {:<18} {:<5} {:>10.1} instructions a pixel",
            figures.core, figures.scene, figures.quality, figures.instructions_per_pixel
        );
        lines += &figures.json()?;
        lines.push('\n');
    }
    write(&file(core), &lines)
}

/// All that is measured on a core.
pub fn tasks(core: &'static Core) -> Vec<Task> {
    let qualities: &[Quality] = match core.name {
        "m3" | "m4f" => &[Quality::Fast, Quality::Fine, Quality::Float],
        _ => &[Quality::Fast, Quality::Fine],
    };
    let tasks = scenes::NAMES.into_iter().flat_map(|name| {
        qualities.iter().map(move |&quality| Task {
            core,
            scene: Scene::BuiltIn(name),
            settings: Settings {
                size: SIZE,
                reflections: REFLECTIONS,
                shading: SHADING,
                quality,
                is_whole: false,
            },
        })
    });
    tasks.collect()
}

/// The figures of a core as they are kept.
pub fn read(core: &Core) -> Result<Vec<Figures>> {
    let file = file(core);
    let text = match fs::read_to_string(&file) {
        Ok(text) => text,
        Err(_) => bail!(
            "there is no {}: `cargo xtask measure --all --core {}` writes it",
            file.display(),
            core.name
        ),
    };
    let figures = |line| serde_json::from_str(line);
    let rows: Result<Vec<_>, _> = text.lines().map(figures).collect();
    rows.with_context(|| format!("{} is not what the command writes", file.display()))
}

fn file(core: &Core) -> PathBuf {
    root().join(format!("docs/measured/{}.jsonl", core.name))
}

fn write(file: &Path, text: &str) -> Result<()> {
    let folder = file.parent().unwrap_or(file);
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(file, text))
        .with_context(|| format!("cannot write {}", file.display()))?;
    println!("{}", file.display());
    Ok(())
}
