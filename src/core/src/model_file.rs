//! The model file: flat `name = value` lines. Hosts without a TOML library can also read this subset of TOML.
//!
//! ```toml
//! format = 1
//! elements = ["series_compliance", "fv_curve"]
//! series_stiffness = 3.0e6   # N/m
//! fv_velocity = [-1.0, 0.0, 1.0]
//! fv_force = [-1500.0, 0.0, 2500.0]
//! fv_interpolation = "monotone_cubic"
//! ```
//!
//! The file of a damper that depends on a setting, such as a current, names the grid of settings. A parameter may then
//! have one value for each setting of the grid, and so may the forces of the FV table ([`crate::family`]):
//!
//! ```toml
//! setting = [0.0, 0.8, 1.6]
//! setting_name = "current"
//! setting_unit = "A"
//! gas_force = [80.0, 82.0, 85.0]
//! fv_force = [[-900.0, 0.0, 1200.0], [-1500.0, 0.0, 2500.0], [-1900.0, 0.0, 3300.0]]
//! ```
//!
//! A value is a number, a word in quotes, or a list, which may extend over several lines. Parameters that the file does
//! not name keep their defaults. Reading ends at the first `[table]`: all further text is for people and tools, not for
//! the damper. A table with the name of an element is an error, because its author probably meant parameters of the
//! damper.
//!
//! All files that dashpot writes announce the first table in a comment (`# The lines up to [end] are the damper`). If
//! such a file ends before the table, it is truncated. A truncated file is an error, because missing parameters would
//! silently have their defaults.

use crate::family::Axis;
use crate::family::axis::{ENTRIES, can_vary, check_entry, check_grid, check_text, check_values, index_of};
use crate::family::interpolation::MAX_GRID;
use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::number;
use crate::parameter::values::check;
use crate::parameter::{COUNT, Element, GROUPS, List, Number, Params, Row, Shape, table};

/// Required value of the key `format`.
pub const FORMAT: f64 = 1.0;

/// Error of reading a model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReadError {
    /// Number of the line, from 1.
    pub line: u32,
    /// Index in the parameter table of the parameter that the line names, or [`NO_PARAMETER`].
    pub parameter: u16,
    /// Error in that line.
    pub problem: LineProblem,
}

/// Kind of error in a model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineProblem {
    /// The line is not `name = value`.
    Syntax,
    /// A value is invalid: it must be a number, a word in quotes, or a list of numbers or words.
    Value,
    /// A key, or an element in `elements`, appears twice.
    Repeated,
    /// `format` is missing or has a number that this library cannot read.
    Format,
    /// `elements` is missing.
    NoElements,
    /// `elements` contains an unknown name.
    UnknownElement,
    /// A list has more numbers than any parameter allows.
    TooLong,
    /// The file ends before the table that its comment announces.
    CutOff,
    /// A table has the name of an element, or of the integration's settings.
    ElementTable,
    /// The name is unknown, or the parameter table rejects the value.
    Parameter(Fault),
    /// An entry of the setting is invalid: its grid, a number, its name or its unit.
    Setting(Reason),
    /// The damper depends on a setting, but the caller needs an ordinary damper.
    Family,
}

impl LineProblem {
    /// Returns the message for the user.
    pub const fn text(self) -> &'static str {
        match self {
            LineProblem::Syntax => "the line is not of the form name = value",
            LineProblem::Value => "the value is not a number, a word in double quotes, or a list of them",
            LineProblem::Repeated => "the name appears a second time",
            LineProblem::Format => "the file must say format = 1; it was written for another version of dashpot",
            LineProblem::NoElements => "the file must name its elements, such as elements = [\"fv_curve\"]",
            LineProblem::UnknownElement => "elements names something that is no element of this version of dashpot",
            LineProblem::TooLong => "the list has more than 64 numbers, which is more than any parameter takes",
            LineProblem::CutOff => {
                "the file was cut off: it ends before the [...] that its first comment announces; copy it again, or delete that comment"
            }
            LineProblem::ElementTable => {
                "parameters stand above the first [table], in no table of their own; write them there and delete this heading"
            }
            LineProblem::Parameter(fault) => fault.reason.text(),
            LineProblem::Setting(Reason::OutOfBounds) => {
                "is out of its bounds: times, rates and hysteresis are not negative, a time is at most 100 s, a dead time 10 s, and the place in the hysteresis lies from -1 to 1"
            }
            LineProblem::Setting(Reason::PointCount) => "is too long; at most 31 bytes",
            LineProblem::Setting(reason) => reason.text(),
            LineProblem::Family => {
                "the damper depends on this setting, and what was asked takes a damper at one setting; write that with dashpot setting FAMILY VALUE -o one.toml"
            }
        }
    }
}

/// Error for a name that is not in the parameter table.
const UNKNOWN: LineProblem = LineProblem::Parameter(Fault { parameter: NO_PARAMETER, reason: Reason::UnknownName });

/// Beginning of the comment that announces the table after the lines of the damper.
pub const ANNOUNCES: &str = "# The lines up to [";

