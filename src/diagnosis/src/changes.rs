//! Changes relative to a reference damper: the smallest set of changes that explains the difference.

use super::phrases;
use dashpot_core::{Params, list};
use dashpot_estimation::curve_part::{CurvePart, Side, Speeds};
use dashpot_estimation::hypothesis::Free;
use dashpot_estimation::structure::context::Structure;
use dashpot_estimation::unknowns::Unknown;
use dashpot_messages::Sentence;
use dashpot_records::{Reading, reading_unit};
use serde::Serialize;

/// One change compared with the reference damper.
#[derive(Debug, Clone, Serialize)]
pub struct Change {
    /// Name of a parameter of the model, or of a part of its FV curve.
    pub name: &'static str,
    /// Value of the reference damper. For a part of the FV curve, it is the force at [`Change::velocity_m_s`].
    pub reference: f64,
    /// Value of this damper.
    pub value: f64,
    /// Lower end of the 95 % interval of `value`, on the assumption that `reference` is exact. The lower end of the
    /// interval of the change is `low` minus `reference`.
    pub low: f64,
    /// Upper end of the 95 % interval of `value`, on the assumption that `reference` is exact.
    pub high: f64,
    /// Unit of `reference`, `value`, `low` and `high`.
    pub unit: &'static str,
    /// Velocity at which the forces of a part of the FV curve are stated, m/s, rebound positive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity_m_s: Option<f64>,
    /// Calibrated probability that this parameter changed.
    pub probability: f64,
    /// Root mean square force that the change causes in the fitted tests, N.
    pub force_n_rms: f64,
}

/// Returns the velocity, m/s, rebound positive, at which the force of a part of the FV curve is stated. The wanted
/// speed is 0.05 m/s for low speeds, 0.3 m/s for all speeds and 1 m/s for high speeds. The nearest point of the curve
/// in the stroke direction gives the velocity. Without such a point, it is the wanted speed itself.
fn velocity_of(part: CurvePart, base: &Params) -> f64 {
    let velocity = base.list(list!("fv_velocity"));
    let is_rebound = part.side != Side::Compression;
    let side = |v: &&f64| if is_rebound { **v > 0.0 } else { **v < 0.0 };
    let speeds: Vec<f64> = velocity.iter().filter(side).map(|v| v.abs()).collect();
    let wanted = match part.speeds {
        Speeds::Low => 0.05,
        Speeds::All => 0.3,
        Speeds::High => 1.0,
    };
    let nearest =
        speeds.iter().copied().min_by(|a, b| (a - wanted).abs().total_cmp(&(b - wanted).abs())).unwrap_or(wanted);
    if is_rebound { nearest } else { -nearest }
}

fn force_at(params: &Params, velocity: f64) -> f64 {
    let (v, f) = (params.list(list!("fv_velocity")), params.list(list!("fv_force")));
    let near = (0..v.len()).min_by(|a, b| (v[*a] - velocity).abs().total_cmp(&(v[*b] - velocity).abs()));
    near.map_or(0.0, |k| f[k])
}

/// Lists the changes of a structure relative to its base, the reference damper, largest force first. `ends` contains
/// the 95 % intervals of the structure's free parameters.
///
/// `probability` and `force` return the probability and the force, N rms, of an effect from its name.
pub fn changes(
    structure: &Structure,
    ends: &[[f64; 2]],
    probability: &dyn Fn(&str) -> f64,
    force: &dyn Fn(&str) -> f64,
) -> Vec<Change> {
    let Structure { hypothesis, refit, .. } = structure;
    let (before, after) = (&hypothesis.base, hypothesis.params(&refit.theta));
    let mut all: Vec<Change> = hypothesis
        .numbers
        .iter()
        .enumerate()
        .filter_map(|(k, number)| {
            let delta = refit.theta[k];
            let ends = ends[k];
            let change = match number.free {
                Free::Shift(unknown) => {
                    let (Unknown::Log(own) | Unknown::Linear(own) | Unknown::Above(own, _)) = unknown else {
                        return None;
                    };
                    let (reference, value) = (before.number(own), after.number(own));
                    let end = |d: f64| match unknown {
                        Unknown::Log(_) => reference * libm::exp(d),
                        Unknown::Linear(_) => reference + d,
                        _ => value + (d - delta) * reference,
                    };
                    Change {
                        name: own.name(),
                        reference,
                        value,
                        low: end(ends[0]),
                        high: end(ends[1]),
                        unit: own.parameter().unit,
                        velocity_m_s: None,
                        probability: probability(own.name()),
                        force_n_rms: force(own.name()),
                    }
                }
                Free::Curve(part) => {
                    let velocity = velocity_of(part, before);
                    let (reference, value) = (force_at(before, velocity), force_at(&after, velocity));
                    let per = if delta == 0.0 { 0.0 } else { (value - reference) / delta };
                    let ends = ends.map(|end| value + (end - delta) * per);
                    Change {
                        name: part.name(),
                        reference,
                        value,
                        low: ends[0].min(ends[1]),
                        high: ends[0].max(ends[1]),
                        unit: "N",
                        velocity_m_s: Some(velocity),
                        probability: probability(part.name()),
                        force_n_rms: force(part.name()),
                    }
                }
                _ => return None,
            };
            Some(change)
        })
        .collect();
    all.sort_by(|a, b| b.force_n_rms.total_cmp(&a.force_n_rms));
    all
}

