//! Reader of the file of dimensions: TOML with the unit in every key.

use crate::dimensions::{Design, Dimensions};
use crate::entry::{DESIGN, ENTRIES, Entry, EntryRow};
use crate::error::DimensionsError;
use crate::uncertain::Uncertain;
use dashpot_identification::model_file::nearest;
use dashpot_messages::format_number;
use std::collections::BTreeMap;
use std::path::Path;
use toml::{Spanned, Value};

/// Smallest half-width of a pressure's 95 % interval, Pa: the accuracy of a workshop gauge.
const GAUGE: f64 = 5e3;

/// Reads a file of dimensions.
///
/// # Errors
/// Returns a [`DimensionsError`] with the file and, for an invalid entry, line and key.
pub fn read(path: &Path) -> Result<Dimensions, DimensionsError> {
    let unreadable = |why| DimensionsError::Unreadable { file: path.to_path_buf(), why };
    let text = dashpot_records::read_small_text(path).map_err(unreadable)?;
    parse(&text, path)
}

/// Parses the text of a file. Errors contain `path`.
///
/// # Errors
/// Returns a [`DimensionsError`] with the file and, for an invalid entry, line and key.
pub fn parse(text: &str, path: &Path) -> Result<Dimensions, DimensionsError> {
    let file = || path.to_path_buf();
    let entries: BTreeMap<Spanned<String>, Spanned<Value>> = toml::from_str(text)
        .map_err(|e| DimensionsError::Toml { file: file(), why: e.to_string().trim().to_owned() })?;
    let mut found = Dimensions::default();
    for (name, value) in &entries {
        let line = 1 + text[..value.span().start].matches('\n').count();
        let key = name.get_ref().as_str();
        let wrong = |text: String| DimensionsError::Entry { file: file(), line, key: key.to_owned(), text };
        if key == DESIGN {
            found.design = Some(design(value.get_ref()).map_err(wrong)?);
            continue;
        }
        let Some(row) = ENTRIES.iter().find(|row| row.key == key) else {
            let known = ENTRIES.iter().map(|row| row.key).chain([DESIGN]);
            return Err(wrong(match nearest(key, known.clone()) {
                hint if hint.is_empty() => {
                    format!(" is no entry of a drawing; the entries are {}", known.collect::<Vec<_>>().join(", "))
                }
                hint => format!(" is no entry of a drawing{hint}"),
            }));
        };
        found = found.with(row.entry, number(row, value.get_ref()).map_err(wrong)?);
    }
    check(&found).map_err(|text| DimensionsError::Together { file: file(), text })?;
    Ok(found)
}

fn design(value: &Value) -> Result<Design, String> {
    match value.as_str() {
        Some("monotube") => Ok(Design::Monotube),
        Some("twin_tube") => Ok(Design::TwinTube),
        _ => Err(format!(" = {} is no design: it is \"monotube\" or \"twin_tube\"", shown(value))),
    }
}

/// Formats a value of the file for a message. The TOML library would write 1e308 with 309 digits, and a list in full.
fn shown(value: &Value) -> String {
    match value {
        Value::Float(number) => format_number(*number),
        Value::Array(list) => format!("a list of {}", list.len()),
        Value::Table(_) => "a table".to_owned(),
        other => other.to_string(),
    }
}

