//! Tests of the subcommands of `dashpot` for an adjustable damper, on synthetic campaigns of a damper with known
//! parameters.

use dashpot_core::Params;
use dashpot_core::family::axis::ENTRIES;
use dashpot_core::family::{Axis, Definition};
use dashpot_core::{element, list, number};
use dashpot_tests::cli::{done, json, number, refused, run, run_with, table};
use dashpot_tests::kernel_campaign::{self, Sine};
use std::fmt::Write as _;
use std::path::Path;

const CURRENTS: [f64; 3] = [0.0, 0.6, 1.2];

/// Makes a damper whose FV curve grows linearly with the current.
fn damper() -> Definition {
    let mut params: Params = kernel_campaign::base();
    let mut axis = Axis::NONE;
    axis.set_grid(&CURRENTS).unwrap();
    let soft = params.list(list!("fv_force")).to_vec();
    for (index, current) in CURRENTS.iter().enumerate() {
        let forces: Vec<f64> = soft.iter().map(|force| force * (0.5 + current)).collect();
        axis.set_forces(index, &forces).unwrap();
    }
    axis.put(&mut params, 0.0);
    Definition { params, axis }
}

/// Writes the records of [`damper`] at a current, A. The names of the records end with `suffix`.
fn write(folder: &Path, current: f64, suffix: &str) {
    write_of(&damper().params_at(current), folder, suffix, 7);
}

/// Writes the synthetic records of a damper with the parameters `params`. The names of the records end with `suffix`.
fn write_of(params: &Params, folder: &Path, suffix: &str, seed: u64) {
    std::fs::create_dir_all(folder).unwrap();
    let sines = [(0.02, 0.04), (0.02, 1.0), (0.02, 4.0), (0.004, 12.0)].map(|(a, f)| Sine::new(a, f));
    let records = kernel_campaign::campaign(params, &sines, seed, 0.01);
    for (record, sine) in records.iter().zip(sines) {
        let mut text = String::from("time_s,displacement_m,force_N\n");
        for ((t, x), f) in record.time.iter().zip(&record.displacement).zip(&record.force) {
            let _ = writeln!(text, "{t:.6},{x:.9},{f:.3}");
        }
        let name = format!("{}mm_{}Hz{suffix}.csv", 1e3 * sine.amplitude, sine.frequency);
        std::fs::write(folder.join(name), text).unwrap();
    }
}

