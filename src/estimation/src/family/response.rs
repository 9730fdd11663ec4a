//! A damper over a setting, run along a segment whose setting changes.

use crate::segment::Segment;
use dashpot_core::family::Family;

/// Forces at the samples of a segment, and where the valve stands there. The run begins at the equilibrium of the first sample.
pub fn run(family: &Family, segment: &Segment) -> (Vec<f64>, Vec<f64>) {
    run_commanded(family, segment, segment.setting.as_deref())
}

/// Forces and stands of the valve under other commands than those of the segment, one for the step that ends at each sample.
pub fn run_commanded(family: &Family, segment: &Segment, commands: Option<&[f64]>) -> (Vec<f64>, Vec<f64>) {
    let command = |sample: usize| commands.and_then(|all| all.get(sample)).copied();
    let count = segment.input.len();
    let (mut forces, mut settings) = (Vec::with_capacity(count), Vec::with_capacity(count));
    let Some(first) = segment.input.first() else { return (forces, settings) };
    let mut state = family.steady_state(first, command(0));
    let mut delay = family.steady_delay(command(0));
    let (mut output, _) = family.evaluate(&state, first, command(0));
    forces.push(output.force);
    settings.push(family.setting_of(&state, command(0)));
    for (i, input) in segment.input.iter().enumerate().skip(1) {
        let is_finite =
            family.step_in_place(&mut state, &mut delay, input, command(i), segment.dt[i], &mut output, false);
        forces.push(if is_finite { output.force } else { f64::NAN });
        settings.push(family.setting_of(&state, command(i)));
    }
    (forces, settings)
}
