//! Replacing dampers in a compiled Adams Car model (`.adm`) by the routine, leaving every other byte alone.

use anyhow::{Context as _, bail};

/// A damper to replace.
#[derive(Debug, Clone, PartialEq)]
pub struct Damper {
    /// Name of the SFORCE in Adams View, as in the comment above it, or its end from a dot on.
    pub name: String,
    /// Length at zero displacement, in model units.
    pub length: f64,
}

/// A statement: the range of its lines.
struct Statement {
    begin: usize,
    end: usize,
}

/// The model with the dampers replaced; they read the model file `path`.
///
/// # Errors
/// Where a damper is not found or found twice, is no SFORCE with an FV spline, or its spline gives a positive SFORCE in
/// rebound: the model's signs are then not those of a damper, and the routine must not guess.
pub fn patch(adm: &str, dampers: &[Damper], path: &str) -> anyhow::Result<String> {
    let mut lines: Vec<String> = adm.split_inclusive('\n').map(String::from).collect();
    let ending = if adm.contains("\r\n") { "\r\n" } else { "\n" };
    let string = 1 + ids(&lines, "STRING").max().unwrap_or(0);
    for damper in dampers {
        let sforce = find(&lines, &damper.name)?;
        check_sign(&lines, &sforce).with_context(|| damper.name.clone())?;
        let function = (sforce.begin..sforce.end)
            .find(|i| keyword(&lines[*i]).starts_with("FUNCTION"))
            .with_context(|| format!("{}: its SFORCE has no line \", FUNCTION = ...\"", damper.name))?;
        lines[function] = format!(
            ", FUNCTION = USER({string}, {:?})\\{ending}, ROUTINE = dashpot_adams::Dashpot_sfosub{ending}",
            damper.length
        );
        lines.drain(function + 1..sforce.end);
    }
    let end = lines.iter().rposition(|l| l.trim().eq_ignore_ascii_case("END") || l.to_uppercase().starts_with("END "));
    let end = end.context("the model has no END statement")?;
    lines.insert(end, format!("STRING/{string}{ending}, STRING = {path}{ending}"));
    Ok(lines.concat())
}

/// What a continuation line begins with, in capitals.
fn keyword(line: &str) -> String {
    line.trim_start_matches(',').trim().to_uppercase()
}

/// The id of a statement that begins with `NAME/`.
fn id(line: &str, name: &str) -> Option<u64> {
    let rest = line.to_uppercase().strip_prefix(name)?.trim_start().strip_prefix('/')?.trim_start().to_string();
    rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
}

fn ids<'a>(lines: &'a [String], name: &'a str) -> impl Iterator<Item = u64> + 'a {
    lines.iter().filter_map(move |l| id(l, name))
}

/// From the line of its name to the last continuation line.
fn statement(lines: &[String], begin: usize) -> Statement {
    let more = lines[begin + 1..].iter().take_while(|l| l.starts_with(',')).count();
    Statement { begin, end: begin + 1 + more }
}

fn find(lines: &[String], name: &str) -> anyhow::Result<Statement> {
    let named = |line: &String| {
        let full =
            line.strip_prefix('!')?.trim().strip_prefix("adams_view_name=")?.trim().trim_matches('\'').to_string();
        (full == name || full.ends_with(&format!(".{name}"))).then_some(())
    };
    let found: Vec<usize> = (0..lines.len()).filter(|i| named(&lines[*i]).is_some()).collect();
    let [comment] = found[..] else {
        bail!(
            "{name}: named {} times in the model; give the whole name that stands in adams_view_name='...'",
            found.len()
        );
    };
    let begin = (comment + 1..lines.len()).find(|i| !lines[*i].starts_with('!')).unwrap_or(comment);
    if id(&lines[begin], "SFORCE").is_none() {
        bail!("{name}: is no SFORCE but \"{}\"", lines[begin].trim());
    }
    Ok(statement(lines, begin))
}

/// The existing function must resist rebound: AKISPL(VR(...), 0, spline) falls with velocity.
fn check_sign(lines: &[String], sforce: &Statement) -> anyhow::Result<()> {
    let text: String = lines[sforce.begin..sforce.end].iter().map(|l| l.trim().trim_start_matches(',')).collect();
    let text = text.to_uppercase().replace(' ', "");
    let at = text.find("AKISPL(").or_else(|| text.find("CUBSPL(")).context("its function has no AKISPL or CUBSPL")?;
    let negated = text[..at].ends_with('-') || text[..at].ends_with("-1*");
    let spline: u64 = third_argument(&text[at + 7..]).context("its spline has no plain number")?;
    let begin = lines.iter().position(|l| id(l, "SPLINE") == Some(spline)).context("its SPLINE is not in the model")?;
    let SplineData { x, y } = spline_data(lines, &statement(lines, begin))?;
    let power: f64 = x.iter().zip(&y).map(|(x, y)| x * y).sum();
    if (power > 0.0) != negated {
        bail!(
            "SPLINE/{spline} gives a positive SFORCE in rebound; a damper's is negative, so its signs are not understood"
        );
    }
    Ok(())
}

