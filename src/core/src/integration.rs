//! How a host step is integrated: the method, and how many substeps the model asks for.

use crate::assembly::Elements;
use crate::number;
use crate::parameter::Params;
use crate::paths::acting::{self, Bends};

/// Between these lengths of a step, s, no power of m/dt or k dt leaves the range of numbers; what lies beyond them
/// could not be told from them.
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
    /// The same where it takes many: substeps per second, beyond half a one.
    many_per_time: f64,
    /// Longest step, s, that is taken as one cheap step; 0 with another method.
    pub(crate) cheap_up_to: f64,
}

/// What the frequency of a spool counts for among those that ask for substeps.
const SPOOL: f64 = 12.0;

/// The mean slope of the FV curve, N s/m over √(k_s m) in the same unit, at which the mass swings back as that of the default
/// damper does.
const SLACK: f64 = 0.94;
/// Speeds, as shares of the FV curve's range, from which its damping of a swinging mass is taken: each half of the one before, so that a
/// level part about rest is found wherever it ends, down to an eighth of the range. One that ends earlier counts as damping there.
const SPEEDS: [f64; 4] = [0.125, 0.25, 0.5, 1.0];
/// The automatic choice for the mass behind a straight spring: n² ≥ `EVEN` f L^1.6 for the method of three stages and
/// n³ ≥ `CUBIC` L f² for that of four, where f is the frequency times the step and L how far the mass swings. Measured over
/// masses of 0.1 to 2 kg, springs of 0.3 to 30 MN/m and curves of 0.3 to 3 times the default one (the error is below a thousandth
/// in all of them: core/tests/accuracy.rs); with less it is not.
const EVEN: f64 = 0.4;
const CUBIC: f64 = 0.12;

/// What these are multiplied by for elements of the paths, whose forces bend within a step (measured over the test matrix,
/// core/tests/paths_accuracy.rs): where a curve bends and no more, where there is a knee, where there is a void or several
/// elements act, where the column turns from soft to hard with the sign of the force, and where friction turns over behind
/// the spring. Rubber, which bends smoothly, takes the method of fourth order.
const KNEE: f64 = 1.3;
const SEVERAL: f64 = 2.0;
const TURNS: f64 = 4.0;
const WHOLE: f64 = 20.0;
const RUBBER: f64 = 0.33;
/// Two substeps a millisecond, however soft the spring: several elements bend the force by themselves. With less, oil with air misses the
/// thousandth at steps of 2 ms.
const TWO_A_MILLISECOND: f64 = 2e3;

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
}

impl Integration {
    /// One step of the method of fourth order.
    pub const OFF: Integration = Integration {
        method: Method::Fourth,
        substeps: 1,
        per_time: 0.0,
        cubic: false,
        many_per_time: 0.0,
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
        // less: tests/tests/hosts/bridge_accuracy.rs).
        let bushing = &elements.paths.bushing;
        let added = bushing.share + bushing.slow_share + bushing.stop_share;
        let stiffness = params.number(number!("series_stiffness")) * (1.0 + added);
        let mass = if elements.has_series() {
            elements.paths.series_compliance.mass
        } else {
            params.number(number!("internal_mass"))
        };
        let mut frequency = libm::sqrt(stiffness / mass);
        if elements.paths.has_spool() {
            // It swings faster than alone, since the force that it makes moves it (measured: 0.1 % with it).
            frequency = frequency.max(SPOOL * elements.paths.valve_hysteresis.per_time);
        }
        if params.number(number!("method")) == 0.0 && substeps == 0 {
            return Integration::automatic(elements, frequency, stiffness * mass);
        }
        // Elements in the paths bend the forces more sharply within a step; a column that turns from soft to hard as the
        // force changes its sign, more than those; and friction that turns over behind a spring, most of all.
        let sharpness = match acting::bends(&elements.paths) {
            Bends::Whole => 20.0,
            Bends::Turning => 8.0,
            Bends::Little if !acting::is_sharp(&elements.paths) => 1.0,
            _ => 2.0,
        };
        let swings = swings(elements, stiffness * mass).max(1.0);
        Integration::new(method, substeps, even(sharpness, frequency, swings), 0.25 * frequency)
    }

    /// The cheapest that keeps the error of a 1 ms step below a thousandth. `impedance` is k_s m.
    fn automatic(elements: &Elements, frequency: f64, impedance: f64) -> Integration {
        let swings = swings(elements, impedance);
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
        match acting::bends(&elements.paths) {
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
        Integration::new(method, substeps.max(1), 0.0, 0.0)
    }

    fn new(method: Method, substeps: u32, per_time: f64, many_per_time: f64) -> Integration {
        let cheap_up_to = match (method, substeps) {
            (Method::Euler, 0) if per_time > 0.0 => 1.0 / per_time,
            (Method::Euler, 0 | 1) => LONGEST,
            _ => 0.0,
        };
        Integration { method, substeps, per_time, cubic: false, many_per_time, cheap_up_to }
    }

    /// Substeps in a host step of `dt`: depends on the model and `dt` alone, never on the motion.
    #[inline(always)]
    pub fn substeps(&self, dt: f64) -> u32 {
        if self.substeps > 0 {
            return self.substeps;
        }
        let (few, many) = (self.per_time * dt, self.many_per_time * dt - 0.5);
        let mut n = 1;
        let is_few = |n: u32| if self.cubic { f64::from(n * n * n) < few * few } else { f64::from(n * n) < few };
        while n < MOST_SUBSTEPS && (is_few(n) || f64::from(n) < many) {
            n += 1;
        }
        n
    }
}

/// Substeps per second, their square, by [`EVEN`]: as many times as elements ask for.
fn even(times: f64, frequency: f64, swings: f64) -> f64 {
    times * EVEN * frequency * libm::pow(swings, 1.6)
}

/// How far the mass swings back behind a straight spring, L. `impedance` is k_s m.
///
/// What damps it is the FV curve at the speeds that it swings with, small or large: the least of the mean slopes from rest to shares of
/// the curve's range. That to the whole range alone takes a curve that is level about rest for one that damps there.
fn swings(elements: &Elements, impedance: f64) -> f64 {
    let curve = &elements.paths.fv_curve;
    let (low, high) = curve.range();
    let at_rest = curve.at(0.0).value;
    let mut damping = f64::INFINITY;
    for end in [low, high] {
        for share in SPEEDS {
            let u = share * end;
            if u != 0.0 {
                damping = damping.min((curve.at(u).value - at_rest) / u);
            }
        }
    }
    // Without a curve nothing damps the mass.
    let damping = if damping < f64::INFINITY { damping.max(1e-3) } else { 1e-3 };
    (SLACK * libm::sqrt(impedance) / damping).clamp(0.25, 10.0)
}
