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
        _ => bail!("length unit '{word}' is not known (mm, cm, meter, km, inch, foot)"),
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

/// N for a word.
pub fn force(word: &str) -> anyhow::Result<f64> {
    Ok(match word.to_lowercase().as_str() {
        "newton" | "n" => 1.0,
        "knewton" | "kilonewton" | "kn" => 1e3,
        "kilogram_force" | "kg_force" | "kgf" => 9.80665,
        "pound_force" | "lbf" => 4.448_221_615_260_5,
        _ => bail!("force unit '{word}' is not known (newton, knewton, kg_force, pound_force)"),
    })
}
