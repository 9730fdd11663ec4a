//! Finds the columns of velocities and forces in a table of peaks, their strokes, and which force belongs to which
//! velocity.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use crate::columns::heading::{Heading, heading, headings, nearest, without_unit, words};
use crate::columns::table::{HEADER_WITHIN, is_units_row, number};
use crate::quantities::channel::Channel;
use crate::quantities::unit::{Dimension, Unit};

/// A direction of motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stroke {
    /// Extension.
    Rebound,
    /// Compression.
    Compression,
}

impl Stroke {
    /// Sign of its velocities and forces inside.
    pub fn sign(self) -> f64 {
        match self {
            Stroke::Rebound => 1.0,
            Stroke::Compression => -1.0,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Stroke::Rebound => "rebound",
            Stroke::Compression => "compression",
        }
    }
}

/// What a column may be: a velocity or a force, of one stroke or of both.
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

/// What the user says about a table of peaks; the default leaves everything to the table.
#[derive(Debug, Clone, Default)]
pub struct PeakOptions {
    /// Which direction a table with signs counts positive; rebound if nothing is said.
    pub positive: Option<crate::options::Positive>,
    /// The click whose curve is read, of a table of an adjustable damper.
    pub clicks: Option<f64>,
    /// Units of velocity and force; they win over the headings.
    pub units: BTreeMap<Channel, Unit>,
    /// Headings, or numbers from 1, of columns.
    pub columns: BTreeMap<PeakColumn, String>,
}

impl PeakOptions {
    /// Takes a channel's unit from its text.
    ///
    /// # Errors
    /// A channel that no table of peaks has, and a unit that is none of it.
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
    /// Its place in the row, from 0.
    pub index: usize,
    /// Its heading.
    pub heading: String,
    /// Its unit.
    pub unit: Unit,
}

/// Forces, and the velocities that they go with.
#[derive(Debug, Clone, PartialEq)]
pub struct PeakPair {
    /// The velocities.
    pub velocity: Taken,
    /// The forces.
    pub force: Taken,
    /// The stroke that both are of; none where the signs tell it.
    pub stroke: Option<Stroke>,
}

/// The columns of a table, and where its rows begin.
pub(crate) struct Found {
    /// Place of the heading among the rows; none where the table begins without one.
    pub header: Option<usize>,
    /// Place of the first row below it.
    pub data: usize,
    pub pairs: Vec<PeakPair>,
}

/// Why no columns were found: the place of the row among the rows, and a sentence.
pub(crate) type Cause = (usize, String);

/// Words for the strokes in headings.
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
/// Beginnings of words that Chinese and German write together with the quantity: `Zugkraft`, `Druckgeschwindigkeit`, 压缩力. The
/// pressure that `Druck` means too is in no unit of force.
const REBOUND_BEFORE: [&str; 4] = ["zug", "复原", "拉伸", "回弹"];
const COMPRESSION_BEFORE: [&str; 2] = ["druck", "压缩"];
/// Letters for rebound and compression, which mean a stroke only where the other one of the pair stands in the same
/// heading line.
///
/// `V-C, C, V-R, R`. Alone, a `c` is as likely a damping coefficient and an `r` a correlation.
const LETTERS: [(&str, &str); 6] = [("r", "c"), ("r", "b"), ("r", "j"), ("e", "c"), ("z", "d"), ("d", "c")];

/// A column that may be taken.
#[derive(Debug, Clone)]
struct Candidate {
    index: usize,
    what: PeakColumn,
    /// None where neither heading, the row below nor the user says one.
    unit: Option<Unit>,
    /// Whether the heading names the quantity and its stroke and nothing else.
    plain: bool,
}

/// A velocity, the force that goes with it, and the stroke of both.
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
        // A line is the heading as well where the user names a column by what stands in it: RO and CO say nothing by themselves.
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

/// The columns where the user gives every one of them by its number: then the table needs no heading.
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

/// What the columns of a heading line may be.
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
        // `Extension` is a displacement to records; in a table of peaks, which has none, it is the stroke.
        let other = other && !matches!(read, Heading::Channel(Channel::Displacement, _));
        let stroke = stroke(words, cell, letters);
        let unit = unit(cell).or_else(|| below.and_then(|row| row.get(index)).and_then(|c| c.parse().ok()));
        let named = quantity(words);
        // What is in m/s is a velocity, whatever it is called; what is in N may be a hysteresis.
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

/// Whether a column is headed by what the user calls it, its unit aside.
fn is_headed(cell: &str, wanted: &str) -> bool {
    cell.trim().eq_ignore_ascii_case(wanted.trim()) || without_unit(cell) == without_unit(wanted)
}