#[test]
fn a_family_is_fitted_validated_and_simulated() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    for current in CURRENTS {
        write(&dir.join("rig"), current, &format!("_{current}A"));
    }
    write(&dir.join("between"), 0.9, "");
    let fit = ["fit", "rig", "--setting", "current", "-o", "family.toml", "--json", "fit.json", "--report", "fit.html"];
    let ran = run(dir, &fit);
    assert_eq!(ran.code, Some(0), "{ran:?}");
    assert!(!ran.err.contains("one model holds one"), "{}", ran.err);
    for words in ["depends on current", "shared by all settings", "family without it", "0.6 A"] {
        assert!(ran.out.contains(words), "{words}: {}", ran.out);
    }
    let again = ["fit", "rig", "--setting", "current", "-o", "again.toml"];
    assert_eq!(run_with(dir, &again, &[("RAYON_NUM_THREADS", "1")]).code, Some(0));
    let written = |name: &str| std::fs::read_to_string(dir.join(name)).unwrap();
    assert!(written("family.toml") == written("again.toml"), "one thread and as many as there are");
    let found = json(&dir.join("fit.json"));
    assert_eq!(found["setting"]["grid"].as_array().unwrap().len(), 3);
    let settings = found["settings"].as_array().unwrap();
    assert!(number(&settings[1], "left_out_ratio") < 1.3, "{settings:?}");
    assert!(settings[0].get("left_out").is_none());
    let of = |name: &str| {
        let all = found["depends_on_setting"].as_array().unwrap();
        all.iter().find(|of| of["name"] == name).unwrap_or_else(|| panic!("{name}: {all:?}"))["varies"].clone()
    };
    assert_eq!((of("fv_force"), of("gas_force")), (true.into(), false.into()));

    // The validation has one entry for each setting of the records.
    done(dir, &["validate", "family.toml", "rig", "--json", "rig.json", "--report", "rig.html"]);
    let validation = json(&dir.join("rig.json"));
    let settings = validation["settings"].as_array().unwrap();
    assert_eq!(settings.len(), 3);
    for of in settings {
        assert!(of["is_of_grid"] == true && number(of, "error_percent") < 2.0, "{of}");
    }
    let report = std::fs::read_to_string(dir.join("rig.html")).unwrap();
    assert!(report.contains("Force at constant velocity, by setting") && report.contains("1.2 A"));
    // In a report, the sections of curves, errors and loops over the setting come first; the other sections are
    // collapsed.
    for name in ["rig.html", "fit.html"] {
        let page = std::fs::read_to_string(dir.join(name)).unwrap();
        let body = page.split("<main>").nth(1).unwrap();
        let at = |text: &str| body.find(text).unwrap_or_else(|| panic!("{name} has no {text}"));
        let first =
            ["by setting", "Force over the setting", "Ratio of hardest", "<table", "id=\"setting-loops\"", "<details"];
        let places: Vec<usize> = first.iter().map(|text| at(text)).collect();
        assert!(places.is_sorted(), "{name}: {places:?}");
        assert!(at("gas_force") < at("<table") && at("id=\"single-tests\"") > at("<details"), "{name}");
        assert_eq!(body.contains("fit of it alone"), name == "fit.html", "{name}");
    }
    let message = refused(dir, &["fit", "rig", "-o", "one.toml", "--report", "one.html"]);
    assert!(message.contains("--setting"), "{message}");

    // The records contain no setting, so `validate` requires `--setting`. Their true setting lies between the grid
    // values of the model.
    let message = refused(dir, &["validate", "family.toml", "between", "--json", "b.json"]);
    assert!(message.contains("--setting") && message.contains("4mm_12Hz"), "{message}");
    done(dir, &["validate", "family.toml", "between", "--setting", "0.9", "--json", "b.json"]);
    let between = json(&dir.join("b.json"));
    let of = &between["settings"][0];
    assert!(of["is_of_grid"] == false && number(of, "error_percent") < 2.0, "{of}");
    done(dir, &["validate", "family.toml", "between", "--setting", "0", "--json", "wrong.json"]);
    assert!(number(&json(&dir.join("wrong.json"))["settings"][0], "error_percent") > 10.0);

    // Without `--setting`, the simulation uses the start setting of the model file, and reports this.
    let motion = std::fs::read_dir(dir.join("between")).unwrap().next().unwrap().unwrap().path();
    let simulate = ["simulate", "family.toml", motion.to_str().unwrap(), "-o", "force.csv"];
    assert!(done(dir, &simulate).contains("at the start setting of family.toml, 0;"));
    assert!(!done(dir, &[&simulate[..], &["--setting", "0.9"]].concat()).contains("start setting"));

    // `dashpot setting` writes the model at one setting, which the other subcommands accept. The file contains the
    // intervals, and the fit of the FV curve alone, which the export of a property file needs.
    done(dir, &["setting", "family.toml", "0.9A", "-o", "at.toml"]);
    let at = dashpot_identification::model_file::read(&dir.join("at.toml")).unwrap();
    assert!(at.identification.intervals.contains_key("gas_force") && at.identification.fv_only.is_some());
    assert!(
        done(dir, &["export", "dpr", "at.toml", "-o", "at.dpr"]).contains("plain FV curve fitted to the same tests")
    );
    let message = refused(dir, &["setting", "family.toml", "9bar", "-o", "at.toml"]);
    assert!(message.contains("counted in A"), "{message}");
    done(dir, &["validate", "at.toml", "between", "--json", "at.json"]);
    let same = number(&json(&dir.join("at.json"))["overall"], "mean_error_n");
    assert!((same - number(&between["overall"], "mean_error_n")).abs() < 1e-6);
}

