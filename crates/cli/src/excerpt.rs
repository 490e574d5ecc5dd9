//! The part of a file that an error points at: a few lines, each of bounded length, that cannot steer a terminal.

use miette::{MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

/// Characters of a line that are shown on either side of what the error is about.
const REACH: usize = 100;
/// Lines of a section that are shown.
const LINES: usize = 10;

/// Such a part, with empty lines for those before it, so that lines keep their numbers.
#[derive(Debug)]
pub struct Excerpt {
    name: String,
    text: String,
    /// The place in the excerpt.
    pub span: SourceSpan,
    /// Bytes that were left out at the start of the line with the place.
    left_out: usize,
}

impl Excerpt {
    /// Of a text, about a range of bytes.
    pub fn new(name: &str, text: &str, offset: usize, length: usize) -> Self {
        let (start, end) = (floor(text, offset), floor(text, offset.saturating_add(length)));
        let line_of = |at: usize| text[..at].rfind('\n').map_or(0, |newline| newline + 1);
        let (first, mut last) = (line_of(start), line_of(end));
        let mut end = end;
        // Of a long section the first line will do.
        if text[first..last].matches('\n').count() >= LINES {
            end = first + text[first..].find('\n').unwrap_or(text.len() - first);
            last = first;
        }
        let above = first.checked_sub(1).map(line_of);
        let mut excerpt = "\n".repeat(text[..above.unwrap_or(first)].matches('\n').count());
        if let Some(above) = above {
            excerpt += &shown(&text[above..first - 1], 0);
            excerpt.push('\n');
        }
        let line_end = |from: usize| text[from..].find('\n').map_or(text.len(), |at| from + at);
        let left = text[first..start].char_indices().rev().nth(REACH).map_or(first, |(at, _)| first + at);
        if last > first {
            let from = excerpt.len() + start - first;
            excerpt += &visible(&text[first..last]);
            excerpt += &shown(&text[last..line_end(last)], end - last);
            return Self { name: visible(name), text: excerpt, span: (from, end - start).into(), left_out: 0 };
        }
        let dots = if left > first { "…" } else { "" };
        let from = excerpt.len() + dots.len() + start - left;
        let rest = &text[start..line_end(start)];
        let length = (end - start).min(shown(rest, 0).len());
        excerpt += &format!("{dots}{}{}", visible(&text[left..start]), shown(rest, 0));
        let below = line_end(start);
        if below < text.len() {
            excerpt.push('\n');
            excerpt += &shown(&text[below + 1..line_end(below + 1)], 0);
        }
        let left_out = (left - first).saturating_sub(dots.len());
        Self { name: visible(name), text: excerpt, span: (from, length).into(), left_out }
    }
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let part = self.text.read_span(span, before, after)?;
        let left_out = if part.column() > 0 { self.left_out } else { 0 };
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            part.data(),
            *part.span(),
            part.line(),
            part.column() + left_out,
            part.line_count(),
        )))
    }
}

/// The start of a line, at least up to a byte, that cannot steer a terminal.
fn shown(line: &str, least: usize) -> String {
    let most = line.char_indices().nth(2 * REACH).map_or(line.len(), |(at, _)| at).max(floor(line, least));
    let dots = if most < line.len() { "…" } else { "" };
    visible(&line[..most]) + dots
}

fn floor(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// As long in bytes as the text: what would steer a terminal is shown as so many question marks.
fn visible(text: &str) -> String {
    let mut seen = String::with_capacity(text.len());
    for c in text.chars() {
        if crate::table::steers(c) && c != '\n' { (0..c.len_utf8()).for_each(|_| seen.push('?')) } else { seen.push(c) }
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::Excerpt;

    fn marked(excerpt: &Excerpt) -> &str {
        let (offset, length) = (excerpt.span.offset(), excerpt.span.len());
        &excerpt.text[offset..offset + length]
    }

    #[test]
    fn limit_an_excerpt_is_short_and_keeps_line_and_place() {
        let text = format!("(\n  a: 1,\n  {}b: mm(3),{}\n  c: 2,\n)", "x: 1, ".repeat(50_000), " y: 2,".repeat(50_000));
        let place = text.find("mm(3)").unwrap();
        let excerpt = Excerpt::new("case.ron", &text, place, 5);
        assert_eq!(marked(&excerpt), "mm(3)");
        assert!(excerpt.text.len() < 1000, "{}", excerpt.text.len());
        assert_eq!(excerpt.text[..excerpt.span.offset()].matches('\n').count(), 2);
        let column = excerpt.span.offset() - excerpt.text.rfind("…x").map_or(0, |at| at.min(excerpt.span.offset()));
        assert!(column < 400);
        // One line, the whole of it wrong.
        let long = "x".repeat(1_000_000);
        assert!(Excerpt::new("case.ron", &long, 0, long.len()).text.len() < 1000);
    }

    #[test]
    fn limit_an_excerpt_cannot_steer_a_terminal() {
        let text = "name: \"\u{1b}]0;title\u{7}\",\nµ: \u{9b}2J, b: 3";
        let excerpt = Excerpt::new("\u{1b}[2J.ron", text, text.find('3').unwrap(), 1);
        assert_eq!(marked(&excerpt), "3");
        assert_eq!(
            (excerpt.text.as_str(), excerpt.name.as_str()),
            ("name: \"?]0;title?\",\nµ: ??2J, b: 3", "?[2J.ron")
        );
    }
}
