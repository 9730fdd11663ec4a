//! Finds the columns of velocities and forces in a table of peaks, their strokes, and the pairs of velocity and force.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use crate::columns::cell::number;
use crate::columns::channel_headings::headings;
use crate::columns::heading::{Heading, heading, nearest, without_unit, words};
use crate::columns::table::{HEADER_WITHIN, is_units_row};
use crate::quantities::channel::Channel;
use crate::quantities::unit::{Dimension, Unit};

/// Direction of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stroke {
    /// Extension.
    Rebound,
    /// Compression.
    Compression,
}

impl Stroke {
    /// Returns the sign of the velocities and forces of the stroke in the internal convention, which is positive in
    /// rebound.
    pub fn sign(self) -> f64 {
        match self {
            Stroke::Rebound => 1.0,
            Stroke::Compression => -1.0,
        }
    }

    /// Returns the name of the direction.
    pub fn name(self) -> &'static str {
        match self {
            Stroke::Rebound => "rebound",
            Stroke::Compression => "compression",
        }
    }
}

/// Possible meaning of a column: a velocity or a force, of one stroke or of both strokes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct PeakColumn {
    force: bool,
    stroke: Option<Stroke>,
}

impl PeakColumn {
    fn dimension(self) -> Dimension {
        if self.force { Dimension::Force } else { Dimension::Speed }
    }

    fn channel(self) -> Channel {
        if self.force { Channel::Force } else { Channel::Velocity }
    }
}

impl fmt::Display for PeakColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(stroke) = self.stroke {
            write!(f, "{}_", stroke.name())?;
        }
        f.write_str(self.channel().name())
    }
}

impl FromStr for PeakColumn {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let strokes = [None, Some(Stroke::Rebound), Some(Stroke::Compression)];
        let all = strokes.into_iter().flat_map(|stroke| [false, true].map(|force| PeakColumn { force, stroke }));
        let known: Vec<PeakColumn> = all.collect();
        let wanted = words(text).join("_");
        known.iter().find(|column| column.to_string() == wanted).copied().ok_or_else(|| {
            let names: Vec<String> = known.iter().map(ToString::to_string).collect();
            format!("'{text}' is no column of a table of peaks; they are {}", names.join(", "))
        })
    }
}

/// Statements of the user about a table of peaks. By default all information comes from the table.
#[derive(Debug, Clone, Default)]
pub struct PeakOptions {
    /// Positive direction of a table with signs, rebound by default.
    pub positive: Option<crate::options::Positive>,
    /// The click of the curve to read, for a table of an adjustable damper.
    pub clicks: Option<f64>,
    /// Units of velocity and force, which take precedence over the headings.
    pub units: BTreeMap<Channel, Unit>,
    /// Headings, or numbers from 1, of the columns that the user names.
    pub columns: BTreeMap<PeakColumn, String>,
}

impl PeakOptions {
    /// Sets the unit of a channel from its text.
    ///
    /// # Errors
    /// The channel does not occur in tables of peaks, or the unit is not a unit of the channel.
    pub fn unit_of(&mut self, channel: Channel, text: &str) -> Result<(), String> {
        if !matches!(channel, Channel::Velocity | Channel::Force) {
            return Err(format!("a table of peaks has velocity and force, no {channel}"));
        }
        let unit: Unit = text.parse()?;
        if unit.dimension() != channel.dimension() {
            return Err(format!("{unit} is no unit of {channel}; it may be in {}", channel.units_understood()));
        }
        self.units.insert(channel, unit);
        Ok(())
    }
}

/// A column that is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Taken {
    /// Index in the row, from 0.
    pub index: usize,
    /// Heading of the column.
    pub heading: String,
    /// Unit of the column.
    pub unit: Unit,
}

/// A column of forces and the column of their velocities.
#[derive(Debug, Clone, PartialEq)]
pub struct PeakPair {
    /// The velocities.
    pub velocity: Taken,
    /// The forces.
    pub force: Taken,
    /// The stroke of both, or `None` if the signs determine the stroke.
    pub stroke: Option<Stroke>,
}

/// The columns of a table, and its first row.
pub(crate) struct Found {
    /// Index of the heading among the rows, or of the row above the data if the user names all columns by number.
    /// `None` without such a row.
    pub header: Option<usize>,
    /// Index of the first row below the heading and its units.
    pub data: usize,
    pub pairs: Vec<PeakPair>,
}

