//! File of limits: a table from a spreadsheet with one limit in each row.

use dashpot_core::family::LARGEST_SETTING;
use dashpot_messages::format_number;
use dashpot_records::{Dimension, Unit, delimiter, split_unit};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Quantity on which a limit can be set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Force at a peak velocity, N. Rebound velocity and tension are positive, compression is negative.
    Force,
    /// Force that pushes the rod out, from slow tests, N.
    GasForce,
    /// Half the difference between the forces in rebound and compression of slow tests, N.
    Friction,
    /// Mean, over velocity, of the magnitude of the force difference between rising and falling velocity, N.
    Hysteresis,
    /// Time from a step of the setting up until the force has completed 63 % of its change, s.
    ResponseTimeUp,
    /// Time from a step of the setting down until the force has completed 63 % of its change, s.
    ResponseTimeDown,
    /// Time from 10 to 90 % of the force change after a step of the setting up, s.
    RiseTimeUp,
    /// Time from 10 to 90 % of the force change after a step of the setting down, s.
    RiseTimeDown,
}

impl Quantity {
    /// All quantities with their names in files.
    pub const NAMES: [(&'static str, Quantity); 8] = [
        ("force", Quantity::Force),
        ("gas_force", Quantity::GasForce),
        ("friction", Quantity::Friction),
        ("hysteresis", Quantity::Hysteresis),
        ("response_time_up", Quantity::ResponseTimeUp),
        ("response_time_down", Quantity::ResponseTimeDown),
        ("rise_time_up", Quantity::RiseTimeUp),
        ("rise_time_down", Quantity::RiseTimeDown),
    ];

    /// Returns whether the quantity is a response time, s, instead of a force, N.
    pub fn is_time(self) -> bool {
        matches!(
            self,
            Quantity::ResponseTimeUp | Quantity::ResponseTimeDown | Quantity::RiseTimeUp | Quantity::RiseTimeDown
        )
    }

    /// Returns the JSON keys of the low end, the high end and the value, each with its unit.
    pub fn keys(self) -> [&'static str; 3] {
        if self.is_time() { ["low_s", "high_s", "value_s"] } else { ["low_n", "high_n", "value_n"] }
    }

    /// Returns the unit in which reports show the quantity, and the factor from N or s to that unit.
    pub fn display(self) -> (&'static str, f64) {
        if self.is_time() { ("ms", 1e3) } else { ("N", 1.0) }
    }

    /// Checks that a number of the table in N or s is one that a damper can have. `name` is the column in messages.
    fn check(self, name: &str, value: f64) -> Result<(), String> {
        let number = format_number(value);
        match self.is_time() {
            true if !(value.abs() <= LONGEST) => Err(format!(
                "{name} = {number} s is no response of a valve; give {LONGEST} s or less, with its unit, such as ms, in a column unit"
            )),
            false if !(value.abs() <= LARGEST_FORCE) => Err(format!(
                "{name} = {number} N is beyond the force of any damper; give -1e6 to 1e6 N, and leave the cell empty where there is no limit"
            )),
            _ => Ok(()),
        }
    }

    /// Returns the quantity with this name. Ignores case, and accepts spaces or hyphens instead of underscores.
    ///
    /// # Errors
    /// Returns a message with the known names.
    pub fn named(said: &str) -> Result<Quantity, String> {
        let plain = said.to_ascii_lowercase().replace([' ', '-'], "_");
        Quantity::NAMES.iter().find(|(name, _)| *name == plain).map(|(_, quantity)| *quantity).ok_or_else(|| {
            format!(
                "{said:?} is nothing that can be limited; quantities are {}",
                Quantity::NAMES.map(|(name, _)| name).join(", ")
            )
        })
    }
}

/// Lowest and highest allowed value of a quantity at one point of operation.
#[derive(Debug, Clone, PartialEq)]
pub struct Limit {
    /// Name in the file, or the name of the quantity if the file gives none.
    pub name: String,
    /// Limited quantity.
    pub quantity: Quantity,
    /// Velocity at which the limit holds, m/s, negative in compression. A force needs it, and a response time must not have it.
    pub velocity_m_s: Option<f64>,
    /// Amplitude at which the limit holds, m. If it is absent, the tests with the largest amplitude that reach the velocity decide.
    pub amplitude_m: Option<f64>,
    /// Smallest allowed value: a force, N, or a time, s.
    pub low: Option<f64>,
    /// Largest allowed value: a force, N, or a time, s.
    pub high: Option<f64>,
    /// Setting at which the limit holds, if the damper has a setting.
    pub setting: Option<f64>,
    /// Unit of the setting in the file, such as mA, or empty. After `restate_settings_of_limits` it is the unit of the damper's setting.
    pub setting_unit: String,
    /// Line number in the file, from 1.
    pub line: u64,
}

/// Largest accepted limit on a response time, s. No valve is slower, so a larger number is rejected as milliseconds without their unit.
const LONGEST: f64 = 2.0;

/// Largest accepted magnitude of a limit on a force, N: the range of a load cell for heavy vehicles.
const LARGEST_FORCE: f64 = 1e6;

/// Largest accepted tolerance in percent. A wider one is no tolerance but a limit on one side, which `low` or `high` states.
const LARGEST_PERCENT: f64 = 1000.0;

/// Accepted magnitudes of a velocity, m/s. Below the lowest, drift of the sensor dominates. Rigs and curb strikes stay below the highest, as
/// the check of records assumes.
const SPEEDS: (f64, f64) = (1e-6, 20.0);

/// Accepted amplitudes, m. Below the smallest, sensors measure only noise. The largest is that of the check of records.
const AMPLITUDES: (f64, f64) = (1e-6, 0.5);

impl Limit {
    /// Checks that the limit is complete, that a value can meet it, and that a rig can measure the quantity at the given velocity.
    ///
    /// # Errors
    /// Returns a message with the reason.
    pub fn check(&self) -> Result<(), String> {
        let numbers = [
            ("velocity_m_s", self.velocity_m_s),
            ("amplitude_m", self.amplitude_m),
            ("low", self.low),
            ("high", self.high),
            ("setting", self.setting),
        ];
        if let Some((name, value)) = numbers.iter().find(|(_, value)| value.is_some_and(|v| !v.is_finite())) {
            return Err(format!("{name} is {}, which is no number", format_number(value.unwrap_or(f64::NAN))));
        }
        if self.quantity.is_time() && (self.velocity_m_s.is_some() || self.amplitude_m.is_some()) {
            return Err(
                "a time of the response is that of all tests with steps; leave velocity_m_s and amplitude_m out".into(),
            );
        }
        for (name, value) in [("low", self.low), ("high", self.high)] {
            if let Some(value) = value {
                self.quantity.check(name, value)?;
            }
        }
        if let Some(high) = self.high.filter(|high| *high <= 0.0 && self.quantity.is_time()) {
            return Err(format!("high = {} s; no valve is that quick, so give more than 0 s", format_number(high)));
        }
        if let Some(setting) = self.setting.filter(|setting| setting.abs() > LARGEST_SETTING) {
            let (value, largest) = (format_number(setting), format_number(LARGEST_SETTING));
            return Err(format!("setting = {value} is beyond that of any damper; give -{largest} to {largest}"));
        }
        match (self.low, self.high) {
            (None, None) => return Err("neither low nor high is given; write at least one".into()),
            (Some(low), Some(high)) if low > high && self.quantity.is_time() => {
                return Err(format!("low ({} s) is above high ({} s)", format_number(low), format_number(high)));
            }
            (Some(low), Some(high)) if low > high => {
                return Err(format!(
                    "low ({} N) is above high ({} N); forces are signed, so in compression the stronger force is the lower one",
                    format_number(low),
                    format_number(high)
                ));
            }
            _ => {}
        }
        if let Some(velocity) = self.velocity_m_s.filter(|v| *v != 0.0 && !(SPEEDS.0..=SPEEDS.1).contains(&v.abs())) {
            return Err(format!(
                "velocity_m_s = {} m/s is no speed of a damper; give a magnitude of {} to {} m/s",
                format_number(velocity),
                format_number(SPEEDS.0),
                SPEEDS.1
            ));
        }
        if self.quantity == Quantity::Force {
            match self.velocity_m_s {
                None => return Err("a force needs the speed at which it is limited, in velocity_m_s".into()),
                Some(0.0) => {
                    return Err("there is no peak force at velocity 0; limit friction or gas_force instead".into());
                }
                Some(v) if v < 0.0 && self.low.is_some_and(|low| low > 0.0) => {
                    return Err("the force is positive at a negative velocity; compression has a negative velocity and a negative force here".into());
                }
                Some(_) => {}
            }
        }
        match self.amplitude_m {
            Some(amplitude) if !(AMPLITUDES.0..=AMPLITUDES.1).contains(&amplitude) => Err(format!(
                "amplitude_m = {} m is no amplitude of a damper; give {} to {} m",
                format_number(amplitude),
                format_number(AMPLITUDES.0),
                AMPLITUDES.1
            )),
            _ => Ok(()),
        }
    }

