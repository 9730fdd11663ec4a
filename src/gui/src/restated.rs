//! Sentences of the reports in the units on screen.
//!
//! The reports state forces in N and lengths in mm. The window states them in the units that the user chose, so that a number in a
//! sentence equals the number of a plot. A unit applies to the number before it, and to numbers that a range or a tolerance connects with
//! this number: `0.6 to 1.2 N`, `31 ± 4 N`, `3 N (95 %: 2 to 4)`.

use crate::units::{Shown, Units, read};
use dashpot_messages::Sentence;
use dashpot_records::{Channel, Unit};
use dashpot_report::words::{VALUE, Words};
use std::ops::Range;
use std::sync::LazyLock;

/// Units of stiffness, damping and energy in the texts of the reports: symbol, SI unit, and the value of one such unit in SI. [`Unit`]
/// contains the units of files.
const DERIVED: &[(&str, &str, f64)] = &[
    ("N·s/mm", "N s/m", 1e3),
    ("N·s/m", "N s/m", 1.0),
    ("N s/m", "N s/m", 1.0),
    ("N/mm³", "N/m^3", 1e9),
    ("N/mm²", "N/m^2", 1e6),
    ("N/mm", "N/m", 1e3),
    ("N/m²", "N/m^2", 1.0),
    ("N/m³", "N/m^3", 1.0),
    ("N/m⁴", "N/m^4", 1.0),
    ("N/m", "N/m", 1.0),
    ("J", "J", 1.0),
];

/// All units that are converted. A longer symbol comes before a shorter symbol with which it begins.
static KNOWN: LazyLock<Vec<(&str, &str, f64)>> = LazyLock::new(|| {
    let of_channels = [(Channel::Displacement, "m"), (Channel::Velocity, "m/s"), (Channel::Force, "N")];
    let of_files = of_channels.into_iter().flat_map(|(channel, si)| {
        let units = Unit::ALL.into_iter().filter(move |unit| unit.dimension() == channel.dimension());
        units.map(move |unit| (unit.name(), si, unit.to_si(1.0)))
    });
    let mut all: Vec<_> = DERIVED.iter().copied().chain(of_files).collect();
    all.sort_by_key(|(symbol, ..)| std::cmp::Reverse(symbol.len()));
    all
});
/// Symbol that is also an English word. It counts as a unit only if it is a value in a sentence.
const WORD: &str = "in";
/// Texts between two numbers of one unit.
const BETWEEN: &[&str] =
    &["–", " – ", " → ", " -> ", " ± ", " to ", " bis ", " à ", " 至 ", " 到 ", " and ", " und ", " et ", " 和 "];
/// Ends of a text between a unit and further numbers of this unit: a tolerance, and a 95 % interval.
const BEHIND: &[&str] = &[" ± ", " (95 %: ", " (95 % : ", "（95 %：", " (95\u{a0}%: "];

/// Formats a sentence in a language and in the selected units. Names in the sentence stay unchanged, even if they look like a quantity.
pub fn restate_sentence(sentence: &Sentence, units: Units, said: &Words) -> String {
    let text = said.say_with_marks(sentence);
    let (mut plain, mut numbers, mut words) = (String::new(), Vec::new(), Vec::new());
    for (k, piece) in text.split(VALUE).enumerate() {
        if k % 2 == 1 {
            // A marked number may contain its unit.
            let figures = figures(piece);
            words.push(plain.len() + piece[figures..].find(|c: char| !c.is_whitespace()).map_or(0, |at| figures + at));
            numbers.extend((figures > 0).then(|| plain.len()..plain.len() + figures));
        }
        plain += piece;
    }
    restate(&plain, &numbers, &words, units, said)
}

/// Restates a text that contains no names of tests in the selected units.
pub fn restate_text(text: &str, units: Units, said: &Words) -> String {
    let (mut numbers, mut at) = (Vec::new(), 0);
    while at < text.len() {
        let length = figures(&text[at..]);
        let is_begin = !text[..at].ends_with(|c: char| c.is_alphanumeric() || ".,_".contains(c));
        if length > 0 && is_begin {
            numbers.push(at..at + length);
        }
        at += length.max(text[at..].chars().next().map_or(1, char::len_utf8));
    }
    restate(text, &numbers, &[], units, said)
}

/// Replaces the unit N in the heading of a column by the selected unit of force. The unit is a separate word of the heading.
pub fn heading(text: &str, units: Units) -> String {
    let symbol = units.force().symbol;
    let words = text.split(' ').map(|word| if word == "N" { symbol.as_str() } else { word });
    words.collect::<Vec<_>>().join(" ")
}

/// Returns the length of the number at the beginning of a text, in bytes; zero without a number.
fn figures(text: &str) -> usize {
    let sign = text.find(|c| !"+-−±".contains(c)).unwrap_or(0);
    let rest = &text[sign..];
    if !rest.starts_with(|c: char| c.is_ascii_digit()) {
        return 0;
    }
    let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').unwrap_or(rest.len());
    sign + rest[..end].trim_end_matches(['.', ',']).len()
}

/// Returns the unit that follows a space at the byte index `at` of a text: SI unit, factor to SI, and range of the symbol. `words` contains
/// the byte indices at which values in words begin.
fn unit_of(text: &str, at: usize, words: &[usize]) -> Option<(&'static str, f64, Range<usize>)> {
    let space = text[at..].chars().next().filter(|c| [' ', '\u{a0}', '\u{202f}'].contains(c))?;
    let begin = at + space.len_utf8();
    let known = KNOWN.iter().find(|(symbol, ..)| {
        let behind = text[begin..].strip_prefix(symbol);
        behind.is_some_and(|behind| !behind.starts_with(|c: char| c.is_ascii_alphanumeric() || "/·²³⁴".contains(c)))
    });
    let (symbol, si, factor) = *known.filter(|known| known.0 != WORD || words.contains(&begin))?;
    Some((si, factor, begin..begin + symbol.len()))
}