/// Reason for which no columns were found: the index of the row, and a message.
pub(crate) type Cause = (usize, String);

/// Words for rebound in headings, in several languages.
const REBOUND: [&str; 14] = [
    "rebound",
    "reb",
    "ext",
    "extension",
    "tension",
    "zug",
    "zugstufe",
    "ausfedern",
    "ausfederung",
    "detente",
    "estensione",
    "extensione",
    "traccion",
    "rimbalzo",
];
const COMPRESSION: [&str; 11] = [
    "compression",
    "comp",
    "compr",
    "bump",
    "jounce",
    "druck",
    "druckstufe",
    "einfedern",
    "einfederung",
    "compressione",
    "compresion",
];
/// Prefixes for rebound that Chinese and German join to the quantity, such as `Zugkraft`. [`COMPRESSION_BEFORE`]
/// contains those for compression, such as `Druckgeschwindigkeit`, 压缩力. `Druck` (compression) also means pressure, but
/// a pressure has no unit of force and is thus not read.
const REBOUND_BEFORE: [&str; 4] = ["zug", "复原", "拉伸", "回弹"];
const COMPRESSION_BEFORE: [&str; 2] = ["druck", "压缩"];
/// Letters for rebound and compression. A letter indicates a stroke only if the other letter of the pair is in the same
/// heading line.
///
/// An example is `V-C, C, V-R, R`. A single `c` may also be a damping coefficient, and a single `r` a correlation.
const LETTERS: [(&str, &str); 6] = [("r", "c"), ("r", "b"), ("r", "j"), ("e", "c"), ("z", "d"), ("d", "c")];

/// A column that may contain a velocity or a force.
#[derive(Debug, Clone)]
struct Candidate {
    index: usize,
    what: PeakColumn,
    /// Unit from the heading, the row below or the user. `None` if none of them states a unit.
    unit: Option<Unit>,
    /// Whether the heading names only the quantity and its stroke.
    plain: bool,
}

/// A velocity, its force, and the stroke of both.
type Chosen<'a> = (&'a Candidate, &'a Candidate, Option<Stroke>);

/// Finds the heading line and the columns in it.
pub(crate) fn find(rows: &[(usize, Vec<String>)], options: &PeakOptions) -> Result<Found, Cause> {
    if let Some(found) = numbered(rows, options)? {
        return Ok(found);
    }
    let mut without_units = None;
    for (k, (_, cells)) in rows.iter().enumerate().take(HEADER_WITHIN) {
        let below = rows.get(k + 1).map(|row| &*row.1).filter(|row| is_units_row(row));
        let candidates = candidates(cells, below, options);
        // A line with a column name that the user stated is also the heading, because names such as RO and CO are not
        // recognized.
        let asked = |(what, text): (&PeakColumn, &String), force: bool| {
            what.force == force && text.trim().parse::<f64>().is_err() && cells.iter().any(|cell| is_headed(cell, text))
        };
        let has = |force: bool| {
            candidates.iter().any(|c| c.what.force == force)
                || options.columns.iter().any(|column| asked(column, force))
        };
        if !(has(false) && has(true)) {
            continue;
        }
        let candidates = named(candidates, cells, below, options).map_err(|cause| (k, cause))?;
        let chosen = pairs(&candidates, cells).map_err(|cause| (k, cause))?;
        let header = Some(k);
        let data = k + 1 + usize::from(below.is_some());
        match taken(&chosen, cells) {
            Ok(pairs) => return Ok(Found { header, data, pairs }),
            Err(cause) => without_units = without_units.or(Some((k, cause))),
        }
    }
    Err(without_units.unwrap_or_else(|| {
        let cause = "no header that names velocity and force with their units, such as velocity_mm_s,force_N or velocity [m/s],rebound \
                     [N],compression [N]; --column and --unit say what a table does not, such as --column rebound_force=2 --unit force=lbf";
        (0, cause.to_owned())
    }))
}

