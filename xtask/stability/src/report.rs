//! Tries the cases, and formats their results as lines. Never prints.

use super::catalogue::judge::{Verdict, judge};
use super::catalogue::{Case, chapters};

/// A case that was tried, and its verdict.
pub struct Tried {
    /// Title of the page's chapter in which a case stands.
    pub chapter: &'static str,
    pub case: Case,
    pub verdict: Verdict,
}

/// Tries all cases of the catalogue.
pub fn try_all() -> impl Iterator<Item = Tried> {
    let chapters = chapters().into_iter();
    chapters.flat_map(|(chapter, cases)| cases.into_iter().map(|case| Tried::new(chapter, case)))
}

impl Tried {
    pub fn new(chapter: &'static str, case: Case) -> Self {
        Self {
            chapter,
            verdict: judge(&case),
            case,
        }
    }

    pub fn line(&self) -> String {
        format!("{:<5} {}: {}", self.word(), self.case.name, self.figures())
    }

    /// Returns the verdict in a few words: `fails`, `met`, or `met, worse than f32`.
    pub fn word(&self) -> &'static str {
        match (self.verdict.is_met, self.verdict.no_worse) {
            (false, _) => "fails",
            (true, Some([false, ..])) => "met, worse than f32",
            (true, _) => "met",
        }
    }

    fn figures(&self) -> String {
        let verdict = &self.verdict;
        let errors = verdict.errors.map(|errors| {
            let [fixed, single] = errors.map(number);
            format!("fixed {fixed}, f32 {single} ({})", verdict.unit)
        });
        let within8 = verdict.within8.map(|shares| {
            let [exact, fast, single] = shares.map(percent);
            format!("within 8: Exact {exact}, Fast {fast}, f32 {single}")
        });
        let parts: Vec<_> = errors.into_iter().chain(within8).collect();
        if parts.is_empty() { verdict.words.clone() } else { parts.join("; ") }
    }
}

/// Formats a figure with as many digits as are significant.
pub fn number(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value < 0.001 => format!("{value:.1e}"),
        value if value < 100.0 => format!("{value:.3}"),
        value => format!("{value:.0}"),
    }
}

pub fn percent(share: f64) -> String {
    format!("{:.2} %", 100.0 * share)
}

/// Smallest share of the cases in which fixed point should be no worse than single precision.
pub const AIM: f64 = 0.9;

/// Numbers of cases that are compared with single precision, and of those that are no worse.
pub struct Compared {
    pub all: usize,
    /// Cases that are no worse by the rule of the page, in `Exact` and `Fast`.
    pub no_worse: [usize; 2],
    /// Cases in which the error of fixed point is smaller, even if invisibly, and in which it is the same.
    pub smaller: usize,
    pub same: usize,
}

impl Compared {
    pub fn of(tried: &[Tried]) -> Self {
        let verdicts = || tried.iter().map(|it| &it.verdict);
        let compared = || verdicts().filter_map(|it| it.no_worse);
        let errors = || verdicts().filter_map(|it| it.errors);
        Self {
            all: compared().count(),
            no_worse: [0, 1].map(|quality| compared().filter(|it| it[quality]).count()),
            smaller: errors().filter(|[fixed, single]| fixed < single).count(),
            same: errors().filter(|[fixed, single]| fixed == single).count(),
        }
    }

    pub fn share(&self, count: usize) -> String {
        let share = percent(count as f64 / self.all as f64);
        format!("{count} of {} ({share})", self.all)
    }

    /// Tests whether enough cases are no worse in `Exact`.
    pub fn is_aim_met(&self) -> bool {
        self.no_worse[0] as f64 >= AIM * self.all as f64
    }
}

/// Returns a line for each case that missed its bar, or is worse than single precision without a
/// reason.
pub fn failures(tried: &[Tried]) -> Vec<String> {
    let missed = tried.iter().filter(|it| !it.verdict.is_met);
    let missed = missed.map(|it| {
        let (name, figures, bar) = (&it.case.name, it.figures(), &it.verdict.words);
        format!("{}: {name}: {figures} (bar: {bar})", it.chapter)
    });
    let worse = worse(tried).filter(|it| it.case.exception.is_none());
    let worse = worse.map(|it| format!("{}: worse than f32: {}", it.case.name, it.figures()));
    missed.chain(worse).collect()
}

/// Returns the cases in which single precision is better than `Exact`.
pub fn worse(tried: &[Tried]) -> impl Iterator<Item = &Tried> {
    let is_worse = |it: &&Tried| matches!(it.verdict.no_worse, Some([false, ..]));
    tried.iter().filter(is_worse)
}
