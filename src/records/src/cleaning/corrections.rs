//! Applies the user's corrections of the sensors to a test: zeros, gains, signs and a delay of the force. A mass on the
//! load cell is only stored here, and `cleaning::finish` corrects its inertia force.

use super::{CompleteTest, cycles};
use crate::data::record::Note;
use crate::data::samples::Samples;
use crate::messages::phrases;
use crate::options::Options;
use crate::signal::delayed_motion::DelayedMotion;
use dashpot_messages::{Sentence, format_decimals};

/// Applies factors to channels other than the force, before displacement and velocity are compared. Without a velocity
/// channel, the factor of the displacement also scales the velocity derived from it.
pub(crate) fn calibrate(samples: &mut Samples, options: &Options) {
    for (channel, gain) in options.gains.iter().filter(|(_, gain)| **gain != 1.0) {
        let Some(values) = samples.channel_mut(*channel) else { continue };
        values.iter_mut().for_each(|value| *value *= gain);
        let text = Sentence::from(phrases::GAIN_OF).with_sentence("channel", channel.message()).with("gain", gain);
        samples.note("corrected", text);
    }
}

/// Applies the corrections of the options, with the signs of the file, and adds a note for each.
///
/// Returns the range of the remaining samples. The delay correction removes the samples without a motion recorded
/// `delay_s` seconds earlier.
pub(crate) fn apply(motion: &mut CompleteTest, options: &Options) -> std::ops::Range<usize> {
    let mut note = |text: Sentence| motion.notes.push(Note { kind: "corrected", text });
    if options.force_zero_n != 0.0 {
        motion.force.iter_mut().for_each(|f| *f -= options.force_zero_n);
        note(Sentence::from(phrases::FORCE_ZERO).with("force", options.force_zero_n));
    }
    if options.gain != 1.0 {
        motion.force.iter_mut().for_each(|f| *f *= options.gain);
        note(Sentence::from(phrases::GAIN).with("gain", options.gain));
    }
    if options.displacement_zero_m != 0.0 {
        motion.displacement.iter_mut().for_each(|x| *x -= options.displacement_zero_m);
        let zero = format_decimals(1e3 * options.displacement_zero_m, 4);
        note(Sentence::from(phrases::DISPLACEMENT_ZERO).with("displacement", zero));
    }
    if options.flip_force {
        motion.force.iter_mut().for_each(|f| *f = -*f);
        motion.notes.push(Note { kind: "flipped", text: phrases::FORCE_TURNED.into() });
    }
    if options.flip_motion {
        motion.displacement.iter_mut().chain(&mut motion.velocity).for_each(|v| *v = -*v);
        motion.notes.push(Note { kind: "flipped", text: phrases::MOTION_TURNED.into() });
        motion.cycles = cycles::find(&motion.time, &motion.displacement);
    }
    let mut note = |text: Sentence| motion.notes.push(Note { kind: "corrected", text });
    if options.rig_mass_kg != 0.0 {
        note(Sentence::from(phrases::MASS_TAKEN_OFF).with("mass", options.rig_mass_kg));
        // The correction needs the acceleration of the whole record, trimmed and with the right sign. It is therefore
        // applied later, when the record is finished.
        motion.stated_error.mass_kg = options.rig_mass_kg;
    }
    if options.delay_s == 0.0 {
        return 0..motion.time.len();
    }
    motion.stated_error.delay_s = options.delay_s;
    let given = if options.delay_s < 0.0 { phrases::EARLY_AS_GIVEN } else { phrases::LATE_AS_GIVEN };
    note(Sentence::from(given).with("delay", format_decimals(1e3 * options.delay_s.abs(), 3)));
    delay_motion(motion, options.delay_s)
}

/// Pairs every force sample with the motion `delay` seconds earlier. Removes samples without such a motion.
///
/// Returns the range of the original samples that remain.
pub(crate) fn delay_motion(motion: &mut CompleteTest, delay: f64) -> std::ops::Range<usize> {
    let earlier = DelayedMotion::new(&motion.time, delay);
    motion.displacement = earlier.values(&motion.displacement);
    motion.velocity = earlier.values(&motion.velocity);
    motion.force = earlier.kept(&motion.force);
    for channel in [&mut motion.side_force, &mut motion.temperature].into_iter().flatten() {
        *channel = earlier.kept(channel);
    }
    if let Some(signal) = &mut motion.setting_signal {
        *signal = signal.with_values(earlier.previous_values(&signal.values));
    }
    let (time, range) = (earlier.kept(&motion.time), earlier.range);
    motion.time = time;
    motion.cycles = cycles::find(&motion.time, &motion.displacement);
    range
}

