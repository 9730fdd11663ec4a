//! The channels of a rig record, their units, and how a column heading names both.

use std::fmt;
use std::str::FromStr;

use serde::Serialize;

/// A quantity that a rig record may hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Time.
    Time,
    /// Displacement of the damper.
    Displacement,
    /// Velocity of the damper.
    Velocity,
    /// Axial damper force.
    Force,
    /// Side force on the rod.
    SideForce,
    /// Damper temperature.
    Temperature,
}

impl Channel {
    /// All channels.
    pub const ALL: [Channel; 6] = [
        Channel::Time,
        Channel::Displacement,
        Channel::Velocity,
        Channel::Force,
        Channel::SideForce,
        Channel::Temperature,
    ];

    /// The channel's name as the command line and the messages write it.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Time => "time",
            Channel::Displacement => "displacement",
            Channel::Velocity => "velocity",
            Channel::Force => "force",
            Channel::SideForce => "side_force",
            Channel::Temperature => "temperature",
        }
    }

    /// How to do without the channel, for messages; nothing where a record needs it.
    pub(crate) fn leave_out_advice(self) -> String {
        match self {
            Channel::Time | Channel::Force => String::new(),
            _ => format!(", or leave the channel out with --ignore {self}"),
        }
    }

    /// What the channel measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Channel::Time => Dimension::Time,
            Channel::Displacement => Dimension::Length,
            Channel::Velocity => Dimension::Speed,
            Channel::Force | Channel::SideForce => Dimension::Force,
            Channel::Temperature => Dimension::Temperature,
        }
    }

    /// Headings understood for this channel, without the unit, in lower case with blanks between the words.
    fn headings(self) -> &'static [&'static str] {
        match self {
            Channel::Time => &["time", "t", "timestamp", "time stamp", "elapsed time", "test time", "running time"],
            Channel::Displacement => {
                &["displacement", "disp", "displ", "position", "pos", "stroke", "travel", "deflection", "x"]
            }
            Channel::Velocity => &["velocity", "vel", "speed", "v"],
            Channel::Force => &["force", "load", "f", "load cell", "loadcell"],
            Channel::SideForce => &[
                "side force",
                "lateral force",
                "side load",
                "lateral load",
                "force side",
                "f side",
                "fs",
                "transverse force",
            ],
            Channel::Temperature => &["temperature", "temp"],
        }
    }

    /// The units understood for this channel, for messages.
    pub fn units_understood(self) -> String {
        Unit::ALL.iter().filter(|u| u.dimension() == self.dimension()).map(|u| u.name()).collect::<Vec<_>>().join(", ")
    }
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Channel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let words = words(text).join(" ");
        Channel::ALL
            .into_iter()
            .find(|c| c.name().replace('_', " ") == words || c.headings().contains(&words.as_str()))
            .ok_or_else(|| {
                format!("'{text}' is no channel; the channels are {}", Channel::ALL.map(Channel::name).join(", "))
            })
    }
}

/// Kind of quantity that a unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Time.
    Time,
    /// Length.
    Length,
    /// Speed.
    Speed,
    /// Force.
    Force,
    /// Temperature.
    Temperature,
}

/// A unit that a record may be written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[allow(missing_docs)] // the names are the meaning
pub enum Unit {
    Second,
    Millisecond,
    Microsecond,
    Minute,
    Metre,
    Centimetre,
    Millimetre,
    Micrometre,
    Inch,
    MetrePerSecond,
    CentimetrePerSecond,
    MillimetrePerSecond,
    InchPerSecond,
    Newton,
    Decanewton,
    Kilonewton,
    PoundForce,
    KilogramForce,
    Celsius,
    Kelvin,
    Fahrenheit,
}

/// Metres in an inch (exact, international yard and pound agreement of 1959).
const INCH: f64 = 0.0254;
/// Newtons in a pound-force (exact: 0.45359237 kg times 9.80665 m/s²).
const POUND_FORCE: f64 = 4.448_221_615_260_5;
/// Newtons in a kilogram-force (standard gravity, exact).
const KILOGRAM_FORCE: f64 = 9.806_65;

impl Unit {
    /// All units.
    pub const ALL: [Unit; 21] = [
        Unit::Second,
        Unit::Millisecond,
        Unit::Microsecond,
        Unit::Minute,
        Unit::Metre,
        Unit::Centimetre,
        Unit::Millimetre,
        Unit::Micrometre,
        Unit::Inch,
        Unit::MetrePerSecond,
        Unit::CentimetrePerSecond,
        Unit::MillimetrePerSecond,
        Unit::InchPerSecond,
        Unit::Newton,
        Unit::Decanewton,
        Unit::Kilonewton,
        Unit::PoundForce,
        Unit::KilogramForce,
        Unit::Celsius,
        Unit::Kelvin,
        Unit::Fahrenheit,
    ];

