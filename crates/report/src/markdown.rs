//! The report as Markdown, and its first tables as plain text for the terminal.

use super::content::Content;
use super::page_table::Table;
use crate::words::visible;
use tribodyn_plot::Figure;

/// `summary.md`.
pub fn page(content: &Content, figures: &[Figure]) -> String {
    let mut text = format!("# {}\n\n{}\n", escape(&content.title), content.subtitle);
    if !content.warnings.is_empty() {
        text += "\n## Warnings\n\n";
        content.warnings.iter().for_each(|warning| text += &format!("- {}\n", escape(warning)));
    }
    content.tables.iter().chain(&content.opening).for_each(|table| text += &markdown(table));
    text += "\n## Figures\n";
    for figure in figures {
        let title = escape(&figure.title);
        text += &format!("\n### {title}\n\n![{title}]({}.svg)\n", figure.name);
    }
    content.notes.iter().for_each(|note| text += &format!("\n{}\n", escape(note)));
    content.inputs.iter().for_each(|table| text += &markdown(table));
    text
}

fn markdown(table: &Table) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = format!("\n## {}\n\n", escape(&table.title));
    if !table.text.is_empty() {
        text += &format!("{}\n\n", escape(&table.text));
    }
    text += &line(table.header.iter().map(|h| escape(h)).collect());
    let rule = |k: usize| if table.numbers.contains(&k) { "---:" } else { "---" }.to_owned();
    text += &line((0..table.header.len()).map(rule).collect());
    table.rows.iter().for_each(|row| text += &line(row.iter().map(|c| escape(c)).collect()));
    text
}

/// Text on one line that no reader of Markdown takes for markup.
fn escape(text: &str) -> String {
    let letters: Vec<char> = visible(text).chars().collect();
    let inside_word = |k: usize| {
        let word = |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(|c| c.is_alphanumeric());
        word(k.checked_sub(1)) && word(Some(k + 1))
    };
    let mut escaped = String::new();
    for (k, letter) in letters.iter().enumerate() {
        match letter {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            // An underscore inside a word is one.
            '_' if inside_word(k) => escaped.push('_'),
            '\\' | '|' | '*' | '_' | '`' | '[' | ']' | '~' | '#' | '!' | '$' => escaped.extend(['\\', *letter]),
            _ => escaped.push(*letter),
        }
    }
    escaped
}

/// The table of the figures set against those of the run.
const VALIDATION: &str = "Validation";

/// The first table of results, that of figures set against those of the run, and the warnings.
pub fn plain(content: &Content) -> String {
    let mut lines = vec![visible(&content.title), String::new()];
    let validation = content.tables.iter().filter(|table| table.title == VALIDATION);
    let first = content.tables.iter().find(|table| table.title != VALIDATION);
    for table in first.into_iter().chain(validation) {
        let compared = table.title == VALIDATION;
        if compared {
            lines.extend([String::new(), table.text.clone()]);
        }
        // The source of a figure would be too long.
        let columns = table.header.len() - usize::from(compared);
        let cells = table.rows.iter().map(|row| row.iter().map(|cell| visible(cell)).collect::<Vec<_>>());
        let mut rows: Vec<Vec<String>> = cells.collect();
        if columns > 3 && !compared {
            rows.insert(0, table.header.iter().map(|h| (*h).to_owned()).collect());
        }
        let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        lines.extend(rows.iter().map(|row| {
            let cell = |k: usize| {
                let wide = widths[k];
                if table.numbers.contains(&k) { format!("{:>wide$}", row[k]) } else { format!("{:wide$}", row[k]) }
            };
            (0..columns).map(cell).collect::<Vec<_>>().join("  ").trim_end().to_owned()
        }));
    }
    lines.extend(content.warnings.iter().map(|warning| visible(&format!("warning: {warning}"))));
    lines.extend(content.notes.iter().map(|note| visible(note)));
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn limit_a_name_stays_text() {
        for (name, expected) in [
            ("ball_count", "ball_count"),
            ("_x_ a|b", "\\_x\\_ a\\|b"),
            ("<script>alert(1)</script> & `code`", "&lt;script&gt;alert(1)&lt;/script&gt; &amp; \\`code\\`"),
            ("**bold** [a](b) # h", "\\*\\*bold\\*\\* \\[a\\](b) \\# h"),
            ("one\n\n# two\u{1b}[2J", "one  \\# two\u{fffd}\\[2J"),
            ("back\\slash", "back\\\\slash"),
        ] {
            assert_eq!(escape(name), expected);
        }
    }
}
