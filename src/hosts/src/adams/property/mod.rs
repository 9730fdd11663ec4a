//! Damper property files of Adams Car: TeimOrbit (`.dpr`) and XML. Rebound velocity and tension are positive in both formats and in this
//! module.

mod teim_orbit;
mod units;
mod xml;

use dashpot_core::{Model, Params};
use dashpot_core::{list, number};
use dashpot_messages::format_number;

/// A force-velocity table in SI.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Velocities, m/s.
    pub velocities: Vec<f64>,
    /// Forces, N.
    pub forces: Vec<f64>,
}

impl Curve {
    /// Returns the points of the model's FV curve. A curve with slopes and knees gives its knees, and some points between and beyond the
    /// knees.
    pub fn from_model(params: &Params, model: &Model) -> Curve {
        let fv = model.elements().paths.fv_curve;
        let velocities = if params.number(number!("fv_form")) == 0.0 {
            params.list(list!("fv_velocity")).to_vec()
        } else {
            let knees = [number!("fv_rebound_v1"), number!("fv_rebound_v2"), number!("fv_compression_v1")];
            let [r1, r2, c1] = knees.map(|knee| params.number(knee));
            vec![
                -3.0 * c1.max(r2),
                -2.0 * c1,
                -c1,
                -0.5 * c1,
                0.0,
                0.5 * r1,
                r1,
                0.5 * (r1 + r2),
                r2,
                1.5 * r2,
                3.0 * r2,
            ]
        };
        let forces = velocities.iter().map(|v| fv.evaluate(*v).value).collect();
        Curve { velocities, forces }
    }
}

/// Contents of a property file, in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Properties {
    /// FV curve of the damper.
    pub curve: Curve,
    /// Whether the curve is linear between its points. A linear rate gives such a curve.
    pub linear: bool,
    /// Constant gas force, N, positive if it pushes the rod out.
    pub gas_force: f64,
    /// On reading: notes on contents of the file that this struct does not represent. On writing: omitted elements and origin of the file.
    pub notes: Vec<String>,
}

/// Format of a property file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// TeimOrbit, `.dpr`. This format cannot represent a gas force.
    TeimOrbit,
    /// XML, `.xml`.
    Xml,
}

/// Writes a property file in mm, s and N.
pub fn write(properties: &Properties, form: Form) -> String {
    match form {
        Form::TeimOrbit => teim_orbit::write(properties),
        Form::Xml => xml::write(properties),
    }
}

/// Reads a property file in either format, regardless of the file name.
///
/// # Errors
/// The file has another type, an unknown unit, an invalid table, or a number that is too large in SI. If one line of the file is the cause,
/// the message states it.
pub fn read(bytes: &[u8]) -> anyhow::Result<Properties> {
    // Adams Car also uses models of MTS Empirical Dynamics (.edd), so a user may pass such a file.
    if bytes.starts_with(b"EDM") {
        anyhow::bail!(
            "this is a binary model of MTS Empirical Dynamics; it holds no curve that could be read. Take the records it was made from"
        );
    }
    // Property files are ASCII or Latin-1. A byte that is not UTF-8 belongs to a comment or a name.
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}');
    let read = if text.trim_start().starts_with('<') { xml::read(text) } else { teim_orbit::read(text) }?;
    // A number that is finite in the units of the file may overflow in SI, or in mm/s when a property file is written.
    let numbers = read.curve.velocities.iter().chain(&read.curve.forces).chain([&read.gas_force]);
    if let Some(number) = numbers.into_iter().find(|n| !(n.abs() <= MOST)) {
        anyhow::bail!("a velocity or force of it becomes {number:e} in SI (m/s, N); look at its numbers and units");
    }
    Ok(read)
}

/// Returns the size of a unit of length in meters. `word` is the name of the unit in property files and models of Adams.
///
/// # Errors
/// The word is unknown.
pub fn length_in_metres(word: &str) -> anyhow::Result<f64> {
    units::length(word)
}

/// Formats a note as a comment.
///
/// The result is one line of ASCII, which every host reads, without characters that either format forbids. The note may cite another user's
/// file with any characters, so forbidden characters are replaced.
fn as_comment(note: &str) -> String {
    let ascii = |c: char| match c {
        '·' => '*',
        c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => ' ',
        c if c.is_ascii() => c,
        _ => '?',
    };
    note.chars().map(ascii).collect()
}

/// Largest accepted velocity, m/s, or force, N. Without the limit, a number could overflow in mm/s. Real dampers, and points that
/// extrapolate their curves, stay far below it.
const MOST: f64 = 1e12;

