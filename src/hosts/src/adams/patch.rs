//! Replacement of damper functions in an Adams dataset (`.adm`) by calls of dashpot's user subroutine. Apart from added STRING statements,
//! all other bytes stay the same.

use super::dataset::{self, Function, Spline, Statement};
use super::expression::{self, Meaning};
use anyhow::{Context as _, bail};
use std::cell::Cell;

/// A damper to replace.
#[derive(Debug, Clone, PartialEq)]
pub struct Damper {
    /// Name of the SFORCE in Adams View, from the comment before the statement. The part after any dot of this name suffices, if it is
    /// unique. `SFORCE/id` is also accepted.
    pub name: String,
    /// Length at zero displacement, in model units.
    pub length: f64,
    /// Path at which the Adams solver finds the model file of the damper.
    pub model_file: String,
}

/// Model with its dampers replaced.
pub struct Patched {
    /// The bytes of the changed file.
    pub model: Vec<u8>,
    /// Notes for the user about the replaced functions.
    pub notes: Vec<String>,
}

/// Returns the unit of length from the UNITS statement of a model: its name, and its size in meters. Returns `None` without such a
/// statement or without a unit of length.
///
/// # Errors
/// The name is not a unit of length.
pub fn length_unit(adm: &[u8]) -> anyhow::Result<Option<(String, f64)>> {
    let lines = dataset::lines(adm);
    let begins = |line: &[u8]| {
        let text = String::from_utf8_lossy(line).to_uppercase();
        text.strip_prefix("UNITS").is_some_and(|rest| rest.trim_start().starts_with('/'))
    };
    let Some(begin) = lines.iter().position(|line| begins(line.1)) else { return Ok(None) };
    let statement = Statement::parse(&lines, begin);
    let words: Vec<&str> = statement
        .text()
        .split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .filter(|word| !word.is_empty())
        .collect();
    let after = |key: &str| words.iter().position(|word| *word == key).and_then(|at| words.get(at + 1));
    // A system of units (MKS, CGS, FPS, IPS) defines all units.
    let (word, metres) = match (after("LENGTH"), after("SYSTEM")) {
        (Some(word), _) => (*word, super::property::length_in_metres(word).context("UNITS")?),
        (None, Some(&"MKS")) => ("METER", 1.0),
        (None, Some(&"CGS")) => ("CENTIMETER", 0.01),
        (None, Some(&"FPS")) => ("FOOT", 0.3048),
        (None, Some(&"IPS")) => ("INCH", 0.0254),
        _ => return Ok(None),
    };
    Ok(Some((word.to_lowercase(), metres)))
}

const ROUTINE: &str = "dashpot_adams::Dashpot_sfosub";

