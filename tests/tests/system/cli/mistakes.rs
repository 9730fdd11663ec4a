//! Tests of common mistakes of engineers. Each mistake must give a message with the cause, or a model that lists its
//! limitations.

use dashpot_tests::cli::{HEADER, campaign_folder, done, json, refused, rewrite, row, run, table};
use std::path::Path;

fn fit_refused(dir: &Path) -> String {
    refused(dir, &["fit", "data", "-o", "m.toml"])
}

#[test]
fn wrong_units_are_refused_or_told() {
    let folder = campaign_folder();
    let dir = folder.path();
    let (records, data) = (dir.join("records"), dir.join("data"));
    type Slip = (&'static str, fn([f64; 4]) -> String, &'static str);
    let slips: [Slip; 4] = [
        ("time_s,displacement_m,force_N", |[t, x, _, f]| format!("{t},{},{f}", 1e3 * x), "--unit displacement=mm"),
        ("time_s,velocity_m_s,force_N", |[t, _, v, f]| format!("{t},{},{f}", 1e3 * v), "velocity=mm/s"),
        ("time_s,displacement_m,force_kN", |[t, x, _, f]| format!("{t},{x},{f}"), "--unit force=N"),
        (HEADER, |[t, x, v, f]| format!("{t},{},{v},{f}", 1e3 * x), "--unit displacement=mm"),
    ];
    for (header, slip, wanted) in slips {
        rewrite(&records, &data, header, slip);
        let message = fit_refused(dir);
        assert!(message.contains(wanted) && message.contains(".csv"), "{message}");
    }
    type SlipTold = (&'static str, fn([f64; 4]) -> String, [&'static str; 2]);
    let told: [SlipTold; 3] = [
        ("time_s,displacement_m,force_N", |[t, x, _, f]| format!("{},{x},{f}", 1e3 * t), ["time=ms", "time=s"]),
        ("time_s,displacement_m,force_N", |[t, x, _, f]| format!("{t},{x},{}", 1e-3 * f), ["force=kN", "force=N"]),
        (
            "time_s,displacement_mm,force_N",
            |[t, x, _, f]| format!("{t},{x},{f}"),
            ["displacement=m", "displacement=mm"],
        ),
    ];
    for (header, slip, [likely, insist]) in told {
        rewrite(&records, &data, header, slip);
        let message = fit_refused(dir);
        let wanted = format!("Give --unit {likely}, or --unit {insist} to insist");
        assert!(message.contains(&wanted), "{header}: {message}");
        let told = run(dir, &["fit", "data", "-o", "m.toml", "--model", "fv", "--unit", insist]);
        assert!(told.code == Some(0) && told.err.contains("right?"), "{told:?}");
        std::fs::remove_file(dir.join("m.toml")).unwrap();
    }
    let swapped = |[t, x, _, f]: [f64; 4]| format!("{t},{f},{x}");
    rewrite(&records, &data, "time_s,displacement_mm,force_N", swapped);
    let message = fit_refused(dir);
    assert!(message.contains("'displacement_mm' and 'force_N' look swapped"), "{message}");
}

#[test]
fn a_load_cell_that_is_turned_or_dead_is_refused() {
    let folder = campaign_folder();
    let dir = folder.path();
    let (records, data) = (dir.join("records"), dir.join("data"));
    rewrite(&records, &data, HEADER, |[t, x, v, f]| row([t, x, v, -f]));
    assert!(fit_refused(dir).contains("sign"));
    let told = done(dir, &["fit", "data", "-o", "m.toml", "--flip", "force", "--model", "fv"]);
    assert!(told.contains("rebound positive"), "{told}");
    std::fs::remove_file(dir.join("m.toml")).unwrap();
    rewrite(&records, &data, HEADER, |[t, x, v, _]| row([t, x, v, -152.0]));
    assert!(fit_refused(dir).contains("frozen"));
    // The force channel contains only noise of at most 1 N, independent of the motion.
    rewrite(&records, &data, HEADER, |[t, x, v, f]| row([t, x, v, (1e6 * f + 1e7 * t).sin()]));
    let message = fit_refused(dir);
    assert!(message.contains("tests show no force"), "{message}");
}

