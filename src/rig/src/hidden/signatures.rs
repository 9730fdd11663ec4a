//! Tests of the characteristic signatures of effects in the force.

use std::f64::consts::TAU;

use crate::{InjectedCase, Matrix, Options, Record, TestPoint};

/// Smallest significant force difference between two simulations, N. Additional states change the steps of the solver
/// and thus the force slightly.
const SOLVER_N: f64 = 0.02;

fn sine(name: &str, amplitude_m: f64, frequency_hz: f64) -> TestPoint {
    TestPoint { cycles: 2, ..TestPoint::at_peak_velocity(name.into(), amplitude_m, TAU * amplitude_m * frequency_hz) }
}

fn measured(points: &[TestPoint], effects: &[(&str, f64)]) -> Vec<Record> {
    let case = InjectedCase {
        effects: effects.iter().map(|(name, strength)| ((*name).into(), *strength)).collect(),
        options: Options { seed: 11, noise_percent: 0.0, ..Options::default() },
        ..InjectedCase::default()
    };
    case.run_matrix(&Matrix::new(points.to_vec()).unwrap(), |_, _| {}).unwrap().campaign.records
}

/// Computes the force with an effect of strength 1 minus the force without it, N, for every sample of every test.
fn traces(points: &[TestPoint], effect: &str) -> Vec<(Record, Vec<f64>)> {
    let neutral = measured(points, &[]);
    let hidden = measured(points, &[(effect, 1.0)]);
    hidden
        .into_iter()
        .zip(neutral)
        .map(|(with, without)| {
            let trace = with.force_n.iter().zip(&without.force_n).map(|(a, b)| a - b).collect();
            (with, trace)
        })
        .collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0f64, |most, value| most.max(value.abs()))
}

#[test]
fn cavitation_caps_compression_and_leaves_rebound() {
    let points = [sine("fast", 0.025, 9.0)];
    let (neutral, hidden) = (measured(&points, &[]), measured(&points, &[("cavitation:monotube_compression", 2.0)]));
    let ends = |record: &Record| {
        record.force_n.iter().fold((0f64, 0f64), |(low, high), force| (low.min(*force), high.max(*force)))
    };
    let ((low, high), (capped, kept)) = (ends(&neutral[0]), ends(&hidden[0]));
    assert!(capped > 0.8 * low, "{capped} of {low} N");
    assert!((kept / high - 1.0).abs() < 0.02, "{kept} of {high} N");
}

#[test]
fn late_valves_make_the_force_larger_while_the_speed_rises() {
    for form in ["spool", "opening_and_closing_pressure"] {
        for (record, trace) in traces(&[sine("knee", 0.03, 2.0)], &format!("valve_hysteresis:{form}")) {
            let (mut rising, mut falling) = (0.0, 0.0);
            for (speeds, trace) in record.velocity_m_s.windows(2).zip(&trace[1..]) {
                let v = speeds[1];
                let speeds_up = v.abs() > speeds[0].abs();
                *(if speeds_up { &mut rising } else { &mut falling }) += trace * v.signum();
            }
            assert!(rising > 0.0 && rising > falling, "{form}: {rising} against {falling}");
        }
    }
}

#[test]
fn presliding_turns_over_a_distance_at_any_frequency() {
    let points = [sine("slow", 0.01, 0.25), sine("quick", 0.01, 1.0)];
    let distances: Vec<f64> = traces(&points, "presliding_friction:maxwell_slip")
        .iter()
        .map(|(record, trace)| {
            // Start at the reversal at full extension, and continue until the force difference has fallen to half of
            // its peak.
            let from = record.time_s.len() / 3;
            let x = &record.displacement_m;
            let turn = (from..x.len() - 1).find(|i| x[*i] >= x[i - 1] && x[*i] > x[i + 1]).unwrap();
            let most = largest(&trace[turn..turn + 40]);
            let peak = (turn..turn + 40).find(|i| trace[*i].abs() == most).unwrap();
            let half = (peak..trace.len()).find(|i| trace[*i].abs() < 0.5 * most).unwrap();
            x[turn] - x[half]
        })
        .collect();
    assert!(distances[0] > 0.0 && (0.4..2.5).contains(&(distances[1] / distances[0])), "{distances:?} m");
}

#[test]
fn moving_mass_is_one_mass_in_every_test() {
    let points = [sine("slow", 0.03, 1.0), sine("fast", 0.005, 12.0)];
    let masses: Vec<f64> = traces(&points, "moving_mass:rig_mass")
        .iter()
        .map(|(record, trace)| {
            let omega = TAU * record.point.frequency_hz;
            largest(trace) / (record.point.amplitude_m * omega * omega)
        })
        .collect();
    // The limits are wider than the drawn masses of 2 to 5 kg, because ramps have slightly larger accelerations than
    // full cycles.
    assert!(masses.iter().all(|mass| (1.9..6.5).contains(mass)), "{masses:?} kg");
    assert!((masses[0] / masses[1] - 1.0).abs() < 0.3, "{masses:?} kg");
}

#[test]
fn side_friction_and_stops_act_only_where_they_can() {
    let side = TestPoint { side_force_n: 800.0, ..sine("side", 0.02, 0.5) };
    for form in ["saturating", "two_bushes"] {
        let found = traces(&[sine("free", 0.02, 0.5), side.clone()], &format!("side_force_friction:{form}"));
        assert!(largest(&found[0].1) < SOLVER_N && largest(&found[1].1) > 10.0, "{form}");
    }
    for (name, sign) in [("bump_stop", -1.0), ("rebound_stop", 1.0)] {
        for form in ["rubber", "hydraulic"] {
            let found = traces(&[sine("short", 0.02, 1.0), sine("long", 0.05, 3.0)], &format!("{name}:{form}"));
            assert!(largest(&found[0].1) < SOLVER_N, "{name}:{form}");
            for (x, trace) in found[1].0.displacement_m.iter().zip(&found[1].1) {
                assert!(
                    trace.abs() < SOLVER_N || (sign * x > 0.02 && sign * trace > 0.0),
                    "{name}:{form}: {trace} N at {x} m"
                );
            }
            assert!(largest(&found[1].1) > 30.0, "{name}:{form}");
        }
    }
}

#[test]
fn drift_follows_the_clock_and_gas_the_position() {
    let points = [sine("first", 0.02, 1.0), sine("second", 0.02, 1.5), sine("third", 0.02, 2.0)];
    let slopes: Vec<f64> = traces(&points, "force_drift:linear")
        .iter()
        .flat_map(|(record, trace)| {
            let last = trace.len() - 1;
            [trace[0] / record.time_s[0].max(1e-9), trace[last] / record.time_s[last]]
        })
        .skip(1)
        .collect();
    assert!(slopes.iter().all(|slope| (slope / slopes[0] - 1.0).abs() < 1e-6), "{slopes:?} N/s");
    for (record, trace) in traces(&points, "gas_spring:van_der_waals") {
        for (x, trace) in record.displacement_m.iter().zip(&trace) {
            // Compared with the constant preload, the gas force is larger in compression and smaller in extension.
            assert!(x.abs() < 1e-4 || trace * x > 0.0, "{trace} N at {x} m");
        }
    }
}
