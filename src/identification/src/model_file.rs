//! Reading and writing of model files. A model file contains first the lines that the kernel reads, then tables with the results of the
//! fit.
//!
//! Every host reads the part before the first table with the kernel's own reader ([`dashpot_core::model_file`]). Validation, diagnosis and
//! people use the tables.

use super::short::short;
pub use crate::fit_tables::{FvOnly, FvOnlyAt, Identification, Interval, IntervalOverSetting};
use crate::setting_energy::energy_remark;
use crate::{Estimate, Fit, Measured, Standing, describe_item, to_measurement_error};
use crate::{edited, remarks};
use dashpot_core::family::axis::ENTRIES;
use dashpot_core::family::{Axis, Definition, Family};
use dashpot_core::parameter::GROUPS;
use dashpot_core::parameter::{self, Element, List, Row, Shape};
use dashpot_core::{Fault, Model, Params, model_file};
use dashpot_core::{element, list, number};
use dashpot_estimation::structure::inventory::InventoryItem;
use dashpot_messages::{Kept, Sentence, format_number};
use dashpot_records::{clock, read_small_text};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Contents of a model file.
#[derive(Debug, Clone)]
pub struct ModelFile {
    /// Parameters of the damper.
    pub params: Params,
    /// Setting on which the damper depends. Its grid is empty for an ordinary damper, the only kind that [`read`] accepts.
    pub axis: Axis,
    /// Results of the fit, or empty for a file without a fit.
    pub identification: Identification,
    /// Indices, in the parameter table, of the parameters that the text gives, whether their element is on or off.
    pub specified: Vec<usize>,
    /// Names of the numbers outside the interval from their fit, such as `fv_force[3]@0.8`. [`ModelFile::new`] has removed the intervals of
    /// these numbers.
    pub edited: Vec<String>,
}

/// Reason why a model file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ModelFileError {
    /// The file cannot be read.
    #[error("cannot read the model file {file}: {why}")]
    Unreadable {
        /// Path of the file.
        file: PathBuf,
        /// Reason from the operating system.
        why: std::io::Error,
    },
    /// The file is empty.
    #[error("{file} is empty; dashpot fit writes a model file, docs/parameters.md of dashpot lists what one may hold")]
    Empty {
        /// Path of the file.
        file: PathBuf,
    },
    /// A line before the first table is invalid. The kernel reads this part of the file.
    #[error("{file}, line {line}: {subject}{text}")]
    Line {
        /// Path of the file.
        file: PathBuf,
        /// Line number, from 1.
        line: u32,
        /// Name of the invalid parameter with a colon, or empty.
        subject: String,
        /// Description of the error.
        text: String,
    },
    /// A table after the lines that the kernel reads is invalid.
    #[error("{file}: {why}")]
    Tables {
        /// Path of the file.
        file: PathBuf,
        /// Message of the TOML reader, with line and column.
        why: String,
    },
    /// The file contains a model of the literature that the kernel cannot run.
    #[error(
        "{file} holds a model of the literature for comparison; the kernel cannot run it. Give it to dashpot validate --against"
    )]
    ForComparison {
        /// Path of the file.
        file: PathBuf,
    },
    /// The parameters do not form a valid model.
    #[error("{file}: {fault}")]
    Model {
        /// Path of the file.
        file: PathBuf,
        /// Invalid parameter, and the reason.
        fault: NoModel,
    },
}

/// Reason why parameters do not form a valid model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{parameter} {text}")]
pub struct NoModel {
    /// Invalid parameter.
    pub parameter: &'static str,
    /// Reason why the parameter is invalid.
    pub text: &'static str,
}

/// Makes the model of a parameter set.
///
/// # Errors
/// Returns the invalid parameter and the reason.
pub fn prepared(params: &Params) -> Result<Model, NoModel> {
    Model::new(params).map_err(|fault| NoModel {
        parameter: name_of(fault.parameter).unwrap_or("a parameter"),
        text: fault.reason.text(),
    })
}

/// Makes the damper family of a definition.
///
/// # Errors
/// Returns the invalid parameter and the reason.
pub fn prepared_family(definition: &Definition) -> Result<Box<Family>, NoModel> {
    let mut family = Box::new(Family::OFF);
    family.set(&definition.params, &definition.axis).map_err(no_family)?;
    Ok(family)
}

fn no_family(fault: Fault) -> NoModel {
    NoModel { parameter: name_of(fault.parameter).unwrap_or("the setting"), text: fault.reason.text() }
}

impl ModelFile {
    /// Returns the damper, which may depend on a setting.
    pub fn definition(&self) -> Definition {
        Definition { params: self.params, axis: self.axis }
    }

