//! Fills the templates of pages and writes Markdown tables.

/// Replaces each `{{name}}` in a page's template by the value of that name. White space at the end
/// of a value is left out.
pub fn filled(template: &str, values: &[(&str, String)]) -> String {
    values
        .iter()
        .fold(template.to_owned(), |text, (name, value)| {
            text.replace(&["{{", name, "}}"].concat(), value.trim_end())
        })
}

/// Returns a Markdown table. The first `texts` columns are text; the others are numbers and aligned
/// to the right.
pub fn markdown(texts: usize, head: &[String], rows: &[Vec<String>]) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = |column| if column < texts { "---" } else { "--:" };
    let rule: Vec<_> = (0..head.len()).map(rule).collect();
    let mut text = line(head) + &format!("|{}|\n", rule.join("|"));
    text.extend(rows.iter().map(|cells| line(cells)));
    text
}
