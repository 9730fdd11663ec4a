//! Checks of a damper over a setting against limits. The tests at the setting of a limit decide about the limit.

use super::measured::Figures;
use super::table::{Limit, Quantity};
use super::{Certificate, Checked, Overall, Value, Verdict};
use crate::validation::{ResponseTimes, StepGroup, StepResponse, TimeUncertainty};
use dashpot_messages::format_number;
use dashpot_records::{Record, is_same_setting, restate_in_unit};
use serde::{Deserialize, Serialize};

/// Reason why limits do not match the damper.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SettingLimitError {
    /// A limit has no setting, but the tests have several settings.
    #[error(
        "the limit {name} in line {line} says no setting, and the tests have several: give the table a column setting, or validate the damper at one, written with dashpot setting"
    )]
    Without {
        /// Name of the limit.
        name: String,
        /// Line of the limit.
        line: u64,
    },
    /// A limit has a setting, but the damper has none.
    #[error(
        "the limit {name} in line {line} holds at the setting {}, and the damper depends on none: leave the column setting out",
        format_number(*setting)
    )]
    OfOrdinary {
        /// Name of the limit.
        name: String,
        /// Line of the limit.
        line: u64,
        /// Setting of the limit.
        setting: f64,
    },
    /// The unit of a limit's setting and the damper's unit belong to different quantities.
    #[error("the limit {name} in line {line} has its setting in {unit}, the damper in {own}: write it in {own}")]
    OtherUnit {
        /// Name of the limit.
        name: String,
        /// Line of the limit.
        line: u64,
        /// Unit of the limit's setting.
        unit: String,
        /// Unit of the damper's setting, or "no unit".
        own: String,
    },
}

/// Converts the settings of limits to `own`, the unit of the damper's setting, and states this unit in every limit. A setting without a unit
/// keeps its value.
///
/// # Errors
/// Returns the first limit whose unit belongs to another quantity, or that has a unit while the damper's setting has none.
pub fn restate_settings_of_limits(limits: &mut [Limit], own: &str) -> Result<(), SettingLimitError> {
    for limit in limits {
        // If the damper's setting has no unit, a limit with a unit cannot be converted, so it is rejected.
        let is_stated = !limit.setting_unit.is_empty();
        if is_stated && (own.is_empty() || !restate_in_unit(&mut limit.setting_unit, own, &mut limit.setting)) {
            return Err(SettingLimitError::OtherUnit {
                name: limit.name.clone(),
                line: limit.line,
                unit: limit.setting_unit.clone(),
                own: if own.is_empty() { "no unit".to_owned() } else { own.to_owned() },
            });
        }
        limit.setting_unit = own.to_owned();
    }
    Ok(())
}

/// Checks that no limit has a setting.
///
/// # Errors
/// Returns the first limit with a setting.
pub fn check_without_setting(limits: &[Limit]) -> Result<(), SettingLimitError> {
    match limits.iter().find_map(|limit| Some((limit, limit.setting?))) {
        None => Ok(()),
        Some((limit, setting)) => {
            Err(SettingLimitError::OfOrdinary { name: limit.name.clone(), line: limit.line, setting })
        }
    }
}

/// Checks that each limit on a force has a setting if the records have several settings. A limit on a response time needs no setting,
/// because it then applies to all steps.
///
/// # Errors
/// Returns the first limit without a setting.
pub fn check_over_settings(limits: &[Limit], settings: &[Option<f64>]) -> Result<(), SettingLimitError> {
    let first = settings.iter().flatten().next().copied();
    let is_one = settings.iter().flatten().all(|setting| first.is_some_and(|first| is_same_setting(*setting, first)));
    match limits.iter().find(|limit| limit.setting.is_none() && !limit.quantity.is_time() && !is_one) {
        Some(without) => Err(SettingLimitError::Without { name: without.name.clone(), line: without.line }),
        None => Ok(()),
    }
}

/// Response times of the steps from one setting to another, over all of them or in one test and stroke direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct StepTimes {
    from: f64,
    to: f64,
    tests: Vec<String>,
    times: ResponseTimes,
    uncertainty: Option<TimeUncertainty>,
}

