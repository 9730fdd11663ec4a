//! Examples of the first use of the virtual rig: a campaign on the physical damper, and a case with an injected effect.

use dashpot_rig::{Campaign, InjectedCase, Matrix, MatrixOptions, Options, Plan, RigError};

#[test]
fn a_campaign_is_measured() -> Result<(), RigError> {
    let matrix = Matrix::thesis(&MatrixOptions {
        amplitudes_m: vec![0.05],
        peak_velocities_m_s: vec![0.5],
        slow_tests: false,
        ..MatrixOptions::default()
    })?;
    let campaign = Campaign::run(&matrix, &Options::default(), |_done, _total| {})?;
    assert_eq!(campaign.records[0].point.name, "a50mm_v0500mm_s");
    Ok(())
}

#[test]
fn an_effect_is_hidden() -> Result<(), RigError> {
    let case = InjectedCase {
        effects: vec![("free_play".into(), 1.0)],
        plan: Plan::OneFrequency,
        options: Options { seed: 7, noise_percent: 2.0, ..Options::default() },
    };
    let outcome = case.run()?;
    assert_eq!(outcome.truth.effects[0].name, "free_play");
    let record = &outcome.campaign.records[0];
    assert_eq!(record.force_n.len(), record.clean_force_n.len());
    Ok(())
}
