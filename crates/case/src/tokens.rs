//! RON text cut into tokens with their byte ranges; comments and white space fall away.

use std::ops::Range;

/// A token.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token {
    pub kind: Kind,
    pub range: Range<usize>,
}

/// Kind of a token.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// One of `( ) [ ] { } , :`.
    Punctuation(char),
    /// Identifier or number.
    Word,
    /// String, byte string or character, quotes included.
    Quoted,
}

/// Cuts `text` into tokens; `None` where a comment or a string does not end.
pub(super) fn tokens(text: &str) -> Option<Vec<Token>> {
    let mut tokens = Vec::new();
    let mut at = 0;
    loop {
        at = skip_blank(text, at)?;
        let Some(first) = text[at..].chars().next() else {
            return Some(tokens);
        };
        let (kind, length) = if is_punctuation(first) {
            (Kind::Punctuation(first), first.len_utf8())
        } else if let Some(length) = quoted_length(&text[at..])? {
            (Kind::Quoted, length)
        } else {
            (Kind::Word, word_length(&text[at..]))
        };
        tokens.push(Token { kind, range: at..at + length });
        at += length;
    }
}

fn is_punctuation(c: char) -> bool {
    matches!(c, '(' | ')' | '[' | ']' | '{' | '}' | ',' | ':')
}

/// White space of the format, which includes the marks of writing direction.
pub(super) fn is_blank(c: char) -> bool {
    matches!(c, '\t'..='\r' | ' ' | '\u{85}' | '\u{200E}' | '\u{200F}' | '\u{2028}' | '\u{2029}')
}

/// Where the next token begins.
fn skip_blank(text: &str, mut at: usize) -> Option<usize> {
    loop {
        let rest = &text[at..];
        let blank = rest.len() - rest.trim_start_matches(is_blank).len();
        if blank > 0 {
            at += blank;
        } else if rest.starts_with("//") {
            at += rest.find('\n').unwrap_or(rest.len());
        } else if rest.starts_with("/*") {
            at += block_comment_length(rest)?;
        } else {
            return Some(at);
        }
    }
}

/// Block comments nest.
fn block_comment_length(rest: &str) -> Option<usize> {
    let bytes = rest.as_bytes();
    let (mut depth, mut at) = (0, 0);
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"/*" => (depth, at) = (depth + 1, at + 2),
            b"*/" => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// Length of the string or character that `rest` begins with, `Some(None)` where it begins with neither.
#[allow(clippy::option_option)]
fn quoted_length(rest: &str) -> Option<Option<usize>> {
    let prefix = rest.len() - rest.trim_start_matches(['b', 'r']).len();
    let body = &rest[prefix..];
    let hashes = body.len() - body.trim_start_matches('#').len();
    let raw = matches!(&rest[..prefix], "r" | "br") && body[hashes..].starts_with('"');
    if raw {
        let start = prefix + hashes + 1;
        let close = format!("\"{}", "#".repeat(hashes));
        return rest[start..].find(&close).map(|end| Some(start + end + close.len()));
    }
    let Some(quote) = body.chars().next().filter(|c| matches!(c, '"' | '\'') && matches!(&rest[..prefix], "" | "b"))
    else {
        return Some(None);
    };
    let mut escaped = false;
    for (at, c) in rest.char_indices().skip(prefix + 1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            c if c == quote => return Some(Some(at + 1)),
            _ => {}
        }
    }
    None
}

fn word_length(rest: &str) -> usize {
    let ends = |(at, c): &(usize, char)| {
        is_punctuation(*c) || is_blank(*c) || matches!(c, '"' | '\'') || (*c == '/' && *at > 0)
    };
    // A lone sign that opens neither word nor comment is a word too: every token has a length.
    rest.char_indices().skip(1).find(ends).map_or(rest.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(text: &str) -> Vec<&str> {
        tokens(text).unwrap().into_iter().map(|t| &text[t.range]).collect()
    }

    #[test]
    fn limit_comments_are_no_tokens_and_strings_are_one() {
        let text = "a/*(/* [ */ }*/: // )\n \"x ) \\\" // y\", r#\"q\" )\"#, b\"(\", '\"', -1.5e-3µ\u{2028})";
        assert_eq!(
            cut(text),
            ["a", ":", "\"x ) \\\" // y\"", ",", "r#\"q\" )\"#", ",", "b\"(\"", ",", "'\"'", ",", "-1.5e-3µ", ")"]
        );
    }

    #[test]
    fn limit_raw_identifiers_and_words_beginning_with_r_or_b_are_words() {
        assert_eq!(cut("rpm(r#type, br, b)"), ["rpm", "(", "r#type", ",", "br", ",", "b", ")"]);
    }

    #[test]
    fn limit_what_does_not_end_has_no_tokens() {
        for text in ["/* /* */", "\"abc", "r#\"abc\"", "'"] {
            assert_eq!(tokens(text), None, "{text}");
        }
        assert_eq!(tokens(" // end"), Some(vec![]));
    }
}
