//! Files of third-party writers (`foreign/make.py`). All contain the same test, so all must give the same data.

use dashpot_records::{Options, Record, load};
use std::f64::consts::TAU;
use std::path::Path;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/foreign");

fn only(name: &str) -> Record {
    let file = Path::new(FOLDER).join(name);
    let mut campaign = load(&[file], &Options::default(), &|_| ()).unwrap_or_else(|e| panic!("{name}: {e}"));
    assert_eq!(campaign.records.len(), 1, "{name}");
    campaign.records.remove(0)
}

/// Checks the motion of a file, and its force within `tolerance`, N, against the damper and the motion of `make.py`.
fn check(name: &str, tolerance: f64) {
    let record = only(name);
    assert!((record.frequency - 2.0).abs() < 0.01, "{name}: {} Hz", record.frequency);
    assert!((record.amplitude - 0.020).abs() < 2e-5, "{name}: {} m", record.amplitude);
    let w = 2.0 * TAU;
    for i in 0..record.time.len() {
        // The true velocity has the magnitude that follows from the displacement, and the sign of the record's
        // velocity.
        let x = record.displacement[i] / 0.020;
        let v_true = (0.020 * w * (1.0 - (x * x).min(1.0)).sqrt()).copysign(record.velocity[i]);
        // Near the ends of the stroke, the square root is sensitive to the last digit of the displacement.
        if v_true.abs() < 0.06 {
            continue;
        }
        let force = if v_true > 0.0 { 1500.0 } else { 800.0 } * v_true + 40.0 * libm::tanh(v_true / 0.002);
        assert!((record.force[i] - force).abs() < tolerance, "{name}, sample {i}: {} for {force}", record.force[i]);
    }
}

#[test]
fn mdf_of_asammdf() {
    for name in ["plain.mf4", "deflated.mf4", "apart.mf4"] {
        check(name, 1.0);
    }
    // The resolution of the displacement is a micrometer, which limits the accuracy of the velocity near the end of the
    // stroke.
    check("transposed.mf4", 12.0);
}

#[test]
fn mdf_3_of_asammdf() {
    check("plain.mdf", 1.0);
    check("counts.mdf", 12.0);
    // Loggers give MDF files the extension .dat, which rigs also give to their text files.
    let folder = tempfile::tempdir().unwrap();
    let dat = folder.path().join("counts.dat");
    std::fs::copy(Path::new(FOLDER).join("counts.mdf"), &dat).unwrap();
    let read = load(&[dat], &Options::default(), &|_| ()).unwrap().records.remove(0);
    assert_eq!(read.force, only("counts.mdf").force);
}

#[test]
fn mat_of_version_73_of_h5py() {
    check("matlab73.mat", 1.0);
}

#[test]
fn tdms_of_nptdms() {
    check("time.tdms", 1.0);
    check("waves.tdms", 1.0);
}

#[test]
fn when_a_file_says_the_test_began_is_read() {
    use dashpot_records::clock::seconds;
    let at = |name: &str| only(name).begins;
    assert_eq!(at("waves.tdms"), seconds("2026-11-25 10:03:22.5"));
    for (name, made) in [("plain.mf4", "2026-11-23 17:56:09"), ("transposed.mf4", "2026-11-23 17:56:09")] {
        let from = seconds(made).unwrap();
        assert!(at(name).is_some_and(|t| (from..from + 1.0).contains(&t)), "{name}: {:?}", at(name));
    }
    // An MDF 3 file without a start time states the earliest time that its format can contain. A TDMS time channel has
    // no start time.
    assert_eq!([at("plain.mdf"), at("time.tdms")], [None, None]);
}
