//! Unit words of property files, in either form.

use anyhow::bail;

/// Factors to SI.
#[derive(Debug, Clone, Copy)]
pub struct Units {
    /// m.
    pub length: f64,
    /// s.
    pub time: f64,
    /// N.
    pub force: f64,
}

impl Units {
    /// A velocity of the file in m/s.
    pub fn velocity(&self, v: f64) -> f64 {
        self.metres(v) / self.time
    }

    /// A length of the file in m. Dividing by a whole number makes 254 mm into 0.254 m to the last bit.
    pub fn metres(&self, x: f64) -> f64 {
        let per_metre = 1.0 / self.length;
        if per_metre.fract() == 0.0 { x / per_metre } else { x * self.length }
    }
}

/// m for a word.
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

/// s for a word.
pub fn time(word: &str) -> anyhow::Result<f64> {
    Ok(match word.to_lowercase().as_str() {
        "second" | "sec" | "s" => 1.0,
        "millisecond" | "ms" => 1e-3,
        "minute" | "min" => 60.0,
        "hour" | "h" => 3600.0,
        _ => bail!("time unit '{word}' is not known (second, millisecond, minute, hour)"),
    })
}

/// N; by definition of the international pound and the standard acceleration of fall.
const POUND_FORCE: f64 = 4.448_221_615_260_5;

/// N for a word.
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

    /// The words that the makers of the format list for it.
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
        // A pound of force is what one slug takes to gain one foot per second and second.
        assert!((force("pound_force").unwrap() - 14.593_902_937_2 * 0.3048).abs() < 1e-9);
        assert_eq!(16.0 * force("ounce_force").unwrap(), force("pound_force").unwrap());
        assert_eq!(5280.0 * length("foot").unwrap(), length("mile").unwrap());
    }
}
