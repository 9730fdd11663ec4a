//! Sign of an imposed motion, from the force that was recorded with it.

use crate::imposed_motion::{ImposeError, ImposedMotion, SimulatedSample};

/// Smallest ratio of two errors at which the sign is doubted. It is the error of the motion as read, divided by the error with the opposite
/// direction positive.
///
/// For a damper that is nearly symmetric, the ratio is near 1 although the direction is right. The test
/// `a_motion_with_compression_positive_is_noticed_by_its_force` checks the limit.
const CLEAR: f64 = 2.0;
/// Largest error with the opposite direction, as a fraction of the force, at which the model describes the damper. With a larger error,
/// the recorded force may be that of another damper.
const DESCRIBES: f64 = 0.35;

/// Errors of a model for a motion as read and with the opposite direction positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignDoubt {
    /// Root mean square error of the force for the motion as read, N.
    pub error: f64,
    /// Root mean square error with the opposite direction positive, N.
    pub reversed_error: f64,
    /// Whether the recorded force has the sign of the project already, so that only the motion is reversed.
    pub motion_alone: bool,
}

/// Compares a recorded force with the simulated force, for the motion as read and for the reversed motion. Returns the errors if the
/// reversed motion is clearly the right one. Returns `None` if the numbers of samples differ.
///
/// Each error is computed with the sign of the recorded force that fits better. This is because some files count motion and force in
/// opposite directions.
///
/// `as_read` is the simulation of the motion as read. `simulate` computes the force of another motion. `recorded` has
/// one force for each sample, in N, with the sign of the motion.
///
/// # Errors
/// The errors of `simulate`.
pub fn doubt_sign(
    motion: &ImposedMotion,
    as_read: &[SimulatedSample],
    recorded: &[f64],
    simulate: &dyn Fn(&ImposedMotion) -> Result<Vec<SimulatedSample>, ImposeError>,
) -> Result<Option<SignDoubt>, ImposeError> {
    if recorded.len() != motion.time.len() {
        return Ok(None);
    }
    let rms = |values: &mut dyn Iterator<Item = f64>| {
        (values.map(|value| value * value).sum::<f64>() / recorded.len() as f64).sqrt()
    };
    let error = |simulated: &[SimulatedSample], sign: f64| {
        rms(&mut simulated.iter().zip(recorded).map(|(sample, force)| sample.force - sign * force))
    };
    let reversed = simulate(&motion.reversed())?;
    let smaller = |simulated: &[SimulatedSample]| error(simulated, 1.0).min(error(simulated, -1.0));
    let (with_force, alone) = (error(&reversed, -1.0), error(&reversed, 1.0));
    let doubt =
        SignDoubt { error: smaller(as_read), reversed_error: with_force.min(alone), motion_alone: alone < with_force };
    let force = rms(&mut recorded.iter().copied());
    Ok((doubt.error > CLEAR * doubt.reversed_error && doubt.reversed_error < DESCRIBES * force).then_some(doubt))
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::{Model, Params};
    use dashpot_records::MotionRecord;
    use std::f64::consts::TAU;

    #[test]
    fn a_motion_with_compression_positive_is_noticed_by_its_force() {
        let model = Model::new(&Params::new()).unwrap();
        let time: Vec<f64> = (0..2000).map(|k| 1e-3 * f64::from(k)).collect();
        let displacement = time.iter().map(|t| 0.02 * libm::sin(2.0 * TAU * t)).collect();
        let record = MotionRecord { time, displacement: Some(displacement), ..MotionRecord::default() };
        let motion = ImposedMotion::new(record, None).unwrap();
        let simulate = |of: &ImposedMotion| of.drive(&model);
        let forces: Vec<f64> = simulate(&motion).unwrap().iter().map(|sample| sample.force).collect();
        let doubt = |motion: &ImposedMotion, recorded: &[f64]| {
            doubt_sign(motion, &simulate(motion).unwrap(), recorded, &simulate).unwrap()
        };
        let of_file = |sign: f64, scale: f64| -> Vec<f64> { forces.iter().map(|force| sign * scale * force).collect() };
        assert_eq!(doubt(&motion, &of_file(1.0, 1.1)), None);
        let found = doubt(&motion.reversed(), &of_file(-1.0, 1.1)).unwrap();
        assert!(found.error > 3.0 * found.reversed_error && !found.motion_alone, "{found:?}");
        // In the file, only the motion is reversed. If only the sign of the force is wrong, the motion is not doubted.
        let found = doubt(&motion.reversed(), &of_file(1.0, 1.1)).unwrap();
        assert!(found.motion_alone, "{found:?}");
        assert_eq!(doubt(&motion, &of_file(-1.0, 1.1)), None);
        // A force of another damper, or one with another number of samples, gives no doubt.
        assert_eq!(doubt(&motion.reversed(), &of_file(-1.0, 5.0)), None);
        assert_eq!(doubt(&motion, &forces[1..]), None);
    }
}