/// Reads a number, or the two ends of its 95 % interval.
fn number(row: &EntryRow, value: &Value) -> Result<Uncertain, String> {
    let (from, to) = row.bounds;
    let one = |value: &Value| {
        let number = value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64)).ok_or_else(|| {
            format!(
                " = {} is no number; give one, such as {key} = {from}, or its range [low, high]",
                shown(value),
                key = row.key
            )
        })?;
        if number.is_finite() && (from..=to).contains(&number) {
            Ok(number)
        } else {
            let number = format_number(number);
            Err(format!(" = {number} lies outside {from} to {to}; look at the unit, which is the end of the key"))
        }
    };
    let si = |x: f64| x * row.to_si;
    if let Some(ends) = value.as_array() {
        let [low, high] = ends.as_slice() else {
            return Err(format!(" has {} numbers; give one, or its range [low, high]", ends.len()));
        };
        let (low, high) = (one(low)?, one(high)?);
        if low > high {
            return Err(format!(" = [{low}, {high}] has its upper end first; write [{high}, {low}]"));
        }
        // Between positive ends, the value is the geometric mean, because the distribution is symmetric in the
        // logarithm.
        let middle = if low > 0.0 { libm::sqrt(low * high) } else { 0.5 * (low + high) };
        return Ok(Uncertain { value: si(middle), low: si(low), high: si(high) });
    }
    let value = one(value)?;
    Ok(match row.entry {
        Entry::GasTemperature => Uncertain::within(value, 3.0),
        Entry::GasPressure => Uncertain::within(si(value), (row.tolerance * si(value)).max(GAUGE)),
        _ => Uncertain::within_factor(si(value), 1.0 + row.tolerance),
    })
}

