//! Writes `docs/internals/stability.md`: the catalogue and its results. Never opens a file.

use std::fmt::Write as _;

use super::catalogue::judge::{MANY, SHORT_SIDE, SIDE, UNSEEN};
use super::report::{self, Compared, Tried, number, percent};

/// Returns the text of the page.
pub fn page(tried: &[Tried]) -> String {
    let mut page = head(tried);
    for chapter in tried.chunk_by(|a, b| a.chapter == b.chapter) {
        write_chapter(&mut page, chapter);
    }
    write_exceptions(&mut page, tried);
    page.push_str(include_str!("../limits.md"));
    page
}

fn write_exceptions(page: &mut String, tried: &[Tried]) {
    page.push_str("\n## Where f32 is better\n\n");
    let lines: Vec<_> = report::worse(tried)
        .map(|it| {
            let [fixed, single] = it.verdict.errors.unwrap_or_default().map(number);
            let reason = it.case.exception.unwrap_or("For no reason.");
            format!("- {}: {fixed} against {single}. {reason}\n", it.case.name)
        })
        .collect();
    page.push_str(&if lines.is_empty() { "Nowhere.\n".to_owned() } else { lines.concat() });
}

fn head(tried: &[Tried]) -> String {
    let compared = Compared::of(tried);
    let aim = if compared.is_aim_met() { "met" } else { "missed" };
    format!(
        "# Stiff and extreme cases\n\n\
         Written by `cargo run --release --package stability`, which ends with exit code 1 where a \
         case misses its bar, is worse than `f32` for no reason that is named, or the aim below is \
         missed; the tests try the same catalogue.\n\n\
         Pictures are {SIDE}x{SIDE} ({SHORT_SIDE}x{SHORT_SIDE} with more than {MANY} reflections), in \
         Blinn-Phong, by `Exact` and `Fast`, and by the double-precision reference's own formulas \
         in single precision (`f32`), which trace every pixel, as `Exact` does. Errors are of `Exact`; a \
         picture's is the mean difference of a channel in 255ths from the double-precision reference, \
         unless the unit says otherwise. Fixed point is no worse than `f32` where its error is not larger; \
         or, of a picture, where at least as many pixels are within 8 and its mean error is below {UNSEEN} \
         of a 255th: that is one channel in twenty off by a single level, which is rounding. Where a case \
         says below what its two errors cannot be told apart, that counts as equal.\n\n\
         {} cases, {} of which meet their bar. Of those that both can try, fixed point is no worse than \
         `f32` in {}: its error is smaller in {}, the same in {}, and larger by nothing that can be seen or told apart in {}. The \
         aim is that these are {} at least: it is {aim}. `Exact` is held to it, as it does the same work; \
         `Fast`, which takes pixels from those beside them, is no worse in {}.\n",
        tried.len(),
        tried.iter().filter(|it| it.verdict.is_met).count(),
        compared.share(compared.no_worse[0]),
        compared.smaller,
        compared.same,
        compared.no_worse[0] - compared.smaller - compared.same,
        percent(report::AIM),
        compared.no_worse[1],
    )
}

fn write_chapter(page: &mut String, chapter: &[Tried]) {
    let (figures, claims): (Vec<_>, Vec<_>) =
        chapter.iter().partition(|it| it.verdict.errors.is_some());
    let title = chapter.first().map_or("", |it| it.chapter);
    let _ = write!(page, "\n## {title}\n");
    if !figures.is_empty() {
        page.push_str(
            "\n| case | why it is hard | reference | unit | fixed | f32 | within 8: Exact | Fast \
             | f32 | bar | verdict |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
        );
    }
    for tried in figures {
        let (case, verdict, word) = (&tried.case, &tried.verdict, tried.word());
        let [fixed, single] = verdict.errors.unwrap_or_default().map(number);
        let shares = verdict.within8.map(|shares| shares.map(percent));
        let [exact, fast, port] = shares.unwrap_or_default();
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} | {fixed} | {single} | {exact} | {fast} | {port} | {} | {word} |",
            case.name, case.why, verdict.reference, verdict.unit, verdict.words,
        );
    }
    if !claims.is_empty() {
        page.push_str(
            "\n| case | why it is hard | what was found | verdict |\n|---|---|---|---|\n",
        );
    }
    for tried in claims {
        let (name, why, words) = (&tried.case.name, tried.case.why, &tried.verdict.words);
        let _ = writeln!(page, "| {name} | {why} | {words} | {} |", tried.word());
    }
}