    /// Makes the contents of the file of a damper. If an interval of `identification` does not contain its number, the number was changed
    /// since the fit. Then the interval is removed.
    pub fn new(params: Params, axis: Axis, mut identification: Identification, specified: Vec<usize>) -> ModelFile {
        let edited = edited::take_out(&params, &axis, &mut identification);
        ModelFile { params, axis, identification, specified, edited }
    }

    /// Returns the remarks on numbers ([`ModelFile::remarks_on_numbers`]) and on energy ([`ModelFile::remark_on_energy`]).
    pub fn remarks(&self) -> Vec<Sentence> {
        let mut all = self.remarks_on_numbers();
        all.extend(self.remark_on_energy());
        all
    }

    /// Returns the remark on energy ([`energy_remark`]) for a damper over a setting whose file comes from no fit or was changed since the
    /// fit. Returns `None` for an unchanged file of a fit, because the fit has its own note.
    pub fn remark_on_energy(&self) -> Option<Sentence> {
        let is_by_hand = !self.identification.is_of_a_fit() || self.was_changed();
        if self.axis.is_some() && is_by_hand { energy_remark(&self.definition()) } else { None }
    }

    /// Returns the remarks on numbers of disabled elements, missing numbers, and numbers changed since the fit.
    pub fn remarks_on_numbers(&self) -> Vec<Sentence> {
        let mut all = remarks::idle(&self.specified, &self.params);
        all.extend(remarks::on_defaults(&self.specified, &self.params, &self.identification));
        all.extend(remarks::edited(&self.edited));
        all
    }

    /// Returns all remarks of the file: the remarks of its fit, and the remarks on its numbers.
    pub fn notes(&self) -> Vec<String> {
        let remarks = self.remarks().into_iter().map(|sentence| sentence.to_string());
        self.identification.notes.iter().cloned().chain(remarks).collect()
    }

    /// Returns whether the damper differs from the damper that the fit wrote into the file.
    ///
    /// The damper differs if a number lies outside its interval in the file, or if an element with an identified number is off. A file that
    /// a user edits keeps the tables of its fit, so these tables show the change. A change within an interval does not count.
    pub fn was_changed(&self) -> bool {
        let known = &self.identification;
        let is_off = |row: &Row| row.element().is_some_and(|element| !self.params.is_on(element));
        let is_identified = |row: &Row| {
            known.intervals.contains_key(row.parameter.name)
                || known.intervals_over_setting.contains_key(row.parameter.name)
        };
        !self.edited.is_empty() || parameter::table().any(|row| is_identified(&row) && is_off(&row))
    }

    /// Returns the parameters of the plain FV curve that the fit stored. If there is none, returns those of the model's own curve and gas
    /// force.
    pub fn plain(&self) -> Params {
        if let Some(Ok(params)) = self.identification.fv_only.as_ref().map(FvOnly::params) {
            return params;
        }
        let mut params = self.params;
        params.disable_all();
        params.enable(element!("fv_curve"), true);
        params.enable(element!("gas_preload"), self.params.is_on(element!("gas_preload")));
        params
    }
}

/// Returns the parameters that affect a damper.
///
/// Parameters of disabled elements and of unselected forms have no effect. For example, the knees of the FV curve have no effect while an
/// FV table is used. Parameters that belong to no element are included if they differ from their default.
pub fn in_use(params: &Params) -> Vec<Row> {
    let says = |row: &Row| match row.element() {
        None => params.get(row) != row.parameter.default,
        Some(_) => params.counts(row) && !params.get(row).is_empty(),
    };
    parameter::table().filter(says).collect()
}

/// Reads a model file and checks that its parameters form a valid model.
///
/// # Errors
/// Returns a [`ModelFileError`] with file, line and parameter.
pub fn read(path: &Path) -> Result<ModelFile, ModelFileError> {
    let file = path.to_path_buf();
    let text = read_small_text(path).map_err(|why| ModelFileError::Unreadable { file, why })?;
    of_text(&text, path)
}

/// Reads a model file whose damper may depend on a setting.
///
/// # Errors
/// The errors of [`read`].
pub fn read_family(path: &Path) -> Result<ModelFile, ModelFileError> {
    let file = path.to_path_buf();
    let text = read_small_text(path).map_err(|why| ModelFileError::Unreadable { file, why })?;
    family_of_text(&text, path)
}

/// Parses the text of a model file and checks that its parameters form a valid model. `path` is the name of the file in messages.
///
/// # Errors
/// The errors of [`read`].
pub fn of_text(text: &str, path: &Path) -> Result<ModelFile, ModelFileError> {
    parsed(text, path, |params, _| model_file::read(text.as_bytes(), params))
}

