//! Tables of peak force over peak velocity (PVP, CVP), as rigs and suppliers hand them on: velocity and force, or velocity with
//! a column for rebound and one for compression. Text or a workbook.

use std::path::Path;

use super::channel::Channel;
use super::csv::cells_of_text;
use super::error::{Place, RecordError};
use super::heading::{Heading, HeadingUnit, heading, words};
use super::not_read;
use super::options::Positive;
use super::table::{HEADER_WITHIN, number};
use super::unit::{Dimension, Unit};
use super::xlsx::cells_of_workbook;

/// A point of the table: rebound velocity and tension force positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakPoint {
    /// Velocity, m/s.
    pub velocity_m_s: f64,
    /// Force, N.
    pub force_n: f64,
    /// Line or row of the file, from 1.
    pub line: usize,
}

/// A table of peaks.
#[derive(Debug, Clone, PartialEq)]
pub struct Peaks {
    /// Its points, in the order of their velocity.
    pub points: Vec<PeakPoint>,
    /// How rebound was told from compression.
    pub told: Told,
}

/// How a table tells rebound from compression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Told {
    /// Its headings name the strokes.
    Headings,
    /// The user says which direction its signs count positive.
    Given(Positive),
    /// Nothing says so; its signs were taken as rebound positive.
    Assumed,
}

impl Peaks {
    /// Velocity, m/s, and the force in rebound over that in compression there: where both sides have the highest velocity that both
    /// reach, along straight lines between the points.
    pub fn asymmetry(&self) -> Option<(f64, f64)> {
        let side = |sign: f64| -> Vec<(f64, f64)> {
            let mut points: Vec<(f64, f64)> = self
                .points
                .iter()
                .map(|p| (sign * p.velocity_m_s, sign * p.force_n))
                .filter(|(velocity, _)| *velocity > 0.0)
                .collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            points
        };
        let (rebound, compression) = (side(1.0), side(-1.0));
        let fastest = rebound.last()?.0.min(compression.last()?.0);
        let at = |side: &[(f64, f64)]| {
            let above = side.iter().position(|p| p.0 >= fastest)?;
            let (b, a) = (side[above], above.checked_sub(1).map_or((0.0, 0.0), |k| side[k]));
            Some(a.1 + (b.1 - a.1) * (fastest - a.0) / (b.0 - a.0))
        };
        let (rebound, compression) = (at(&rebound)?, at(&compression)?);
        (rebound > 0.0 && compression > 0.0).then(|| (fastest, rebound / compression))
    }
}

/// Words for the strokes in headings.
const REBOUND: [&str; 12] = [
    "rebound",
    "reb",
    "ext",
    "extension",
    "tension",
    "zug",
    "zugstufe",
    "detente",
    "estensione",
    "复原",
    "拉伸",
    "回弹",
];
const COMPRESSION: [&str; 9] =
    ["compression", "bump", "jounce", "druck", "druckstufe", "comp", "compressione", "compresion", "压缩"];

/// A column of forces, and the column of velocities that it goes with.
struct Column {
    force: (usize, Unit),
    velocity: (usize, Unit),
    /// The direction that both are of; none where the table is signed.
    stroke: Option<f64>,
}

