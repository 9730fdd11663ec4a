//! How a host step is integrated: the method, and how many substeps the model asks for.

use crate::assembly::Elements;
use crate::number;
use crate::parameter::Params;
use crate::paths::acting::{self, Bends};

/// Bounds of the length of a step, s, within which no power of m/dt or k dt leaves the range of numbers.
pub(crate) const SHORTEST: f64 = 1e-90;
pub(crate) const LONGEST: f64 = 1e60;

/// How a host step is integrated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// The method.
    pub method: Method,
    /// Substeps inside one host step; 0: from [`Integration::per_time`].
    pub substeps: u32,
    /// Substeps that the model's stiffness asks for where few are enough, per second: their square, or the root of their cube.
    pub per_time: f64,
    /// Whether it is the latter.
    cubic: bool,
    /// Substeps per second beyond half a substep, where a step takes many.
    many_per_time: f64,
    /// Frequency of a mass that rings, rad/s ([`RINGS`]); 0 where something damps it.
    rings_at: f64,
    /// Length from which a step that does not resolve the mass removes its energy ([`Integration::method_of`]).
    quiets_at: f64,
    /// Longest step, s, that is one substep of the method.
    one_up_to: f64,
    /// Longest step, s, that is taken as one cheap step; 0 with another method.
    pub(crate) cheap_up_to: f64,
}

/// What the frequency of a spool counts for among those that ask for substeps.
const SPOOL: f64 = 12.0;

/// The mean derivative of the FV curve at which the mass overshoots as that of the default damper does.
///
/// In N s/m over √(k_s m) in the same unit.
const SLACK: f64 = 0.94;
/// Velocities, as fractions of the FV curve's range, at which the damping of a swinging mass is evaluated.
///
/// Each is half of the one before, so that a level part about rest is found wherever it ends, down to an eighth of
/// the range. One that ends earlier counts as damping there.
const SPEEDS: [f64; 4] = [0.125, 0.25, 0.5, 1.0];
/// Limits of the automatic choice for the mass behind a linear spring.
///
/// n² ≥ `EVEN` f L^1.6 for the method of three stages and n³ ≥ `CUBIC` L f² for that of four, where f is the
/// frequency times the step and L the overshoot of the mass. Measured over masses of 0.1 to 2 kg, springs of 0.3 to
/// 30 MN/m and curves of 0.3 to 3 times the default one. The error is below a thousandth in all of them
/// (core/tests/accuracy.rs); with smaller limits it is not.
const EVEN: f64 = 0.4;
const CUBIC: f64 = 0.12;

/// Factors on these limits for elements of the force path, whose forces are nonlinear within a step.
///
/// Measured over the test matrix (core/tests/paths_accuracy.rs): for a curve that is nonlinear and no more, for a
/// knee, for a void or several elements, for a column that turns from soft to hard with the sign of the force, and
/// for friction that reverses behind the spring. Rubber, which is smooth, uses the method of fourth order.
const KNEE: f64 = 1.3;
const SEVERAL: f64 = 2.0;
const TURNS: f64 = 4.0;
const WHOLE: f64 = 20.0;
const RUBBER: f64 = 0.33;
/// Two substeps a millisecond, however soft the spring: several elements bend the force by themselves. With less, oil with air misses the
/// thousandth at steps of 2 ms.
const TWO_A_MILLISECOND: f64 = 2e3;

/// Overshoot from which a mass counts as ringing: √(k_s m) over its damping, in units of the default damper's.
///
/// It keeps two thirds of a swing in the next, at a damping ratio of 0.06. From 5 on, dampers with a third of the
/// default damping lost the thousandth in steps that other methods handle well.
const RINGS: f64 = 8.0;
/// Radians of its swing that a substep may cover: six substeps to a swing. Of 20,000 masses of 0.5 to 20 kg thrown about on hardening rubber
/// 3 had a force that short steps do not have with 1.5, 14 with 2 and 250 without this; with 1 none (a thousand of the kind: `cargo test -p
/// dashpot-abi --test search hard_rubber`).
const FOLLOWED: f64 = 1.0;

/// Most substeps that the automatic choice takes.
const MOST_SUBSTEPS: u32 = 16;

/// The methods, by order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Five stages, order 4 (Hairer & Wanner, *Solving Ordinary Differential Equations II*, table IV.6.5).
    Fourth,
    /// Four stages, order 3, with the smallest γ that is L-stable.
    Third,
    /// Three stages, order 2, with the smallest γ that is L-stable: the cheapest that is exact enough at 1 ms.
    ThreeStage,
    /// Two stages, order 2 (Alexander, SIAM J. Numer. Anal. 14, 1977).
    Second,
    /// The cheap step: linearly implicit in closed form, order 1.
    Euler,
    /// One stage, order 1, solved in full. It is not to be chosen: see [`Integration::method_of`].
    BackwardEuler,
}