/// Parses the text of a model file whose damper may depend on a setting.
///
/// # Errors
/// The errors of [`read`].
pub fn family_of_text(text: &str, path: &Path) -> Result<ModelFile, ModelFileError> {
    parsed(text, path, |params, axis| model_file::read_family(text.as_bytes(), params, axis))
}

fn parsed(
    text: &str,
    path: &Path,
    read: impl FnOnce(&mut Params, &mut Axis) -> Result<(), model_file::ReadError>,
) -> Result<ModelFile, ModelFileError> {
    let file = path.to_path_buf();
    if text.trim().is_empty() {
        return Err(ModelFileError::Empty { file });
    }
    if crate::literature::file::is_one(text) {
        return Err(ModelFileError::ForComparison { file });
    }
    let (mut params, mut axis) = (Params::new(), Axis::NONE);
    read(&mut params, &mut axis).map_err(|e| {
        let (subject, mut words) = match e.problem {
            model_file::LineProblem::Parameter(fault) => (subject(fault.parameter), e.problem.text().to_owned()),
            _ => (name_of(e.parameter).map_or(String::new(), |name| format!("{name}: ")), e.problem.text().to_owned()),
        };
        if let model_file::LineProblem::Parameter(fault) = e.problem
            && fault.reason == dashpot_core::Reason::OutOfBounds
        {
            words = format!("{words}{}", bounds(fault.parameter));
        }
        if let Some(name) = model_file::name_at(text.as_bytes(), &e).map(String::from_utf8_lossy) {
            let name = name.as_ref();
            let meant = match e.problem {
                model_file::LineProblem::UnknownElement => nearest(name, Element::all().map(Element::name)),
                model_file::LineProblem::Repeated
                | model_file::LineProblem::Setting(_)
                | model_file::LineProblem::Family => String::new(),
                _ => nearest(name, parameter::table().map(|row| row.parameter.name)),
            };
            words = format!("{name:?}: {words}{meant}");
        }
        ModelFileError::Line { file: file.clone(), line: e.line, subject, text: words }
    })?;
    let substeps = params.number(number!("substeps"));
    if substeps.fract() != 0.0 {
        let line =
            text.lines().position(|line| line.trim_start().starts_with("substeps")).map_or(1, |at| at as u32 + 1);
        let words = format!("a whole number is needed; {substeps} would be taken as {}", substeps.trunc());
        return Err(ModelFileError::Line { file, line, subject: "substeps: ".to_owned(), text: words });
    }
    prepared(&params).map_err(|fault| ModelFileError::Model { file: file.clone(), fault })?;
    if axis.is_some() {
        Family::check(&params, &axis).map_err(|fault| match outside_grid(&axis, text) {
            Some((line, words)) => {
                ModelFileError::Line { file: file.clone(), line, subject: String::new(), text: words }
            }
            None => ModelFileError::Model { file: file.clone(), fault: no_family(fault) },
        })?;
    }
    #[derive(Deserialize)]
    struct Tables {
        #[serde(default)]
        identification: Identification,
    }
    let wrong = |e: toml::de::Error| ModelFileError::Tables { file: file.clone(), why: e.to_string() };
    let names: BTreeMap<String, serde::de::IgnoredAny> = toml::from_str(text).map_err(wrong)?;
    let tables: Tables = toml::from_str(text).map_err(wrong)?;
    let given: Vec<usize> =
        parameter::table().filter(|row| names.contains_key(row.parameter.name)).map(|row| row.index).collect();
    if given.is_empty() {
        parameters_in_tables(text, path)?;
    }
    Ok(ModelFile::new(params, axis, tables.identification, given))
}

/// Checks that the start value of the setting lies within the grid, and that the hysteresis is at most a quarter of the grid's range.
/// Returns line number and message of the first violation.
fn outside_grid(axis: &Axis, text: &str) -> Option<(u32, String)> {
    let line =
        |key: &str| text.lines().position(|line| line.trim_start().starts_with(key)).map_or(1, |at| at as u32 + 1);
    let ((low, high), start) = (axis.range(), axis.start());
    if !(low..=high).contains(&start) {
        let key = "setting_start";
        let [start, low, high] = [start, low, high].map(format_number);
        return Some((line(key), format!("{key} = {start} lies outside the settings of the file, {low} to {high}")));
    }
    let hysteresis = axis.actuator().hysteresis;
    let most = 0.25 * (high - low);
    let key = "setting_hysteresis";
    (hysteresis > most).then(|| {
        let [hysteresis, most, low, high] = [hysteresis, most, low, high].map(format_number);
        let words = format!("{key} = {hysteresis} is more than {most}, a quarter of the way from {low} to {high}: the valve would hardly move");
        (line(key), words)
    })
}