#[test]
fn gaps_stubs_and_strays_are_named() {
    let folder = campaign_folder();
    let dir = folder.path();
    let (records, data) = (dir.join("records"), dir.join("data"));
    let copy = || rewrite(&records, &data, HEADER, row);
    std::fs::create_dir(&data).unwrap();
    assert!(fit_refused(dir).contains("holds no record"));
    copy();
    std::fs::write(data.join("b.csv"), format!("{HEADER}\n0,0,0,0\n1,0,0,0\n")).unwrap();
    let strict = |dir: &Path| refused(dir, &["fit", "data", "-o", "m.toml", "--strict"]);
    let left_out = |dir: &Path| run(dir, &["fit", "data", "-o", "m.toml", "--model", "fv"]).err;
    assert!(strict(dir).contains("b.csv: has only 2 usable samples"));
    assert!(left_out(dir).contains("b.csv: has only 2 usable samples"));
    std::fs::write(data.join("b.csv"), "").unwrap();
    assert!(strict(dir).contains("b.csv: is empty"));
    assert!(left_out(dir).contains("left out, as it is no record: data/b.csv: is empty"));
    std::fs::remove_file(dir.join("m.toml")).unwrap();
    std::fs::remove_file(data.join("b.csv")).unwrap();
    let of = |r: [f64; 4], hole: bool| if hole { row(r).replace(&format!("{:.9}", r[3]), "NaN") } else { row(r) };
    rewrite(&records, &data, HEADER, |r| of(r, true));
    let message = fit_refused(dir);
    assert!(message.contains("line 2: force is missing") && !message.contains("--ignore force"), "{message}");
    // A truncated line and a duplicate file are usable, and both are reported.
    copy();
    let cut = data.join("a15mm_v0262mm_s.csv");
    let text = std::fs::read_to_string(&cut).unwrap();
    std::fs::write(&cut, &text[..text[..text.len() / 2].rfind(',').unwrap()]).unwrap();
    std::fs::copy(data.join("a50mm_v0052mm_s.csv"), data.join("a50mm_v0052mm_s Kopie – 試験.csv")).unwrap();
    let told = run(dir, &["fit", "data", "-o", "m.toml", "--model", "fv"]);
    assert!(told.code == Some(0) && told.out.contains("a15mm_v0262mm_s: 1 of"), "{told:?}");
    assert!(told.err.contains("holds the same samples as"), "{told:?}");
    // `validate` also reports the duplicate file.
    let told = run(dir, &["validate", "m.toml", "data", "--json", "v.json"]);
    assert!(told.code == Some(0) && told.err.contains("holds the same samples as"), "{told:?}");
}

/// Fault of a single record: its name, a function that makes each row, and a text of the message. The function gets the
/// index and the values of a valid row; `None` omits the row.
type Fault = (&'static str, fn(usize, [f64; 4]) -> Option<String>, &'static str);

const FAULTS: [Fault; 7] = [
    ("short", |i, r| (i < 12).then(|| row(r)), "has only 12 usable samples"),
    ("still", |_, [t, ..]| Some(row([t, 0.0, 0.0, 0.0])), "the damper does not move"),
    ("dead", |_, [t, x, v, _]| Some(row([t, x, v, -120.0])), "force is frozen at -120"),
    ("holes", |i, r| Some(if i > 500 { row([r[0], r[1], r[2], f64::NAN]) } else { row(r) }), "force is missing"),
    ("clipped", |_, [t, x, v, f]| Some(row([t, x, v, f.min(400.0)])), "force is clipped at 400"),
    ("words", |i, r| Some(if i == 300 { row(r) + "x" } else { row(r) }), "is no number"),
    ("clock", |_, [_, x, v, f]| Some(row([7.0, x, v, f])), "time does not advance"),
];

