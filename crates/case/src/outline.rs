//! The outline of a RON text: which value stands where, found without knowing its types.

use super::tokens::{Kind, Token, tokens};
use std::fmt;
use std::iter::Peekable;
use std::ops::Range;
use std::vec::IntoIter;

/// Deepest nesting that is followed; the reader of the format has the same limit.
const MAX_DEPTH: usize = 128;

/// One step of a path.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Segment {
    /// Into a field, or inside an enum variant.
    Name(String),
    /// Into an element of a list or tuple.
    Index(usize),
    /// Into the value of a map's key.
    Key(String),
}

/// A path to a value, written as in `coatings.inner.curve.Tested[0].pressure` or `sources["ring.z"]`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Path(pub Vec<Segment>);

impl Path {
    /// Reads a path; `None` where it is not written as one.
    pub fn parse(text: &str) -> Option<Self> {
        let mut segments = Vec::new();
        let mut rest = text;
        while !rest.is_empty() {
            if let Some(quoted) = rest.strip_prefix("[\"") {
                let (key, after) = quoted.split_once("\"]")?;
                segments.push(Segment::Key(key.to_owned()));
                rest = after;
            } else if let Some(bracket) = rest.strip_prefix('[') {
                let (index, after) = bracket.split_once(']')?;
                segments.push(Segment::Index(index.parse().ok()?));
                rest = after;
            } else {
                let name = if segments.is_empty() { rest } else { rest.strip_prefix('.')? };
                let end = name.find(['.', '[']).unwrap_or(name.len());
                if end == 0 {
                    return None;
                }
                segments.push(Segment::Name(name[..end].to_owned()));
                rest = &name[end..];
            }
        }
        Some(Self(segments))
    }
}

impl fmt::Display for Path {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, segment) in self.0.iter().enumerate() {
            match segment {
                Segment::Name(name) if i == 0 => f.write_str(name)?,
                Segment::Name(name) => write!(f, ".{name}")?,
                Segment::Index(index) => write!(f, "[{index}]")?,
                Segment::Key(key) => write!(f, "[\"{key}\"]")?,
            }
        }
        Ok(())
    }
}

/// A value of the text.
#[derive(Debug)]
struct Node {
    /// All of it.
    range: Range<usize>,
    /// The word it is or begins with: a variant, a unit, a number.
    name: Option<Range<usize>>,
    /// The bracket with what it holds.
    body: Option<Body>,
}

#[derive(Debug)]
struct Body {
    range: Range<usize>,
    open: char,
    entries: Vec<Entry>,
}

#[derive(Debug)]
struct Entry {
    key: Option<Range<usize>>,
    value: Node,
}

/// The outline of a text.
pub(super) struct Outline<'a> {
    text: &'a str,
    root: Node,
}

/// A path that leads nowhere.
#[derive(Debug, PartialEq)]
pub(super) struct Missing {
    /// Steps that could be taken.
    pub steps: usize,
    /// The value they lead to.
    pub deepest: Range<usize>,
    /// Steps that are allowed there.
    pub allowed: Vec<String>,
}

/// Where a walk along a path stands: at a value, or inside a variant that holds fields or several values.
#[derive(Clone, Copy)]
struct Spot<'n> {
    node: &'n Node,
    inside: bool,
}

impl<'a> Outline<'a> {
    /// Outlines a text that holds exactly one value; `None` where brackets, strings or comments do not match.
    pub fn new(text: &'a str) -> Option<Self> {
        let mut parser = Parser { text, tokens: tokens(text)?.into_iter().peekable() };
        parser.skip_attributes()?;
        let root = parser.value(0)?;
        parser.tokens.next().is_none().then_some(Self { text, root })
    }

    /// Byte range of the value at a path.
    pub fn find(&self, path: &Path) -> Result<Range<usize>, Missing> {
        let mut spot = Spot { node: &self.root, inside: false };
        for (steps, segment) in path.0.iter().enumerate() {
            spot = self.step(spot, segment).ok_or_else(|| Missing {
                steps,
                deepest: spot.range(),
                allowed: self.allowed(spot),
            })?;
        }
        Ok(spot.range())
    }

    /// Byte ranges of the keys of the map at a path.
    pub fn keys(&self, path: &Path) -> Vec<Range<usize>> {
        let mut spot = Some(Spot { node: &self.root, inside: false });
        for segment in &path.0 {
            spot = spot.and_then(|spot| self.step(spot, segment));
        }
        spot.into_iter().flat_map(|s| s.transparent(self).entries()).filter_map(|entry| entry.key.clone()).collect()
    }

