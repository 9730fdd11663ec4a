//! A strict reader of the Adams dataset and command files that the exports write.
//!
//! The reader accepts only the kinds of statements that the exports write, and resolves every id.

use std::collections::{BTreeMap, BTreeSet};

/// Argument of a statement in a dataset: a word alone, or a key with its value. A function expression is the value of
/// the key `FUNCTION`.
#[derive(Debug, Clone, PartialEq)]
pub enum Argument {
    /// A word alone.
    Word(String),
    /// A key and its value.
    Value(String, String),
}

/// Statements of a dataset with their arguments, by the name and the id of each statement (`MARKER/11`).
pub type Dataset = BTreeMap<(String, u64), Vec<Argument>>;

/// Type of an argument's value.
#[derive(Clone, Copy)]
enum Kind {
    /// No value: the argument is a word alone.
    Word,
    /// A fixed count of numbers.
    Numbers(usize),
    /// A list of at least four numbers.
    List,
    /// The id of an element of this type, such as MARKER.
    Id(&'static str),
    /// Text of any form.
    Text,
    /// A function expression.
    Function,
    /// `library::routine`.
    Routine,
}

/// Returns the grammar of a statement: the number of required arguments at its start, and all allowed arguments.
fn grammar(name: &str) -> (usize, &'static [(&'static str, Kind)]) {
    use Kind::{Function, Id, List, Numbers, Routine, Text, Word};
    match name {
        "PART" => {
            (0, &[("GROUND", Word), ("MASS", Numbers(1)), ("CM", Id("MARKER")), ("IP", Numbers(3)), ("QG", Numbers(3))])
        }
        "MARKER" => (2, &[("PART", Id("PART")), ("QP", Numbers(3))]),
        "JOINT" => (3, &[("TRANSLATIONAL", Word), ("I", Id("MARKER")), ("J", Id("MARKER"))]),
        "MOTION" => {
            (4, &[("JOINT", Id("JOINT")), ("TRANSLATION", Word), ("DISPLACEMENT", Word), ("FUNCTION", Function)])
        }
        "BUSHING" => (
            6,
            &[
                ("I", Id("MARKER")),
                ("J", Id("MARKER")),
                ("K", Numbers(3)),
                ("KT", Numbers(3)),
                ("C", Numbers(3)),
                ("CT", Numbers(3)),
            ],
        ),
        "SFORCE" => (
            4,
            &[
                ("TRANSLATIONAL", Word),
                ("I", Id("MARKER")),
                ("J", Id("MARKER")),
                ("FUNCTION", Function),
                ("ROUTINE", Routine),
            ],
        ),
        "DIFF" => (2, &[("IC", Numbers(1)), ("FUNCTION", Function), ("STATIC_HOLD", Word)]),
        "REQUEST" => (2, &[("FUNCTION", Function), ("ROUTINE", Routine)]),
        "STRING" => (1, &[("STRING", Text)]),
        "SPLINE" => (2, &[("X", List), ("Y", List)]),
        _ => panic!("no statement {name} is known"),
    }
}

fn numbers(text: &str) -> Vec<f64> {
    text.split(',').map(|n| n.trim().parse().unwrap_or_else(|_| panic!("\"{n}\" is no number"))).collect()
}

/// Joins each statement with its continuation lines, and omits comments. A line feed replaces the comma with which a
/// continuation line begins.
fn joined(text: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with('!')) {
        assert!(line.is_ascii() && !line.contains('\t') && line == line.trim_end(), "\"{line}\"");
        match line.strip_prefix(',') {
            Some(more) => *all.last_mut().expect("a statement to continue") += &format!("\n{more}"),
            None => all.push(line.into()),
        }
    }
    all
}