/// Rejects a file that gives parameters inside tables, such as `[parameters]`, because all of them would keep their defaults. The tables of
/// a fit may contain names of parameters, because they give intervals under these names.
fn parameters_in_tables(text: &str, path: &Path) -> Result<(), ModelFileError> {
    let mut table = None;
    for (at, line) in text.lines().enumerate() {
        let line = line.trim_start();
        if let Some(heading) = line.strip_prefix('[') {
            table = Some(heading.split([']', '.']).next().unwrap_or("").trim());
        }
        let name = line.split('=').next().unwrap_or("").trim();
        let is_of_a_fit = table.is_none_or(|table| table == "identification");
        if !is_of_a_fit && line.contains('=') && parameter::find(name).is_some() {
            return Err(ModelFileError::Line {
                file: path.to_path_buf(),
                line: at as u32 + 1,
                subject: format!("{name}: "),
                text: model_file::LineProblem::ElementTable.text().replace("this heading", "the heading of this one"),
            });
        }
    }
    Ok(())
}

fn name_of(parameter: u16) -> Option<&'static str> {
    parameter::table().nth(parameter as usize).map(|row| row.parameter.name)
}

fn subject(parameter: u16) -> String {
    name_of(parameter).map_or(String::new(), |name| format!("{name}: the value "))
}

fn bounds(parameter: u16) -> String {
    parameter::table().nth(parameter as usize).map_or(String::new(), |row| {
        let p = row.parameter;
        format!(" ({} to {} {})", p.low, p.high, p.unit)
    })
}

/// Returns the question "did you mean ...?" with the known name that is most similar to a misspelled name. Returns an empty text if no name
/// is similar.
pub fn nearest(name: &str, known: impl Iterator<Item = &'static str>) -> String {
    let shared = |other: &str| {
        let pairs = |s: &str| s.as_bytes().windows(2).map(<[u8]>::to_vec).collect::<Vec<_>>();
        let (a, b) = (pairs(name), pairs(other));
        2.0 * a.iter().filter(|p| b.contains(p)).count() as f64 / (a.len() + b.len()).max(1) as f64
    };
    known
        .max_by(|a, b| shared(a).total_cmp(&shared(b)))
        .filter(|best| shared(best) > 0.6)
        .map_or(String::new(), |best| format!("; did you mean {best}?"))
}

pub(crate) fn number(value: f64) -> String {
    format!("{value:?}")
}

