//! The report as one HTML page that needs nothing else: figures are inline SVG, which a script covers with interactive
//! ones on screen; nothing is loaded from anywhere.

use super::content::Content;
use super::live::Live;
use super::page_table::Table;
use tribodyn_plot::Figure;

/// Light and dark; colours carry no meaning that words do not carry too.
const STYLE: &str = include_str!("../assets/report/page.css");
const SCRIPT: &str = include_str!("../assets/report/page.js");
const UPLOT: &str = include_str!("../assets/uplot/uPlot.iife.min.js");
const UPLOT_STYLE: &str = include_str!("../assets/uplot/uPlot.min.css");
const UPLOT_LICENCE: &str = include_str!("../assets/uplot/LICENSE");

/// The figures beside the first results: the bearing, and the loads round it.
const LEADING: [&str; 3] = ["bearing", "orbit-load", "contact-loads"];

/// `report.html`: results with the bearing and its loads, the other figures, what was run, and every input folded.
pub fn page(content: &Content, figures: &[Figure], live: &Live) -> Result<String, serde_json::Error> {
    let (wide, narrow): (Vec<&Table>, Vec<&Table>) = content.tables.iter().partition(|t| t.wide);
    let (figured, wide): (Vec<&Table>, Vec<&Table>) = wide.into_iter().partition(|t| !t.numbers.is_empty());
    let (leading, others): (Vec<&Figure>, Vec<&Figure>) =
        figures.iter().partition(|figure| LEADING.contains(&figure.name.as_str()));
    let mut html = head(&content.title, content.subtitle);
    let before = narrow.first().copied().into_iter().chain(figured.iter().copied());
    html += &navigation(before, &wide, content);
    html += "<main>\n";
    html += &warnings(content);
    let beside: String = leading.iter().map(|f| drawing(f)).collect();
    let beside = (!beside.is_empty()).then(|| format!("<div>\n{beside}</div>\n"));
    let first = narrow.iter().take(1).map(|t| section(t));
    html += &pair(first.chain(beside));
    html += &pair(narrow.iter().skip(1).map(|t| section(t)));
    figured.iter().for_each(|t| html += &section(t));
    html += "<h2 id=\"figures\">Figures</h2>\n";
    content.notes.iter().for_each(|note| html += &format!("<p>{}</p>\n", escape(note)));
    html += &drawings(&others);
    content.opening.iter().chain(wide).for_each(|t| html += &section(t));
    html += &inputs(content);
    html += "</main>\n";
    html += &script(live)?;
    Ok(html + "</body>\n</html>\n")
}

/// Parts side by side where the page is wide enough; nothing without any.
fn pair(parts: impl Iterator<Item = String>) -> String {
    let inside: String = parts.collect();
    if inside.is_empty() { inside } else { format!("<div class=\"pair\">\n{inside}</div>\n") }
}

/// Every value of the case, and the case file: folded, they are longer than all else.
fn inputs(content: &Content) -> String {
    let mut html = String::new();
    if !content.inputs.is_empty() {
        let tables: String = content.inputs.iter().map(section).collect();
        html += &format!(
            "<h2 id=\"inputs\">Inputs</h2>\n<details>\n<summary>Every value of the case, with its source</summary>\n{tables}</details>\n"
        );
    }
    if let Some(text) = &content.case_text {
        html += &format!(
            "<h2 id=\"case-file\">Case file</h2>\n<details>\n<summary>The whole case file</summary>\n<pre>{}</pre>\n</details>\n",
            escape(text)
        );
    }
    html
}

fn head(title: &str, subtitle: &str) -> String {
    let (title, subtitle) = (escape(title), escape(subtitle));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"generator\" content=\"tribodyn\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n\
         <style>{UPLOT_STYLE}\n{STYLE}</style>\n</head>\n<body>\n\
         <header>\n<h1>{title}</h1>\n<p class=\"sub\">{subtitle}</p>\n</header>\n"
    )
}