/// Figures of a damper over a setting, measured from its records, that decide about every limit. Serde can store them as text.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SettingsFigures {
    /// Figures of the tests at each constant setting.
    at: Vec<(f64, Figures)>,
    steps: Vec<StepTimes>,
}

impl SettingsFigures {
    /// Measures the figures of the records, and copies the measured times of `responses`. `settings` contains the setting of every record,
    /// or `None` if the setting changes within the record.
    pub fn measure((records, settings): (&[&Record], &[Option<f64>]), responses: &[StepResponse]) -> Self {
        // Store the times of each group of steps too, because a mean over tests and stroke directions could conceal a slow response.
        let all = |of: &StepResponse| Some((of.measured?, of.uncertainty, of.tests.clone()));
        let each = |of: &StepGroup| Some((of.measured?, of.uncertainty, vec![of.test.clone()]));
        Self { at: figures_at(records, settings, None), steps: steps(responses, all, each) }
    }

    /// Computes the figures of a model on the same records. `forces` contains its forces at the samples of each record.
    fn of_model(
        (records, settings): (&[&Record], &[Option<f64>]),
        forces: &[&[f64]],
        responses: &[StepResponse],
    ) -> Self {
        // The times of the model are computed, so they have no measurement uncertainty.
        let all = |of: &StepResponse| Some((of.model?, None, of.tests.clone()));
        let each = |of: &StepGroup| Some((of.model?, None, vec![of.test.clone()]));
        Self { at: figures_at(records, settings, Some(forces)), steps: steps(responses, all, each) }
    }

    /// Compares limits with these figures. If `model` is given, the limits are also compared with these figures of the model on the same
    /// records.
    ///
    /// A limit on a response time applies to all steps in its direction. If the limit has a setting, it applies only to the steps that end at
    /// this setting.
    ///
    /// # Errors
    /// The errors of [`check_over_settings`].
    pub fn judge(&self, limits: &[Limit], model: Option<&SettingsFigures>) -> Result<Certificate, SettingLimitError> {
        let settings: Vec<Option<f64>> = self.at.iter().map(|(setting, _)| Some(*setting)).collect();
        check_over_settings(limits, &settings)?;
        let none = Figures::measure(&[], None);
        let mut checked = Vec::new();
        let mut peaks = Vec::new();
        let mut judged: Vec<f64> = Vec::new();
        for limit in limits {
            if limit.quantity.is_time() {
                checked.push(self.judge_time(limit, model));
                continue;
            }
            // A limit without a setting is not tested if the setting changes in every record.
            let setting = limit.setting.or(settings.first().copied().flatten());
            let own = setting.and_then(|setting| self.figures(setting)).unwrap_or(&none);
            let of_model = setting.zip(model).and_then(|(setting, model)| model.figures(setting));
            let found = own.judge(std::slice::from_ref(limit), model.map(|_| of_model.unwrap_or(&none)));
            checked.extend(found.limits);
            if let Some(setting) = setting.filter(|own| !judged.iter().any(|known| is_same_setting(*known, *own))) {
                judged.push(setting);
                peaks.extend(found.peaks);
            }
        }
        Ok(Certificate {
            passed: checked.iter().all(|l| l.verdict == Verdict::Pass),
            overall: Overall::of(checked.iter().map(|l| l.verdict)),
            model_passed: model.map(|_| checked.iter().all(|l| l.model_verdict == Some(Verdict::Pass))),
            limits: checked,
            peaks,
        })
    }

    /// Returns the figures at a setting, or `None` if no test is there.
    fn figures(&self, setting: f64) -> Option<&Figures> {
        self.at.iter().find(|(own, _)| is_same_setting(*own, setting)).map(|(_, figures)| figures)
    }

    /// Compares a limit on a response time with the slowest response to which the limit applies.
    fn judge_time(&self, limit: &Limit, model: Option<&SettingsFigures>) -> Checked {
        let measured = self.slowest(limit);
        let simulated = model.map(|model| model.slowest(limit));
        let verdict = |value: Option<&Value>| match value {
            None => Verdict::NotTested,
            Some(value) if limit.holds(value.value) => Verdict::Pass,
            Some(_) => Verdict::Fail,
        };
        Checked {
            limit: limit.clone(),
            verdict: verdict(measured.as_ref()),
            model_verdict: simulated.as_ref().map(|value| verdict(value.as_ref())),
            measured,
            model: simulated.flatten(),
        }
    }