#[test]
fn one_spoilt_test_is_named_and_left_out() {
    let folder = campaign_folder();
    let dir = folder.path();
    done(dir, &["fit", "records", "-o", "m.toml", "--model", "fv"]);
    let victim = "a15mm_v0262mm_s.csv";
    let (_, sound) = table(&dir.join("records").join(victim));
    let all = std::fs::read_dir(dir.join("records"))
        .unwrap()
        .filter(|e| e.as_ref().unwrap().path().extension().is_some_and(|e| e == "csv"))
        .count();
    for (name, fault, wanted) in FAULTS {
        rewrite(&dir.join("records"), &dir.join("data"), HEADER, row);
        let rows = sound.iter().enumerate().filter_map(|(i, r)| fault(i, [r[0], r[1], r[2], r[3]]));
        let text: String = std::iter::once(HEADER.to_owned()).chain(rows).map(|line| line + "\n").collect();
        std::fs::write(dir.join("data").join(victim), text).unwrap();
        let strict = refused(dir, &["validate", "m.toml", "data", "--strict"]);
        assert!(strict.contains(wanted) && strict.contains(victim), "{name}: {strict}");
        let ran = run(dir, &["validate", "m.toml", "data", "--json", "v.json", "--report", "v.html"]);
        let said = format!("note: left out: data/{victim}");
        assert!(ran.code == Some(0) && ran.err.contains(&said) && ran.err.contains(wanted), "{name}: {}", ran.err);
        let found = json(&dir.join("v.json"));
        assert_eq!(found["tests"].as_array().unwrap().len(), all - 1, "{name}");
        let unusable = found["unusable"].as_array().unwrap();
        let why = unusable[0]["why"].as_str().unwrap();
        assert!(unusable.len() == 1 && unusable[0]["is_test"] == true, "{name}: {unusable:?}");
        assert!(why.contains(wanted) && why.contains(victim), "{name}: {why}");
        let report = std::fs::read_to_string(dir.join("v.html")).unwrap();
        assert!(report.contains(&format!("left out: data/{victim}")), "{name}");
    }
    // `fit` and `diagnose` also report the unusable test. `diagnose` also reports one in the reference.
    let told = run(dir, &["fit", "data", "-o", "n.toml", "--model", "fv", "--json", "f.json"]);
    assert!(told.err.contains("left out: data/a15"), "{}", told.err);
    assert_eq!(json(&dir.join("f.json"))["unusable"][0]["is_test"], true);
    let args = [
        "diagnose",
        "m.toml",
        "records",
        "--reference",
        "data",
        "--max-effects",
        "1",
        "--json",
        "d.json",
        "--report",
        "d.html",
    ];
    assert!(run(dir, &args).err.contains("left out: data/a15"));
    // Both campaigns may have files of the same names, so an error in the reference begins with the option.
    std::fs::create_dir(dir.join("none")).unwrap();
    assert!(refused(dir, &["diagnose", "m.toml", "records", "--reference", "none"]).contains("--reference none: "));
    assert!(json(&dir.join("d.json"))["unusable"][0]["why"].as_str().unwrap().contains("data/a15"));
    assert!(std::fs::read_to_string(dir.join("d.html")).unwrap().contains("left out: data/a15"));
}

#[test]
fn what_most_tests_have_or_leaves_nothing_is_refused() {
    let folder = campaign_folder();
    let dir = folder.path();
    // Millimeters that are read as meters are an error, even if most tests have this fault.
    rewrite(&dir.join("records"), &dir.join("data"), HEADER, |[t, x, v, f]| row([t, 1e3 * x, 1e3 * v, f]));
    std::fs::copy(dir.join("records/a50mm_v0052mm_s.csv"), dir.join("data/a50mm_v0052mm_s.csv")).unwrap();
    let message = fit_refused(dir);
    assert!(message.contains("--unit displacement=mm"), "{message}");
    rewrite(&dir.join("records"), &dir.join("data"), HEADER, |[t, ..]| row([t, 0.0, 0.0, 0.0]));
    assert!(fit_refused(dir).contains("does not move"));
}