/// Largest number of values in one list. The text of [`LineProblem::TooLong`] also contains this number.
const LONGEST: usize = 64;

/// Reads a model file into `params`; parameters that the file does not name have their defaults. Rejects a damper that
/// depends on a setting: see [`read_family`].
///
/// # Errors
/// Returns the first error with its line; `params` then stays unchanged.
pub fn read(text: &[u8], params: &mut Params) -> Result<(), ReadError> {
    if let (_, _, Some(line)) = grid_of(text)? {
        return Err(ReadError { line, parameter: NO_PARAMETER, problem: LineProblem::Family });
    }
    let mut scratch = Params::BLANK;
    read_into(text, &mut scratch, None)?;
    *params = scratch;
    Ok(())
}

/// Checks whether [`read_family`] can read a text.
///
/// # Errors
/// Returns the first error with its line.
pub fn check_family(text: &[u8]) -> Result<(), ReadError> {
    read_into(text, &mut Params::BLANK.clone(), None)
}

/// Reads a model file of an ordinary or an adjustable damper. `params` are the parameters at the start setting. For an
/// ordinary damper, `axis` has no grid.
///
/// # Errors
/// Returns the first error with its line; `params` and `axis` then stay unchanged.
pub fn read_family(text: &[u8], params: &mut Params, axis: &mut Axis) -> Result<(), ReadError> {
    // Check first in separate memory, so that an error leaves the caller's data unchanged.
    check_family(text)?;
    read_checked(text, params, axis)
}

/// Reads a text that passed [`check_family`], directly into the caller's memory.
///
/// # Errors
/// Returns the errors of [`read_family`]; the caller's data may then be incomplete.
pub fn read_checked(text: &[u8], params: &mut Params, axis: &mut Axis) -> Result<(), ReadError> {
    axis.clear();
    let (grid, count, line) = grid_of(text)?;
    let Some(line) = line else { return read_into(text, params, None) };
    let wrong = |_| ReadError { line, parameter: NO_PARAMETER, problem: LineProblem::Setting(Reason::SettingGrid) };
    axis.set_grid(grid.get(..count).unwrap_or(&[])).map_err(wrong)?;
    read_into(text, params, Some(axis))?;
    axis.put(params, axis.start());
    Ok(())
}

/// Finds the grid of the setting in a text. Returns its values, their number, and its line. The line is `None` if the
/// text names no setting, or if another line before it is not `name = value`.
fn grid_of(text: &[u8]) -> Result<([f64; MAX_GRID], usize, Option<u32>), ReadError> {
    let mut reader = Reader::new(text);
    let mut grid = [0.0; MAX_GRID];
    loop {
        reader.blank(true);
        let line = reader.line;
        // The full reading of the text reports a line with a syntax error.
        let Some(name) = reader.name() else { return Ok((grid, 0, None)) };
        reader.blank(false);
        if !reader.take(b'=') {
            return Ok((grid, 0, None));
        }
        reader.blank(false);
        if name != b"setting" {
            reader.skip_value();
            continue;
        }
        let wrong =
            |line| ReadError { line, parameter: NO_PARAMETER, problem: LineProblem::Setting(Reason::SettingGrid) };
        let mut count = 0;
        reader.list(|value, line| {
            let (Value::Number(number), Some(slot)) = (value, grid.get_mut(count)) else { return Err(wrong(line)) };
            *slot = number;
            count += 1;
            Ok(())
        })?;
        check_grid(grid.get(..count).unwrap_or(&[])).map_err(|_| wrong(line))?;
        return Ok((grid, count, Some(line)));
    }
}

