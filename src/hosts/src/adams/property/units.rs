//! Units of property files, in both formats.

use anyhow::bail;

/// Factors that convert numbers in the units of a property file to SI units.
#[derive(Debug, Clone, Copy)]
pub struct Units {
    /// Size of the unit of length, m.
    pub length: f64,
    /// Size of the unit of time, s.
    pub time: f64,
    /// Size of the unit of force, N.
    pub force: f64,
}

impl Units {
    /// Converts a velocity of the file to m/s.
    pub fn velocity(&self, v: f64) -> f64 {
        self.metres(v) / self.time
    }

    /// Converts a length of the file to m. If 1 m is an integer number of units, divides by this number, so that 254 mm becomes exactly
    /// 0.254 m.
    pub fn metres(&self, x: f64) -> f64 {
        let per_metre = 1.0 / self.length;
        if per_metre.fract() == 0.0 { x / per_metre } else { x * self.length }
    }
}

/// Returns the size of a unit of length, m.
pub fn length(word: &str) -> anyhow::Result<f64> {
    Ok(match word.to_lowercase().as_str() {
        "mm" | "millimeter" | "millimetre" => 1e-3,
        "cm" | "centimeter" | "centimetre" => 1e-2,
        "m" | "meter" | "metre" => 1.0,
        "km" | "kilometer" | "kilometre" => 1e3,
        "inch" | "in" => 0.0254,
        "foot" | "feet" | "ft" => 0.3048,
        "mile" => 1609.344,
        _ => bail!("length unit '{word}' is not known (mm, cm, meter, km, inch, foot, mile)"),
    })
}

/// Returns the size of a unit of time, s.
pub fn time(word: &str) -> anyhow::Result<f64> {
    Ok(match word.to_lowercase().as_str() {
        "second" | "sec" | "s" => 1.0,
        "millisecond" | "ms" => 1e-3,
        "minute" | "min" => 60.0,
        "hour" | "h" => 3600.0,
        _ => bail!("time unit '{word}' is not known (second, millisecond, minute, hour)"),
    })
}

/// Pound-force, N, by definition of the international pound and the standard acceleration of gravity.
const POUND_FORCE: f64 = 4.448_221_615_260_5;

/// Returns the size of a unit of force, N.
pub fn force(word: &str) -> anyhow::Result<f64> {
    Ok(match word.to_lowercase().as_str() {
        "newton" | "n" => 1.0,
        "knewton" | "kilonewton" | "kn" => 1e3,
        "kilogram_force" | "kg_force" | "kgf" => 9.80665,
        "pound_force" | "lbf" => POUND_FORCE,
        "kpound_force" => 1e3 * POUND_FORCE,
        "ounce_force" => POUND_FORCE / 16.0,
        "dyne" => 1e-5,
        _ => bail!(
            "force unit '{word}' is not known (newton, knewton, kg_force, pound_force, kpound_force, ounce_force, dyne)"
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names of units come from the documentation of the property files.
    #[test]
    fn every_word_of_the_format_is_known() {
        for word in ["mm", "m", "meter", "cm", "mile", "foot", "inch"] {
            assert!(length(word).is_ok(), "{word}");
        }
        for word in ["newton", "kg_force", "knewton", "pound_force", "kpound_force", "dyne", "ounce_force"] {
            assert!(force(word).is_ok(), "{word}");
        }
        for word in ["second", "sec", "millisecond", "minute", "hour"] {
            assert!(time(word).is_ok(), "{word}");
        }
        // One pound-force accelerates one slug, 14.5939 kg, by one foot per second squared.
        assert!((force("pound_force").unwrap() - 14.593_902_937_2 * 0.3048).abs() < 1e-9);
        assert_eq!(16.0 * force("ounce_force").unwrap(), force("pound_force").unwrap());
        assert_eq!(5280.0 * length("foot").unwrap(), length("mile").unwrap());
    }
}