impl Method {
    /// Number of stages.
    pub(crate) fn stages(self) -> u32 {
        match self {
            Method::Fourth => 5,
            Method::Third => 4,
            Method::ThreeStage => 3,
            Method::Second => 2,
            Method::Euler | Method::BackwardEuler => 1,
        }
    }
}

impl Integration {
    /// One step of the method of fourth order.
    pub const OFF: Integration = Integration {
        method: Method::Fourth,
        substeps: 1,
        per_time: 0.0,
        cubic: false,
        many_per_time: 0.0,
        rings_at: 0.0,
        quiets_at: 0.0,
        one_up_to: LONGEST,
        cheap_up_to: 0.0,
    };

    /// From the parameters.
    pub fn prepare(params: &Params, elements: &Elements) -> Integration {
        let method = match params.number(number!("method")) {
            1.0 => Method::Second,
            2.0 => Method::Euler,
            3.0 => Method::Third,
            5.0 => Method::ThreeStage,
            _ => Method::Fourth,
        };
        let substeps = params.number(number!("substeps")) as u32;
        // The stiff motion is the mass on its series spring. Its frequency times the step grows like the square of the
        // substeps needed for a given error, and further on in proportion to them (0.1 % at 4 to 6 each, the less damping the
        // less: tests/tests/system/hosts/bridge_accuracy.rs).
        let bushing = &elements.paths.bushing;
        let added = bushing.share + bushing.slow_share + bushing.stop_share;
        let stiffness = params.number(number!("series_stiffness")) * (1.0 + added);
        let mass = if elements.has_series() {
            elements.paths.series_compliance.mass
        } else {
            params.number(number!("internal_mass"))
        };
        let alone = libm::sqrt(stiffness / mass);
        let mut frequency = alone;
        if elements.paths.has_spool() {
            // It swings faster than alone, since the force that it makes moves it (measured: 0.1 % with it).
            frequency = frequency.max(SPOOL * elements.paths.valve_hysteresis.per_time);
        }
        let (damping, impedance) = (least_derivative(elements), libm::sqrt(stiffness * mass));
        let swings = (SLACK * impedance / damping).clamp(0.25, 10.0);
        // What damps the spring damps the swing as well, but bends no force.
        let damped = damping + elements.paths.series_compliance.damping;
        let rings_at = if elements.has_series() && SLACK * impedance >= RINGS * damped { alone } else { 0.0 };
        let quiets_at = if elements.paths.has_column() || elements.paths.has_cavitation() { 0.0 } else { rings_at };
        if params.number(number!("method")) == 0.0 && substeps == 0 {
            return Integration::automatic(elements, frequency, swings).ringing_at(rings_at, quiets_at);
        }
        // Elements in the paths bend the forces more sharply within a step; a column that turns from soft to hard as the
        // force changes its sign, more than those; and friction that turns over behind a spring, most of all.
        let sharpness = match acting::is_nonlinear(&elements.paths) {
            Bends::Whole => 20.0,
            Bends::Turning => 8.0,
            Bends::Little if !acting::is_sharp(&elements.paths) => 1.0,
            _ => 2.0,
        };
        let per_time = even(sharpness, frequency, swings.max(1.0));
        Integration::new(method, substeps, per_time, 0.25 * frequency).ringing_at(rings_at, quiets_at)
    }

    /// The cheapest that keeps the error of a 1 ms step below a thousandth.
    fn automatic(elements: &Elements, frequency: f64, swings: f64) -> Integration {
        // What bends the force does so as sharply where the mass does not swing.
        let swings = if elements.has_paths() { swings.max(1.0) } else { swings };
        let many = 0.25 * frequency;
        let three = |times: f64| Integration::new(Method::ThreeStage, 0, even(times, frequency, swings), many);
        let four = |times: f64| {
            let per_time = libm::sqrt(times * CUBIC * swings) * frequency;
            Integration { cubic: true, ..Integration::new(Method::Third, 0, per_time, many) }
        };
        let cheaper = |times: f64| {
            let (three, four) = (three(times), four(times));
            let stages = |count: u32, of: &Integration| count * of.substeps(1e-3);
            if stages(3, &three) <= stages(4, &four) { three } else { four }
        };
        let at_least_two = |by_stiffness: Integration| Integration {
            many_per_time: by_stiffness.many_per_time.max(TWO_A_MILLISECOND),
            ..by_stiffness
        };
        match acting::is_nonlinear(&elements.paths) {
            Bends::Little => cheaper(1.0),
            Bends::Smoothly => Integration::new(Method::Fourth, 0, RUBBER * frequency, many),
            Bends::Knee => four(KNEE),
            Bends::Several => at_least_two(three(SEVERAL)),
            Bends::Turning => at_least_two(four(TURNS)),
            Bends::Whole => four(WHOLE),
        }
    }

    /// So many substeps of this method, whatever the step.
    pub fn fixed(method: Method, substeps: u32) -> Integration {
        Integration::new(method, substeps.max(1), 0.0, 0.0).ringing_at(0.0, 0.0)
    }