#[test]
fn a_campaign_without_a_setting_is_refused_and_a_profile_gives_one() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    for (current, name) in [(0.0, "_soft"), (1.2, "_hard")] {
        write(&dir.join("rig"), current, name);
    }
    let message = refused(dir, &["fit", "rig", "--setting", "current", "-o", "family.toml"]);
    assert!(message.contains("no test says its current") && message.contains("campaign.toml"), "{message}");
    let profile = "format = \"dashpot campaign profile 1\"\nsetting = \"current\"\nsetting_unit = \"A\"\n\
                   [settings]\n\"*_soft\" = 0.0\n\"*_hard\" = 1.2\n";
    std::fs::write(dir.join("rig/campaign.toml"), profile).unwrap();
    let ran = run(dir, &["fit", "rig", "--setting", "current", "-o", "family.toml"]);
    assert_eq!(ran.code, Some(0), "{ran:?}");
    let file = std::fs::read_to_string(dir.join("family.toml")).unwrap();
    assert!(file.contains("setting = [0.0, 1.2]") && file.contains("setting_name = \"current\""), "{file}");
    // Tests at several settings are fitted as one damper only on request.
    let message = refused(dir, &["fit", "rig", "-o", "one.toml"]);
    assert!(message.contains("2 settings of current") && message.contains("--setting none"), "{message}");
    assert!(!dir.join("one.toml").exists());
    let ran = run(dir, &["fit", "rig", "--setting", "none", "-o", "one.toml"]);
    assert!(ran.code == Some(0) && ran.err.contains("2 settings of current"), "{ran:?}");
    // One setting alone is an ordinary damper.
    done(dir, &["fit", "rig", "--hold-out", "*_soft", "-o", "hard.toml"]);
    let message = refused(dir, &["fit", "rig", "--setting", "clicks", "-o", "other.toml"]);
    assert!(message.contains("a setting called current"), "{message}");
}

/// Writes the family of [`damper`] as a model file.
fn write_model(path: &Path) {
    write_definition(path, &damper());
}

fn write_definition(path: &Path, damper: &Definition) {
    std::fs::write(path, dashpot_identification::model_file::flat_family(damper, |_| String::new())).unwrap();
}

#[test]
fn a_family_is_diagnosed_at_each_of_its_settings() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    // The records come from one damper of the virtual rig, so the settings have no effect. The model lacks dry
    // friction.
    done(dir, &["matrix", "--amplitudes", "50,1", "--peak-velocities", "52,262,1047", "-o", "small.csv"]);
    for (seed, current) in ["3", "4", "5"].iter().zip(CURRENTS) {
        done(dir, &["rig", "-o", &format!("rig/{current}A"), "--matrix", "small.csv", "--seed", seed]);
    }
    let poor = ["--elements", "fv_curve,series_compliance,gas_preload", "-o", "poor.toml"];
    done(dir, &[&["fit", "rig", "--subfolders", "--setting", "current"][..], &poor].concat());
    let options = ["--subfolders", "--candidates", "coulomb_friction,presliding_friction"];
    let verb = ["diagnose", "poor.toml", "rig", "--json", "d.json", "--report", "d.html", "--excel", "d.xlsx"];
    let said = done(dir, &[&verb[..], &options].concat());
    // A finding common to all settings is reported once.
    assert_eq!(said.matches("at every setting this damper shows presliding_friction").count(), 1, "{said}");
    let found = json(&dir.join("d.json"));
    let settings = found["settings"].as_array().unwrap();
    assert_eq!(settings.len(), CURRENTS.len());
    for (of, current) in settings.iter().zip(CURRENTS) {
        assert_eq!(of["setting"], current);
        assert_eq!(of["findings"][0]["effect"], "presliding_friction", "{of}");
        assert!(of["inventory"].is_array() && of["over_whole_records"].is_object(), "{of}");
    }
    let effects = found["effects"].as_array().unwrap();
    let friction = effects.iter().find(|of| of["effect"] == "presliding_friction").unwrap();
    assert!(friction["at_all_settings"] == true && friction["settings"].as_array().unwrap().len() == 3, "{friction}");
    let page = std::fs::read_to_string(dir.join("d.html")).unwrap();
    assert!(page.contains("id=\"settings\"") && page.contains("id=\"setting-3\"") && page.contains("<details"));

    // The diagnosis at one setting equals the diagnosis of the ordinary damper at this setting.
    done(dir, &["setting", "poor.toml", "0.6", "-o", "one.toml"]);
    done(dir, &["diagnose", "one.toml", "rig/0.6A", "--candidates", options[2], "--json", "one.json"]);
    let one = json(&dir.join("one.json"));
    for key in ["findings", "inventory"] {
        let effects = |of: &serde_json::Value| -> Vec<serde_json::Value> {
            of[key].as_array().unwrap().iter().map(|of| of["effect"].clone()).collect()
        };
        assert_eq!(effects(&one), effects(&settings[1]), "{key}");
    }
    // Two settings suffice for the rest.
    std::fs::rename(dir.join("rig/1.2A"), dir.join("1.2A")).unwrap();
    // With the diagnosed records as reference, the diagnosis reports no change.
    let same = [&["diagnose", "poor.toml", "rig", "--reference", "rig", "--json", "same.json"][..], &options].concat();
    let said = done(dir, &same);
    assert!(said.contains("at any setting") && said.contains("value for value, are in the reference"), "{said}");
    let missing = refused(dir, &[&["diagnose", "poor.toml", "rig", "--reference", "rig/0A"][..], &options].concat());
    assert!(missing.contains("--reference") || missing.contains("does not say its current"), "{missing}");

    // Without a model file, the diagnosis fits a model over all settings to the records.
    let alone = ["diagnose", "rig", "--setting", "current", "--json", "a.json"];
    done(dir, &[&alone[..], &options].concat());
    assert_eq!(json(&dir.join("a.json"))["settings"].as_array().unwrap().len(), 2);
}

