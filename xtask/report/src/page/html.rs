//! The page as one HTML file that holds its plots and pictures.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::{HEADS, Page, Sample, Section};

const STYLE: &str = "\
body { font: 16px/1.5 system-ui, sans-serif; color: #111; background: #fff; max-width: 1120px; \
margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; margin-top: 2.2rem; }
nav a { margin-right: .8rem; }
svg { max-width: 100%; height: auto; display: block; margin: 1rem 0; }
.samples { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; }
figure img { width: 256px; image-rendering: pixelated; display: block; border: 1px solid #ccc; }
figcaption { font-size: .85rem; max-width: 256px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .8rem; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .45rem; border-bottom: 1px solid #ddd; text-align: right; white-space: nowrap; }
th { border-bottom: 2px solid #888; }
td:nth-child(2), th:nth-child(2) { text-align: left; }
tr.float td { background: #faf1ec; }
.use li { font-weight: 600; }
";

/// The whole page.
pub fn write(page: &Page) -> String {
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "Error against run time" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "Error against run time" }
                @for sentence in page.introduction() { p { (sentence) } }
                nav {
                    @for section in &page.sections {
                        @let name = section.scene.painter.name();
                        a href={ "#" (section.file) } { (name) }
                    }
                }
                h2 { "The scenes" }
                p { (page.columns()) }
                @for section in &page.sections { (scene(page, section)) }
                h2 { "Fixed point against float" }
                p { (page.contest_head()) }
                ul { @for line in page.contest() { li { (line) } } }
                h2 { "Theory beside measurement" }
                @for sentence in page.theory() { p { (sentence) } }
                p { (page.verdict()) }
                p { (page.room_words()) }
                (PreEscaped(&page.room))
            }
        }
    };
    markup.into_string() + "\n"
}

fn scene(page: &Page, section: &Section) -> Markup {
    let name = section.scene.painter.name();
    html! {
        h3 id=(section.file) { (name) }
        ul.use {
            @for line in section.recommendations(page.arguments.core) { li { (line) } }
        }
        p { "The last reflection that changes the picture is N = " (section.scene.last) "." }
        (PreEscaped(&section.psnr))
        (PreEscaped(&section.largest))
        div.samples { @for it in &section.samples { (sample(section, it)) } }
        div.wide {
            table {
                thead { tr { @for head in HEADS { th { (head) } } } }
                tbody {
                    @for row in section.rows() {
                        tr.float[row[0].is_empty()] { @for cell in row { td { (cell) } } }
                    }
                }
            }
        }
    }
}

fn sample(section: &Section, sample: &Sample) -> Markup {
    let words = section.front[sample.number - 1].words();
    let [picture, difference] = sample.pictures.each_ref().map(|png| data(png));
    let gain = crate::write::DIFFERENCE_GAIN;
    html! {
        figure {
            img src=(picture) alt={ "The scene at point " (sample.number) };
            img src=(difference) alt={ "What differs at point " (sample.number) };
            figcaption { (sample.number) ": " (words) ". Below: the difference, " (gain) " times as large." }
        }
    }
}

fn data(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", STANDARD.encode(png))
}
