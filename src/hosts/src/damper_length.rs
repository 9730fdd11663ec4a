//! Parsing of the length of a damper.
//!
//! Adams uses mm, and CarMaker uses m, so the user may write a unit after the number. A length that no damper has is rejected, because the
//! user probably meant the unit of the other program.

use dashpot_messages::format_number;

/// Longest accepted length of a damper, m. A larger number is probably a length in mm. A damper of a heavy truck reaches 1 m, and the limit
/// leaves a margin.
pub(crate) const LONGEST: f64 = 3.0;

/// Shortest accepted length of a damper, m. The damper of a toy model car is 0.05 m long, and the limit leaves a margin.
pub(crate) const SHORTEST: f64 = 0.03;

/// Splits a text into a number and its unit, `mm` or `m`, if the text ends with one.
pub fn parts(text: &str) -> (&str, Option<&'static str>) {
    let given = ["mm", "m"].into_iter().find_map(|unit| Some((text.strip_suffix(unit)?.trim_end(), Some(unit))));
    given.unwrap_or((text, None))
}

/// Parses a length and converts it to the model's unit. `unit` is the name of that unit, and `metres` is its size in meters. A number
/// without a unit is in the model's unit.
///
/// # Errors
/// The text is not the length of a damper.
pub fn in_units(text: &str, unit: &str, metres: f64) -> Result<f64, String> {
    let (number, given) = parts(text);
    let Ok(value) = number.parse::<f64>() else {
        return Err(format!("the length \"{text}\" is no number, with mm or m behind it if you like"));
    };
    let in_metres = match given {
        Some("mm") => value / 1e3,
        Some(_) => value,
        None => value * metres,
    };
    if !(SHORTEST..=LONGEST).contains(&in_metres) {
        return Err(format!(
            "no damper is {} {} long (they have {SHORTEST} to {LONGEST} m); a number alone is in the unit of the model, {unit}, so give such as {:.4} or \
             412.5mm",
            format_number(value),
            given.unwrap_or(unit),
            0.4125 / metres
        ));
    }
    // If the number is in the model's unit, use it without conversion: 412.3 stays 412.3.
    Ok(match given {
        None => value,
        Some("mm") if metres == 1e-3 => value,
        Some(_) if metres == 1e-3 => in_metres * 1e3,
        _ => in_metres / metres,
    })
}

/// Parses a length in mm. A number without a unit is in mm.
///
/// # Errors
/// The text is not the length of a damper.
pub fn in_millimetres(text: &str) -> Result<f64, String> {
    read(text, "mm")
}

/// Parses a length in m. A number without a unit is in m.
///
/// # Errors
/// The text is not the length of a damper.
pub fn in_metres(text: &str) -> Result<f64, String> {
    read(text, "m")
}

/// Parses a length in `unit`. A number without a unit is in this unit.
fn read(text: &str, unit: &str) -> Result<f64, String> {
    let (number, given) = parts(text);
    let given = given.unwrap_or(unit);
    let example = if unit == "mm" { "412.5, 412.5mm or 0.4125m" } else { "0.4125, 0.4125m or 412.5mm" };
    let Ok(value) = number.parse::<f64>() else {
        let comma = if number.contains(',') { "; a decimal comma is written as a point" } else { "" };
        return Err(format!(
            "the length of a damper is a number in {unit}, with its unit if you like, such as {example}{comma}"
        ));
    };
    let metres = if given == "mm" { value / 1e3 } else { value };
    if !(SHORTEST..=LONGEST).contains(&metres) {
        return Err(format!(
            "no damper is {} {given} long (they have {SHORTEST} to {LONGEST} m); a number alone is in {unit}, so give such as {example}",
            format_number(value)
        ));
    }
    // Use the number without conversion to m and back: 412.3 stays 412.3.
    Ok(match (given, unit) {
        ("m", "mm") => value * 1e3,
        ("mm", "m") => value / 1e3,
        _ => value,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_may_bear_its_unit() {
        for text in ["412.5", "412.5mm", "412.5 mm", "0.4125m", "0.4125 m"] {
            assert_eq!(in_millimetres(text), Ok(412.5), "{text}");
        }
        for text in ["0.4125", "0.4125m", "412.5mm"] {
            assert_eq!(in_metres(text), Ok(0.4125), "{text}");
        }
        assert_eq!(in_millimetres("412.3"), Ok(412.3));
    }

    #[test]
    fn a_length_is_taken_in_the_units_of_the_model() {
        for (text, unit, metres, length) in [
            ("0.4125", "meter", 1.0, 0.4125),
            ("412.5mm", "meter", 1.0, 0.4125),
            ("412.3", "millimeter", 1e-3, 412.3),
            ("412.3mm", "millimeter", 1e-3, 412.3),
            ("0.4125m", "millimeter", 1e-3, 412.5),
            ("0.254m", "inch", 0.0254, 10.0),
        ] {
            assert_eq!(in_units(text, unit, metres), Ok(length), "{text}");
        }
        assert_eq!(in_units("412.3", "millimeter", 1e-3), Ok(412.3));
        let refusal = in_units("412.5", "meter", 1.0).unwrap_err();
        assert!(refusal.contains("412.5 meter long") && refusal.contains("0.4125 or 412.5mm"), "{refusal}");
        assert!(in_units("0.4125", "millimeter", 1e-3).is_err());
    }

    #[test]
    fn lengths_of_hundreds_of_digits_are_rejected_in_a_short_sentence() {
        for value in ["1e308", "-1e308", "1e-308", "inf", "NaN", "0"] {
            for message in [in_millimetres(value), in_metres(value), in_units(value, "inch", 0.0254)] {
                let message = message.unwrap_err();
                assert!(message.contains(value) && message.contains("0.03 to 3 m"), "{message}");
                assert!(message.len() < 300, "{message}");
            }
        }
    }

    #[test]
    fn a_length_that_no_damper_has_is_refused_with_the_unit_that_was_taken() {
        for (text, read, words) in [
            ("0.4125", in_millimetres as fn(&str) -> _, "0.4125 mm long"),
            ("412.5", in_metres, "412.5 m long"),
            ("412.5m", in_millimetres, "412.5 m long"),
            ("0.4125mm", in_metres, "0.4125 mm long"),
            ("0", in_millimetres, "0 mm long"),
            ("-412.5", in_millimetres, "-412.5 mm long"),
            ("nan", in_metres, "NaN m long"),
            ("412,5", in_millimetres, "decimal comma"),
            ("16in", in_millimetres, "a number in mm"),
            ("", in_metres, "a number in m"),
        ] {
            let refusal: String = read(text).unwrap_err();
            assert!(refusal.contains(words) && refusal.contains("412.5mm"), "{text}: {refusal}");
        }
    }
}
