//! Fills the marks of the page: styles, scripts, the wasm and the data go into one file. It never
//! knows what a script does.

use std::fs;
use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result, ensure};
use base64::prelude::{BASE64_STANDARD, Engine};
use flate2::{Compression, write::DeflateEncoder};

/// Returns the text of the page. `folder` has its parts; `data` is JSON.
pub fn fill(folder: &Path, wasm: &[u8], data: &str) -> Result<String> {
    let page = read(&folder.join("index.html"))?;
    let worker = read(&folder.join("worker.js"))?;
    let mut main = scripts(folder, &page)?;
    for (name, value) in [
        ("WASM", literal(&BASE64_STANDARD.encode(deflated(wasm)?))?),
        ("WORKER", literal(&worker)?),
        ("DATA", data.replace('<', "\\u003c")),
    ] {
        main = replaced(&main, &format!("/*{{{name}}}*/null"), &value)?;
    }
    ensure!(
        !main.contains("</script"),
        "a script of the page contains the tag that ends it"
    );
    let style = read(&folder.join("style.css"))?;
    let page = replaced(&page, "/*{STYLE}*/", &style)?;
    replaced(&page, "/*{MAIN}*/", &main)
}

/// Returns the scripts joined, in the order of the page's line `scripts: first.js second.js`.
fn scripts(folder: &Path, page: &str) -> Result<String> {
    let mut lines = page.lines().map(str::trim);
    let names = lines.find_map(|line| line.strip_prefix("scripts: "));
    let names = names.context("the page must name its scripts")?;
    names.split(' ').map(|it| read(&folder.join(it))).collect()
}

fn read(file: &Path) -> Result<String> {
    fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display()))
}

/// Puts `value` where the mark is.
///
/// # Errors
/// The text has no such mark, or several.
fn replaced(text: &str, mark: &str, value: &str) -> Result<String> {
    let (before, after) = text
        .split_once(mark)
        .filter(|(_, after)| !after.contains(mark))
        .with_context(|| format!("the page must have the mark {mark} once"))?;
    Ok([before, value, after].concat())
}

/// Returns the bytes deflated, which a server's own compression cannot do once they are base64.
fn deflated(bytes: &[u8]) -> Result<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?)
}

/// Returns a text as a string of JavaScript that contains no tag.
fn literal(text: &str) -> Result<String> {
    Ok(serde_json::to_string(text)?.replace('<', "\\u003c"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_is_one_file_with_everything_in_it() {
        let folder = tempfile::tempdir().unwrap();
        let main = "const W = /*{WASM}*/null, R = /*{WORKER}*/null, D = /*{DATA}*/null;";
        for (name, text) in [
            (
                "index.html",
                "scripts: a.js main.js\n<style>/*{STYLE}*/</style><script>/*{MAIN}*/</script>",
            ),
            ("style.css", "p{}"),
            ("a.js", "a();"),
            ("worker.js", "b('</script>');"),
            ("main.js", main),
        ] {
            fs::write(folder.path().join(name), text).unwrap();
        }
        let page = fill(folder.path(), b"foo", "{\"a\":\"<b>\"}").unwrap();
        let expected = "scripts: a.js main.js\n<style>p{}</style><script>a();const W = \"S8vPBwA=\", \
                        R = \"b('\\u003c/script>');\", D = {\"a\":\"\\u003cb>\"};</script>";
        assert_eq!(page, expected);
        fs::write(folder.path().join("main.js"), "").unwrap();
        let error = fill(folder.path(), b"", "").unwrap_err().to_string();
        assert_eq!(error, "the page must have the mark /*{WASM}*/null once");
    }
}
