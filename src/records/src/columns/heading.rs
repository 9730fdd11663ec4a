//! Recognizes channel and unit in column headings, in the languages and notations of test rigs.

use super::channel_headings::headings;
use crate::quantities::channel::Channel;
use crate::quantities::unit::{Dimension, Unit, plain};
use std::str::FromStr;

/// Meaning of a column heading.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Heading {
    /// One of the channels, with the unit if the heading contains one.
    Channel(Channel, HeadingUnit),
    /// The column that distinguishes several tests in one file.
    Test,
    /// Sample time of a record without a time vector (a scalar of a MAT file).
    SampleTime(HeadingUnit),
    /// Samples per second of a record without a time vector.
    SampleRate,
    /// No known meaning.
    Unknown,
}

/// The unit part of a heading.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum HeadingUnit {
    /// No unit in the heading.
    Missing,
    /// The heading contains a unit that is unknown or does not measure this quantity.
    Unknown(String),
    /// The unit.
    Known(Unit),
}

/// Headings of a column with the name of the test, alone or followed by a word of [`OF_A_TEST`].
const TESTS: [&str; 27] = [
    "test",
    "run",
    "versuch",
    "versuchs",
    "prufung",
    "pruflauf",
    "messung",
    "messlauf",
    "testlauf",
    "essai",
    "prova",
    "ensayo",
    "prueba",
    "testid",
    "testno",
    "testnr",
    "versuchsnr",
    "versuchsnummer",
    "versuchsname",
    "prufnummer",
    "prufungsnummer",
    "messungsnummer",
    "testnummer",
    "试验",
    "试验编号",
    "测试编号",
    "试验名称",
];
/// Words that may follow a word of [`TESTS`] in a heading, such as `id` in `Test ID`.
const OF_A_TEST: [&str; 15] = [
    "id",
    "no",
    "nr",
    "number",
    "name",
    "nummer",
    "bezeichnung",
    "n",
    "num",
    "numero",
    "nom",
    "nome",
    "nombre",
    "编号",
    "名称",
];

/// Words of a heading that give no information about the quantity.
const FILLERS: [&str; 58] = [
    "channel",
    "ch",
    "signal",
    "measured",
    "meas",
    "actual",
    "act",
    "damper",
    "actuator",
    "lead",
    "axial",
    "rig",
    "rod",
    "piston",
    "oil",
    "body",
    "shock",
    "absorber",
    "kanal",
    "ist",
    "istwert",
    "gemessen",
    "dampfer",
    "daempfer",
    "kolben",
    "zylinder",
    "in",
    "de",
    "du",
    "la",
    "del",
    "della",
    "dell",
    "amortisseur",
    "ammortizzatore",
    "amortiguador",
    "mesure",
    "mesuree",
    "misurata",
    "misurato",
    "medida",
    "medido",
    // Words of rig controllers for a measured value and for its axis.
    "feedback",
    "fbk",
    "fb",
    "response",
    "reading",
    "achse",
    "axis",
    "aktuator",
    "station",
    "primary",
    "machine",
    "maschine",
    "main",
    "filter",
    "filtered",
    "gefiltert",
];
/// Words that name a sensor or an input. A heading that is recognized without removal of such words has precedence.
const SENSORS: [&str; 15] = [
    "lvdt",
    "sensor",
    "transducer",
    "encoder",
    "aufnehmer",
    "wegaufnehmer",
    "linear",
    "digital",
    "analog",
    "input",
    "ai",
    "value",
    "wert",
    "messwert",
    "messung",
];

/// Headings of a time column that are the name of a unit, such as `millis`, and this unit.
const CLOCKS: [(&[&str], Unit); 3] = [
    (&["seconds", "secs", "sekunden", "secondes", "segundos", "secondi"], Unit::Second),
    (&["millis", "milliseconds", "millisekunden", "millisecondes"], Unit::Millisecond),
    (&["micros", "microseconds", "mikrosekunden", "microsecondes"], Unit::Microsecond),
];

/// Headings that count only if no other heading names the quantity. For example, Simulink writes `tout` in addition to
/// `time`.
const STOPGAPS: [&str; 6] = ["times", "tout", "dist", "distance", "forc", "lead"];