/// Reads one row of two numbers. An error message states the line number `line` and the name `what` of the table.
fn row(text: &str, line: usize, what: &str) -> anyhow::Result<[f64; 2]> {
    let number = |word: &str| word.replace(['D', 'd'], "e").parse::<f64>().ok().filter(|n| n.is_finite());
    let words = text.split([' ', '\t', ',']).filter(|w| !w.is_empty());
    let numbers: Option<Vec<f64>> = words.map(number).collect();
    match numbers.as_deref() {
        Some(&[x, y]) => Ok([x, y]),
        _ => anyhow::bail!("line {line}: a row of {what} is two finite numbers, not \"{text}\""),
    }
}

/// A row of a table with its line number.
type Row = ([f64; 2], usize);

/// Makes a curve from rows. Their abscissae must increase throughout or decrease throughout.
///
/// If `rises` is set, the ordinates must not decrease. This applies to the curve of a damper, because a model cannot represent a decreasing
/// curve.
fn curve(mut rows: Vec<Row>, rises: bool) -> anyhow::Result<Curve> {
    let falls = rows.len() > 1 && rows[0].0[0] > rows[rows.len() - 1].0[0];
    if falls {
        rows.reverse();
    }
    let mut curve = Curve::default();
    for (i, ([v, f], own)) in rows.iter().enumerate() {
        // Line number for error messages. An error concerns two neighboring rows of the curve, and the message states the row that comes
        // later in the file.
        let line = if falls && i > 0 { rows[i - 1].1 } else { *own };
        if let Some(before) = curve.velocities.last().filter(|before| *before >= v) {
            let [v, before] = [*v, *before].map(format_number);
            anyhow::bail!(
                "line {line}: {v} and {before} are out of order; the first column, velocities in [CURVE], must increase, or decrease, from row to row"
            );
        }
        if let Some(before) = curve.forces.last().filter(|before| rises && *before > f) {
            let [f, before] = [*f, *before].map(format_number);
            anyhow::bail!(
                "line {line}: force {f} lies below {before}, that of the next lower velocity; the curve of a damper must not fall. Rebound and tension \
                 are positive in these files: look at the signs, or at the two numbers"
            );
        }
        curve.velocities.push(*v);
        curve.forces.push(*f);
    }
    Ok(curve)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn example() -> Properties {
        Properties {
            curve: Curve {
                velocities: vec![-0.254, -0.1, 0.0, 0.0333, 1.0 / 3.0],
                forces: vec![-809.5, -300.1, 0.0, 127.0, 1423.4],
            },
            linear: false,
            gas_force: 0.0,
            notes: Vec::new(),
        }
    }

    #[test]
    fn a_number_that_no_unit_can_hold_is_refused() {
        let text = "[UNITS]\nLENGTH='mm'\nFORCE='KN'\nTIME='second'\n[CURVE]\n0 0\n1 1e307\n";
        let error = read(text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains("becomes inf in SI"), "{error}");
        // A velocity of 1e307 mm/s is finite in SI, but exceeds the limit, which prevents overflow when a property file is written in mm.
        assert!(read(text.replace("1 1e307", "1e307 1").as_bytes()).is_err());
        assert!(read(text.replace("1e307", "1e5").as_bytes()).is_ok());
    }

    #[test]
    fn a_binary_model_is_told_from_a_property_file() {
        let error = read(b"EDMEDMEDM a heading\0\x01\xff").unwrap_err().to_string();
        assert!(error.contains("Empirical Dynamics"), "{error}");
    }

    #[test]
    fn what_is_written_reads_back() {
        for (form, gas_force) in [(Form::TeimOrbit, 0.0), (Form::Xml, 0.0), (Form::Xml, 141.5)] {
            let notes =
                vec!["from a model, with -- and $ and ! in its <name>".to_owned(), "left out: friction".to_owned()];
            let out = Properties { gas_force, notes, ..example() };
            let back = read(write(&out, form).as_bytes()).unwrap();
            for (a, b) in out.curve.velocities.iter().zip(&back.curve.velocities) {
                assert!((a - b).abs() <= 1e-15 * a.abs(), "{a} {b}");
            }
            assert_eq!((&back.curve.forces, back.gas_force, back.linear), (&out.curve.forces, gas_force, false));
            assert_eq!(back.notes, Vec::<String>::new(), "{form:?}: our own file says nothing that we do not read");
        }
    }

    #[test]
    fn notes_of_any_kind_leave_the_file_readable() {
        let notes =
            ["c·h/m ä", "a\0b", "c ---> d -", "{rows}{gas_force}", "e\n[CURVE]\n1 2", "\u{ffff}"].map(str::to_owned);
        let noted = Properties { notes: notes.to_vec(), ..example() };
        for form in [Form::TeimOrbit, Form::Xml] {
            let text = write(&noted, form);
            assert!(text.is_ascii() && text.contains("c*h/m ?"), "{text}");
            let back = read(text.as_bytes()).unwrap();
            assert_eq!(back.curve.forces, read(write(&example(), form).as_bytes()).unwrap().curve.forces, "{form:?}");
        }
    }
}
