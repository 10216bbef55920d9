//! The little of Markdown that the tables need.

/// The cells of a table row; a bar within a cell is escaped.
pub(crate) fn cells(row: &str) -> Vec<String> {
    let row = row.trim().replace("\\|", "\u{0}");
    let row = row.strip_prefix('|').unwrap_or(&row);
    let row = row.strip_suffix('|').unwrap_or(row);
    row.split('|').map(|cell| cell.trim().replace('\u{0}', "|")).collect()
}

/// The rows of the first table whose header begins with `header`, such as `| plane |`.
pub(crate) fn rows_below(text: &str, header: &str) -> Vec<Vec<String>> {
    let rows = text.lines().skip_while(|line| !line.starts_with(header)).skip(2);
    rows.take_while(|line| line.starts_with('|')).map(cells).collect()
}
