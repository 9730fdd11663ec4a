//! Converts records that have a crank angle instead of time. Dynos with a crank drive write them.
//!
//! If the lines above the table state the speed of the crank, the angle gives the time.

use super::cell::number;
use super::heading::words;

/// Headings of a column with the crank angle, as words without accents.
const ANGLES: [&str; 11] = [
    "crank angle",
    "crankangle",
    "crank",
    "crank position",
    "angle",
    "phase angle",
    "kurbelwinkel",
    "winkel",
    "drehwinkel",
    "angle vilebrequin",
    "曲柄转角",
];
/// Names of the entry above the table that states the speed of the crank.
const SPEEDS: [&str; 10] = [
    "speed",
    "crank speed",
    "motor speed",
    "rpm",
    "rotational speed",
    "drehzahl",
    "kurbeldrehzahl",
    "vitesse de rotation",
    "转速",
    "frequency",
];
/// Heading that replaces the heading of the angle column.
const TIME: &str = "Time [s]";

/// Conversion of crank angles to times.
#[derive(Debug, Clone)]
pub(crate) struct Crank {
    /// Index of the column with the crank angle.
    pub index: usize,
    /// Speed, revolutions per minute.
    pub rpm: f64,
    seconds: f64,
    /// Angle of a full turn, in the unit of the column.
    turn: f64,
    /// Number of full turns so far. `last` is the previous angle.
    turns: f64,
    last: Option<f64>,
}

/// Finds a column of angles in a heading without a time, and the speed in the lines above the table. Replaces the
/// heading of the column by a time heading. Returns `None` if there is no such column or no speed.
pub(crate) fn find<'a>(
    header: &mut [String],
    units: Option<&mut Vec<String>>,
    above: impl Iterator<Item = &'a str>,
) -> Option<Crank> {
    let below = |k: usize| units.as_ref().and_then(|units| units.get(k)).map(String::as_str);
    let (index, turn) = header.iter().enumerate().find_map(|(k, heading)| Some((k, turn_of(heading, below(k))?)))?;
    let rpm = above.filter_map(speed).last()?;
    header[index] = TIME.to_owned();
    if let Some(units) = units
        && let Some(unit) = units.get_mut(index)
    {
        *unit = "s".to_owned();
    }
    Some(Crank { index, rpm, seconds: 60.0 / (rpm * turn), turn, turns: 0.0, last: None })
}

/// Returns whether a heading names the angle of a crank.
pub(crate) fn is_angle(heading: &str) -> bool {
    turn_of(heading, None).is_some()
}

/// Returns the angle of a full turn in the unit of a column of crank angles. `below` is the cell of the row of units.
/// Returns `None` for a column of another quantity or in another unit.
fn turn_of(heading: &str, below: Option<&str>) -> Option<f64> {
    let (name, unit) = parted(heading);
    let unit = unit.or(below).unwrap_or_default().trim().trim_matches(|c| "[]()".contains(c)).to_lowercase();
    let turn = match unit.as_str() {
        "" | "deg" | "°" | "degree" | "degrees" | "grad" | "度" => 360.0,
        "rad" => std::f64::consts::TAU,
        "rev" | "turns" => 1.0,
        _ => return None,
    };
    ANGLES.contains(&name.as_str()).then_some(turn)
}

impl Crank {
    /// Returns the time, s, at which the crank has the angle `angle`, in the unit of its column. A decrease by more
    /// than half a turn begins the next turn.
    pub fn time(&mut self, angle: f64) -> f64 {
        if self.last.is_some_and(|last| angle < last - 0.5 * self.turn) {
            self.turns += 1.0;
        }
        if angle.is_finite() {
            self.last = Some(angle);
        }
        (angle + self.turns * self.turn) * self.seconds
    }
}

/// Returns the words of a heading, and the unit in its brackets.
fn parted(heading: &str) -> (String, Option<&str>) {
    match heading.trim().split_once(['[', '(']) {
        Some((name, unit)) => (words(name).join(" "), Some(unit.trim_end_matches([']', ')']))),
        None => (words(heading).join(" "), None),
    }
}

/// Reads the speed of a crank, revolutions per minute, from a line such as `Speed: 120.0 rpm` or `Drehzahl
/// [1/min];120`.
fn speed(line: &str) -> Option<f64> {
    let separator = line.chars().find(|c| "\t;:=".contains(*c)).unwrap_or(',');
    let mut cells = line.split(separator).map(|c| c.trim().trim_matches('"'));
    let (name, in_name) = parted(cells.next()?);
    let value = cells.find(|c| !c.is_empty())?;
    let (value, unit) = match value.split_once(' ') {
        Some((value, unit)) => (value, Some(unit.trim())),
        None => (value, cells.find(|c| !c.is_empty()).or(in_name)),
    };
    let value = number(value, true).filter(|v| v.is_finite() && *v > 0.0)?;
    let per_minute = match unit.map(|unit| unit.trim_matches(|c| "[]()".contains(c)).to_lowercase()).as_deref() {
        Some("rpm" | "1/min" | "u/min" | "min-1" | "r/min" | "tr/min" | "rev/min") => 1.0,
        Some("hz" | "1/s" | "rev/s") => 60.0,
        None if name == "rpm" => 1.0,
        _ => return None,
    };
    SPEEDS.contains(&name.as_str()).then_some(value * per_minute)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_of_cranks_are_read_and_others_are_not() {
        for (line, wanted) in [
            ("Speed: 120.0 rpm", Some(120.0)),
            ("Drehzahl [1/min];18,5", Some(18.5)),
            ("RPM,90", Some(90.0)),
            ("Frequency = 2 Hz", Some(120.0)),
            ("Speed: 0.5 m/s", None),
            ("Stroke: 50 mm", None),
            ("Speed: fast", None),
        ] {
            assert_eq!(speed(line), wanted, "{line}");
        }
    }

    #[test]
    fn angles_are_a_clock_over_many_turns() {
        let mut header = vec!["Crank angle [deg]".to_owned(), "Force [N]".to_owned()];
        let mut crank = find(&mut header, None, ["Speed: 60 rpm"].into_iter()).unwrap();
        assert_eq!(header[0], "Time [s]");
        let times: Vec<f64> = [0.0, 90.0, 359.0, 0.0, 180.0].iter().map(|angle| crank.time(*angle)).collect();
        assert!(
            times.iter().zip([0.0, 0.25, 359.0 / 360.0, 1.0, 1.5]).all(|(a, b)| (a - b).abs() < 1e-12),
            "{times:?}"
        );
        // Without a speed, an angle does not determine the time. A column of another quantity is not an angle.
        assert!(find(&mut vec!["Angle".to_owned()], None, std::iter::empty()).is_none());
        assert!(find(&mut vec!["Force [N]".to_owned()], None, ["RPM: 60"].into_iter()).is_none());
    }
}
