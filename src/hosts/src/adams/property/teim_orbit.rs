//! The TeimOrbit form (`.dpr`, version 4.0): blocks of `key = value` and a table.

use super::{Curve, Properties, push_rising, row, units};
use anyhow::{Context as _, bail};
use std::fmt::Write as _;

/// The table as a property file in mm, s and N.
pub fn write(properties: &Properties) -> String {
    let ruler = |name: &str| format!("${}{name}\n", "-".repeat(78 - name.len()));
    let mut out = String::new();
    for note in &properties.notes {
        let _ = writeln!(out, "$ {}", super::as_comment(note));
    }
    out += &ruler("MDI_HEADER");
    out += "[MDI_HEADER]\n FILE_TYPE     =  'dpr'\n FILE_VERSION  =  4.0\n FILE_FORMAT   =  'ASCII'\n";
    out += &ruler("UNITS");
    out += "[UNITS]\n LENGTH  =  'mm'\n ANGLE  =  'degrees'\n FORCE  =  'newton'\n MASS  =  'kg'\n TIME  =  'second'\n";
    out += &ruler("CURVE");
    out += "[CURVE]\n{   vel       force}\n";
    for (v, f) in properties.curve.velocities.iter().zip(&properties.curve.forces) {
        let _ = writeln!(out, "{:?} {f:?}", 1e3 * v);
    }
    out
}

/// Where a comment begins, outside quotes.
fn without_comment(line: &str) -> &str {
    let mut quoted = None;
    for (i, c) in line.char_indices() {
        match (c, quoted) {
            ('\'' | '"', None) => quoted = Some(c),
            (c, Some(q)) if c == q => quoted = None,
            ('$' | '!', None) => return &line[..i],
            _ => {}
        }
    }
    line
}

/// Reads a property file.
///
/// # Errors
/// As [`super::read`].
pub fn read(text: &str) -> anyhow::Result<Properties> {
    // Blocks [..], sub-blocks (..) of a block, the heading {..} of a table.
    let (mut block, mut within, mut turned) = (String::new(), String::new(), false);
    let (mut length, mut time, mut force) = (None, None, None);
    let (mut curve, mut notes) = (Curve::default(), Vec::new());
    for (i, line) in text.lines().enumerate() {
        let (number, line) = (i + 1, without_comment(line).trim());
        let at = || format!("line {number}");
        if line.is_empty() {
            continue;
        }
        if let Some(name) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            (block, within) = (name.trim().to_uppercase(), String::new());
            if !["MDI_HEADER", "HEADER", "UNITS", "CURVE"].contains(&block.as_str()) {
                notes.push(format!("the block [{block}]"));
            }
        } else if let Some(name) = line.strip_prefix('(').and_then(|l| l.strip_suffix(')')) {
            within = name.trim().to_uppercase();
            if within != "COMMENTS" {
                notes.push(format!("the sub-block ({within}) of [{block}]"));
            }
        } else if line.starts_with('{') {
            let words = line.to_lowercase();
            turned = block == "CURVE" && words.find("force").is_some_and(|f| words.find("vel").is_some_and(|v| f < v));
        } else if !within.is_empty() {
            // Comments, and what is told above.
        } else if let Some((key, value)) = line.split_once('=') {
            let (key, value) = (key.trim().to_uppercase(), value.trim().trim_matches(['\'', '"']).trim());
            match (block.as_str(), key.as_str()) {
                ("MDI_HEADER" | "HEADER", "FILE_TYPE") if !value.eq_ignore_ascii_case("dpr") => {
                    bail!("{}: this is a file of type '{value}', not a damper ('dpr')", at())
                }
                ("UNITS", "LENGTH") => length = Some(units::length(value).with_context(at)?),
                ("UNITS", "TIME") => time = Some(units::time(value).with_context(at)?),
                ("UNITS", "FORCE") => force = Some(units::force(value).with_context(at)?),
                ("CURVE", _) => notes.push(format!("{key} = {value} of [CURVE]")),
                _ => {}
            }
        } else if block == "CURVE" {
            let [a, b] = row(line, number, "[CURVE]")?;
            push_rising(&mut curve, if turned { [b, a] } else { [a, b] }, number)?;
        }
    }
    let (Some(length), Some(time), Some(force)) = (length, time, force) else {
        bail!("the block [UNITS] lacks LENGTH, FORCE or TIME");
    };
    if curve.velocities.len() < 2 {
        bail!("the block [CURVE] has fewer than two rows");
    }
    let units = units::Units { length, time, force };
    curve.velocities.iter_mut().for_each(|v| *v = units.velocity(*v));
    curve.forces.iter_mut().for_each(|f| *f *= force);
    Ok(Properties { curve, straight: false, gas_force: 0.0, notes })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_converted_and_comments_skipped() {
        let text = "$ a comment\n[MDI_HEADER]\nFILE_TYPE = 'dpr'\n(COMMENTS)\n{comment_string}\n'a table = 3, $5'\n[UNITS]\n\
                    LENGTH = 'inch'\nFORCE = 'pound_force'\nTIME = 'sec'\n[CURVE]\n{ vel force}\n-10 -1 ! first\n10 2\n";
        let curve = read(text).unwrap().curve;
        assert_eq!(curve.velocities, [-0.254, 0.254]);
        assert!((curve.forces[1] - 8.896_443_230_521).abs() < 1e-9);
    }

    #[test]
    fn other_hands_wrote_it_too() {
        let text = "[HEADER]\r\nFILE_TYPE = \"DPR\"\r\n[UNITS]\r\nLENGTH = \"meter\"\r\nFORCE=\"KN\"\r\nTIME=\"Sec\"\r\n[curve]\r\n\
                    { force\tvelocity }\r\n-1.0D0,\t-0.5d+00\r\n2.5D-1, 1\r\n[DAMPER_TEMPERATURE]\r\nT = 20\r\n";
        let read = read(text).unwrap();
        assert_eq!((read.curve.velocities, read.curve.forces), (vec![-0.5, 1.0], vec![-1000.0, 250.0]));
        assert_eq!(read.notes, ["the block [DAMPER_TEMPERATURE]"]);
    }

    #[test]
    fn a_bad_file_is_refused_with_its_line() {
        let good = "[UNITS]\nLENGTH='mm'\nFORCE='newton'\nTIME='second'\n[CURVE]\n0 0\n1 1\n";
        assert!(read(good).is_ok());
        for (bad, word) in [
            (good.replace("1 1", "1 1 1"), "line 7"),
            (good.replace("1 1", "-1 1"), "line 7"),
            (good.replace("1 1", "1 nan"), "line 7"),
            (good.replace("1 1", "1 -1"), "line 7: force -1 lies below the one before, 0"),
            (good.replace("'mm'", "'cubit'"), "line 2"),
            (good.replace("TIME", "TIDE"), "TIME"),
            (good.replace("1 1\n", ""), "two rows"),
            (format!("[MDI_HEADER]\nFILE_TYPE='bus'\n{good}"), "'bus'"),
        ] {
            assert!(format!("{:#}", read(&bad).unwrap_err()).contains(word), "{bad}");
        }
    }
}