/// Splits the arguments of a statement at commas and line feeds outside of function expressions.
fn arguments(text: &str) -> Vec<Argument> {
    let mut all: Vec<Argument> = Vec::new();
    let mut rest = text;
    while !rest.trim().is_empty() {
        let trimmed = rest.trim_start_matches([' ', ',', '\n']);
        if let Some(function) = trimmed.strip_prefix("FUNCTION") {
            let function = function.trim_start().strip_prefix('=').expect("FUNCTION =");
            // A function expression must be the last argument, or end with a backslash at the end of its line.
            let (function, after) = function.split_once('\\').unwrap_or((function, ""));
            assert!(after.is_empty() || after.starts_with('\n'), "behind a function: {after}");
            all.push(Argument::Value("FUNCTION".into(), function.replace('\n', "").trim().into()));
            rest = after;
            continue;
        }
        let end = trimmed.find([',', '\n']).unwrap_or(trimmed.len());
        let (piece, after) = trimmed.split_at(end);
        match piece.split_once('=') {
            Some((key, value)) => all.push(Argument::Value(key.trim().into(), value.trim().into())),
            None if piece.trim().chars().all(|c| c.is_ascii_uppercase() || c == '_') => {
                all.push(Argument::Word(piece.trim().into()))
            }
            None => match all.last_mut() {
                Some(Argument::Value(_, value)) => *value += &format!(", {}", piece.trim()),
                _ => panic!("\"{piece}\" belongs to nothing"),
            },
        }
        rest = after;
    }
    all
}

/// Returns the ids of the markers in the functions DM (distance) and VR (relative velocity) of an expression.
fn markers_of(function: &str) -> Vec<u64> {
    let mut all = Vec::new();
    for name in ["DM(", "VR("] {
        for (at, _) in function.match_indices(name) {
            let (ids, _) = function[at + 3..].split_once(')').expect("a bracket");
            all.extend(ids.split(',').map(|i| i.trim().parse::<u64>().expect("a marker")));
        }
    }
    all
}

/// Reads a dataset. If `whole` is true, the text must be a complete model with title, units and END, otherwise a
/// fragment of a model. `others` are ids of markers in the rest of this model.
pub fn read(text: &str, whole: bool, others: &[u64]) -> Dataset {
    let mut all = Dataset::new();
    let mut statements = joined(text);
    if whole {
        statements.remove(0);
        assert_eq!(statements.pop().as_deref(), Some("END"));
        assert_eq!(statements.pop().as_deref(), Some("RESULTS/"));
        assert_eq!(statements.remove(0), "UNITS/FORCE = NEWTON, MASS = KILOGRAM, LENGTH = MILLIMETER, TIME = SECOND");
    }
    for statement in &statements {
        let (name, rest) = statement.split_once('/').unwrap_or_else(|| panic!("\"{statement}\""));
        let (id, rest) = rest.split_once([',', '\n']).unwrap_or((rest, ""));
        let id: u64 = id.trim().parse().unwrap_or_else(|_| panic!("\"{id}\" in {statement}"));
        let earlier = all.insert((name.into(), id), arguments(rest));
        assert!(earlier.is_none(), "{name}/{id} stands twice");
    }
    for ((name, id), given) in &all {
        check(&all, &format!("{name}/{id}"), name, given, others);
    }
    all
}