/// Reads the text into `read`. After an error, `read` may be partly changed.
///
/// Values that depend on a setting are written to the `axis`, or only checked if there is no axis.
#[inline(never)]
fn read_into(text: &[u8], read: &mut Params, mut axis: Option<&mut Axis>) -> Result<(), ReadError> {
    let (_, settings, _) = grid_of(text)?;
    read.set_defaults();
    read.disable_all();
    let mut seen = [false; COUNT];
    let mut seen_of_setting = [false; ENTRIES.len() + 3];
    let (mut has_format, mut has_elements) = (false, false);
    let mut varying = 0;
    let mut reader = Reader::new(text);
    loop {
        reader.blank(true);
        let line = reader.line;
        let at = |problem| ReadError { line, parameter: NO_PARAMETER, problem };
        match reader.peek() {
            None if reader.announced => return Err(at(LineProblem::CutOff)),
            None | Some(b'[') => break,
            Some(_) => {}
        }
        let name = reader.name().ok_or(at(LineProblem::Syntax))?;
        reader.blank(false);
        if !reader.take(b'=') {
            return Err(at(LineProblem::Syntax));
        }
        reader.blank(false);
        match name {
            b"format" => {
                reader.format().map_err(at)?;
                if has_format {
                    return Err(at(LineProblem::Repeated));
                }
                has_format = true;
            }
            b"elements" => {
                if has_elements {
                    return Err(at(LineProblem::Repeated));
                }
                has_elements = true;
                reader.elements(read)?;
            }
            _ if name == b"setting" || name.starts_with(b"setting_") => {
                let index = match name {
                    b"setting" => ENTRIES.len(),
                    b"setting_name" => ENTRIES.len() + 1,
                    b"setting_unit" => ENTRIES.len() + 2,
                    _ => index_of(name).ok_or(at(UNKNOWN))?,
                };
                match seen_of_setting.get_mut(index) {
                    Some(seen) if !*seen => *seen = true,
                    _ => return Err(at(LineProblem::Repeated)),
                }
                if settings == 0 {
                    return Err(at(LineProblem::Setting(Reason::SettingGrid)));
                }
                reader.setting(index, axis.as_deref_mut())?;
            }
            _ => {
                let row = table().find(|row| row.parameter.name.as_bytes() == name).ok_or(at(UNKNOWN))?;
                let of_row = |error| ReadError { parameter: row.index as u16, ..error };
                if seen.get(row.index) == Some(&true) {
                    return Err(of_row(at(LineProblem::Repeated)));
                }
                if let Some(seen) = seen.get_mut(row.index) {
                    *seen = true;
                }
                if settings > 0 && reader.is_over_setting(row) {
                    varying += usize::from(!can_vary_list(row));
                    reader.over_setting(row, settings, varying, axis.as_deref_mut(), read).map_err(of_row)?;
                } else {
                    reader.parameter(row, read).map_err(of_row)?;
                }
            }
        }
        reader.blank(false);
        if !matches!(reader.peek(), None | Some(b'\n')) {
            return Err(at(LineProblem::Syntax));
        }
    }
    reader.refuse_element_tables()?;
    if !has_format {
        return Err(ReadError { line: 1, parameter: NO_PARAMETER, problem: LineProblem::Format });
    }
    if !has_elements {
        return Err(ReadError { line: 1, parameter: NO_PARAMETER, problem: LineProblem::NoElements });
    }
    Ok(())
}

/// Returns the name at fault in the text of a file, or `None` if the error is not about a name.
///
/// The result is the name of an unknown parameter or element, of an element that is listed twice, or of an entry of the
/// setting.
///
/// The search uses bytes, because the text searches of the standard library can panic.
pub fn name_at<'a>(text: &'a [u8], error: &ReadError) -> Option<&'a [u8]> {
    let (from, to) = line_at(text, error.line)?;
    let line = text.get(from..to)?;
    let found = match error.problem {
        LineProblem::UnknownElement => {
            find_word(line, |word| Element::all().all(|element| element.name().as_bytes() != word))?
        }
        LineProblem::Parameter(Fault { reason: Reason::UnknownName, .. })
        | LineProblem::Setting(_)
        | LineProblem::Family => {
            let end = line.iter().position(|b| *b == b'=').unwrap_or(line.len());
            line.get(..end)?.trim_ascii()
        }
        LineProblem::Repeated if error.parameter == NO_PARAMETER => {
            let up_to = text.get(..to)?;
            find_word(line, |word| count_words(up_to, word) > 1)?
        }
        _ => return None,
    };
    Some(found.strip_prefix(b"\xef\xbb\xbf").unwrap_or(found))
}

/// Returns the byte indices of start and end of a line, whose number counts from 1.
fn line_at(text: &[u8], line: u32) -> Option<(usize, usize)> {
    let mut number = 1;
    let mut from = 0;
    for (at, byte) in text.iter().enumerate() {
        if *byte == b'\n' {
            if number == line {
                return Some((from, at));
            }
            (number, from) = (number + 1, at + 1);
        }
    }
    (number == line).then_some((from, text.len()))
}

/// Calls `visit` with the words in quotes, except in comments, until `visit` returns true; returns that word, or
/// `None`.
fn find_word<'a>(text: &'a [u8], mut visit: impl FnMut(&'a [u8]) -> bool) -> Option<&'a [u8]> {
    let (mut begins, mut is_remark) = (None, false);
    for (at, byte) in text.iter().enumerate() {
        match (*byte, begins) {
            (b'\n', _) => (begins, is_remark) = (None, false),
            (b'#', None) => is_remark = true,
            (b'"', None) if !is_remark => begins = Some(at + 1),
            (b'"', Some(from)) => {
                if let Some(word) = text.get(from..at)
                    && visit(word)
                {
                    return Some(word);
                }
                begins = None;
            }
            _ => {}
        }
    }
    None
}

/// Counts how often the word `wanted` appears in quotes, outside comments.
fn count_words(text: &[u8], wanted: &[u8]) -> usize {
    let mut count = 0;
    let _ = find_word(text, |word| {
        count += usize::from(word == wanted);
        false
    });
    count
}

enum Value<'a> {
    Number(f64),
    Word(&'a [u8]),
}

struct Reader<'a> {
    rest: &'a [u8],
    line: u32,
    /// Whether a comment announced a table.
    announced: bool,
}

