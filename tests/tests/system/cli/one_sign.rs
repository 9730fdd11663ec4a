//! One sign convention for the campaigns of one rig. A group or a reference with clear forces decides for a campaign whose
//! forces hardly show the sign.

use dashpot_tests::cli::{done, run};
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;

/// Writes tests of a damper into a folder, with compression counted positive. `law` returns the force, N, tension
/// positive, at a velocity, m/s, extension positive.
fn write_campaign(folder: &Path, law: impl Fn(f64) -> f64) {
    std::fs::create_dir_all(folder).unwrap();
    for (name, speed) in [("slow", 0.05), ("medium", 0.2), ("fast", 0.5)] {
        let rate = speed / 0.02;
        let mut text = String::from("time_s,displacement_mm,force_N\n");
        for sample in 0..2000 {
            let time = f64::from(sample) * 4.0 * TAU / rate / 2000.0;
            let (displacement, velocity) = (20.0 * (rate * time).sin(), speed * (rate * time).cos());
            writeln!(text, "{time:.6},{:.5},{:.3}", -displacement, -law(velocity)).unwrap();
        }
        std::fs::write(folder.join(format!("{name}.csv")), text).unwrap();
    }
}

#[test]
fn the_surest_campaign_decides_for_a_reference_and_for_groups() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    write_campaign(&dir.join("fleet/clear"), |v| if v > 0.0 { 3000.0 * v - 150.0 } else { 1000.0 * v - 150.0 });
    // Without gas and with slightly more force in compression, this campaign alone would be read in the other direction.
    write_campaign(&dir.join("fleet/unsure"), |v| if v > 0.0 { 1000.0 * v } else { 1150.0 * v });
    done(dir, &["fit", "fleet/clear", "-o", "m.toml", "--model", "fv"]);
    let alone = run(dir, &["fit", "fleet/unsure", "-o", "u.toml", "--model", "fv"]);
    assert!(alone.err.contains("% sure"), "{}", alone.err);
    let decided = "the surest records of the rig say compression positive";
    let compared = run(dir, &["diagnose", "m.toml", "fleet/unsure", "--reference", "fleet/clear"]);
    assert!(compared.err.contains(decided), "{} {}", compared.err, compared.out);
    let groups = run(dir, &["diagnose", "m.toml", "fleet", "--group", "folders", "--reference", "fleet/clear"]);
    assert!(groups.err.contains(decided), "{} {}", groups.err, groups.out);
}
