//! Response of the valve of an adjustable damper to a step of its command. Only the parameters of the actuator determine this response.

use dashpot_core::family::actuator::{Actuator, Stand};
use dashpot_core::family::axis::Axis;
use dashpot_identification::validation::{ResponseTimes, StepResponse};

/// Number of points of a response.
const POINTS: usize = 400;
/// Number of time constants that a response includes. At the end of the response, a thousandth of the change remains.
const CONSTANTS: f64 = 7.0;
/// Time before the step that a response includes, as a fraction of the time after the step.
const BEFORE: f64 = 0.1;

/// Computes the response of the valve to a step of the command, as the completed fraction of the change of its setting.
///
/// Before the step, the valve is in equilibrium at `from` after a long travel in the direction opposite to the step. Its hysteresis
/// therefore reverses. Returns `None` without an actuator, or if the valve does not move.
pub fn valve_response(axis: &Axis, from: f64, to: f64) -> Option<StepResponse> {
    let actuator = axis.actuator();
    if !has_actuator(axis) || from == to {
        return None;
    }
    let falls = usize::from(to < from);
    let rate = actuator.rate[falls];
    let at_limit = if rate > 0.0 { (to - from).abs() / rate } else { 0.0 };
    let moving = at_limit + CONSTANTS * actuator.time[falls];
    // A valve without a lag jumps. So the response includes some time after the jump, which shows that the valve stays at its new position.
    let span = (actuator.dead_time + moving).max(1.25 * actuator.dead_time).max(1e-3);
    let rest = Stand { lagged: from, turned: if actuator.has_hysteresis() { (from - to).signum() } else { 0.0 } };
    let (zero, one) = (actuator.setting(&rest), actuator.setting(&actuator.at_rest(&rest, to)));
    let time: Vec<f64> = (0..=POINTS).map(|k| span * ((1.0 + BEFORE) * k as f64 / POINTS as f64 - BEFORE)).collect();
    let response: Vec<f64> = time.iter().map(|t| (moved(&actuator, &rest, to, *t) - zero) / (one - zero)).collect();
    Some(StepResponse {
        from,
        to,
        steps: 0,
        tests: Vec::new(),
        sample_s: 0.0,
        end_fraction: 1.0,
        groups: Vec::new(),
        measured: None,
        uncertainty: None,
        model: ResponseTimes::measure(&time, &response),
        time,
        measured_response: Vec::new(),
        model_response: response,
    })
}

/// Returns whether the axis has an actuator, so that the setting of the valve can deviate from the command.
pub fn has_actuator(axis: &Axis) -> bool {
    let actuator = axis.actuator();
    axis.is_some() && (actuator.has_lag() || actuator.dead_time > 0.0)
}

/// Returns the setting of the valve at a time after the step of the command to `to`, s.
fn moved(actuator: &Actuator, rest: &Stand, to: f64, time: f64) -> f64 {
    let moving = time - actuator.dead_time;
    // Without a lag, the valve reaches its new position immediately.
    let stand = if moving < 0.0 { *rest } else { actuator.advance(rest, to, moving.max(f64::MIN_POSITIVE)) };
    actuator.setting(&stand)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(numbers: [f64; 6]) -> Axis {
        let mut axis = Axis::NONE;
        axis.set_grid(&[0.0, 1.6]).unwrap();
        for (k, number) in numbers.iter().enumerate() {
            axis.set_number(k + 1, *number).unwrap();
        }
        axis
    }

    #[test]
    fn times_are_those_of_the_numbers() {
        let lag = axis([8e-3, 20e-3, 2e-3, 0.0, 0.0, 0.1]);
        let up = valve_response(&lag, 0.0, 1.6).unwrap().model.unwrap();
        // The hysteresis reverses during the first tenths of the change. In this part, the valve is slower than its time constant.
        assert!(up.t63_s > 0.010 && up.t63_s < 0.0115 && up.overshoot.abs() < 1e-6, "{up:?}");
        let down = valve_response(&axis([8e-3, 20e-3, 0.0, 0.0, 0.0, 0.0]), 1.6, 0.0).unwrap().model.unwrap();
        assert!((down.t63_s - 0.020).abs() < 2e-4 && (down.t90_s - 0.04605).abs() < 3e-4, "{down:?}");
        let limited = valve_response(&axis([0.0, 0.0, 0.0, 100.0, 0.0, 0.0]), 0.0, 1.6).unwrap().model.unwrap();
        assert!((limited.t90_s - 0.0144).abs() < 1e-4, "{limited:?}");
        let delayed = valve_response(&axis([0.0, 0.0, 5e-3, 0.0, 0.0, 0.0]), 0.0, 1.6).unwrap().model.unwrap();
        assert!((delayed.t63_s - 0.005).abs() < 1e-4, "{delayed:?}");
    }

    #[test]
    fn a_valve_without_an_actuator_has_no_response() {
        assert!(valve_response(&axis([0.0; 6]), 0.0, 1.6).is_none() && !has_actuator(&Axis::NONE));
        assert!(valve_response(&axis([8e-3; 6]), 0.4, 0.4).is_none());
    }
}
