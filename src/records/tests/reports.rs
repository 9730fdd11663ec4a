//! Situations that users reported, as synthetic inputs. The inputs are in `../shared/data/reports`, where the README
//! states the correct results.

use dashpot_records::{Campaign, Options, PeakOptions, Positive, Unit, load, peak_clicks, read_peaks};
use dashpot_test_support::reported;
use std::path::Path;

fn read(path: &Path) -> Campaign {
    load(&[path.to_path_buf()], &Options::default(), &|_| ()).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Joins all notes of the campaign and of its tests.
fn describe(campaign: &Campaign) -> String {
    let notes = campaign.records.iter().flat_map(|record| &record.notes).chain(&campaign.notes);
    notes.map(|note| format!("{}: {}\n", note.kind, note.text)).collect()
}

/// Returns the largest absolute force, N.
fn strongest(campaign: &Campaign) -> f64 {
    campaign.records.iter().flat_map(|r| &r.force).fold(0.0, |most: f64, f| most.max(f.abs()))
}

#[test]
fn mdf_groups_of_two_rates_are_joined() {
    let Some(path) = reported("mdf_groups_of_two_rates") else { return };
    let campaign = read(&path);
    assert_eq!(campaign.records.len(), 6);
    assert!(describe(&campaign).contains("joined at the times of the slower channels"), "{}", describe(&campaign));
    assert_eq!(campaign.sign.positive, Positive::Rebound);
    let amplitudes: Vec<f64> = campaign.records.iter().map(|r| r.amplitude).collect();
    assert!(amplitudes.iter().all(|a| *a > 1e-3), "{amplitudes:?}");
}

#[test]
fn a_tdms_that_broke_off_says_so() {
    let Some(path) = reported("tdms_cut_off") else { return };
    let campaign = read(&path);
    assert_eq!(campaign.records.len(), 6);
    let cut = campaign.notes.iter().filter(|note| note.kind == "cut_off" && note.is_loud()).count();
    assert!(cut > 0, "{}", describe(&campaign));
}

#[test]
fn rows_of_an_earlier_run_are_skipped_and_millis_are_time() {
    let Some(path) = reported("stale_serial_block") else { return };
    let campaign = read(&path);
    assert_eq!(campaign.records.len(), 6);
    assert!(describe(&campaign).contains("the first 7 rows"), "{}", describe(&campaign));
    // The times of the stale rows are 33 s too late, and these rows contain almost no force.
    let first: Vec<(f64, f64)> = campaign.records.iter().map(|r| (r.time[0], r.force[0])).collect();
    assert!(first.iter().all(|(time, force)| *time < 10.0 && force.abs() > 1.0), "{first:?}");
    // Repeat the test with `Millis`, a heading that microcontroller boards write.
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(&path).unwrap().flatten() {
        let text = std::fs::read_to_string(entry.path()).unwrap().replace("Time [ms]", "Millis");
        std::fs::write(folder.path().join(entry.file_name()), text).unwrap();
    }
    let millis = read(folder.path());
    assert!(millis.records.iter().zip(&campaign.records).all(|(a, b)| a.time == b.time && a.force == b.force));
}

#[test]
fn a_late_velocity_is_not_used() {
    let Some(path) = reported("late_velocity_column") else { return };
    let smoothed = |wanted: &str| {
        let mut options = Options::default();
        options.columns.insert("velocity".parse().unwrap(), wanted.into());
        load(&[path.clone()], &options, &|_| ()).unwrap()
    };
    let campaign = smoothed("Smoothed_Velocity");
    assert!(describe(&campaign).contains("'Smoothed_Velocity [mm/s]' comes"), "{}", describe(&campaign));
    // The record's velocity is derived from the displacement, although the user selected a velocity column.
    let without =
        load(&[path.clone()], &Options { ignore: ["velocity".parse().unwrap()].into(), ..Options::default() }, &|_| ())
            .unwrap();
    for (record, derived) in campaign.records.iter().zip(&without.records) {
        assert_eq!(record.velocity, derived.velocity);
    }
}

#[test]
fn crank_angle_and_speed_are_a_clock() {
    let Some(path) = reported("crank_angle") else { return };
    let campaign = read(&path);
    let frequencies: Vec<f64> = campaign.records.iter().map(|r| r.frequency).collect();
    let wanted = std::fs::read_to_string(path.join("run2.csv")).unwrap();
    let rpm: f64 =
        wanted.lines().nth(1).unwrap().trim_start_matches("Speed: ").trim_end_matches(" rpm").parse().unwrap();
    assert!((frequencies[2] * 60.0 / rpm - 1.0).abs() < 1e-3, "{frequencies:?}");
    for record in &campaign.records {
        let text = std::fs::read_to_string(path.join(format!("{}.csv", record.name))).unwrap();
        let stroke = text.lines().next().unwrap().trim_start_matches("Stroke: ").trim_end_matches(" mm");
        let amplitude = 0.5e-3 * stroke.parse::<f64>().unwrap();
        assert!((record.amplitude - amplitude).abs() < 2e-4, "{}: {}", record.name, record.amplitude);
    }
    assert!(describe(&campaign).contains("120 revolutions per minute"), "{}", describe(&campaign));
}

#[test]
fn settings_are_recognised_in_a_channel_and_in_names() {
    for name in ["current_column", "currents_in_names"] {
        let Some(path) = reported(name) else { return };
        let campaign = read(&path);
        for record in &campaign.records {
            let setting = record.setting.as_ref().unwrap_or_else(|| panic!("{name}: {}", record.name));
            let wanted: f64 = record.name.rsplit('_').next().unwrap().trim_end_matches('A').parse().unwrap();
            assert_eq!((setting.name.as_str(), setting.unit.as_str()), ("current", "A"));
            assert!((setting.value - wanted).abs() < 1e-9, "{name}: {} {}", record.name, setting.value);
        }
        let warned: Vec<_> = campaign.notes.iter().filter(|note| note.kind == "settings").collect();
        assert!(warned.len() == 1 && warned[0].is_loud(), "{name}: {}", describe(&campaign));
        assert!(warned[0].text.to_string().contains("5 settings of current"));
    }
}

#[test]
fn a_table_of_clicks_gives_a_curve_a_click() {
    let Some(path) = reported("click_table") else { return };
    let file = path.join("clicks.csv");
    assert_eq!(peak_clicks(&file).unwrap(), [0.0, 10.0, 20.0]);
    let mut options = PeakOptions::default();
    options.unit_of("force".parse().unwrap(), "lbf").unwrap();
    let refused = read_peaks(&file, &options).unwrap_err().to_string();
    assert!(refused.contains("0, 10, 20") && refused.contains("--clicks all"), "{refused}");
    options.clicks = Some(10.0);
    let peaks = read_peaks(&file, &options).unwrap();
    assert_eq!(peaks.points.len(), 8);
    let fastest = peaks.points.last().unwrap();
    assert!(
        (fastest.velocity_m_s - 0.254).abs() < 1e-9 && (fastest.force_n - Unit::PoundForce.to_si(140.0)).abs() < 1e-9
    );
    // The table is rejected as a record, and the message names the command that reads it.
    let message = load(&[file], &Options::default(), &|_| ()).unwrap_err().to_string();
    assert!(message.contains("dashpot import peaks"), "{message}");
}

#[test]
fn a_stump_beside_a_gap_is_left_out() {
    let Some(path) = reported("gap_in_one_test") else { return };
    let campaign = read(&path);
    assert_eq!(campaign.records.len(), 5, "{:?}", campaign.records.iter().map(|r| &r.name).collect::<Vec<_>>());
    assert!(describe(&campaign).contains("holds no whole cycle and was left out"), "{}", describe(&campaign));
}

#[test]
fn a_log_with_rests_is_seven_tests() {
    let Some(path) = reported("one_log_with_dwells") else { return };
    let campaign = read(&path);
    assert_eq!(campaign.records.len(), 7);
    let mut amplitudes: Vec<f64> = campaign.records.iter().map(|r| r.amplitude).collect();
    amplitudes.sort_by(f64::total_cmp);
    assert!((amplitudes[0] - 0.001).abs() < 1e-4 && (amplitudes[6] - 0.05).abs() < 1e-3, "{amplitudes:?}");
    assert!(campaign.records.iter().all(|r| r.frequency > 0.0));
}

#[test]
fn a_staircase_of_speeds_is_a_test_a_speed() {
    let Some(path) = reported("staircase_pair") else { return };
    for (name, friction) in [("a", 190.0), ("b", 135.0)] {
        let campaign = read(&path.join(name));
        let speeds: Vec<f64> = campaign.records.iter().map(|r| 1e3 * r.peak_velocity).collect();
        assert_eq!(speeds.len(), 7, "{name}: {speeds:?}\n{}", describe(&campaign));
        for (speed, wanted) in speeds.iter().zip([10.0, 20.0, 30.0, 50.0, 75.0, 100.0, 150.0]) {
            assert!((speed / wanted - 1.0).abs() < 0.05, "{name}: {speeds:?}");
        }
        // The motion has no standstill, so the direction may be uncertain. A note then reports the uncertainty.
        let unsure = campaign.notes.iter().any(|note| note.kind == "sign_unsure");
        assert!(unsure == (campaign.sign.confidence < 0.8), "{name}: {:?}", campaign.sign);
        // Half the force jump at the turning points of the slowest test is mostly friction.
        let slowest = &campaign.records[0];
        let mean = |up: bool| {
            let forces: Vec<f64> = slowest
                .velocity
                .iter()
                .zip(&slowest.force)
                .filter(|(v, _)| (**v > 0.0) == up)
                .map(|(_, f)| *f)
                .collect();
            forces.iter().sum::<f64>() / forces.len() as f64
        };
        let jump = 0.5 * (mean(true) - mean(false));
        assert!((jump - friction).abs() < 20.0, "{name}: {jump}");
        assert!(strongest(&campaign) > 300.0);
    }
}