    /// The entry whose key or value stands at byte `offset`, the innermost one: its path, where its key (or, without
    /// one, its value) is, and its value.
    pub fn entry_at(&self, offset: usize) -> Option<(Path, Range<usize>, Range<usize>)> {
        let mut path = Path::default();
        let mut node = &self.root;
        let mut found = None;
        loop {
            let holds = |entry: &Entry| {
                let start = entry.key.as_ref().unwrap_or(&entry.value.range).start;
                (start..entry.value.range.end).contains(&offset)
            };
            let body = node.body.as_ref();
            let Some((i, entry)) = body.and_then(|b| b.entries.iter().enumerate().find(|(_, e)| holds(e))) else {
                return found;
            };
            let name = self.name(node).filter(|name| *name != "Some");
            path.0.extend(name.map(|name| Segment::Name(name.to_owned())));
            match &entry.key {
                Some(key) if body.is_some_and(|b| b.open == '{') => {
                    path.0.push(Segment::Key(unquoted(&self.text[key.clone()]).to_owned()));
                }
                Some(key) => path.0.push(Segment::Name(self.text[key.clone()].to_owned())),
                None if node.name.is_some() && node.entries().len() == 1 => {}
                None => path.0.push(Segment::Index(i)),
            }
            node = &entry.value;
            let pointed = entry.key.as_ref().unwrap_or(&node.range).clone();
            found = Some((path.clone(), pointed, node.range.clone()));
        }
    }

    /// Paths and byte ranges of the values that hold no named fields, in the order of the text: `mm(30.16)`, a list of
    /// numbers, a word.
    pub fn leaves(&self) -> Vec<(Path, Range<usize>)> {
        let mut found = Vec::new();
        self.collect(&self.root, &Path::default(), &mut found);
        found
    }

    fn collect(&self, node: &Node, path: &Path, found: &mut Vec<(Path, Range<usize>)>) {
        if !node.has_fields() {
            found.push((path.clone(), node.range.clone()));
            return;
        }
        let inside = |path: &Path, segment: Segment| Path(path.0.iter().cloned().chain([segment]).collect());
        let variant = self.name(node).filter(|name| *name != "Some" && !path.0.is_empty());
        let path = variant.map_or_else(|| path.clone(), |name| inside(path, Segment::Name(name.to_owned())));
        for (index, entry) in node.entries().iter().enumerate() {
            let below = match &entry.key {
                Some(key) if node.body.as_ref().is_some_and(|body| body.open == '{') => {
                    inside(&path, Segment::Key(unquoted(&self.text[key.clone()]).to_owned()))
                }
                Some(key) => inside(&path, Segment::Name(self.text[key.clone()].to_owned())),
                None if node.name.is_some() && node.entries().len() == 1 => path.clone(),
                None => inside(&path, Segment::Index(index)),
            };
            self.collect(&entry.value, &below, found);
        }
    }

    fn step<'n>(&self, spot: Spot<'n>, segment: &Segment) -> Option<Spot<'n>> {
        let spot = spot.transparent(self);
        if let (Segment::Name(name), false) = (segment, spot.inside)
            && let Some(inside) = self.enter(spot.node, name)
        {
            return Some(inside);
        }
        let named = |wanted: &str, entry: &&Entry| {
            entry.key.as_ref().is_some_and(|key| unquoted(&self.text[key.clone()]) == wanted)
        };
        let entry = match segment {
            Segment::Name(name) if spot.opens_with('(') => spot.entries().iter().find(|e| named(name, e)),
            Segment::Key(key) if spot.opens_with('{') => spot.entries().iter().find(|e| named(key, e)),
            Segment::Index(i) if spot.inside || spot.node.name.is_none() => {
                spot.entries().get(*i).filter(|e| e.key.is_none())
            }
            _ => None,
        };
        // The name before a bracket need not be in the path: without types a variant looks like a named struct.
        entry.map(|entry| Spot { node: &entry.value, inside: false })
    }

    /// Steps inside the variant `name`: to its value if it has one without a name, else to its bracket.
    fn enter<'n>(&self, node: &'n Node, name: &str) -> Option<Spot<'n>> {
        let body = node.body.as_ref()?;
        (self.name(node) == Some(name)).then_some(match body.entries.as_slice() {
            [Entry { key: None, value }] => Spot { node: value, inside: false },
            _ => Spot { node, inside: true },
        })
    }

    fn name(&self, node: &Node) -> Option<&'a str> {
        node.name.clone().map(|range| &self.text[range])
    }

    fn allowed(&self, spot: Spot<'_>) -> Vec<String> {
        let spot = spot.transparent(self);
        if !spot.inside
            && spot.node.body.is_some()
            && let Some(name) = self.name(spot.node)
        {
            return vec![name.to_owned()];
        }
        let key = |entry: &Entry| entry.key.clone().map(|key| self.text[key].to_owned());
        let name = |(i, entry): (usize, &Entry)| key(entry).unwrap_or_else(|| format!("[{i}]"));
        spot.entries().iter().enumerate().map(name).collect()
    }
}