#[test]
fn a_few_tests_give_a_model_that_says_what_it_lacks() {
    let folder = campaign_folder();
    let dir = folder.path();
    for name in ["a50mm_v0262mm_s", "a01mm_v0052mm_s", "slow_0.0118hz"] {
        let data = format!("records/{name}.csv");
        if !dir.join(&data).exists() {
            continue;
        }
        let told = done(dir, &["fit", &data, "-o", "m.toml"]);
        assert!(told.contains("not identified: its element is off"), "{name}: {told}");
        let told = done(dir, &["validate", "m.toml", "records"]);
        assert!(told.contains("tests are faster than the FV curve reaches"), "{name}: {told}");
        done(dir, &["simulate", "m.toml", "records/a50mm_v1047mm_s.csv", "-o", "f.csv"]);
        let (_, measured) = table(&dir.join("records/a50mm_v1047mm_s.csv"));
        let (_, answered) = table(&dir.join("f.csv"));
        let peak = |rows: &[Vec<f64>]| rows.iter().fold(0.0_f64, |m, r| m.max(r[3].abs()));
        assert!(peak(&answered) < 50.0 * peak(&measured), "{name}: {}", peak(&answered));
    }
}

#[test]
fn flags_that_leave_nothing_are_refused() {
    let folder = campaign_folder();
    let dir = folder.path();
    for (more, wanted) in [
        (&["--hold-out", "*"][..], "leaves no test"),
        (&["--hold-out", "nothing*"], "matches no test"),
        (&["--elements", "magic"], "no element called"),
        (&["--ignore", "force"], "cannot be left out"),
        (&["--unit", "force"], "--unit"),
        (&["--unit", "force=parsec"], "--unit"),
        (&["--column", "force=nope"], "no column 'nope'"),
        (&["--flip", "time"], "--flip"),
        (&["--exclude", "nothing*"], "matches no file and no test"),
        (&["--exclude", "*"], "leaves no record"),
        (&["--delay", "12"], "delay of 12 s"),
        (&["--delay", "5mm"], "such as 5ms"),
        (&["--force-zero", "much"], "such as 0.12kN"),
        (&["--gain", "0"], "gain of 0"),
        (&["--json", "none/fit.json"], "there is no folder none"),
    ] {
        let message = refused(dir, &[&["fit", "records", "-o", "m.toml"], more].concat());
        assert!(message.contains(wanted), "{more:?}: {message}");
    }
    assert!(refused(dir, &["fit", "records", "-o", "none/m.toml"]).contains("make it first"));
    assert!(refused(dir, &["fit", "records", "-o", "m.csv"]).contains("name it otherwise"));
    std::fs::write(dir.join("empty.toml"), "\n").unwrap();
    assert!(refused(dir, &["check", "empty.toml"]).contains("empty.toml is empty"));
    assert!(refused(dir, &["check", "records"]).contains("it is a folder; give a file in it"));
    assert!(refused(dir, &["fit", "records", "-o", "-", "--json", "-"]).contains("one result"));
    assert!(refused(dir, &["rig", "-o", "c", "--noise", "-3"]).contains("noise"));
    assert!(refused(dir, &["rig", "-o", "c", "--sample-rate", "10"]).contains("sample rate"));
    assert!(refused(dir, &["rig", "-o", "c", "--matrix", "none.csv"]).contains("none.csv"));
    assert!(refused(dir, &["matrix", "--amplitudes", "-5"]).contains("5"));
}

