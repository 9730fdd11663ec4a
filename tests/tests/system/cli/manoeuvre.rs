//! Tests of `dashpot manoeuvre`, the vehicle simulation on the command line.

use dashpot_tests::bridge::MODEL;
use dashpot_tests::cli::{done, json, number, refused, small_campaign};

#[test]
fn every_manoeuvre_tells_what_the_dampers_saw() {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    std::fs::write(at.join("model.toml"), MODEL).expect("a model file");
    small_campaign(at);
    for name in ["bump", "step-steer", "sine-steer", "track"] {
        let args = ["manoeuvre", name, "model.toml", "--tests", "records", "--json", "m.json", "--report", "m.html"];
        let told = done(at, &args);
        assert!(told.contains("rig tests") && told.contains("heave acceleration"), "{told}");
        let figures = json(&at.join("m.json"));
        for corner in figures["corners"].as_array().expect("corners") {
            // Relative to the FV curve alone, the model's friction and compressibility change the force by less than a
            // factor of 2.
            let (model, curve) = (number(corner, "largest_force_n"), number(corner, "largest_force_fv_n"));
            assert!((0.5..2.0).contains(&(model / curve)), "{name}: {corner}");
            assert!(
                number(corner, "rms_force_difference_n") > 1.0 && number(corner, "energy_j") > 0.0,
                "{name}: {corner}"
            );
            assert!((0.0..=1.0).contains(&number(corner, "fraction_inside_tests")), "{name}: {corner}");
        }
        let page = std::fs::read_to_string(at.join("m.html")).expect("the report");
        assert!(page.contains("Operating region") && page.matches("<svg xmlns").count() == 21, "{name}");
        assert!(!page.contains("NaN") || page.matches("NaN").count() == page.matches("isNaN").count(), "{name}");
        let first = page;
        done(at, &args);
        assert!(std::fs::read_to_string(at.join("m.html")).expect("the report") == first, "the same bytes");
    }
    // The next run has a heavier, user-defined vehicle and a report in another language.
    std::fs::write(at.join("car.toml"), "sprung_mass = 2200\n").expect("a vehicle");
    let own =
        ["manoeuvre", "bump", "model.toml", "--vehicle", "car.toml", "--json", "own.json", "--report", "own.html"];
    done(at, &[&own[..], &["--language", "de"]].concat());
    done(at, &["manoeuvre", "bump", "model.toml", "--json", "usual.json"]);
    let rms = |file: &str| json(&at.join(file))["rms_heave_acceleration_m_s2"][0].as_f64().expect("a number");
    assert!(rms("own.json") < 0.9 * rms("usual.json"), "{} {}", rms("own.json"), rms("usual.json"));
    let page = std::fs::read_to_string(at.join("own.html")).expect("the report");
    assert!(page.contains("Straße unter den Vorderrädern") && page.contains("car.toml") && page.contains("2200"));
    std::fs::write(at.join("car.toml"), "wheels = 3\n").expect("a vehicle");
    let told = refused(at, &["manoeuvre", "bump", "model.toml", "--vehicle", "car.toml"]);
    assert!(told.contains("car.toml") && told.contains("line 1") && told.contains("\"wheels\""), "{told}");
    // With a tire of 1e9 N/m, the vehicle is unstable with any damper. The message names the parameters of the vehicle
    // and a stable step.
    std::fs::write(at.join("car.toml"), "tyre = 1e9\n").expect("a vehicle");
    let stiff = ["manoeuvre", "bump", "model.toml", "--vehicle", "car.toml"];
    let told = refused(at, &stiff);
    assert!(
        told.contains("unsprung_mass 40 kg on tyre 1e9 N/m") && told.contains("whatever the damper does"),
        "{told}"
    );
    let step = told.split("take steps of ").nth(1).and_then(|t| t.split(" ms").next()).expect("a step");
    let step = format!("{}", 1e-3 * step.parse::<f64>().expect("a number"));
    done(at, &[&stiff[..], &["--step", &step]].concat());
    assert!(refused(at, &["manoeuvre", "bump", "model.toml", "--step", "0.1"]).contains("0.0001 to 0.005"));
    assert!(refused(at, &["manoeuvre", "loop", "model.toml"]).contains("step-steer"));
}
