//! A document, and its two forms: Markdown, and one HTML page that needs nothing but itself.

use std::fmt::Write as _;

/// A piece of a document. Texts may hold `` `code` ``, `**bold**` and `[words](link)`.
#[derive(Debug, Clone, PartialEq, Eq)]
#[allow(dead_code, reason = "only some pages hold formulas and details")]
pub(crate) enum Block {
    /// A heading of a level from 1 to 4, with the name by which links reach it.
    Heading(u8, String, String),
    /// A paragraph.
    Text(String),
    /// A formula or a piece of code, kept as it is.
    Code(String),
    /// A list.
    List(Vec<String>),
    /// A table: its head and its rows.
    Table(Vec<String>, Vec<Vec<String>>),
    /// What is there for who asks for it, under a line that says what it is.
    Details(String, Vec<Block>),
}

/// A heading that links reach by its words.
pub(crate) fn heading(level: u8, title: &str) -> Block {
    let name = title.to_lowercase().replace(|c: char| !c.is_alphanumeric(), "-");
    Block::Heading(level, name, title.to_owned())
}

/// A paragraph.
pub(crate) fn text(words: impl Into<String>) -> Block {
    Block::Text(words.into())
}

/// A table.
pub(crate) fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Block {
    Block::Table(head.iter().map(|cell| (*cell).to_owned()).collect(), rows.into_iter().collect())
}

/// As Markdown.
pub(crate) fn markdown(blocks: &[Block]) -> String {
    let mut text = String::new();
    for block in blocks {
        match block {
            Block::Heading(level, _, title) => {
                let _ = writeln!(text, "{} {title}\n", "#".repeat(usize::from(*level)));
            }
            Block::Text(words) => {
                let _ = writeln!(text, "{words}\n");
            }
            Block::Code(code) => {
                let _ = writeln!(text, "```\n{code}\n```\n");
            }
            Block::List(items) => {
                for item in items {
                    let _ = writeln!(text, "- {item}");
                }
                text.push('\n');
            }
            Block::Table(head, rows) => {
                let row = |cells: &[String]| {
                    let cells: Vec<String> = cells.iter().map(|c| c.replace('|', "\\|")).collect();
                    format!("| {} |\n", cells.join(" | "))
                };
                text.push_str(&row(head));
                text.push_str(&format!("|{}\n", "---|".repeat(head.len())));
                for cells in rows {
                    text.push_str(&row(cells));
                }
                text.push('\n');
            }
            Block::Details(title, inner) => {
                let _ = writeln!(text, "{title}:\n\n{}", markdown(inner));
            }
        }
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

/// As a page of HTML.
pub(crate) fn html(blocks: &[Block]) -> String {
    let title = blocks.iter().find_map(|block| match block {
        Block::Heading(1, _, title) => Some(escaped(title)),
        _ => None,
    });
    let title = title.unwrap_or_default();
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
        body(blocks)
    )
}

const STYLE: &str = include_str!("document.css");

fn body(blocks: &[Block]) -> String {
    let mut text = String::new();
    for block in blocks {
        let _ = match block {
            Block::Heading(level, name, title) => {
                writeln!(text, "<h{level} id=\"{}\">{}</h{level}>", escaped(name), inline(title))
            }
            Block::Text(words) => writeln!(text, "<p>{}</p>", inline(words)),
            Block::Code(code) => writeln!(text, "<pre>{}</pre>", escaped(code)),
            Block::List(items) => {
                let items: String = items.iter().map(|item| format!("<li>{}</li>\n", inline(item))).collect();
                writeln!(text, "<ul>\n{items}</ul>")
            }
            Block::Table(head, rows) => {
                let head: String = head.iter().map(|cell| format!("<th scope=\"col\">{}</th>", inline(cell))).collect();
                let rows: String = rows.iter().map(|cells| row(cells)).collect();
                writeln!(
                    text,
                    "<div class=\"wide\"><table>\n<thead><tr>{head}</tr></thead>\n\
                     <tbody>\n{rows}</tbody>\n</table></div>"
                )
            }
            Block::Details(title, inner) => {
                writeln!(text, "<details>\n<summary>{}</summary>\n{}</details>", inline(title), body(inner))
            }
        };
    }
    text
}

fn row(cells: &[String]) -> String {
    let cells: String = cells
        .iter()
        .map(|cell| {
            // What was only tried on values has no colour.
            let class = if cell.starts_with("proved") || cell.starts_with("refuted") {
                " class=\"good\""
            } else if cell.starts_with("failed") || cell.starts_with("NOT") {
                " class=\"bad\""
            } else {
                ""
            };
            format!("<td{class}>{}</td>", inline(cell))
        })
        .collect();
    format!("<tr>{cells}</tr>\n")
}

/// Code, links and bold words of a text.
fn inline(words: &str) -> String {
    let mut text = String::new();
    for (nth, part) in words.split('`').enumerate() {
        if nth % 2 == 1 {
            // A command is to be copied as one line.
            let is_command = part.starts_with("cargo ") || part.starts_with("proofs/machine/");
            let class = if is_command { " class=\"line\"" } else { "" };
            let _ = write!(text, "<code{class}>{}</code>", escaped(part));
            continue;
        }
        let mut rest = part;
        while let Some((before, label, link, after)) = link(rest) {
            let _ = write!(text, "{}<a href=\"{}\">{}</a>", escaped(before), escaped(link), escaped(label));
            rest = after;
        }
        text.push_str(&escaped(rest));
    }
    let parts = text.split("**").enumerate();
    parts.map(|(nth, part)| if nth % 2 == 1 { format!("<strong>{part}</strong>") } else { part.to_owned() }).collect()
}

/// The first link of a text: what stands before it, its words, where it leads, and what follows.
fn link(text: &str) -> Option<(&str, &str, &str, &str)> {
    let (head, rest) = text.split_once("](")?;
    let (before, label) = head.rsplit_once('[')?;
    let (link, after) = rest.split_once(')')?;
    Some((before, label, link, after))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_say_the_same() {
        let blocks = [
            Block::Heading(1, "top".into(), "A < B".into()),
            Block::Text("See `a | b` and [there](x.smt2), **now**.".into()),
            Block::Table(vec!["p".into()], vec![vec!["proved".into()]]),
        ];
        assert_eq!(
            markdown(&blocks),
            "# A < B\n\nSee `a | b` and [there](x.smt2), **now**.\n\n| p |\n|---|\n| proved |\n"
        );
        let page = html(&blocks);
        for part in [
            "<h1 id=\"top\">A &lt; B</h1>",
            "<code>a | b</code> and <a href=\"x.smt2\">there</a>, <strong>now</strong>.",
            "<td class=\"good\">proved</td>",
        ] {
            assert!(page.contains(part), "{part}\n{page}");
        }
    }
}
