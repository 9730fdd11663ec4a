//! Statements of an Adams dataset (`.adm`) as they lie in the bytes of a file.
//!
//! A statement begins with `NAME/id`; lines that begin with a comma continue it. Comments begin with `!`, on lines of their own
//! or behind a statement. Files may hold any bytes in comments and names.

use anyhow::{Context as _, bail};

/// Stands in [`Statement::text`] where a line ends and its continuation begins.
const JOINT: char = '\n';

/// A statement of a file.
pub struct Statement {
    /// Its text in capitals, without comments and the commas that continue it.
    text: String,
    /// For every character of the text its place in the file.
    places: Vec<usize>,
}

/// A function expression in a statement.
pub struct Function {
    /// Its text in capitals.
    pub text: String,
    /// Range of bytes in the file, from the F of `FUNCTION`, with the backslash that ends it.
    pub begin: usize,
    /// One past the last byte.
    pub end: usize,
    /// Statement text behind it.
    pub after: String,
}

/// Points of a spline: X, and one list of Y for every value of Z.
pub struct Spline {
    /// Abscissae.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<Vec<f64>>,
}

/// Lines of a file, each with its place.
pub fn lines(file: &[u8]) -> Vec<(usize, &[u8])> {
    let mut at = 0;
    file.split_inclusive(|b| *b == b'\n')
        .map(|line| {
            at += line.len();
            (at - line.len(), line)
        })
        .collect()
}

/// What ends a line: "\r\n", "\n" or nothing.
pub fn ending(line: &[u8]) -> &'static str {
    match line {
        [.., b'\r', b'\n'] => "\r\n",
        [.., b'\n'] => "\n",
        _ => "",
    }
}

/// A line without its comment and end.
fn code(line: &[u8]) -> &[u8] {
    line.split(|b| matches!(b, b'!' | b'\r' | b'\n')).next().unwrap_or_default()
}

fn first(line: &[u8]) -> Option<u8> {
    code(line).iter().copied().find(|b| !b.is_ascii_whitespace())
}

/// The name and id of the statement that begins on a line.
pub fn head(line: &[u8]) -> Option<(String, u64)> {
    if !line.first()?.is_ascii_alphabetic() {
        return None;
    }
    let text = String::from_utf8_lossy(code(line)).to_uppercase();
    let (name, rest) = text.split_once('/')?;
    let digits: String = rest.trim_start().chars().take_while(char::is_ascii_digit).collect();
    Some((name.trim().into(), digits.parse().ok()?))
}

/// Whether a line is the END statement.
pub fn is_end(line: &[u8]) -> bool {
    let text = String::from_utf8_lossy(code(line)).trim().to_uppercase();
    text == "END" || text.starts_with("END ") || text.starts_with("END/")
}

/// The name that a comment line gives to the element below it.
pub fn view_name(line: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(line.strip_prefix(b"!")?).trim().to_string();
    let (key, value) = text.split_once('=')?;
    key.trim().eq_ignore_ascii_case("adams_view_name").then(|| value.trim().trim_matches(['\'', '"']).to_string())
}

impl Statement {
    /// The statement that begins on line `begin`.
    pub fn parse(lines: &[(usize, &[u8])], begin: usize) -> Statement {
        let mut statement = Statement { text: String::new(), places: Vec::new() };
        statement.push(lines[begin], 0);
        for &(place, line) in &lines[begin + 1..] {
            match first(line) {
                Some(b',') => {
                    let comma = line.iter().position(|b| *b == b',').unwrap_or_default();
                    statement.text.push(JOINT);
                    statement.places.push(place);
                    statement.push((place, line), comma + 1);
                }
                // Comments and empty lines may lie between; whether they do shows at the next continuation.
                None => {}
                Some(_) => break,
            }
        }
        statement
    }

    /// Its text in capitals.
    pub fn text(&self) -> &str {
        &self.text
    }

    fn push(&mut self, (place, line): (usize, &[u8]), from: usize) {
        for (i, byte) in code(line).iter().enumerate().skip(from) {
            self.text.push(if byte.is_ascii() { byte.to_ascii_uppercase() as char } else { '?' });
            self.places.push(place + i);
        }
    }

    /// Arguments behind `NAME/id` and before the function, if there is one.
    fn arguments(&self) -> impl Iterator<Item = &str> {
        let end = self.function_key().map_or(self.text.len(), |k| k.0);
        self.text[..end].split([',', JOINT]).map(str::trim).filter(|a| !a.is_empty())
    }

    /// Whether a quality without a value is among the arguments, in full or abbreviated as Adams allows.
    pub fn has_quality(&self, word: &str) -> bool {
        let behind = self.function().map(|f| f.after).unwrap_or_default();
        let is = |a: &str| !a.is_empty() && !a.contains('=') && (word.starts_with(a) || a.starts_with(word));
        self.arguments().chain(behind.split([',', JOINT]).map(str::trim)).any(is)
    }

