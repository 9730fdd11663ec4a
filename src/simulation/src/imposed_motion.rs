//! Motions that a user imposes on a model. Missing channels are computed, and the motion is resampled on request and simulated.

use dashpot_core::family::Family;
use dashpot_core::step::force_in_place;
use dashpot_core::{Input, Model};
use dashpot_messages::format_number;
use dashpot_records::{Channel, MotionRecord, motion_limit};

/// Largest number of rows of a resampled motion. More rows are rejected, because this number already gives some gigabytes of output.
pub const MOST_ROWS: usize = 50_000_000;

/// Largest initial position that a user may state, m: the travel of the longest drive, as for records.
const FARTHEST: f64 = 10.0;

/// Number of samples between two reports of progress.
///
/// The simulation of these samples takes some hundredths of a second. So cancellation appears immediate, and the cost of a report is
/// negligible.
pub const PROGRESS_INTERVAL: usize = 16_384;

/// A motion that can drive a model.
#[derive(Debug, Clone)]
pub struct ImposedMotion {
    /// Time, s, strictly increasing.
    pub time: Vec<f64>,
    /// Displacement, m. If it is missing, the model integrates the velocity.
    pub displacement: Option<Vec<f64>>,
    /// Velocity, m/s.
    pub velocity: Vec<f64>,
    /// Side force, N, if known.
    pub side_force: Option<Vec<f64>>,
    /// Damper temperature, °C, if known.
    pub temperature: Option<Vec<f64>>,
    /// Setting of an adjustable damper, in the unit of the record, if known.
    pub setting: Option<Vec<f64>>,
    /// Displacement at the first sample, m.
    pub initial_position: f64,
}

/// Output of a model at one sample of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimulatedSample {
    /// Time, s.
    pub time: f64,
    /// Displacement, m, extension positive.
    pub displacement: f64,
    /// Velocity, m/s, extension positive.
    pub velocity: f64,
    /// Force, N, tension positive.
    pub force: f64,
}

/// Reason why a motion cannot be imposed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImposeError {
    /// An initial position is given, although the motion has a displacement.
    #[error(
        "the motion has a displacement, which says where it starts: an initial position is for motions that give \
         velocity alone. Leave it out, or leave the displacement unread with --ignore displacement"
    )]
    InitialPositionKnown,
    /// The initial position is not finite, or larger than [`FARTHEST`].
    #[error("the initial position is {} m, which is no position; give -{FARTHEST} to {FARTHEST} m", format_number(*.0))]
    InitialPosition(f64),
    /// The step is not a positive finite number.
    #[error("the step is {} s; it must be above zero and at most the duration of the motion", format_number(*.0))]
    Step(f64),
    /// The step is longer than the motion.
    #[error(
        "the step of {} s is longer than the motion, which lasts {} s",
        format_number(*step),
        format_number(*duration)
    )]
    LongStep {
        /// The step, s.
        step: f64,
        /// Duration of the motion, s.
        duration: f64,
    },
    /// The step gives more than [`MOST_ROWS`] rows.
    #[error(
        "a step of {} s makes {} rows of a motion of {} s; at most {MOST_ROWS} are written, so give a longer step",
        format_number(*step),
        format_number(rows.round()),
        format_number(*duration)
    )]
    ShortStep {
        /// The step, s.
        step: f64,
        /// Duration of the motion, s.
        duration: f64,
        /// Number of rows.
        rows: f64,
    },
    /// A channel is larger than [`motion_limit`]: time, s, name of the quantity, value and limit.
    #[error(
        "at {} s the {} is {}; a motion has at most {}, so check its units",
        format_number(*.0),
        .1,
        format_number(*.2),
        format_number(*.3)
    )]
    Beyond(f64, Channel, f64, f64),
    /// The velocity or the force is not finite: time, s, and name of the quantity.
    #[error("at {} s the {} is no finite number any more; check the units of the motion", format_number(*.0), .1)]
    NotFinite(f64, &'static str),
}