/// Links to the parts of the page.
fn navigation<'a>(before: impl Iterator<Item = &'a Table>, after: &[&Table], content: &Content) -> String {
    let link = |anchor: &str, name: &str| format!("<a href=\"#{anchor}\">{}</a>", escape(name));
    let mut links: String = before.map(|t| link(&anchor(&t.title), &t.title)).collect();
    links += &link("figures", "Figures");
    links.extend(content.opening.iter().chain(after.iter().copied()).map(|t| link(&anchor(&t.title), &t.title)));
    if !content.inputs.is_empty() {
        links += &link("inputs", "Inputs");
    }
    if content.case_text.is_some() {
        links += &link("case-file", "Case file");
    }
    format!("<nav><div>{links}</div></nav>\n")
}

/// Letters and digits of a title in lower case, hyphens between words.
fn anchor(title: &str) -> String {
    let words = title.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join("-")
}

/// Data, library and script of the interactive figures.
fn script(live: &Live) -> Result<String, serde_json::Error> {
    if live.is_empty() {
        return Ok(String::new());
    }
    Ok(format!(
        "<script type=\"application/json\" id=\"charts\">{}</script>\n<script>\n/*\nuPlot\n\n{UPLOT_LICENCE}*/\n{UPLOT}</script>\n<script>\n{SCRIPT}</script>\n",
        live.json()?
    ))
}

fn warnings(content: &Content) -> String {
    if content.warnings.is_empty() {
        return String::new();
    }
    let items: String = content.warnings.iter().map(|w| format!("<li>{}</li>\n", escape(w))).collect();
    format!("<section class=\"warnings\">\n<h2>Warnings</h2>\n<ul>\n{items}</ul>\n</section>\n")
}

/// A figure as its drawing.
fn drawing(f: &Figure) -> String {
    let alone = f.svg().trim_start_matches(|c| c != '\n').trim_start();
    let svg = if f.svg().starts_with("<?xml") { alone } else { f.svg() };
    let wide = svg.split('"').nth(3).filter(|text| text.parse::<f64>().is_ok()).unwrap_or("0");
    let class = format!("class=\"still\" style=\"--wide: {wide}px\"");
    format!("<figure id=\"{}\">\n<div {class}>\n{}</div>\n</figure>\n", f.name, compact(svg))
}

/// Figures of one panel width side by side, wide ones alone.
fn drawings(figures: &[&Figure]) -> String {
    let (polar, others): (Vec<&Figure>, Vec<&Figure>) = figures.iter().partition(|f| f.name.starts_with("orbit-"));
    let html: String = others.iter().map(|f| drawing(f)).collect();
    html + &pair(polar.iter().map(|f| drawing(f)))
}

/// The same drawing with paths of lines in relative coordinates of one decimal: about half as long.
///
/// Differences are those of rounded places, so that errors do not add up.
fn compact(svg: &str) -> String {
    let mut pieces = svg.split(" d=\"M");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (path, rest) = piece.split_once('"').unwrap_or((piece, ""));
        text += " d=\"";
        text += &relative(path).unwrap_or_else(|| format!("M{path}"));
        text += "\"";
        text += rest;
    }
    text
}

/// `71.25 20.5 L72 23` as `M71.3 20.5l.7 2.5`; None where a path is anything else than one line.
fn relative(path: &str) -> Option<String> {
    let tenths = |text: &str| text.parse::<f64>().ok().map(|v| (10.0 * v).round() as i64);
    let mut short = String::with_capacity(path.len() / 2);
    let mut last = None;
    for point in path.split(" L") {
        let (x, y) = point.split_once(' ')?;
        let (x, y) = (tenths(x)?, tenths(y)?);
        match last {
            None => short += &format!("M{} {}l", decimal(x), decimal(y)),
            Some((from_x, from_y)) if (from_x, from_y) == (x, y) => continue,
            Some((from_x, from_y)) => {
                for step in [decimal(x - from_x), decimal(y - from_y)] {
                    let apart = !(short.ends_with('l') || step.starts_with('-'));
                    short += if apart { " " } else { "" };
                    short += &step;
                }
            }
        }
        last = Some((x, y));
    }
    Some(short.trim_end_matches('l').to_owned())
}

