//! TeimOrbit property files (`.dpr`, version 4.0): blocks of `key = value` and a table.

use super::{Properties, row, units};
use anyhow::{Context as _, bail};
use std::fmt::Write as _;

/// Writes the properties as a file in mm, s and N.
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

/// Removes the comment of a line. A comment begins with `$` or `!` outside quotes.
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

/// Returns the words of a line, separated by spaces, tabs or commas. Quoted words may contain spaces.
fn words(line: &str) -> impl Iterator<Item = &str> {
    let mut rest = line;
    std::iter::from_fn(move || {
        rest = rest.trim_start_matches([' ', '\t', ',']);
        let quote = rest.chars().next()?;
        let (word, left) = if matches!(quote, '\'' | '"') {
            rest[1..].split_once(quote).unwrap_or((&rest[1..], ""))
        } else {
            rest.split_at(rest.find([' ', '\t', ',']).unwrap_or(rest.len()))
        };
        rest = left;
        Some(word.trim())
    })
}

/// Returns whether a line in a comment sub-block is `KEY = value` outside quotes, and thus not a comment.
fn is_key(line: &str) -> bool {
    line.split_once('=').is_some_and(|(key, _)| {
        let key = key.trim();
        !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
    })
}

/// Reads a property file.
///
/// # Errors
/// The errors of [`super::read`].
pub fn read(text: &str) -> anyhow::Result<Properties> {
    // The format has blocks [..], sub-blocks (..) of a block, and the heading {..} of a table.
    let (mut block, mut within, mut turned) = (String::new(), String::new(), false);
    let mut columns: Vec<String> = Vec::new();
    let (mut length, mut time, mut force) = (None, None, None);
    let (mut rows, mut notes) = (Vec::new(), Vec::new());
    for (i, line) in text.lines().enumerate() {
        let (number, line) = (i + 1, without_comment(line).trim());
        let at = || format!("line {number}");
        if line.is_empty() {
            continue;
        }
        if let Some(name) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            (block, within) = (name.trim().to_uppercase(), String::new());
            columns.clear();
            if !["MDI_HEADER", "HEADER", "UNITS", "CURVE"].contains(&block.as_str()) {
                notes.push(format!("the block [{block}]"));
            }
        } else if let Some(name) = line.strip_prefix('(').and_then(|l| l.strip_suffix(')')) {
            within = name.trim().to_uppercase();
            columns.clear();
            if within != "COMMENTS" && !(block == "UNITS" && ["BASE", "USER"].contains(&within.as_str())) {
                notes.push(format!("the sub-block ({within}) of [{block}]"));
            }
        } else if let Some(heading) = line.strip_prefix('{') {
            let words = heading.trim_end_matches('}').to_lowercase();
            columns = words.split([' ', '\t', ',']).filter(|w| !w.is_empty()).map(str::to_owned).collect();
            let place = |what: &str| columns.iter().position(|c| c.starts_with(what));
            if let ("CURVE", Some(force), Some(velocity)) = (block.as_str(), place("force"), place("vel")) {
                // The table of the curve begins here, so a preceding comment sub-block has ended.
                (within, turned) = (String::new(), force < velocity);
            }
        } else if within == "COMMENTS" && !is_key(line) {
            // The lines of a comment are skipped.
        } else if block == "UNITS" && within == "BASE" {
            for (column, word) in columns.iter().zip(words(line)) {
                match column.as_str() {
                    "length" => length = Some(units::length(word).with_context(at)?),
                    "time" => time = Some(units::time(word).with_context(at)?),
                    "force" => force = Some(units::force(word).with_context(at)?),
                    _ => {}
                }
            }
        } else if block == "UNITS" && within == "USER" {
            // A row (USER) gives the unit of a derived quantity as powers of the base units, times a conversion factor.
            let kind = words(line).next().unwrap_or_default().to_lowercase();
            let factor = columns.iter().position(|c| c.starts_with("conv")).and_then(|place| words(line).nth(place));
            let is_one = factor.is_some_and(|factor| factor.parse() == Ok(1.0));
            if ["velocity", "force"].contains(&kind.as_str()) && !is_one {
                bail!(
                    "{}: a unit of {kind} with a conversion of its own; write the curve in the units of (BASE)",
                    at()
                );
            }
        } else if !within.is_empty() && within != "COMMENTS" {
            // Lines of other sub-blocks are skipped. A note already names the sub-block.
        } else if let Some((key, value)) = line.split_once('=') {
            within.clear();
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
            rows.push((if turned { [b, a] } else { [a, b] }, number));
        }
    }
    let (Some(length), Some(time), Some(force)) = (length, time, force) else {
        bail!("the block [UNITS] lacks LENGTH, FORCE or TIME, or its sub-block (BASE) length, force or time");
    };
    if rows.len() < 2 {
        bail!("the block [CURVE] has fewer than two rows");
    }
    let mut curve = super::curve(rows, true)?;
    let units = units::Units { length, time, force };
    curve.velocities.iter_mut().for_each(|v| *v = units.velocity(*v));
    curve.forces.iter_mut().for_each(|f| *f *= force);
    Ok(Properties { curve, linear: false, gas_force: 0.0, notes })
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

    const BASE: &str = "[UNITS]\n(BASE)\n{length force angle mass time}\n'inch' 'pound_force' 'degrees' 'kg' 'second'\n(USER)\n\
                        {unit_type length force angle mass time conversion}\n'torsion_stiffness' 1 1 -1 0 0 1.0\n'velocity' 1 0 0 0 -1 1.0\n";

    #[test]
    fn units_in_sub_blocks_and_comments_in_any_block_are_read() {
        let text = format!(
            "{BASE}[CURVE]\n(COMMENTS)\n{{comment_string}}\n'a = 3, of the rig'\n'more'\n{{ vel force }}\n-10 -1\n10 2\n"
        );
        let found = read(&text).unwrap();
        assert_eq!(found.curve.velocities, [-0.254, 0.254]);
        assert!((found.curve.forces[1] - 8.896_443_230_521).abs() < 1e-9);
        assert_eq!(found.notes, Vec::<String>::new());
        let text = "[UNITS]\n(COMMENTS)\n{comment_string}\n'as measured'\nLENGTH = 'mm'\nFORCE = 'newton'\nTIME = 'second'\n[CURVE]\n0 0\n1 1\n";
        assert_eq!(read(text).unwrap().curve.velocities, [0.0, 1e-3]);
    }

    #[test]
    fn rows_may_descend() {
        let up = format!("{BASE}[CURVE]\n-10 -1\n0 0\n10 2\n");
        let down = format!("{BASE}[CURVE]\n10 2\n0 0\n-10 -1\n");
        assert_eq!(read(&up).unwrap(), read(&down).unwrap());
    }

    #[test]
    fn a_bad_file_is_refused_with_its_line() {
        let good = "[UNITS]\nLENGTH='mm'\nFORCE='newton'\nTIME='second'\n[CURVE]\n0 0\n1 1\n";
        assert!(read(good).is_ok());
        for (bad, word) in [
            (good.replace("1 1", "1 1 1"), "line 7"),
            (good.replace("1 1", "-1 1"), "line 7"),
            (good.replace("1 1", "1 nan"), "line 7"),
            (good.replace("1 1", "1 -1"), "line 7: force -1 lies below 0"),
            (good.replace("0 0\n1 1", "3 3\n1 4\n0 0"), "line 7: force 3 lies below 4"),
            (good.replace("1 1", "1 1\n1 2"), "line 8: 1 and 1 are out of order"),
            (
                good.replace(
                    "[CURVE]",
                    "(USER)\n{unit_type length force time conversion}\n'velocity' 1 0 -1 2.0\n[CURVE]",
                ),
                "line 7: a unit of velocity",
            ),
            (good.replace("'mm'", "'cubit'"), "line 2"),
            (good.replace("TIME", "TIDE"), "TIME"),
            (good.replace("1 1\n", ""), "two rows"),
            (format!("[MDI_HEADER]\nFILE_TYPE='bus'\n{good}"), "'bus'"),
        ] {
            assert!(format!("{:#}", read(&bad).unwrap_err()).contains(word), "{bad}");
        }
    }
}
