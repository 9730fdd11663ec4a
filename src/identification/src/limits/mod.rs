//! Checks of a damper against limits that its maker or buyer states.
//!
//! [`table`] reads the limits, and [`measured`] extracts the figures from the records. [`judge`] compares limits and records, and
//! [`Figures::judge`] compares limits and stored figures. [`judge_over_settings`] judges a damper over a setting,
//! [`SettingsFigures::judge`] its stored figures.
//!
//! The verdict applies to the measured damper. If a model is given, the same rules judge its forces separately. A model that represents the
//! damper in a vehicle must meet the limits too.

mod json;
mod measured;
mod over_settings;
mod table;

pub use measured::{BETWEEN, Figures, NEAR};
pub use over_settings::{
    SettingLimitError, SettingsFigures, check_over_settings, check_without_setting, judge_over_settings,
    restate_settings_of_limits,
};
pub use table::{Limit, LimitError, Quantity, parse, read};

use dashpot_records::Record;
use serde::Serialize;

/// Verdict on a damper or a model by one limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The figure is within the limits.
    Pass,
    /// The figure is outside the limits.
    Fail,
    /// The records do not show the limited quantity. For example, no test reaches the speed, or no test is slow enough for friction. This
    /// is not a pass.
    NotTested,
}

/// Verdict on a damper by all its limits together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Overall {
    /// Every limit was tested and met.
    Pass,
    /// At least one limit is violated.
    Fail,
    /// No limit is violated, but at least one was not tested.
    Incomplete,
}

impl Overall {
    /// Combines the verdicts on each limit.
    fn of(each: impl Iterator<Item = Verdict>) -> Overall {
        each.fold(Overall::Pass, |overall, one| match (overall, one) {
            (Overall::Fail, _) | (_, Verdict::Fail) => Overall::Fail,
            (Overall::Incomplete, _) | (_, Verdict::NotTested) => Overall::Incomplete,
            _ => Overall::Pass,
        })
    }
}

/// Figure of one limited quantity, and the tests from which it comes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Value {
    /// Figure: a force, N, or a time, s.
    pub value: f64,
    /// Names of the tests.
    pub tests: Vec<String>,
    /// Half-width of the 95 % interval of a measured time, s, or `None` if it is unknown.
    pub uncertainty: Option<f64>,
    /// Part of a friction that grows with velocity, N, or `None` if it is unknown. It is the damping at the speed of the slow tests.
    pub damping: Option<f64>,
    /// Settings before and after the steps of a response time; `None` for a force.
    pub step: Option<(f64, f64)>,
}

/// One limit with its figures and verdicts.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The limit.
    pub limit: Limit,
    /// Measured figure, if the records show it.
    pub measured: Option<Value>,
    /// Figure of the model on the same tests.
    pub model: Option<Value>,
    /// Verdict on the damper, from the measured figure.
    pub verdict: Verdict,
    /// Verdict on the model, if one was given.
    pub model_verdict: Option<Verdict>,
}

/// Fraction of a measured friction above which its velocity-dependent part is reported as damping. Scatter of the median forces in slow
/// tests stays below this fraction. Test: `friction_of_a_stiff_valve_is_told_as_damping`.
const DAMPING_SHARE: f64 = 0.25;

impl Checked {
    /// Returns the part of a measured friction that is damping, N, if it exceeds 25 % of the friction.
    pub fn damping_in_friction(&self) -> Option<f64> {
        let measured = self.measured.as_ref()?;
        measured.damping.filter(|damping| *damping > DAMPING_SHARE * measured.value)
    }

    /// Returns the uncertainty of the measured figure, s, if the lower or the upper limit lies within this uncertainty. The uncertainty can
    /// then change the verdict.
    pub fn deciding_uncertainty(&self) -> Option<f64> {
        let measured = self.measured.as_ref()?;
        let uncertainty = measured.uncertainty?;
        let is_within = |end: &f64| (measured.value - end).abs() < uncertainty;
        [self.limit.low, self.limit.high].iter().flatten().any(is_within).then_some(uncertainty)
    }
}

/// Force at peak velocity of one test, from rig and model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PeakPoint {
    /// Name of the test.
    pub test: String,
    /// Amplitude, m.
    pub amplitude_m: f64,
    /// Velocity, m/s, rebound positive.
    pub velocity_m_s: f64,
    /// Measured force, N.
    pub force_n: f64,
    /// Force of the model, N, or `None` without a model.
    pub model_n: Option<f64>,
}

