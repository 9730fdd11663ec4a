//! Tests that the campaigns of one rig get one sign convention. If the forces of a campaign hardly show the sign, a group or a reference
//! with clear forces determines it.

use dashpot_tests::cli::{done, run, write_sines};

#[test]
fn the_surest_campaign_decides_for_a_reference_and_for_groups() {
    let folder = tempfile::tempdir().unwrap();
    let dir = folder.path();
    write_sines(&dir.join("fleet/clear"), -1.0, |v| if v > 0.0 { 3000.0 * v - 150.0 } else { 1000.0 * v - 150.0 });
    // Without gas and with slightly more force in compression, this campaign alone would be read with the opposite direction positive.
    write_sines(&dir.join("fleet/unsure"), -1.0, |v| if v > 0.0 { 1000.0 * v } else { 1150.0 * v });
    done(dir, &["fit", "fleet/clear", "-o", "m.toml", "--model", "fv"]);
    let alone = run(dir, &["fit", "fleet/unsure", "-o", "u.toml", "--model", "fv"]);
    assert!(alone.err.contains("% sure"), "{}", alone.err);
    let decided = "the surest records of the rig say compression positive";
    let compared = run(dir, &["diagnose", "m.toml", "fleet/unsure", "--reference", "fleet/clear"]);
    assert!(compared.err.contains(decided), "{} {}", compared.err, compared.out);
    let groups = run(dir, &["diagnose", "m.toml", "fleet", "--group", "folders", "--reference", "fleet/clear"]);
    assert!(groups.err.contains(decided), "{} {}", groups.err, groups.out);
}