impl ImposedMotion {
    /// Makes a complete motion from a record: computes a missing velocity, and sets the initial position.
    ///
    /// A motion with displacement and velocity stays unchanged. For a motion with displacement alone, the velocity is the derivative of the
    /// cubic spline through the displacement. The spline has continuous acceleration and not-a-knot ends. It is exact for cubics, and
    /// otherwise of third order in the sampling interval. For a motion with velocity alone, the model integrates the velocity from
    /// `initial_position`, m, by default 0.
    ///
    /// # Errors
    /// Returns an error if an initial position is given for a motion with displacement. Also returns an error if the initial position or a
    /// velocity is not finite, or if a channel is beyond [`motion_limit`].
    pub fn new(record: MotionRecord, initial_position: Option<f64>) -> Result<ImposedMotion, ImposeError> {
        let MotionRecord { time, displacement, velocity, side_force, temperature, setting, .. } = record;
        let setting = setting.map(|of| of.values);
        let (initial_position, velocity) = match (&displacement, velocity) {
            (Some(_), _) if initial_position.is_some() => return Err(ImposeError::InitialPositionKnown),
            (Some(x), Some(v)) => (x.first().copied().unwrap_or(0.0), v),
            (Some(x), None) => (x.first().copied().unwrap_or(0.0), spline_slopes(&time, x)),
            (None, v) => (initial_position.unwrap_or(0.0), v.unwrap_or_default()),
        };
        let is_stated = displacement.is_none();
        if !initial_position.is_finite() || is_stated && initial_position.abs() > FARTHEST {
            return Err(ImposeError::InitialPosition(initial_position));
        }
        if let Some(row) = velocity.iter().position(|v| !v.is_finite()) {
            return Err(ImposeError::NotFinite(time[row], "velocity"));
        }
        for (channel, values) in [
            (Channel::Time, Some(&time)),
            (Channel::Displacement, displacement.as_ref()),
            (Channel::Velocity, Some(&velocity)),
            (Channel::SideForce, side_force.as_ref()),
            (Channel::Temperature, temperature.as_ref()),
            (Channel::Setting, setting.as_ref()),
        ] {
            let (values, limit) = (values.map_or(&[][..], Vec::as_slice), motion_limit(channel));
            if let Some(row) = values.iter().position(|value| value.abs() > limit) {
                return Err(ImposeError::Beyond(time[row], channel, values[row], limit));
            }
        }
        Ok(ImposedMotion { time, displacement, velocity, side_force, temperature, setting, initial_position })
    }

    /// Resamples the motion at a fixed step, s, beginning at the first sample.
    ///
    /// Displacement and velocity follow the cubic Hermite interpolant between neighboring samples, which the model also uses within a step.
    /// Side force, temperature and setting are interpolated linearly.
    ///
    /// # Errors
    /// Returns an error if the step is not positive, is longer than the motion, or gives too many rows.
    pub fn resampled(&self, step: f64) -> Result<ImposedMotion, ImposeError> {
        if !(step.is_finite() && step > 0.0) {
            return Err(ImposeError::Step(step));
        }
        let n = self.time.len();
        let (start, end) = (self.time[0], self.time[n - 1]);
        let duration = end - start;
        // The factor 1 + 1e-9 keeps the last sample in spite of rounding errors of the duration.
        let steps = (duration / step * (1.0 + 1e-9)).floor();
        if steps < 1.0 {
            return Err(ImposeError::LongStep { step, duration });
        }
        if steps >= MOST_ROWS as f64 {
            return Err(ImposeError::ShortStep { step, duration, rows: steps + 1.0 });
        }
        let integrated;
        let x = match &self.displacement {
            Some(x) => x,
            None => {
                integrated = self.integrated();
                &integrated
            }
        };
        let v = &self.velocity;
        let rows = steps as usize + 1;
        let mut out = ImposedMotion {
            time: Vec::with_capacity(rows),
            displacement: Some(Vec::with_capacity(rows)),
            velocity: Vec::with_capacity(rows),
            side_force: self.side_force.as_ref().map(|_| Vec::with_capacity(rows)),
            temperature: self.temperature.as_ref().map(|_| Vec::with_capacity(rows)),
            setting: self.setting.as_ref().map(|_| Vec::with_capacity(rows)),
            initial_position: self.initial_position,
        };
        let mut i = 0;
        for k in 0..rows {
            let t = (start + k as f64 * step).min(end);
            while i + 2 < n && self.time[i + 1] <= t {
                i += 1;
            }
            let h = self.time[i + 1] - self.time[i];
            let s = (t - self.time[i]) / h;
            let (x, v) = hermite([x[i], x[i + 1]], [v[i], v[i + 1]], h, s);
            out.time.push(start + k as f64 * step);
            out.displacement.get_or_insert_default().push(x);
            out.velocity.push(v);
            for (to, from) in [
                (&mut out.side_force, &self.side_force),
                (&mut out.temperature, &self.temperature),
                (&mut out.setting, &self.setting),
            ] {
                if let (Some(to), Some(from)) = (to, from) {
                    to.push(from[i] + s * (from[i + 1] - from[i]));
                }
            }
        }
        Ok(out)
    }