/// Returns whether a heading has lower precedence than a heading with a common name of the quantity.
pub(crate) fn is_stopgap(text: &str) -> bool {
    if text.len() > LONGEST {
        return false;
    }
    let is_one = |word: &String| {
        STOPGAPS.contains(&word.as_str()) || CLOCKS.iter().any(|(names, _)| names.contains(&word.as_str()))
    };
    words(text).iter().any(is_one)
}

/// Length limit of a heading, bytes. A longer text is not a heading, and the comparison of its words would take
/// minutes.
const LONGEST: usize = 400;

/// Words that indicate a setpoint or a single value of a quantity instead of its signal over time.
const NO_COURSE: [&str; 30] = [
    "command",
    "cmd",
    "setpoint",
    "set",
    "target",
    "demand",
    "desired",
    "reference",
    "ref",
    "error",
    "soll",
    "sollwert",
    "sollweg",
    "sollkraft",
    "regelabweichung",
    "consigne",
    "erreur",
    "setvalue",
    "peak",
    "max",
    "min",
    "maximum",
    "minimum",
    "mean",
    "average",
    "amplitude",
    "side",
    "lateral",
    "预设",
    "设定",
];

/// Words that may accompany the word for current in the heading of a valve current: the device, or a word for a
/// setpoint. A setpoint of the current is a setting too, like a measured current.
const BESIDE_CURRENT: [&str; 25] = [
    "coil",
    "solenoid",
    "valve",
    "spule",
    "ventil",
    "bobine",
    "vanne",
    "bobina",
    "valvola",
    "valvula",
    "command",
    "commanded",
    "cmd",
    "setpoint",
    "set",
    "target",
    "demand",
    "desired",
    "reference",
    "ref",
    "soll",
    "sollwert",
    "consigne",
    "设定",
    "预设",
];

/// Returns whether a heading names a setpoint. A measured current has precedence over its setpoint.
pub(crate) fn is_setpoint(text: &str) -> bool {
    text.len() <= LONGEST && words(text).iter().any(|word| NO_COURSE.contains(&word.as_str()) || word.contains("soll"))
}

/// Returns the unit of current in the brackets of a heading, or in the unit `below` it, as written.
pub(crate) fn unit_of_current<'a>(text: &'a str, below: Option<&'a str>) -> Option<&'a str> {
    let is_current = |unit: &&str| unit.parse::<Unit>().is_ok_and(|unit| unit.dimension() == Dimension::Current);
    written_unit(text).or(below).filter(is_current)
}

/// Words for the fraction of time in which a valve gets its supply voltage, as in "duty cycle".
const DUTY: [&str; 5] = ["duty", "dutycycle", "pwm", "tastgrad", "占空比"];

/// Returns the unit of a command to a valve in another unit than one of current, as written: `Current [%]`.
/// `below` is the unit below the heading.
pub(crate) fn unit_of_command<'a>(text: &'a str, below: Option<&'a str>) -> Option<&'a str> {
    let unit = written_unit(text).or(below)?;
    match heading(text) {
        Heading::Channel(Channel::Current, HeadingUnit::Unknown(_)) => Some(unit),
        _ if text.len() <= LONGEST && words(text).iter().any(|word| DUTY.contains(&word.as_str())) => Some(unit),
        _ => None,
    }
}

/// Returns the channel that the unit of an unknown heading indicates: a force or a displacement. `below` is the unit
/// below the heading. Returns `None` for recognized headings, for setpoints and for other units.
pub(crate) fn by_unit(text: &str, below: Option<&str>) -> Option<Channel> {
    if text.len() > LONGEST {
        return None;
    }
    let text = plain(text);
    let (name, written) = bracketed(text.trim()).map_or((text.trim(), None), |(name, unit)| (name, Some(unit)));
    let told = words(name);
    let unit = written.or(below).and_then(|unit| unit.parse::<Unit>().ok())?;
    if heading(&text) != Heading::Unknown || told.is_empty() || told.iter().any(|w| NO_COURSE.contains(&w.as_str())) {
        return None;
    }
    match unit.dimension() {
        Dimension::Force => Some(Channel::Force),
        Dimension::Length => Some(Channel::Displacement),
        _ => None,
    }
}

