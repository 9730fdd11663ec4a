//! Statements of an Adams dataset (`.adm`) with their positions in the bytes of a file.
//!
//! A statement begins with `NAME/id`. Lines that begin with a comma continue it. A comment begins with `!`, on a separate line or after a
//! statement. Comments and names may contain any bytes.

use anyhow::{Context as _, bail};

/// Character in [`Statement::text`] between a line and its continuation line.
const JOINT: char = '\n';

/// A statement of an Adams dataset.
pub struct Statement {
    /// Text in capitals, without comments and continuation commas.
    text: String,
    /// Byte position in the file of each character of `text`.
    places: Vec<usize>,
}

/// A function expression in a statement.
pub struct Function {
    /// Text of the expression in capitals.
    pub text: String,
    /// Position in the file of the first byte of the argument, the F of `FUNCTION`.
    pub begin: usize,
    /// Position in the file after the last byte of the expression. A final backslash belongs to the expression.
    pub end: usize,
    /// Text of the statement after the expression, in capitals.
    pub after: String,
}

/// Points of a SPLINE statement: X, and one list of Y for each value of Z.
pub struct Spline {
    /// X values, increasing.
    pub x: Vec<f64>,
    /// Lists of Y values, each as long as `x`.
    pub y: Vec<Vec<f64>>,
}

/// Returns the lines of a file, each with its byte position in the file.
pub fn lines(file: &[u8]) -> Vec<(usize, &[u8])> {
    let mut at = 0;
    file.split_inclusive(|b| *b == b'\n')
        .map(|line| {
            at += line.len();
            (at - line.len(), line)
        })
        .collect()
}

/// Returns the line ending of a line: "\r\n", "\n" or nothing.
pub fn ending(line: &[u8]) -> &'static str {
    match line {
        [.., b'\r', b'\n'] => "\r\n",
        [.., b'\n'] => "\n",
        _ => "",
    }
}

/// Returns a line without its comment and line ending.
fn code(line: &[u8]) -> &[u8] {
    line.split(|b| matches!(b, b'!' | b'\r' | b'\n')).next().unwrap_or_default()
}

fn first(line: &[u8]) -> Option<u8> {
    code(line).iter().copied().find(|b| !b.is_ascii_whitespace())
}

/// Returns the name and id of the statement that begins on a line, or `None` if none begins there.
pub fn head(line: &[u8]) -> Option<(String, u64)> {
    if !line.first()?.is_ascii_alphabetic() {
        return None;
    }
    let text = String::from_utf8_lossy(code(line)).to_uppercase();
    let (name, rest) = text.split_once('/')?;
    let digits: String = rest.trim_start().chars().take_while(char::is_ascii_digit).collect();
    Some((name.trim().into(), digits.parse().ok()?))
}

/// Returns whether a line is the END statement.
pub fn is_end(line: &[u8]) -> bool {
    let text = String::from_utf8_lossy(code(line)).trim().to_uppercase();
    text == "END" || text.starts_with("END ") || text.starts_with("END/")
}

/// Returns the name that a comment line `! adams_view_name='...'` gives to the following element.
pub fn view_name(line: &[u8]) -> Option<String> {
    let text = String::from_utf8_lossy(line.strip_prefix(b"!")?).trim().to_string();
    let (key, value) = text.split_once('=')?;
    key.trim().eq_ignore_ascii_case("adams_view_name").then(|| value.trim().trim_matches(['\'', '"']).to_string())
}