    /// Returns the motion with the opposite direction positive.
    pub fn reversed(&self) -> ImposedMotion {
        let mut out = self.clone();
        out.displacement.iter_mut().flatten().chain(&mut out.velocity).for_each(|value| *value = -*value);
        out.initial_position = -out.initial_position;
        out
    }

    /// Computes the displacement, m, from the velocity with the rule of the model: the velocity is linear between samples.
    fn integrated(&self) -> Vec<f64> {
        let mut x = self.initial_position;
        let mut displacement = vec![x];
        for (t, v) in self.time.windows(2).zip(self.velocity.windows(2)) {
            x += 0.5 * (t[1] - t[0]) * (v[0] + v[1]);
            displacement.push(x);
        }
        displacement
    }

    /// Returns the input of the model at a sample. Without a temperature channel, the temperature is 20 °C.
    pub fn input(&self, i: usize) -> Input {
        Input {
            displacement: self.displacement.as_ref().map(|c| c[i]),
            side_force: self.side_force.as_ref().map_or(0.0, |c| c[i]),
            temperature: self.temperature.as_ref().map_or(20.0, |c| c[i]),
            ..Input::velocity(self.velocity[i])
        }
    }

    /// Simulates the motion with one step of the model for each sample, from the steady state at the first sample.
    ///
    /// # Errors
    /// Returns an error if the motion is so extreme that a number overflows.
    pub fn drive(&self, model: &Model) -> Result<Vec<SimulatedSample>, ImposeError> {
        self.drive_telling(model, &|_, _| {})
    }

    /// Returns the commanded setting during the step that ends at a sample, or `None` if the motion has no setting.
    ///
    /// The command is the mean of the settings at both ends of the step, because a change is equally likely in both halves.
    pub fn command(&self, sample: usize) -> Option<f64> {
        let setting = self.setting.as_ref()?;
        Some(0.5 * (setting.get(sample.saturating_sub(1))? + setting.get(sample)?))
    }

    /// Simulates an adjustable damper. `command` returns the setting during the step that ends at a sample.
    ///
    /// # Errors
    /// Returns the errors of [`ImposedMotion::drive`].
    pub fn drive_family(
        &self,
        family: &Family,
        command: &dyn Fn(usize) -> f64,
    ) -> Result<Vec<SimulatedSample>, ImposeError> {
        let first = Input { displacement: Some(self.initial_position), ..self.input(0) };
        let start = Some(command(0));
        let mut state = family.steady_state(&first, start);
        let mut delay = family.steady_delay(start);
        let mut output = family.evaluate(&state, &first, start).0;
        let mut answers = Vec::with_capacity(self.time.len());
        for (i, &time) in self.time.iter().enumerate() {
            if i > 0 {
                let (to, dt) = (self.input(i), time - self.time[i - 1]);
                if !family.step_in_place(&mut state, &mut delay, &to, Some(command(i)), dt, &mut output, false) {
                    return Err(ImposeError::NotFinite(time, "force"));
                }
            }
            if !(state.is_finite() && output.force.is_finite()) {
                return Err(ImposeError::NotFinite(time, "force"));
            }
            let (displacement, velocity) = (state.displacement, self.velocity[i]);
            answers.push(SimulatedSample { time, displacement, velocity, force: output.force });
        }
        Ok(answers)
    }