/// Results of the comparison of a damper with all its limits.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Certificate {
    /// Whether every limit was tested and met.
    pub passed: bool,
    /// Verdict on the damper. A limit that was not tested is neither a failure nor a pass.
    pub overall: Overall,
    /// Whether every limit was tested on the model and the model meets it, or `None` without a model.
    pub model_passed: Option<bool>,
    /// Every limit, in the order of the file.
    pub limits: Vec<Checked>,
    /// Peak points that supply the forces.
    pub peaks: Vec<PeakPoint>,
}

/// Compares limits with records. `model` contains the forces of a model at the samples of each record. If it is given, the limits are also
/// compared with these forces.
pub fn judge(limits: &[Limit], records: &[&Record], model: Option<&[&[f64]]>) -> Certificate {
    let simulated = model.map(|forces| Figures::measure(records, Some(forces)));
    Figures::measure(records, None).judge(limits, simulated.as_ref())
}

impl Figures {
    /// Compares limits with these figures. If `model` is given, the limits are also compared with these figures of the model on the same
    /// records.
    pub fn judge(&self, limits: &[Limit], model: Option<&Figures>) -> Certificate {
        answers(limits, self, model)
    }
}

fn answers(limits: &[Limit], measured: &Figures, simulated: Option<&Figures>) -> Certificate {
    let verdict = |limit: &Limit, value: Option<&Value>| match value {
        None => Verdict::NotTested,
        Some(value) if limit.holds(value.value) => Verdict::Pass,
        Some(_) => Verdict::Fail,
    };
    let limits: Vec<Checked> = limits
        .iter()
        .map(|limit| {
            let found = measured.value(limit);
            let by_model = simulated.map(|figures| figures.value(limit));
            Checked {
                limit: limit.clone(),
                verdict: verdict(limit, found.as_ref()),
                model_verdict: by_model.as_ref().map(|value| verdict(limit, value.as_ref())),
                measured: found,
                model: by_model.flatten(),
            }
        })
        .collect();
    let peaks = measured.points().enumerate().map(|(k, point)| PeakPoint {
        test: point.test.clone(),
        amplitude_m: point.amplitude,
        velocity_m_s: point.peak.velocity_m_s,
        force_n: point.peak.force_n,
        model_n: simulated.and_then(|figures| figures.points().nth(k)).map(|p| p.peak.force_n),
    });
    Certificate {
        passed: limits.iter().all(|l| l.verdict == Verdict::Pass),
        overall: Overall::of(limits.iter().map(|l| l.verdict)),
        model_passed: simulated.map(|_| limits.iter().all(|l| l.model_verdict == Some(Verdict::Pass))),
        peaks: peaks.collect(),
        limits,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;
    use std::path::Path;

    /// Makes a test of a damper with a hysteresis loop.
    ///
    /// The damper has 2000 N s/m in rebound, 800 N s/m in compression, 30 N of friction and 150 N of gas force.
    fn test(name: &str, amplitude: f64, peak: f64) -> Record {
        let (n, cycles, w) = (400, 4, peak / amplitude);
        let mut record = Record {
            name: name.into(),
            amplitude,
            frequency: w / TAU,
            peak_velocity: peak,
            cycles: (0..cycles).map(|c| n * c..n * (c + 1)).collect(),
            ..Record::default()
        };
        for i in 0..n * cycles {
            // The phase is shifted by half a step, so that no sample has zero velocity.
            let phase = TAU * (i as f64 + 0.5) / n as f64;
            let v = peak * libm::cos(phase);
            record.time.push(phase / w);
            record.displacement.push(amplitude * libm::sin(phase));
            record.velocity.push(v);
            let damping = if v > 0.0 { 2000.0 } else { 800.0 };
            record.force.push(damping * v + 30.0 * v.signum() - 150.0 + 40.0 * peak * libm::sin(phase));
        }
        record
    }

    fn answer(text: &str, model: f64) -> Certificate {
        let records = [test("fast", 0.05, 0.524), test("short", 0.005, 0.524), test("slow", 0.05, 0.0026)];
        let records: Vec<&Record> = records.iter().collect();
        let forces: Vec<Vec<f64>> = records.iter().map(|r| r.force.iter().map(|f| model * f).collect()).collect();
        let forces: Vec<&[f64]> = forces.iter().map(Vec::as_slice).collect();
        judge(&parse(Path::new("l.csv"), text).unwrap(), &records, Some(&forces))
    }

    #[test]
    fn friction_of_a_stiff_valve_is_told_as_damping() {
        let limits = parse("l.csv".as_ref(), "quantity,high\nfriction,60\n").unwrap();
        // Damping at the peak velocity, N.
        for (damping, wanted) in [(1.5, None), (150.0, Some(0.87 * 150.0))] {
            let mut record = test("slow", 0.05, 0.005);
            record.force = record.velocity.iter().map(|v| damping * v / 0.005 + 30.0 * v.signum() - 150.0).collect();
            let found = judge(&limits, &[&record], None);
            let (told, measured) = (found.limits[0].damping_in_friction(), &found.limits[0].measured);
            assert_eq!(told.is_some(), wanted.is_some(), "{measured:?}");
            let is_near = |(told, wanted): (f64, f64)| (told / wanted - 1.0).abs() < 0.1;
            assert!(told.zip(wanted).is_none_or(is_near), "{told:?}: {measured:?}");
        }
    }

    #[test]
    fn the_figures_are_those_of_the_damper() {
        let found = answer(
            "quantity,velocity_m_s,low,high\nforce,0.52,900,940\nforce,-0.52,-630,-580\ngas_force,,140,160\nfriction,,25,35\n\
             hysteresis,0.52,0,60\n",
            1.0,
        );
        let value = |k: usize| found.limits[k].measured.as_ref().unwrap().value;
        // The mean velocity of the samples within 2 % of the peak velocity is 0.5206 m/s, 0.7 % below the peak.
        assert!((value(0) - (2000.0 * 0.5206 + 30.0 - 150.0)).abs() < 6.0, "{}", value(0));
        assert!((value(1) + 800.0 * 0.5206 + 30.0 + 150.0).abs() < 4.0, "{}", value(1));
        // At 2.3 mm/s, the median speed of the sliding samples, the damper adds 4.6 N in rebound and 1.8 N in compression. So half the
        // difference of the strokes is 33.2 N, and their mean changes by 1.4 N.
        assert!((value(2) - 148.6).abs() < 0.5 && (value(3) - 33.2).abs() < 0.5, "{} {}", value(2), value(3));
        assert!(value(4) > 10.0 && value(4) < 60.0, "{}", value(4));
        assert!(found.passed && found.model_passed == Some(true), "{found:?}");
        assert_eq!(found.limits[0].measured.as_ref().unwrap().tests, ["fast"], "the longest stroke is read");
    }

    #[test]
    fn one_window_missed_fails_the_damper_and_the_model_by_itself() {
        let text = "quantity,velocity_m_s,low,high\nforce,0.52,900,940\n";
        let high = answer(&text.replace("940", "910"), 1.0);
        assert!(!high.passed && high.limits[0].verdict == Verdict::Fail);
        let model = answer(text, 1.1);
        assert!(model.passed && model.model_passed == Some(false));
    }

    #[test]
    fn what_was_not_tested_is_no_pass() {
        let found = answer("quantity,velocity_m_s,low,high\nforce,1.5,900,940\n", 1.0);
        assert!(!found.passed && found.limits[0].verdict == Verdict::NotTested && found.limits[0].measured.is_none());
        assert_eq!(found.overall, Overall::Incomplete);
        // One violated limit fails the damper in any order of the limits, even if other limits were not tested.
        let (missed, kept) = ("force,0.52,0,10\n", "force,0.52,900,940\n");
        for (rows, overall) in [
            ([missed, "force,1.5,900,940\n"], Overall::Fail),
            (["force,1.5,900,940\n", missed], Overall::Fail),
            (["force,1.5,900,940\n", kept], Overall::Incomplete),
            ([kept, kept], Overall::Pass),
        ] {
            let found = answer(&format!("quantity,velocity_m_s,low,high\n{}", rows.concat()), 1.0);
            assert_eq!(found.overall, overall, "{rows:?}");
            assert_eq!(found.passed, overall == Overall::Pass);
        }
    }

    #[test]
    fn a_stroke_can_be_asked_for() {
        let found = answer("quantity,velocity_m_s,amplitude_m,low,high\nforce,0.52,0.005,900,940\n", 1.0);
        assert_eq!(found.limits[0].measured.as_ref().unwrap().tests, ["short"]);
    }
}
