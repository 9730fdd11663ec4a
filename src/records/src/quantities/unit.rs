//! Units of the channels of records. Only this module converts them.

use std::fmt;
use std::str::FromStr;

use serde::Serialize;

/// Physical quantity that a unit measures.
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
    /// Electric current.
    Current,
    /// Setting of a damper, which has its own units.
    Setting,
}

/// A unit of a channel in a record.
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
    KilopoundForce,
    KilogramForce,
    Celsius,
    Kelvin,
    Fahrenheit,
    Ampere,
    Milliampere,
    AsWritten,
}

/// Meters in an inch (exact, international yard and pound agreement of 1959).
const INCH: f64 = 0.0254;
/// Newtons in a pound-force (exact: 0.45359237 kg times 9.80665 m/s²).
const POUND_FORCE: f64 = 4.448_221_615_260_5;
/// Newtons in a kilogram-force (standard gravity, exact).
const KILOGRAM_FORCE: f64 = 9.806_65;

impl Unit {
    /// All units.
    pub const ALL: [Unit; 25] = [
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
        Unit::KilopoundForce,
        Unit::KilogramForce,
        Unit::Celsius,
        Unit::Kelvin,
        Unit::Fahrenheit,
        Unit::Ampere,
        Unit::Milliampere,
        Unit::AsWritten,
    ];

    /// Returns the unit's symbol.
    pub fn name(self) -> &'static str {
        self.spellings()[0]
    }

    /// Returns the supported spellings. The first one is the symbol. The comparison ignores case, because no two units
    /// of one dimension differ only in case.
    fn spellings(self) -> &'static [&'static str] {
        match self {
            Unit::Second => &["s", "sec", "second", "seconds", "sek", "sekunde", "sekunden", "秒"],
            Unit::Millisecond => &["ms", "msec", "millisecond", "milliseconds", "毫秒"],
            Unit::Microsecond => &["us", "usec"],
            Unit::Minute => &["min", "minute", "minutes"],
            Unit::Metre => &["m", "meter", "metre", "meters", "metres", "米"],
            Unit::Centimetre => &["cm"],
            Unit::Millimetre => &["mm", "millimeter", "millimetre", "毫米"],
            Unit::Micrometre => &["um", "micron", "microns"],
            Unit::Inch => &["in", "inch", "inches", "\""],
            Unit::MetrePerSecond => &["m/s", "mps", "m/sec", "m s-1", "m.s-1", "m*s^-1", "ms-1", "ms^-1", "米/秒"],
            Unit::CentimetrePerSecond => &["cm/s", "cm/sec"],
            Unit::MillimetrePerSecond => &["mm/s", "mmps", "mm/sec", "mm s-1", "mm.s-1", "毫米/秒"],
            Unit::InchPerSecond => &["in/s", "ips", "in/sec", "inch/s"],
            Unit::Newton => &["N", "newton", "newtons", "牛", "牛顿"],
            Unit::Decanewton => &["daN"],
            Unit::Kilonewton => &["kN", "千牛"],
            Unit::PoundForce => &["lbf", "lb", "lbs", "pound", "pounds"],
            Unit::KilopoundForce => &["kip", "kips", "klbf", "klb"],
            // Many dynos write kg as the unit of force.
            Unit::KilogramForce => &["kgf", "kp", "kg"],
            Unit::Celsius => &["degC", "C", "deg C", "celsius", "deg_C", "摄氏度"],
            Unit::Kelvin => &["K", "kelvin", "degK"],
            Unit::Fahrenheit => &["degF", "F", "deg F", "fahrenheit", "deg_F"],
            Unit::Ampere => &["A", "amp", "amps", "ampere"],
            Unit::Milliampere => &["mA"],
            Unit::AsWritten => &["as written"],
        }
    }

    /// Returns the quantity that the unit measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Unit::Second | Unit::Millisecond | Unit::Microsecond | Unit::Minute => Dimension::Time,
            Unit::Metre | Unit::Centimetre | Unit::Millimetre | Unit::Micrometre | Unit::Inch => Dimension::Length,
            Unit::MetrePerSecond | Unit::CentimetrePerSecond | Unit::MillimetrePerSecond | Unit::InchPerSecond => {
                Dimension::Speed
            }
            Unit::Newton
            | Unit::Decanewton
            | Unit::Kilonewton
            | Unit::PoundForce
            | Unit::KilopoundForce
            | Unit::KilogramForce => Dimension::Force,
            Unit::Celsius | Unit::Kelvin | Unit::Fahrenheit => Dimension::Temperature,
            Unit::Ampere | Unit::Milliampere => Dimension::Current,
            Unit::AsWritten => Dimension::Setting,
        }
    }

    /// Converts a value in this unit to SI (temperature: °C). Only this function converts the units of channels.
    pub fn to_si(self, value: f64) -> f64 {
        match self {
            Unit::Second
            | Unit::Metre
            | Unit::MetrePerSecond
            | Unit::Newton
            | Unit::Celsius
            | Unit::Ampere
            | Unit::AsWritten => value,
            Unit::Minute => value * 60.0,
            // Division instead of multiplication rounds decimal numbers correctly: 12.5 mm gives the double nearest to
            // 0.0125 m.
            Unit::Millisecond | Unit::Millimetre | Unit::MillimetrePerSecond | Unit::Milliampere => value / 1e3,
            Unit::Microsecond | Unit::Micrometre => value / 1e6,
            Unit::Centimetre | Unit::CentimetrePerSecond => value / 1e2,
            Unit::Inch | Unit::InchPerSecond => value * INCH,
            Unit::Decanewton => value * 10.0,
            Unit::Kilonewton => value * 1e3,
            Unit::PoundForce => value * POUND_FORCE,
            Unit::KilopoundForce => value * 1e3 * POUND_FORCE,
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

/// Replaces characters outside ASCII in units and headings by ASCII characters, and removes accents.
pub(crate) fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            'µ' | 'μ' => out.push('u'),
            '°' | 'º' => out.push_str("deg"),
            '℃' => out.push_str("degC"),
            '\u{feff}' => {}
            '⁻' => out.push('-'),
            '¹' => out.push('1'),
            // Replace the full-width characters of Chinese and Japanese keyboards.
            '\u{ff01}'..='\u{ff5e}' => out.push(char::from_u32(c as u32 - 0xfee0).unwrap_or(c)),
            '\u{3000}' => out.push(' '),
            'à'..='å' => out.push('a'),
            'ç' => out.push('c'),
            'è'..='ë' => out.push('e'),
            'ì'..='ï' => out.push('i'),
            'ñ' => out.push('n'),
            'ò'..='ö' => out.push('o'),
            'ù'..='ü' => out.push('u'),
            'À'..='Å' => out.push('A'),
            'È'..='Ë' => out.push('E'),
            'Ò'..='Ö' => out.push('O'),
            'Ù'..='Ü' => out.push('U'),
            'ß' => out.push_str("ss"),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_convert_to_si() {
        let near = |u: Unit, value: f64, si: f64| assert!((u.to_si(value) - si).abs() <= 1e-12 * si.abs(), "{u}");
        near(Unit::Millimetre, 12.5, 0.0125);
        near(Unit::Inch, 1.0, 0.0254);
        near(Unit::PoundForce, 100.0, 444.822_161_526_05);
        near(Unit::KilopoundForce, 2.0, 8_896.443_230_521);
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
}