    /// Returns the longest time to which a limit on a response time applies.
    fn slowest(&self, limit: &Limit) -> Option<Value> {
        let is_up = matches!(limit.quantity, Quantity::ResponseTimeUp | Quantity::RiseTimeUp);
        let is_rise = matches!(limit.quantity, Quantity::RiseTimeUp | Quantity::RiseTimeDown);
        let is_own = |of: &&StepTimes| {
            (of.to > of.from) == is_up && limit.setting.is_none_or(|setting| is_same_setting(of.to, setting))
        };
        let value = |of: &StepTimes| Value {
            value: if is_rise { of.times.t90_s - of.times.t10_s } else { of.times.t63_s },
            tests: of.tests.clone(),
            uncertainty: of.uncertainty.map(|of| if is_rise { of.rise_s } else { of.t63_s }),
            damping: None,
            step: Some((of.from, of.to)),
        };
        self.steps.iter().filter(is_own).map(value).max_by(|a, b| a.value.total_cmp(&b.value))
    }
}

/// Measures the figures of the records at each constant setting. `forces` replaces the measured forces if it is given.
fn figures_at(records: &[&Record], settings: &[Option<f64>], forces: Option<&[&[f64]]>) -> Vec<(f64, Figures)> {
    let mut distinct: Vec<f64> = Vec::new();
    for setting in settings.iter().flatten() {
        if !distinct.iter().any(|known| is_same_setting(*known, *setting)) {
            distinct.push(*setting);
        }
    }
    let of_one = |setting: f64| {
        let is_own = |k: &usize| settings[*k].is_some_and(|own| is_same_setting(own, setting));
        let own: Vec<usize> = (0..records.len()).filter(is_own).collect();
        let of: Vec<&Record> = own.iter().map(|k| records[*k]).collect();
        let forces: Option<Vec<&[f64]>> = forces.map(|all| own.iter().map(|k| all[*k]).collect());
        (setting, Figures::measure(&of, forces.as_deref()))
    };
    distinct.into_iter().map(of_one).collect()
}

/// Times of a response, their uncertainty, and the names of their tests.
type Times = Option<(ResponseTimes, Option<TimeUncertainty>, Vec<String>)>;

/// Collects the times of all responses, first those over all steps, then those of each group of steps.
fn steps(
    responses: &[StepResponse],
    of_all: impl Fn(&StepResponse) -> Times,
    of_each: impl Fn(&StepGroup) -> Times,
) -> Vec<StepTimes> {
    let all = responses.iter().map(|of| (of, of_all(of)));
    let of_each = &of_each;
    let each = responses.iter().flat_map(|of| of.groups.iter().map(move |group| (of, of_each(group))));
    let step = |(of, times): (&StepResponse, Times)| {
        times.map(|(times, uncertainty, tests)| StepTimes { from: of.from, to: of.to, tests, times, uncertainty })
    };
    all.chain(each).filter_map(step).collect()
}

/// Compares limits with the records of a damper over a setting and with the forces of its model. `model` contains these forces at the
/// samples of each record.
///
/// `settings` contains the setting of every record, or `None` if the setting changes within the record.
///
/// # Errors
/// The errors of [`check_over_settings`].
pub fn judge_over_settings(
    limits: &[Limit],
    own: (&[&Record], &[Option<f64>]),
    model: &[&[f64]],
    responses: &[StepResponse],
) -> Result<Certificate, SettingLimitError> {
    let simulated = SettingsFigures::of_model(own, model, responses);
    SettingsFigures::measure(own, responses).judge(limits, Some(&simulated))
}

#[cfg(test)]
mod tests {
    use super::super::table::parse;
    use super::*;
    use std::f64::consts::TAU;