    /// The unit's symbol.
    pub fn name(self) -> &'static str {
        self.spellings()[0]
    }

    /// Spellings understood; the first is the one written. Compared without regard to case, except where
    /// case carries meaning (none of these do within one dimension).
    fn spellings(self) -> &'static [&'static str] {
        match self {
            Unit::Second => &["s", "sec", "second", "seconds"],
            Unit::Millisecond => &["ms", "msec", "millisecond", "milliseconds"],
            Unit::Microsecond => &["us", "usec"],
            Unit::Minute => &["min", "minute", "minutes"],
            Unit::Metre => &["m", "meter", "metre", "meters", "metres"],
            Unit::Centimetre => &["cm"],
            Unit::Millimetre => &["mm"],
            Unit::Micrometre => &["um", "micron", "microns"],
            Unit::Inch => &["in", "inch", "inches", "\""],
            Unit::MetrePerSecond => &["m/s", "mps", "m/sec", "m s-1", "m.s-1", "m*s^-1", "ms-1", "ms^-1"],
            Unit::CentimetrePerSecond => &["cm/s", "cm/sec"],
            Unit::MillimetrePerSecond => &["mm/s", "mmps", "mm/sec", "mm s-1", "mm.s-1"],
            Unit::InchPerSecond => &["in/s", "ips", "in/sec", "inch/s"],
            Unit::Newton => &["N", "newton", "newtons"],
            Unit::Decanewton => &["daN"],
            Unit::Kilonewton => &["kN"],
            Unit::PoundForce => &["lbf", "lb", "lbs"],
            Unit::KilogramForce => &["kgf", "kp"],
            Unit::Celsius => &["degC", "C", "deg C", "celsius", "deg_C"],
            Unit::Kelvin => &["K", "kelvin", "degK"],
            Unit::Fahrenheit => &["degF", "F", "deg F", "fahrenheit", "deg_F"],
        }
    }

    /// What the unit measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Unit::Second | Unit::Millisecond | Unit::Microsecond | Unit::Minute => Dimension::Time,
            Unit::Metre | Unit::Centimetre | Unit::Millimetre | Unit::Micrometre | Unit::Inch => Dimension::Length,
            Unit::MetrePerSecond | Unit::CentimetrePerSecond | Unit::MillimetrePerSecond | Unit::InchPerSecond => {
                Dimension::Speed
            }
            Unit::Newton | Unit::Decanewton | Unit::Kilonewton | Unit::PoundForce | Unit::KilogramForce => {
                Dimension::Force
            }
            Unit::Celsius | Unit::Kelvin | Unit::Fahrenheit => Dimension::Temperature,
        }
    }

    /// A value in this unit as SI (temperature: °C). This is the only place where units change.
    pub fn to_si(self, value: f64) -> f64 {
        match self {
            Unit::Second | Unit::Metre | Unit::MetrePerSecond | Unit::Newton | Unit::Celsius => value,
            Unit::Minute => value * 60.0,
            // Division keeps decimal figures exact to the last digit: 12.5 mm is the double nearest 0.0125 m.
            Unit::Millisecond | Unit::Millimetre | Unit::MillimetrePerSecond => value / 1e3,
            Unit::Microsecond | Unit::Micrometre => value / 1e6,
            Unit::Centimetre | Unit::CentimetrePerSecond => value / 1e2,
            Unit::Inch | Unit::InchPerSecond => value * INCH,
            Unit::Decanewton => value * 10.0,
            Unit::Kilonewton => value * 1e3,
            Unit::PoundForce => value * POUND_FORCE,
            Unit::KilogramForce => value * KILOGRAM_FORCE,
            Unit::Kelvin => value - 273.15,
            Unit::Fahrenheit => (value - 32.0) / 1.8,
        }
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Unit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let plain = plain(text);
        let plain = plain.trim().trim_matches(|c| "[](){}".contains(c)).trim();
        Unit::ALL.into_iter().find(|u| u.spellings().iter().any(|s| s.eq_ignore_ascii_case(plain))).ok_or_else(|| {
            format!("'{text}' is no unit known here; known are {}", Unit::ALL.map(Unit::name).join(", "))
        })
    }
}

/// What a column heading says.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Heading {
    /// One of the channels; the unit if the heading carries one.
    Channel(Channel, HeadingUnit),
    /// The column that tells several tests in one file apart.
    Test,
    /// Sample time of a record without time vector (MAT scalars).
    SampleTime(HeadingUnit),
    /// Nothing known here.
    Unknown,
}