/// Tenths as a number without what is not needed: `-.5`, `12`.
fn decimal(tenths: i64) -> String {
    let (sign, whole, part) = (if tenths < 0 { "-" } else { "" }, tenths.abs() / 10, tenths.abs() % 10);
    match (whole, part) {
        (whole, 0) => format!("{sign}{whole}"),
        (0, part) => format!("{sign}.{part}"),
        (whole, part) => format!("{sign}{whole}.{part}"),
    }
}

fn section(table: &Table) -> String {
    let class = if table.wide { " class=\"wide\"" } else { "" };
    let kind = if table.header.len() == 2 && table.wide { " class=\"facts\"" } else { "" };
    let number = |k: usize| if table.numbers.contains(&k) { " class=\"n\"" } else { "" };
    let mut html = format!("<section{class}>\n<h2 id=\"{}\">{}</h2>\n", anchor(&table.title), escape(&table.title));
    if !table.text.is_empty() {
        html += &format!("<p class=\"sub\">{}</p>\n", escape(&table.text));
    }
    html += &format!("<div class=\"scroll\" tabindex=\"0\">\n<table{kind}>\n<thead><tr>");
    for (k, name) in table.header.iter().enumerate() {
        html += &format!("<th{}>{}</th>", number(k), escape(name));
    }
    html += "</tr></thead>\n<tbody>\n";
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
    html + "</tbody>\n</table>\n</div>\n</section>\n"
}

/// Text that cannot be taken for markup.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_markup_in_a_case_stays_text() {
        assert_eq!(escape("<b> & \"x\""), "&lt;b&gt; &amp; &quot;x&quot;");
    }

    #[test]
    fn identity_compact_paths_end_where_the_long_ones_do() {
        assert_eq!(relative("71.25 20.5 L72 23 L72.04 22.98 L71.5 23").unwrap(), "M71.3 20.5l.7 2.5-.5 0");
        let points: Vec<[f64; 2]> = (0..2000).map(|k| [0.33 * k as f64, 90.0 * (0.7 * k as f64).sin()]).collect();
        let long: Vec<String> = points.iter().map(|[x, y]| format!("{x:.2} {y:.2}")).collect();
        let long = long.join(" L");
        let short = relative(&long).unwrap();
        assert!(10 * short.len() < 6 * long.len(), "{} of {}", short.len(), long.len());
        let spaced = short[1..].replace('-', " -").replace('l', " ");
        let sums = spaced.split_whitespace().enumerate().fold([0.0; 2], |mut sums, (k, step)| {
            sums[k % 2] += step.parse::<f64>().unwrap();
            sums
        });
        let end = points[points.len() - 1];
        assert!((sums[0] - end[0]).abs() < 0.06 && (sums[1] - end[1]).abs() < 0.06, "{sums:?} {end:?}");
    }

    #[test]
    fn limit_other_paths_and_elements_stay() {
        let svg = "<path d=\"M1 2 L3 4 Z\" fill=\"x\"/><line x1=\"1.25\"/>";
        assert_eq!(compact(svg), svg);
        assert_eq!(compact("<path d=\"M1.25 2 L3 4\"/>"), "<path d=\"M1.3 2l1.7 2\"/>");
    }

    #[test]
    fn limit_the_embedded_scripts_do_not_end_their_element() {
        for text in [SCRIPT, UPLOT, UPLOT_LICENCE] {
            assert!(!text.to_lowercase().contains("</script") && !text.contains("<!--"));
        }
        assert!(!UPLOT_LICENCE.contains("*/"));
    }
}