/// Returns whether a row is the one list that may depend on a setting: the forces of the FV table.
fn can_vary_list(row: Row) -> bool {
    List::try_from(row).is_ok_and(can_vary)
}

impl<'a> Reader<'a> {
    /// Begins to read a text. Some editors begin a file with a byte-order mark, which is skipped.
    fn new(text: &'a [u8]) -> Reader<'a> {
        let rest = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
        Reader { rest, line: 1, announced: false }
    }

    /// Reads the format and checks it.
    fn format(&mut self) -> Result<(), LineProblem> {
        match self.value() {
            Some(Value::Number(number)) if number == FORMAT => Ok(()),
            _ => Err(LineProblem::Format),
        }
    }

    /// Reads the list of elements and switches them on.
    fn elements(&mut self, read: &mut Params) -> Result<(), ReadError> {
        self.list(|value, line| {
            let at = |problem| ReadError { line, parameter: NO_PARAMETER, problem };
            let Value::Word(word) = value else { return Err(at(LineProblem::Value)) };
            let named = Element::all().find(|element| element.name().as_bytes() == word);
            let element = named.ok_or(at(LineProblem::UnknownElement))?;
            if read.is_on(element) {
                return Err(at(LineProblem::Repeated));
            }
            read.enable(element, true);
            Ok(())
        })
    }

    /// Returns whether the next value has one entry for each setting of the grid. For a number or a choice, such a
    /// value is a list; for a list, it is a list of lists. The number of entries is not checked.
    fn is_over_setting(&self, row: Row) -> bool {
        let mut ahead = Reader { ..*self };
        if !ahead.take(b'[') {
            return false;
        }
        ahead.blank(true);
        match row.parameter.shape {
            Shape::List(_) => ahead.peek() == Some(b'['),
            Shape::Scalar | Shape::Choice(_) => true,
        }
    }

    /// Reads the value of one entry of the setting: a number, the name or the unit. `index` counts the [`ENTRIES`],
    /// then the grid, the name and the unit.
    fn setting(&mut self, index: usize, axis: Option<&mut Axis>) -> Result<(), ReadError> {
        let line = self.line;
        let at = |problem| ReadError { line, parameter: NO_PARAMETER, problem };
        let wrong = |fault: Fault| at(LineProblem::Setting(fault.reason));
        if index == ENTRIES.len() {
            // The grid was already read and checked before all other entries.
            self.skip_value();
            return Ok(());
        }
        match self.value().ok_or(at(LineProblem::Value))? {
            Value::Number(number) if index < ENTRIES.len() => {
                check_entry(index, number).map_err(wrong)?;
                axis.map_or(Ok(()), |axis| axis.set_number(index, number)).map_err(wrong)
            }
            Value::Word(word) if index > ENTRIES.len() => {
                check_text(word).map_err(wrong)?;
                axis.map_or(Ok(()), |axis| {
                    if index == ENTRIES.len() + 1 { axis.set_name_bytes(word) } else { axis.set_unit_bytes(word) }
                })
                .map_err(wrong)
            }
            _ => Err(at(LineProblem::Value)),
        }
    }

    /// Reads the values of a parameter for each setting. `varying` is the number of parameters that depend on the
    /// setting so far, including this one but not the forces of the FV table.
    fn over_setting(
        &mut self,
        row: Row,
        settings: usize,
        varying: usize,
        mut axis: Option<&mut Axis>,
        read: &mut Params,
    ) -> Result<(), ReadError> {
        let line = self.line;
        let at = |problem| ReadError { line, parameter: row.index as u16, problem };
        let fault = |reason| at(LineProblem::Parameter(Fault { parameter: row.index as u16, reason }));
        let of_table = |found: Fault| fault(found.reason);
        if let Ok(number) = Number::try_from(row) {
            if !matches!(row.parameter.shape, Shape::Scalar) {
                return Err(fault(Reason::SettingFixed));
            }
            let (mut values, mut count) = ([0.0; MAX_GRID], 0);
            self.list(|value, line| {
                let Value::Number(value) = value else { return Err(ReadError { line, ..at(LineProblem::Value) }) };
                *values.get_mut(count).ok_or(fault(Reason::SettingCount))? = value;
                count += 1;
                Ok(())
            })?;
            let values = values.get(..count).unwrap_or(&[]);
            check_values(number, values, settings).map_err(of_table)?;
            if varying > crate::family::axis::MAX_NUMBERS {
                return Err(fault(Reason::SettingTooMany));
            }
            return axis.map_or(Ok(()), |axis| axis.set_values(number, values)).map_err(of_table);
        }
        let list = List::try_from(row).map_err(of_table)?;
        if !can_vary(list) {
            return Err(fault(Reason::SettingFixed));
        }
        self.take(b'[');
        let (mut index, mut points) = (0, 0);
        loop {
            self.blank(true);
            if self.take(b']') {
                break;
            }
            let line = self.line;
            let (mut forces, mut count) = ([0.0; LONGEST], 0);
            self.list(|value, line| {
                let Value::Number(value) = value else { return Err(ReadError { line, ..at(LineProblem::Value) }) };
                *forces.get_mut(count).ok_or(ReadError { line, ..at(LineProblem::TooLong) })? = value;
                count += 1;
                Ok(())
            })?;
            let of_line = |error: ReadError| ReadError { line, ..error };
            let forces = forces.get(..count).unwrap_or(&[]);
            check(&row, forces).map_err(of_table).map_err(of_line)?;
            if index > 0 && count != points {
                return Err(of_line(fault(Reason::CurveLengths)));
            }
            if forces.is_empty() {
                return Err(of_line(fault(Reason::PointCount)));
            }
            points = count;
            if index == 0 {
                // The forces at the first setting are those of the parameter set until the axis has the forces at all
                // settings.
                read.set_list(list, forces).map_err(of_table).map_err(of_line)?;
            }
            if let Some(axis) = axis.as_deref_mut() {
                axis.set_forces(index, forces).map_err(of_table).map_err(of_line)?;
            }
            index += 1;
            self.blank(true);
            if !self.take(b',') && self.peek() != Some(b']') {
                return Err(at(LineProblem::Value));
            }
        }
        if index == settings { Ok(()) } else { Err(fault(Reason::SettingCount)) }
    }

    /// Skips a list, or the rest of the line if the value is not a list.
    fn skip_value(&mut self) {
        let mut depth = 0i32;
        while let Some(c) = self.peek() {
            match c {
                b'"' => {
                    self.advance();
                    while self.peek().is_some_and(|c| c != b'"' && c != b'\n') {
                        self.advance();
                    }
                    self.take(b'"');
                    continue;
                }
                b'#' => {
                    self.blank(false);
                    continue;
                }
                b'[' => depth += 1,
                b']' => depth -= 1,
                b'\n' if depth <= 0 => return,
                _ => {}
            }
            self.advance();
            if depth == 0 && c == b']' {
                return;
            }
        }
    }

    /// Reads the value of a row of the parameter table.
    fn parameter(&mut self, row: Row, read: &mut Params) -> Result<(), ReadError> {
        let line = self.line;
        let at = |problem| ReadError { line, parameter: row.index as u16, problem };
        let fault = |reason| at(LineProblem::Parameter(Fault { parameter: row.index as u16, reason }));
        let set = match row.parameter.shape {
            Shape::List(_) => {
                let mut numbers = [0.0; LONGEST];
                let mut count = 0;
                if self.peek() != Some(b'[') {
                    return Err(fault(Reason::WrongShape));
                }
                self.list(|value, line| {
                    let Value::Number(number) = value else {
                        return Err(ReadError { line, ..at(LineProblem::Value) });
                    };
                    let slot = numbers.get_mut(count).ok_or(ReadError { line, ..at(LineProblem::TooLong) })?;
                    *slot = number;
                    count += 1;
                    Ok(())
                })?;
                List::try_from(row).and_then(|list| read.set_list(list, numbers.get(..count).unwrap_or(&[])))
            }
            Shape::Choice(words) => {
                let Some(Value::Word(word)) = self.value() else { return Err(at(LineProblem::Value)) };
                let place = words.iter().position(|w| w.as_bytes() == word).ok_or(fault(Reason::NotAChoice))?;
                Number::try_from(row).and_then(|choice| read.set(choice, place as f64))
            }
            Shape::Scalar => {
                if self.peek() == Some(b'[') {
                    return Err(fault(Reason::WrongShape));
                }
                let Some(Value::Number(number)) = self.value() else { return Err(at(LineProblem::Value)) };
                Number::try_from(row).and_then(|of| read.set(of, number))
            }
        };
        set.map_err(|f| fault(f.reason))
    }

    fn peek(&self) -> Option<u8> {
        self.rest.first().copied()
    }

    fn advance(&mut self) {
        if let Some((c, tail)) = self.rest.split_first() {
            self.line = self.line.wrapping_add(u32::from(*c == b'\n'));
            self.rest = tail;
        }
    }

    fn take(&mut self, wanted: u8) -> bool {
        let found = self.peek() == Some(wanted);
        if found {
            self.advance();
        }
        found
    }

    /// Skips blanks and comments; also skips line ends if `lines` is true.
    fn blank(&mut self, lines: bool) {
        while let Some(c) = self.peek() {
            match c {
                b' ' | b'\t' | b'\r' => self.advance(),
                b'\n' if lines => self.advance(),
                b'#' => {
                    self.announced |= self.rest.starts_with(ANNOUNCES.as_bytes());
                    while self.peek().is_some_and(|c| c != b'\n') {
                        self.advance();
                    }
                }
                _ => return,
            }
        }
    }

    /// Reads the longest run of bytes that `belongs` accepts.
    fn run(&mut self, belongs: impl Fn(u8) -> bool) -> &'a [u8] {
        let start = self.rest;
        let length = start.iter().position(|c| !belongs(*c)).unwrap_or(start.len());
        let (run, tail) = start.split_at_checked(length).unwrap_or((start, &[]));
        self.rest = tail;
        run
    }