/// Reads a table of peaks. `positive` says which direction a signed table counts positive; rebound where nothing is said.
///
/// # Errors
/// [`RecordError`] with file, line and what to do.
pub fn read_peaks(file: &Path, positive: Option<Positive>) -> Result<Peaks, RecordError> {
    let extension = file.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let workbook = ["xlsx", "xlsm"].contains(&extension.as_str());
    if !workbook && let Some((is, instead)) = not_read::known(file) {
        return Err(RecordError::NotRead { file: file.into(), is, instead });
    }
    let rows = if workbook { cells_of_workbook(file)? } else { cells_of_text(file)? };
    let at = Place::file(file);
    let wrong = |line: usize, cause: String| RecordError::PeakTable { at: at.clone(), line, cause };
    let below = |k: usize| rows.get(k + 1).map(|row| &*row.1);
    let found = rows.iter().enumerate().find_map(|(k, (_, cells))| Some((k, columns(cells, below(k))?)));
    // A record has a time beside what it measures; each of its samples would be taken for a peak.
    let timed = rows.iter().take(found.as_ref().map_or(HEADER_WITHIN, |(k, _)| k + 1)).find_map(|(line, cells)| {
        let is_time = |cell: &&String| matches!(heading(cell), Heading::Channel(Channel::Time, _));
        let is_other =
            |cell: &String| matches!(heading(cell), Heading::Channel(channel, _) if channel != Channel::Time);
        cells.iter().any(is_other).then(|| cells.iter().find(is_time)).flatten().map(|time| (*line, time.trim()))
    });
    if let Some((line, time)) = timed {
        let cause = format!(
            "the column '{time}' makes this a record over time, and no table of peaks; dashpot fit reads records. If every row is \
             a peak, take that column out"
        );
        return Err(wrong(line, cause));
    }
    let Some((header, columns)) = found else {
        let cause = "no header that names velocity and force with their units, such as velocity_mm_s,force_N or \
                     velocity [m/s],rebound [N],compression [N]";
        return Err(wrong(rows.first().map_or(1, |row| row.0), cause.into()));
    };
    let turn = if positive == Some(Positive::Compression) { -1.0 } else { 1.0 };
    let mut points = Vec::new();
    for (line, cells) in &rows[header + 1..] {
        let value = |(index, unit): (usize, Unit)| -> Result<Option<f64>, RecordError> {
            let text = cells.get(index).map_or("", |c| c.trim());
            let value = number(text, true).ok_or_else(|| wrong(*line, format!("{text:?} is no number")))?;
            Ok(Some(unit.to_si(value)).filter(|v| v.is_finite()))
        };
        // The row of units, and rows without a velocity, are no points.
        let is_units = cells
            .iter()
            .all(|c| c.trim().is_empty() || c.trim().trim_matches(['[', ']', '(', ')']).parse::<Unit>().is_ok());
        if is_units {
            continue;
        }
        for column in &columns {
            let (Some(velocity), Some(force)) = (value(column.velocity)?, value(column.force)?) else { continue };
            let (velocity_m_s, force_n) = match column.stroke {
                Some(sign) => (sign * velocity.abs(), sign * force.abs()),
                // Speeds without a sign: the force tells the stroke.
                None if velocity > 0.0 && force < 0.0 => (-turn * velocity, turn * force),
                None => (turn * velocity, turn * force),
            };
            points.push(PeakPoint { velocity_m_s, force_n, line: *line });
        }
    }
    points.retain(|p| p.velocity_m_s != 0.0);
    points.sort_by(|a, b| a.velocity_m_s.total_cmp(&b.velocity_m_s));
    for pair in points.windows(2) {
        let [a, b] = pair else { continue };
        if a.velocity_m_s == b.velocity_m_s {
            return Err(wrong(b.line, format!("line {} has the same velocity, {} m/s", a.line, b.velocity_m_s)));
        }
    }
    for (is_there, stroke) in [
        (points.iter().any(|p| p.velocity_m_s > 0.0), "rebound"),
        (points.iter().any(|p| p.velocity_m_s < 0.0), "compression"),
    ] {
        if !is_there {
            let line = rows[header].0;
            let cause = format!(
                "holds no point in {stroke}; write rebound and compression with opposite signs, or in a column each"
            );
            return Err(wrong(line, cause));
        }
    }
    let told = match positive {
        _ if columns.iter().all(|column| column.stroke.is_some()) => Told::Headings,
        Some(positive) => Told::Given(positive),
        None => Told::Assumed,
    };
    Ok(Peaks { points, told })
}

/// The columns of a header, with their units from it or from the row below.
fn columns(cells: &[String], below: Option<&[String]>) -> Option<Vec<Column>> {
    let unit = |index: usize, dimension: Dimension| {
        let of_heading = match heading(&cells[index]) {
            Heading::Channel(_, HeadingUnit::Known(unit)) => Some(unit),
            // A heading of a stroke alone, such as `Rebound [N]`.
            _ => bracketed(&cells[index]),
        };
        let row =
            below.and_then(|row| row.get(index)).and_then(|c| c.trim().trim_matches(['[', ']', '(', ')']).parse().ok());
        of_heading.or(row).filter(|u| u.dimension() == dimension).map(|unit| (index, unit))
    };
    let stroke = |index: usize| {
        let words = words(&cells[index]);
        let says = |names: &[&str]| words.iter().any(|w| names.contains(&w.as_str()));
        match (says(&REBOUND), says(&COMPRESSION)) {
            (true, false) => Some(1.0),
            (false, true) => Some(-1.0),
            _ => None,
        }
    };
    let of = |index: usize, channel: Channel| matches!(heading(&cells[index]), Heading::Channel(c, _) if c == channel);
    let all = 0..cells.len();
    // What is in m/s is a velocity, whatever it is called.
    let velocities: Vec<(usize, Unit)> = all.clone().filter_map(|index| unit(index, Dimension::Speed)).collect();
    let forces = all.filter(|&index| of(index, Channel::Force) || stroke(index).is_some());
    let columns: Vec<Column> = forces
        .filter_map(|index| {
            let force = unit(index, Dimension::Force)?;
            // The velocity of the same stroke, else the one before the force: a table may have one for each side.
            let own = stroke(index);
            let same = |v: &&(usize, Unit)| own.is_some() && stroke(v.0) == own;
            let may = |v: &&(usize, Unit)| own.is_none() || stroke(v.0).is_none();
            let before = |v: &&(usize, Unit)| v.0 < index;
            let velocity = velocities
                .iter()
                .rfind(|v| same(v) && before(v))
                .or_else(|| velocities.iter().find(same))
                .or_else(|| velocities.iter().rfind(|v| may(v) && before(v)))
                .or_else(|| velocities.iter().find(may))?;
            Some(Column { force, velocity: *velocity, stroke: own.or_else(|| stroke(velocity.0)) })
        })
        .collect();
    (!columns.is_empty()).then_some(columns)
}