    /// Makes a test of a damper with the damping coefficient `damping`, N s/m.
    fn test(name: &str, damping: f64) -> Record {
        let (n, cycles, w) = (400, 4, 10.0);
        let mut record = Record {
            name: name.into(),
            amplitude: 0.05,
            frequency: w / TAU,
            peak_velocity: 0.5,
            cycles: (0..cycles).map(|c| n * c..n * (c + 1)).collect(),
            ..Record::default()
        };
        for i in 0..n * cycles {
            let phase = TAU * (i as f64 + 0.5) / n as f64;
            record.time.push(phase / w);
            record.displacement.push(0.05 * libm::sin(phase));
            record.velocity.push(0.5 * libm::cos(phase));
            record.force.push(damping * 0.5 * libm::cos(phase));
        }
        record
    }

    fn judged(text: &str) -> Result<Certificate, SettingLimitError> {
        let all = [test("soft", 1000.0), test("hard", 4000.0)];
        let records: Vec<&Record> = all.iter().collect();
        let forces: Vec<&[f64]> = all.iter().map(|record| record.force.as_slice()).collect();
        judge_over_settings(
            &parse("l.csv".as_ref(), text).unwrap(),
            (&records, &[Some(0.0), Some(1.6)]),
            &forces,
            &responses(),
        )
    }

    /// Makes step responses with different times until 63 % of the change. From 0 to 1.6, the time is 12 ms, from 0 to 0.8 it is 9 ms, and
    /// from 1.6 to 0 it is 20 ms.
    fn responses() -> Vec<StepResponse> {
        let of = |from: f64, to: f64, t63_s: f64| {
            let times = ResponseTimes { t10_s: 0.003, t63_s, t90_s: 2.0 * t63_s, overshoot: 0.0 };
            StepResponse {
                from,
                to,
                steps: 3,
                tests: vec![format!("{from} {to}")],
                sample_s: 1e-3,
                end_fraction: 1.0,
                groups: Vec::new(),
                measured: Some(times),
                uncertainty: Some(TimeUncertainty { t63_s: 0.0005, t90_s: 0.001, rise_s: 0.0008 }),
                model: None,
                time: Vec::new(),
                measured_response: Vec::new(),
                model_response: Vec::new(),
            }
        };
        vec![of(0.0, 1.6, 0.012), of(0.0, 0.8, 0.009), of(1.6, 0.0, 0.020)]
    }

    #[test]
    fn a_limit_is_not_tested_where_the_setting_changes_in_every_record() {
        let all = [test("road", 1000.0)];
        let found = judge_over_settings(
            &parse("l.csv".as_ref(), "quantity,velocity_m_s,high\nforce,0.5,900\n").unwrap(),
            (&[&all[0]], &[None]),
            &[all[0].force.as_slice()],
            &[],
        )
        .unwrap();
        assert_eq!(found.limits.iter().map(|l| l.verdict).collect::<Vec<_>>(), [Verdict::NotTested]);
        assert!(!found.passed);
    }

    #[test]
    fn a_time_is_that_of_the_slowest_response() {
        let found = judged(
            "quantity,setting,high,unit\nresponse_time_up,,11,ms\nresponse_time_up,0.8,11,ms\nrise_time_down,,40,ms\nrise_time_up,0.3,40,ms\n",
        )
        .unwrap();
        let verdicts: Vec<Verdict> = found.limits.iter().map(|l| l.verdict).collect();
        assert_eq!(verdicts, [Verdict::Fail, Verdict::Pass, Verdict::Pass, Verdict::NotTested]);
        assert_eq!(found.limits[0].measured.as_ref().unwrap().tests, ["0 1.6"]);
        assert!((found.limits[2].measured.as_ref().unwrap().value - 0.037).abs() < 1e-12);
        // JSON has the figures in seconds, and their keys end in the unit.
        let json = serde_json::to_value(&found.limits[0]).unwrap();
        assert_eq!(json["measured"]["uncertainty_s"], 0.0005);
        // The limits apply to the slowest step upward, from 0 to 1.6, and to the only step downward.
        assert_eq!(json["measured"]["step"], serde_json::json!([0.0, 1.6]));
        assert_eq!(found.limits[2].measured.as_ref().unwrap().step, Some((1.6, 0.0)));
        // The uncertainty of 0.5 ms does not decide about the limit of 11 ms, because the value 12 ms is 1 ms away.
        assert_eq!(found.limits[0].deciding_uncertainty(), None);
        let near =
            judged("quantity,setting,high,unit\nresponse_time_up,1.6,11.8,ms\nresponse_time_up,1.6,12.2,ms\n").unwrap();
        let verdicts: Vec<_> = near.limits.iter().map(|l| (l.verdict, l.deciding_uncertainty())).collect();
        assert_eq!(verdicts, [(Verdict::Fail, Some(0.0005)), (Verdict::Pass, Some(0.0005))]);
        assert_eq!((&json["high_s"], &json["measured"]["value_s"]), (&0.011.into(), &0.012.into()));
        assert!(json.get("high_n").is_none() && json["measured"].get("value_n").is_none(), "{json}");
    }