/// Reads a column heading: `displacement_mm`, `Velocity [m/s]`, `Force (N)`, `F_N`, `Load, kN`, `Weg in mm`, `位移/mm`.
pub(crate) fn heading(text: &str) -> Heading {
    if text.len() > LONGEST {
        return Heading::Unknown;
    }
    match strict(text) {
        Heading::Unknown => loose(text),
        found => found,
    }
}

/// Returns whether the heading is recognized without removal of sensor names and numbers.
pub(crate) fn is_plain(text: &str) -> bool {
    text.len() <= LONGEST && strict(text) != Heading::Unknown
}

fn strict(text: &str) -> Heading {
    let text = plain(text);
    let text = text.trim();
    if let Some((name, unit)) = bracketed(text) {
        return classify(&words(name), HeadingUnitText::Bracketed(unit));
    }
    let words = words(text);
    // The longest matching unit has precedence: `in/s`, not `s`, in `Piston velocity in/s`. In `Messzeit in s`, only
    // `s` matches.
    let mut other = None;
    for (split, unit) in trailing_units(&words) {
        match classify(&words[..split], HeadingUnitText::Trailing(unit)) {
            Heading::Unknown => {}
            found @ Heading::Channel(_, HeadingUnit::Unknown(_)) => {
                other.get_or_insert(found);
            }
            found => return found,
        }
    }
    other.unwrap_or_else(|| classify(&words, HeadingUnitText::None))
}

/// Reads a heading that also contains a sensor name, an input number, or a name from the acquisition system.
///
/// Examples are `Ch 1 Displacement (mm)`, `Displacement LVDT [mm]` and `Position(Linear:Digital Position) (mm)`. A
/// stated unit must match the channel.
fn loose(text: &str) -> Heading {
    let text = without_rate(&plain(text));
    let (name, unit) = match bracketed(text.trim()) {
        Some((name, unit)) => (name.to_owned(), unit.parse::<Unit>().ok()),
        None => {
            let all = words(&text);
            let (split, unit) = trailing_unit(&all);
            (all[..split].join(" "), unit)
        }
    };
    let outer = name.split(['(', ':']).next().unwrap_or_default();
    let outer = if words(outer).is_empty() { &name } else { outer };
    let told: Vec<String> = words(outer)
        .into_iter()
        .filter(|word| !SENSORS.contains(&word.as_str()) && !word.chars().all(|c| c.is_ascii_digit()))
        .collect();
    match classify(&told, unit.map_or(HeadingUnitText::None, HeadingUnitText::Trailing)) {
        // A single letter with a number is too ambiguous without a unit.
        Heading::Channel(_, HeadingUnit::Missing) if told.concat().chars().count() == 1 => Heading::Unknown,
        found @ Heading::Channel(_, HeadingUnit::Known(_) | HeadingUnit::Missing) => found,
        Heading::Unknown => misspelt(&told, unit),
        _ => Heading::Unknown,
    }
}

/// Reads a long name with one wrong letter, such as `Lead Actuator Displacment`. Excludes time headings, because
/// `Restzeit` is not a misspelled `Testzeit`.
fn misspelt(told: &[String], unit: Option<Unit>) -> Heading {
    /// Smallest number of letters at which a name with one wrong letter is unambiguous.
    const LONG: usize = 9;
    let telling: Vec<&str> = told.iter().map(String::as_str).filter(|w| !FILLERS.contains(w)).collect();
    let [name] = telling[..] else { return Heading::Unknown };
    let length = name.chars().count();
    // This function is called for every possible heading cell. Therefore, compare only names of similar length letter
    // by letter.
    let near = |h: &&&str| h.chars().count() >= LONG && h.chars().count().abs_diff(length) <= 1;
    let of = |channel: &Channel| headings(*channel).iter().filter(near).any(|h| distance(name, h) == 1);
    match ([Channel::Displacement, Channel::Velocity, Channel::Force].into_iter().find(of), unit) {
        (Some(channel), None) => Heading::Channel(channel, HeadingUnit::Missing),
        (Some(channel), Some(unit)) if unit.dimension() == channel.dimension() => {
            Heading::Channel(channel, HeadingUnit::Known(unit))
        }
        _ => Heading::Unknown,
    }
}

