//! The report as one HTML page that needs nothing else: figures are inline SVG, nothing is loaded from anywhere.

use super::content::{Content, Table};
use tribodyn_plot::Figure;

/// Light, for screen and paper; colours carry no meaning that words do not carry too.
const STYLE: &str = "
:root { color-scheme: light; }
body { font: 15px/1.5 system-ui, 'Helvetica Neue', Arial, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 1080px; margin: 0 auto; padding: 24px 28px 60px; }
h1 { font-size: 24px; line-height: 1.25; margin: 0 0 4px; }
h2 { font-size: 18px; margin: 34px 0 6px; border-bottom: 1px solid #c8c8c8; padding-bottom: 3px; }
p { margin: 6px 0 10px; }
.sub { color: #555; }
.warnings { border: 1px solid #b35900; border-left-width: 6px; background: #fff8ef; padding: 8px 16px; margin: 18px 0; }
.warnings h2 { border: 0; margin: 2px 0 4px; font-size: 16px; }
.warnings ul { margin: 4px 0; padding-left: 20px; }
table { border-collapse: collapse; font-size: 14px; }
th, td { text-align: left; vertical-align: top; padding: 3px 14px 3px 0; border-bottom: 1px solid #e4e4e4; overflow-wrap: anywhere; }
th { border-bottom: 2px solid #8a8a8a; }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; overflow-wrap: normal; }
.n + td, .wide th { white-space: nowrap; overflow-wrap: normal; }
.wide { width: 100%; font-size: 13px; }
.wide td:first-child { white-space: nowrap; overflow-wrap: normal; }
.class { font-weight: 600; white-space: nowrap; }
.assumed { font-style: italic; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(440px, 1fr)); gap: 0 40px; align-items: start; }
figure { margin: 18px 0; break-inside: avoid; text-align: center; }
figure svg { max-width: 100%; height: auto; }
pre { font: 12px/1.4 ui-monospace, Menlo, Consolas, monospace; background: #f6f6f6; padding: 12px; white-space: pre-wrap; }
nav a { margin-right: 14px; } a { color: #00548a; }
@media print { body { max-width: none; padding: 0; font-size: 12px; } nav, details:not([open]) { display: none; }
  table { font-size: 11px; } h2 { break-after: avoid; } tr { break-inside: avoid; } @page { margin: 16mm; } }
";

/// `report.html`.
pub fn page(content: &Content, figures: &[Figure]) -> String {
    let title = escape(&content.title);
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n<p class=\"sub\">{}</p>\n",
        escape(content.subtitle)
    );
    html += "<nav>";
    for (anchor, name) in
        [("case", "What was run"), ("results", "Results"), ("histories", "Figures"), ("file", "Case file")]
    {
        html += &format!("<a href=\"#{anchor}\">{name}</a>");
    }
    html += "</nav>\n";
    html += &warnings(content);
    html += "<div id=\"case\">\n";
    content.opening.iter().for_each(|t| html += &format!("<section>\n{}</section>\n", table(t)));
    html += "</div>\n";
    let (wide, narrow): (Vec<&Table>, Vec<&Table>) = content.tables.iter().partition(|t| t.wide);
    let (figured, wide): (Vec<&Table>, Vec<&Table>) = wide.into_iter().partition(|t| !t.numbers.is_empty());
    html += "<div class=\"pair\" id=\"results\">\n";
    narrow.iter().for_each(|t| html += &format!("<section>\n{}</section>\n", table(t)));
    html += "</div>\n";
    figured.iter().for_each(|t| html += &format!("<section>\n{}</section>\n", table(t)));
    html += "<h2 id=\"histories\">Figures</h2>\n";
    content.notes.iter().for_each(|note| html += &format!("<p>{}</p>\n", escape(note)));
    html += &drawings(figures);
    wide.iter().for_each(|t| html += &format!("<section>\n{}</section>\n", table(t)));
    if let Some(text) = &content.case_text {
        html += &format!(
            "<details id=\"file\">\n<summary>The whole case file</summary>\n<pre>{}</pre>\n</details>\n",
            escape(text)
        );
    }
    html + "</body>\n</html>\n"
}

fn warnings(content: &Content) -> String {
    if content.warnings.is_empty() {
        return String::new();
    }
    let items: String = content.warnings.iter().map(|w| format!("<li>{}</li>\n", escape(w))).collect();
    format!("<section class=\"warnings\">\n<h2>Warnings</h2>\n<ul>\n{items}</ul>\n</section>\n")
}

/// Figures of one panel width side by side, wide ones alone.
fn drawings(figures: &[Figure]) -> String {
    let one = |f: &Figure| {
        let alone = f.svg().trim_start_matches(|c| c != '\n').trim_start();
        let svg = if f.svg().starts_with("<?xml") { alone } else { f.svg() };
        format!("<figure id=\"{}\">\n{svg}\n</figure>\n", f.name)
    };
    let (polar, others): (Vec<&Figure>, Vec<&Figure>) = figures.iter().partition(|f| f.name.starts_with("orbit-"));
    let mut html: String = others.iter().map(|f| one(f)).collect();
    if !polar.is_empty() {
        html += "<div class=\"pair\">\n";
        polar.iter().for_each(|f| html += &one(f));
        html += "</div>\n";
    }
    html
}

fn table(table: &Table) -> String {
    let wide = if table.wide { " class=\"wide\"" } else { "" };
    let number = |k: usize| if table.numbers.contains(&k) { " class=\"n\"" } else { "" };
    let mut html =
        format!("<h2>{}</h2>\n<p class=\"sub\">{}</p>\n<table{wide}>\n<tr>", escape(&table.title), escape(&table.text));
    for (k, name) in table.header.iter().enumerate() {
        html += &format!("<th{}>{}</th>", number(k), escape(name));
    }
    html += "</tr>\n";
    for row in &table.rows {
        html += "<tr>";
        for (k, cell) in row.iter().enumerate() {
            let class = if table.header[k] == "Class" {
                format!(" class=\"class {}\"", escape(cell))
            } else {
                number(k).to_owned()
            };
            html += &format!("<td{class}>{}</td>", escape(cell));
        }
        html += "</tr>\n";
    }
    html + "</table>\n"
}

/// Text that cannot be taken for markup.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn limit_markup_in_a_case_stays_text() {
        assert_eq!(escape("<b> & \"x\""), "&lt;b&gt; &amp; &quot;x&quot;");
    }
}
