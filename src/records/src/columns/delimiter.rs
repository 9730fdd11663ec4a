//! Detects delimiters between the columns of a text, and splits lines at them.

use csv::ReaderBuilder;

/// Supported delimiters, in the order in which they are tried.
///
/// A comma may also be a decimal comma, so the tab and the semicolon come first. The bar is last, because it is rare.
pub(crate) const ALL: [u8; 4] = [b'\t', b';', b',', b'|'];

/// Detects the delimiter of a short table from its heading: the most frequent one, or a comma if there is none.
pub fn detect(heading: &str) -> u8 {
    let count = |d: u8| heading.bytes().filter(|b| *b == d).count();
    // If several delimiters are equally frequent, the first of this list has precedence.
    [b',', b';', b'\t', b'|'].into_iter().rev().max_by_key(|d| count(*d)).unwrap_or(b',')
}

/// Splits one line at a delimiter, with support for quotes.
pub(crate) fn split(line: &str, delimiter: u8) -> Vec<String> {
    // For a line without quotes, the setup of a reader would take longer than the split.
    if !line.is_empty() && !line.contains(['"', '\r', '\n']) {
        return line.split(char::from(delimiter)).map(str::to_owned).collect();
    }
    let mut reader =
        ReaderBuilder::new().has_headers(false).delimiter(delimiter).flexible(true).from_reader(line.as_bytes());
    reader.records().next().and_then(Result::ok).map(|r| r.iter().map(str::to_string).collect()).unwrap_or_default()
}

/// Returns whether quoted cells of comma-separated text contain decimal commas: `"0,5","12,75"`. A comma before three
/// digits is ambiguous, because it may separate thousands. A number with a point excludes decimal commas.
pub(crate) fn quotes_decimal_commas(text: &str) -> bool {
    /// Number of rows to inspect. In a column of numbers, decimals occur within these rows.
    const ROWS: usize = 500;
    let mut reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
    let mut told = false;
    for row in reader.records().take(ROWS).filter_map(Result::ok) {
        for cell in row.iter().map(str::trim) {
            let Some((whole, decimals)) = cell.split_once(',') else { continue };
            let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
            let (mantissa, _) = decimals.split_once(['e', 'E']).unwrap_or((decimals, ""));
            let whole = whole.trim_start_matches(['-', '+', '\u{2212}']);
            if whole.bytes().any(|b| !b.is_ascii_digit() && b != b'.') || whole.is_empty() {
                continue;
            }
            if cell.contains('.') {
                return false;
            }
            told |= digits(mantissa) && mantissa.len() != 3;
        }
    }
    told
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_delimiter_is_the_one_that_makes_most_columns() {
        for (heading, wanted) in [
            ("a,b,c", b','),
            ("a;b (x, y);c", b';'),
            ("a\tb\tc, d", b'\t'),
            ("a|b|c", b'|'),
            ("alone", b','),
            ("a,b;c", b','),
        ] {
            assert_eq!(detect(heading), wanted, "{heading}");
        }
    }

    #[test]
    fn commas_in_quotes_are_decimal_where_they_cannot_part_thousands() {
        for (text, wanted) in [
            ("\"t\",\"F\"\n\"0,5\",\"12,75\"\n", true),
            ("\"t\",\"F\"\n\"0,001\",\"1,234\"\n\"0,0015\",\"1,234\"\n", true),
            ("\"-1,5E-3\",\"2\"\n", true),
            ("t,F\n0.5,\"1,234\"\n0.6,\"12,345\"\n", false),
            ("t,F\n0.5,\"1,234.5\"\n0.6,\"1,23\"\n", false),
            ("\"Time, s\",\"Force, N\"\n0,1\n", false),
            ("", false),
        ] {
            assert_eq!(quotes_decimal_commas(text), wanted, "{text}");
        }
    }
}
