//! Several changes of a damper relative to a reference, in few tests.

use dashpot_test_support::Random;
use dashpot_tests::cli::{done, json, number, write_sines};
use std::path::Path;

/// Writes three tests of a damper with a proportional force in each direction, N s/m, a gas force, N, and noise.
fn write_campaign(folder: &Path, [rebound, compression, gas]: [f64; 3]) {
    let mut random = Random(1);
    write_sines(folder, 1.0, |velocity| {
        let damping = if velocity > 0.0 { rebound } else { compression };
        damping * velocity + gas + random.between(-5.0, 5.0)
    });
}

#[test]
fn two_changes_are_found_in_three_tests() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    write_campaign(&dir.join("reference"), [3000.0, 1000.0, -150.0]);
    done(dir, &["fit", "reference", "-o", "m.toml", "--model", "fv", "--positive", "rebound"]);
    let campaigns = [
        // The first of the two changes alone explains only a small part of the residual, so it is hardly more probable
        // than no change.
        ("two", [2000.0, 1000.0, 0.0], vec!["gas_force", "rebound_curve"]),
        // If both sides of the curve change, the diagnosis must report one change of each side. It must not report a
        // change of the whole curve and one of a single side.
        ("three", [1000.0, 1150.0, 0.0], vec!["compression_curve", "gas_force", "rebound_curve"]),
    ];
    for (name, damper, wanted) in campaigns {
        write_campaign(&dir.join(name), damper);
        let options = ["--reference", "reference", "--positive", "rebound", "--json", "d.json", "--force"];
        done(dir, &[&["diagnose", "m.toml", name][..], &options].concat());
        let found = json(&dir.join("d.json"));
        let changes = found["changes"].as_array().unwrap();
        let mut names: Vec<&str> = changes.iter().map(|change| change["name"].as_str().unwrap()).collect();
        names.sort_unstable();
        assert_eq!(names, wanted, "{found}");
        for change in changes {
            // Forces at 0.2 m/s, and the gas force, which is positive in compression.
            let truth = match change["name"].as_str().unwrap() {
                "gas_force" => -damper[2],
                "rebound_curve" => damper[0] * number(change, "velocity_m_s"),
                _ => damper[1] * number(change, "velocity_m_s"),
            };
            let value = number(change, "value");
            assert!((value - truth).abs() < 5.0 + 0.03 * truth.abs(), "{change}: {truth}");
        }
    }
}
