//! Reconstructs the call stack of a traced program from the executed addresses alone, and counts its
//! calls.

use std::collections::HashMap;

/// A chain of calls from the watched code to a function: an index into [`Calls`], plus one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Way(usize);

impl Way {
    /// The empty chain: a function that no watched code calls.
    pub const ROOT: Self = Self(0);
}

/// One call: the chain of calls that leads to the caller, the address of the call, and the function
/// it calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Call {
    pub way: Way,
    pub site: u32,
    pub callee: u32,
}

/// All call chains that have occurred, and the chain that the program is in now.
#[derive(Debug, Default)]
pub struct Calls {
    /// The last call of each chain but the root, and how often it was made.
    calls: Vec<(Call, u64)>,
    index: HashMap<Call, Way>,
    /// The current call stack: chains and their return addresses, the outermost first.
    open: Vec<(Way, u32)>,
}

impl Calls {
    /// Returns the chain of calls to the function that runs now.
    pub fn way(&self) -> Way {
        self.open.last().map_or(Way::ROOT, |&(way, _)| way)
    }

    /// Returns the last call of a chain, or `None` for the root.
    pub fn call(&self, way: Way) -> Option<Call> {
        Some(self.calls.get(way.0.checked_sub(1)?)?.0)
    }

    /// Returns every call that has occurred, and how often it was made.
    pub fn all(&self) -> impl Iterator<Item = (Call, u64)> {
        self.calls.iter().copied()
    }

    /// Records a call at `site` that will return to `back`.
    pub fn enter(&mut self, site: u32, callee: u32, back: u32) {
        let way = self.take(site, callee);
        self.open.push((way, back));
    }

    /// Records a tail call: a jump at `site` to a function that returns in place of the one that jumped.
    pub fn replace(&mut self, site: u32, callee: u32) {
        let way = self.take(site, callee);
        match self.open.last_mut() {
            Some(last) => last.0 = way,
            // The root returns to code that is not watched.
            None => self.open.push((way, 0)),
        }
    }

    /// Records a jump to `to`, and tests whether it is a return. A return removes all calls above
    /// it, too.
    pub fn leave(&mut self, to: u32) -> bool {
        let returned = self.open.iter().rposition(|&(_, back)| back == to);
        if let Some(depth) = returned {
            self.open.truncate(depth);
        }
        returned.is_some()
    }

    /// Records that the watched code has ended.
    pub fn end(&mut self) {
        self.open.clear();
    }

    fn take(&mut self, site: u32, callee: u32) -> Way {
        let way = self.way();
        let call = Call { way, site, callee };
        let calls = &mut self.calls;
        let way = *self.index.entry(call).or_insert_with(|| {
            calls.push((call, 0));
            Way(calls.len())
        });
        if let Some((_, count)) = self.calls.get_mut(way.0 - 1) {
            *count += 1;
        }
        way
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the addresses of the calls on the current stack, the latest first.
    fn sites(calls: &Calls) -> Vec<u32> {
        let mut way = calls.way();
        let mut sites = Vec::new();
        while let Some(call) = calls.call(way) {
            sites.push(call.site);
            way = call.way;
        }
        sites
    }

    #[test]
    fn calls_are_left_where_they_return_to() {
        let mut calls = Calls::default();
        calls.enter(10, 100, 14);
        calls.enter(110, 200, 114);
        assert_eq!(sites(&calls), [110, 10]);
        assert!(!calls.leave(205));
        assert!(calls.leave(114));
        assert_eq!(sites(&calls), [10]);
        assert!(calls.leave(14));
        assert_eq!(calls.way(), Way::ROOT);
        assert!(!calls.leave(14));
    }

    #[test]
    fn function_that_is_jumped_to_returns_for_its_caller() {
        let mut calls = Calls::default();
        calls.enter(10, 100, 14);
        calls.replace(120, 300);
        assert_eq!(sites(&calls), [120, 10]);
        assert!(calls.leave(14));
        assert_eq!(calls.way(), Way::ROOT);
        calls.replace(20, 300);
        assert_eq!(sites(&calls), [20]);
        calls.end();
        assert_eq!(calls.way(), Way::ROOT);
    }

    #[test]
    fn return_leaves_all_calls_above() {
        let mut calls = Calls::default();
        calls.enter(10, 100, 14);
        calls.enter(110, 200, 114);
        assert!(calls.leave(14));
        assert_eq!(calls.way(), Way::ROOT);
    }

    #[test]
    fn same_calls_are_one_way_that_is_counted() {
        let mut calls = Calls::default();
        for _ in 0..3 {
            calls.enter(10, 100, 14);
            calls.leave(14);
        }
        calls.enter(20, 100, 24);
        let counts = calls.all().map(|(call, count)| (call.site, count));
        assert_eq!(counts.collect::<Vec<_>>(), [(10, 3), (20, 1)]);
    }
}