impl Statement {
    /// Parses the statement that begins on line `begin`.
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
                // A comment or an empty line belongs to the statement if a continuation line follows.
                None => {}
                Some(_) => break,
            }
        }
        statement
    }

    /// Returns the text of the statement in capitals.
    pub fn text(&self) -> &str {
        &self.text
    }

    fn push(&mut self, (place, line): (usize, &[u8]), from: usize) {
        for (i, byte) in code(line).iter().enumerate().skip(from) {
            self.text.push(if byte.is_ascii() { byte.to_ascii_uppercase() as char } else { '?' });
            self.places.push(place + i);
        }
    }

    /// Returns the arguments after `NAME/id`, up to the function if there is one.
    fn arguments(&self) -> impl Iterator<Item = &str> {
        let end = self.function_key().map_or(self.text.len(), |k| k.0);
        self.text[..end].split([',', JOINT]).map(str::trim).filter(|a| !a.is_empty())
    }

    /// Returns whether the arguments include the keyword `word` without a value, such as TRANSLATIONAL, in full or abbreviated.
    pub fn has_quality(&self, word: &str) -> bool {
        let behind = self.function().map(|f| f.after).unwrap_or_default();
        let is = |a: &str| !a.is_empty() && !a.contains('=') && (word.starts_with(a) || a.starts_with(word));
        self.arguments().chain(behind.split([',', JOINT]).map(str::trim)).any(is)
    }

    /// Returns whether an argument `KEY = ...` exists outside the function, where KEY is `word` in full or abbreviated.
    pub fn has_key(&self, word: &str) -> bool {
        let behind = self.function().map(|f| f.after).unwrap_or_default();
        let is = |a: &str| a.split_once('=').is_some_and(|(k, _)| !k.trim().is_empty() && word.starts_with(k.trim()));
        self.arguments().chain(behind.split([',', JOINT]).map(str::trim)).any(is)
    }

    /// Returns the id that the argument `key` states, such as 75 in `I = 75`. The function expression is not searched.
    pub fn id_of(&self, key: &str) -> Option<u64> {
        let behind = self.function().map(|f| f.after).unwrap_or_default();
        let mut all =
            self.arguments().map(String::from).chain(behind.split([',', JOINT]).map(|a| a.trim().to_string()));
        all.find_map(|a| a.split_once('=').filter(|(k, _)| k.trim() == key)?.1.trim().parse().ok())
    }

    /// Returns the positions of `KEY =` and of its value in the text.
    fn key(&self, key: &str) -> Option<(usize, usize)> {
        self.text.match_indices(key).find_map(|(at, _)| {
            let before = self.text[..at].trim_end_matches([' ', '\t']);
            let after = self.text[at + key.len()..].trim_start_matches([' ', '\t', JOINT]);
            let is_key = before.ends_with([',', JOINT, '\\']) && after.starts_with('=');
            is_key.then(|| (at, self.text.len() - after.len() + 1))
        })
    }

    /// Returns the positions of the key FUNCTION, in full or abbreviated, and of its value in the text.
    fn function_key(&self) -> Option<(usize, usize)> {
        const WORD: &str = "FUNCTION";
        (1..=WORD.len()).rev().find_map(|length| self.key(&WORD[..length]))
    }

    /// Returns the function expression of the argument `FUNCTION = ...`.
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

    /// Returns the points of a spline.
    ///
    /// # Errors
    /// Points are in a separate file, points are not numbers, the numbers of X and Y differ, or X does not increase.
    pub fn spline(&self) -> anyhow::Result<Spline> {
        let mut spline = Spline { x: Vec::new(), y: Vec::new() };
        let mut key = String::new();
        // The first part, NAME/id, is skipped.
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
        // In a spline with several lists of Y, which is a surface, a value of Z precedes each list. This value is removed.
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
    /// Returns the value of the Y list with index `list` at `x`, by linear interpolation. Outside the points, the value is constant.
    pub fn value(&self, list: usize, x: f64) -> f64 {
        let i = self.x.partition_point(|p| *p <= x).min(self.x.len() - 1).max(1);
        let (a, b, y) = (self.x[i - 1], self.x[i], &self.y[list]);
        let share = ((x - a) / (b - a)).clamp(0.0, 1.0);
        y[i - 1] + (y[i] - y[i - 1]) * share
    }
}
