//! Which calls an executed instruction was reached by: a shadow of the call stack, kept from the
//! addresses alone.

use std::collections::HashMap;

/// A way of calls from what is watched to a function, by its place in [`Calls`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Way(usize);

impl Way {
    /// Of what is not called by anything that is watched.
    pub const ROOT: Self = Self(0);
}

/// A function's call in a certain way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Call {
    pub way: Way,
    pub site: u32,
    pub callee: u32,
}

/// All ways there have been, and where on them the program is.
#[derive(Debug, Default)]
pub struct Calls {
    /// What leads to each way but the root, and how often it was taken.
    calls: Vec<(Call, u64)>,
    index: HashMap<Call, Way>,
    /// The ways that are open, and the addresses they return to.
    open: Vec<(Way, u32)>,
}

impl Calls {
    /// The way to what is executed now.
    pub fn way(&self) -> Way {
        self.open.last().map_or(Way::ROOT, |&(way, _)| way)
    }

    /// The call that leads to a way; `None` for the root.
    pub fn call(&self, way: Way) -> Option<Call> {
        Some(self.calls.get(way.0.checked_sub(1)?)?.0)
    }

    pub fn all(&self) -> impl Iterator<Item = (Call, u64)> {
        self.calls.iter().copied()
    }

    /// Takes a function that is called at `site` and will return to `back`.
    pub fn enter(&mut self, site: u32, callee: u32, back: u32) {
        let way = self.take(site, callee);
        self.open.push((way, back));
    }

    /// Takes a function that is jumped to at `site` and returns for the one it was reached from.
    pub fn replace(&mut self, site: u32, callee: u32) {
        let way = self.take(site, callee);
        match self.open.last_mut() {
            Some(last) => last.0 = way,
            // The root returns to what is not watched.
            None => self.open.push((way, 0)),
        }
    }

    /// Takes a jump; whether it was a return.
    pub fn leave(&mut self, to: u32) -> bool {
        let returned = self.open.iter().rposition(|&(_, back)| back == to);
        if let Some(depth) = returned {
            self.open.truncate(depth);
        }
        returned.is_some()
    }

    /// Takes the end of what is watched.
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

    /// The sites of the calls that lead to where the program is, the latest first.
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
        let counts: Vec<_> = calls
            .all()
            .map(|(call, count)| (call.site, count))
            .collect();
        assert_eq!(counts, [(10, 3), (20, 1)]);
    }
}