/// Returns the columns if the user names columns only by number, among them a velocity and a force. Otherwise returns
/// `None`. With numbers, the table requires no heading.
fn numbered(rows: &[(usize, Vec<String>)], options: &PeakOptions) -> Result<Option<Found>, Cause> {
    let given: Option<Vec<(PeakColumn, usize)>> = options
        .columns
        .iter()
        .map(|(what, text)| Some((*what, text.trim().parse::<usize>().ok()?.checked_sub(1)?)))
        .collect();
    let Some(given) = given else { return Ok(None) };
    let has = |force: bool| given.iter().any(|(what, _)| what.force == force);
    if !(has(false) && has(true)) {
        return Ok(None);
    }
    let is_number = |text: &String| number(text, true).is_some_and(f64::is_finite);
    let first = rows.iter().position(|(_, cells)| given.iter().all(|(_, at)| cells.get(*at).is_some_and(is_number)));
    let Some(data) = first else {
        let columns: Vec<String> = given.iter().map(|(_, at)| (at + 1).to_string()).collect();
        return Err((0, format!("no row has numbers in the columns {} that --column names", columns.join(", "))));
    };
    let above = |by: usize| data.checked_sub(by).map(|k| &*rows[k].1);
    let units = above(1).filter(|row| is_units_row(row));
    let heading = if units.is_some() { above(2) } else { above(1) };
    let nothing = Vec::new();
    let cells = heading.unwrap_or(&nothing);
    let candidates: Vec<Candidate> =
        given.iter().map(|(what, index)| candidate(*index, *what, cells, units, options)).collect();
    let place = data.saturating_sub(1);
    let chosen = pairs(&candidates, cells).map_err(|cause| (place, cause))?;
    let pairs = taken(&chosen, cells).map_err(|cause| (place, cause))?;
    Ok(Some(Found { header: data.checked_sub(1), data, pairs }))
}

/// Returns the possible columns of a heading line.
fn candidates(cells: &[String], below: Option<&[String]>, options: &PeakOptions) -> Vec<Candidate> {
    let says: Vec<Vec<String>> = cells.iter().map(|cell| words(cell)).collect();
    let letters = LETTERS.into_iter().find(|(rebound, compression)| {
        let stands = |letter: &str| says.iter().zip(cells).any(|(words, cell)| tells(words, cell, letter));
        stands(rebound) && stands(compression)
    });
    let mut found = Vec::new();
    for (index, cell) in cells.iter().enumerate() {
        let words = &says[index];
        let read = heading(cell);
        let other = match &read {
            Heading::Channel(channel, _) => !matches!(channel, Channel::Velocity | Channel::Force),
            Heading::Test | Heading::SampleTime(_) | Heading::SampleRate => true,
            Heading::Unknown => false,
        };
        // In records, `Extension` is a displacement. Tables of peaks have no displacement, so the word means the
        // stroke.
        let other = other && !matches!(read, Heading::Channel(Channel::Displacement, _));
        let stroke = stroke(words, cell, letters);
        let unit = unit(cell).or_else(|| below.and_then(|row| row.get(index)).and_then(|c| c.parse().ok()));
        let named = quantity(words);
        // A column in m/s is a velocity under any heading. A column in N may be a hysteresis width instead of a force.
        let force = match (unit.map(Unit::dimension), named) {
            (Some(Dimension::Speed), _) => false,
            (Some(Dimension::Force), Some(false)) => continue,
            (Some(Dimension::Force), named) if named.is_some() || stroke.is_some() => true,
            (Some(_), _) => continue,
            (None, _) if foreign_unit(cell, letters) => continue,
            (None, Some(force)) => force,
            (None, None) if stroke.is_some() && words.len() == 1 => true,
            (None, None) => continue,
        };
        if other {
            continue;
        }
        found.push(candidate(index, PeakColumn { force, stroke }, cells, below, options));
    }
    found
}

fn candidate(
    index: usize,
    what: PeakColumn,
    cells: &[String],
    below: Option<&[String]>,
    options: &PeakOptions,
) -> Candidate {
    let cell = cells.get(index).map_or("", |c| c.as_str());
    let of_row = below.and_then(|row| row.get(index)).and_then(|c| c.parse::<Unit>().ok());
    let own = unit(cell).or(of_row).filter(|unit| unit.dimension() == what.dimension());
    let given = options.units.get(&what.channel()).copied();
    let without = without_unit(cell);
    let plain = without.split(' ').filter(|word| !word.is_empty()).all(|word| {
        quantity(&[word.to_owned()]).is_some()
            || stroke(&[word.to_owned()], word, None).is_some()
            || word.chars().count() == 1
    });
    Candidate { index, what, unit: given.or(own), plain }
}

