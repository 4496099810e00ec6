//! Tables for the pages that the chores write.

/// A page's template with `{{name}}` replaced by the value of that name, and no space after it.
pub fn filled(template: &str, values: &[(&str, String)]) -> String {
    values
        .iter()
        .fold(template.to_owned(), |text, (name, value)| {
            text.replace(&["{{", name, "}}"].concat(), value.trim_end())
        })
}

/// A Markdown table: so many columns of text, and then numbers, which stand to the right.
pub fn markdown(texts: usize, head: &[String], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = |column| if column < texts { "---" } else { "--:" };
    let rule: Vec<_> = (0..head.len()).map(rule).collect();
    let mut text = line(head) + &format!("|{}|\n", rule.join("|"));
    text.extend(rows.iter().map(|cells| line(cells)));
    text
}
