//! Output of text to the terminal. Names of files, headings and entries of tables come from unknown sources. Therefore,
//! characters that would move the cursor, color the text or reorder it are escaped.

use anyhow::Context as _;
use std::borrow::Cow;
use std::io::Write;

/// Returns whether a character affects a terminal, or the order of the text around it.
///
/// These are control characters except line feed and tab, the direction marks of Unicode's annex 9, and the separators
/// of lines and paragraphs.
fn acts(c: char) -> bool {
    let is_mark = matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    (c.is_control() && c != '\n' && c != '\t') || is_mark
}

/// Escapes every character that affects a terminal, in the form `\u{1b}`.
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.chars().any(acts) {
        return text.into();
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if acts(c) {
            shown.extend(c.escape_unicode());
        } else {
            shown.push(c);
        }
    }
    shown.into()
}

/// Prints a line on standard output.
pub(crate) fn line(text: &str) -> anyhow::Result<()> {
    writeln!(std::io::stdout().lock(), "{}", printable(text)).context("cannot write to standard output")
}

/// Prints a line on standard error. A failure is ignored, because it cannot be reported.
pub fn warn(text: &str) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable(text));
}

/// Prints a line on standard error, and returns an error if that fails.
pub(crate) fn warn_or_fail(text: &str) -> anyhow::Result<()> {
    writeln!(std::io::stderr().lock(), "{}", printable(text)).context("cannot write to standard error")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_acts_on_a_terminal_is_shown() {
        assert_eq!(printable("Kraft [N]\tµ 减振器\n"), "Kraft [N]\tµ 减振器\n");
        assert_eq!(printable("a\u{1b}[31mred\r\u{7}"), "a\\u{1b}[31mred\\u{d}\\u{7}");
        assert_eq!(printable("\u{9b}2J\u{202e}vsc.exe\u{2066}"), "\\u{9b}2J\\u{202e}vsc.exe\\u{2066}");
    }
}