/// A pipe without a writer blocks a reader forever, and `/dev/zero` never ends.
#[cfg(unix)]
#[test]
fn pipes_and_devices_are_refused_by_every_option_that_names_a_file() {
    let folder = campaign_folder();
    let dir = folder.path();
    done(dir, &["fit", "records", "--model", "fv", "-o", "m.toml"]);
    assert!(std::process::Command::new("mkfifo").arg(dir.join("pipe")).status().unwrap().success());
    std::os::unix::fs::symlink("/dev/zero", dir.join("zero")).unwrap();
    std::fs::create_dir(dir.join("piped")).unwrap();
    std::fs::copy(dir.join("m.toml"), dir.join("piped/m.toml")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(dir.join("piped/campaign.toml")).status().unwrap().success());
    let answered = |args: &[&str]| -> (Option<i32>, String) {
        let mut command = std::process::Command::new("timeout");
        let output = command.arg("30").arg(dashpot_tests::cli::program()).args(args).current_dir(dir).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    for file in ["pipe", "zero"] {
        let named = format!("{file}.toml");
        std::os::unix::fs::symlink(dir.join(file), dir.join(&named)).unwrap();
        for args in [
            &["check", &named][..],
            &["fit", "records", "-o", "n.toml", "--dimensions", &named],
            &["explain", "m.toml", "--dimensions", &named],
            &["validate", "m.toml", "records", "--limits", &named],
            &["export", "adams", "m.toml", "-o", "run", "--library", &named],
            &["rig", "-o", "c", "--matrix", &named],
        ] {
            let (code, message) = answered(args);
            assert_eq!(code, Some(2), "{args:?}: {message}");
            assert!(message.contains(&named) && message.contains("regular file"), "{args:?}: {message}");
        }
    }
    // An output is written into a folder that contains a pipe with the name campaign.toml.
    let (code, message) = answered(&["fit", "records", "--model", "fv", "-o", "piped/m.toml"]);
    assert_eq!(code, Some(0), "{message}");
    let (code, message) = answered(&["rig", "-o", "piped"]);
    assert_eq!(code, Some(2), "{message}");
}

#[test]
fn a_model_file_edited_to_nonsense_is_refused_with_line_or_parameter() {
    let folder = campaign_folder();
    let dir = folder.path();
    done(dir, &["fit", "records", "-o", "m.toml"]);
    let text = std::fs::read_to_string(dir.join("m.toml")).unwrap();
    // With `-o -`, the model file goes to standard output.
    assert_eq!(done(dir, &["fit", "records", "-o", "-"]), text);
    let gas = text.lines().find(|l| l.starts_with("gas_force")).unwrap();
    for (from, to, wanted) in [
        (gas, "gas_force = \"much\"", "line"),
        (gas, "gas_force = nan", "line"),
        (gas, "gas_force = 1e400", "line"),
        (gas, "gas_force = 1e9", "gas_force"),
        (gas, "gass_force = 150", "did you mean gas_force?"),
        ("format = 1", "format = 9", "format = 1"),
        ("fv_force = [", "fv_force = [1.0, ", "fv_force"),
        ("elements = [", "elements = [\"magic\", ", "line"),
        ("\n[identification]\n", "\n[identification\n", "line"),
        ("[identification.fv_only]", "[identification.fv_only]\nvelocity = 1", "line"),
    ] {
        assert!(text.contains(from), "{from}");
        std::fs::write(dir.join("bad.toml"), text.replacen(from, to, 1)).unwrap();
        let message = refused(dir, &["validate", "bad.toml", "records", "--json", "v.json"]);
        assert!(message.contains("bad.toml") && message.contains(wanted), "{to}: {message}");
    }
    for (bytes, wanted) in [(&b""[..], "bad.toml is empty"), (b"\xff\xfe\x00binary", "UTF-8")] {
        std::fs::write(dir.join("bad.toml"), bytes).unwrap();
        assert!(refused(dir, &["validate", "bad.toml", "records"]).contains(wanted));
    }
    // A model file without elements is a valid damper without force.
    std::fs::write(dir.join("off.toml"), "format = 1\nelements = []\n").unwrap();
    done(dir, &["validate", "off.toml", "records", "--json", "v.json"]);
    let overall = &json(&dir.join("v.json"))["overall"];
    assert!(overall["error_percent"].as_f64() > overall["fv_only"]["error_percent"].as_f64());
}

#[test]
fn what_is_no_record_is_refused() {
    let folder = campaign_folder();
    let dir = folder.path();
    for name in ["noise.csv", "noise.xlsx", "noise.mat", "noise.pdf"] {
        std::fs::write(dir.join(name), (0..4000_u32).map(|i| (i * i / 7 % 251) as u8).collect::<Vec<_>>()).unwrap();
        assert!(refused(dir, &["fit", name, "-o", "m.toml"]).contains(name));
        assert!(refused(dir, &["simulate", "records/a50mm_v0052mm_s.csv", name, "-o", "f.csv"]).contains("line 1"));
    }
    assert!(refused(dir, &["fit", "nowhere", "-o", "m.toml"]).contains("no such file"));
}