    /// Returns whether a value meets the limit.
    pub fn holds(&self, value: f64) -> bool {
        self.low.is_none_or(|low| value >= low) && self.high.is_none_or(|high| value <= high)
    }
}

/// Reason why a file of limits is invalid.
#[derive(Debug, thiserror::Error)]
pub enum LimitError {
    /// The file cannot be read.
    #[error("{file}: cannot be read ({source})", file = .file.display())]
    Read {
        /// Path of the file.
        file: PathBuf,
        /// Reason from the operating system.
        #[source]
        source: std::io::Error,
    },
    /// A line is not a valid limit.
    #[error("{file}, line {line}: {cause}", file = .file.display())]
    Line {
        /// Path of the file.
        file: PathBuf,
        /// Line number, from 1.
        line: u64,
        /// Description of the error, and its remedy.
        cause: String,
    },
}

/// Known columns, as text for error messages. Either `low` and `high`, or `nominal` and `tolerance`, define the limit.
const COLUMNS: &str =
    "quantity, velocity_m_s, low, high, and if wanted nominal, tolerance, amplitude_m, setting, unit, name";

/// Reads a file of limits. The file may be in UTF-8 or in another encoding that a spreadsheet writes.
///
/// # Errors
/// [`LimitError`] with file, line and remedy.
pub fn read(file: &Path) -> Result<Vec<Limit>, LimitError> {
    let bytes = dashpot_records::read_small(file).map_err(|source| LimitError::Read { file: file.into(), source })?;
    parse(file, &dashpot_records::text(&bytes))
}

/// Reads the text of a file of limits. `file` is its name in messages.
///
/// # Errors
/// The errors of [`read`].
pub fn parse(file: &Path, text: &str) -> Result<Vec<Limit>, LimitError> {
    let wrong = |line: u64, cause: String| LimitError::Line { file: file.into(), line, cause };
    let text = text.trim_start_matches('\u{feff}');
    // A spreadsheet with decimal commas separates fields by semicolons or tabs. So a comma in a number is a decimal comma with these
    // separators.
    let is_heading = |l: &&str| !l.trim().is_empty() && !l.trim_start().starts_with('#');
    let delimiter = delimiter::detect(text.lines().find(is_heading).unwrap_or_default());
    let decimal_comma = delimiter != b',';
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let header: Vec<String> = reader
        .headers()
        .map_err(|e| wrong(1, e.to_string()))?
        .iter()
        .map(|h| h.to_ascii_lowercase().replace([' ', '-'], "_"))
        .collect();
    let known =
        ["quantity", "velocity_m_s", "low", "high", "nominal", "tolerance", "amplitude_m", "setting", "unit", "name"];
    let header_line =
        1 + text.lines().take_while(|l| l.trim().is_empty() || l.trim_start().starts_with('#')).count() as u64;
    if let Some(other) = header.iter().find(|h| !known.contains(&h.as_str())) {
        return Err(wrong(
            header_line,
            format!("there is no column {other:?} in a table of limits; the columns are {COLUMNS}"),
        ));
    }
    if let Some(twice) = header.iter().enumerate().find_map(|(k, h)| header[..k].contains(h).then_some(h)) {
        return Err(wrong(header_line, format!("the column {twice:?} stands there twice")));
    }
    if !header.iter().any(|h| h == "quantity") {
        return Err(wrong(header_line, format!("the column quantity is missing; the columns are {COLUMNS}")));
    }
    let mut limits = Vec::new();
    for row in reader.records() {
        let row = row.map_err(|e| wrong(e.position().map_or(1, csv::Position::line), e.to_string()))?;
        // In a spreadsheet file, an empty row consists of separators only.
        if row.iter().all(str::is_empty) {
            continue;
        }
        let line = row.position().map_or(1, |at| line_of(text, at));
        if row.len() != header.len() {
            return Err(wrong(line, format!("has {} fields where the header has {}", row.len(), header.len())));
        }
        let cell =
            |name: &str| header.iter().position(|h| h == name).and_then(|k| row.get(k)).filter(|cell| !cell.is_empty());
        limits.push(limit(&cell, decimal_comma, line).map_err(|cause| wrong(line, cause))?);
    }
    if limits.is_empty() {
        return Err(wrong(header_line, "has a header but no limit below it".into()));
    }
    Ok(limits)
}

/// Returns the line number of a row. The position from the CSV reader is the end of the previous row, so empty lines and comments after it
/// are added.
fn line_of(text: &str, at: &csv::Position) -> u64 {
    let ahead = usize::try_from(at.byte()).ok().and_then(|byte| text.get(byte..)).unwrap_or_default();
    at.line() + ahead.lines().take_while(|l| l.is_empty() || l.starts_with('#')).count() as u64
}

fn number(name: &str, text: &str, decimal_comma: bool) -> Result<f64, String> {
    match number_with_unit(name, text, decimal_comma) {
        Ok((value, unit)) if unit.is_empty() => Ok(value),
        _ => Err(no_number(name, text)),
    }
}

fn number_with_unit(name: &str, text: &str, decimal_comma: bool) -> Result<(f64, String), String> {
    let plain = if decimal_comma { text.replace(',', ".") } else { text.to_owned() };
    let is_unit = |unit: &str| unit.chars().next().is_none_or(char::is_alphabetic);
    let found = split_unit(&plain).filter(|(_, unit)| is_unit(unit));
    let (value, unit) = found.ok_or_else(|| no_number(name, text))?;
    Ok((value, unit.to_owned()))
}

fn no_number(name: &str, text: &str) -> String {
    format!("{name} is {text:?}, which is no number")
}

fn limit<'a>(cell: &impl Fn(&str) -> Option<&'a str>, decimal_comma: bool, line: u64) -> Result<Limit, String> {
    let said = cell("quantity").unwrap_or_default();
    let quantity = Quantity::named(said)?;
    let unit = match cell("unit") {
        None if quantity.is_time() => Unit::Second,
        Some(text) if quantity.is_time() => text
            .parse::<Unit>()
            .ok()
            .filter(|u| u.dimension() == Dimension::Time)
            .ok_or_else(|| format!("the unit {text:?} is no unit of time; s, ms are"))?,
        None => Unit::Newton,
        Some(text) => text
            .parse::<Unit>()
            .ok()
            .filter(|u| u.dimension() == Dimension::Force)
            .ok_or_else(|| format!("the unit {text:?} is no unit of force; N, kN, daN, lbf are"))?,
    };
    let value = |name: &str| cell(name).map(|text| number(name, text, decimal_comma)).transpose();
    let newton = |name: &str| Ok::<_, String>(value(name)?.map(|v| unit.to_si(v)));
    let (mut low, mut high) = (newton("low")?, newton("high")?);
    match (newton("nominal")?, cell("tolerance")) {
        (None, None) => {}
        (Some(nominal), Some(text)) if low.is_none() && high.is_none() => {
            quantity.check("nominal", nominal)?;
            let size = match text.strip_suffix('%') {
                Some(percent) => {
                    let percent = number("tolerance", percent.trim(), decimal_comma)?;
                    if percent.abs() > LARGEST_PERCENT {
                        let number = format_number(percent);
                        return Err(format!("tolerance = {number} %; give 0 to {LARGEST_PERCENT} %, or low and high"));
                    }
                    nominal.abs() * percent / 100.0
                }
                None => unit.to_si(number("tolerance", text, decimal_comma)?),
            };
            if size < 0.0 {
                return Err(format!("the tolerance {text:?} is negative"));
            }
            quantity.check("tolerance", size)?;
            quantity.check("nominal + tolerance", nominal + size)?;
            quantity.check("nominal - tolerance", nominal - size)?;
            (low, high) = (Some(nominal - size), Some(nominal + size));
        }
        (Some(_), Some(_)) => return Err("give either low and high or nominal and tolerance, not both".into()),
        _ => return Err("nominal and tolerance belong together (tolerance in the unit, or as 10 %)".into()),
    }
    let (setting, setting_unit) = match cell("setting") {
        Some(text) => {
            let (value, unit) = number_with_unit("setting", text, decimal_comma)?;
            (Some(value), unit)
        }
        None => (None, String::new()),
    };
    let limit = Limit {
        name: cell("name").map_or_else(|| said.to_owned(), str::to_owned),
        quantity,
        velocity_m_s: value("velocity_m_s")?,
        amplitude_m: value("amplitude_m")?,
        low,
        high,
        setting,
        setting_unit,
        line,
    };
    limit.check().map(|()| limit)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Vec<Limit>, String> {
        parse(Path::new("oem.csv"), text).map_err(|e| e.to_string())
    }

    #[test]
    fn windows_are_read_in_both_manners() {
        let limits = of("\u{feff}# front\nname,quantity,velocity_m_s,low,high,nominal,tolerance,unit\n\
                         R0.5,force,0.524,0.9,,,,kN\nC0.5,force,-0.524,,,-600,10 %,N\n,friction,,,,30,5,\n")
        .unwrap();
        assert_eq!((limits[0].low, limits[0].high, limits[0].line), (Some(900.0), None, 3));
        assert_eq!((limits[1].low, limits[1].high), (Some(-660.0), Some(-540.0)));
        assert_eq!((limits[2].name.as_str(), limits[2].low, limits[2].high), ("friction", Some(25.0), Some(35.0)));
        assert!(limits[1].holds(-660.0) && !limits[1].holds(-661.0));
        let times = of("quantity,setting,high,unit\nresponse_time_up,1.6,15,ms\nrise time down,,0.02,\n").unwrap();
        assert_eq!((times[0].high, times[0].setting, times[1].high), (Some(0.015), Some(1.6), Some(0.02)));
        let with_units = of("quantity,setting,high\nfriction,500mA,2\nfriction,5e2 mA,2\nfriction,0.5,2\n").unwrap();
        let seen: Vec<_> = with_units.iter().map(|l| (l.setting, l.setting_unit.as_str())).collect();
        assert_eq!(seen, [(Some(500.0), "mA"), (Some(500.0), "mA"), (Some(0.5), "")]);
        assert!(of("quantity,setting,high\nfriction,hard,2\n").unwrap_err().contains("hard"));
        let german = of("quantity;velocity_m_s;low;high\nforce;0,524;900,5;1000\n").unwrap();
        let tabs = of("# from a spreadsheet\nquantity\tvelocity_m_s\tlow\thigh\nforce\t0,524\t900,5\t1000\n").unwrap();
        assert_eq!(tabs, german.iter().map(|l| Limit { line: l.line + 1, ..l.clone() }).collect::<Vec<_>>());
        assert_eq!((german[0].velocity_m_s, german[0].low), (Some(0.524), Some(900.5)));
    }

    #[test]
    fn a_table_is_read_in_the_code_page_that_a_spreadsheet_saves_it_in() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), b"name,quantity,low\nD\xE4mpfer \x96 vorn,friction,1\n").unwrap();
        assert_eq!(read(file.path()).unwrap()[0].name, "Dämpfer – vorn");
    }

    /// Checks every column of numbers with numbers that no damper has. The message names the column, the value and a bound.
    #[test]
    fn numbers_beyond_their_bounds_are_rejected_with_column_and_bounds() {
        let with = |quantity: &str, column: &str, value: &str| match column {
            "low" | "high" => format!("quantity,velocity_m_s,{column}\n{quantity},{},{value}\n", velocity(quantity)),
            "nominal" => {
                format!("quantity,velocity_m_s,nominal,tolerance\n{quantity},{},{value},1e-3\n", velocity(quantity))
            }
            "tolerance" => {
                format!("quantity,velocity_m_s,nominal,tolerance\n{quantity},{},1e-3,{value}\n", velocity(quantity))
            }
            "velocity_m_s" => format!("quantity,velocity_m_s,low\n{quantity},{value},-1\n"),
            _ => format!("quantity,velocity_m_s,low,{column}\n{quantity},{},-1,{value}\n", velocity(quantity)),
        };
        let everywhere = ["1e308", "-1e308", "nan", "inf", "-inf", "1e400"];
        for (quantity, column, also_bad, good) in [
            ("force", "low", &[][..], "-1e6"),
            ("force", "high", &[], "1e6"),
            ("force", "nominal", &[], "0"),
            ("force", "tolerance", &["1e308 %", "1e9 %", "-1"], "1000 %"),
            ("force", "velocity_m_s", &["0", "1e-308", "-1e-308", "20.1"], "-20"),
            ("force", "amplitude_m", &["0", "1e-308", "-0.01", "0.6"], "0.5"),
            ("force", "setting", &["1e308mA", "1.1e9"], "1e-308"),
            ("friction", "high", &["1.1e6"], "1e-308"),
            ("rise_time_up", "low", &["2.1"], "0"),
            ("rise_time_up", "high", &["0", "-1", "2.1"], "2"),
            ("rise_time_up", "tolerance", &["2"], "0.5"),
        ] {
            for value in everywhere.iter().chain(also_bad) {
                let message = of(&with(quantity, column, value)).unwrap_err();
                let names_it = message.contains(column) || message.contains(column.trim_end_matches("_m_s"));
                assert!(message.starts_with("oem.csv, line 2: ") && names_it, "{column} {value}: {message}");
                assert!(message.len() < 300, "{column} {value}: {message}");
            }
            let accepted = of(&with(quantity, column, good));
            assert!(accepted.is_ok(), "{quantity} {column} {good}: {accepted:?}");
        }
    }

    /// Returns the velocity that a limit on this quantity needs, as a cell.
    fn velocity(quantity: &str) -> &'static str {
        if quantity == "force" { "0.5" } else { "" }
    }

    #[test]
    fn mistakes_are_told_with_file_and_line() {
        let cases = [
            ("quantity,low\nforce,1\n", "line 2: a force needs the speed"),
            (
                "quantity,velocity_m_s,low,high\nforce,-0.5,500,600\n",
                "line 2: the force is positive at a negative velocity",
            ),
            ("quantity,velocity_m_s,low,high\nforce,-0.5,-500,-600\n", "the stronger force is the lower one"),
            ("quantity,low,high\nfriction,,\n", "neither low nor high"),
            ("quantity,low,high\nfriction,a,1\n", "low is \"a\", which is no number"),
            ("quantity,low,high\nfriction,nan,1\n", "no number"),
            ("quantity,low,high\nnoise,0,1\n", "\"noise\" is nothing that can be limited"),
            ("quantity,low,high,unit\nfriction,0,1,mm\n", "no unit of force"),
            ("quantity,high,unit\nresponse_time_up,10,N\n", "no unit of time"),
            ("quantity,high\nresponse_time_up,20\n", "high = 20 s is no response of a valve; give 2 s or less"),
            ("quantity,high,velocity_m_s\nrise_time_up,0.01,0.3\n", "leave velocity_m_s"),
            ("quantity,low,high\nrise_time_up,0.02,0.01\n", "above high (0.01 s)"),
            ("quantity,lo\nfriction,0\n", "no column \"lo\""),
            ("quantity,low\nfriction,0,1\n", "line 2: has 3 fields where the header has 2"),
            ("quantity,low\n\n# ours\n , \n,\nfriction,x\n", "line 6: low is \"x\""),
            ("quantity,low\r\n\r\nfriction,x\r\n", "line 3: low is \"x\""),
            ("low\n1\n", "the column quantity is missing"),
            ("quantity,low,high\n", "no limit below it"),
            ("", "quantity is missing"),
            ("quantity,low,nominal,tolerance\nfriction,1,2,3\n", "not both"),
            ("quantity,low,nominal,tolerance\nfriction,,2,\n", "belong together"),
        ];
        for (text, wanted) in cases {
            let message = of(text).unwrap_err();
            assert!(message.starts_with("oem.csv, line ") && message.contains(wanted), "{text:?}: {message}");
        }
    }
}
