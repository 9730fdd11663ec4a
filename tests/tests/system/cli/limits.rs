//! Tests of the option `--limits`: a damper that passes, a damper that fails, and limits that cannot be tested.

use dashpot_tests::cli::{campaign_folder, done, json, refused, run};
use std::fs;
use std::path::Path;

/// Fits the FV curve alone to the records, because this fit is fast.
fn model(dir: &Path) {
    done(dir, &["fit", "records", "-o", "m.toml", "--model", "fv"]);
}

/// Returns the velocity, m/s, and the measured force, N, of the peak in `v.json` whose velocity is nearest to
/// `velocity`, m/s.
fn peak(dir: &Path, velocity: f64) -> [f64; 2] {
    let figures = json(&dir.join("v.json"));
    let peaks = figures["tests"].as_array().unwrap().iter().flat_map(|t| t["peaks"].as_array().unwrap().clone());
    let of = |p: &serde_json::Value| [p["velocity_m_s"].as_f64().unwrap(), p["force_n"]["measured"].as_f64().unwrap()];
    peaks.map(|p| of(&p)).min_by(|a, b| (a[0] - velocity).abs().total_cmp(&(b[0] - velocity).abs())).unwrap()
}

#[test]
fn a_damper_passes_or_fails_by_its_windows() {
    let folder = campaign_folder();
    let dir = folder.path();
    model(dir);
    done(dir, &["validate", "m.toml", "records", "--json", "v.json"]);
    let ([vr, fr], [vc, fc]) = (peak(dir, 1.047), peak(dir, -1.047));
    let windows = |width: f64| {
        format!(
            "name,quantity,velocity_m_s,nominal,tolerance,low,high\nR1,force,{vr},{fr},{width} %,,\nC1,force,{vc},{fc},{width} %,,\n\
             ,friction,,,,0,500\n,gas_force,,,,-1000,1000\n,hysteresis,{vr},,,,1000\n"
        )
    };
    fs::write(dir.join("l.csv"), windows(10.0)).unwrap();
    let args = ["validate", "m.toml", "records", "--limits", "l.csv", "--json", "c.json", "--certificate", "c.html"];
    let passed = run(dir, &args);
    assert_eq!(passed.code, Some(0), "{passed:?}");
    assert!(passed.out.contains("PASS: all 5 limits are kept"), "{}", passed.out);
    assert_eq!(json(&dir.join("c.json"))["limits"]["passed"], true);
    let page = fs::read_to_string(dir.join("c.html")).unwrap();
    assert!(
        page.contains("PASS. The damper keeps all limits (5).") && page.contains("l.csv") && page.contains("SHA-256")
    );
    assert_eq!(run(dir, &args).code, Some(0));
    assert!(fs::read_to_string(dir.join("c.html")).unwrap() == page, "the same bytes");
    // With a nominal force of 1.3 times the measured one, the damper violates the limit in rebound. The exit code is 1,
    // and the message counts the violated limits.
    fs::write(dir.join("l.csv"), windows(10.0).replace(&format!("{fr},10 %"), &format!("{},10 %", 1.3 * fr))).unwrap();
    let german = [&args[..], &["--report", "r.html", "--language", "de", "--date", "2024-05-17"]].concat();
    let failed = run(dir, &german);
    assert_eq!(failed.code, Some(1), "{failed:?}");
    assert!(failed.out.contains("FAIL: 1 of 5 limits is not kept"), "{}", failed.out);
    let report = fs::read_to_string(dir.join("r.html")).unwrap();
    assert!(
        report.contains("NICHT BESTANDEN. Der Dämpfer hält 1 von 5 Grenzwerten nicht ein.")
            && report.contains("2024-05-17")
    );
    // A limit at a velocity without a test neither passes nor fails.
    fs::write(dir.join("l.csv"), "quantity,velocity_m_s,low,high\nforce,9,0,1e6\n").unwrap();
    let untested = run(dir, &args);
    assert!(untested.code == Some(1) && untested.out.contains("NOT TESTED"), "{untested:?}");
    assert!(untested.out.contains("INCOMPLETE: the one limit could not be tested"), "{}", untested.out);
    assert!(!untested.out.contains("FAIL") && json(&dir.join("c.json"))["limits"]["overall"] == "incomplete");
    assert!(passed.out.contains("interpolated linearly between two tests"), "{}", passed.out);
}