/// Replaces the dampers of a model.
///
/// A function may add a force at rest, such as a gas force, to its spline. Such a function is replaced only with `with_preload`, by which
/// the user confirms that the model file contains the force.
///
/// # Errors
/// A damper is missing or ambiguous, or is not an SFORCE with an FV spline. The path of a model file cannot be part of a STRING, or the
/// model has no END. An SFORCE that is positive in rebound is also rejected, because the model then does not have the signs of a damper.
pub fn patch(adm: &[u8], dampers: &[Damper], with_preload: bool) -> anyhow::Result<Patched> {
    let lines = dataset::lines(adm);
    let strings = lines.iter().filter_map(|l| dataset::head(l.1)).filter(|h| h.0 == "STRING").map(|h| h.1);
    let last = strings.max().unwrap_or(0);
    // The ids of the added STRING statements, at most one per damper, must not overflow.
    let string = last.checked_add(1).filter(|first| first.checked_add(dampers.len() as u64).is_some());
    let string = string.with_context(|| format!("STRING/{last} leaves no number for another STRING; renumber it"))?;
    let end = lines.iter().rposition(|l| dataset::is_end(l.1)).context("the model has no END statement")?;
    let ending = dataset::ending(lines[0].1);
    // Each model file gets one STRING statement.
    let mut paths: Vec<&str> = Vec::new();
    for damper in dampers {
        let path = damper.model_file.as_str();
        if path.is_empty() || path.contains(|c: char| c.is_control() || c == '!') {
            bail!(
                "the model file {path:?} cannot stand in a STRING: it must have no line break and no exclamation mark"
            );
        }
        if !paths.contains(&path) {
            paths.push(path);
        }
    }
    let strings: String = paths
        .iter()
        .enumerate()
        .map(|(i, path)| format!("STRING/{}{ending}, STRING = {path}{ending}", string + i as u64))
        .collect();
    let mut changes = vec![(lines[end].0, lines[end].0, strings)];
    let mut notes = Vec::new();
    for damper in dampers {
        let function =
            function_of(&lines, &damper.name, with_preload, &mut notes).with_context(|| damper.name.clone())?;
        if changes.iter().any(|c| c.0 == function.begin) {
            bail!("{}: is named twice", damper.name);
        }
        let string = string + paths.iter().position(|p| *p == damper.model_file).unwrap_or(0) as u64;
        let line = lines.iter().rev().find(|l| l.0 <= function.begin).map_or(ending, |l| dataset::ending(l.1));
        let line = if line.is_empty() { ending } else { line };
        // After a backslash the next argument may follow on the same line without a comma.
        let after = function.after.trim_start_matches([' ', '\t']);
        let comma = if after.is_empty() || after.starts_with([',', '\n']) { "" } else { "," };
        let text = format!("FUNCTION = USER({string}, {:?})\\{line}, ROUTINE = {ROUTINE}{comma}", damper.length);
        changes.push((function.begin, function.end, text));
    }
    changes.sort_by_key(|c| c.0);
    let (mut out, mut from) = (Vec::with_capacity(adm.len() + 200), 0);
    for (begin, end, text) in changes {
        out.extend_from_slice(&adm[from..begin]);
        out.extend_from_slice(text.as_bytes());
        from = end;
    }
    out.extend_from_slice(&adm[from..]);
    Ok(Patched { model: out, notes })
}

/// Checks the function of the SFORCE `name`, and returns the function if a call of dashpot's routine can replace it.
fn function_of(
    lines: &[(usize, &[u8])],
    name: &str,
    with_preload: bool,
    notes: &mut Vec<String>,
) -> anyhow::Result<Function> {
    let sforce = Statement::parse(lines, find(lines, name)?);
    let function = sforce.function().context("its SFORCE has no \"FUNCTION = ...\"")?;
    if function.text.starts_with("USER(") {
        let ours = function.after.contains("DASHPOT_ADAMS::");
        bail!("its force is {} routine already", if ours { "this" } else { "a" });
    }
    if sforce.has_key("ROUTINE") {
        bail!("its SFORCE names a ROUTINE beside its function");
    }
    for word in ["ROTATIONAL", "ACTIONONLY"] {
        if sforce.has_quality(word) {
            bail!("its SFORCE is {word}; a damper acts and reacts along a line");
        }
    }
    for note in check_function(lines, &sforce, &function.text, with_preload)? {
        notes.push(format!("{name}: {note}"));
    }
    Ok(function)
}