/// Removes the rate that some acquisition systems append to the name of their time channel: `Zeit 1 -
/// Standardmessrate`.
fn without_rate(text: &str) -> String {
    const RATES: [&str; 6] = [
        "standardmessrate",
        "schnelle messrate",
        "langsame messrate",
        "default sample rate",
        "fast sample rate",
        "slow sample rate",
    ];
    let Some((name, remark)) = text.split_once(" - ") else { return text.to_owned() };
    let lower = remark.to_lowercase();
    match RATES.iter().find(|rate| lower.trim_start().starts_with(**rate)) {
        // In the heading, the unit follows the rate, so the unit stays.
        Some(rate) => format!("{} {}", name, &remark.trim_start()[rate.len()..]),
        None => text.to_owned(),
    }
}

/// Returns units written as trailing words (`velocity_m_s`, `force N`) and their positions. The longest unit is first.
fn trailing_units(words: &[String]) -> Vec<(usize, Unit)> {
    (1..=2.min(words.len().saturating_sub(1)))
        .rev()
        .map(|count| words.len() - count)
        .filter_map(|split| Some((split, words[split..].join("/").parse::<Unit>().ok()?)))
        // In `Load cell A`, the letter identifies the cell and is not a unit.
        .filter(|(split, unit)| {
            unit.dimension() != Dimension::Current
                || words[..*split].iter().any(|word| headings(Channel::Current).contains(&word.as_str()))
        })
        .collect()
}

/// Returns the longest unit in the trailing words and its position. Without a unit, the position is the number of
/// words.
fn trailing_unit(words: &[String]) -> (usize, Option<Unit>) {
    trailing_units(words).first().map_or((words.len(), None), |(split, unit)| (*split, Some(*unit)))
}

/// Returns the words of a heading without its unit, for comparison with names given by the user.
pub(crate) fn without_unit(text: &str) -> String {
    if text.len() > LONGEST {
        return text.to_owned();
    }
    let text = plain(text);
    match bracketed(text.trim()) {
        Some((name, _)) => words(name).join(" "),
        None => {
            let all = words(&text);
            all[..trailing_unit(&all).0].join(" ")
        }
    }
}

/// Returns the heading most similar to a missing name, if at most a third of the letters of the name (at least one)
/// differ.
pub(crate) fn nearest<'a>(wanted: &str, headings: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = without_unit(wanted);
    let allowed = (wanted.chars().count() / 3).max(1);
    headings
        .into_iter()
        .filter(|h| !h.trim().is_empty())
        .map(|h| (distance(&wanted, &without_unit(h)), h))
        .filter(|(distance, _)| *distance <= allowed)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, h)| h)
}

/// Returns the heading of a file that is likely a misspelled heading of a channel.
pub(crate) fn nearest_to<'a>(channel: Channel, found: &[&'a str]) -> Option<&'a str> {
    /// Number of headings of a file to compare. A malicious file may have millions.
    const COMPARED: usize = 200;
    let known = headings(channel).iter().filter(|h| h.chars().count() >= 3);
    known.filter_map(|h| nearest(h, found.iter().copied().take(COMPARED))).next()
}

/// Returns the edit distance of two texts, in which an exchange of neighboring letters is one edit (Damerau 1964).
/// Returns `usize::MAX` for texts of more than `LONG` characters.
fn distance(a: &str, b: &str) -> usize {
    /// Length of a long text, above that of any heading. Limits the computing time for malicious files.
    const LONG: usize = 64;
    let is_long = |text: &str| text.chars().nth(LONG).is_some();
    if is_long(a) || is_long(b) { usize::MAX } else { strsim::osa_distance(a, b) }
}

enum HeadingUnitText<'a> {
    None,
    Bracketed(&'a str),
    Trailing(Unit),
}