    /// With a mass that rings at a frequency, or at 0 not at all; what follows from all of it is found.
    fn ringing_at(self, rings_at: f64, quiets_at: f64) -> Integration {
        let longest = |most: f64, per_time: f64| if per_time > 0.0 { most / per_time } else { LONGEST };
        let one_up_to = match self.substeps {
            0 => longest(1.0, self.per_time).min(longest(1.5, self.many_per_time)),
            1 => LONGEST,
            _ => 0.0,
        };
        Integration {
            rings_at,
            quiets_at,
            one_up_to: one_up_to.min(longest(FOLLOWED, if self.substeps == 0 { rings_at } else { quiets_at })),
            ..self
        }
    }

    fn new(method: Method, substeps: u32, per_time: f64, many_per_time: f64) -> Integration {
        let cheap_up_to = match (method, substeps) {
            (Method::Euler, 0) if per_time > 0.0 => 1.0 / per_time,
            (Method::Euler, 0 | 1) => LONGEST,
            _ => 0.0,
        };
        Integration {
            method,
            substeps,
            per_time,
            cubic: false,
            many_per_time,
            rings_at: 0.0,
            quiets_at: 0.0,
            one_up_to: 0.0,
            cheap_up_to,
        }
    }

    /// The longest host step, s, whose substeps resolve a ringing mass at the stiffness of rest; infinite if none
    /// rings.
    pub fn longest_that_follows(&self) -> f64 {
        let substeps = if self.substeps > 0 { self.substeps } else { MOST_SUBSTEPS };
        if self.rings_at > 0.0 { FOLLOWED * f64::from(substeps) / self.rings_at } else { f64::INFINITY }
    }

    /// Whether it takes the energy of one that they do not follow ([`Integration::method_of`]).
    pub fn quiets(&self) -> bool {
        self.quiets_at > 0.0
    }

    /// Whether a host step of `dt` is one substep of [`Integration::method`].
    #[inline(always)]
    pub(crate) fn is_one(&self, dt: f64) -> bool {
        dt <= self.one_up_to
    }

    /// Substeps in a host step of `dt`: depends on the model and `dt` alone, never on the motion.
    #[inline(always)]
    pub fn substeps(&self, dt: f64) -> u32 {
        if self.is_one(dt) {
            return 1;
        }
        if self.substeps > 0 {
            return self.substeps;
        }
        let (few, many) = (self.per_time * dt, self.many_per_time * dt - 0.5);
        let mut n = 1;
        let is_few = |n: u32| if self.cubic { f64::from(n * n * n) < few * few } else { f64::from(n * n) < few };
        while n < MOST_SUBSTEPS && (is_few(n) || f64::from(n) < many || is_beyond(self.rings_at * dt, n)) {
            n += 1;
        }
        n
    }

    /// The method of a host step of `dt` in so many substeps, which is another one for a ringing mass that is not
    /// resolved.
    ///
    /// A method of higher order shifts the frequency of such a mass, and may shift it onto that of the drive, with several times the force of
    /// short steps. Backward Euler takes its energy instead. It knows no motion inside a substep but that at its end, which a spring does not mind:
    /// an oil column or a void that is moved by that speed for so long makes a hundred times the force, so with them the method stays.
    ///
    /// `stiffer`: how many times as stiff as at rest the spring gets in the step.
    #[inline(always)]
    pub(crate) fn method_of(&self, dt: f64, substeps: u32, stiffer: impl FnOnce() -> f64) -> Method {
        if self.quiets_at > 0.0 && is_beyond(self.quiets_at * libm::sqrt(stiffer()) * dt, substeps) {
            return Method::BackwardEuler;
        }
        self.method
    }
}

/// Whether so many substeps do not follow a mass that rings over an angle, rad.
#[inline(always)]
fn is_beyond(angle: f64, substeps: u32) -> bool {
    angle > FOLLOWED * f64::from(substeps)
}

/// Substeps per second, their square, by [`EVEN`]: as many times as elements ask for.
fn even(times: f64, frequency: f64, swings: f64) -> f64 {
    times * EVEN * frequency * libm::pow(swings, 1.6)
}

/// Least mean derivative of the FV curve from rest to fractions of its range, N s/m.
///
/// It is the damping of the mass at the velocities of its swing. The mean to the whole range alone would overestimate
/// the damping of a curve that is level about rest.
///
/// The mean to the whole range alone would overestimate the damping of a curve that is level about rest.
fn least_derivative(elements: &Elements) -> f64 {
    let curve = &elements.paths.fv_curve;
    let (low, high) = curve.range();
    let at_rest = curve.evaluate(0.0).value;
    let mut damping = f64::INFINITY;
    for end in [low, high] {
        for share in SPEEDS {
            let u = share * end;
            if u != 0.0 {
                damping = damping.min((curve.evaluate(u).value - at_rest) / u);
            }
        }
    }
    // Without a curve nothing damps the mass.
    if damping < f64::INFINITY { damping.max(1e-3) } else { 1e-3 }
}