impl Change {
    /// Formats the value of this damper and its interval with the digits that all tables and sentences use.
    pub fn reading(&self) -> Reading {
        Reading::new(self.value, self.low, self.high, self.unit)
    }

    /// Returns the name of the change in a table.
    pub fn label(&self) -> String {
        match self.velocity_m_s {
            Some(velocity) => format!("{}, {:.0} mm/s", self.name, 1e3 * velocity),
            None => self.name.to_owned(),
        }
    }

    /// Returns whether the 95 % interval contains the value of the reference damper.
    fn may_be_none(&self) -> bool {
        (self.low..=self.high).contains(&self.reference)
    }

    /// Formats the change as a sentence, for example "gas_force -14.7 -> 24.0 N". If the interval contains the reference,
    /// the sentence has the interval and says so.
    pub fn sentence(&self) -> Sentence {
        let change = self.sentence_without_interval();
        if !self.may_be_none() {
            return change;
        }
        let reading = self.reading();
        Sentence::from(phrases::UNCERTAIN_CHANGE)
            .with_sentence("change", change)
            .with("low", reading.low)
            .with("high", reading.high)
            .with("unit", reading.unit)
    }

    fn sentence_without_interval(&self) -> Sentence {
        // The unit is that of this damper's value, as in the table of changes. The reference has this unit as well.
        let reading = self.reading();
        let (factor, _) = reading_unit(self.value, self.unit);
        let reference = Reading::in_unit([factor * self.reference, f64::NAN, f64::NAN], &reading.unit).value;
        if let Some(velocity) = self.velocity_m_s {
            let said = match self.name {
                "fv_curve" => phrases::CHANGED_BOTH,
                "rebound_curve" => phrases::CHANGED_REBOUND,
                "compression_curve" => phrases::CHANGED_COMPRESSION,
                "rebound_low_speed" => phrases::CHANGED_REBOUND_LOW,
                "compression_low_speed" => phrases::CHANGED_COMPRESSION_LOW,
                "rebound_high_speed" => phrases::CHANGED_REBOUND_HIGH,
                _ => phrases::CHANGED_COMPRESSION_HIGH,
            };
            let percent = if self.reference == 0.0 { 0.0 } else { 100.0 * (self.value / self.reference - 1.0) };
            return Sentence::from(said)
                .with("percent", format!("{percent:+.0}"))
                .with("velocity", format!("{:.0}", 1e3 * velocity.abs()))
                .with("reference", reference)
                .with("value", reading.value);
        }
        let value = reading.with_unit();
        Sentence::from(phrases::OTHER_NUMBER).with("name", self.name).with("reference", reference).with("value", value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_whose_interval_contains_the_reference_says_so() {
        let change = |low: f64, high: f64| Change {
            name: "rebound_curve",
            reference: 1570.0,
            value: 1312.0,
            low,
            high,
            unit: "N",
            velocity_m_s: Some(0.324),
            probability: 0.93,
            force_n_rms: 151.0,
        };
        let sure = change(1306.0, 1330.0).sentence().to_string();
        assert!(sure.contains("-16 %") && !sure.contains("interval"), "{sure}");
        let unsure = change(1306.0, 1988.0).sentence().to_string();
        assert!(unsure.ends_with("(uncertain: the 95 % interval, 1306 to 1988 N, contains the reference)"), "{unsure}");
    }
}