/// Returns whether a heading without its unit equals the user's name for a column.
fn is_headed(cell: &str, wanted: &str) -> bool {
    cell.trim().eq_ignore_ascii_case(wanted.trim()) || without_unit(cell) == without_unit(wanted)
}

/// Replaces candidates by the columns that the user names for the same quantity and stroke.
fn named(
    mut candidates: Vec<Candidate>,
    cells: &[String],
    below: Option<&[String]>,
    options: &PeakOptions,
) -> Result<Vec<Candidate>, String> {
    for (what, text) in &options.columns {
        let wanted = text.trim();
        let of_name: Vec<usize> = (0..cells.len()).filter(|&k| is_headed(&cells[k], wanted)).collect();
        let of_number = || wanted.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).filter(|k| *k < cells.len());
        let index = match of_name[..] {
            [one] => one,
            [] => of_number().ok_or_else(|| {
                let near = nearest(wanted, cells.iter().map(String::as_str));
                let near = near.map_or_else(String::new, |near| format!("; '{near}' is near"));
                format!("--column {what}={wanted} names no column; there are {}{near}", listed(cells.iter()))
            })?,
            _ => {
                let numbers: Vec<String> = of_name.iter().map(|k| (k + 1).to_string()).collect();
                return Err(format!(
                    "--column {what}={wanted} names the columns {} alike; give the number of one",
                    numbers.join(" and ")
                ));
            }
        };
        // A column that the user names for one stroke replaces the candidates of its quantity for this stroke, and
        // those without a stroke. A column named without a stroke replaces all candidates of its quantity. Other
        // columns that the user names remain.
        candidates.retain(|c| {
            let of_kind = c.what.force == what.force
                && (what.stroke.is_none() || c.what.stroke.is_none() || c.what.stroke == what.stroke);
            let given = options.columns.contains_key(&c.what) && c.what != *what;
            c.index != index && (!of_kind || given)
        });
        candidates.push(candidate(index, *what, cells, below, options));
    }
    candidates.sort_by_key(|c| c.index);
    Ok(candidates)
}

/// Pairs the forces with their velocities, and determines the stroke of each pair.
fn pairs<'a>(candidates: &'a [Candidate], cells: &[String]) -> Result<Vec<Chosen<'a>>, String> {
    let velocities: Vec<&Candidate> = candidates.iter().filter(|c| !c.what.force).collect();
    let forces: Vec<&Candidate> = candidates.iter().filter(|c| c.what.force).collect();
    let of = |stroke: Option<Stroke>| forces.iter().filter(move |c| c.what.stroke == stroke).count();
    // If each stroke has its own forces, a force without a stroke is a gas or friction force and is left out.
    let both = of(Some(Stroke::Rebound)) > 0 && of(Some(Stroke::Compression)) > 0;
    let forces: Vec<&Candidate> = forces.into_iter().filter(|c| !both || c.what.stroke.is_some()).collect();
    // The table has one velocity for all forces, or one velocity before each force. In the second case, the positions
    // determine the pairs.
    let before = |force: &Candidate| velocities.iter().rfind(|v| v.index < force.index).copied();
    let each = velocities.len() == forces.len() && {
        let mut used: Vec<Option<usize>> = forces.iter().map(|f| before(f).map(|v| v.index)).collect();
        used.dedup();
        used.len() == forces.len() && used.iter().all(Option::is_some)
    };
    let mut chosen: Vec<Chosen<'_>> = Vec::new();
    for force in forces {
        let stroke = force.what.stroke;
        let own: Vec<&Candidate> =
            velocities.iter().filter(|v| stroke.is_some() && v.what.stroke == stroke).copied().collect();
        let may: Vec<&Candidate> =
            velocities.iter().filter(|v| stroke.is_none() || v.what.stroke.is_none()).copied().collect();
        let by_place = before(force).filter(|v| each && (stroke.is_none() || v.what.stroke.is_none()));
        let velocity = match (&own[..], by_place) {
            ([], Some(velocity)) => velocity,
            ([], None) => one(&may, cells, force)?,
            _ => one(&own, cells, force)?,
        };
        chosen.push((velocity, force, stroke.or(velocity.what.stroke)));
    }
    for stroke in [None, Some(Stroke::Rebound), Some(Stroke::Compression)] {
        let of_it: Vec<&Candidate> = chosen.iter().filter(|c| c.2 == stroke).map(|c| c.1).collect();
        if of_it.len() < 2 {
            continue;
        }
        let plain: Vec<&Candidate> = of_it.iter().filter(|c| c.plain).copied().collect();
        let [only] = plain[..] else {
            let what = PeakColumn { force: true, stroke };
            let columns = listed(of_it.iter().map(|c| &cells[c.index]));
            return Err(format!("the columns {columns} may all be the {}; {}", said(what), asked(what, &of_it, cells)));
        };
        chosen.retain(|c| c.2 != stroke || c.1.index == only.index);
    }
    Ok(chosen)
}