    #[test]
    fn each_window_is_judged_by_the_tests_at_its_setting() {
        let found = judged(
            "quantity,velocity_m_s,setting,low,high\nforce,0.5,0,450,550\nforce,0.5,1.6,1900,2100\nforce,0.5,0.8,1,2\n",
        )
        .unwrap();
        let verdicts: Vec<Verdict> = found.limits.iter().map(|l| l.verdict).collect();
        assert_eq!(verdicts, [Verdict::Pass, Verdict::Pass, Verdict::NotTested]);
        assert_eq!(found.overall, Overall::Incomplete);
        assert_eq!(found.limits[1].measured.as_ref().unwrap().tests, ["hard"]);
        assert_eq!(found.peaks.len(), 4);
    }

    #[test]
    fn stored_figures_judge_as_the_records_do() {
        let all = [test("soft", 1000.0), test("hard", 4000.0)];
        let records: Vec<&Record> = all.iter().collect();
        let text = "quantity,velocity_m_s,setting,low,high,unit\nforce,0.5,1.6,1900,2100,N\nforce,0.5,0.8,1,2,N\nresponse_time_up,,,,11,ms\n";
        let limits = parse("l.csv".as_ref(), text).unwrap();
        let figures = SettingsFigures::measure((&records, &[Some(0.0), Some(1.6)]), &responses());
        let stored: SettingsFigures = serde_json::from_str(&serde_json::to_string(&figures).unwrap()).unwrap();
        let found = stored.judge(&limits, None).unwrap();
        let of_records = judged(text).unwrap();
        assert_eq!(
            found.limits.iter().map(|l| (l.verdict, &l.measured)).collect::<Vec<_>>(),
            of_records.limits.iter().map(|l| (l.verdict, &l.measured)).collect::<Vec<_>>()
        );
        assert_eq!(found.overall, Overall::Fail);
        assert!(found.model_passed.is_none() && found.limits.iter().all(|l| l.model_verdict.is_none()));
    }

    #[test]
    fn settings_of_windows_are_restated_in_the_unit_of_the_damper() {
        let read = || parse("l.csv".as_ref(), "quantity,setting,high\nfriction,1.6,2\nfriction,500mA,2\n").unwrap();
        let mut limits = read();
        restate_settings_of_limits(&mut limits, "A").unwrap();
        assert_eq!(limits.iter().map(|l| l.setting.unwrap()).collect::<Vec<_>>(), [1.6, 0.5]);
        assert!(limits.iter().all(|l| l.setting_unit == "A"));
        for own in ["bar", ""] {
            let wrong = restate_settings_of_limits(&mut read(), own).unwrap_err().to_string();
            assert!(wrong.contains("line 3") && wrong.contains("mA"), "{wrong}");
        }
    }

    #[test]
    fn a_window_without_a_setting_is_rejected_with_its_line() {
        let wrong = judged("quantity,velocity_m_s,setting,low,high\nforce,0.5,0,1,2\nforce,0.5,,1,2\n").unwrap_err();
        assert!(wrong.to_string().contains("line 3") && wrong.to_string().contains("dashpot setting"), "{wrong}");
        let limits = parse("l.csv".as_ref(), "quantity,setting,high\nfriction,1.6,2\n").unwrap();
        assert!(check_without_setting(&limits).unwrap_err().to_string().contains("line 2"));
    }
}