/// Checks the messages about a setting between two settings of the model, and about a setting outside of the grid.
#[test]
fn an_interpolated_setting_is_called_interpolated() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    write_model(&dir.join("family.toml"));
    let at = |setting: &str| run(dir, &["setting", "family.toml", setting, "-o", "one.toml"]).err;
    assert!(at("0.9").contains("0.9 lies between the settings 0.6 and 1.2"), "{}", at("0.9"));
    assert!(!at("0.6").contains("interpolated"), "{}", at("0.6"));
    assert!(at("600").contains("600 lies outside those of family.toml, 0 to 1.2: check its unit"), "{}", at("600"));
    // The damper at a setting between two settings is stronger than the interpolated model. The validation must not doubt the setting of
    // these tests. The diagnosis must state that its numbers there are interpolated.
    let mut strong = damper().params_at(0.9);
    let forces: Vec<f64> = strong.list(list!("fv_force")).iter().map(|force| 1.25 * force).collect();
    strong.set_list(list!("fv_force"), &forces).unwrap();
    write_of(&strong, &dir.join("between"), "_0.9A", 5);
    let said = run(dir, &["validate", "family.toml", "between"]);
    assert!(said.out.contains("0.9, interpolated") && !said.err.contains("Check the setting"), "{said:?}");
    let said = run(dir, &["diagnose", "family.toml", "between", "--candidates", "free_play", "--json", "d.json"]);
    assert!(said.err.contains("was not measured at 0.9: its numbers there are interpolated"), "{said:?}");
    assert_eq!(json(&dir.join("d.json"))["settings"][0]["interpolated"].as_bool(), Some(true));
}

#[test]
fn friction_that_was_added_at_all_settings_is_one_change_against_the_reference() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    for (seed, current) in (10..).zip(CURRENTS) {
        let good = damper().params_at(current);
        let mut worn = good;
        worn.enable(element!("coulomb_friction"), true);
        worn.set(number!("coulomb_force"), 60.0).unwrap();
        write_of(&good, &dir.join("good"), &format!("_{current}A"), seed);
        write_of(&worn, &dir.join("worn"), &format!("_{current}A"), seed + 10);
    }
    write_model(&dir.join("family.toml"));
    let verb = ["diagnose", "family.toml", "worn", "--reference", "good", "--json", "d.json", "--report", "d.html"];
    let said = done(dir, &[&verb[..], &["--candidates", "coulomb_friction,gas_preload,free_play"]].concat());
    assert!(said.contains("coulomb_force changed at every setting"), "{said}");
    let found = json(&dir.join("d.json"));
    let changes = found["changes"].as_array().unwrap();
    assert!(changes.len() == 1 && changes[0]["at_all_settings"] == true, "{changes:?}");
    let forces = changes[0]["settings"].as_array().unwrap().iter().map(|at| at["value"].as_f64().unwrap());
    let forces: Vec<f64> = forces.collect();
    assert!(forces.len() == 3 && forces.iter().all(|force| (force / 60.0 - 1.0).abs() < 0.1), "{forces:?}");
    assert!(std::fs::read_to_string(dir.join("d.html")).unwrap().contains("coulomb_friction"));
}

