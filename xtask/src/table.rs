//! Fills the templates of pages and writes Markdown tables.

use std::borrow::Borrow;

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
pub fn markdown<H: Borrow<str>>(
    texts: usize,
    head: &[H],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> String {
    let line = |cells: String| format!("| {cells} |\n");
    let rule = |column| if column < texts { "---" } else { "--:" };
    let rule: Vec<_> = (0..head.len()).map(rule).collect();
    let mut text = line(head.join(" | ")) + &format!("|{}|\n", rule.join("|"));
    text.extend(rows.into_iter().map(|cells| line(cells.join(" | "))));
    text
}

/// Returns the cells of a row: its name, then the others.
pub fn row(name: &str, cells: impl IntoIterator<Item = String>) -> Vec<String> {
    [name.to_owned()].into_iter().chain(cells).collect()
}

/// Returns the cell of a figure that may be missing.
pub fn cell(figure: Option<String>) -> String {
    figure.unwrap_or_else(|| "-".to_owned())
}

/// Rounds a number to this many digits after the point.
pub fn rounded(number: f64, digits: i32) -> f64 {
    let unit = 10_f64.powi(digits);
    (number * unit).round() / unit
}

/// A text whose table of the same head is replaced; each of its lines begins with `prefix`. `None` if
/// it has no such table.
pub fn with_table(text: &str, prefix: &str, table: &str) -> Option<String> {
    let head = format!("{prefix}{}", table.lines().next()?);
    let (before, rest) = text.split_once(&head)?;
    let is_row = |line: &&str| line.starts_with(&format!("{prefix}|"));
    let after = rest.split_inclusive('\n').skip(1).skip_while(is_row);
    let rows = table.lines().map(|line| format!("{prefix}{line}\n"));
    Some(before.to_owned() + &rows.collect::<String>() + &after.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_rows_of_the_table_are_replaced() {
        let text = "//! a\n//! | x | y |\n//! |---|\n//! | old |\n//!\n//! | other |\n";
        let replaced = with_table(text, "//! ", "| x | y |\n|---|\n| 1 |\n| 2 |\n");
        let expected =
            "//! a\n//! | x | y |\n//! |---|\n//! | 1 |\n//! | 2 |\n//!\n//! | other |\n";
        assert_eq!(replaced.as_deref(), Some(expected));
        assert_eq!(with_table("nothing\n", "", "| x |\n"), None);
    }
}
