//! The page as Markdown, beside its pictures.

use super::{HEADS, Page, Section};

/// The whole page.
pub fn write(page: &Page) -> String {
    let mut text = format!(
        "<!-- Written by `{}`. Do not edit. -->\n\n# Error against run time\n\n",
        page.arguments.command()
    );
    text += "[The same as one page with all its pictures](index.html), to be opened from disk.\n\n";
    text += &paragraphs(&page.introduction());
    let links = page.sections.iter().map(|it| {
        let name = it.scene.painter.name();
        format!("[{name}](#{name})")
    });
    text += &(links.collect::<Vec<_>>().join(", ") + "\n\n");
    text += "## Fixed point against float\n\n";
    text += &(page.contest_head() + "\n\n");
    text += &(list(&page.contest()) + "\n");
    text += "## Theory beside measurement\n\n";
    text += &paragraphs(&page.theory());
    text += &(page.verdict() + "\n\n");
    text += &(page.room_words() + "\n\n![Levels against reflections](room.svg)\n\n");
    text += "## The scenes\n\n";
    text += &(page.columns() + "\n\n");
    text.extend(page.sections.iter().map(|section| scene(page, section)));
    text.trim_end().to_owned() + "\n"
}

fn scene(page: &Page, section: &Section) -> String {
    let (name, file) = (section.scene.painter.name(), &section.file);
    let mut text = format!(
        "### {name}\n\nThe last reflection that changes the picture is N = {}.\n\n",
        section.scene.last
    );
    text += &(list(&section.recommendations(page.arguments.core)) + "\n");
    text += &format!("![PSNR against cost]({file}-psnr.svg)\n\n");
    text += &format!("![Largest error against cost]({file}-largest.svg)\n\n");
    let cells = |cell: &dyn Fn(&super::Sample) -> String| {
        let cells: Vec<_> = section.samples.iter().map(cell).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    text += &cells(&|it| format!("point {}", it.number));
    text += &format!("|{}\n", "---|".repeat(section.samples.len()));
    text += &cells(&|it| format!("![]({})", it.files[0]));
    text += &cells(&|it| format!("![]({})", it.files[1]));
    text += &format!(
        "\nBelow: the differences, {} times as large.\n\n",
        crate::write::DIFFERENCE_GAIN
    );
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    text += &line(&HEADS.map(str::to_owned));
    text += &format!("|--:|---|{}\n", "--:|".repeat(HEADS.len() - 2));
    text.extend(section.rows().iter().map(|row| line(row)));
    text + "\n"
}

fn paragraphs(sentences: &[String]) -> String {
    sentences.iter().map(|it| format!("{it}\n\n")).collect()
}

fn list(lines: &[String]) -> String {
    lines.iter().map(|it| format!("- {it}\n")).collect()
}