    /// Simulates the motion like [`ImposedMotion::drive`], and reports progress. Every [`PROGRESS_INTERVAL`] samples, `tell` receives the
    /// number of finished samples and their total.
    ///
    /// # Errors
    /// Returns the errors of [`ImposedMotion::drive`].
    pub fn drive_telling(
        &self,
        model: &Model,
        tell: &dyn Fn(usize, usize),
    ) -> Result<Vec<SimulatedSample>, ImposeError> {
        let first = Input { displacement: Some(self.initial_position), ..self.input(0) };
        let mut state = model.steady_state(&first);
        let mut force = dashpot_core::evaluate::force(model, &state, &first).force;
        let mut answers = Vec::with_capacity(self.time.len());
        for (i, &time) in self.time.iter().enumerate() {
            if i % PROGRESS_INTERVAL == 0 {
                tell(i, self.time.len());
            }
            if i > 0 {
                let found = force_in_place(model, &mut state, &self.input(i), time - self.time[i - 1]);
                force = found.ok_or(ImposeError::NotFinite(time, "force"))?;
            }
            if !(state.is_finite() && force.is_finite()) {
                return Err(ImposeError::NotFinite(time, "force"));
            }
            answers.push(SimulatedSample { time, displacement: state.displacement, velocity: self.velocity[i], force });
        }
        Ok(answers)
    }
}

/// Evaluates the cubic with the values `x` and slopes `v` at both ends of an interval of length `h`. Returns value and slope at the
/// fraction `s` of the interval.
fn hermite(x: [f64; 2], v: [f64; 2], h: f64, s: f64) -> (f64, f64) {
    let (dx, p, q) = (x[1] - x[0], h * v[0], h * v[1]);
    let (square, cube) = (3.0 * dx - 2.0 * p - q, p + q - 2.0 * dx);
    (x[0] + s * (p + s * (square + s * cube)), (p + s * (2.0 * square + s * 3.0 * cube)) / h)
}