#[test]
fn friction_that_chatters_at_one_setting_is_said_and_not_replaced_at_the_others() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    let mut family = damper();
    family.params.enable(element!("coulomb_friction"), true);
    family.params.set(number!("coulomb_steepness"), 2000.0).unwrap();
    family.axis.set_values(number!("coulomb_force"), &[2.0, 10.0, 80.0]).unwrap();
    family.axis.put(&mut family.params, 0.0);
    let text = dashpot_identification::model_file::flat_family(&family, |_| String::new());
    std::fs::write(dir.join("steep.toml"), text).unwrap();
    let said = done(dir, &["check", "steep.toml"]);
    // A setting without a remark has no line of its own.
    assert!(said.lines().all(|line| !line.starts_with("setting = 0:")), "{said}");
    let worst = said.lines().find(|line| line.starts_with("setting = 1.2:")).unwrap_or_else(|| panic!("{said}"));
    assert!(
        worst.contains("coulomb_friction makes it") && said.contains("over 3 settings, the largest at 1.2"),
        "{said}"
    );
    let message = refused(dir, &["check", "steep.toml", "--for-step", "1ms"]);
    assert!(message.contains("at the setting 1.2 coulomb_friction chatters"), "{message}");
    let export = ["export", "fmu", "steep.toml", "-o", "d.fmu", "--for-step", "1ms"];
    let message = refused(dir, &export);
    assert!(message.contains("at the setting 1.2 coulomb_friction") && !dir.join("d.fmu").exists(), "{message}");
}

#[test]
fn what_a_diagnosis_over_settings_cannot_do_is_said_with_the_way_to_it() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    write(&dir.join("rig"), 0.6, "");
    write_model(&dir.join("family.toml"));
    for option in [["-o", "better.toml"], ["--next-tests", "next.csv"], ["--svg", "figures"], ["--group", "folders"]] {
        let message = refused(dir, &[&["diagnose", "family.toml", "rig"][..], &option].concat());
        assert!(message.contains(option[0]) && message.contains("dashpot setting"), "{message}");
    }
    let message = refused(dir, &["diagnose", "family.toml", "rig", "--json", "d.json"]);
    assert!(message.contains("--setting") && message.contains("4mm_12Hz"), "{message}");
    let message = refused(dir, &["diagnose", "family.toml", "rig", "--setting", "current"]);
    assert!(message.contains("a number"), "{message}");
    let message = refused(dir, &["diagnose", "rig", "--setting", "0.6"]);
    assert!(message.contains("a name"), "{message}");
    done(dir, &["setting", "family.toml", "0.6", "-o", "one.toml"]);
    let message = refused(dir, &["diagnose", "one.toml", "rig", "--setting", "0.6"]);
    assert!(message.contains("depends on no setting"), "{message}");
    let given = ["diagnose", "family.toml", "rig", "--setting", "0.6", "--candidates", "free_play", "--json", "d.json"];
    done(dir, &given);
    assert_eq!(json(&dir.join("d.json"))["settings"][0]["setting"], 0.6);
}

#[test]
fn limits_hold_at_the_setting_that_they_name() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    for current in CURRENTS {
        write(&dir.join("rig"), current, &format!("_{current}A"));
    }
    let mut in_ampere = damper();
    in_ampere.axis.set_unit("A").unwrap();
    write_definition(&dir.join("family.toml"), &in_ampere);
    let v = 0.02 * std::f64::consts::TAU * 4.0;
    let force = |current: f64| {
        let at = dashpot_core::Model::new(&damper().params_at(current)).unwrap();
        dashpot_simulation::prediction::at_velocities(&at, &[v])[0][1]
    };
    let row = |current: f64, low: f64, high: f64| {
        format!("force,{v},{current},{},{}\n", low * force(current), high * force(current))
    };
    let write = |name: &str, rows: &str| {
        std::fs::write(dir.join(name), format!("quantity,velocity_m_s,setting,low,high\n{rows}")).unwrap();
    };
    write("kept.csv", &(row(0.0, 0.9, 1.1) + &row(1.2, 0.9, 1.1)));
    // At the hard setting, the damper violates the limits of the soft setting.
    write("missed.csv", &(row(0.0, 0.9, 1.1) + &row(0.0, 0.9, 1.1).replace(",0,", ",1.2,")));
    write("without.csv", &row(0.0, 0.9, 1.1).replace(",0,", ",,"));
    let judge = |limits: &str, model: &str| {
        let certificate = ["--certificate", "c.html", "--json", "v.json"];
        run(dir, &[&["validate", model, "rig", "--limits", limits][..], &certificate].concat())
    };
    let kept = judge("kept.csv", "family.toml");
    assert_eq!(kept.code, Some(0), "{kept:?}");
    let found = json(&dir.join("v.json"));
    assert_eq!(found["limits"]["limits"][1]["setting"], 1.2);
    assert_eq!(found["limits"]["limits"][1]["setting_unit"], "A");
    assert_eq!(found["limits"]["limits"][1]["measured"]["tests"][0], "20mm_4Hz_1.2A");
    assert!(std::fs::read_to_string(dir.join("c.html")).unwrap().contains("setting 1.2"));
    assert_eq!(judge("missed.csv", "family.toml").code, Some(1));
    let without = judge("without.csv", "family.toml");
    assert!(without.code == Some(2) && without.err.contains("dashpot setting"), "{without:?}");
    assert!(without.out.is_empty(), "rejected before any table: {}", without.out);
    done(dir, &["setting", "family.toml", "0.6", "-o", "one.toml"]);
    let ordinary = judge("kept.csv", "one.toml");
    assert!(ordinary.code == Some(2) && ordinary.err.contains("line 2"), "{ordinary:?}");
}