    /// Reads to the end of the text and rejects tables with the name of a group of parameters. Without this check, the
    /// parameters of such a table would silently keep their defaults.
    fn refuse_element_tables(&mut self) -> Result<(), ReadError> {
        loop {
            self.blank(true);
            let line = self.line;
            let is_heading = self.take(b'[');
            // The heading of an array of tables in TOML has two brackets.
            self.take(b'[');
            self.blank(false);
            if is_heading
                && let Some(name) = self.name()
                && GROUPS.iter().any(|group| group.name.as_bytes() == name)
            {
                return Err(ReadError { line, parameter: NO_PARAMETER, problem: LineProblem::ElementTable });
            }
            while self.peek().is_some_and(|c| c != b'\n') {
                self.advance();
            }
            if self.peek().is_none() {
                return Ok(());
            }
        }
    }

    fn name(&mut self) -> Option<&'a [u8]> {
        let run = self.run(|c| c.is_ascii_alphanumeric() || c == b'_');
        if run.is_empty() { None } else { Some(run) }
    }

    fn value(&mut self) -> Option<Value<'a>> {
        if self.take(b'"') {
            let word = self.run(|c| c != b'"' && c != b'\n');
            return self.take(b'"').then_some(Value::Word(word));
        }
        let run = self.run(|c| c.is_ascii_alphanumeric() || matches!(c, b'+' | b'-' | b'.' | b'_'));
        number::parse(run).map(Value::Number)
    }

    fn list(&mut self, mut each: impl FnMut(Value<'a>, u32) -> Result<(), ReadError>) -> Result<(), ReadError> {
        let wrong = |line| ReadError { line, parameter: NO_PARAMETER, problem: LineProblem::Value };
        if !self.take(b'[') {
            return Err(wrong(self.line));
        }
        loop {
            self.blank(true);
            if self.take(b']') {
                return Ok(());
            }
            let line = self.line;
            let value = self.value().ok_or(wrong(line))?;
            each(value, line)?;
            self.blank(true);
            if !self.take(b',') && self.peek() != Some(b']') {
                return Err(wrong(self.line));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{element, list};
    use std::format;

    const SMALL: &str = "\u{feff}# a damper\r\nformat = 1\nelements = [\"fv_curve\", # why\n \"gas_preload\",]\n\
        gas_force = 12.5 # N\nfv_interpolation = \"linear\"\nfv_velocity = [-1, 0,\n 1.0]\nfv_force=[-1e3,0.0,2_000]\n\
        [intervals]\ngas_force = [1, 2]\n";

    #[test]
    fn reads_every_kind_of_value() {
        let mut params = Params::new();
        read(SMALL.as_bytes(), &mut params).unwrap();
        assert!(
            params.is_on(element!("fv_curve"))
                && params.is_on(element!("gas_preload"))
                && !params.is_on(element!("series_compliance"))
        );
        assert_eq!(params.number(number!("gas_force")), 12.5);
        assert_eq!(params.number(number!("fv_interpolation")), 1.0);
        assert_eq!(params.list(list!("fv_velocity")), [-1.0, 0.0, 1.0]);
        assert_eq!(params.list(list!("fv_force")), [-1000.0, 0.0, 2000.0]);
        assert_eq!(params.number(number!("series_stiffness")), Params::new().number(number!("series_stiffness")));
    }

    const OVER_CURRENT: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\n\
        gas_force = [80, 82.5,\n 85] # N\nfv_velocity = [-1, 0, 1.0]\n\
        fv_force = [[-900, 0, 1200], # soft\n [-1500, 0, 2500],\n [-1900, 0, 3300],]\n\
        setting = [0.0, 0.8, 1.6]\nsetting_name = \"current\"\nsetting_unit = \"A\"\nsetting_start = 0.8\n\
        setting_time_up = 0.008\nsetting_hysteresis = 0.05\n[notes]\nsetting = [3]\n";

    #[test]
    fn a_damper_over_a_setting_is_read_in_any_order_of_its_lines() {
        let (mut params, mut axis) = (Params::new(), Axis::NONE);
        read_family(OVER_CURRENT.as_bytes(), &mut params, &mut axis).unwrap();
        assert_eq!((axis.grid(), axis.name(), axis.unit(), axis.start()), (&[0.0, 0.8, 1.6][..], "current", "A", 0.8));
        assert_eq!(axis.values(number!("gas_force")), Some(&[80.0, 82.5, 85.0][..]));
        assert_eq!(axis.forces(2), Some(&[-1900.0, 0.0, 3300.0][..]));
        let actuator = axis.actuator();
        assert_eq!((actuator.time, actuator.hysteresis), ([0.008, 0.0], 0.05));
        // The parameter set has the values at the start setting, 0.8 A.
        assert_eq!(params.number(number!("gas_force")), 82.5);
        assert_eq!(params.list(list!("fv_force")), [-1500.0, 0.0, 2500.0]);
        crate::family::Family::check(&params, &axis).unwrap();
        // The reader of ordinary dampers rejects the file and changes nothing.
        let mut plain = Params::new();
        let error = read(OVER_CURRENT.as_bytes(), &mut plain).unwrap_err();
        assert_eq!((error.line, error.problem), (9, LineProblem::Family));
        assert_eq!(name_at(OVER_CURRENT.as_bytes(), &error), Some(&b"setting"[..]));
        assert_eq!(plain, Params::new());
        // After reading an ordinary damper, the axis has no grid and no values.
        read_family(SMALL.as_bytes(), &mut params, &mut axis).unwrap();
        assert!(!axis.is_some() && axis.numbers().is_empty() && !axis.has_forces() && axis.name().is_empty());
        assert_eq!(params.number(number!("gas_force")), 12.5);
    }

    #[test]
    fn what_is_wrong_with_a_setting_is_told_with_its_line() {
        let head = "format = 1\nelements = [\"fv_curve\"]\nsetting = [0.0, 1.0]\n";
        let wrong = |text: &str| {
            let (mut params, mut axis) = (Params::new(), Axis::NONE);
            let error = read_family(text.as_bytes(), &mut params, &mut axis).unwrap_err();
            assert!(params == Params::new() && !axis.is_some());
            error
        };
        let row = |reason| move |problem: LineProblem| matches!(problem, LineProblem::Parameter(fault) if fault.reason == reason);
        for (text, line, reason) in [
            ("gas_force = [1, 2, 3]", 4, Reason::SettingCount),
            ("gas_force = [1]", 4, Reason::SettingCount),
            ("gas_force = [1, 1e9]", 4, Reason::OutOfBounds),
            ("fv_form = [\"table\", \"table\"]", 4, Reason::SettingFixed),
            ("substeps = [1, 2]", 4, Reason::SettingFixed),
            ("fv_velocity = [[-1, 1], [-1, 1]]", 4, Reason::SettingFixed),
            ("fv_force = [[0, 1],\n[0, 1, 2]]", 5, Reason::CurveLengths),
            ("fv_force = [[0, 1],\n[0, 1], [0, 1]]", 4, Reason::SettingCount),
            ("fv_force = [[0, 1],\n[0, 1e9]]", 5, Reason::OutOfBounds),
        ] {
            let error = wrong(&format!("{head}{text}\n"));
            assert!(error.line == line && row(reason)(error.problem), "{text}: {error:?}");
        }
        for (text, line, problem) in [
            ("setting_time_up = -1", 4, LineProblem::Setting(Reason::OutOfBounds)),
            ("setting_time_up = [1]", 4, LineProblem::Value),
            ("setting_name = 3", 4, LineProblem::Value),
            (
                "setting_name = \"a name that is longer than there is room for\"",
                4,
                LineProblem::Setting(Reason::PointCount),
            ),
            ("setting_unit = \"A\"\nsetting_unit = \"A\"", 5, LineProblem::Repeated),
            ("setting_tine_up = 1", 4, UNKNOWN),
            ("gas_force = [1, x]", 4, LineProblem::Value),
        ] {
            let error = wrong(&format!("{head}{text}\n"));
            assert_eq!((error.line, error.problem), (line, problem), "{text}");
        }
        for grid in ["[1.0]", "[1, 1]", "[2, 1]", "[1, 2, 3, 4, 5, 6, 7, 8, 9]", "[]", "3", "[\"a\", \"b\"]"] {
            let error = wrong(&format!("format = 1\nelements = []\nsetting = {grid}\n"));
            assert!(
                matches!(error.problem, LineProblem::Setting(Reason::SettingGrid) | LineProblem::Value)
                    && error.line == 3,
                "{grid}: {error:?}"
            );
        }
        // Without a grid, an entry of the setting is an error.
        let error = wrong("format = 1\nelements = []\nsetting_time_up = 1\n");
        assert_eq!((error.line, error.problem), (3, LineProblem::Setting(Reason::SettingGrid)));
        let error = wrong("format = 1\nelements = []\ngas_force = [1, 2]\n");
        assert!(row(Reason::WrongShape)(error.problem));
        let many: std::vec::Vec<_> = table()
            .filter(|row| matches!(row.parameter.shape, Shape::Scalar) && row.element().is_some())
            .take(33)
            .collect();
        let lines: std::string::String = many
            .iter()
            .map(|row| {
                let d = row.parameter.default[0];
                format!("{} = [{d}, {d}]\n", row.parameter.name)
            })
            .collect();
        let error = wrong(&format!("{head}{lines}"));
        assert!(error.line == 36 && row(Reason::SettingTooMany)(error.problem), "{error:?}");
    }

    #[test]
    fn a_file_that_was_cut_off_before_what_it_announces_is_refused() {
        let whole = "# One damper.\n# The lines up to [end] are the damper.\n\nformat = 1\nelements = [\"gas_preload\"]\n\
                     gas_force = 151.93 # N\n\n[end]\n";
        let end = whole.find("[end]\n").unwrap();
        assert!(read(whole.as_bytes(), &mut Params::new()).is_ok());
        // Truncate the file at every position from the first parameter on.
        for cut in whole.find("format").unwrap()..whole.len() {
            let refused = read(&whole.as_bytes()[..cut], &mut Params::new()).is_err();
            assert_eq!(refused, cut <= whole.rfind('[').unwrap(), "{cut} of {end}: {:?}", &whole[..cut]);
        }
        let cut = read(&whole.as_bytes()[..whole.find("1.93").unwrap()], &mut Params::new()).unwrap_err();
        assert!(cut.problem == LineProblem::CutOff && cut.line == 6, "{cut:?}");
    }

    #[test]
    fn a_table_that_is_named_as_an_element_is_refused() {
        let refused = |text: &str| read(text.as_bytes(), &mut Params::new()).unwrap_err();
        let head = "format = 1\nelements = [\"fv_curve\"]\n";
        for (rest, line) in [
            ("[fv_curve]\nfv_form = \"piecewise\"\n", 3),
            ("[identification]\ntests = [\n[1, 2],\n]\n\n  [ integration ]  # mine\nsubsteps = 2\n", 8),
            ("[notes]\n[series_compliance.mine]", 4),
            ("[[fv_curve]]", 3),
        ] {
            let error = refused(&format!("{head}{rest}"));
            assert_eq!((error.line, error.problem), (line, LineProblem::ElementTable), "{rest}");
        }
        // This error precedes the error of a missing `format`, because a file with its elements in tables has no lines
        // above them.
        assert_eq!(refused("[fv_curve]\n").problem, LineProblem::ElementTable);
        for rest in ["[fv_curves]\n", "# [fv_curve]\n", "[notes]\nwhy = \"[fv_curve]\"\n"] {
            assert!(read(format!("{head}{rest}").as_bytes(), &mut Params::new()).is_ok(), "{rest}");
        }
    }

    #[test]
    fn errors_name_the_line_and_change_nothing() {
        let head = "format = 1\nelements = []\n";
        let cases = [
            ("gas_force 5", 3, None, LineProblem::Syntax),
            ("gas_force = 1,5", 3, None, LineProblem::Syntax),
            ("gas_force = five", 3, Some("gas_force"), LineProblem::Value),
            ("gas_force = \"five\"", 3, Some("gas_force"), LineProblem::Value),
            ("gas_force = 5\ngas_force = 6", 4, Some("gas_force"), LineProblem::Repeated),
            ("fv_force = [1,\n2,\nx]", 5, Some("fv_force"), LineProblem::Value),
            ("elements = [\"x\"]", 3, None, LineProblem::Repeated),
        ];
        for (tail, line, name, problem) in cases {
            let parameter = name.and_then(crate::parameter::find).map_or(NO_PARAMETER, |row| row.index as u16);
            let mut params = Params::new();
            let text = std::format!("{head}{tail}");
            assert_eq!(read(text.as_bytes(), &mut params), Err(ReadError { line, parameter, problem }), "{tail}");
            assert_eq!(params, Params::new());
        }
        let parameter = |text: &str| match read(std::format!("{head}{text}").as_bytes(), &mut Params::new()) {
            Err(ReadError { line: 3, problem: LineProblem::Parameter(fault), .. }) => fault.reason,
            other => panic!("{text}: {other:?}"),
        };
        assert_eq!(parameter("gas_forse = 5"), Reason::UnknownName);
        assert_eq!(parameter("series_stiffness = -5"), Reason::OutOfBounds);
        assert_eq!(parameter("series_stiffness = [5]"), Reason::WrongShape);
        assert_eq!(parameter("fv_force = 5"), Reason::WrongShape);
        assert_eq!(parameter("fv_form = \"round\""), Reason::NotAChoice);
        let problem = |text: &str| read(text.as_bytes(), &mut Params::new()).unwrap_err().problem;
        assert_eq!(problem("elements = []"), LineProblem::Format);
        assert_eq!(problem("format = 2\nelements = []"), LineProblem::Format);
        assert_eq!(problem("format = 1"), LineProblem::NoElements);
        assert_eq!(problem("format = 1\nelements = [\"warp_drive\"]"), LineProblem::UnknownElement);
        assert_eq!(problem("format = 1\nelements = [\"fv_curve\",\n\"fv_curve\"]"), LineProblem::Repeated);
        let name = |text: &'static str| {
            read(text.as_bytes(), &mut Params::new())
                .err()
                .and_then(|error| name_at(text.as_bytes(), &error).and_then(|name| core::str::from_utf8(name).ok()))
        };
        assert_eq!(name("format = 1\nelements = [\"fv_curve\", \"warp_drive\"]"), Some("warp_drive"));
        assert_eq!(
            name("format = 1\nelements = [\"fv_curve\", # \"\n\"gas_preload\", \"fv_curve\"]"),
            Some("fv_curve")
        );
        assert_eq!(name("format = 1\nelements = [\"fv_curve\"]\ngas_forse = 5"), Some("gas_forse"));
        assert_eq!(name("format = 2\n"), None);
        assert_eq!(problem(""), LineProblem::Format);
    }
}