#[cfg(test)]
mod tests {
    use super::super::{finish, repair};
    use super::*;
    use crate::fixtures::SineTest;
    use crate::quantities::channel::Channel;

    #[test]
    fn every_channel_takes_a_factor() {
        let mut short = SineTest::default().samples();
        let sound = repair(short.clone(), &Options::default()).unwrap();
        short.displacement.as_mut().unwrap().iter_mut().for_each(|x| *x /= 1.25);
        short.velocity = None;
        let mut options = Options::default();
        options.gains.insert(Channel::Displacement, 1.25);
        let found = repair(short, &options).unwrap();
        let peak = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        assert!((peak(&found.velocity) / peak(&sound.velocity) - 1.0).abs() < 0.01);
        assert!((peak(&found.displacement) / peak(&sound.displacement) - 1.0).abs() < 1e-9);
        assert!(found.notes.iter().any(|n| n.text.to_string().contains("displacement multiplied by 1.25")));
    }

    #[test]
    fn a_late_force_finds_its_motion_again() {
        let test = SineTest { frequency: 4.0, noise: 0.0, ..SineTest::default() };
        let sound = repair(test.samples(), &Options::default()).unwrap();
        for (steps, delay) in [(9, 9.0 / 800.0), (40, 40.0 / 800.0)] {
            let mut late = test.samples();
            // After the rotation, the force of sample i is in row i + steps.
            late.force.rotate_right(steps);
            let options = Options { delay_s: delay, ..Options::default() };
            let found = repair(late, &options).unwrap();
            assert_eq!(found.time.len(), sound.time.len() - steps);
            assert!(found.notes.iter().any(|n| n.kind == "corrected"));
            for i in 0..found.time.len() {
                assert!((found.force[i] - sound.force[i]).abs() < 1e-9);
                assert!((found.displacement[i] - sound.displacement[i]).abs() < 1e-6);
                assert!((found.velocity[i] - sound.velocity[i]).abs() < 1e-9 + 1e-3 * 1.3, "{i}");
            }
        }
        // The delay is not a whole number of samples. The interpolation error of a sine is less than a thousandth of
        // its largest step between samples.
        let options = Options { delay_s: 3.4 / 800.0, ..Options::default() };
        let found = repair(test.samples(), &options).unwrap();
        let steady = found.steady();
        for i in steady.start + 4..steady.end - 4 {
            let phase = std::f64::consts::TAU * 4.0 * (found.time[i] - options.delay_s - 0.6 * 0.25)
                + std::f64::consts::TAU * 0.37 / 200.0;
            let wanted = 0.01 + 0.05 * libm::sin(phase);
            assert!((found.displacement[i] - wanted).abs() < 1e-6, "{i}: {} {wanted}", found.displacement[i]);
        }
    }

    #[test]
    fn zeros_and_gain_are_applied_and_told() {
        let test = SineTest::default();
        let sound = repair(test.samples(), &Options::default()).unwrap();
        let options = Options { force_zero_n: 20.0, gain: 2.0, displacement_zero_m: 0.01, ..Options::default() };
        let found = repair(test.samples(), &options).unwrap();
        assert_eq!(found.notes.iter().filter(|n| n.kind == "corrected").count(), 3);
        for i in 0..found.time.len() {
            assert_eq!(found.force[i], (sound.force[i] - 20.0) * 2.0);
            assert_eq!(found.displacement[i], sound.displacement[i] - 0.01);
        }
    }

    #[test]
    fn a_mass_on_the_load_cell_is_taken_off_and_told() {
        let test = SineTest { frequency: 4.0, noise: 0.0, ..SineTest::default() };
        let record = |mass: f64, turned: bool| {
            let options = Options { rig_mass_kg: mass, flip_force: turned, flip_motion: turned, ..Options::default() };
            finish(repair(test.samples(), &options).unwrap()).unwrap()
        };
        let omega = std::f64::consts::TAU * 4.0;
        for turned in [false, true] {
            let (with, without) = (record(3.0, turned), record(0.0, turned));
            assert!(with.notes.iter().any(|n| n.kind == "corrected" && n.text.to_string().contains("3 kg")));
            let steady = without.cycles[0].start + 5..without.cycles[2].end - 5;
            for i in steady {
                // The acceleration of a sine is −ω² times the displacement from the mean.
                let taken = -3.0 * omega * omega * (without.displacement[i] - without.mean_displacement);
                let found = without.force[i] - with.force[i];
                assert!((found - taken).abs() < 0.02 * 3.0 * omega * omega * 0.05, "{i}: {found} {taken}");
            }
        }
        let absurd = Options { rig_mass_kg: 1200.0, ..Options::default() }.check();
        assert!(absurd.unwrap_err().contains("kg"));
    }
}