#[test]
fn mistakes_in_limits_are_told_before_any_work() {
    let folder = campaign_folder();
    let dir = folder.path();
    model(dir);
    fs::write(dir.join("l.csv"), "quantity,velocity_m_s,low,high\nforce,-0.5,100,200\n").unwrap();
    let told = refused(dir, &["validate", "m.toml", "records", "--limits", "l.csv", "--certificate", "c.html"]);
    assert!(told.contains("l.csv, line 2") && told.contains("compression"), "{told}");
    assert!(refused(dir, &["validate", "m.toml", "records", "--limits", "none.csv"]).contains("none.csv"));
    assert!(refused(dir, &["validate", "m.toml", "records", "--certificate", "c.html"]).contains("--limits"));
    assert!(refused(dir, &["validate", "m.toml", "records", "--language", "it"]).contains("en, de, fr and zh"));
}

#[test]
fn a_table_of_peaks_starts_a_model() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    fs::write(
        dir.join("pvp.csv"),
        "Velocity [mm/s],Rebound [N],Compression [N]\n100,350,-290\n500,1100,-700\n1000,1900,-1000\n",
    )
    .unwrap();
    done(dir, &["import", "peaks", "pvp.csv", "-o", "m.toml", "--gas-force", "100", "--friction", "40"]);
    let signed = "velocity_m_s,force_N\n-0.5,-1100\n0.5,700\n";
    fs::write(dir.join("signed.csv"), signed).unwrap();
    let told = done(dir, &["import", "peaks", "signed.csv", "-o", "s.toml"]);
    assert!(told.contains("positive velocities and forces taken as rebound"), "{told}");
    assert!(told.contains("0.64 times") && told.contains("give --positive compression"), "{told}");
    let told = done(dir, &["import", "peaks", "signed.csv", "-o", "s.toml", "--positive", "compression"]);
    assert!(told.contains("negative velocities and forces taken as rebound, as given"), "{told}");
    assert!(told.contains("1.57 times") && !told.contains("Most dampers"), "{told}");
    fs::write(dir.join("motion.csv"), motion()).unwrap();
    done(dir, &["simulate", "m.toml", "motion.csv", "-o", "f.csv"]);
    let (_, rows) = dashpot_tests::cli::table(&dir.join("f.csv"));
    // At a constant 0.5 m/s, the model returns the force of the imported table. The import subtracts friction and gas
    // force, and the model adds them again.
    let last = rows.last().and_then(|row| row.last()).unwrap();
    assert!((last - 1100.0).abs() < 2.0, "{last}");
    fs::write(dir.join("pvp.csv"), "velocity_m_s,force_N\n0.1,300\n0.5,250\n-0.1,-300\n").unwrap();
    let told = refused(dir, &["import", "peaks", "pvp.csv", "-o", "n.toml"]);
    assert!(told.contains("pvp.csv, line 3") && told.contains("weaker"), "{told}");
}

#[test]
fn a_table_of_a_dyno_is_told_as_understood() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    fs::write(dir.join("dyno.csv"), "V-C,C,V-R,R\n2,45,2,60\n10,90,10,200\n").unwrap();
    let told = refused(dir, &["import", "peaks", "dyno.csv", "-o", "m.toml"]);
    assert!(told.contains("line 1: no unit is known of 'V-C'") && told.contains("--unit velocity="), "{told}");
    let given = ["import", "peaks", "dyno.csv", "-o", "m.toml", "--unit", "velocity=in/s", "--unit", "force=lbf"];
    let told = done(dir, &given);
    assert!(
        told.contains("compression from 'C' in lbf over 'V-C' in in/s, rebound from 'R' in lbf over 'V-R' in in/s"),
        "{told}"
    );
    assert!(told.contains("as the headings name them") && told.contains("2.22 times"), "{told}");
    let told = refused(dir, &["import", "peaks", "dyno.csv", "-o", "m.toml", "--unit", "velocity=lbf"]);
    assert!(told.contains("lbf is no unit of velocity") && told.contains("in/s"), "{told}");
    let told = refused(dir, &["import", "peaks", "dyno.csv", "-o", "m.toml", "--column", "rebound=R"]);
    assert!(told.contains("rebound_force"), "{told}");
}

/// Makes the text of a motion file: half a second at 0.5 m/s, at 1 kHz.
fn motion() -> String {
    let row = |i: i32| format!("{},{},0.5\n", 1e-3 * f64::from(i), 0.5e-3 * f64::from(i));
    "time_s,displacement_m,velocity_m_s\n".to_owned() + &(0..500).map(row).collect::<String>()
}