pub(crate) fn text(value: &str) -> String {
    // Format a TOML basic string.
    let mut out = String::from("\"");
    for c in value.chars() {
        match c {
            '\\' | '"' => out.extend(['\\', c]),
            '\n' => out.push(' '),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out + "\""
}

fn value(row: &Row, params: &Params, axis: &Axis) -> String {
    let values = params.get(row);
    let all = |values: &[f64]| format!("[{}]", values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(", "));
    if let Some(over) = dashpot_core::parameter::Number::try_from(*row).ok().and_then(|number| axis.values(number)) {
        return all(over);
    }
    if *row == *list!("fv_force").row() && axis.has_forces() {
        let lines: Vec<String> = (0..axis.grid().len()).filter_map(|index| axis.forces(index)).map(all).collect();
        return format!("[\n    {},\n]", lines.join(",\n    "));
    }
    match row.parameter.shape {
        Shape::Scalar => number(values[0]),
        Shape::Choice(words) => text(words[values[0] as usize]),
        Shape::List(_) => all(values),
    }
}

/// Formats the part of a model file that the kernel reads. `comment` returns the comment behind each parameter.
pub fn flat(params: &Params, comment: impl Fn(&Row) -> String) -> String {
    flat_keeping(params, &[], comment)
}

/// Formats the part that the kernel reads, including parameters of disabled elements at the indices `kept`. Thus these parameters stay in
/// the file when a user changes another number, and their elements can be enabled later.
pub fn flat_keeping(params: &Params, kept: &[usize], comment: impl Fn(&Row) -> String) -> String {
    flat_over(params, &Axis::NONE, kept, comment)
}

/// Formats the part that the kernel reads, for a damper that may depend on a setting.
pub fn flat_family(damper: &Definition, comment: impl Fn(&Row) -> String) -> String {
    flat_over(&damper.params, &damper.axis, &[], comment)
}

/// Formats the lines of the setting on which a damper depends. Returns an empty text for an ordinary damper.
fn setting(axis: &Axis) -> String {
    if !axis.is_some() {
        return String::new();
    }
    let grid = axis.grid().iter().map(|value| number(*value)).collect::<Vec<_>>().join(", ");
    let mut out = format!("\n# The setting that this damper depends on\nsetting = [{grid}]\n");
    for (name, word) in [("setting_name", axis.name()), ("setting_unit", axis.unit())] {
        if !word.is_empty() {
            let _ = writeln!(out, "{name} = {}", text(word));
        }
    }
    for (index, entry) in ENTRIES.iter().enumerate() {
        let value = axis.number(index);
        // The start value of the setting (index 0) is always written. Times, rates and hysteresis of 0 are omitted.
        if index == 0 || value != 0.0 {
            let _ = writeln!(out, "{} = {}  # {}", entry.name, number(value), entry.meaning);
        }
    }
    out
}

fn flat_over(params: &Params, axis: &Axis, kept: &[usize], comment: impl Fn(&Row) -> String) -> String {
    let on: Vec<String> = Element::all().filter(|e| params.is_on(*e)).map(|e| text(e.name())).collect();
    let mut out = format!("format = 1\nelements = [{}]\n{}", on.join(", "), setting(axis));
    for (g, group) in GROUPS.iter().enumerate() {
        let element = Element::of_group(g);
        let is_off = element.is_some_and(|element| !params.is_on(element));
        let rows: Vec<Row> = parameter::table()
            .filter(|row| row.group == g)
            .filter(|row| !is_off || kept.contains(&row.index))
            // Skip empty lists, and parameters without an element at their default.
            .filter(|row| element.is_some() || params.get(row) != row.parameter.default)
            .filter(|row| !params.get(row).is_empty())
            .collect();
        if rows.is_empty() {
            continue;
        }
        let off = if is_off { " (off; the numbers are kept)" } else { "" };
        let _ = write!(out, "\n# {}: {}{off}\n", group.name, group.meaning);
        for row in rows {
            let _ = writeln!(out, "{} = {}  # {}", row.parameter.name, value(&row, params, axis), comment(&row));
        }
    }
    out
}

/// Formats a model file without results of a fit. The remarks are comments at the beginning of the file.
pub fn plain(params: &Params, remarks: &[String]) -> String {
    let mut out = String::from(
        "# A damper for dashpot. SI units; extension (rebound) and tension positive.\n\
         # The lines up to [end] are the damper.\n",
    );
    for line in remarks.iter().flat_map(|remark| remark.lines()) {
        let _ = writeln!(out, "# {line}");
    }
    out.push('\n');
    out + &flat(params, |row| {
        let p = row.parameter;
        if p.unit == "-" { p.meaning.to_owned() } else { format!("{}; {}", p.unit, p.meaning) }
    }) + "\n[end]\n"
}

/// Formats the table of a model file that contains a plain FV curve.
fn fv_only_table(curve: &FvOnly) -> String {
    format!("\n[identification.fv_only]  # the plain FV curve fitted to the same tests\n{}", curve.lines())
}

/// Formats the model file of an ordinary damper: its numbers, then the tables of its fit. Without results of a fit, formats a [`plain`]
/// file.
///
/// # Errors
/// Returns an error if TOML cannot represent the tables.
pub fn with_tables(file: &ModelFile, remarks: &[String]) -> Result<String, toml::ser::Error> {
    #[derive(Serialize)]
    struct Tables<'a> {
        identification: &'a Identification,
    }
    let known = &file.identification;
    if known.tests.is_empty() && known.intervals.is_empty() && known.fv_only.is_none() {
        return Ok(plain(&file.params, remarks));
    }
    Ok(plain(&file.params, remarks) + "\n" + &toml::to_string(&Tables { identification: known })?)
}

/// Formats unit and meaning of a parameter. Also formats interval and source from the fit if there is exactly one estimate.
pub(crate) fn describe_parameter(row: &Row, estimates: &[&Estimate]) -> String {
    let p = row.parameter;
    let mut words = if p.unit == "-" { String::new() } else { format!("{}; ", p.unit) };
    words += p.meaning;
    if let [estimate] = estimates {
        match (&estimate.standing, estimate.low, estimate.high) {
            (Standing::NotIdentified, ..) => words += "; not identified from this data",
            (_, Some(low), Some(high)) => {
                let _ = write!(words, "; 95 %: {} to {}; from {}", short(low), short(high), estimate.from);
            }
            _ => {}
        }
    }
    words
}

/// Formats the lower and upper end of an interval. Without an interval, both ends are the value.
pub(crate) fn format_pair(estimate: Option<&Estimate>, value: f64) -> String {
    match estimate {
        Some(Estimate { low: Some(low), high: Some(high), .. }) => format!("[{}, {}]", number(*low), number(*high)),
        _ => format!("[{0}, {0}]", number(value)),
    }
}

/// Formats the intervals of the points of a curve. The fixed point of the curve is exact by definition, so both ends of its interval are
/// its value.
pub(crate) fn format_points(estimates: &[&Estimate], values: &[f64]) -> String {
    let of = |k: usize| estimates.iter().find(|e| e.index == Some(k)).copied();
    let pairs: Vec<String> = values.iter().enumerate().map(|(k, value)| format_pair(of(k), *value)).collect();
    format!("[{}]", pairs.join(", "))
}

/// Information of a fit about its records, for the table `[identification]`.
pub(crate) struct Account<'f> {
    pub(crate) tests: &'f [String],
    pub(crate) fingerprints: &'f [String],
    pub(crate) not_identified: &'f [String],
    pub(crate) inventory: &'f [InventoryItem],
    pub(crate) notes: &'f [Sentence],
    pub(crate) sources: Vec<&'f Sentence>,
    pub(crate) measured: &'f [Measured],
    pub(crate) clock_from: Option<f64>,
}

