//! Reads Rust source just well enough to find the modules that it names: words, paths and trees of
//! paths. Never knows which names are allowed.

/// Returns the modules that a file names by paths that start with `crate`, `self` or `super`, with
/// their lines.
pub fn paths(module: &[String], source: &str) -> Vec<(usize, String)> {
    let tokens = tokens(source);
    let exports = tokens.iter().any(|token| token.1 == "macro_export");
    let mut scope = Scope {
        module: module.to_vec(),
        ..Scope::default()
    };
    let mut found = Vec::new();
    for at in 0..tokens.len() {
        let word = tokens[at].1;
        scope.pass(&tokens[..=at]);
        let is_inner = at > 0 && tokens[at - 1].1 == "::";
        let starts_path = tokens.get(at + 1).is_some_and(|next| next.1 == "::");
        // Users write what an exported macro expands to, and name what the crate's root re-exports.
        let is_for_users = exports && at > 0 && tokens[at - 1].1 == "$";
        if is_inner || !starts_path || is_for_users {
            continue;
        }
        let base = match word {
            "crate" => Vec::new(),
            "self" => scope.module.clone(),
            "super" => scope.module[..scope.module.len() - 1].to_vec(),
            _ => continue,
        };
        follow(&tokens, at + 2, base, &mut found);
    }
    found
}

/// Follows a path or a tree of paths from its next name. Returns the token after its end.
fn follow(
    tokens: &[(usize, &str)],
    mut at: usize,
    mut base: Vec<String>,
    found: &mut Vec<(usize, String)>,
) -> usize {
    while let Some((line, token)) = tokens.get(at) {
        match *token {
            "super" => drop(base.pop()),
            "self" => {}
            "{" => {
                at += 1;
                while tokens[at].1 != "}" {
                    at = match tokens[at].1 {
                        "," => at + 1,
                        _ => follow(tokens, at, base.clone(), found),
                    };
                }
                return at + 1;
            }
            name => base.push(name.to_owned()),
        }
        at += 1;
        if tokens.get(at).is_none_or(|next| next.1 != "::") {
            // A path that ends at the crate's root names no module.
            found.extend(base.first().map(|room| (*line, room.clone())));
            if tokens.get(at).is_some_and(|next| next.1 == "as") {
                at += 2;
            }
            return at;
        }
        at += 1;
    }
    at
}

/// The module that contains a token, including modules that are opened inside the file.
#[derive(Default)]
struct Scope {
    module: Vec<String>,
    depth: usize,
    opened: Vec<usize>,
}

impl Scope {
    /// Updates the module with the last of the tokens passed so far.
    fn pass(&mut self, passed: &[(usize, &str)]) {
        match passed {
            [.., (_, "mod"), (_, name), (_, "{")] => {
                self.module.push((*name).to_owned());
                self.opened.push(self.depth);
                self.depth += 1;
            }
            [.., (_, "{")] => self.depth += 1,
            [.., (_, "}")] => {
                self.depth -= 1;
                if self.opened.pop_if(|depth| *depth == self.depth).is_some() {
                    self.module.pop();
                }
            }
            _ => {}
        }
    }
}

/// Returns the words and symbols of Rust source with their lines, without comments, strings and
/// characters.
pub fn tokens(source: &str) -> Vec<(usize, &str)> {
    let mut pieces = pieces(source);
    pieces.retain(|(_, piece)| !is_comment(piece) && !is_text(piece));
    pieces
}

/// Returns everything except white space, with its first line: words, symbols, strings, characters
/// and comments.
fn pieces(source: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let (mut rest, mut line) = (source, 1);
    while let Some(first) = rest.chars().next() {
        let skipped = skipped(rest);
        let length = match first {
            _ if skipped > 0 => skipped,
            _ if rest.starts_with("::") => 2,
            _ if is_word(first) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            _ => first.len_utf8(),
        };
        let (piece, later) = rest.split_at(length);
        if !first.is_whitespace() {
            found.push((line, piece.trim_end()));
        }
        line += piece.matches('\n').count();
        rest = later;
    }
    found
}

fn is_comment(piece: &str) -> bool {
    piece.starts_with("//") || piece.starts_with("/*")
}

/// Tests whether a piece is a string, a character, or the mark of a lifetime.
fn is_text(piece: &str) -> bool {
    piece.contains('"') || piece.starts_with('\'')
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Returns the length of a comment, a string or a character at the start of the source, or 0.
fn skipped(rest: &str) -> usize {
    let until = |end: &str, from: usize| {
        let found = rest[from..].find(end);
        found.map_or(rest.len(), |at| from + at + end.len())
    };
    if rest.starts_with("//") {
        until("\n", 2)
    } else if rest.starts_with("/*") {
        until("*/", 2)
    } else if rest.starts_with('"') {
        quoted(rest, '"')
    } else if rest.starts_with("'\\") {
        quoted(rest, '\'')
    } else if rest.starts_with('\'') {
        // A character has a closing quote; a lifetime has none.
        let mut chars = rest.char_indices().skip(2);
        chars
            .next()
            .map_or(1, |(at, c)| if c == '\'' { at + 1 } else { 1 })
    } else {
        let hashes = rest.strip_prefix('r').map_or("", |text| {
            &text[..text.find(|c| c != '#').unwrap_or(text.len())]
        });
        let opening = 1 + hashes.len();
        if rest.starts_with('r') && rest[opening..].starts_with('"') {
            until(&format!("\"{hashes}"), opening + 1)
        } else {
            0
        }
    }
}

/// Returns the length of a text between `mark`s. A backslash escapes the next character.
fn quoted(rest: &str, mark: char) -> usize {
    let mut chars = rest.char_indices().skip(1);
    while let Some((at, c)) = chars.next() {
        match c {
            '\\' => drop(chars.next()),
            c if c == mark => return at + 1,
            _ => {}
        }
    }
    rest.len()
}