fn classify(words: &[String], unit: HeadingUnitText<'_>) -> Heading {
    let all = words.join(" ");
    if let [test, of_it @ ..] = words
        && TESTS.contains(&test.as_str())
        && of_it.len() <= 1
        && of_it.iter().all(|word| OF_A_TEST.contains(&word.as_str()))
    {
        return Heading::Test;
    }
    if ["sample rate", "sampling rate", "sampling frequency", "sample frequency", "fs", "abtastrate"]
        .contains(&all.as_str())
        && !matches!(&unit, HeadingUnitText::Trailing(u) if u.dimension() == Dimension::Force)
        && !matches!(&unit, HeadingUnitText::Bracketed(u) if u.parse::<Unit>().is_ok_and(|u| u.dimension() == Dimension::Force))
    {
        return Heading::SampleRate;
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
    // In most files, `fs` is the sampling frequency. If `fs` has a unit of force, it is the side force.
    match &unit {
        Some(Ok(u)) if name == "fs" && u.dimension() == Dimension::Force => {
            return Heading::Channel(Channel::SideForce, HeadingUnit::Known(*u));
        }
        _ => {}
    }
    // The letter `T` may also mean time, but the unit in `T [degC]` indicates a temperature.
    match &unit {
        Some(Ok(u)) if name == "t" && u.dimension() == Dimension::Temperature => {
            return Heading::Channel(Channel::Temperature, HeadingUnit::Known(*u));
        }
        _ => {}
    }
    // Microcontroller boards write time headings that are only the name of a unit.
    if unit.is_none()
        && let Some((_, unit)) = CLOCKS.iter().find(|(names, _)| names.contains(&name.as_str()))
    {
        return Heading::Channel(Channel::Time, HeadingUnit::Known(*unit));
    }
    let named = Channel::ALL.into_iter().find(|c| headings(*c).contains(&name.as_str()));
    let is_current = || {
        let own = telling.iter().copied().filter(|word| !BESIDE_CURRENT.contains(word));
        headings(Channel::Current).contains(&own.collect::<Vec<_>>().join(" ").as_str())
    };
    let Some(channel) = named.or_else(|| is_current().then_some(Channel::Current)) else {
        return Heading::Unknown;
    };
    match unit {
        None => Heading::Channel(channel, HeadingUnit::Missing),
        Some(Ok(u)) if u.dimension() == channel.dimension() => Heading::Channel(channel, HeadingUnit::Known(u)),
        // A single letter with a unit of another quantity (`f [Hz]`, `v [V]`) does not name a damper channel.
        Some(_) if name.len() == 1 => Heading::Unknown,
        Some(Ok(u)) => Heading::Channel(channel, HeadingUnit::Unknown(u.name().to_string())),
        Some(Err(text)) => Heading::Channel(channel, HeadingUnit::Unknown(text)),
    }
}

/// Splits `name [unit]`, `name (unit)` or `name {unit}` at the last such bracket.
fn bracketed(text: &str) -> Option<(&str, &str)> {
    for (open, close) in [('[', ']'), ('(', ')'), ('{', '}')] {
        if let Some(start) = text.rfind(open)
            && let Some(length) = text[start..].find(close)
        {
            return Some((&text[..start], text[start + open.len_utf8()..start + length].trim()));
        }
    }
    None
}

/// Returns the unit in the brackets of a heading, as written.
pub(crate) fn written_unit(text: &str) -> Option<&str> {
    bracketed(text).map(|(_, unit)| unit).filter(|unit| !unit.is_empty())
}

/// Splits a heading into words in lower case.
pub(crate) fn words(text: &str) -> Vec<String> {
    plain(text).split(|c: char| !c.is_alphanumeric()).filter(|w| !w.is_empty()).map(str::to_lowercase).collect()
}

/// Lists the supported headings and units, for error messages.
pub(crate) fn vocabulary() -> String {
    let some = |c: Channel| headings(c).iter().take(6).copied().collect::<Vec<_>>().join(", ");
    let units = |c: Channel| c.units_understood();
    let by_heading = Channel::ALL.into_iter().filter(|c| !headings(*c).is_empty());
    let channels: Vec<String> = by_heading.map(|c| format!("{} ({}) in {}", c.name(), some(c), units(c))).collect();
    let channels = channels.join("; ");
    format!("{channels}; the names also in German, French, Italian, Spanish and Chinese")
}

impl FromStr for Channel {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let words = words(text).join(" ");
        Channel::ALL
            .into_iter()
            .find(|c| c.name().replace('_', " ") == words || headings(*c).contains(&words.as_str()))
            .ok_or_else(|| {
                format!("'{text}' is no channel; the channels are {}", Channel::ALL.map(Channel::name).join(", "))
            })
    }
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
        for named in ["Run", "Prüfung Nr.", "Versuch", "Messung", "Prüflauf", "Versuchs-Nr.", "Essai", "试验编号"]
        {
            assert_eq!(heading(named), Heading::Test, "{named}");
        }
    }

    #[test]
    fn a_unit_of_the_wrong_kind_is_reported_as_unknown() {
        assert_eq!(heading("Force [mm]"), Heading::Channel(Channel::Force, HeadingUnit::Unknown("mm".into())));
        assert_eq!(heading("Force [tons]"), Heading::Channel(Channel::Force, HeadingUnit::Unknown("tons".into())));
        assert_eq!(heading("Force"), Heading::Channel(Channel::Force, HeadingUnit::Missing));
    }

    #[test]
    fn headings_as_rigs_write_them_in_six_languages() {
        use Channel::*;
        use Unit::*;
        for (text, channel, unit) in [
            ("Zeit [s]", Time, Second),
            ("Messzeit in s", Time, Second),
            ("Weg [mm]", Displacement, Millimetre),
            ("Dämpferweg_mm", Displacement, Millimetre),
            ("Kraft (kN)", Force, Kilonewton),
            ("Dämpferkraft [N]", Force, Newton),
            ("Daempferkraft [N]", Force, Newton),
            ("Kolbengeschwindigkeit [mm/s]", Velocity, MillimetrePerSecond),
            ("Querkraft [N]", SideForce, Newton),
            ("Öltemperatur [°C]", Temperature, Celsius),
            ("Temps (s)", Time, Second),
            ("Déplacement (mm)", Displacement, Millimetre),
            ("Effort [daN]", Force, Decanewton),
            ("Vitesse (m/s)", Velocity, MetrePerSecond),
            ("Température (°C)", Temperature, Celsius),
            ("Tempo [s]", Time, Second),
            ("Spostamento [mm]", Displacement, Millimetre),
            ("Corsa mm", Displacement, Millimetre),
            ("Forza [N]", Force, Newton),
            ("Velocità [m/s]", Velocity, MetrePerSecond),
            ("Tiempo [s]", Time, Second),
            ("Desplazamiento (mm)", Displacement, Millimetre),
            ("Posición [mm]", Displacement, Millimetre),
            ("Fuerza [kN]", Force, Kilonewton),
            ("Velocidad [m/s]", Velocity, MetrePerSecond),
            ("时间(s)", Time, Second),
            ("时间（秒）", Time, Second),
            ("位移/mm", Displacement, Millimetre),
            ("速度/(m/s)", Velocity, MetrePerSecond),
            ("阻尼力（kN）", Force, Kilonewton),
            ("力 [N]", Force, Newton),
            ("温度(℃)", Temperature, Celsius),
            ("Position(Linear:Digital Position) (mm)", Displacement, Millimetre),
            ("Load(Linear:Load) (kN)", Force, Kilonewton),
            ("Ch 1 Displacement (mm)", Displacement, Millimetre),
            ("Ch 2 Force (kN)", Force, Kilonewton),
            ("Displacement LVDT [mm]", Displacement, Millimetre),
            ("Load Cell 1 [kN]", Force, Kilonewton),
            ("Running Time Sec", Time, Second),
            ("Zeit  1 - Standardmessrate [s]", Time, Second),
            ("Time  1 - default sample rate [s]", Time, Second),
            ("Standardweg [mm]", Displacement, Millimetre),
            ("Standardkraft [N]", Force, Newton),
            ("Achse-2 Weg [mm]", Displacement, Millimetre),
            ("Achse-2 Kraft Filter [N]", Force, Newton),
            ("Axial Displacement Feedback (mm)", Displacement, Millimetre),
            ("Load (kip)", Force, KilopoundForce),
            ("Weg/AI 1 (mm)", Displacement, Millimetre),
            ("Force(Kg)", Force, KilogramForce),
            ("fs [N]", SideForce, Newton),
            ("Millis", Time, Millisecond),
            ("times(s)", Time, Second),
            ("Tout [s]", Time, Second),
            ("dist [mm]", Displacement, Millimetre),
            ("forc (N)", Force, Newton),
            ("Lead Actuator Force [kN]", Force, Kilonewton),
            ("Lead Actuator Displacment (mm)", Displacement, Millimetre),
        ] {
            assert_eq!(read(text), (channel, unit), "{text}");
        }
        for text in [
            "Displacement - Command (mm)",
            "Sollweg [mm]",
            "Kraft Sollwert [N]",
            "Load 2 setpoint [kN]",
            "F 1 [Hz]",
            "x2",
            "1",
            "Consigne effort [N]",
        ] {
            assert_eq!(heading(text), Heading::Unknown, "{text}");
        }
        for text in ["fs", "Fs [Hz]", "Sampling frequency [Hz]"] {
            assert_eq!(heading(text), Heading::SampleRate, "{text}");
        }
        assert!(is_plain("Force [N]") && !is_plain("Force 2 [N]"));
    }

    #[test]
    fn a_current_may_be_set_or_measured() {
        for (text, unit, setpoint) in [
            ("Strom Soll [A]", Unit::Ampere, true),
            ("Sollstrom [mA]", Unit::Milliampere, true),
            ("Strom Ist [A]", Unit::Ampere, false),
            ("Ventilstrom Sollwert (A)", Unit::Ampere, true),
            ("I [A]", Unit::Ampere, false),
            ("I_valve_mA", Unit::Milliampere, false),
            ("I_cmd [A]", Unit::Ampere, true),
            ("Coil current setpoint [mA]", Unit::Milliampere, true),
            ("consigne courant bobine (A)", Unit::Ampere, true),
            ("设定 电流 [A]", Unit::Ampere, true),
        ] {
            assert_eq!((read(text), is_setpoint(text)), ((Channel::Current, unit), setpoint), "{text}");
        }
        // None of these headings is a valve current. They are a current of another device, a single value, a letter
        // with another unit, and a load cell named A.
        for text in
            ["motor current [A]", "max current [A]", "I [mm]", "pump [A]", "Strom Regelabweichung [A]", "Load cell A"]
        {
            assert_eq!(heading(text), Heading::Unknown, "{text}");
        }
        assert_eq!(unit_of_current("pump [A]", None), Some("A"));
        assert_eq!((unit_of_current("pump", Some("mA")), unit_of_current("force", Some("N"))), (Some("mA"), None));
    }

    #[test]
    fn a_unit_speaks_for_a_heading_that_is_not_understood() {
        for (text, below, wanted) in [
            ("friction force (kip)", None, Some(Channel::Force)),
            ("Fh [kN]", None, Some(Channel::Force)),
            ("Linear_Pot (scaled)", None, None),
            ("Linear Pot", Some("mm"), Some(Channel::Displacement)),
            ("u [mm]", None, Some(Channel::Displacement)),
            ("Force setpoint [N]", None, None),
            ("displacement command (mm)", None, None),
            // The heading itself is recognized, so the unit has no influence.
            ("Lateral Force [N]", None, None),
            ("Force [N]", None, None),
            ("[N]", None, None),
            ("Fh", None, None),
        ] {
            assert_eq!(by_unit(text, below), wanted, "{text}");
        }
        assert_eq!(heading("Restzeit"), Heading::Unknown);
        assert_eq!(heading("Ausfederweg [mm]"), Heading::Unknown);
    }

    #[test]
    fn the_nearest_heading_is_proposed() {
        let found = ["Zeit [s]", "Wegg [mm]", "Kratf [N]"];
        assert_eq!(nearest("zeit", found), Some("Zeit [s]"));
        assert_eq!(nearest_to(Channel::Force, &found), Some("Kratf [N]"));
        assert_eq!(nearest_to(Channel::Displacement, &found), Some("Wegg [mm]"));
        assert_eq!(nearest("pressure", found), None);
        assert_eq!((distance("kitten", "sitting"), distance("", "abc")), (3, 3));
    }
}