/// The unit part of a heading.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum HeadingUnit {
    /// No unit in the heading.
    Missing,
    /// A unit is written there but not understood, or does not measure this quantity.
    Unknown(String),
    /// The unit.
    Known(Unit),
}

/// Headings of a column that holds the name of the test.
const TEST_HEADINGS: [&str; 12] = [
    "test",
    "test id",
    "testid",
    "test no",
    "testno",
    "test number",
    "test name",
    "run",
    "run id",
    "run no",
    "run number",
    "test nr",
];

/// Words in a heading that say nothing about the quantity.
const FILLERS: [&str; 15] = [
    "channel", "ch", "signal", "measured", "meas", "actual", "act", "damper", "actuator", "axial", "rig", "rod",
    "piston", "oil", "body",
];

/// Reads a column heading: `displacement_mm`, `Velocity [m/s]`, `Force (N)`, `F_N`, `Load, kN`.
pub(crate) fn heading(text: &str) -> Heading {
    let text = plain(text);
    let text = text.trim();
    if let Some((name, unit)) = bracketed(text) {
        return classify(&words(name), HeadingUnitText::Bracketed(unit));
    }
    let words = words(text);
    // A unit written as trailing words: `velocity_m_s`, `force N`. The longest that is a unit wins.
    for count in (1..=2.min(words.len().saturating_sub(1))).rev() {
        let split = words.len() - count;
        let unit_text = words[split..].join("/");
        if let Ok(unit) = unit_text.parse::<Unit>() {
            let found = classify(&words[..split], HeadingUnitText::Trailing(unit));
            if found != Heading::Unknown {
                return found;
            }
        }
    }
    classify(&words, HeadingUnitText::None)
}

enum HeadingUnitText<'a> {
    None,
    Bracketed(&'a str),
    Trailing(Unit),
}

fn classify(words: &[String], unit: HeadingUnitText<'_>) -> Heading {
    let all = words.join(" ");
    if TEST_HEADINGS.contains(&all.as_str()) {
        return Heading::Test;
    }
    let telling: Vec<&str> = words.iter().map(String::as_str).filter(|w| !FILLERS.contains(w)).collect();
    let name = telling.join(" ");
    let unit = match unit {
        HeadingUnitText::None => None,
        HeadingUnitText::Bracketed("") => None,
        HeadingUnitText::Bracketed(text) => Some(text.parse::<Unit>().map_err(|_| text.to_string())),
        HeadingUnitText::Trailing(unit) => Some(Ok(unit)),
    };
    if ["dt", "ts", "sample time", "sampling time", "sample interval"].contains(&name.as_str()) {
        return match unit {
            None => Heading::SampleTime(HeadingUnit::Missing),
            Some(Ok(u)) if u.dimension() == Dimension::Time => Heading::SampleTime(HeadingUnit::Known(u)),
            Some(_) => Heading::Unknown,
        };
    }
    // `T [degC]`: the letter is time's, but the unit says what it is.
    match &unit {
        Some(Ok(u)) if name == "t" && u.dimension() == Dimension::Temperature => {
            return Heading::Channel(Channel::Temperature, HeadingUnit::Known(*u));
        }
        _ => {}
    }
    let Some(channel) = Channel::ALL.into_iter().find(|c| c.headings().contains(&name.as_str())) else {
        return Heading::Unknown;
    };
    match unit {
        None => Heading::Channel(channel, HeadingUnit::Missing),
        Some(Ok(u)) if u.dimension() == channel.dimension() => Heading::Channel(channel, HeadingUnit::Known(u)),
        // A single letter with a foreign unit is another quantity (`f [Hz]`, `v [V]`), not a damper channel.
        Some(_) if name.len() == 1 => Heading::Unknown,
        Some(Ok(u)) => Heading::Channel(channel, HeadingUnit::Unknown(u.name().to_string())),
        Some(Err(text)) => Heading::Channel(channel, HeadingUnit::Unknown(text)),
    }
}

/// Splits `name [unit]` or `name (unit)`.
fn bracketed(text: &str) -> Option<(&str, &str)> {
    for (open, close) in [('[', ']'), ('(', ')'), ('{', '}')] {
        if let Some(start) = text.rfind(open) {
            if let Some(length) = text[start..].find(close) {
                return Some((&text[..start], text[start + open.len_utf8()..start + length].trim()));
            }
        }
    }
    None
}

/// Letters outside ASCII that units and headings use, written plainly.
fn plain(text: &str) -> String {
    text.replace(['µ', 'μ'], "u").replace(['°', 'º'], "deg").replace('\u{feff}', "").replace('⁻', "-").replace('¹', "1")
}