/// Formulates the request to select one of several columns.
///
/// Columns without a stroke may belong to one stroke each, so the request names both strokes. A column that the user
/// names for both strokes replaces all others.
fn asked(what: PeakColumn, of: &[&Candidate], cells: &[String]) -> String {
    let given = |what: PeakColumn, column: &Candidate| format!("--column {what}={}", by_name(column.index, cells));
    match (what.stroke, of) {
        (None, [first, second, ..]) => {
            let of_stroke = |stroke| PeakColumn { stroke: Some(stroke), ..what };
            format!(
                "where each is of one stroke, say which by {} {}, the other way round if so it is; where one is of both, by {}",
                given(of_stroke(Stroke::Rebound), first),
                given(of_stroke(Stroke::Compression), second),
                given(what, first)
            )
        }
        (_, [first, ..]) => format!("say which by {} or --column {what}={}", given(what, first), first.index + 1),
        (_, []) => String::new(),
    }
}

/// Refers to a column by its heading, or by its number if the heading is empty or not unique.
fn by_name(index: usize, cells: &[String]) -> String {
    let name = cells.get(index).map_or("", |cell| cell.trim());
    let alike = cells.iter().filter(|cell| without_unit(cell) == without_unit(name)).count();
    if name.is_empty() || alike > 1 { (index + 1).to_string() } else { format!("\"{name}\"") }
}

/// Returns the velocity column that belongs to the force column `of`. It is the only velocity column, or the only one
/// whose heading contains nothing but the quantity and its stroke.
///
/// # Errors
/// A request to name the velocity column, if there is no such column or if several columns are possible.
fn one<'a>(velocities: &[&'a Candidate], cells: &[String], of: &Candidate) -> Result<&'a Candidate, String> {
    let plain: Vec<&Candidate> = velocities.iter().filter(|c| c.plain).copied().collect();
    let force = cells.get(of.index).map_or("", |c| c.trim());
    match (velocities, &plain[..]) {
        ([only], _) | (_, [only]) => Ok(only),
        ([], _) => {
            let what = PeakColumn { force: false, stroke: of.what.stroke };
            Err(format!("no velocity goes with the force '{force}'; name its column, such as --column {what}=1"))
        }
        ([first, ..], _) => {
            let columns = listed(velocities.iter().map(|c| &cells[c.index]));
            // A force column for both strokes has only one velocity column, so the request names a single column.
            let how = match of.what.stroke {
                Some(_) => asked(first.what, velocities, cells),
                None => asked(first.what, &velocities[..1], cells),
            };
            Err(format!("the columns {columns} may all be the velocity of '{force}'; {how}"))
        }
    }
}

/// Returns the columns with their units. A column without a unit is an error.
fn taken(chosen: &[Chosen<'_>], cells: &[String]) -> Result<Vec<PeakPair>, String> {
    let heading = |c: &Candidate| cells.get(c.index).map_or("", |c| c.trim()).to_owned();
    let all = || chosen.iter().flat_map(|(velocity, force, _)| [*velocity, *force]);
    let lacking =
        |force: bool| all().filter(|c| c.unit.is_none() && c.what.force == force).map(heading).collect::<Vec<_>>();
    let (velocities, forces) = (lacking(false), lacking(true));
    let advice = match (velocities.is_empty(), forces.is_empty()) {
        (true, true) => {
            let column = |c: &Candidate| c.unit.map(|unit| Taken { index: c.index, heading: heading(c), unit });
            return Ok(chosen
                .iter()
                .filter_map(|(velocity, force, stroke)| {
                    Some(PeakPair { velocity: column(velocity)?, force: column(force)?, stroke: *stroke })
                })
                .collect());
        }
        (false, true) => "--unit velocity=mm/s",
        (true, false) => "--unit force=N",
        (false, false) => "--unit velocity=mm/s --unit force=N",
    };
    let mut without: Vec<String> = velocities.into_iter().chain(forces).collect();
    without.dedup();
    let known = |channel: Channel| format!("{channel} in {}", channel.units_understood());
    Err(format!(
        "no unit is known of {}; give it, such as {advice} ({}; {})",
        listed(without.iter()),
        known(Channel::Velocity),
        known(Channel::Force)
    ))
}

fn listed<'a>(headings: impl Iterator<Item = &'a String>) -> String {
    /// Largest number of headings in a message. A damaged file may have thousands.
    const TOLD: usize = 20;
    headings.take(TOLD).map(|h| format!("'{}'", h.trim().escape_debug())).collect::<Vec<_>>().join(", ")
}