/// Computes the slopes of the cubic spline through the samples, not-a-knot at both ends (de Boor, A Practical Guide to Splines, 1978, IV).
///
/// Three samples give the slopes of a parabola. Two samples give the slope of a line.
fn spline_slopes(t: &[f64], x: &[f64]) -> Vec<f64> {
    let n = t.len();
    let h: Vec<f64> = t.windows(2).map(|t| t[1] - t[0]).collect();
    let d: Vec<f64> = x.windows(2).zip(&h).map(|(x, h)| (x[1] - x[0]) / h).collect();
    match n {
        0 | 1 => return vec![0.0; n],
        2 => return vec![d[0]; 2],
        3 => {
            let bend = (d[1] - d[0]) / (h[0] + h[1]);
            return vec![d[0] - h[0] * bend, d[0] + h[0] * bend, d[1] + h[1] * bend];
        }
        _ => {}
    }
    // Tridiagonal system: below[i] s[i-1] + at[i] s[i] + above[i] s[i+1] = right[i] for the slopes s. The not-a-knot conditions of the end
    // rows contain a third slope, which is already eliminated with the neighboring row.
    let (l, m) = (n - 2, n - 3);
    let (first, last) = (h[0] + h[1], h[l] + h[m]);
    let (mut below, mut at, mut above, mut right) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    (at[0], above[0]) = (h[1], first);
    right[0] = ((h[0] + 2.0 * first) * h[1] * d[0] + h[0] * h[0] * d[1]) / first;
    for i in 1..n - 1 {
        (below[i], at[i], above[i]) = (h[i], 2.0 * (h[i - 1] + h[i]), h[i - 1]);
        right[i] = 3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
    }
    (below[n - 1], at[n - 1]) = (last, h[m]);
    right[n - 1] = ((h[l] + 2.0 * last) * h[m] * d[l] + h[l] * h[l] * d[m]) / last;
    // Elimination needs no pivoting, because every pivot stays positive.
    for i in 1..n {
        let share = below[i] / at[i - 1];
        at[i] -= share * above[i - 1];
        right[i] -= share * right[i - 1];
    }
    let mut slopes = right;
    slopes[n - 1] /= at[n - 1];
    for i in (0..n - 1).rev() {
        slopes[i] = (slopes[i] - above[i] * slopes[i + 1]) / at[i];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::Params;
    use dashpot_records::{MotionSetting, SettingSource};
    use dashpot_test_support::drawn;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    /// Returns two superposed sines of different speed, with `n` samples in 1 s.
    fn wave(n: usize) -> MotionRecord {
        let time: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
        let w = [3.0 * TAU, 11.0 * TAU];
        let displacement = time.iter().map(|t| 0.03 * libm::sin(w[0] * t) + 0.002 * libm::cos(w[1] * t)).collect();
        let velocity =
            time.iter().map(|t| 0.03 * w[0] * libm::cos(w[0] * t) - 0.002 * w[1] * libm::sin(w[1] * t)).collect();
        MotionRecord { time, displacement: Some(displacement), velocity: Some(velocity), ..MotionRecord::default() }
    }

    fn model() -> Model {
        Model::new(&Params::new()).unwrap()
    }

    fn forces(motion: &ImposedMotion) -> Vec<f64> {
        motion.drive(&model()).unwrap().iter().map(|a| a.force).collect()
    }

    /// Returns the largest difference between two lists of forces, relative to the largest force of the first.
    fn apart(a: &[f64], b: &[f64]) -> f64 {
        let peak = a.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
        a.iter().zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / peak
    }

    #[test]
    fn every_form_of_a_motion_gives_the_same_force() {
        let both = wave(2000);
        let reference = forces(&ImposedMotion::new(both.clone(), None).unwrap());
        let start = both.displacement.as_ref().unwrap()[0];
        let displacement = ImposedMotion::new(MotionRecord { velocity: None, ..both.clone() }, None).unwrap();
        assert!(apart(&reference, &forces(&displacement)) < 1e-4);
        let velocity = ImposedMotion::new(MotionRecord { displacement: None, ..both }, Some(start)).unwrap();
        assert!(apart(&reference, &forces(&velocity)) < 1e-3);
    }

    #[test]
    fn a_finer_step_changes_little_and_its_own_step_nothing() {
        for record in [wave(1000), MotionRecord { displacement: None, ..wave(1000) }] {
            let motion = ImposedMotion::new(record, None).unwrap();
            let reference = forces(&motion);
            assert!(apart(&reference, &forces(&motion.resampled(1e-3).unwrap())) < 1e-9);
            let fine = forces(&motion.resampled(5e-4).unwrap());
            assert_eq!(fine.len(), 2001);
            let at_same_times: Vec<f64> = fine.iter().step_by(2).copied().collect();
            assert!(apart(&reference, &at_same_times) < 2e-3, "{}", apart(&reference, &at_same_times));
        }
    }

    #[test]
    fn side_force_temperature_and_setting_run_straight_between_samples() {
        let record = MotionRecord {
            time: vec![0.0, 1.0, 3.0],
            velocity: Some(vec![0.0; 3]),
            side_force: Some(vec![0.0, 10.0, 50.0]),
            temperature: Some(vec![20.0, 30.0, 20.0]),
            setting: Some(MotionSetting {
                name: "current".into(),
                unit: "A".into(),
                values: vec![0.4, 0.4, 1.6],
                source: SettingSource::Name { is_sure: true },
            }),
            ..MotionRecord::default()
        };
        let motion = ImposedMotion::new(record, None).unwrap();
        assert_eq!([0, 1, 2].map(|sample| motion.command(sample)), [0.4, 0.4, 1.0].map(Some));
        let motion = motion.resampled(0.5).unwrap();
        assert!((motion.command(6).unwrap() - 1.45).abs() < 1e-12);
        assert_eq!(motion.side_force.unwrap(), [0.0, 5.0, 10.0, 20.0, 30.0, 40.0, 50.0]);
        assert_eq!(motion.temperature.unwrap(), [20.0, 25.0, 30.0, 27.5, 25.0, 22.5, 20.0]);
    }

    #[test]
    fn what_cannot_be_imposed_is_refused() {
        let both = wave(10);
        assert_eq!(ImposedMotion::new(both.clone(), Some(0.0)).unwrap_err(), ImposeError::InitialPositionKnown);
        let velocity = MotionRecord { displacement: None, ..both.clone() };
        assert!(ImposedMotion::new(velocity, Some(f64::NAN)).is_err());
        let motion = ImposedMotion::new(both, None).unwrap();
        for step in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.5, 1e-12] {
            assert!(motion.resampled(step).is_err(), "{step}");
        }
        assert_eq!(motion.resampled(1.0).unwrap().time, [0.0, 1.0]);
        assert_eq!(motion.resampled(0.4).unwrap().time, [0.0, 0.4, 0.8]);
        let absurd = MotionRecord {
            time: vec![0.0, 1e-300],
            displacement: Some(vec![-1e300, 1e300]),
            ..MotionRecord::default()
        };
        assert!(matches!(ImposedMotion::new(absurd, None), Err(ImposeError::NotFinite(_, "velocity"))));
    }

    #[test]
    fn numbers_beyond_their_bounds_are_rejected_in_a_short_sentence() {
        // Records cannot depend on the kernel, so the bound of a setting is stated twice.
        assert_eq!(motion_limit(Channel::Setting), dashpot_core::family::LARGEST_SETTING);
        let still = || MotionRecord { time: vec![0.0, 1.0], velocity: Some(vec![0.0; 2]), ..MotionRecord::default() };
        let message = |record: MotionRecord, position: Option<f64>, step: f64| {
            let made = ImposedMotion::new(record, position).and_then(|motion| motion.resampled(step));
            made.map(|_| ()).map_err(|error| error.to_string())
        };
        for value in [1e308, -1e308, f64::NAN, f64::INFINITY] {
            let of_position = message(still(), Some(value), 0.1).unwrap_err();
            assert!(
                of_position.starts_with("the initial position is") && of_position.contains("-10 to 10"),
                "{of_position}"
            );
            let of_step = message(still(), None, value).unwrap_err();
            assert!(of_step.starts_with("the step"), "{of_step}");
            for said in [of_position, of_step] {
                assert!(said.contains(&format_number(value)) && said.len() < 300, "{said}");
            }
        }
        for step in [0.0, 1e-308] {
            let said = message(still(), None, step).unwrap_err();
            assert!(said.contains("step") && said.len() < 300, "{said}");
        }
        assert_eq!(message(still(), Some(1e-308), 0.1), Ok(()));
        let two = |value: f64| Some(vec![0.0, value]);
        for value in [1e308, -1e308] {
            for record in [
                MotionRecord { displacement: two(value), ..still() },
                MotionRecord { velocity: two(value), ..still() },
                MotionRecord { side_force: two(value), ..still() },
                MotionRecord { temperature: two(value), ..still() },
            ] {
                let said = message(record, None, 0.1).unwrap_err();
                assert!(said.contains(&format_number(value)) && said.len() < 300, "{said}");
            }
        }
        // The velocity that is computed from two samples a short time apart also has a limit. The motion has no column of velocity.
        let fast = MotionRecord { time: vec![0.0, 1.0 / 4096.0], displacement: two(0.5), velocity: None, ..still() };
        assert!(message(fast, None, 1e-4).unwrap_err().contains("velocity is 2048;"));
    }

    proptest! {
        #![proptest_config(drawn(256))]
        #[test]
        fn the_spline_is_exact_for_cubics_at_uneven_times(
            c in prop::array::uniform4(-1.0..1.0_f64),
            steps in prop::collection::vec(0.01..1.0_f64, 4..30),
        ) {
            let mut now = 0.0;
            let time: Vec<f64> = steps.iter().map(|h| { now += h; now / steps.len() as f64 }).collect();
            let x: Vec<f64> = time.iter().map(|t| c[0] + t * (c[1] + t * (c[2] + t * c[3]))).collect();
            for (t, v) in time.iter().zip(spline_slopes(&time, &x)) {
                let exact = c[1] + t * (2.0 * c[2] + 3.0 * c[3] * t);
                prop_assert!((v - exact).abs() < 1e-7, "{v} {exact}");
            }
        }

        #[test]
        fn the_spline_has_no_jump_of_acceleration(x in prop::collection::vec(-1.0..1.0_f64, 5..20)) {
            let time: Vec<f64> = (0..x.len()).map(|i| 0.1 * i as f64 + 0.01 * (i % 3) as f64).collect();
            let v = spline_slopes(&time, &x);
            let bend = |i: usize, at_end: bool| {
                let h = time[i + 1] - time[i];
                let (dx, p, q) = (x[i + 1] - x[i], h * v[i], h * v[i + 1]);
                let bends = if at_end { -6.0 * dx + 2.0 * p + 4.0 * q } else { 6.0 * dx - 4.0 * p - 2.0 * q };
                bends / (h * h)
            };
            for i in 1..x.len() - 1 {
                // The second derivatives are of the order of 1 / (0.1 s)², so the tolerance is far below them.
                prop_assert!((bend(i - 1, true) - bend(i, false)).abs() < 1e-8);
            }
        }
    }
}