/// Words of a heading in lower case.
fn words(text: &str) -> Vec<String> {
    text.split(|c: char| !c.is_alphanumeric()).filter(|w| !w.is_empty()).map(str::to_lowercase).collect()
}

/// Splits a command-line assignment such as `force=kN` or `force=Load Cell 1`.
///
/// # Errors
/// A sentence if there is no `=`, or the left side is no channel.
pub fn assignment(text: &str) -> Result<(Channel, &str), String> {
    let (channel, value) =
        text.split_once('=').ok_or_else(|| format!("'{text}' should read channel=value, for example force=kN"))?;
    let value = value.trim().trim_matches('"');
    if value.is_empty() {
        return Err(format!("'{text}' says nothing after the '='"));
    }
    Ok((channel.trim().parse()?, value))
}

/// What headings and units are understood, for error messages.
pub(crate) fn vocabulary() -> String {
    Channel::ALL.map(|c| format!("{} ({}) in {}", c.name(), c.headings().join(", "), c.units_understood())).join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (Channel, Unit) {
        match heading(text) {
            Heading::Channel(c, HeadingUnit::Known(u)) => (c, u),
            other => panic!("{text}: {other:?}"),
        }
    }

    #[test]
    fn headings_of_common_exports_are_understood() {
        assert_eq!(read("time_s"), (Channel::Time, Unit::Second));
        assert_eq!(read("displacement_mm"), (Channel::Displacement, Unit::Millimetre));
        assert_eq!(read("velocity_m_s"), (Channel::Velocity, Unit::MetrePerSecond));
        assert_eq!(read("Velocity [m/s]"), (Channel::Velocity, Unit::MetrePerSecond));
        assert_eq!(read("Force (N)"), (Channel::Force, Unit::Newton));
        assert_eq!(read("F_kN"), (Channel::Force, Unit::Kilonewton));
        assert_eq!(read("Damper Force, daN"), (Channel::Force, Unit::Decanewton));
        assert_eq!(read("Piston velocity in/s"), (Channel::Velocity, Unit::InchPerSecond));
        assert_eq!(read("Lateral Force [lbf]"), (Channel::SideForce, Unit::PoundForce));
        assert_eq!(read("T [°C]"), (Channel::Temperature, Unit::Celsius));
        assert_eq!(read("t [ms]"), (Channel::Time, Unit::Millisecond));
        assert_eq!(read("x (µm)"), (Channel::Displacement, Unit::Micrometre));
        assert_eq!(read("speed_mm_s"), (Channel::Velocity, Unit::MillimetrePerSecond));
    }

    #[test]
    fn other_quantities_are_left_alone() {
        for text in
            ["f [Hz]", "v [V]", "Force setpoint [N]", "displacement command mm", "Cycle", "acceleration", "s", ""]
        {
            assert_eq!(heading(text), Heading::Unknown, "{text}");
        }
        assert_eq!(heading("Test No"), Heading::Test);
        assert_eq!(heading("test_id"), Heading::Test);
    }

    #[test]
    fn a_unit_of_the_wrong_kind_is_reported_as_unknown() {
        assert_eq!(heading("Force [mm]"), Heading::Channel(Channel::Force, HeadingUnit::Unknown("mm".into())));
        assert_eq!(heading("Force [tons]"), Heading::Channel(Channel::Force, HeadingUnit::Unknown("tons".into())));
        assert_eq!(heading("Force"), Heading::Channel(Channel::Force, HeadingUnit::Missing));
    }

    #[test]
    fn units_convert_to_si() {
        let near = |u: Unit, value: f64, si: f64| assert!((u.to_si(value) - si).abs() <= 1e-12 * si.abs(), "{u}");
        near(Unit::Millimetre, 12.5, 0.0125);
        near(Unit::Inch, 1.0, 0.0254);
        near(Unit::PoundForce, 100.0, 444.822_161_526_05);
        near(Unit::Kilonewton, 1.5, 1500.0);
        near(Unit::Fahrenheit, 212.0, 100.0);
        near(Unit::Kelvin, 300.0, 26.85);
        near(Unit::Microsecond, 1e6, 1.0);
    }

    #[test]
    fn every_unit_reads_back_from_its_own_name() {
        for unit in Unit::ALL {
            assert_eq!(unit.name().parse::<Unit>(), Ok(unit));
        }
    }

    #[test]
    fn assignments_from_the_command_line() {
        assert_eq!(assignment("force=kN"), Ok((Channel::Force, "kN")));
        assert_eq!(assignment("side_force=\"Load Cell 2\""), Ok((Channel::SideForce, "Load Cell 2")));
        assert!(assignment("force").is_err());
        assert!(assignment("pressure=bar").unwrap_err().contains("displacement"));
    }
}
