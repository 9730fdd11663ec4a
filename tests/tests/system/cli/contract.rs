//! Tests of the interface to scripts: names, flags, JSON keys and exit codes of the program `dashpot`.

use dashpot_tests::cli::{done, json, number, refused, run, small_campaign};
use serde_json::Value;

const ERRORS: [&str; 5] = ["mean_error_n", "error_percent", "region1_n", "region2_n", "rmse_n"];
const FIGURES: [&str; 4] = ["amplitude_m", "frequency_hz", "peak_velocity_m_s", "max_force_n"];

fn assert_errors(value: &Value) {
    for key in ERRORS {
        assert!(number(value, key) >= 0.0, "{key}");
    }
    for key in ["mean_error_n", "error_percent", "rmse_n"] {
        assert!(number(&value["fv_only"], key) >= 0.0, "{key}");
    }
}

#[test]
fn records_to_model_to_errors() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    small_campaign(dir);
    let said = done(
        dir,
        &["fit", "records", "-o", "m.toml", "--json", "fit.json", "--positive", "rebound", "--model", "thesis"],
    );
    // The last line of the output compares the error of the fit with the noise and with the error of the FV curve
    // alone.
    let last = said.lines().last().unwrap();
    assert!(last.contains("the noise of the records") && last.contains("the FV curve alone"), "{last}");
    let fit = json(&dir.join("fit.json"));
    assert!(fit["parameters"].as_array().is_some_and(|p| p.len() > 5));
    let model: toml::Table = std::fs::read_to_string(dir.join("m.toml")).unwrap().parse().unwrap();
    assert_eq!(model["format"].as_integer(), Some(1));

    // With `--json -`, standard output is pure JSON, equal to the file that `--json` with a file name writes.
    let out = done(dir, &["validate", "m.toml", "records", "--json", "-", "--report", "r.html", "--svg", "figures"]);
    let validation: Value = serde_json::from_str(&out).unwrap();
    done(dir, &["validate", "m.toml", "records", "--json", "v.json"]);
    assert_eq!(json(&dir.join("v.json")), validation);
    let tests = validation["tests"].as_array().unwrap();
    let records = std::fs::read_dir(dir.join("records")).unwrap().count() - 1; // and campaign.toml
    assert_eq!(tests.len(), records);
    for test in tests {
        assert!(test["name"].is_string());
        FIGURES.iter().for_each(|key| assert!(number(test, key) > 0.0));
        assert_errors(test);
    }
    assert_errors(&validation["overall"]);
    let mean = tests.iter().map(|t| number(t, "error_percent")).sum::<f64>() / tests.len() as f64;
    assert!((mean - number(&validation["overall"], "error_percent")).abs() < 1e-9 * mean);
    let report = std::fs::read_to_string(dir.join("r.html")).unwrap();
    assert!(report.contains("<svg") && !report.contains("src=\"http") && !report.contains("<script src"));
    assert!(std::fs::read_dir(dir.join("figures")).unwrap().count() > tests.len());

    for kind in ["fv", "lag"] {
        let out = done(dir, &["fit", "records", "-o", "k.toml", "--model", kind, "--json", "-"]);
        assert!(serde_json::from_str::<Value>(&out).unwrap()["parameters"].is_array());
        done(dir, &["simulate", "k.toml", "records/a50mm_v0262mm_s.csv", "-o", "k.csv"]);
    }
}

#[test]
fn several_files_and_folders_are_one_campaign() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    small_campaign(dir);
    let file = |name: &str| format!("records/{name}.csv");
    let (a, b) = (file("a50mm_v0262mm_s"), file("a15mm_v0262mm_s"));
    let out = done(dir, &["fit", &a, &b, "-o", "m.toml", "--model", "fv"]);
    assert!(out.contains("2 tests fitted") && out.contains("FV curve  mm/s"), "{out}");
    let out = done(dir, &["validate", "m.toml", "records", &a, "--json", "-"]);
    let validation: Value = serde_json::from_str(&out).unwrap();
    let used = |name: &str| {
        let tests = validation["tests"].as_array().unwrap();
        tests.iter().find(|t| t["name"] == name).unwrap()["used_in_fit"].clone()
    };
    assert_eq!((used("a50mm_v0262mm_s"), used("a50mm_v0052mm_s")), (true.into(), false.into()));
}

#[test]
fn matrix_and_rig_write_what_each_other_read() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    let printed = done(dir, &["matrix"]);
    assert!(printed.starts_with("name,amplitude_mm,frequency_hz"));
    done(dir, &["matrix", "-o", "m.csv"]);
    assert_eq!(std::fs::read_to_string(dir.join("m.csv")).unwrap(), printed);
    std::fs::write(dir.join("two.csv"), "amplitude_mm,frequency_hz\n50,0.5\n5,2\n").unwrap();
    done(dir, &["rig", "-o", "c", "--seed", "1", "--noise", "0", "--matrix", "two.csv"]);
    let records = |e: &std::fs::DirEntry| e.path().extension().is_some_and(|e| e == "csv");
    assert_eq!(std::fs::read_dir(dir.join("c")).unwrap().filter(|e| records(e.as_ref().unwrap())).count(), 2);
}

/// Returns the subcommands that a help page lists.
fn commands(help: &str) -> impl Iterator<Item = &str> {
    let list = help.split_once("Commands:\n").map_or("", |(_, rest)| rest.split("\n\n").next().unwrap_or(""));
    list.lines()
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
}

#[test]
fn every_verb_explains_itself_with_an_example() {
    let folder = tempfile::tempdir().unwrap();
    let mut left = vec![Vec::<String>::new()];
    let mut verbs = 0;
    while let Some(path) = left.pop() {
        let asked: Vec<&str> = path.iter().map(String::as_str).chain(["--help"]).collect();
        let help = done(folder.path(), &asked);
        let below: Vec<String> = commands(&help).filter(|verb| *verb != "help").map(str::to_owned).collect();
        if below.is_empty() {
            let example = format!("dashpot {}", path.join(" "));
            assert!(help.contains("Example") && help.contains(&example), "{path:?}: {help}");
            verbs += 1;
        }
        left.extend(below.into_iter().map(|verb| path.iter().cloned().chain([verb]).collect()));
    }
    assert!(verbs > 20, "{verbs}");
    // Missing or wrong arguments produce the usage message.
    for args in [&[][..], &["fit"], &["fit", "x"], &["paint"], &["simulate", "a", "b"]] {
        let ran = run(folder.path(), args);
        assert!(ran.code == Some(2) && (ran.err + &ran.out).contains("Usage"), "{args:?}");
    }
    assert!(refused(folder.path(), &["fit", "x", "-o", "m", "--model", "magic"]).contains("thesis"));
}