/// Rejects combinations of entries that no damper can have.
fn check(found: &Dimensions) -> Result<(), String> {
    let mm = |entry| found.stated(entry).map(|value: Uncertain| 1e3 * value.value);
    if let (Some(bore), Some(rod)) = (mm(Entry::Bore), mm(Entry::Rod))
        && rod >= bore
    {
        return Err(format!("rod_mm = {rod:.3} does not fit into bore_mm = {bore:.3}; exchange or correct the two"));
    }
    let cm3 = |entry| found.stated(entry).map(|value: Uncertain| 1e6 * value.value);
    if let (Some(all), Some(oil)) = (cm3(Entry::ReserveVolume), cm3(Entry::ReserveOil))
        && oil >= all
    {
        return Err(format!(
            "reserve_oil_cm3 = {oil:.3} leaves no gas in reserve_volume_cm3 = {all:.3}; correct one of the two"
        ));
    }
    if let (Some(all), Some(gas)) = (cm3(Entry::ReserveVolume), cm3(Entry::GasVolume))
        && gas > all
    {
        return Err(format!(
            "gas_volume_cm3 = {gas:.3} exceeds reserve_volume_cm3 = {all:.3}, which holds it; correct one of the two"
        ));
    }
    for (entry, others) in [
        (Entry::GasVolume, "reserve_volume_cm3 and reserve_oil_cm3 leave"),
        (Entry::OilVolume, "bore, rod, chambers and reserve_oil_cm3 hold"),
    ] {
        let (Some(stated), Some(other)) = (found.stated(entry), found.by_others(entry)) else { continue };
        // The oil volume may include the oil of a reserve that the drawing does not state.
        let may_be_more = entry == Entry::OilVolume && found.stated(Entry::ReserveOil).is_none();
        if stated.high < other.low || stated.low > other.high && !may_be_more {
            let cm3 = |value: f64| 1e6 * value;
            return Err(format!(
                "{} = {:.1} contradicts the other entries: {others} {:.1} ({:.1} to {:.1}); correct one of them, or give ranges [low, high] that agree",
                entry.key(),
                cm3(stated.value),
                cm3(other.value),
                cm3(other.low),
                cm3(other.high)
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Dimensions, String> {
        parse(text, Path::new("D.toml")).map_err(|e| e.to_string())
    }

    #[test]
    fn every_number_has_bounds_that_its_message_names() {
        for row in &ENTRIES {
            let (low, high) = row.bounds;
            for value in ["1e308", "-1e308", "nan", "inf", "[1e308, 1e308]", "[[1e308], 1]", "[-1e308, 1e308]"] {
                let message = read(&format!("{} = {value}\n", row.key)).unwrap_err();
                assert!(message.starts_with(&format!("D.toml, line 1: {} = ", row.key)), "{message}");
                let names_bounds = message.contains(&format!("{low} to {high}")) || message.contains("is no number");
                assert!(names_bounds && message.len() < 300, "{message}");
            }
            let tiny = read(&format!("{} = 1e-308\n", row.key));
            assert_eq!(tiny.is_ok(), low <= 0.0, "{tiny:?}");
            assert_eq!(read(&format!("{} = 0\n", row.key)).is_ok(), low <= 0.0);
        }
        let message = read("design = 1e308\n").unwrap_err();
        assert!(message.contains("design = 1e308 is no design") && message.len() < 300, "{message}");
    }

    #[test]
    fn units_end_here() {
        let found =
            read("design = \"monotube\"\nbore_mm = 36\ngas_pressure_bar = [14, 16]\noil_modulus_gpa = 1.3\n").unwrap();
        assert_eq!(found.design, Some(Design::Monotube));
        assert!((found.stated(Entry::Bore).unwrap().value - 0.036).abs() < 1e-12);
        let pressure = found.stated(Entry::GasPressure).unwrap();
        assert!((pressure.low - 14e5).abs() < 1.0 && (pressure.high - 16e5).abs() < 1.0);
        assert!((found.stated(Entry::OilModulus).unwrap().value - 1.3e9).abs() < 1.0);
        assert!(read("").unwrap().is_empty());
    }

    #[test]
    fn volumes_that_agree_are_read_and_a_reserve_may_hold_more_oil() {
        let chambers = "bore_mm = 36\nrod_mm = 11\nrebound_chamber_mm = 130\ncompression_chamber_mm = 150\n";
        for more in
            ["oil_volume_cm3 = 275\n", "oil_volume_cm3 = 400\n", "oil_volume_cm3 = 400\nreserve_oil_cm3 = 125\n"]
        {
            assert!(read(&format!("{chambers}{more}")).is_ok(), "{more}");
        }
        let said = read(&format!("{chambers}oil_volume_cm3 = 400\nreserve_oil_cm3 = 20\n")).unwrap_err();
        assert!(said.contains("oil_volume_cm3 = 400.0 contradicts"), "{said}");
        assert!(read("gas_volume_cm3 = 180\nreserve_volume_cm3 = 200\nreserve_oil_cm3 = 20\n").is_ok());
    }

    #[test]
    fn what_is_wrong_is_named_with_file_line_and_key() {
        for (text, part) in [
            ("rod_mm = 12\nbor_mm = 36\n", "D.toml, line 2: bor_mm is no entry of a drawing; did you mean bore_mm?"),
            ("color = 3\n", "the entries are bore_mm, rod_mm"),
            ("bore_mm = 0.036\n", "D.toml, line 1: bore_mm = 0.036 lies outside 5 to 300"),
            ("bore_mm = nan\n", "lies outside"),
            ("bore_mm = \"36\"\n", "is no number"),
            ("bore_mm = [36, 35]\n", "write [35, 36]"),
            ("bore_mm = [36]\n", "has 1 numbers"),
            ("design = \"tritube\"\n", "\"monotube\" or \"twin_tube\""),
            ("bore_mm = 12\nrod_mm = 36\n", "D.toml: rod_mm = 36.000 does not fit into bore_mm = 12.000"),
            ("reserve_volume_cm3 = 90\nreserve_oil_cm3 = 95\n", "leaves no gas"),
            (
                "gas_volume_cm3 = 100\nreserve_volume_cm3 = 200\nreserve_oil_cm3 = 20\n",
                "gas_volume_cm3 = 100.0 contradicts the other entries: reserve_volume_cm3 and reserve_oil_cm3 leave 180.0",
            ),
            (
                "bore_mm = 36\nrod_mm = 11\nrebound_chamber_mm = 130\ncompression_chamber_mm = 150\noil_volume_cm3 = 20\n",
                "oil_volume_cm3 = 20.0 contradicts",
            ),
            ("bore_mm = \n", "is not a TOML file"),
            ("[oil]\nmodulus = 3\n", "oil is no entry"),
        ] {
            let said = read(text).expect_err(text);
            assert!(said.contains(part), "{text}: {said}");
        }
    }
}
