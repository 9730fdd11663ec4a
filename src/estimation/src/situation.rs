//! Summary of a base model and its tests: quantities from which searches derive their start values.

use crate::first_guess::{dry, slowing_forces};
use crate::heating::Heating;
use crate::samples::Test;
use crate::scale::Scale;
use crate::segment::Segment;
use crate::warmth::temperatures;
use dashpot_core::Params;
use dashpot_core::{element, list, number};
use dashpot_records::Record;
use dashpot_records::restrict;

/// Quantities of a base model and its tests, from which searches derive their start values.
#[derive(Debug, Clone)]
pub struct Situation {
    /// The base model.
    pub base: Params,
    /// Strength of the damper relative to that of a passenger car's damper; 1 within the force range of cars.
    pub scale: Scale,
    /// Sum of the sliding forces of Coulomb, Stribeck and presliding friction in the model, N.
    pub friction: f64,
    /// Friction, N, that an FV curve may contain as a step at zero velocity. Zero if [`Situation::friction`] is
    /// positive.
    pub friction_in_curve: f64,
    /// Hydraulic force at the highest speed in rebound, N, positive.
    pub top_rebound: f64,
    /// Hydraulic force at the highest speed in compression, N, positive.
    pub top_compression: f64,
    /// Typical force at the knee of the FV curve, N.
    pub knee_force: f64,
    /// Lowest and highest displacement of the tests, m.
    pub reach: (f64, f64),
    /// Largest range of displacements, m, over which samples have about equal velocity.
    pub places_span: f64,
    /// Range of the tests' accumulated heat, J, with cooling neglected.
    pub heat_span: f64,
    /// Ratio of the highest to the lowest frequency; infinite if a test has no frequency.
    pub frequency_ratio: f64,
    /// Whether all records have a temperature channel and the temperature varies by more than 3 K.
    pub temperature_measured: bool,
    /// Middle of the temperature range, °C; 20 if [`Situation::temperature_measured`] is false.
    pub temperature: f64,
    /// Time between the middles of the first and the last test on the clock of the campaign, s.
    pub clock_span: f64,
    /// Times midway between successive tests whose middles are more than 1 s apart, s of the campaign's clock. At these
    /// times, the zero of the load cell may have been set again. The first and the last pair of tests are excluded.
    pub pauses: Vec<u32>,
    /// Delay of the force channel estimated from the raw data of the first record, s; 0 if none was significant.
    pub apparent_delay: f64,
    /// Span of the absolute side forces, N.
    pub side_force_span: f64,
    /// Highest speeds in rebound and compression, m/s, positive.
    pub fastest: [f64; 2],
    /// Forces at the points of the FV curve, N, only from samples at which the damper slows down. Empty without tests
    /// and for a curve with fewer than three points.
    pub slowing: Vec<f64>,
}

/// Speed range, m/s, in which a curve without friction is nearly linear, so that it can be extrapolated to zero
/// velocity.
const DRAWN_BACK: (f64, f64) = (0.02, 0.08);

/// Interpolates an FV curve (`v` in m/s, `f` in N) linearly at the velocity `speed`. Beyond the ends, the last force
/// applies.
fn at(v: &[f64], f: &[f64], speed: f64) -> f64 {
    let right = restrict(v.partition_point(|x| *x < speed), 1, v.len() - 1);
    let share = ((speed - v[right - 1]) / (v[right] - v[right - 1])).clamp(0.0, 1.0);
    f[right - 1] + share * (f[right] - f[right - 1])
}

/// Computes half the step of an FV curve at zero velocity, N: the force at low speed, extrapolated to zero speed. For
/// fewer than three points, the result is 0.
fn step_at_standstill(v: &[f64], f: &[f64]) -> f64 {
    if v.len() < 3 {
        return 0.0;
    }
    let (slow, fast) = DRAWN_BACK;
    let half = |speed: f64| 0.5 * (at(v, f, speed) - at(v, f, -speed));
    (half(slow) - slow * (half(fast) - half(slow)) / (fast - slow)).max(0.0)
}

/// Speeds at which displacements are compared, m/s. [`OF_SPEED`] is the relative tolerance of a sample's speed.
const SPEEDS: [f64; 6] = [0.05, 0.1, 0.2, 0.4, 0.8, 1.6];
const OF_SPEED: f64 = 0.3;

/// Computes the largest range of displacements, m, of samples with about equal velocity. If the range is zero, effects
/// of displacement and of velocity cannot be separated.
fn places_span(tests: &[Test]) -> f64 {
    let at = |speed: f64| {
        let of = tests.iter().flat_map(|t| t.inputs()).filter(|i| (i.velocity / speed - 1.0).abs() < OF_SPEED);
        let (low, high) = of
            .filter_map(|i| i.displacement)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        (high - low).max(0.0)
    };
    SPEEDS.iter().flat_map(|speed| [at(*speed), at(-speed)]).fold(0.0, f64::max)
}

