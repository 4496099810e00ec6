//! Tests the playground in headless Chromium, as people use it: from its file, on a desk and on a
//! telephone.

#![cfg(test)]

mod copied;
mod driver;
mod site;

use driver::Tab;
use serde_json::{Value, json};
use site::{address, built, kept_hashes};

#[test]
fn page_opens_from_its_file_without_a_word_in_the_log() {
    let tab = Tab::open();
    tab.visit(address());
    let first = tab.run("return performance.getEntriesByName('first picture')[0].startTime;");
    let first = first.as_f64().unwrap();
    println!("from opening to the first picture: {first:.0} ms");
    assert_eq!(tab.log(), Vec::<Value>::new());
}

#[test]
fn page_is_no_larger_than_it_may_be() {
    let size = built().1.rsplit("index.html: ").next().unwrap();
    println!("{}", size.trim());
    let [_, page, _, wasm] = numbers(size)[..] else {
        panic!("{size}");
    };
    assert!(page <= 350_000.0 && wasm <= 200_000.0, "{size}");
}

#[test]
fn scenes_have_the_hashes_of_the_boards_and_their_copies_in_rust_draw_the_same() {
    let (tab, kept) = (Tab::open(), kept_hashes());
    tab.visit(address());
    let (mut names, mut hashes, mut sources) = (Vec::new(), Vec::new(), Vec::new());
    for (value, name) in tab.scenes() {
        tab.choose("scene", &value);
        sources.push(tab.text("return await window.reflet.rust();"));
        hashes.push(tab.hash());
        let shown = json!([hashes.last(), kept.get(&name)]);
        tab.wait_for(&format!(
            "const [here, board] = {shown}, shown = (id) => document.getElementById(id).textContent;
             return shown('hash') === here && (board === null || here === board && shown('hash-board') === board);"
        ));
        names.push(name);
    }
    let boards = kept.iter().filter(|(name, _)| names.contains(*name));
    let are_all = boards.count() == kept.len() && names.len() > kept.len();
    assert!(are_all, "{names:?}");
    assert_eq!(names[0], "castle");
    assert_eq!(copied::run(&sources), hashes, "{names:?}");
    assert_eq!(tab.log(), Vec::<Value>::new());
}

#[test]
fn edits_are_drawn_and_a_mistake_is_shown_at_its_line() {
    let tab = Tab::open();
    tab.visit(address());
    let before = (tab.hash(), tab.text("return window.reflet.text();"));
    let edited = before.1.replacen("[0.7, 0.6, 0]", "[0.1, 0.6, 0.9]", 1);
    assert_ne!(edited, before.1);
    assert_eq!(tab.edit(&edited), "ready");
    assert_ne!(tab.hash(), before.0);
    let line = edited.lines().position(|line| line.contains("\"radius\""));
    let line = line.unwrap() + 1;
    let mistake = edited.replacen("\"radius\"", "\"radios\"", 1);
    assert_eq!(tab.edit(&mistake), "error");
    assert!(tab.text_of("error").contains("radios"));
    assert_eq!(numbers(&tab.text_of("error-line")), [line as f64]);
    assert_eq!(tab.edit(&before.1), "ready");
    assert_eq!(tab.hash(), before.0);
    assert_eq!(tab.text_of("error"), "");
}

#[test]
fn table_of_a_path_sums_to_the_colour_of_the_pixel() {
    let tab = Tab::open();
    tab.visit(address());
    tab.choose("quality", "1");
    for (x, y) in [(160, 250), (100, 120), (20, 10)] {
        tab.choose("pixel-x", &x.to_string());
        tab.choose("pixel-y", &y.to_string());
        let rows = tab.run(
            "return [...document.querySelectorAll('#path-table tr')].map((row) => row.cells[5].textContent);",
        );
        let mut sum = [0.0; 3];
        for row in rows.as_array().unwrap() {
            let adds = numbers(row.as_str().unwrap());
            (0..3).for_each(|at| sum[at] += adds[at]);
        }
        let shown = numbers(&tab.text_of("path-sum"));
        let is_shown = |at: usize| (sum[at] - shown[at]).abs() < 0.002;
        assert!((0..3).all(is_shown), "{rows}: {sum:?}, {shown:?}");
        let pixel = tab.run(&format!(
            "const it = document.getElementById('picture').getContext('2d');
             return [...it.getImageData({x}, {y}, 1, 1).data].slice(0, 3);"
        ));
        let levels = numbers(&tab.text_of("path-pixel"));
        let bytes: Vec<_> = levels.iter().map(|&it| it as u8).collect();
        assert_eq!(json!(bytes), pixel, "{x}, {y}");
        let near = |at: usize| (255.0 * sum[at].clamp(0.0, 1.0) - levels[at]).abs() <= 1.5;
        assert!((0..3).all(near), "{sum:?}, {levels:?}");
    }
}

