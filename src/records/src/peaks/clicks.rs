//! Tables of peak force over peak velocity of an adjustable damper. They have a column for every click (`C 10 clk`) or
//! a column that states the clicks. Each click has one curve.

use crate::columns::cell::number;
use crate::columns::table::HEADER_WITHIN;
use crate::quantities::setting_value::CLICKS;

/// Rows of a table with their line numbers.
pub(crate) type TableRows = Vec<(usize, Vec<String>)>;

/// Positions of the clicks in a table.
struct Layout {
    /// Index of the heading among the rows.
    header: usize,
    /// For every column with a click in its heading: the click, and the heading without the click.
    columns: Vec<Option<(f64, String)>>,
    /// Index of the column that states the clicks of each row.
    of_rows: Option<usize>,
}

/// Returns the distinct clicks of a table in ascending order, or an empty list for a table without clicks.
pub(crate) fn clicks(rows: &[(usize, Vec<String>)]) -> Vec<f64> {
    let Some(layout) = layout(rows) else { return Vec::new() };
    let in_rows = rows[layout.header + 1..].iter().filter_map(|(_, cells)| number(cells.get(layout.of_rows?)?, true));
    let mut all: Vec<f64> =
        layout.columns.iter().flatten().map(|(click, _)| *click).chain(in_rows).filter(|c| c.is_finite()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// Returns the table of one click: clears the columns and removes the rows of all other clicks. Also removes the click
/// from the headings.
pub(crate) fn only(mut rows: TableRows, wanted: f64) -> TableRows {
    let Some(layout) = layout(&rows) else { return rows };
    if let Some(of_rows) = layout.of_rows {
        let is_other = |cells: &[String]| {
            cells
                .get(of_rows)
                .and_then(|cell| number(cell, true))
                .is_some_and(|click| click.is_finite() && click != wanted)
        };
        let mut place = 0..;
        rows.retain(|(_, cells)| place.next().is_some_and(|k: usize| k <= layout.header) || !is_other(cells));
    }
    for (k, (_, cells)) in rows.iter_mut().enumerate().skip(layout.header) {
        for (cell, column) in cells.iter_mut().zip(&layout.columns) {
            match column {
                Some((click, heading)) if *click == wanted && k == layout.header => cell.clone_from(heading),
                Some((click, _)) if *click != wanted => cell.clear(),
                _ => {}
            }
        }
        if let Some(cell) = layout.of_rows.and_then(|k| cells.get_mut(k)) {
            cell.clear();
        }
    }
    rows
}

fn layout(rows: &[(usize, Vec<String>)]) -> Option<Layout> {
    rows.iter().take(HEADER_WITHIN).enumerate().find_map(|(header, (_, cells))| {
        let columns: Vec<Option<(f64, String)>> = cells.iter().map(|cell| click_of(cell)).collect();
        let of_rows = cells.iter().position(|cell| {
            let parts = parts(cell);
            parts.iter().any(|part| is_click(part)) && parts.iter().all(|part| number(part, true).is_none())
        });
        // A heading line has more than one cell.
        let has_others = cells.len() > 1;
        let found = has_others && (columns.iter().flatten().count() > 0 || of_rows.is_some());
        found.then_some(Layout { header, columns, of_rows })
    })
}

/// Returns the click in a heading and the rest of the heading: `C 10 clk` gives 10 and `C`.
fn click_of(cell: &str) -> Option<(f64, String)> {
    let parts = parts(cell);
    let word = parts.iter().position(|part| is_click(part))?;
    // The number is before or after the word for clicks.
    let place = [word.checked_sub(1), Some(word + 1)].into_iter().flatten();
    let (at, click) = place.filter_map(|k| Some((k, number(parts.get(k)?, true).filter(|c| c.is_finite())?))).next()?;
    let rest = parts.iter().enumerate().filter(|(k, _)| *k != word && *k != at);
    Some((click, rest.map(|(_, part)| part.as_str()).collect::<Vec<_>>().join(" ")))
}

fn is_click(part: &str) -> bool {
    CLICKS.contains(&part.to_lowercase().as_str())
}

/// Splits a heading into words and numbers.
fn parts(cell: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in cell.trim().chars() {
        let is_digit = |c: char| c.is_ascii_digit() || c == '.';
        if c.is_whitespace() || c == '_' {
            before = ' ';
            continue;
        }
        match parts.last_mut() {
            Some(part) if before != ' ' && is_digit(before) == is_digit(c) => part.push(c),
            _ => parts.push(c.to_string()),
        }
        before = c;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(lines: &[&str]) -> TableRows {
        let cells = |line: &str| line.split(',').map(str::to_owned).collect();
        lines.iter().enumerate().map(|(k, line)| (k + 1, cells(line))).collect()
    }

    #[test]
    fn columns_of_a_click_are_parted_from_those_of_others() {
        let rows = table(&["Vel (in/s),C 0 clk,C 10 clk,R 0 clk,R 10clk", "1,40,25,60,36", "3,70,48,110,70"]);
        assert_eq!(clicks(&rows), [0.0, 10.0]);
        let one = only(rows, 10.0);
        assert_eq!(one[0].1, ["Vel (in/s)", "", "C", "", "R"]);
        assert_eq!(one[2].1, ["3", "", "48", "", "70"]);
    }

    #[test]
    fn rows_of_a_click_are_parted_from_those_of_others() {
        let rows = table(&["v [m/s],Clicks,rebound [N]", "0.1,0,300", "0.1,5,200", "0.3,0,700"]);
        assert_eq!(clicks(&rows), [0.0, 5.0]);
        let one = only(rows, 0.0);
        let lines: Vec<usize> = one.iter().map(|row| row.0).collect();
        assert!(lines == [1, 2, 4] && one[0].1[1].is_empty() && one[1].1 == ["0.1", "", "300"], "{one:?}");
    }

    #[test]
    fn other_tables_have_no_clicks() {
        let rows = table(&["velocity [m/s],rebound [N],compression [N]", "0.1,300,200"]);
        assert!(clicks(&rows).is_empty() && only(rows.clone(), 0.0) == rows);
    }
}