/// Returns the sources of single numbers. A model file does not state the sources of the points of curves.
pub(crate) fn sources<'e>(estimates: impl Iterator<Item = &'e Estimate>) -> Vec<&'e Sentence> {
    estimates.filter(|estimate| estimate.index.is_none()).map(|estimate| &estimate.from).collect()
}

/// Writes the table `[identification]`.
pub(crate) fn write_account(out: &mut String, account: &Account) {
    let list =
        |items: &[String]| format!("[\n{}]", items.iter().map(|i| format!("    {},\n", text(i))).collect::<String>());
    let _ = writeln!(out, "\n[identification]\ntests = {}", list(account.tests));
    let _ = writeln!(out, "fingerprints = {}", list(account.fingerprints));
    let _ = writeln!(out, "not_identified = {}", list(account.not_identified));
    let inventory = account.inventory.iter().map(describe_item);
    let notes: Vec<Sentence> = inventory.chain(account.notes.iter().cloned()).collect();
    let _ = writeln!(out, "notes = {}", list(&notes.iter().map(ToString::to_string).collect::<Vec<_>>()));
    let mut messages: Vec<String> = Vec::new();
    for sentence in notes.iter().chain(account.sources.iter().copied()) {
        let Ok(message) = toml::Value::try_from(Kept::from(sentence)).map(|kept| kept.to_string()) else { continue };
        if !messages.contains(&message) {
            messages.push(message);
        }
    }
    let lines: String = messages.iter().map(|message| format!("    {message},\n")).collect();
    let _ = writeln!(out, "messages = [  # notes and sources, for reports in other languages\n{lines}]");
    let errors = to_measurement_error(account.measured);
    let drifts = errors.gain_per_s != 0.0 || errors.zero_n_per_s != 0.0;
    if let Some(from) = account.clock_from.filter(|_| drifts) {
        let _ =
            writeln!(out, "clock_from = \"{}\"  # when what drifts in the measurement was right", clock::written(from));
    }
}

/// Writes the interval of a number, or the intervals of all points of a curve. Writes nothing for a number without an interval.
pub(crate) fn write_interval(out: &mut String, name: &str, estimates: &[&Estimate], params: &Params) {
    if let [estimate @ Estimate { index: None, .. }] = estimates {
        if estimate.low.is_some() {
            let _ = writeln!(out, "{name} = {}", format_pair(Some(estimate), estimate.value));
        }
    } else {
        let values = List::find(name).map_or(&[][..], |list| params.list(list));
        let _ = writeln!(out, "{name} = {}", format_points(estimates, values));
    }
}

/// Writes the measurement errors of the records, and the kinds of tests from which each number of `numbers` was identified.
pub(crate) fn write_origins<'e>(
    out: &mut String,
    measured: &[Measured],
    numbers: impl Iterator<Item = (&'e str, Vec<&'e Estimate>)>,
) {
    if !measured.is_empty() {
        *out += "\n[identification.measurement]  # what the records are off by, value and 95 %; taken out of them, never of the damper\n";
        for Measured { name, value, low, high, .. } in measured {
            let _ = writeln!(out, "{name} = [{}, {}, {}]", number(*value), number(*low), number(*high));
        }
    }
    *out += "\n[identification.sources]  # share of the information by kind of test\n";
    for (name, estimates) in numbers {
        if let [Estimate { index: None, from, .. }] = estimates[..] {
            let _ = writeln!(out, "{name} = {}", text(&from.to_string()));
        }
    }
}