#[test]
fn everything_can_be_reached_on_a_telephone() {
    let tab = Tab::narrow();
    tab.visit(address());
    let unreached = tab.run(
        "const page = document.documentElement;
         if (innerWidth !== 390 || page.scrollWidth > innerWidth) return [innerWidth, page.scrollWidth];
         const all = [...document.querySelectorAll('button, select, input, textarea, canvas, summary, a[href]')];
         if (all.length < 20) return all.length;
         return all.filter((it) => it.checkVisibility() && !it.matches('.skip') && !it.closest('dialog')).filter((it) => {
           it.scrollIntoView({ block: 'center', behavior: 'instant' });
           const box = it.getBoundingClientRect();
           const top = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
           const is = (found) => found && (it.contains(found) || found.contains(it) && found.closest('label, .frame'));
           return box.left < 0 || box.right > innerWidth + 0.5 || !is(top);
         }).map((it) => it.outerHTML.slice(0, 80));",
    );
    assert_eq!(unreached, json!([]));
}

#[test]
fn link_restores_the_scene_that_it_contains() {
    let tab = Tab::open();
    tab.visit(address());
    let text =
        tab.text("return window.reflet.text();")
            .replacen("[0.7, 0.6, 0]", "[0.1, 0.6, 0.9]", 1);
    assert_eq!(tab.edit(&text), "ready");
    let hash = tab.hash();
    let link = tab.text(
        "let copied = null;
         const clipboard = { writeText: async (text) => { copied = text; } };
         Object.defineProperty(navigator, 'clipboard', { value: clipboard, configurable: true });
         document.getElementById('copy-link').click();
         while (copied === null) await new Promise((it) => setTimeout(it, 20));
         return copied;",
    );
    tab.visit(&link);
    assert_eq!(tab.text("return window.reflet.text();"), text);
    assert_eq!(tab.hash(), hash);
}

#[test]
fn every_setting_is_drawn_and_the_camera_orbits_and_zooms() {
    let tab = Tab::open();
    tab.visit(address());
    for id in ["preset", "quality", "shading", "smooth"] {
        let values = tab.run(&format!(
            "return [...document.getElementById('{id}').options].map((it) => it.value);"
        ));
        let values = values.as_array().unwrap();
        assert!(values.len() > 1, "{id}");
        for value in values {
            tab.choose(id, value.as_str().unwrap());
        }
    }
    tab.choose("n", "0");
    let mut hashes = vec![tab.hash()];
    for event in [
        "new KeyboardEvent('keydown', { key: 'ArrowUp', bubbles: true })",
        "new WheelEvent('wheel', { deltaY: 100 })",
    ] {
        let body = format!("document.getElementById('picture').dispatchEvent({event});");
        tab.run(&body);
        assert_eq!(tab.settled(), "ready");
        assert!(!hashes.contains(&tab.hash()), "{event}");
        hashes.push(tab.hash());
    }
    for id in ["row-bars", "errors-chart"] {
        let element = format!("document.getElementById('{id}')");
        tab.run(&format!("{element}.scrollIntoView();"));
        tab.wait_for(&format!("return {element}.childElementCount > 0;"));
    }
    assert_eq!(tab.log(), Vec::<Value>::new());
}

fn numbers(text: &str) -> Vec<f64> {
    let parts = text.replace('\u{2212}', "-");
    let parts = parts.split(|letter: char| !letter.is_ascii_digit() && !".-e".contains(letter));
    let parts = parts.map(|part| part.trim_end_matches('.'));
    parts.filter_map(|part| part.parse().ok()).collect()
}
