//! The report as Markdown, and its first tables as plain text for the terminal.

use super::content::{Content, Table};
use tribodyn_plot::Figure;

/// `summary.md`.
pub fn page(content: &Content, figures: &[Figure]) -> String {
    let mut text = format!("# {}\n", content.title);
    if !content.warnings.is_empty() {
        text += "\n## Warnings\n\n";
        content.warnings.iter().for_each(|warning| text += &format!("- {warning}\n"));
    }
    content.tables.iter().for_each(|table| text += &markdown(table));
    text += "\n## Figures\n";
    for figure in figures {
        text += &format!("\n### {}\n\n![{}]({}.svg)\n", figure.title, figure.title, figure.name);
    }
    content.notes.iter().for_each(|note| text += &format!("\n{note}\n"));
    text
}

fn markdown(table: &Table) -> String {
    let cell = |text: &str| text.replace('|', "\\|");
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = format!("\n## {}\n\n{}\n\n", table.title, table.text);
    text += &line(table.header.iter().map(|h| cell(h)).collect());
    let rule = |k: usize| if table.numbers.contains(&k) { "---:" } else { "---" }.to_owned();
    text += &line((0..table.header.len()).map(rule).collect());
    table.rows.iter().for_each(|row| text += &line(row.iter().map(|c| cell(c)).collect()));
    text
}

/// Warnings, the first table, and that of figures set against those of the run.
pub fn plain(content: &Content) -> String {
    let mut lines = vec![content.title.clone(), String::new()];
    let validation = content.tables.iter().find(|table| table.wide && !table.numbers.is_empty());
    for table in content.tables.iter().take(1).chain(validation) {
        if table.wide {
            lines.extend([String::new(), table.text.clone()]);
        }
        // The source of a figure would be too long.
        let columns = table.header.len() - usize::from(table.wide);
        let width = |k: usize| table.rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        lines.extend(table.rows.iter().map(|row| {
            let cell = |k: usize| {
                let wide = widths[k];
                if table.numbers.contains(&k) { format!("{:>wide$}", row[k]) } else { format!("{:wide$}", row[k]) }
            };
            (0..columns).map(cell).collect::<Vec<_>>().join("  ").trim_end().to_owned()
        }));
    }
    lines.extend(content.warnings.iter().map(|warning| format!("warning: {warning}")));
    lines.extend(content.notes.iter().cloned());
    lines.join("\n")
}
