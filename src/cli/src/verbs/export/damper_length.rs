//! The length of a damper as an option: Adams counts it in mm and CarMaker in m, so a number may bear its unit, and one that no damper has is
//! taken for one in the other unit and refused.

use dashpot_hosts::fmu::LONGEST;

/// Shortest damper, m: a model car's has 50 mm, with room.
const SHORTEST: f64 = 0.03;

/// A length in mm; the number alone is one.
pub fn in_millimetres(text: &str) -> Result<f64, String> {
    read(text, "mm")
}

/// A length in m; the number alone is one.
pub fn in_metres(text: &str) -> Result<f64, String> {
    read(text, "m")
}

/// A length in `unit`, which a number alone is in.
fn read(text: &str, unit: &str) -> Result<f64, String> {
    let (number, given) = match text.strip_suffix("mm").map(|n| (n, "mm")).or(text.strip_suffix('m').map(|n| (n, "m")))
    {
        Some((number, given)) => (number.trim_end(), given),
        None => (text, unit),
    };
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
            "no damper is {value} {given} long (they have {SHORTEST} to {LONGEST} m); a number alone is in {unit}, so give such as {example}"
        ));
    }
    // From the number itself, not by way of m and back: 412.3 stays 412.3.
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