/// Converts the numbers in the ranges `numbers` of a text to the selected units. Numbers without a unit, or with another unit, stay
/// unchanged. `words` contains the byte indices at which values in words begin.
fn restate(text: &str, numbers: &[Range<usize>], words: &[usize], units: Units, said: &Words) -> String {
    // Replacements of parts of the text, in the order of the text.
    let mut parts: Vec<(Range<usize>, String)> = Vec::new();
    for (k, number) in numbers.iter().enumerate() {
        let Some((si, factor, symbol)) = unit_of(text, number.end, words) else { continue };
        let shown = shown_of(units, si);
        let factor = factor * shown.factor;
        if text[symbol.clone()] == shown.symbol {
            continue;
        }
        let mut all = vec![k];
        let connects = |a: usize, b: usize| BETWEEN.contains(&&text[numbers[a].end..numbers[b].start]);
        while all[0] > 0 && connects(all[0] - 1, all[0]) {
            all.insert(0, all[0] - 1);
        }
        let is_bare = |k: usize| unit_of(text, numbers[k].end, words).is_none();
        let follows = |next: &usize| {
            let between = &text[symbol.end..numbers[*next].start];
            BEHIND.iter().any(|end| between.strip_suffix(end).is_some_and(|words| !words.contains(['(', ',', ';'])))
        };
        // In a text without marks, the 95 of "(95 %: 2 to 4)" counts as a number too. So the search includes the two numbers after the
        // current one.
        let behind = (k + 1..numbers.len().min(k + 3)).find(follows);
        if let Some(first) = behind.filter(|first| is_bare(*first)) {
            all.push(first);
            all.extend((first + 1 < numbers.len() && connects(first, first + 1)).then_some(first + 1));
        }
        // If one number cannot be read, the text keeps its unit.
        let restated: Option<Vec<_>> = all
            .iter()
            .map(|k| Some((numbers[*k].clone(), restate_number(&text[numbers[*k].clone()], factor, said)?)))
            .collect();
        if let Some(restated) = restated {
            parts.extend(restated);
            parts.push((symbol, shown.symbol));
        }
    }
    parts.sort_by_key(|(range, _)| range.start);
    let (mut out, mut end) = (String::new(), 0);
    for (range, part) in parts {
        if range.start >= end {
            out += &text[end..range.start];
            out += &part;
            end = range.end;
        }
    }
    out + &text[end..]
}

fn shown_of(units: Units, si: &str) -> Shown {
    if si == "J" { units.energy() } else { units.shown(si) }
}

/// Multiplies a number in a text by a factor. The result has as many significant digits as the number.
fn restate_number(number: &str, factor: f64, said: &Words) -> Option<String> {
    let unsigned = number.trim_start_matches(['+', '±']);
    let sign = &number[..number.len() - unsigned.len()];
    let figures: String = unsigned.chars().filter(char::is_ascii_digit).collect();
    let significant = figures.trim_start_matches('0').len().clamp(1, 6) as i32;
    let value = dashpot_report::numbers::digits(factor * read(unsigned)?, significant);
    Some(format!("{sign}{}", said.number(&value)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{Force, Velocity};
    use crate::words::Language;

    const POUNDS: Units = Units { velocity: Velocity::InchesPerSecond, force: Force::Pounds };
    const KILO: Units = Units { velocity: Velocity::MetersPerSecond, force: Force::Kilonewtons };

    #[test]
    fn a_unit_takes_with_it_every_number_of_its_range() {
        for (given, units, wanted) in [
            ("off by 16.3 N (1.5 %)", POUNDS, "off by 3.66 lbf (1.5 %)"),
            ("600–1200 mm/s, 56.0 N", KILO, "0.600–1.200 m/s, 0.0560 kN"),
            ("from 9.26 to 9.62 N rms", POUNDS, "from 2.08 to 2.16 lbf rms"),
            ("−155 N ± 95 as counted", KILO, "−0.155 kN ± 0.095 as counted"),
            ("by 3.0 N a minute (95 %: 2.0 to 4.0)", KILO, "by 0.0030 kN a minute (95 %: 0.0020 to 0.0040)"),
            ("100 → 200 N at 52 mm/s", POUNDS, "22.5 → 45.0 lbf at 2.0 in/s"),
            ("4655 N/mm at 3.5 Hz", POUNDS, "26581 lbf/in at 3.5 Hz"),
            // Lengths stay in mm. A number in another format, such as with a power of ten, keeps its unit.
            ("25.0 mm", KILO, "25.0 mm"),
            ("1.000·10⁻⁶ N", KILO, "1.000·10⁻⁶ N"),
            ("3 Nm, 2 Newton, 5 N-m2", KILO, "3 Nm, 2 Newton, 0.005 kN-m2"),
        ] {
            assert_eq!(restate_text(given, units, Language::English.words()), wanted);
        }
        let german = restate_text("von 9,26 bis 9,62 N", POUNDS, Language::German.words());
        assert_eq!(german, "von 2,08 bis 2,16 lbf");
        let default = "from 9.26 to 9.62 N, 25.0 mm, 100 N/mm";
        assert_eq!(restate_text(default, Units::default(), Language::English.words()), default);
    }
}
