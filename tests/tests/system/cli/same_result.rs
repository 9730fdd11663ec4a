//! Tests that the result for a campaign is independent of the number of threads, and of signs, units and number format
//! in the files.

use dashpot_tests::cli::{contents, done, json, rewrite, run_with, small_campaign};
use serde_json::Value;
use std::path::Path;

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    small_campaign(dir);
    for verb in [
        &["rig", "-o", "again", "--matrix", "small.csv", "--seed", "3"][..],
        &["fit", "records", "-o", "m.toml", "--json", "fit.json"],
        &["validate", "m.toml", "records", "--json", "v.json", "--report", "r.html"],
    ] {
        let with = |threads: &str| {
            let ran = run_with(dir, verb, &[("RAYON_NUM_THREADS", threads)]);
            assert_eq!(ran.code, Some(0), "{}", ran.err);
            (ran.out, contents(dir))
        };
        assert!(with("1") == with("2"), "{verb:?}");
    }
}

/// Returns the estimates of a fit from its JSON: name with index, value, and the width of the interval (0 without an
/// interval).
fn estimates(path: &Path) -> Vec<(String, f64, f64)> {
    let parameters = json(path)["parameters"].as_array().unwrap().clone();
    let of = |p: &Value| {
        let width = match (p["low"].as_f64(), p["high"].as_f64()) {
            (Some(low), Some(high)) => high - low,
            _ => 0.0,
        };
        (format!("{} {}", p["name"], p["index"]), p["value"].as_f64().unwrap(), width)
    };
    parameters.iter().map(of).collect()
}

#[test]
fn signs_units_and_spelling_of_the_file_do_not_matter() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    small_campaign(dir);
    let records = dir.join("records");
    let plain = |v: f64, digits: usize| format!("{v:.digits$}");
    let comma = |v: f64, digits: usize| plain(v, digits).replace('.', ",");
    rewrite(&records, &dir.join("compression"), "time_s,displacement_m,velocity_m_s,force_N", |[t, x, v, f]| {
        [plain(t, 6), plain(-x, 7), plain(-v, 7), plain(-f, 3)].join(",")
    });
    rewrite(&records, &dir.join("units"), "Time [ms];Stroke [mm];Speed [mm/s];Load Cell [kN]", |[t, x, v, f]| {
        [comma(1e3 * t, 3), comma(1e3 * x, 4), comma(1e3 * v, 4), comma(1e-3 * f, 6)].join(";")
    });
    let fit = |data: &str, more: &[&str]| {
        let name = format!("{data}.json");
        done(dir, &[&["fit", data, "-o", "m.toml", "--json", &name], more].concat());
        estimates(&dir.join(name))
    };
    let reference = fit("records", &[]);
    for other in [fit("compression", &[]), fit("compression", &["--positive", "compression"]), fit("units", &[])] {
        assert_eq!(reference.len(), other.len());
        for ((name, a, width), (other_name, b, _)) in reference.iter().zip(&other) {
            assert_eq!(name, other_name);
            assert!((a - b).abs() <= 0.01 * width + 1e-4 * a.abs(), "{name}: {a} {b}");
        }
    }
}
