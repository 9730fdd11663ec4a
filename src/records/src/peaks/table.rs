//! Tables of peak force over peak velocity from rigs and suppliers, called PVP or CVP in their software.
//!
//! A table has columns for velocity and force, or for velocity, rebound and compression. The file is a text or a
//! workbook.

use std::path::Path;

use super::clicks::{TableRows, clicks, only};
use super::columns::{self, PeakOptions, PeakPair, Stroke, Taken};
use crate::columns::cell::number;
use crate::columns::heading::{Heading, heading};
use crate::columns::table::{HEADER_WITHIN, is_units_row};
use crate::error::{Place, RecordError, RecordFileError};
use crate::file_extensions::extension;
use crate::formats::csv::cells_of_text;
use crate::formats::unsupported;
use crate::formats::xlsx::cells_of_workbook;
use crate::options::Positive;
use crate::quantities::channel::Channel;
use crate::quantities::unit::Unit;
use crate::source::Source;
use crate::tuning::plausibility::{HIGHEST_SPEED, LARGEST_FORCE};
use dashpot_messages::format_number;

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
    /// Points of the table, sorted by velocity.
    pub points: Vec<PeakPoint>,
    /// Source of the distinction between rebound and compression.
    pub source: StrokeSource,
    /// The columns that were read.
    pub pairs: Vec<PeakPair>,
}

/// Source of the distinction between rebound and compression in a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StrokeSource {
    /// The headings name the strokes.
    Headings,
    /// The user states the positive direction of the signs.
    Stated(Positive),
    /// The positive direction is not stated. Rebound is assumed.
    Assumed,
}

impl Peaks {
    /// Returns a speed, m/s, and the ratio of the force in rebound to that in compression at this speed.
    ///
    /// The speed is the highest that both strokes reach. Forces between the points are interpolated linearly. Returns
    /// `None` if a stroke has no points, or no positive damping force at this speed.
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

/// Returns the clicks of the curves in a table of peaks, in ascending order. For a table without clicks, the list is
/// empty.
///
/// # Errors
/// [`RecordError`] if the table cannot be read.
pub fn peak_clicks(file: &Path) -> Result<Vec<f64>, RecordError> {
    Ok(clicks(&cells(file)?))
}

/// Returns whether a file that is not a record is a table of peaks.
pub(crate) fn is_one(file: &Path) -> bool {
    /// Largest number of rows of a table of peaks. A record has more rows.
    const MOST: usize = 200;
    let Ok(rows) = cells(file) else { return false };
    let has_motion =
        |cell: &String| matches!(heading(cell), Heading::Channel(Channel::Displacement | Channel::Time, _));
    if rows.len() > MOST || rows.iter().take(HEADER_WITHIN).any(|(_, cells)| cells.iter().any(has_motion)) {
        return false;
    }
    // Missing units are reported when the table is read, so this check assumes m/s and N.
    let units = [(Channel::Velocity, Unit::MetrePerSecond), (Channel::Force, Unit::Newton)].into();
    let options = PeakOptions { units, ..PeakOptions::default() };
    let first = clicks(&rows).first().copied();
    columns::find(&first.map_or(rows.clone(), |click| only(rows, click)), &options).is_ok()
}

/// Returns the row numbers and the cells of a table.
fn cells(file: &Path) -> Result<TableRows, RecordError> {
    let source = Source::read(file)?;
    if ["xlsx", "xlsm"].contains(&extension(file).as_str()) {
        return cells_of_workbook(&source);
    }
    match unsupported::known(&source.bytes) {
        Some((is, instead)) => Err(RecordFileError::NotRead { file: file.into(), is, instead }.into()),
        None => cells_of_text(&source),
    }
}

/// Reads a table of peaks.
///
/// # Errors
/// [`RecordError`] with file, line and remedy.
pub fn read_peaks(file: &Path, options: &PeakOptions) -> Result<Peaks, RecordError> {
    let table = Table { file, rows: cells(file)? }.select_curve(options.clicks)?;
    let found = columns::find(&table.rows, options);
    table.reject_record(found.as_ref().map_or(HEADER_WITHIN, |found| found.header.map_or(0, |k| k + 1)))?;
    let found = found.map_err(|(row, cause)| table.error(table.line(row), cause))?;
    let turn = if options.positive == Some(Positive::Compression) { -1.0 } else { 1.0 };
    let mut points = Vec::new();
    for pair in &found.pairs {
        let mut of_pair = table.read_points(pair, found.data)?;
        orient(&mut of_pair, pair.stroke, turn);
        points.append(&mut of_pair);
    }
    points.retain(|p| p.velocity_m_s != 0.0);
    points.sort_by(|a, b| a.velocity_m_s.total_cmp(&b.velocity_m_s));
    table.reject_equal_velocities(&points)?;
    table.require_both_strokes(&points, table.line(found.header.unwrap_or(0)))?;
    let source = match options.positive {
        _ if found.pairs.iter().all(|pair| pair.stroke.is_some()) => StrokeSource::Headings,
        Some(positive) => StrokeSource::Stated(positive),
        None => StrokeSource::Assumed,
    };
    Ok(Peaks { points, source, pairs: found.pairs })
}

/// Rows of a table of peaks and their file, which messages name.
struct Table<'a> {
    file: &'a Path,
    rows: TableRows,
}