    /// Whether an argument `KEY = ...` stands outside the function, the key in full or abbreviated.
    pub fn has_key(&self, word: &str) -> bool {
        let behind = self.function().map(|f| f.after).unwrap_or_default();
        let is = |a: &str| a.split_once('=').is_some_and(|(k, _)| !k.trim().is_empty() && word.starts_with(k.trim()));
        self.arguments().chain(behind.split([',', JOINT]).map(str::trim)).any(is)
    }

    /// The id that an argument such as `I = 75` names.
    pub fn id_of(&self, key: &str) -> Option<u64> {
        let behind = self.function().map(|f| f.after).unwrap_or_default();
        let mut all =
            self.arguments().map(String::from).chain(behind.split([',', JOINT]).map(|a| a.trim().to_string()));
        all.find_map(|a| a.split_once('=').filter(|(k, _)| k.trim() == key)?.1.trim().parse().ok())
    }

    /// Where `KEY =` begins in the text, and where its value does.
    fn key(&self, key: &str) -> Option<(usize, usize)> {
        self.text.match_indices(key).find_map(|(at, _)| {
            let before = self.text[..at].trim_end_matches([' ', '\t']);
            let after = self.text[at + key.len()..].trim_start_matches([' ', '\t', JOINT]);
            let is_key = before.ends_with([',', JOINT, '\\']) && after.starts_with('=');
            is_key.then(|| (at, self.text.len() - after.len() + 1))
        })
    }

    /// [`Statement::key`] of FUNCTION, in full or abbreviated.
    fn function_key(&self) -> Option<(usize, usize)> {
        const WORD: &str = "FUNCTION";
        (1..=WORD.len()).rev().find_map(|length| self.key(&WORD[..length]))
    }

    /// Its `FUNCTION = ...`.
    pub fn function(&self) -> Option<Function> {
        let (at, value) = self.function_key()?;
        let rest = &self.text[value..];
        let length = rest.find('\\').map_or(rest.trim_end_matches([' ', '\t', JOINT]).len(), |i| i + 1);
        let text: String = rest[..length].trim_end_matches('\\').chars().filter(|c| !c.is_whitespace()).collect();
        Some(Function {
            text,
            begin: self.places[at],
            end: self.places[value + length - 1] + 1,
            after: rest[length..].to_string(),
        })
    }

    /// Its points, where it is a spline.
    ///
    /// # Errors
    /// Where the points are in a file, are no numbers, or X and Y do not match.
    pub fn spline(&self) -> anyhow::Result<Spline> {
        let mut spline = Spline { x: Vec::new(), y: Vec::new() };
        let mut key = String::new();
        // The first piece is NAME/id.
        for piece in self.text.split([',', JOINT]).skip(1).map(str::trim).filter(|p| !p.is_empty()) {
            let number = match piece.split_once('=') {
                Some((k, value)) => {
                    key = k.trim().to_string();
                    if key == "FILE" || key == "BLOCK" {
                        bail!("its points are in a file");
                    }
                    if key == "Y" {
                        spline.y.push(Vec::new());
                    }
                    value.trim()
                }
                None if piece == "LINEAR_EXTRAPOLATE" => continue,
                None => piece,
            };
            if number.is_empty() {
                continue;
            }
            let value: f64 = number.replace('D', "E").parse().with_context(|| format!("\"{piece}\" is no number"))?;
            match key.as_str() {
                "X" => spline.x.push(value),
                "Y" => spline.y.last_mut().context("Y")?.push(value),
                "Z" => {}
                _ => bail!("\"{piece}\" is not understood"),
            }
        }
        let count = spline.x.len();
        // A surface: several lists of Y, each behind its Z.
        if spline.y.len() > 1 && spline.y.iter().all(|y| y.len() == count + 1) {
            spline.y.iter_mut().for_each(|y| *y = y.split_off(1));
        }
        if count < 2 || spline.y.is_empty() || spline.y.iter().any(|y| y.len() != count) {
            let counts: Vec<String> = spline.y.iter().map(|y| y.len().to_string()).collect();
            bail!("it has {count} X and {} Y values", counts.join(" + "));
        }
        if spline.x.windows(2).any(|w| w[0] >= w[1]) {
            bail!("its X values do not increase");
        }
        Ok(spline)
    }
}

impl Spline {
    /// The value of list `list` at `x`, straight between the points.
    pub fn value(&self, list: usize, x: f64) -> f64 {
        let i = self.x.partition_point(|p| *p <= x).min(self.x.len() - 1).max(1);
        let (a, b, y) = (self.x[i - 1], self.x[i], &self.y[list]);
        let share = ((x - a) / (b - a)).clamp(0.0, 1.0);
        y[i - 1] + (y[i] - y[i - 1]) * share
    }
}