impl Node {
    fn entries(&self) -> &[Entry] {
        self.body.as_ref().map_or(&[], |body| &body.entries)
    }

    /// True if it or a value inside has named fields.
    fn has_fields(&self) -> bool {
        self.entries().iter().any(|entry| entry.key.is_some() || entry.value.has_fields())
    }
}

impl<'n> Spot<'n> {
    fn range(self) -> Range<usize> {
        match &self.node.body {
            Some(body) if self.inside => body.range.clone(),
            _ => self.node.range.clone(),
        }
    }

    fn entries(self) -> &'n [Entry] {
        self.node.entries()
    }

    fn opens_with(self, open: char) -> bool {
        self.node.body.as_ref().is_some_and(|body| body.open == open)
    }

    /// `Some(…)` may be written or left out, and does not stand in paths.
    fn transparent(self, outline: &Outline<'_>) -> Self {
        match self.entries() {
            [Entry { key: None, value }] if !self.inside && outline.name(self.node) == Some("Some") => {
                Spot { node: value, inside: false }.transparent(outline)
            }
            _ => self,
        }
    }
}

/// The content of a quoted key without escapes, or the key itself.
pub(super) fn unquoted(key: &str) -> &str {
    let inner = key.trim_start_matches('r').trim_matches('#');
    inner.strip_prefix('"').and_then(|k| k.strip_suffix('"')).unwrap_or(key)
}

struct Parser<'a> {
    text: &'a str,
    tokens: Peekable<IntoIter<Token>>,
}

impl Parser<'_> {
    /// Passes over `#![enable(…)]` at the top of a file.
    fn skip_attributes(&mut self) -> Option<()> {
        while self.tokens.next_if(|t| self.text[t.range.clone()] == *"#!").is_some() {
            while self.tokens.next()?.kind != Kind::Punctuation(']') {}
        }
        Some(())
    }

    fn value(&mut self, depth: usize) -> Option<Node> {
        let token = self.tokens.next()?;
        let Range { start, end } = token.range;
        match token.kind {
            Kind::Quoted => Some(Node { range: start..end, name: None, body: None }),
            Kind::Punctuation(open) => {
                let body = self.body(start, open, depth)?;
                Some(Node { range: body.range.clone(), name: None, body: Some(body) })
            }
            Kind::Word => {
                let bracket = self.tokens.next_if(|t| t.kind == Kind::Punctuation('('));
                let body = match bracket {
                    Some(open) => Some(self.body(open.range.start, '(', depth)?),
                    None => None,
                };
                let whole = start..body.as_ref().map_or(end, |b| b.range.end);
                Some(Node { range: whole, name: Some(start..end), body })
            }
        }
    }

    fn body(&mut self, start: usize, open: char, depth: usize) -> Option<Body> {
        let close = match open {
            '(' => ')',
            '[' => ']',
            '{' => '}',
            _ => return None,
        };
        if depth >= MAX_DEPTH {
            return None;
        }
        let mut entries = Vec::new();
        loop {
            if let Some(end) = self.tokens.next_if(|t| t.kind == Kind::Punctuation(close)) {
                return Some(Body { range: start..end.range.end, open, entries });
            }
            let value = self.value(depth + 1)?;
            entries.push(match self.tokens.next_if(|t| t.kind == Kind::Punctuation(':')) {
                Some(_) => Entry { key: Some(value.range), value: self.value(depth + 1)? },
                None => Entry { key: None, value },
            });
            let comma = self.tokens.next_if(|t| t.kind == Kind::Punctuation(',')).is_some();
            let closes = self.tokens.peek().is_some_and(|t| t.kind == Kind::Punctuation(close));
            if !comma && !closes {
                return None;
            }
        }
    }
}