impl Table<'_> {
    fn error(&self, line: usize, cause: String) -> RecordError {
        RecordFileError::PeakTable { at: Place::file(self.file), line, cause }.into()
    }

    /// Returns the line of a row in the file.
    fn line(&self, row: usize) -> usize {
        self.rows.get(row).map_or(1, |row| row.0)
    }

    /// Retains the curve of the clicks that the user selects. A table of one curve needs no selection.
    fn select_curve(self, wanted: Option<f64>) -> Result<Self, RecordError> {
        let clicks = clicks(&self.rows);
        let known = || clicks.iter().copied().map(format_number).collect::<Vec<_>>().join(", ");
        let cause = match (wanted, &clicks[..]) {
            (Some(wanted), known) if known.contains(&wanted) => {
                return Ok(Table { rows: only(self.rows, wanted), ..self });
            }
            (None, []) => return Ok(self),
            (None, [only_one]) => return Ok(Table { rows: only(self.rows, *only_one), ..self }),
            (Some(_), []) => "it has no column that names clicks".into(),
            (Some(wanted), _) => {
                format!("it has no curve of {} clicks; there are those of {}", format_number(wanted), known())
            }
            (None, [first, ..]) => format!(
                "it has a curve for each of {} clicks; --clicks {} takes one of them, --clicks all makes a model of each",
                known(),
                format_number(*first)
            ),
        };
        Err(self.error(1, cause))
    }

    /// Returns an error if one of the first rows is the heading of a record. A record has a time in addition to its
    /// channels, and each of its samples would count as a peak.
    fn reject_record(&self, rows: usize) -> Result<(), RecordError> {
        let timed = self.rows.iter().take(rows).find_map(|(line, cells)| {
            let is_time = |cell: &&String| matches!(heading(cell), Heading::Channel(Channel::Time, _));
            let is_other =
                |cell: &String| matches!(heading(cell), Heading::Channel(channel, _) if channel != Channel::Time);
            cells.iter().any(is_other).then(|| cells.iter().find(is_time)).flatten().map(|time| (*line, time.trim()))
        });
        let Some((line, time)) = timed else { return Ok(()) };
        let cause = format!(
            "the column '{time}' makes this a record over time, and no table of peaks; dashpot fit reads records. If every row is \
             a peak, take that column out"
        );
        Err(self.error(line, cause))
    }

    /// Reads the points of two columns with the signs of the file. `data` is the index of the first row of the data.
    fn read_points(&self, pair: &PeakPair, data: usize) -> Result<Vec<PeakPoint>, RecordError> {
        let mut points = Vec::new();
        for (line, cells) in &self.rows[data..] {
            let value = |column: &Taken| -> Result<f64, RecordError> {
                let text = cells.get(column.index).map_or("", |c| c.trim());
                let value = number(text, true).ok_or_else(|| self.error(*line, format!("{text:?} is no number")))?;
                Ok(column.unit.to_si(value))
            };
            // A row of units below a repeated heading is not a point, and neither is a row without a velocity or a
            // force.
            if is_units_row(cells) {
                continue;
            }
            let (velocity, force) = (value(&pair.velocity)?, value(&pair.force)?);
            for (number, largest, unit) in [(velocity, HIGHEST_SPEED, "m/s"), (force, LARGEST_FORCE, "N")] {
                if number.is_finite() && number.abs() > largest {
                    let number = format_number(number);
                    let cause = format!(
                        "{number} {unit} is beyond any damper, {largest} {unit}; check the column and its unit (--unit)"
                    );
                    return Err(self.error(*line, cause));
                }
            }
            if velocity.is_finite() && force.is_finite() {
                points.push(PeakPoint { velocity_m_s: velocity, force_n: force, line: *line });
            }
        }
        Ok(points)
    }

    /// Returns an error if two of the sorted points have the same velocity.
    fn reject_equal_velocities(&self, points: &[PeakPoint]) -> Result<(), RecordError> {
        for pair in points.windows(2) {
            let [a, b] = pair else { continue };
            if a.velocity_m_s == b.velocity_m_s {
                let (first, second) = (a.line.min(b.line), a.line.max(b.line));
                let cause = format!("line {first} has the same velocity, {} m/s", format_number(b.velocity_m_s));
                return Err(self.error(second, cause));
            }
        }
        Ok(())
    }

    /// Returns an error at the line of the heading if a stroke has no point.
    fn require_both_strokes(&self, points: &[PeakPoint], heading_line: usize) -> Result<(), RecordError> {
        for (is_there, stroke) in [
            (points.iter().any(|p| p.velocity_m_s > 0.0), Stroke::Rebound),
            (points.iter().any(|p| p.velocity_m_s < 0.0), Stroke::Compression),
        ] {
            if !is_there {
                let cause = format!(
                    "holds no point in {stroke}; write rebound and compression with opposite signs, or in a column each, which --column \
                     {stroke}_force names",
                    stroke = stroke.name()
                );
                return Err(self.error(heading_line, cause));
            }
        }
        Ok(())
    }
}