/// Writes a model of an adjustable damper with valve dynamics, and a motion at 1 kHz with additional columns after
/// time, displacement and velocity.
fn write_valve_and_motion(dir: &Path, headings: &str, columns: impl Fn(f64) -> String) {
    let mut damper = damper();
    damper.axis.set_name("current").unwrap();
    damper.axis.set_unit("A").unwrap();
    for (entry, value) in [("setting_time_up", 0.008), ("setting_time_down", 0.012), ("setting_dead_time", 0.003)] {
        let index = ENTRIES.iter().position(|known| known.name == entry).unwrap();
        damper.axis.set_number(index, value).unwrap();
    }
    let text = dashpot_identification::model_file::flat_family(&damper, |_| String::new());
    std::fs::write(dir.join("valve.toml"), text).unwrap();
    let mut text = format!("time_s,displacement_m,velocity_m_s{headings}\n");
    for k in 0..2000 {
        let t = 1e-3 * f64::from(k);
        let (x, v) = (0.02 * (9.0 * t).sin(), 0.18 * (9.0 * t).cos());
        let _ = writeln!(text, "{t:?},{x:?},{v:?}{}", columns(t));
    }
    std::fs::write(dir.join("motion.csv"), text).unwrap();
}

/// Returns the forces, N, and the printed text of `dashpot simulate` with further options.
fn simulated(dir: &Path, options: &[&str]) -> (Vec<f64>, String) {
    let printed = done(dir, &[&["simulate", "valve.toml", "motion.csv", "-o", "force.csv"], options].concat());
    (table(&dir.join("force.csv")).1.iter().map(|row| row[3]).collect(), printed)
}

