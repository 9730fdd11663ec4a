//! Tests that files with date and time form one campaign on a common clock. The fit then finds a drift of the force
//! channel over the campaign.

use dashpot_records::clock::{seconds, written};
use dashpot_tests::cli::{campaign_folder, done, run, table};
use std::path::Path;

/// Drift of the zero of the force channel, N/s.
const DRIFT: f64 = 0.006;

/// Writes the records as a German rig does, twelve minutes apart, each with its own time from zero on, and adds
/// [`DRIFT`] to the force.
///
/// If `dated` is true, each file begins with a header that contains the date and time of the first row.
fn measured(from: &Path, to: &Path, dated: bool) {
    std::fs::create_dir_all(to).unwrap();
    let mut files: Vec<_> = std::fs::read_dir(from).unwrap().map(|e| e.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == "csv"));
    files.sort();
    // The order of the start times differs from the order of the file names, so that a sort by name is detected.
    let count = files.len();
    for (k, path) in files.iter().enumerate() {
        let start = 720.0 * ((5 * k + 3) % count) as f64;
        let at = written(seconds("2026-11-25 23:55:10").unwrap() + start);
        let (date, time) = at.split_once(' ').unwrap();
        let [year, month, day] = date.split('-').collect::<Vec<_>>()[..] else { panic!("{date}") };
        let mut text = if dated { format!("Datum;{day}.{month}.{year}\nUhrzeit;{time}\n\n") } else { String::new() };
        text += "Zeit [s];Weg [mm];Kraft [N]\n";
        for r in table(path).1 {
            let force = r[3] + DRIFT * (start + r[0]);
            text += &format!("{:.6};{:.5};{force:.3}\n", r[0], 1e3 * r[1]).replace('.', ",");
        }
        std::fs::write(to.join(path.file_name().unwrap()), text).unwrap();
    }
}

#[test]
fn a_drift_over_files_with_date_and_time_is_found_and_taken_out_of_a_part_of_them_too() {
    let folder = campaign_folder();
    let dir = folder.path();
    measured(&dir.join("records"), &dir.join("dated"), true);
    measured(&dir.join("records"), &dir.join("plain"), false);
    let fitted = run(dir, &["fit", "dated", "-o", "m.toml"]);
    let said = fitted.out + &fitted.err;
    assert!(said.contains("on one clock by the date and time that their files bear, from 2026-11-25 23:55:"), "{said}");
    let model: toml::Table = std::fs::read_to_string(dir.join("m.toml")).unwrap().parse().unwrap();
    let of_the_fit = &model["identification"];
    assert!(of_the_fit["clock_from"].as_str().unwrap().starts_with("2026-11-25 23:55:"));
    let drift = of_the_fit["measurement"]["drift"][0].as_float().unwrap();
    assert!((drift / DRIFT - 1.0).abs() < 0.1, "{drift}");
    // Copy the campaign without the file that was measured first.
    std::fs::create_dir(dir.join("part")).unwrap();
    for entry in std::fs::read_dir(dir.join("dated")).unwrap().map(|e| e.unwrap()) {
        let text = std::fs::read_to_string(entry.path()).unwrap();
        if !text.starts_with("Datum;25.11.2026\nUhrzeit;23:5") {
            std::fs::write(dir.join("part").join(entry.file_name()), text).unwrap();
        }
    }
    let error = |data: &str| {
        done(dir, &["validate", "m.toml", data, "--json", "v.json"]);
        dashpot_tests::cli::json(&dir.join("v.json"))["overall"]["mean_error_n"].as_f64().unwrap()
    };
    let (whole, part) = (error("dated"), error("part"));
    assert!(part < 1.5 * whole, "{part} of {whole}");
    // Without a common clock the drift is not identifiable, and a remark says so.
    let fitted = run(dir, &["fit", "plain", "-o", "p.toml"]);
    assert!(!std::fs::read_to_string(dir.join("p.toml")).unwrap().contains("\ndrift ="));
    assert!((fitted.out + &fitted.err).contains("another constant force of each test"));
}
