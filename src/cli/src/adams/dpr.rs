//! The damper property file of Adams Car (`.dpr`, TeimOrbit, version 4.0): a table of velocity and force.
//!
//! In the file and here rebound velocity and tension are positive.

use anyhow::{Context as _, bail};
use std::fmt::Write as _;

/// A force-velocity table in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Velocities, m/s.
    pub velocities: Vec<f64>,
    /// Forces, N.
    pub forces: Vec<f64>,
}

/// The table as a property file in mm, s and N.
pub fn write(curve: &Curve) -> String {
    let ruler = |name: &str| format!("${}{name}\n", "-".repeat(70 - name.len()));
    let mut out = ruler("MDI_HEADER");
    out += "[MDI_HEADER]\n FILE_TYPE     =  'dpr'\n FILE_VERSION  =  4.0\n FILE_FORMAT   =  'ASCII'\n";
    out += &ruler("UNITS");
    out += "[UNITS]\n LENGTH  =  'mm'\n ANGLE  =  'degrees'\n FORCE  =  'newton'\n MASS  =  'kg'\n TIME  =  'second'\n";
    out += &ruler("CURVE");
    out += "[CURVE]\n{   vel       force}\n";
    for (v, f) in curve.velocities.iter().zip(&curve.forces) {
        let _ = writeln!(out, "{:?} {f:?}", 1e3 * v);
    }
    out
}

/// Reads a property file.
///
/// # Errors
/// Where the file is of another type, a unit is unknown, or the table is not one: with the line.
pub fn read(text: &str) -> anyhow::Result<Curve> {
    let mut block = String::new();
    let (mut length, mut time, mut force) = (None, None, None);
    let mut curve = Curve { velocities: Vec::new(), forces: Vec::new() };
    for (i, line) in text.lines().enumerate() {
        let line = line.split(['$', '!']).next().unwrap_or_default().trim();
        let at = || format!("line {}", i + 1);
        if line.is_empty() || line.starts_with('{') || line.starts_with('(') {
            continue;
        }
        if let Some(name) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            block = name.trim().to_uppercase();
        } else if let Some((key, value)) = line.split_once('=') {
            let (key, value) = (key.trim().to_uppercase(), value.trim().trim_matches('\'').to_lowercase());
            match (block.as_str(), key.as_str()) {
                ("MDI_HEADER" | "HEADER", "FILE_TYPE") if value != "dpr" => {
                    bail!("{}: this is a file of type '{value}', not a damper ('dpr')", at())
                }
                ("UNITS", "LENGTH") => length = Some(length_unit(&value).with_context(at)?),
                ("UNITS", "TIME") => time = Some(time_unit(&value).with_context(at)?),
                ("UNITS", "FORCE") => force = Some(force_unit(&value).with_context(at)?),
                _ => {}
            }
        } else if block == "CURVE" {
            let numbers: Result<Vec<f64>, _> = line.split_whitespace().map(str::parse::<f64>).collect();
            let Ok([v, f]) = numbers.as_deref() else {
                bail!("{}: a row of [CURVE] is a velocity and a force, not \"{line}\"", at());
            };
            if !v.is_finite() || !f.is_finite() {
                bail!("{}: \"{line}\" is not finite", at());
            }
            if curve.velocities.last().is_some_and(|last| last >= v) {
                bail!("{}: velocity {v} does not lie above the one before; the velocities must increase", at());
            }
            curve.velocities.push(*v);
            curve.forces.push(*f);
        }
    }
    let (Some(length), Some(time), Some(force)) = (length, time, force) else {
        bail!("the block [UNITS] lacks LENGTH, FORCE or TIME");
    };
    if curve.velocities.len() < 2 {
        bail!("the block [CURVE] has fewer than two rows");
    }
    // Dividing by a whole number makes 254 mm into 0.254 m to the last bit.
    let per_metre = 1.0 / length;
    let metres = |v: f64| if per_metre.fract() == 0.0 { v / per_metre } else { v * length };
    curve.velocities.iter_mut().for_each(|v| *v = metres(*v) / time);
    curve.forces.iter_mut().for_each(|f| *f *= force);
    Ok(curve)
}

fn length_unit(word: &str) -> anyhow::Result<f64> {
    Ok(match word {
        "mm" | "millimeter" => 1e-3,
        "cm" | "centimeter" => 1e-2,
        "m" | "meter" => 1.0,
        "km" | "kilometer" => 1e3,
        "inch" | "in" => 0.0254,
        "foot" | "feet" | "ft" => 0.3048,
        _ => bail!("length unit '{word}' is not known (mm, cm, meter, km, inch, foot)"),
    })
}

fn time_unit(word: &str) -> anyhow::Result<f64> {
    Ok(match word {
        "second" | "sec" | "s" => 1.0,
        "millisecond" | "ms" => 1e-3,
        "minute" | "min" => 60.0,
        "hour" => 3600.0,
        _ => bail!("time unit '{word}' is not known (second, millisecond, minute, hour)"),
    })
}

fn force_unit(word: &str) -> anyhow::Result<f64> {
    Ok(match word {
        "newton" | "n" => 1.0,
        "knewton" | "kn" => 1e3,
        "kilogram_force" | "kg_force" | "kgf" => 9.80665,
        "pound_force" | "lbf" => 4.448_221_615_260_5,
        _ => bail!("force unit '{word}' is not known (newton, knewton, kg_force, pound_force)"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let curve = Curve {
            velocities: vec![-0.254, -0.1, 0.0, 0.0333, 1.0 / 3.0],
            forces: vec![-809.5, -300.1, 0.0, 127.0, 1423.4],
        };
        let back = read(&write(&curve)).unwrap();
        for (a, b) in curve.velocities.iter().zip(&back.velocities) {
            assert!((a - b).abs() <= 1e-15 * a.abs(), "{a} {b}");
        }
        assert_eq!(back.forces, curve.forces);
        assert_eq!(write(&read(&write(&back)).unwrap()), write(&back));
    }

    #[test]
    fn units_are_converted_and_comments_skipped() {
        let text = "$ a comment\n[MDI_HEADER]\nFILE_TYPE = 'dpr'\n[UNITS]\nLENGTH = 'inch'\nFORCE = 'pound_force'\nTIME = 'sec'\n\
                    [CURVE]\n{ vel force}\n-10 -1 ! first\n10 2\n";
        let curve = read(text).unwrap();
        assert_eq!(curve.velocities, [-0.254, 0.254]);
        assert!((curve.forces[1] - 8.896_443_230_521).abs() < 1e-9);
    }

    #[test]
    fn a_bad_file_is_refused_with_its_line() {
        let good = "[UNITS]\nLENGTH='mm'\nFORCE='newton'\nTIME='second'\n[CURVE]\n0 0\n1 1\n";
        assert!(read(good).is_ok());
        for (bad, word) in [
            (good.replace("1 1", "1 1 1"), "line 7"),
            (good.replace("1 1", "-1 1"), "line 7"),
            (good.replace("1 1", "1 nan"), "line 7"),
            (good.replace("'mm'", "'cubit'"), "line 2"),
            (good.replace("TIME", "TIDE"), "TIME"),
            (good.replace("1 1\n", ""), "two rows"),
            (format!("[MDI_HEADER]\nFILE_TYPE='bus'\n{good}"), "'bus'"),
        ] {
            assert!(format!("{:#}", read(&bad).unwrap_err()).contains(word), "{bad}");
        }
    }
}
