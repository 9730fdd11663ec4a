//! Tables of peak force over peak velocity (PVP, CVP), as rigs and suppliers hand them on: velocity and force, or velocity with
//! a column for rebound and one for compression. Text or a workbook.

use std::path::Path;

use super::channel::Channel;
use super::csv::cells_of_text;
use super::error::{Place, RecordError};
use super::heading::{Heading, HeadingUnit, heading, words};
use super::table::number;
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

/// Words for the strokes in headings.
const REBOUND: [&str; 10] =
    ["rebound", "extension", "tension", "zug", "zugstufe", "detente", "estensione", "estension", "复原", "拉伸"];
const COMPRESSION: [&str; 9] =
    ["compression", "bump", "jounce", "druck", "druckstufe", "comp", "compressione", "compresion", "压缩"];

/// Which columns a table has.
struct Columns {
    velocity: (usize, Unit),
    /// Columns of force with the direction that they are of; none where the table is signed.
    forces: Vec<(usize, Unit, Option<f64>)>,
}

/// Reads a table of peaks; the points come in the order of their velocity.
///
/// # Errors
/// [`RecordError`] with file, line and what to do.
pub fn read_peaks(file: &Path) -> Result<Vec<PeakPoint>, RecordError> {
    let extension = file.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    let rows = match extension.as_str() {
        "xlsx" | "xlsm" => cells_of_workbook(file)?,
        _ => cells_of_text(file)?,
    };
    let at = Place::file(file);
    let wrong = |line: usize, cause: String| RecordError::PeakTable { at: at.clone(), line, cause };
    let found =
        rows.iter().enumerate().find_map(|(k, (_, cells))| Some((k, columns(cells, rows.get(k + 1).map(|r| &*r.1))?)));
    let Some((header, columns)) = found else {
        let cause = "no header that names velocity and force with their units, such as velocity_mm_s,force_N or \
                     velocity [m/s],rebound [N],compression [N]";
        return Err(wrong(1, cause.into()));
    };
    let mut points = Vec::new();
    for (line, cells) in &rows[header + 1..] {
        let value = |index: usize, unit: Unit| -> Result<Option<f64>, RecordError> {
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
        let Some(velocity) = value(columns.velocity.0, columns.velocity.1)? else { continue };
        for (index, unit, stroke) in &columns.forces {
            let Some(force) = value(*index, *unit)? else { continue };
            let (velocity_m_s, force_n) = match stroke {
                Some(sign) => (sign * velocity.abs(), sign * force.abs()),
                // Speeds without a sign: the force tells the stroke.
                None if velocity > 0.0 && force < 0.0 => (-velocity, force),
                None => (velocity, force),
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
                "holds no point in {stroke}; write compression with a negative velocity, or in a column of its own"
            );
            return Err(wrong(line, cause));
        }
    }
    Ok(points)
}

/// The columns of a header, with their units from it or from the row below.
fn columns(cells: &[String], below: Option<&[String]>) -> Option<Columns> {
    let unit = |index: usize, dimension: Dimension| {
        let of_heading = match heading(&cells[index]) {
            Heading::Channel(_, HeadingUnit::Known(unit)) => Some(unit),
            // A heading of a stroke alone, such as `Rebound [N]`.
            _ => bracketed(&cells[index]),
        };
        let row =
            below.and_then(|row| row.get(index)).and_then(|c| c.trim().trim_matches(['[', ']', '(', ')']).parse().ok());
        of_heading.or(row).filter(|u| u.dimension() == dimension)
    };
    let stroke = |text: &str| {
        let words = words(text);
        let says = |names: &[&str]| words.iter().any(|w| names.contains(&w.as_str()));
        match (says(&REBOUND), says(&COMPRESSION)) {
            (true, false) => Some(1.0),
            (false, true) => Some(-1.0),
            _ => None,
        }
    };
    let mut velocity = None;
    let mut forces = Vec::new();
    for (index, cell) in cells.iter().enumerate() {
        let channel = match heading(cell) {
            Heading::Channel(channel, _) => Some(channel),
            _ => None,
        };
        if velocity.is_none() && (channel == Some(Channel::Velocity) || cell.to_lowercase().contains("velocity")) {
            velocity = unit(index, Dimension::Speed).map(|u| (index, u));
        } else if channel == Some(Channel::Force) || stroke(cell).is_some() {
            forces.extend(unit(index, Dimension::Force).map(|u| (index, u, stroke(cell))));
        }
    }
    (!forces.is_empty()).then_some(())?;
    Some(Columns { velocity: velocity?, forces })
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
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pvp.csv");
        std::fs::write(&file, text).unwrap();
        let points = read_peaks(&file).map_err(|e| e.to_string())?;
        Ok(points.iter().map(|p| [p.velocity_m_s, p.force_n]).collect())
    }

    #[test]
    fn tables_of_every_manner_give_the_same_points() {
        let wanted = vec![[-0.5, -600.0], [-0.25, -400.0], [0.25, 700.0], [0.5, 1100.0]];
        for text in [
            "velocity_m_s,force_N\n-0.5,-600\n-0.25,-400\n0,0\n0.25,700\n0.5,1100\n",
            "Velocity [mm/s];Rebound [N];Compression [N]\n250;700;-400\n500;1100;-600\n",
            "Geschwindigkeit;Zugstufe;Druckstufe\nmm/s;kN;kN\n250;0,7;0,4\n500;1,1;0,6\n",
            "velocity_m_s,force_N\n0.25,700\n0.25,-400\n0.5,1100\n0.5,-600\n",
        ] {
            let found = of(text).unwrap();
            assert_eq!(found.len(), 4, "{text}: {found:?}");
            for (a, b) in found.iter().zip(&wanted) {
                assert!((a[0] - b[0]).abs() < 1e-12 && (a[1] - b[1]).abs() < 1e-9, "{text}: {found:?}");
            }
        }
    }

    #[test]
    fn mistakes_are_told_with_file_and_line() {
        for (text, wanted) in [
            ("speed,force\n1,2\n", "line 1: no header that names velocity and force"),
            ("velocity_m_s,force_N\n0.1,x\n", "line 2: \"x\" is no number"),
            ("velocity_m_s,force_N\n0.1,5\n0.1,6\n-0.1,-5\n", "line 3: line 2 has the same velocity"),
            ("velocity_m_s,force_N\n0.1,5\n", "holds no point in compression"),
            ("", "is empty"),
        ] {
            let message = of(text).unwrap_err();
            assert!(message.contains("pvp.csv") && message.contains(wanted), "{text:?}: {message}");
        }
    }
}