/// Computes the forces of the FV curve, N, at `velocities`, m/s, from samples at which the damper slows down. The
/// result is empty without tests, and for fewer than three velocities.
fn slowing(tests: &[Test], velocities: &[f64]) -> Vec<f64> {
    let segments: Vec<Segment> = tests.iter().map(|t| t.segment.clone()).collect();
    if segments.is_empty() || velocities.len() < 3 {
        return Vec::new();
    }
    slowing_forces(&segments, velocities, dry(&segments))
}

impl Situation {
    /// Computes the situation from a model and tests.
    pub fn new(base: &Params, records: &[&Record], tests: &[Test]) -> Situation {
        let inputs = || tests.iter().flat_map(|t| t.inputs());
        let span = |values: &mut dyn Iterator<Item = f64>| {
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            if low <= high { (low, high) } else { (0.0, 0.0) }
        };
        let reach = span(&mut inputs().filter_map(|i| i.displacement));
        let temperatures = temperatures(records);
        let side = span(&mut inputs().map(|i| i.side_force.abs()));
        let clock = span(&mut tests.iter().map(|t| t.segment.clock));
        let frequencies = span(&mut tests.iter().map(|t| t.frequency));
        let forces = span(&mut tests.iter().flat_map(|t| t.forces().iter().copied()));
        let fastest = span(&mut inputs().map(|i| i.velocity));
        let scale = Scale::from_params(base);
        let mut friction = 0.0;
        if base.is_on(element!("coulomb_friction")) {
            friction += base.number(number!("coulomb_force"));
        }
        if base.is_on(element!("stribeck_friction")) {
            friction += base.number(number!("stribeck_coulomb_force"));
        }
        if base.is_on(element!("presliding_friction")) {
            friction += base.number(number!("presliding_force"));
        }
        let (v, f) = (base.list(list!("fv_velocity")), base.list(list!("fv_force")));
        // The knee is the first point in rebound beyond which the slope is less than half of the curve's largest slope.
        let slopes: Vec<f64> = v.windows(2).zip(f.windows(2)).map(|(v, f)| (f[1] - f[0]) / (v[1] - v[0])).collect();
        let steepest = slopes.iter().fold(0.0f64, |m, s| m.max(*s));
        let knee = v
            .windows(2)
            .zip(f.windows(2))
            .zip(&slopes)
            .filter(|((v, _), s)| v[0] >= 0.0 && **s < 0.5 * steepest)
            .map(|((_, f), _)| f[0])
            .next();
        let mut clocks: Vec<f64> = tests.iter().map(|t| t.segment.clock).collect();
        clocks.sort_by(f64::total_cmp);
        let pauses = clocks
            .windows(2)
            .skip(1)
            .take(clocks.len().saturating_sub(3))
            .filter(|w| w[1] - w[0] > 1.0)
            .map(|w| (0.5 * (w[0] + w[1])) as u32)
            .collect();
        // Without a friction element, the FV curve contains friction as a step.
        let in_curve = if friction > 0.0 { 0.0 } else { step_at_standstill(v, f) };
        Situation {
            base: *base,
            scale,
            friction_in_curve: in_curve,
            places_span: places_span(tests),
            heat_span: Heating::new(records, tests).span(),
            frequency_ratio: if frequencies.0 > 0.0 { frequencies.1 / frequencies.0 } else { f64::INFINITY },
            friction,
            // These forces exclude friction and gas, which are parallel to the valves.
            top_rebound: at(v, f, fastest.1).max(scale.force()),
            top_compression: (-at(v, f, fastest.0)).max(scale.force()),
            knee_force: knee.unwrap_or(0.3 * forces.1).max(scale.force()),
            reach,
            temperature_measured: temperatures.is_some(),
            temperature: temperatures.map_or(20.0, |(low, high)| 0.5 * (low + high)),
            clock_span: clock.1 - clock.0,
            pauses,
            apparent_delay: records.first().map_or(0.0, |record| record.apparent_delay_s),
            side_force_span: side.1 - side.0,
            fastest: [fastest.1.max(0.0), (-fastest.0).max(0.0)],
            slowing: slowing(tests, v),
        }
    }

    /// Scales the situation to a car damper, because tabulated start values and priors apply to car dampers.
    pub fn as_car(&self) -> Situation {
        let of_car = |force: f64| force / self.scale.force();
        Situation {
            base: self.scale.as_car(&self.base),
            scale: Scale::CAR,
            friction: of_car(self.friction),
            friction_in_curve: of_car(self.friction_in_curve),
            top_rebound: of_car(self.top_rebound),
            top_compression: of_car(self.top_compression),
            knee_force: of_car(self.knee_force),
            heat_span: of_car(self.heat_span),
            side_force_span: of_car(self.side_force_span),
            slowing: self.slowing.iter().map(|force| of_car(*force)).collect(),
            ..self.clone()
        }
    }

    /// Returns the force of the FV curve, N, at a velocity, m/s.
    pub fn driven(&self, speed: f64) -> f64 {
        at(self.base.list(list!("fv_velocity")), self.base.list(list!("fv_force")), speed)
    }
}