/// Formats the model file of a fit.
pub fn write(fit: &Fit) -> String {
    let of = |name: &str| fit.estimates.iter().filter(|e| e.name == name).collect::<Vec<&Estimate>>();
    let mut out = String::from(
        "# A damper identified by dashpot. SI units; extension (rebound) and tension positive.\n\
         # The lines up to [identification] are the damper; what follows is for people and tools.\n\n",
    );
    out += &flat(&fit.params, |row| describe_parameter(row, &of(row.parameter.name)));
    let mut not_identified: Vec<String> = fit
        .estimates
        .iter()
        .filter(|e| e.standing == Standing::NotIdentified)
        .map(|e| e.index.map_or(e.name.to_owned(), |i| format!("{}[{i}]", e.name)))
        .collect();
    not_identified.dedup();
    let account = Account {
        tests: &fit.tests,
        fingerprints: &fit.fingerprints,
        not_identified: &not_identified,
        inventory: &fit.inventory,
        notes: &fit.notes,
        sources: sources(fit.estimates.iter()),
        measured: &fit.measured,
        clock_from: fit.clock_from,
    };
    write_account(&mut out, &account);
    out += "\n[identification.intervals]  # 95 %\n";
    let mut names: Vec<&str> = fit.estimates.iter().map(|e| e.name).collect();
    names.dedup();
    for name in &names {
        write_interval(&mut out, name, &of(name), &fit.params);
    }
    write_origins(&mut out, &fit.measured, names.iter().map(|name| (*name, of(name))));
    out + &fv_only_table(&FvOnly::from_params(&fit.fv_only))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_none_is_told_with_what_it_may_mean() {
        for (text, words) in [
            ("elements = [\"fv_curve\", \"bumpstop\"]\n", "\"bumpstop\": elements names something that is no element"),
            ("elements = [\"fv_curve\", \"bumpstop\"]\n", "did you mean bump_stop?"),
            ("elements = [\"fv_curve\",\n\"fv_curve\"]\n", "\"fv_curve\": the name appears a second time"),
            ("elements = [\"fv_curve\"]\ngas_forze = 3\n", "did you mean gas_force?"),
            (
                "elements = [\"fv_curve\"]\nsubsteps = 2.5\n",
                "line 3: substeps: a whole number is needed; 2.5 would be taken as 2",
            ),
        ] {
            let error = of_text(&format!("format = 1\n{text}"), Path::new("m.toml")).unwrap_err().to_string();
            assert!(error.contains(words), "{error}");
        }
    }

    #[test]
    fn the_flat_part_is_toml_and_reads_back_exactly() {
        let mut params = Params::new();
        params.set(number!("series_stiffness"), 2.345_678_901_234_5e6).unwrap();
        params.set(number!("gas_force"), -0.1).unwrap();
        params.set(number!("method"), 1.0).unwrap();
        let text = flat(&params, |_| String::new());
        let mut back = Params::new();
        model_file::read(text.as_bytes(), &mut back).unwrap();
        assert_eq!(back, params);
        let table: toml::Table = text.parse().unwrap();
        assert_eq!(table["series_stiffness"].as_float(), Some(2.345_678_901_234_5e6));
        assert_eq!(table["fv_force"].as_array().unwrap().len(), params.list(list!("fv_force")).len());
    }

    #[test]
    fn a_family_is_toml_and_reads_back_exactly() {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 0.7, 1.6]).unwrap();
        axis.set_name("current").unwrap();
        axis.set_unit("A").unwrap();
        for (index, value) in [0.1, 0.008, 0.02, 0.005, 100.0, 50.0, 0.03].into_iter().enumerate() {
            axis.set_number(index, value).unwrap();
        }
        let mut params = Params::new();
        axis.set_values(number!("gas_force"), &[80.0, 81.5, 90.1]).unwrap();
        for index in 0..3 {
            let forces: Vec<f64> =
                params.list(list!("fv_force")).iter().map(|force| force * (1.0 + index as f64 / 3.0)).collect();
            axis.set_forces(index, &forces).unwrap();
        }
        axis.put(&mut params, 0.1);
        let damper = Definition { params, axis };
        let text = flat_family(&damper, |row| row.parameter.meaning.to_owned());
        let _: toml::Table = text.parse().unwrap();
        let file = family_of_text(&text, Path::new("family.toml")).unwrap();
        assert_eq!(file.definition(), damper);
        assert_eq!(flat_family(&file.definition(), |row| row.parameter.meaning.to_owned()), text);
        // The reader of ordinary dampers rejects this file. The message states the remedy.
        let error = of_text(&text, Path::new("family.toml")).unwrap_err().to_string();
        assert!(error.starts_with("family.toml, line 5: \"setting\": the damper depends on this setting"), "{error}");
        let error = family_of_text(&text.replace("setting_start = 0.1", "setting_start = 9.0"), Path::new("f.toml"))
            .unwrap_err();
        assert!(
            error.to_string().contains(": setting_start = 9 lies outside the settings of the file, 0 to 1.6"),
            "{error}"
        );
        let error =
            family_of_text(&text.replace("setting_hysteresis = 0.03", "setting_hysteresis = 0.9"), Path::new("f.toml"))
                .unwrap_err();
        assert!(error.to_string().contains("setting_hysteresis = 0.9 is more than 0.4"), "{error}");
    }

    #[test]
    fn a_number_of_an_element_that_is_off_is_told() {
        let of = |text: &str| of_text(&format!("format = 1\n{text}"), Path::new("m.toml")).unwrap();
        let text = "elements = [\"fv_curve\"]\nfv_form = \"table\"\ngas_force = 150\ncoulomb_force = 40\ncoulomb_steepness = 1000\nsubsteps = 2\n";
        let mut file = of(text);
        let said = file.notes();
        assert_eq!(said.len(), 2, "{said:?}");
        let with = |name: &str| said.iter().find(|note| note.contains(name)).unwrap().clone();
        assert!(with("gas_force").contains("gas_preload is off"), "{said:?}");
        assert!(with("coulomb_force").contains("coulomb_steepness"), "{said:?}");
        // A user interface may enable the element of the gas force. The note on it then disappears.
        file.params.enable(element!("gas_preload"), true);
        assert_eq!(file.notes().len(), 1);
        let on = "elements = [\"gas_preload\"]\ngas_force = 150\n[identification]\nnotes = [\"kept\"]\n";
        assert_eq!(of(on).notes(), ["kept"]);
        // A file that dashpot writes contains no number without effect.
        assert_eq!(
            of(flat(&Params::new(), |_| String::new()).trim_start_matches("format = 1\n")).notes(),
            Vec::<String>::new()
        );
    }

    #[test]
    fn a_file_whose_parameters_all_stand_in_tables_is_refused() {
        let of = |text: &str| of_text(&format!("format = 1\nelements = [\"fv_curve\"]\n{text}"), Path::new("m.toml"));
        let error = of("[parameters]\n# 1\nfv_form = \"piecewise\"\n").unwrap_err().to_string();
        assert!(error.starts_with("m.toml, line 5: fv_form: parameters stand above the first [table]"), "{error}");
        let error = of("fv_form = \"table\"\n[fv_curve]\nfv_form = \"piecewise\"\n").unwrap_err().to_string();
        assert!(error.starts_with("m.toml, line 4: parameters stand above the first [table]"), "{error}");
        // Tables of notes and tables of a fit are allowed.
        for rest in [
            "substeps = 2\n[notes]\nsubsteps = 4\n",
            "[notes]\nwhy = \"mine\"\n",
            "[identification.intervals]\nfv_rebound_c1 = [1, 2]\n",
        ] {
            assert!(of(rest).is_ok(), "{rest}");
        }
    }

    #[test]
    fn a_number_of_another_form_is_not_in_use() {
        let names = |text: &str| -> Vec<&str> {
            let file = of_text(&format!("format = 1\n{text}"), Path::new("m.toml")).unwrap();
            in_use(&file.params).iter().map(|row| row.parameter.name).collect()
        };
        let table = names("elements = [\"fv_curve\", \"parallel_spring\"]\ngas_force = 150\n");
        let spring = ["spring_linear", "spring_quadratic", "spring_cubic", "spring_quartic"];
        assert_eq!(table, [&["fv_form", "fv_interpolation", "fv_velocity", "fv_force"][..], &spring[..]].concat());
        let knees = names("elements = [\"fv_curve\"]\nfv_form = \"piecewise\"\nsubsteps = 4\n");
        assert!(knees.contains(&"fv_rebound_v2") && knees.contains(&"substeps"), "{knees:?}");
        assert!(!knees.contains(&"fv_force") && !knees.contains(&"method"), "{knees:?}");
        // Every element has numbers that take effect once the element is enabled.
        for element in Element::all() {
            let mut params = Params::new();
            params.enable(element, true);
            if Model::new(&params).is_ok() {
                assert!(in_use(&params).iter().any(|row| row.element() == Some(element)), "{}", element.name());
            }
        }
    }

    #[test]
    fn every_text_survives_the_file() {
        for name in ["Dämpfer \"A\" – 試験\\1", "a\tb\u{1}c\u{7f}", "# [x] = 'y'"] {
            let table: toml::Table = format!("name = {}", text(name)).parse().unwrap();
            assert_eq!(table["name"].as_str(), Some(name));
        }
    }

    #[test]
    fn a_misspelt_name_is_named_with_its_line_and_a_suggestion() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("m.toml");
        std::fs::write(&path, "format = 1\nelements = []\nseries_stifness = 1e6\n").unwrap();
        let message = read(&path).unwrap_err().to_string();
        assert!(message.contains("line 3") && message.contains("series_stiffness"), "{message}");
    }
}
