//! `dashpot manoeuvre`: the vehicle on the command line.

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
            // The model's friction and compressibility change the force, but not beyond recognition.
            let (model, curve) = (number(corner, "largest_force_n"), number(corner, "largest_force_fv_n"));
            assert!((0.5..2.0).contains(&(model / curve)), "{name}: {corner}");
            assert!(
                number(corner, "rms_force_difference_n") > 1.0 && number(corner, "energy_j") > 0.0,
                "{name}: {corner}"
            );
            assert!((0.0..=1.0).contains(&number(corner, "share_inside_tests")), "{name}: {corner}");
        }
        let page = std::fs::read_to_string(at.join("m.html")).expect("the report");
        assert!(page.contains("Operating region") && page.matches("<svg").count() == 12, "{name}");
        assert!(!page.contains("NaN") || page.matches("NaN").count() == page.matches("isNaN").count(), "{name}");
        let first = page;
        done(at, &args);
        assert!(std::fs::read_to_string(at.join("m.html")).expect("the report") == first, "the same bytes");
    }
    assert!(refused(at, &["manoeuvre", "bump", "model.toml", "--step", "0.1"]).contains("0.0001 to 0.005"));
    assert!(refused(at, &["manoeuvre", "loop", "model.toml"]).contains("step-steer"));
}