fn third_argument(text: &str) -> Option<u64> {
    let (mut depth, mut argument, mut word) = (0, 0, String::new());
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' if depth == 0 => break,
            ')' => depth -= 1,
            ',' if depth == 0 => argument += 1,
            c if argument == 2 && depth == 0 => word.push(c),
            _ => {}
        }
    }
    word.parse().ok()
}

struct SplineData {
    x: Vec<f64>,
    y: Vec<f64>,
}

fn spline_data(lines: &[String], at: &Statement) -> anyhow::Result<SplineData> {
    let mut data = SplineData { x: Vec::new(), y: Vec::new() };
    let mut into_y = None;
    let text: String = lines[at.begin..at.end].concat();
    for word in text.split(|c: char| c == ',' || c.is_whitespace()) {
        let word = match word.trim().to_uppercase() {
            w if w.starts_with("X=") || w == "X" => {
                into_y = Some(false);
                w.trim_start_matches('X').trim_start_matches('=').to_string()
            }
            w if w.starts_with("Y=") || w == "Y" => {
                into_y = Some(true);
                w.trim_start_matches('Y').trim_start_matches('=').to_string()
            }
            w => w.trim_start_matches('=').to_string(),
        };
        if let (Some(into_y), Ok(number)) = (into_y, word.parse::<f64>()) {
            if into_y { data.y.push(number) } else { data.x.push(number) }
        }
    }
    if data.x.len() < 2 || data.x.len() != data.y.len() {
        bail!("its SPLINE has {} X and {} Y values", data.x.len(), data.y.len());
    }
    Ok(data)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: &str = "A title\n!  adams_view_name='susp.dal_ride_damper.force'\nSFORCE/1\n, TRANSLATIONAL\n, I = 75\n, J = 76\n\
        , FUNCTION = step(vr(75,76), -1e-4, 1.0, 1e-4, 1.0)\n,*akispl(vr(75,76),0,9)\n!\n!  adams_view_name='other'\nSFORCE/2\n\
        , TRANSLATIONAL\n, I = 1\n, J = 2\n, FUNCTION = 0\nSTRING/103\n, STRING = a.tir\nSPLINE/9\n, X = -100, 0, 100\n\
        , Y = 500, 0, -900\nEND\n";

    fn damper(name: &str) -> [Damper; 1] {
        [Damper { name: name.into(), length: 412.5 }]
    }

    #[test]
    fn the_named_damper_is_replaced_and_every_other_byte_stays() {
        for ending in ["\n", "\r\n"] {
            let model = MODEL.replace('\n', ending);
            let new = patch(&model, &damper("dal_ride_damper.force"), "damper.toml").unwrap();
            let old_function =
                ", FUNCTION = step(vr(75,76), -1e-4, 1.0, 1e-4, 1.0)\n,*akispl(vr(75,76),0,9)\n".replace('\n', ending);
            let function =
                ", FUNCTION = USER(104, 412.5)\\\n, ROUTINE = dashpot_adams::Dashpot_sfosub\n".replace('\n', ending);
            let string = "STRING/104\n, STRING = damper.toml\n".replace('\n', ending);
            assert!(new.contains(&function) && new.contains(&string), "{new}");
            assert_eq!(new.replace(&function, &old_function).replace(&string, ""), model);
        }
    }

    #[test]
    fn what_is_not_understood_is_refused() {
        for (model, name, word) in [
            (MODEL.to_string(), "dar_ride_damper.force", "0 times"),
            (MODEL.replace("'other'", "'x.dal_ride_damper.force'"), "dal_ride_damper.force", "2 times"),
            (MODEL.to_string(), "other", "no AKISPL"),
            (MODEL.replace("500, 0, -900", "-500, 0, 900"), "dal_ride_damper.force", "positive SFORCE in rebound"),
            (MODEL.replace("SPLINE/9", "SPLINE/8"), "dal_ride_damper.force", "not in the model"),
            (MODEL.replace("SFORCE/1", "GFORCE/1"), "dal_ride_damper.force", "no SFORCE"),
        ] {
            let error = format!("{:#}", patch(&model, &damper(name), "damper.toml").unwrap_err());
            assert!(error.contains(word), "{error}");
        }
        let negated = MODEL.replace("500, 0, -900", "-500, 0, 900").replace(",*akispl", ",*(-akispl");
        assert!(patch(&negated, &damper("dal_ride_damper.force"), "damper.toml").is_ok());
    }
}
