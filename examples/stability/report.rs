//! What came of the cases, as lines; it never tries one.

use serde_json::{Value, json};

use super::catalogue::Case;
use super::catalogue::judge::{Verdict, judge};

/// A case and what came of it.
pub struct Tried {
    /// The chapter's title.
    pub chapter: &'static str,
    /// The case's name.
    pub name: String,
    /// Why it is hard.
    pub why: &'static str,
    /// Why single precision may be better.
    pub exception: Option<&'static str>,
    /// What came of it.
    pub verdict: Verdict,
}

impl Tried {
    /// Tries a case.
    pub fn new(chapter: &'static str, case: &Case) -> Self {
        Self {
            chapter,
            name: case.name.clone(),
            why: case.why,
            exception: case.exception,
            verdict: judge(case),
        }
    }

    /// One line, for programs or for people.
    pub fn line(&self, is_json: bool) -> String {
        match is_json {
            true => self.json().to_string(),
            false => format!("{:<5} {}: {}", self.word(), self.name, self.figures()),
        }
    }

    /// One word for what came of it.
    pub fn word(&self) -> &'static str {
        match (self.verdict.is_met, self.verdict.is_no_worse) {
            (false, _) => "fails",
            (true, Some(false)) => "met, worse than f32",
            (true, _) => "met",
        }
    }

    fn figures(&self) -> String {
        let Verdict {
            errors,
            unit,
            within8,
            words,
            ..
        } = &self.verdict;
        let errors = errors.map(|[fixed, single]| {
            format!("fixed {}, f32 {} ({unit})", number(fixed), number(single))
        });
        let within8 = within8.map(|shares| {
            let [fine, fast, single] = shares.map(percent);
            format!("within 8: Fine {fine}, Fast {fast}, f32 {single}")
        });
        let parts: Vec<_> = errors.into_iter().chain(within8).collect();
        match parts.is_empty() {
            true => words.clone(),
            false => parts.join("; "),
        }
    }

    fn json(&self) -> Value {
        let Verdict {
            reference,
            unit,
            errors,
            within8,
            is_met,
            is_no_worse,
            words,
        } = &self.verdict;
        json!({
            "chapter": self.chapter, "case": self.name, "why": self.why,
            "reference": reference, "unit": unit,
            "fixed": errors.map(|it| it[0]), "f32": errors.map(|it| it[1]),
            "within8": within8.map(|it| json!({"fine": it[0], "fast": it[1], "f32": it[2]})),
            "met": is_met, "no_worse_than_f32": is_no_worse, "bar": words,
        })
    }
}

/// A figure in as many digits as say something.
pub fn number(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value < 0.001 => format!("{value:.1e}"),
        value if value < 100.0 => format!("{value:.3}"),
        value => format!("{value:.0}"),
    }
}

/// A share in percent.
pub fn percent(share: f64) -> String {
    format!("{:.2} %", 100.0 * share)
}

/// How many cases are compared with single precision, and how many of them are no worse.
pub fn compared(tried: &[Tried]) -> (usize, usize) {
    let compared: Vec<_> = tried
        .iter()
        .filter_map(|it| it.verdict.is_no_worse)
        .collect();
    (compared.len(), compared.iter().filter(|it| **it).count())
}

/// What has missed a bar, or is worse than single precision for no reason, a line each.
pub fn failures(tried: &[Tried]) -> Vec<String> {
    let missed = tried.iter().filter(|it| !it.verdict.is_met);
    let mut lines: Vec<_> = missed
        .map(|it| {
            format!(
                "{}: {}: {} (bar: {})",
                it.chapter,
                it.name,
                it.figures(),
                it.verdict.words
            )
        })
        .collect();
    let worse = worse(tried).filter(|it| it.exception.is_none());
    lines.extend(worse.map(|it| format!("{}: worse than f32: {}", it.name, it.figures())));
    let (all, no_worse) = compared(tried);
    if 10 * no_worse < 9 * all {
        lines.push(format!(
            "no worse than f32 in {no_worse} of {all} cases only"
        ));
    }
    lines
}

/// The cases in which single precision is better.
pub fn worse(tried: &[Tried]) -> impl Iterator<Item = &Tried> {
    tried
        .iter()
        .filter(|it| it.verdict.is_no_worse == Some(false))
}

/// One line about all.
pub fn summary(tried: &[Tried]) -> String {
    let (all, no_worse) = compared(tried);
    let met = tried.iter().filter(|it| it.verdict.is_met).count();
    format!(
        "{met} of {} cases meet their bar; fixed point is no worse than f32 in {no_worse} of {all}",
        tried.len()
    )
}