fn find(lines: &[(usize, &[u8])], name: &str) -> anyhow::Result<usize> {
    if let Some(id) = name.to_uppercase().strip_prefix("SFORCE/").and_then(|id| id.trim().parse::<u64>().ok()) {
        let is = |line: &[u8]| dataset::head(line) == Some(("SFORCE".into(), id));
        return lines.iter().position(|l| is(l.1)).context("is not in the model");
    }
    let (name, tail) = (name.to_lowercase(), format!(".{}", name.to_lowercase()));
    let is = |line: &[u8]| {
        dataset::view_name(line).map(|n| n.to_lowercase()).is_some_and(|full| full == name || full.ends_with(&tail))
    };
    let found: Vec<usize> = (0..lines.len()).filter(|i| is(lines[*i].1)).collect();
    let [comment] = found[..] else {
        bail!(
            "named {} times in the model; give the whole name that stands in adams_view_name='...', or SFORCE/id",
            found.len()
        );
    };
    let is_text = |line: &[u8]| !line.starts_with(b"!") && !line.trim_ascii().is_empty();
    let begin = (comment + 1..lines.len()).find(|i| is_text(lines[*i].1)).context("nothing follows its name")?;
    // Adams View writes a disabled element as comment lines after the name of the element. So the statement at `begin` may belong to the
    // next element.
    if let Some(next) = lines[comment + 1..begin].iter().find_map(|l| dataset::view_name(l.1)) {
        bail!("is switched off in the model: its lines are comments, and the next element is {next}");
    }
    if dataset::head(lines[begin].1).is_none_or(|h| h.0 != "SFORCE") {
        bail!("is no SFORCE but \"{}\"", String::from_utf8_lossy(lines[begin].1).trim());
    }
    Ok(begin)
}