/// The unit at the end of a heading, in brackets or after the last blank, comma or underscore.
fn bracketed(text: &str) -> Option<Unit> {
    let text = text.trim().trim_end_matches([']', ')']);
    text.rsplit(['[', '(', ' ', ',', '_']).next()?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Vec<[f64; 2]>, String> {
        let peaks = read(text, None)?;
        Ok(peaks.points.iter().map(|p| [p.velocity_m_s, p.force_n]).collect())
    }

    fn read(text: &str, positive: Option<Positive>) -> Result<Peaks, String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pvp.csv");
        std::fs::write(&file, text).unwrap();
        read_peaks(&file, positive).map_err(|e| e.to_string())
    }

    #[test]
    fn tables_of_every_manner_give_the_same_points() {
        let wanted = vec![[-0.5, -600.0], [-0.25, -400.0], [0.25, 700.0], [0.5, 1100.0]];
        for text in [
            "velocity_m_s,force_N\n-0.5,-600\n-0.25,-400\n0,0\n0.25,700\n0.5,1100\n",
            "Velocity [mm/s];Rebound [N];Compression [N]\n250;700;-400\n500;1100;-600\n",
            "Geschwindigkeit;Zugstufe;Druckstufe\nmm/s;kN;kN\n250;0,7;0,4\n500;1,1;0,6\n",
            "velocity_m_s,force_N\n0.25,700\n0.25,-400\n0.5,1100\n0.5,-600\n",
            "Abs Velocity (mm/s),Comp Force (N),Reb Force (N)\n250,400,700\n500,600,1100\n",
            // A velocity for each side, by its name or before its force.
            "compression velocity [mm/s],compression [N],rebound velocity [mm/s],rebound [N]\n250,400,500,1100\n500,600,250,700\n",
            "rebound velocity [mm/s],compression velocity [mm/s],rebound [N],compression [N]\n250,500,700,600\n500,250,1100,400\n",
            "v [m/s];Zug [N];v [m/s];Druck [N]\n0,25;700;0,5;600\n0,5;1100;0,25;400\n",
            "rebound velocity [mm/s],force [N],compression velocity [mm/s],force [N]\n250,700,250,400\n500,1100,500,600\n",
        ] {
            let found = of(text).unwrap();
            assert_eq!(found.len(), 4, "{text}: {found:?}");
            for (a, b) in found.iter().zip(&wanted) {
                assert!((a[0] - b[0]).abs() < 1e-12 && (a[1] - b[1]).abs() < 1e-9, "{text}: {found:?}");
            }
        }
    }

    #[test]
    fn a_signed_table_may_count_compression_positive() {
        let text = "velocity_m_s,force_N\n-0.5,-1500\n-0.25,-700\n0.25,300\n0.5,600\n";
        let assumed = read(text, None).unwrap();
        assert_eq!((assumed.told, assumed.asymmetry()), (Told::Assumed, Some((0.5, 600.0 / 1500.0))));
        let turned = read(text, Some(Positive::Compression)).unwrap();
        assert_eq!(turned.told, Told::Given(Positive::Compression));
        assert_eq!((turned.points[3].velocity_m_s, turned.points[3].force_n), (0.5, 1500.0));
        assert_eq!(turned.asymmetry(), Some((0.5, 2.5)));
        let named = read("velocity [m/s],rebound [N],compression [N]\n0.5,9,4\n", Some(Positive::Compression)).unwrap();
        assert_eq!((named.told, named.asymmetry()), (Told::Headings, Some((0.5, 2.25))));
    }

    #[test]
    fn a_workbook_of_old_is_told_as_one() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pvp.xls");
        std::fs::write(&file, b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 velocity").unwrap();
        let message = read_peaks(&file, None).unwrap_err().to_string();
        assert!(message.contains(".xls") && message.contains(".xlsx"), "{message}");
    }

    #[test]
    fn mistakes_are_told_with_file_and_line() {
        for (text, wanted) in [
            ("speed,force\n1,2\n", "line 1: no header that names velocity and force"),
            ("velocity_m_s,force_N\n0.1,x\n", "line 2: \"x\" is no number"),
            ("velocity_m_s,force_N\n0.1,5\n0.1,6\n-0.1,-5\n", "line 3: line 2 has the same velocity"),
            ("velocity_m_s,force_N\n0.1,5\n", "holds no point in compression"),
            ("", "is empty"),
            ("time [s],velocity [m/s],force [N]\n0,0.1,5\n", "dashpot fit reads records"),
            ("Zeit [s],Weg [mm],Kraft [N]\n0,0.1,5\n", "the column 'Zeit [s]'"),
            ("time (s),displacement (in),friction force (kip)\n0,0.1,5\n", "the column 'time (s)'"),
        ] {
            let message = of(text).unwrap_err();
            assert!(message.contains("pvp.csv") && message.contains(wanted), "{text:?}: {message}");
        }
    }
}
