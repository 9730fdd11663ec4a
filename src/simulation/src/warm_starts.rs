//! Temperature of the damper at the start of each record.
//!
//! A model with a heat balance starts cold in every simulation, although the preceding tests have warmed the oil on the rig. For records
//! with a common clock, the rise ϑ of the oil temperature, K, follows from C_h dϑ/dt = F v − h ϑ. C_h is the heat capacity, J/K, and h the
//! heat transfer, W/K. The force F, N, and the velocity v, m/s, are measured, and F v is 0 in pauses.

use dashpot_core::{Model, Params, State, element, number};
use dashpot_estimation::heating::Heating;
use dashpot_records::Record;

/// Cooling rate, 1/s, that replaces smaller rates, including zero. It removes only a thousandth of the temperature rise in a day.
const NONE: f64 = 1e-8;

/// Heat that the damper absorbed in a campaign.
pub struct WarmStarts(Heating);

impl WarmStarts {
    /// Computes the heat that the damper absorbed in these records.
    pub fn new(records: &[&Record]) -> WarmStarts {
        WarmStarts(Heating::new(records, &[]))
    }

    /// Returns the rise of the oil's temperature, K, at the start of the record with the index `place`.
    ///
    /// Returns 0 if the model has no heat balance, or if every record has a separate clock.
    pub fn rise(&self, params: &Params, place: usize) -> f64 {
        let heats = params.is_on(element!("temperature_fade")) && params.number(number!("fade_source")) == 1.0;
        if !heats {
            return 0.0;
        }
        let capacity = params.number(number!("heat_capacity"));
        let cooling = params.number(number!("heat_transfer")) / capacity;
        self.0.at_the_begin(place, cooling.max(NONE)) / capacity
    }
}

/// Sets the rise of the oil's temperature, K, in a state. Does nothing if the model has no such internal state.
pub(crate) fn warm(model: &Model, state: &mut State, rise: f64) {
    let is_heat = |k: &usize| model.state_name(*k).is_some_and(|(name, _)| name == "oil_temperature_rise");
    // The first two states belong to the internal mass.
    if let Some(k) = (2..model.states()).find(is_heat) {
        state.internal[k - 2] = rise;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prediction::predict;
    use dashpot_records::smoothing::smooth;
    use std::f64::consts::TAU;

    /// Makes a record of ten cycles of high power that begins at the time `clock_s` of the campaign.
    fn record(clock_s: f64) -> Record {
        let time: Vec<f64> = (0..5000).map(|k| 1e-3 * f64::from(k)).collect();
        let omega = TAU * 2.0;
        Record {
            displacement: time.iter().map(|t| 0.05 * libm::sin(omega * t)).collect(),
            velocity: time.iter().map(|t| 0.05 * omega * libm::cos(omega * t)).collect(),
            force: vec![0.0; time.len()],
            amplitude: 0.05,
            frequency: 2.0,
            peak_velocity: 0.05 * omega,
            clock_s,
            time,
            ..Record::default()
        }
    }

    #[test]
    fn a_model_goes_on_as_warm_as_the_tests_before_made_it() {
        let mut params = Params::new();
        params.enable(element!("temperature_fade"), true);
        for (name, value) in [
            (number!("fade_source"), 1.0),
            (number!("fade_coefficient"), 0.02),
            (number!("heat_capacity"), 300.0),
            (number!("heat_transfer"), 2.0),
        ] {
            params.set(name, value).unwrap();
        }
        let model = Model::new(&params).unwrap();
        // The measured forces of both records come from one simulation of the model, with a pause of 0.5 s between the records.
        let whole = {
            let (a, b) = (record(0.0), record(0.0));
            let rest = 0.5;
            let time: Vec<f64> = a.time.iter().copied().chain(b.time.iter().map(|t| 5.0 + rest + t)).collect();
            let joined = |a: &[f64], b: &[f64]| [a, b].concat();
            Record {
                displacement: joined(&a.displacement, &b.displacement),
                velocity: joined(&a.velocity, &b.velocity),
                force: vec![0.0; time.len()],
                time,
                ..a.clone()
            }
        };
        let forces = predict(&model, &whole, &smooth(&whole), 0.0);
        let [mut first, mut second] = [record(0.0), record(5.5)];
        (first.force, second.force) = (forces[..5000].to_vec(), forces[5000..].to_vec());
        let rise = WarmStarts::new(&[&first, &second]).rise(&params, 1);
        assert!(rise > 5.0, "{rise}");
        let top = second.force.iter().fold(0.0f64, |m, f| m.max(f.abs()));
        let off = |rise: f64| {
            let forces = predict(&model, &second, &smooth(&second), rise);
            let late = |(k, (f, m)): (usize, (&f64, &f64))| if k > 100 { (f - m).abs() } else { 0.0 };
            forces.iter().zip(&second.force).enumerate().map(late).fold(0.0, f64::max) / top
        };
        assert!(off(rise) < 0.01 && off(0.0) > 0.05, "{} {}", off(rise), off(0.0));
        // Records with separate clocks give no information about the preceding time.
        second.clock_s = 0.0;
        assert_eq!(WarmStarts::new(&[&first, &second]).rise(&params, 1), 0.0);
        params.set(number!("fade_source"), 0.0).unwrap();
        assert_eq!(WarmStarts::new(&[&first, &record(5.5)]).rise(&params, 1), 0.0);
    }
}