/// The candidates with those that the user names in the place of others of their kind.
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
        // Of its kind no other is taken: one of a stroke takes the place of those of that stroke and of both, one of both that of all.
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

/// The forces with their velocities, and the stroke of both.
fn pairs<'a>(candidates: &'a [Candidate], cells: &[String]) -> Result<Vec<Chosen<'a>>, String> {
    let velocities: Vec<&Candidate> = candidates.iter().filter(|c| !c.what.force).collect();
    let forces: Vec<&Candidate> = candidates.iter().filter(|c| c.what.force).collect();
    let of = |stroke: Option<Stroke>| forces.iter().filter(move |c| c.what.stroke == stroke).count();
    // Where each stroke has its forces, a force beside them is that of the gas or of friction.
    let both = of(Some(Stroke::Rebound)) > 0 && of(Some(Stroke::Compression)) > 0;
    let forces: Vec<&Candidate> = forces.into_iter().filter(|c| !both || c.what.stroke.is_some()).collect();
    // One velocity for all, or one before each force: then the place tells which.
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

/// How to say which of several columns is meant. What is of no stroke may be one of each, and is asked for so; a column that is named for both
/// strokes would take the place of the other one.
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

/// A column by its heading; by its number where another one has the same, or where there is none.
fn by_name(index: usize, cells: &[String]) -> String {
    let name = cells.get(index).map_or("", |cell| cell.trim());
    let alike = cells.iter().filter(|cell| without_unit(cell) == without_unit(name)).count();
    if name.is_empty() || alike > 1 { (index + 1).to_string() } else { format!("\"{name}\"") }
}

/// The one velocity that a force goes with.
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
            // Of a force of both strokes there is one velocity alone.
            let how = match of.what.stroke {
                Some(_) => asked(first.what, velocities, cells),
                None => asked(first.what, &velocities[..1], cells),
            };
            Err(format!("the columns {columns} may all be the velocity of '{force}'; {how}"))
        }
    }
}

/// The columns with their units.
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
    /// Headings that are told; damaged files have thousands.
    const TOLD: usize = 20;
    headings.take(TOLD).map(|h| format!("'{}'", h.trim().escape_debug())).collect::<Vec<_>>().join(", ")
}

fn said(what: PeakColumn) -> String {
    let stroke = what.stroke.map_or_else(String::new, |stroke| format!(" in {}", stroke.name()));
    format!("{}{stroke}", what.channel())
}

/// Whether words speak of a force, true, or of a velocity, false.
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

/// Whether a letter stands in a heading as a word of its own, and not as a unit such as the `C` of `T [C]`.
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

/// The parts of a heading that may be a unit, the last first.
fn parts(cell: &str) -> impl Iterator<Item = &str> {
    cell.rsplit(['[', ']', '(', ')', '{', '}', ' ', ',', '_', ';', ':']).map(str::trim).filter(|part| !part.is_empty())
}

/// The unit of a speed or force in a heading.
fn unit(cell: &str) -> Option<Unit> {
    if let Heading::Channel(_, crate::columns::heading::HeadingUnit::Known(unit)) = heading(cell) {
        return Some(unit);
    }
    let of_peaks = |unit: &Unit| matches!(unit.dimension(), Dimension::Speed | Dimension::Force);
    // `velocity_mm_s`: the blank or stroke between the parts of the unit is written as an underscore.
    let joined = cell.trim().rsplit('_').take(2).collect::<Vec<_>>();
    let speed = match joined[..] {
        [time, length] => format!("{}/{time}", length.rsplit(' ').next().unwrap_or_default()).parse().ok(),
        _ => None,
    };
    speed.filter(of_peaks).or_else(|| parts(cell).filter_map(|part| part.parse().ok()).find(of_peaks))
}

/// Whether a heading bears in brackets what is neither a unit of speed or force nor a stroke: `c [Ns/m]`, `Oil [C]`.
fn foreign_unit(cell: &str, letters: Option<(&str, &str)>) -> bool {
    let inside = cell.split(['[', '(', '{']).nth(1).and_then(|rest| rest.split([']', ')', '}']).next());
    let Some(inside) = inside.map(str::trim).filter(|text| !text.is_empty()) else { return false };
    let says = words(inside);
    unit(inside).is_none()
        && stroke(&says, inside, None).is_none()
        && quantity(&says).is_none()
        && !letters.is_some_and(|(r, c)| says == [r] || says == [c])
}
