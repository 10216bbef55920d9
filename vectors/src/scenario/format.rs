//! Scenario text as it is to be laid out.

/// The longest cell for which the others of its column are padded.
const PADDED: usize = 40;

/// The text with its cells aligned group by group, bodies indented by four spaces, and single empty lines between
/// groups and before rows. What it means does not change.
#[must_use]
pub fn formatted(text: &str) -> String {
    let mut out = String::new();
    let mut rows: Vec<&str> = Vec::new();
    let mut is_header = false;
    for line in text.lines().map(str::trim_end) {
        let is_group = line.starts_with('[') && line.ends_with(']');
        if is_group || line.starts_with('#') {
            flush(&mut rows, &mut out);
            // The comment of a group and its name stand together, apart from what is above.
            let follows = out.is_empty() || out.lines().last().is_some_and(|last| last.starts_with('#'));
            if !follows && !out.ends_with("\n\n") {
                out.push('\n');
            }
            out.push_str(line);
            out.push('\n');
            is_header = is_group;
        } else if line.is_empty() {
            flush(&mut rows, &mut out);
            is_header = false;
        } else if is_header {
            let (key, value) = line.split_once(':').unwrap_or((line, ""));
            out.push_str(&format!("{key}: {}\n", value.trim()));
        } else {
            if rows.is_empty() && !out.ends_with("\n\n") {
                out.push('\n');
            }
            rows.push(line);
        }
    }
    flush(&mut rows, &mut out);
    out.trim_end().to_owned() + "\n"
}

/// Writes the rows of a group.
fn flush(rows: &mut Vec<&str>, out: &mut String) {
    let cells = |row: &str| row.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(str::to_owned).collect();
    let split: Vec<Vec<String>> = rows
        .drain(..)
        .map(|row| match row.strip_prefix(' ') {
            Some(body) => vec![String::new(), body.trim().to_owned()],
            None => cells(row),
        })
        .collect();
    let is_row = |cells: &&Vec<String>| cells.first().is_some_and(|name| !name.is_empty());
    let width = |column: usize| {
        let lengths =
            split.iter().filter(is_row).filter_map(|cells| cells.get(column)).map(|cell| cell.chars().count());
        lengths.filter(|length| *length <= PADDED).max().unwrap_or_default()
    };
    for cells in &split {
        if !is_row(&cells) {
            out.push_str(&format!("    {}\n", cells.concat()));
            continue;
        }
        let last = cells.len() - 1;
        for (column, cell) in cells.iter().enumerate() {
            let (width, gap) = if column == last { (0, "\n") } else { (width(column), "  ") };
            out.push_str(&format!("{cell:width$}{gap}"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# Why.\n[a]\ncolumns:  x\n\none  1\ntwo-or-more  2\n   go 5;  ask\n\n\n\n[b]\n\nlast  3\n";
    const LAID_OUT: &str =
        "# Why.\n[a]\ncolumns: x\n\none          1\ntwo-or-more  2\n    go 5;  ask\n\n[b]\n\nlast  3\n";

    #[test]
    fn cells_are_aligned_and_groups_set_apart() {
        assert_eq!(formatted(TEXT), LAID_OUT);
    }

    #[test]
    fn what_is_laid_out_stays_as_it_is() {
        assert_eq!(formatted(LAID_OUT), LAID_OUT);
    }
}