#[test]
fn a_constant_column_of_the_motion_is_the_option() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    write_valve_and_motion(dir, "", |_| String::new());
    let given = |setting: &str| simulated(dir, &["--setting", setting]).0;
    let (at_start, printed) = simulated(dir, &[]);
    assert!(printed.contains("at the start setting") && printed.contains("--column setting=HEADING"), "{printed}");
    let (hard, half, outside) = (given("1.2"), given("0.45"), given("5"));
    assert!(hard == outside && hard != half && at_start != half);
    for (heading, cell, options, expected) in [
        (",current [A]", ",0.45", &[][..], &half),
        (",current [mA]", ",450", &[], &half),
        (",current [A]", ",0.45", &["--step", "0.001"], &half),
        (",command", ",0.45", &["--column", "setting=command"], &half),
        (",current [A]", ",7", &[], &hard),
        (",current [A]", ",0.45", &["--ignore", "current", "--setting", "1.2"], &hard),
    ] {
        write_valve_and_motion(dir, heading, |_| cell.to_owned());
        let (forces, printed) = simulated(dir, options);
        let furthest = forces.iter().zip(expected).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(forces.len() == 2000 && furthest < 1e-6, "{heading} {options:?}: {furthest} {printed}");
        assert_eq!(printed.contains("at 2000 of 2000 samples the current lies outside"), cell == ",7", "{printed}");
    }
    // The output contains the setting column as in the input, so a simulated motion can serve as an input again.
    write_valve_and_motion(dir, ",current [mA]", |t| format!(",{}", 100.0 + 250.0 * t));
    let (forces, _) = simulated(dir, &[]);
    let (columns, rows) = table(&dir.join("force.csv"));
    assert_eq!(columns[4], "current_A");
    assert!(rows.iter().all(|row| (row[4] - 0.1 - 0.25 * row[0]).abs() < 1e-9));
    std::fs::copy(dir.join("force.csv"), dir.join("motion.csv")).unwrap();
    let again = simulated(dir, &["--ignore", "force"]).0;
    assert!(again.iter().zip(&forces).all(|(a, b)| (a - b).abs() < 1e-6));
    // The name of the motion file states a pressure. The setting of this damper is a current, so the pressure is not
    // used.
    write_valve_and_motion(dir, "", |_| String::new());
    std::fs::rename(dir.join("motion.csv"), dir.join("motion_3bar.csv")).unwrap();
    let printed = done(dir, &["simulate", "valve.toml", "motion_3bar.csv", "-o", "force.csv"]);
    assert!(printed.contains("depends on current; the pressure is not read"), "{printed}");
    assert!(printed.contains("at the start setting"), "{printed}");
    write_valve_and_motion(dir, ",current [A]", |_| ",0.45".to_owned());
    let message = refused(dir, &["simulate", "valve.toml", "motion.csv", "-o", "f.csv", "--setting", "1.2"]);
    for words in ["column 'current [A]'", "--setting", "--ignore current", "motion.csv"] {
        assert!(message.contains(words), "{words}: {message}");
    }
    let message = refused(dir, &["simulate", "valve.toml", "motion.csv", "-o", "f.csv", "--column", "setting=lost"]);
    assert!(message.contains("'lost'"), "{message}");
    write_valve_and_motion(dir, ",p [bar]", |_| ",0.45".to_owned());
    let message = refused(dir, &["simulate", "valve.toml", "motion.csv", "-o", "f.csv", "--column", "setting=p"]);
    assert!(message.contains("in bar") && message.contains("valve.toml in A"), "{message}");
}

#[test]
fn a_validation_names_tests_whose_forces_are_those_of_another_setting() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    let mut damper = damper();
    damper.axis.set_name("current").unwrap();
    damper.axis.set_unit("A").unwrap();
    let text = dashpot_identification::model_file::flat_family(&damper, |_| String::new());
    std::fs::write(dir.join("family.toml"), text).unwrap();
    for (place, current, stated) in [("right", 0.6, "_0.6A"), ("wrong", 0.6, "_0.0A")] {
        write(&dir.join(place), current, stated);
        let run = run(dir, &["validate", "family.toml", place, "--json", "errors.json", "--report", "page.html"]);
        assert_eq!(run.code, Some(0), "{run:?}");
        let is_wrong = place == "wrong";
        let page = std::fs::read_to_string(dir.join("page.html")).unwrap();
        for text in [&run.err, &page] {
            assert_eq!(text.contains("are those of about 0.6 A, not of 0 A"), is_wrong, "{text}");
        }
        // The report says so in its answer, before the section of the setting.
        let answer = page.split("id=\"setting\"").next().unwrap();
        assert_eq!(answer.contains("are those of about 0.6 A"), is_wrong);
        let figures = json(&dir.join("errors.json"));
        let doubt = figures.pointer("/setting_doubts/0").map(|doubt| (&doubt["stated"], &doubt["fitting"]));
        assert_eq!(doubt, is_wrong.then_some((&0.0.into(), &0.6.into())));
    }
}