/// Checks that the force of the existing function resists motion: velocity times SFORCE, summed over the points of its SPLINE, is negative.
///
/// Replacement of the function would silently remove its parts other than the spline. So a force in addition to the spline is an error.
/// With `with_preload`, a force at rest is allowed and reported. Factors on the spline are reported. Returns these reports.
fn check_function(
    lines: &[(usize, &[u8])],
    sforce: &Statement,
    function: &str,
    with_preload: bool,
) -> anyhow::Result<Vec<String>> {
    let at = function
        .find("AKISPL(")
        .or_else(|| function.find("CUBSPL("))
        .context("its function has no AKISPL or CUBSPL")?;
    let used = function.matches("AKISPL(").count() + function.matches("CUBSPL(").count();
    if used > 1 {
        bail!("its function has {used} splines; which is the damper's is not understood");
    }
    let id = third_argument(&function[at + 7..]).context("its spline has no plain number")?;
    let is = |line: &[u8]| dataset::head(line) == Some(("SPLINE".into(), id));
    let begin = lines.iter().position(|l| is(l.1)).with_context(|| format!("its SPLINE/{id} is not in the model"))?;
    let spline: Spline = Statement::parse(lines, begin).spline().with_context(|| format!("SPLINE/{id}"))?;
    let markers = [sforce.id_of("I"), sforce.id_of("J")];
    let markers = if markers.contains(&None) { [None; 2] } else { markers };
    let mut notes = Vec::new();
    for list in 0..spline.y.len() {
        let asked = Cell::new(None);
        let force = |speed: f64| {
            let value = |_: u64, x: f64| {
                asked.set(Some(x));
                Ok(spline.value(list, x))
            };
            expression::evaluate(function, &Meaning { markers, speed, spline: &value })
        };
        let (mut power, mut largest, mut factors) = (0.0, 0.0_f64, Vec::new());
        // With a spline of zeros, the function returns only the force that it adds to its spline.
        let nothing = |_: u64, _: f64| Ok(0.0);
        let beside = |speed: f64| expression::evaluate(function, &Meaning { markers, speed, spline: &nothing });
        for speed in spline.x.iter().filter(|x| **x != 0.0) {
            let (whole, from_spline) = (force(*speed)?, spline.value(list, *speed));
            power += speed * whole;
            largest = largest.max(whole.abs());
            if asked.get().is_none_or(|x: f64| (x - speed).abs() > 1e-9 * speed.abs()) {
                bail!("SPLINE/{id} is no function of VR alone");
            }
            if from_spline != 0.0 {
                factors.push((*speed, whole / from_spline));
            }
        }
        if !(power < 0.0) {
            bail!(
                "SPLINE/{id} gives a positive SFORCE in rebound; a damper's is negative, so its signs are not understood"
            );
        }
        let added_at_rest = beside(0.0)?;
        for speed in spline.x.iter().copied().chain([0.0]) {
            let added = beside(speed)?;
            if (added - added_at_rest).abs() > 1e-9 * largest {
                bail!(
                    "its function adds {added} to its spline at the speed {speed}, which is no force at rest and which the \
                     damper's routine would replace; give it an SFORCE of its own first"
                );
            }
            if added.abs() > 1e-9 * largest && !with_preload {
                bail!(
                    "its function adds {added} to its spline, which the damper's routine would replace; where the model file \
                     holds that force (gas_preload) give --replace-preload, else give it an SFORCE of its own first"
                );
            }
        }
        let rest = force(0.0)?;
        if rest.abs() > 1e-9 * largest && !with_preload {
            bail!(
                "its force at rest is {rest}, which the damper's routine would replace; where the model file holds that force \
                 (gas_preload) give --replace-preload, else give it an SFORCE of its own first"
            );
        }
        if rest.abs() > 1e-9 * largest {
            notes.push(format!("its force at rest, {rest}, is replaced by the gas force of the model file"));
        }
        let scaled = factors.iter().find(|(_, factor)| (factor.abs() - 1.0).abs() > 1e-6);
        if let (Some((speed, factor)), true) = (scaled, rest.abs() <= 1e-9 * largest) {
            notes.push(format!(
                "its spline is taken {} times (at the speed {speed}); that factor goes with the spline and is not applied to the \
                 identified damper",
                factor.abs()
            ));
        }
    }
    Ok(notes)
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

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: &str = "A title\n!  adams_view_name='susp.dal_ride_damper.force'\nSFORCE/1\n, TRANSLATIONAL\n, I = 75\n, J = 76\n\
        , FUNCTION = step(vr(75,76), -1e-4, 1.0, 1e-4, 1.0)\n,*akispl(vr(75,76),0,9)\n!\n!  adams_view_name='other'\nSFORCE/2\n\
        , TRANSLATIONAL\n, I = 1\n, J = 2\n, FUNCTION = 0\nSTRING/103\n, STRING = a.tir\nSPLINE/9\n, X = -100, 0, 100\n\
        , Y = 500, 0, -900\nEND\n";

    fn damper(name: &str) -> [Damper; 1] {
        [Damper { name: name.into(), length: 412.5, model_file: "damper.toml".into() }]
    }

    fn refusal(model: &str, name: &str) -> String {
        format!("{:#}", patch(model.as_bytes(), &damper(name), false).map(|p| p.notes).unwrap_err())
    }

    #[test]
    fn the_unit_of_length_is_that_of_the_units_statement() {
        let of = |units: &str| length_unit(format!("A title\n{units}{MODEL}").as_bytes()).unwrap();
        let is = |word: &str, metres| Some((word.to_owned(), metres));
        assert_eq!(
            of("UNITS/\n, FORCE = NEWTON\n, MASS = KILOGRAM\n, LENGTH = METER\n, TIME = SECOND\n"),
            is("meter", 1.0)
        );
        assert_eq!(of("UNITS/FORCE=NEWTON,LENGTH=MILLIMETER\n"), is("millimeter", 1e-3));
        assert_eq!(of("UNITS/SYSTEM = IPS\n"), is("inch", 0.0254));
        assert_eq!(of(""), None);
        assert!(length_unit(b"t\nUNITS/LENGTH=CUBIT\nEND\n").is_err());
    }

    #[test]
    fn what_is_not_understood_is_refused() {
        let name = "dal_ride_damper.force";
        let with = |from: &str, to: &str| {
            assert!(MODEL.contains(from));
            MODEL.replace(from, to)
        };
        for (model, name, word) in [
            (MODEL.to_string(), "dar_ride_damper.force", "0 times"),
            (with("'other'", "'x.dal_ride_damper.force'"), name, "2 times"),
            (MODEL.to_string(), "other", "no AKISPL"),
            (MODEL.to_string(), "SFORCE/7", "not in the model"),
            (with("500, 0, -900", "-500, 0, 900"), name, "positive SFORCE in rebound"),
            (with("= step", "= -step"), name, "positive SFORCE in rebound"),
            (with("SPLINE/9", "SPLINE/8"), name, "SPLINE/9 is not in the model"),
            (with("SFORCE/1", "GFORCE/1"), name, "no SFORCE"),
            (with(", TRANSLATIONAL\n, I = 75", ", ROTATIONAL\n, I = 75"), name, "ROTATION"),
            (with(", TRANSLATIONAL\n, I = 75", ", rotation\n, I = 75"), name, "ROTATION"),
            (with(", TRANSLATIONAL\n, I = 75", ", ROT\n, I = 75"), name, "ROTATION"),
            (with("J = 76\n", "J = 76, ACTIONONLY\n"), name, "ACTIONONLY"),
            (with("J = 76\n", "J = 76, ACTION\n"), name, "ACTIONONLY"),
            (MODEL.replace("\n,", "\n!,").replacen("SFORCE", "!SFORCE", 1), name, "switched off"),
            (with("*akispl", "*dm(75,76)*akispl"), name, "uses DM"),
            (with("akispl(vr(75,76)", "akispl(vr(75,77)"), name, "not its own markers"),
            (with("akispl(vr(75,76)", "akispl(2*vr(75,76)"), name, "no function of VR alone"),
            (with(",0,9)\n!", ",0,9)+akispl(vr(75,76),0,9)\n!"), name, "2 splines"),
            (with(",0,9)\n!", ",0,9,1)\n!"), name, "slope"),
            (with(",0,9)\n!", ",0,i9)\n!"), name, "no plain number"),
            (with(",0,9)\n!", ",0,9\n!"), name, "bracket"),
            (with("X = -100, 0, 100\n, Y = 500, 0, -900", "FILE = a.txt"), name, "in a file"),
            (with("-100, 0, 100", "-100, 0"), name, "2 X and 3 Y"),
            (with("-100, 0, 100", "100, 0, -100"), name, "do not increase"),
            (with("500, 0, -900", "500, zero, -900"), name, "no number"),
            (with("\nEND\n", "\n"), name, "no END"),
            (with("STRING/103", "STRING/18446744073709551615"), name, "leaves no number"),
            (with(",0,9)\n!", ",0,9)+150\n!"), name, "adds 150"),
            (with(",0,9)\n!", ",0,9)-2*abs(vr(75,76))\n!"), name, "adds -200"),
            (with("500, 0, -900", "500, -30, -900"), name, "at rest is -30"),
            (with(",0,9)\n!", ",0,9)\\\n, ROUT = a::b\n!"), name, "names a ROUTINE"),
            (with("= step", &format!("= {}step", "-".repeat(28_000))), name, "nested"),
            (with("= step", &format!("= {}1*step", "(".repeat(28_000))), name, "nested"),
        ] {
            let error = refusal(&model, name);
            assert!(error.contains(word), "{word}: {error}");
        }
        let once = patch(MODEL.as_bytes(), &damper(name), false).unwrap();
        assert!(once.notes.is_empty());
        let error = refusal(&String::from_utf8(once.model).unwrap(), name);
        assert!(error.contains("this routine already"), "{error}");
        let twice = [damper(name), damper("SFORCE/1")].concat();
        let error = patch(MODEL.as_bytes(), &twice, false).map(|p| p.notes).unwrap_err();
        assert!(format!("{error:#}").contains("named twice"));
    }

    #[test]
    fn what_goes_with_the_function_is_said() {
        let preload = MODEL.replace(",0,9)\n!", ",0,9)+150\n!");
        let patched = patch(preload.as_bytes(), &damper("dal_ride_damper.force"), true).unwrap();
        assert!(patched.notes.len() == 1 && patched.notes[0].contains("at rest, 150"), "{:?}", patched.notes);
        let scaled = MODEL.replace("*akispl", "*0.8*akispl");
        let patched = patch(scaled.as_bytes(), &damper("dal_ride_damper.force"), false).unwrap();
        assert!(patched.notes.len() == 1 && patched.notes[0].contains("0.8 times"), "{:?}", patched.notes);
    }

    /// The dataset was written by hand, with abbreviated keywords, ids with leading zeros, and a power with spaces inside.
    #[test]
    fn abbreviations_are_read() {
        let by_hand = MODEL.replace("SFORCE/1\n", "SFORCE/0001\n").replace(", TRANSLATIONAL\n", ",TRANS\n");
        let by_hand = by_hand.replace("FUNCTION = step", "FUNC= 2.0 *(-1)* * 2 * 0.5 *step").replace("0,9)", "0,0009)");
        let patched = patch(by_hand.as_bytes(), &damper("SFORCE/1"), false).unwrap_or_else(|e| panic!("{e:#}"));
        let text = String::from_utf8(patched.model).unwrap();
        assert!(
            text.contains("\n, FUNCTION = USER(104, 412.5)\\\n, ROUTINE = dashpot_adams::") && !text.contains("akispl"),
            "{text}"
        );
    }

    #[test]
    fn each_model_file_has_its_string() {
        let second = "SFORCE/2\n, TRANSLATIONAL\n, I = 1\n, J = 2\n, FUNCTION = 0";
        let model = MODEL.replace(second, &second.replace("= 0", "= akispl(vr(1,2),0,9)"));
        let mut both = [damper("dal_ride_damper.force"), damper("SFORCE/2")].concat();
        both[1].model_file = "rear.toml".into();
        let text = String::from_utf8(patch(model.as_bytes(), &both, false).unwrap().model).unwrap();
        assert!(text.contains("STRING/104\n, STRING = damper.toml\nSTRING/105\n, STRING = rear.toml\nEND"), "{text}");
        assert!(text.contains("USER(104, 412.5)") && text.contains("USER(105, 412.5)"), "{text}");
        for bad in ["a\nb.toml", "a!b.toml", ""] {
            both[1].model_file = bad.into();
            let error = patch(model.as_bytes(), &both, false).map(|p| p.notes).unwrap_err();
            assert!(format!("{error:#}").contains("STRING"), "{error:#}");
        }
    }

    /// Generator of pseudorandom numbers. Equal seeds give equal numbers.
    struct Dice(u64);

    impl Dice {
        fn below(&mut self, n: usize) -> usize {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 33) as usize % n
        }

        fn one<'a>(&mut self, of: &[&'a str]) -> &'a str {
            of[self.below(of.len())]
        }

        fn case(&mut self, text: &str) -> String {
            match self.below(3) {
                0 => text.to_lowercase(),
                1 => text.to_uppercase(),
                _ => text.into(),
            }
        }
    }

    /// Pieces of a random Adams model: the parts that stay, and the original function of each damper, which lies between two such parts.
    struct Made {
        stays: Vec<Vec<u8>>,
        functions: Vec<(String, &'static str)>,
        names: Vec<String>,
    }

    fn made(dice: &mut Dice) -> Made {
        let end = if dice.below(2) == 0 { "\n" } else { "\r\n" };
        let blank = |dice: &mut Dice| dice.one(&["", " ", "  ", "\t"]).to_string();
        let comma = |dice: &mut Dice| dice.one(&[", ", ",", ",\t", " , "]).to_string();
        let mut stays: Vec<Vec<u8>> = vec![format!("END of a car, model {}{end}", dice.below(99)).into_bytes()];
        let (mut functions, mut names) = (Vec::new(), Vec::new());
        let junk = |dice: &mut Dice, into: &mut Vec<u8>| {
            for _ in 0..dice.below(4) {
                let line = dice.one(&[
                    "!",
                    "",
                    "! ------ a comment with , and ' and /",
                    "PART/3, MASS = 1 ! kg",
                    "STRING/12\n, STRING = mdids://x/y.tir",
                    "SFORCE/900, ROTATION, I=1, J=2, FUNCTION=0",
                    "!  adams_view_name='susp.dal_ride_damper.force_old'",
                ]);
                into.extend_from_slice(line.as_bytes());
                if line.starts_with('!') {
                    into.extend_from_slice(&[0xE4, 0xFF, 0x00]);
                }
                into.extend_from_slice(end.as_bytes());
            }
        };
        let spline = |dice: &mut Dice, id: usize, sign: f64| {
            let x = [-1500.0, -300.0, -50.0, 0.0, 50.0, 300.0, 1500.0];
            let list = |dice: &mut Dice, values: &[f64]| {
                let mut text = String::new();
                for (i, v) in values.iter().enumerate() {
                    if i > 0 {
                        let cut = [
                            ", ".to_string(),
                            ",".into(),
                            format!(",{end},\t"),
                            format!("{end}, "),
                            format!(" ! {i}, 7{end}!{end}, "),
                        ];
                        text += &cut[dice.below(5)];
                    }
                    text += &match dice.below(3) {
                        0 => format!("{v:?}"),
                        1 => format!("{v:e}"),
                        _ => format!("{v:.6e}").replace('e', "D"),
                    };
                }
                text
            };
            let y: Vec<f64> = x.iter().map(|v: &f64| sign * v * if *v > 0.0 { 1.3 } else { 0.7 }).collect();
            let mut text = dice.case(&format!("SPLINE/{id}")) + dice.one(&["", ", LINEAR_EXTRAPOLATE"]) + end;
            text += &format!("{}{}={} {}{end}", comma(dice), dice.case("X"), blank(dice), list(dice, &x));
            if dice.below(3) == 0 {
                for z in [0.0, 10.0] {
                    let y: Vec<f64> = [z].into_iter().chain(y.iter().map(|y| y * (1.0 + z))).collect();
                    text += &format!("{}{} ={}{}{end}", comma(dice), dice.case("Y"), blank(dice), list(dice, &y));
                }
            } else {
                text += &format!("{}{} = {}{end}", comma(dice), dice.case("Y"), list(dice, &y));
            }
            text
        };
        for k in 0..1 + dice.below(3) {
            let mut piece = stays.pop().unwrap();
            let (id, spline_id, sign) = (10 + k, 40 + k, if dice.below(2) == 0 { -1.0 } else { 1.0 });
            let after_it = dice.below(2) == 0;
            let points = spline(dice, spline_id, sign);
            junk(dice, &mut piece);
            if !after_it {
                piece.extend_from_slice(points.as_bytes());
                junk(dice, &mut piece);
            }
            let name = format!("susp_{k}.dal_Ride_damper.force");
            let mark = dice.one(&["'", "\""]);
            let key = dice.case("adams_view_name");
            piece.extend_from_slice(
                format!("!{}{key}{}={mark}{name}{mark}{end}", dice.one(&["  ", "                 "]), blank(dice))
                    .as_bytes(),
            );
            piece.extend_from_slice(dice.one(&["", "!\n", "\n"]).as_bytes());
            let one_line = dice.below(3) == 0;
            let next = |dice: &mut Dice| {
                if one_line {
                    ", ".to_string()
                } else {
                    format!("{}{end}{}", dice.one(&["", " ! rod, tube"]), comma(dice))
                }
            };
            let (i, j) = (75 + k, 176 + k);
            let mut head = dice.case(&format!("SFORCE/{id}"));
            for word in ["TRANSLATIONAL".to_string(), format!("I{}= {i}", blank(dice)), format!("J = {j}")] {
                head += &next(dice);
                head += &dice.case(&word);
            }
            head += &next(dice);
            piece.extend_from_slice(head.as_bytes());
            stays.push(piece);
            // This factor before the spline, together with the sign of the spline's forces, makes the SFORCE negative in rebound.
            let minus =
                if sign > 0.0 { dice.one(&["-", "-1.0*", "(-1)*", "-2.D0 * "]) } else { dice.one(&["", "1.5*", "+"]) };
            let cut = if one_line { String::new() } else { format!("{end}{}", dice.one(&[",", ", ", ",\t"])) };
            let kind = dice.one(&["akispl", "CUBSPL", "AKISPL"]);
            let mut function = format!("{}{}={}", dice.case("FUNCTION"), blank(dice), blank(dice));
            function += &format!(
                "{minus}step(vr({i},{j}), -1.0e-4, 1.1, 1e-4,{cut} 0.9)*{cut}{kind}( VR({i}, {j}), 0, {spline_id}{})",
                dice.one(&["", ", 0"])
            );
            let last = dice.below(2) == 0;
            function += if last { "" } else { "\\" };
            functions.push((function, end));
            let mut tail = if last { String::new() } else { dice.one(&["", " "]).to_string() };
            if !last && !one_line {
                tail += &format!("{end}, ERROR = 1");
            }
            tail += dice.one(&["", "  ", " ! behind it"]);
            let mut piece = format!("{tail}{end}").into_bytes();
            junk(dice, &mut piece);
            if after_it {
                piece.extend_from_slice(points.as_bytes());
            }
            stays.push(piece);
            names.push(match dice.below(3) {
                0 => name,
                1 => format!("susp_{k}.dal_ride_damper.force"),
                _ => format!("SFORCE/{id}"),
            });
        }
        let mut piece = stays.pop().unwrap();
        junk(dice, &mut piece);
        stays.push(piece);
        stays.push(format!("{}{}", dice.case("END"), dice.one(&["", "\n", "\r\n", " \n! behind\n"])).into_bytes());
        Made { stays, functions, names }
    }

    #[test]
    fn any_file_keeps_every_other_byte() {
        let mut dice = Dice(1);
        for number in 0..3000 {
            let made = made(&mut dice);
            let [ends @ .., last] = &made.stays[..] else { panic!() };
            let (mut model, mut want) = (Vec::new(), Vec::new());
            let strings = ends.iter().any(|p| String::from_utf8_lossy(p).contains("STRING/12"));
            let string = if strings { 13 } else { 1 };
            for (k, piece) in ends.iter().enumerate() {
                model.extend_from_slice(piece);
                want.extend_from_slice(piece);
                if let Some((function, end)) = made.functions.get(k) {
                    model.extend_from_slice(function.as_bytes());
                    want.extend_from_slice(
                        format!("FUNCTION = USER({string}, {:?})\\{end}, ROUTINE = {ROUTINE}", 400.5 + k as f64)
                            .as_bytes(),
                    );
                }
            }
            let end = dataset::ending(dataset::lines(&model)[0].1);
            want.extend_from_slice(format!("STRING/{string}{end}, STRING = a b.toml{end}").as_bytes());
            model.extend_from_slice(last);
            want.extend_from_slice(last);
            let named = |(k, name): (usize, &String)| Damper {
                name: name.clone(),
                length: 400.5 + k as f64,
                model_file: "a b.toml".into(),
            };
            let mut dampers: Vec<Damper> = made.names.iter().enumerate().map(named).collect();
            if number % 2 == 0 {
                dampers.reverse();
            }
            let got = patch(&model, &dampers, false).map(|patched| patched.model);
            let text = String::from_utf8_lossy(&model);
            let got = got.unwrap_or_else(|e| panic!("file {number}: {e:#}\n{text}"));
            assert!(got == want, "file {number}\n{text}\nbecame\n{}", String::from_utf8_lossy(&got));
        }
    }
}