fn said(what: PeakColumn) -> String {
    let stroke = what.stroke.map_or_else(String::new, |stroke| format!(" in {}", stroke.name()));
    format!("{}{stroke}", what.channel())
}

/// Returns whether the words of a heading mean a force (`true`) or a velocity (`false`).
fn quantity(words: &[String]) -> Option<bool> {
    let says = |channel: Channel, end: &str| {
        words.iter().any(|word| headings(channel).contains(&word.as_str()) || word.ends_with(end))
    };
    match (says(Channel::Velocity, "geschwindigkeit"), says(Channel::Force, "kraft")) {
        (true, false) => Some(false),
        (false, true) => Some(true),
        _ => None,
    }
}

/// Returns whether the letter of a stroke is a separate word of a heading. In `T [C]`, the letter C is a unit, so the
/// result is false.
fn tells(words: &[String], cell: &str, letter: &str) -> bool {
    words.iter().any(|word| word == letter) && !(foreign_unit(cell, None) && quantity(words).is_none())
}

fn stroke(words: &[String], cell: &str, letters: Option<(&str, &str)>) -> Option<Stroke> {
    let says = |names: &[&str], beginnings: &[&str], letter: Option<&str>| {
        words.iter().any(|word| names.contains(&word.as_str()) || beginnings.iter().any(|b| word.starts_with(b)))
            || letter.is_some_and(|letter| tells(words, cell, letter))
    };
    let rebound = says(&REBOUND, &REBOUND_BEFORE, letters.map(|l| l.0));
    match (rebound, says(&COMPRESSION, &COMPRESSION_BEFORE, letters.map(|l| l.1))) {
        (true, false) => Some(Stroke::Rebound),
        (false, true) => Some(Stroke::Compression),
        _ => None,
    }
}

/// Returns the parts of a heading that may be a unit, beginning with the last part.
fn parts(cell: &str) -> impl Iterator<Item = &str> {
    cell.rsplit(['[', ']', '(', ')', '{', '}', ' ', ',', '_', ';', ':']).map(str::trim).filter(|part| !part.is_empty())
}

/// Returns the unit in a heading: that of a recognized channel, else a unit of speed or force.
fn unit(cell: &str) -> Option<Unit> {
    if let Heading::Channel(_, crate::columns::heading::HeadingUnit::Known(unit)) = heading(cell) {
        return Some(unit);
    }
    let of_peaks = |unit: &Unit| matches!(unit.dimension(), Dimension::Speed | Dimension::Force);
    // In a heading such as `velocity_mm_s`, an underscore replaces the slash of the unit.
    let joined = cell.trim().rsplit('_').take(2).collect::<Vec<_>>();
    let speed = match joined[..] {
        [time, length] => format!("{}/{time}", length.rsplit(' ').next().unwrap_or_default()).parse().ok(),
        _ => None,
    };
    speed.filter(of_peaks).or_else(|| parts(cell).filter_map(|part| part.parse().ok()).find(of_peaks))
}

/// Returns whether the brackets of a heading contain a text that is no stroke, quantity or unit of speed or force: `c
/// [Ns/m]`, `Oil [C]`.
fn foreign_unit(cell: &str, letters: Option<(&str, &str)>) -> bool {
    let inside = cell.split(['[', '(', '{']).nth(1).and_then(|rest| rest.split([']', ')', '}']).next());
    let Some(inside) = inside.map(str::trim).filter(|text| !text.is_empty()) else { return false };
    let says = words(inside);
    unit(inside).is_none()
        && stroke(&says, inside, None).is_none()
        && quantity(&says).is_none()
        && !letters.is_some_and(|(r, c)| says == [r] || says == [c])
}