#[test]
fn a_table_of_clicks_is_one_model_over_the_clicks() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    let table = "Velocity [m/s],C 0 clk [N],C 8 clk [N],R 0 clk [N],R 8 clk [N]\n\
                 0.05,200,100,300,150\n0.1,300,160,500,260\n0.3,,300,900,500\n0.5,700,420,1300,700\n";
    std::fs::write(dir.join("clicks.csv"), table).unwrap();
    let printed = done(dir, &["import", "peaks", "clicks.csv", "-o", "adjuster.toml", "--clicks", "family"]);
    assert!(printed.contains("interpolated linearly over up to 66.7 % of the speed"), "{printed}");
    for (setting, rebound, compression) in [("0", 1300.0, -700.0), ("8", 700.0, -420.0)] {
        done(dir, &["setting", "adjuster.toml", setting, "-o", "one.toml", "--force"]);
        let one = dashpot_identification::model_file::read_family(&dir.join("one.toml")).unwrap();
        let forces = one.params.list(list!("fv_force"));
        assert_eq!((forces.first(), forces.last()), (Some(&compression), Some(&rebound)));
    }
    // If measured velocities differ slightly between the clicks of an adjuster, as on a dyno, the imported FV table
    // contains all points.
    let mut scattered = String::from("Clicks,Comp Vel [m/s],Comp Force [N],Reb Vel [m/s],Reb Force [N]\n");
    let rows =
        [[0.05, 200.0, 300.0, 100.0, 150.0], [0.1, 300.0, 500.0, 160.0, 260.0], [0.5, 700.0, 1300.0, 420.0, 700.0]];
    for (click, factor, column) in [(0, 1.004, 1), (8, 0.997, 3)] {
        for row in rows {
            let v = factor * row[0];
            let _ = writeln!(scattered, "{click},{v},{},{v},{}", row[column], row[column + 1]);
        }
    }
    std::fs::write(dir.join("dyno.csv"), scattered).unwrap();
    let printed = done(dir, &["import", "peaks", "dyno.csv", "-o", "dyno.toml", "--clicks", "family"]);
    assert!(printed.contains("7 points"), "{printed}");
    let three = "Velocity [m/s],C 0 clk [N],C 8 clk [N],C 16 clk [N],R 0 clk [N],R 8 clk [N],R 16 clk [N]\n\
                 0.1,300,100,200,600,200,400\n0.5,600,200,400,1200,400,800\n";
    std::fs::write(dir.join("three.csv"), three).unwrap();
    let printed = done(dir, &["import", "peaks", "three.csv", "-o", "three.toml", "--clicks", "family"]);
    assert!(printed.contains("with 8 and 16 exchanged"), "{printed}");
    // A click whose forces end at a lower velocity would shorten the tables of all clicks, so it is an error.
    std::fs::write(dir.join("short.csv"), table.replace("0.5,700,420,1300,700\n", "0.5,700,,1300,\n")).unwrap();
    let message = refused(dir, &["import", "peaks", "short.csv", "-o", "other.toml", "--clicks", "family"]);
    assert!(message.contains("click 8 has forces up to 300 mm/s"), "{message}");
    std::fs::write(dir.join("clicks.csv"), table.replace("R 8", "R 9")).unwrap();
    let message = refused(dir, &["import", "peaks", "clicks.csv", "-o", "other.toml", "--clicks", "family"]);
    assert!(message.contains("clicks.csv") && !dir.join("other.toml").exists(), "{message}");
}

#[test]
fn a_step_in_the_motion_is_the_one_that_validate_predicts() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    let current = |t: f64| if (0.7..1.4).contains(&t) { 1.2 } else { 0.2 };
    write_valve_and_motion(dir, ",current [A]", |t| format!(",{}", current(t)));
    let (forces, printed) = simulated(dir, &[]);
    assert!(printed.contains("current from the column 'current [A]' of motion.csv: 0.2 to 1.2 A"), "{printed}");
    // The motion with the simulated force as its measured force becomes a record.
    let text = std::fs::read_to_string(dir.join("motion.csv")).unwrap();
    let mut record = String::new();
    for (k, line) in text.lines().enumerate() {
        let force = if k == 0 { "force_N".to_owned() } else { format!("{:?}", forces[k - 1]) };
        let _ = writeln!(record, "{line},{force}");
    }
    std::fs::create_dir(dir.join("rig")).unwrap();
    std::fs::write(dir.join("rig/steps.csv"), record).unwrap();
    let ran = run(dir, &["validate", "valve.toml", "rig", "--positive", "rebound", "--json", "v.json"]);
    let change = "'steps': the current of the damper's valve steps between 0.20 and 1.20 A within the test (steps: 2)";
    assert!(ran.code == Some(0) && ran.err.contains(change) && !ran.err.contains("--exclude"), "{}", ran.err);
    let of = json(&dir.join("v.json"))["changing"].clone();
    // `validate` smooths the motion and `simulate` does not, so a small error is allowed.
    assert!(number(&of, "error_percent") < 0.1, "{of}");
    // If `--setting` gives the same command, the times of its steps differ from those of the column by at most half a
    // sample.
    write_valve_and_motion(dir, "", |_| String::new());
    let (given, _) = simulated(dir, &["--setting", "0:0.2,0.7:1.2,1.4:0.2"]);
    let furthest = forces.iter().zip(&given).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    let peak = forces.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    assert!(furthest > 0.0 && furthest < 0.1 * peak, "{furthest} of {peak}");
}
