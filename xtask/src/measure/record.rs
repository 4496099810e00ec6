//! The figures that are kept in the repository: every built-in scene on every core, a file a core
//! in `docs/measured`, and the page `docs/boards.md` made of them.

use std::thread;

use anyhow::Result;
use reflet::scenes;

use super::{CORES, Core, Figures, Quality, Scene, Size, Task};
use super::{frames, measure, moving_record, page};
use crate::{kept, root};

/// How everything is measured, but for the quality.
const SIZE: Size = Size::new(64, 64);

/// Measures one core or all of them again, and writes their files and the page.
pub fn renew(core: Option<&'static Core>) -> Result<()> {
    let is_meant = |it: &&Core| core.is_none_or(|core| core == *it);
    // Cores of different targets are built in different places, so they do not wait for each other.
    let renewed: Vec<Result<()>> = thread::scope(|scope| {
        let cores = CORES.iter().filter(is_meant);
        let threads: Vec<_> = cores.map(|core| scope.spawn(|| renew_core(core))).collect();
        let threads = threads.into_iter();
        threads
            .map(|it| it.join().expect("no measurement panics"))
            .collect()
    });
    renewed.into_iter().collect::<Result<()>>()?;
    if core.is_none_or(|core| moving_record::CORE_NAMES.contains(&core.name)) {
        moving_record::renew()?;
    }
    renew_page()
}

pub(super) fn renew_page() -> Result<()> {
    kept::write(&root().join("docs/boards.md"), &page()?)
}

fn page() -> Result<String> {
    let rows = CORES.iter().map(read).collect::<Result<Vec<_>>>()?;
    Ok(page::write(
        &rows.concat(),
        &moving_record::read()?,
        &frames::read()?,
    ))
}

fn renew_core(core: &'static Core) -> Result<()> {
    let mut rows = Vec::new();
    for task in tasks(core) {
        let figures = measure(&task)?;
        println!(
            "{:<4} {:<18} {:<5} {:>10.1} instructions a pixel",
            figures.core, figures.scene, figures.quality, figures.instructions_per_pixel
        );
        rows.push(figures);
    }
    kept::write_lines(&file(core), &rows)
}

pub fn tasks(core: &'static Core) -> Vec<Task> {
    let qualities: &[Quality] = match core.name {
        "m3" | "m4f" => &[Quality::FAST, Quality::Float],
        _ => &[Quality::FAST],
    };
    let tasks = scenes::NAMES.into_iter().flat_map(|name| {
        let task = move |&quality| Task::new(core, Scene::BuiltIn(name), SIZE, quality);
        qualities.iter().map(task)
    });
    tasks.collect()
}

pub fn read(core: &Core) -> Result<Vec<Figures>> {
    kept::read(&file(core), &format!("measure --all --core {}", core.name))
}

fn file(core: &Core) -> String {
    format!("docs/measured/{}.jsonl", core.name)
}

#[cfg(test)]
mod tests {
    use std::fs;

    #[test]
    fn page_about_boards_has_the_kept_figures() {
        let page = fs::read_to_string(crate::root().join("docs/boards.md")).unwrap();
        assert!(page == super::page().unwrap(), "docs/boards.md is old");
    }
}