/// Makes rebound and tension positive. `turn` is -1 if compression is positive in the file.
fn orient(points: &mut [PeakPoint], stroke: Option<Stroke>, turn: f64) {
    // The sign of the force at the highest velocity shows the sign convention of the column. A force with the other
    // sign acts in the direction of the motion, for example the gas force at low speeds.
    let strongest = points.iter().max_by(|a, b| a.velocity_m_s.abs().total_cmp(&b.velocity_m_s.abs()));
    let counts = strongest.map_or(1.0, |p| if p.force_n < 0.0 { -1.0 } else { 1.0 });
    for point in points {
        let (velocity, force) = (point.velocity_m_s, point.force_n);
        (point.velocity_m_s, point.force_n) = match stroke {
            Some(stroke) => (stroke.sign() * velocity.abs(), stroke.sign() * counts * force),
            // If velocities have no sign, the sign of the force determines the stroke.
            None if velocity > 0.0 && force < 0.0 => (-turn * velocity, turn * force),
            None => (turn * velocity, turn * force),
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_beyond_any_damper_are_rejected_with_line_and_bound() {
        for (rows, line, wanted) in [
            ("0.1,100\n-1e308,-200\n", 3, "-1e308 m/s is beyond any damper, 20 m/s"),
            ("1e308,100\n-0.1,-200\n", 2, "1e308 m/s is beyond"),
            ("0.1,1e308\n-0.1,-200\n", 2, "1e308 N is beyond any damper, 200000 N"),
            ("0.1,100\n-0.1,-1e308\n", 3, "-1e308 N is beyond"),
            ("524,100\n-524,-200\n", 2, "524 m/s is beyond"),
        ] {
            let message = of(&format!("velocity [m/s],force [N]\n{rows}")).unwrap_err();
            assert!(message.contains("pvp.csv") && message.contains(&format!("line {line}")), "{message}");
            assert!(message.contains(wanted) && message.len() < 300, "{message}");
        }
    }

    fn of(text: &str) -> Result<Vec<[f64; 2]>, String> {
        let peaks = read(text, None)?;
        Ok(peaks.points.iter().map(|p| [p.velocity_m_s, p.force_n]).collect())
    }

    fn read(text: &str, positive: Option<Positive>) -> Result<Peaks, String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pvp.csv");
        std::fs::write(&file, text).unwrap();
        let options = PeakOptions { positive, ..PeakOptions::default() };
        read_peaks(&file, &options).map_err(|e| e.to_string())
    }

    /// Reads a table with the user's columns and units.
    fn said(text: &str, columns: &[(&str, &str)], units: &[(&str, &str)]) -> Result<Peaks, String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pvp.csv");
        std::fs::write(&file, text).unwrap();
        let options = PeakOptions {
            columns: columns.iter().map(|(what, heading)| (what.parse().unwrap(), (*heading).to_owned())).collect(),
            units: units.iter().map(|(channel, unit)| (channel.parse().unwrap(), unit.parse().unwrap())).collect(),
            ..PeakOptions::default()
        };
        read_peaks(&file, &options).map_err(|e| e.to_string())
    }

    fn points(peaks: &Peaks) -> Vec<[f64; 2]> {
        let to = |value: f64| (value * 1e6).round() / 1e6;
        peaks.points.iter().map(|p| [to(p.velocity_m_s), to(p.force_n)]).collect()
    }

    #[test]
    fn tables_of_dynos_are_understood_by_their_words() {
        let wanted = vec![[-0.5, -600.0], [-0.25, -400.0], [0.25, 700.0], [0.5, 1100.0]];
        for text in [
            "V-C [m/s],C [N],V-R [m/s],R [N]\n0.25,400,0.25,700\n0.5,600,0.5,1100\n",
            "V-C,C,V-R,R\nmm/s,N,mm/s,N\n-250,-400,250,700\n-500,-600,500,1100\n",
            "Test,V-C,C,V-R,R\n,mm/s,N,mm/s,N\n1,250,400,250,-700\n2,500,600,500,-1100\n",
            "Comp Vel (mm/s),Comp Force (daN),Reb Vel (mm/s),Reb Force (daN)\n250,40,250,70\n500,60,500,110\n",
            "Velocity compression (mm/s),Force compression (N),Velocity rebound (mm/s),Force rebound (N)\n-250,-400,250,700\n-500,-600,500,1100\n",
            "Geschwindigkeit;Zugkraft;Druckkraft\nmm/s;N;N\n250;700;-400\n500;1100;-600\n",
            "Speed mm/s,Force N (rebound),Force N (compression)\n250,700,400\n500,1100,600\n",
            "速度(m/s),复原力(N),压缩力(N)\n0.25,700,400\n0.5,1100,600\n",
            "Velocity [m/s],F (R) [N],F (C) [N]\n0.25,700,400\n0.5,1100,600\n",
            // If both strokes have forces, a further force column does not belong to a stroke.
            "Velocity [m/s],Rebound [N],Compression [N],Gas Force [N],Hysteresis [N],Oil [C]\n0.25,700,400,9,9,30\n0.5,1100,600,9,9,31\n",
            "Nominal velocity [m/s],Velocity [m/s],Rebound [N],Compression [N]\n0.2,0.25,700,400\n0.4,0.5,1100,600\n",
        ] {
            let found = said(text, &[], &[]).unwrap();
            assert_eq!((points(&found), found.source), (wanted.clone(), StrokeSource::Headings), "{text}");
        }
        let signed = said("v [m/s],F [N],c [Ns/m]\n0.5,1100,9\n-0.5,-600,9\n", &[], &[]).unwrap();
        assert_eq!((points(&signed), signed.source), (vec![[-0.5, -600.0], [0.5, 1100.0]], StrokeSource::Assumed));
    }

    #[test]
    fn units_and_columns_that_a_table_lacks_are_given() {
        let wanted = vec![[-0.254, -444.822162], [0.254, 889.644323]];
        let pounds = [("velocity", "in/s"), ("force", "lbf")];
        let bare = "V-C,C,V-R,R\n10,100,10,200\n";
        let message = said(bare, &[], &[]).unwrap_err();
        assert!(
            message.contains("no unit is known of 'V-C', 'V-R', 'C', 'R'") && message.contains("--unit velocity="),
            "{message}"
        );
        assert_eq!(points(&said(bare, &[], &pounds).unwrap()), wanted);
        // A unit that the user states has precedence over the heading, as in records.
        assert_eq!(points(&said("v [m/s],R [N],C [N]\n10,200,100\n", &[], &pounds).unwrap()), wanted);
        let many = "Speed,CO,RO,CC,RC\n10,100,200,90,190\n";
        let by_number = [("velocity", "1"), ("rebound_force", "3"), ("compression_force", "2")];
        assert_eq!(points(&said(many, &by_number, &pounds).unwrap()), wanted);
        let by_name = [("velocity", "speed"), ("rebound_force", "ro"), ("compression_force", "CO")];
        assert_eq!(points(&said("Speed,Force,CO,RO\n10,7,100,200\n", &by_name, &pounds).unwrap()), wanted);
        // A line is the heading if its cells match the user's column names. The lines above have no influence.
        assert_eq!(points(&said("Damper 7,front,left\nSpeed,CO,RO\n10,100,200\n", &by_name, &pounds).unwrap()), wanted);
        assert_eq!(
            points(
                &said(
                    "10,100,200\n",
                    &[("velocity", "1"), ("compression_force", "2"), ("rebound_force", "3")],
                    &pounds
                )
                .unwrap()
            ),
            wanted
        );
        let message = said("v [m/s],Rebound min [N],Rebound max [N],Compression [N]\n1,2,3,4\n", &[], &[]).unwrap_err();
        assert!(
            message.contains("'Rebound min [N]', 'Rebound max [N]'") && message.contains("--column rebound_force="),
            "{message}"
        );
        let one = [("rebound_force", "Rebound max")];
        let found = said("v [m/s],Rebound min [N],Rebound max [N],Compression [N]\n1,2,3,4\n", &one, &[]).unwrap();
        assert_eq!(points(&found), [[-1.0, -4.0], [1.0, 3.0]]);
        let message = said("v [m/s],R [N],C [N]\n1,2,3\n", &[("rebound_force", "Rebund")], &[]).unwrap_err();
        assert!(message.contains("--column rebound_force=Rebund names no column"), "{message}");
    }

    #[test]
    fn what_may_be_of_either_stroke_is_asked_for_by_stroke() {
        // If the user follows the advice of the message, the table is readable.
        let follow = |text: &str, columns: &[(&str, &str)]| {
            let message = said(text, &[], &[]).unwrap_err();
            for (what, heading) in columns {
                let given = format!("--column {what}={heading}");
                assert!(message.contains(&given), "{given}: {message}");
            }
            let bare: Vec<(&str, &str)> = columns.iter().map(|(what, text)| (*what, text.trim_matches('"'))).collect();
            points(&said(text, &bare, &[]).unwrap())
        };
        let wanted = [[-0.5, -600.0], [0.5, 1100.0]];
        let forces = [("rebound_force", "\"Force A [N]\""), ("compression_force", "\"Force B [N]\"")];
        assert_eq!(follow("v [m/s],Force A [N],Force B [N]\n0.5,1100,600\n", &forces), wanted);
        // Columns with equal headings are distinguished by their numbers.
        let numbers = [("rebound_force", "2"), ("compression_force", "3")];
        assert_eq!(follow("v [m/s],Force peak [N],Force peak [N]\n0.5,1100,600\n", &numbers), wanted);
        let velocities = [("rebound_velocity", "\"Speed one [m/s]\""), ("compression_velocity", "\"Speed two [m/s]\"")];
        let text = "Speed one [m/s],Speed two [m/s],Rebound [N],Compression [N]\n0.5,0.5,1100,600\n";
        assert_eq!(follow(text, &velocities), wanted);
        // Stating one column for both strokes is also a solution.
        let both = said("v [m/s],Force A [N],Force B [N]\n0.5,1100,7\n-0.5,-600,8\n", &[("force", "Force A")], &[]);
        assert_eq!(points(&both.unwrap()), wanted);
        let message = said("Reb Vel [m/s],Reb Force [N],Comp Force [N]\n1,2,3\n", &[], &[]).unwrap_err();
        assert!(message.contains("--column compression_velocity=1"), "{message}");
    }

    #[test]
    fn a_force_against_its_stroke_keeps_its_sign() {
        // Gas pushes the rod out. At low rebound speed, the total force therefore has the sign of compression.
        for text in [
            "v [m/s],Rebound [N],Compression [N]\n0.01,-120,200\n0.5,1100,600\n",
            "v [m/s],Rebound [N],Compression [N]\n0.01,120,-200\n0.5,-1100,-600\n",
        ] {
            let found = said(text, &[], &[]).unwrap();
            assert_eq!(points(&found), [[-0.5, -600.0], [-0.01, -200.0], [0.01, -120.0], [0.5, 1100.0]], "{text}");
        }
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
            // Each stroke has its own velocity column, identified by its name or by its position to the left of the
            // force.
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
        assert_eq!((assumed.source, assumed.asymmetry()), (StrokeSource::Assumed, Some((0.5, 600.0 / 1500.0))));
        let turned = read(text, Some(Positive::Compression)).unwrap();
        assert_eq!(turned.source, StrokeSource::Stated(Positive::Compression));
        assert_eq!((turned.points[3].velocity_m_s, turned.points[3].force_n), (0.5, 1500.0));
        assert_eq!(turned.asymmetry(), Some((0.5, 2.5)));
        let named = read("velocity [m/s],rebound [N],compression [N]\n0.5,9,4\n", Some(Positive::Compression)).unwrap();
        assert_eq!((named.source, named.asymmetry()), (StrokeSource::Headings, Some((0.5, 2.25))));
    }

    #[test]
    fn a_workbook_of_old_is_told_as_one() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pvp.xls");
        std::fs::write(&file, b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 velocity").unwrap();
        let message = read_peaks(&file, &PeakOptions::default()).unwrap_err().to_string();
        assert!(message.contains(".xls") && message.contains(".xlsx"), "{message}");
    }

    #[test]
    fn mistakes_are_told_with_file_and_line() {
        for (text, wanted) in [
            ("speed,weight\n1,2\n", "line 1: no header that names velocity and force"),
            ("speed,force\n1,2\n", "line 1: no unit is known of 'speed', 'force'"),
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
