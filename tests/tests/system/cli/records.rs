//! Tests of `dashpot` with records as rigs write them: profiles, delayed channels, gaps, and one file with two paths.

use dashpot_tests::cli::{HEADER, campaign_folder, done, json, refused, rewrite, row, run, table};
use std::fs;
use std::path::Path;

fn tests(dir: &Path, data: &[&str]) -> usize {
    let args = [&["fit", "-o", "m.toml", "--model", "fv", "--json", "f.json"], data].concat();
    done(dir, &args);
    json(&dir.join("f.json"))["tests"].as_array().unwrap().len()
}

#[test]
fn a_mapping_is_said_once_and_every_verb_obeys_it() {
    let folder = campaign_folder();
    let dir = folder.path();
    let german = "Zeit [s];Kolbenweg;Kanal 7;Kraft";
    rewrite(&dir.join("records"), &dir.join("data"), german, |[t, x, _, f]| {
        format!("{t:.6};{:.6};1;{:.6}", -1e3 * x, -1e-3 * f).replace('.', ",")
    });
    fs::write(dir.join("data/warmup.csv"), fs::read(dir.join("data/a50mm_v0262mm_s.csv")).unwrap()).unwrap();
    fs::write(dir.join("data/Notizen.txt"), "Montag\n").unwrap();
    // Without a profile of columns and units, the message names the missing unit and its flag.
    assert!(refused(dir, &["fit", "data", "-o", "m.toml"]).contains("--unit displacement=mm"));
    let said = [
        "import-profile",
        "data",
        "--column",
        "time=zeit",
        "--column",
        "displacement=2",
        "--unit",
        "displacement=mm",
        "--unit",
        "force=kN",
        "--positive",
        "compression",
        "--exclude",
        "warm*",
    ];
    done(dir, &said);
    let text = fs::read_to_string(dir.join("data/campaign.toml")).unwrap();
    for wanted in ["positive = \"compression\"", "force = \"kN\"", "displacement = \"2\"", "warm*"] {
        assert!(text.contains(wanted), "{text}");
    }
    assert_eq!(tests(dir, &["data"]), tests(dir, &["records"]));
    let fit = run(dir, &["fit", "data", "-o", "a.toml", "--model", "fv"]);
    assert!(fit.err.contains("Notizen.txt") && fit.err.contains("read as data/campaign.toml says"), "{}", fit.err);
    done(dir, &["validate", "a.toml", "data", "--json", "v.json"]);
    // The displacements that are read with the profile equal those of the original records.
    done(dir, &["simulate", "a.toml", "data/a50mm_v0262mm_s.csv", "-o", "f1.csv"]);
    done(dir, &["simulate", "a.toml", "records/a50mm_v0262mm_s.csv", "-o", "f2.csv", "--ignore", "velocity"]);
    let (one, two) = (table(&dir.join("f1.csv")).1, table(&dir.join("f2.csv")).1);
    assert!(one.len() == two.len() && one.iter().zip(&two).all(|(a, b)| (a[1] - b[1]).abs() < 1e-8));
    // A message names a wrong key of the profile.
    fs::write(dir.join("data/campaign.toml"), text.replace("units", "unist")).unwrap();
    assert!(refused(dir, &["fit", "data", "-o", "m.toml"]).contains("unist"));
}

#[test]
fn one_file_by_two_paths_is_one_test() {
    let folder = campaign_folder();
    let dir = folder.path();
    let (a, b) = ("records/a50mm_v0262mm_s.csv", "./records/../records/a50mm_v0262mm_s.csv");
    assert_eq!(tests(dir, &[a, b]), 1);
    assert_eq!(tests(dir, &["records", "./records", a]), tests(dir, &["records"]));
}

#[test]
fn a_late_force_is_told_and_corrected() {
    let folder = campaign_folder();
    let dir = folder.path();
    let late = 0.015;
    fs::create_dir(dir.join("data")).unwrap();
    for entry in fs::read_dir(dir.join("records")).unwrap() {
        let path = entry.unwrap().path();
        let rows = table(&path).1;
        let mut text = format!("{HEADER}\n");
        // The force channel is delayed by `late` seconds: its value is the force, linearly interpolated, at the time
        // `late` seconds earlier.
        let mut k = 0;
        for r in &rows {
            while k + 2 < rows.len() && rows[k + 1][0] <= r[0] - late {
                k += 1;
            }
            let share = ((r[0] - late - rows[k][0]) / (rows[k + 1][0] - rows[k][0])).clamp(0.0, 1.0);
            text += &row([r[0], r[1], r[2], rows[k][3] + share * (rows[k + 1][3] - rows[k][3])]);
            text.push('\n');
        }
        fs::write(dir.join("data").join(path.file_name().unwrap()), text).unwrap();
    }
    let fit = |more: &[&str]| run(dir, &[&["fit", "data", "-o", "m.toml", "--model", "fv"], more].concat()).err;
    let told = fit(&[]);
    let delay: f64 = told.split("--delay ").nth(1).expect(&told).split_whitespace().next().unwrap().parse().unwrap();
    assert!((delay - late).abs() < 2e-3, "{told}");
    assert!(!fit(&["--delay", "0.015"]).contains("--delay"));
}

#[test]
fn a_gap_in_time_is_said_first_and_split() {
    let folder = campaign_folder();
    let dir = folder.path();
    let data = dir.join("data");
    rewrite(&dir.join("records"), &data, HEADER, row);
    let file = data.join("a50mm_v0052mm_s.csv");
    let rows = table(&file).1;
    let mut text = format!("{HEADER}\n");
    for (i, r) in rows.iter().enumerate() {
        let pause = if 2 * i > rows.len() { 60.0 } else { 0.0 };
        text += &row([r[0] + pause, r[1], r[2], r[3]]);
        text.push('\n');
    }
    fs::write(&file, text).unwrap();
    let ran = run(dir, &["fit", "data", "-o", "m.toml", "--model", "fv"]);
    assert!(ran.err.starts_with("note: data/a50mm_v0052mm_s.csv: gaps in time: 60."), "{}", ran.err);
    assert_eq!(tests(dir, &["data"]), tests(dir, &["records"]) + 1);
}