fn check(all: &Dataset, label: &str, name: &str, given: &[Argument], others: &[u64]) {
    let (needed, allowed) = grammar(name);
    let has = |key: &str| given.iter().any(|a| matches!(a, Argument::Word(k) | Argument::Value(k, _) if k == key));
    for (key, _) in &allowed[..needed] {
        assert!(has(key), "{label} has no {key}");
    }
    let exists = |kind: &str, id: u64| {
        let there = all.contains_key(&(kind.into(), id)) || kind == "MARKER" && others.contains(&id);
        assert!(there, "{label} names {kind}/{id}, which is not there");
    };
    let keys: BTreeSet<String> = given
        .iter()
        .map(|a| match a {
            Argument::Word(k) | Argument::Value(k, _) => k.clone(),
        })
        .collect();
    assert_eq!(keys.len(), given.len(), "{label} says something twice");
    for argument in given {
        let (Argument::Word(key) | Argument::Value(key, _)) = argument;
        let kind = allowed.iter().find(|a| a.0 == key).unwrap_or_else(|| panic!("{label} has {key}")).1;
        match (kind, argument) {
            (Kind::Word, Argument::Word(_)) | (Kind::Text, Argument::Value(..)) => {}
            (Kind::Numbers(count), Argument::Value(_, value)) => {
                assert_eq!(numbers(value).len(), count, "{label} {key}")
            }
            (Kind::List, Argument::Value(_, value)) => assert!(numbers(value).len() > 3, "{label} {key}"),
            (Kind::Id(kind), Argument::Value(_, value)) => exists(kind, value.parse().expect("an id")),
            (Kind::Routine, Argument::Value(_, value)) => {
                let routine = value.strip_prefix("dashpot_adams::Dashpot_");
                assert!(routine.is_some_and(|r| ["sfosub", "reqsub"].contains(&r)), "{label} {value}");
            }
            (Kind::Function, Argument::Value(_, value)) => {
                assert_eq!(value.matches('(').count(), value.matches(')').count(), "{label}");
                if let Some(user) = value.strip_prefix("USER(") {
                    let user = numbers(user.strip_suffix(')').expect("the end of USER"));
                    assert!(user.len() <= 30 && has("ROUTINE"), "{label}");
                    if name == "SFORCE" {
                        exists("STRING", user[0] as u64);
                    } else {
                        exists("SFORCE", user[1] as u64);
                    }
                }
                markers_of(value).iter().for_each(|id| exists("MARKER", *id));
                for (at, _) in value.match_indices("DIF(") {
                    let (id, _) = value[at + 4..].split_once(')').expect("a bracket");
                    exists("DIFF", id.parse().expect("an equation"));
                }
                for (at, _) in value.match_indices("AKISPL(") {
                    let (inside, _) = value[at..].split_once(",0,").expect("z = 0");
                    let id = &value[at + inside.len() + 3..];
                    exists("SPLINE", id[..id.find(')').expect("a bracket")].parse().expect("a spline"));
                }
            }
            _ => panic!("{label}: {key} is not of its kind"),
        }
    }
    if name == "SPLINE" {
        let [x, y] = ["X", "Y"].map(|key| values(given, key));
        assert!(x.len() == y.len() && x.windows(2).all(|w| w[0] < w[1]), "{label}");
    }
    if name == "PART" {
        assert_eq!(has("GROUND"), !has("MASS"), "{label} is the ground or has a mass");
    }
}

/// Returns the value of the argument `key`.
pub fn value<'a>(given: &'a [Argument], key: &str) -> &'a str {
    let found = given.iter().find(|a| matches!(a, Argument::Value(k, _) if k == key));
    let Some(Argument::Value(_, value)) = found else { panic!("no {key}") };
    value
}

/// Returns the numbers in the value of the argument `key`.
pub fn values(given: &[Argument], key: &str) -> Vec<f64> {
    numbers(value(given, key))
}

/// Command of an Adams command file.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Sets the error tolerance of the integrator.
    Integrator(f64),
    /// Replaces the function expression of the MOTION with this id.
    Motion(u64, String),
    /// Starts a static analysis.
    Statics,
    /// Starts a dynamic analysis up to an end time, s, with a number of output steps.
    Dynamics(f64, usize),
}

/// Reads an Adams command file. Returns the names of model and output, and the commands before STOP.
pub fn commands(text: &str) -> (String, String, Vec<Command>) {
    let mut lines = text.lines();
    let [model, output] = [lines.next(), lines.next()].map(|l| l.expect("a name").to_string());
    let rest: Vec<&str> = lines.filter(|l| !l.starts_with('!')).collect();
    let (last, rest) = rest.split_last().expect("commands");
    assert_eq!(*last, "STOP");
    let command = |line: &&str| {
        assert!(line.len() < 160 && !line.starts_with(','), "one line a command: {line}");
        let (name, rest) = line.split_once('/').expect("a command");
        let key = |key: &str| {
            let (_, after) = rest.split_once(&format!("{key}=")).unwrap_or_else(|| panic!("{line}: no {key}"));
            after.split(',').next().expect("a value").trim().parse::<f64>().expect("a number")
        };
        match name {
            "INTEGRATOR" => {
                assert!(rest.starts_with("GSTIFF, SI2, ERROR="), "{line}");
                Command::Integrator(key("ERROR"))
            }
            "MOTION" => {
                let (id, function) = rest.split_once(", FUNCTION = ").expect("a function");
                Command::Motion(id.parse().expect("an id"), function.into())
            }
            "SIMULATE" if rest == "STATICS" => Command::Statics,
            "SIMULATE" => {
                assert!(rest.starts_with("DYNAMICS, END="), "{line}");
                Command::Dynamics(key("END"), key("STEPS") as usize)
            }
            _ => panic!("no command {name} is known"),
        }
    };
    (model, output, rest.iter().map(command).collect())
}
