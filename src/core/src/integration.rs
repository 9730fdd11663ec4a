//! Integration of a host step: the method, and the number of substeps that the model needs.

use crate::assembly::Elements;
use crate::number;
use crate::parameter::Params;
use crate::paths::acting::{self, Nonlinearity};

/// Bounds of the step length dt, s, within which no power of mass/dt or stiffness·dt in the step overflows or
/// underflows.
pub(crate) const SHORTEST: f64 = 1e-90;
pub(crate) const LONGEST: f64 = 1e60;

/// Method and substeps of a host step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// Method of each substep.
    pub method: Method,
    /// Number of substeps inside one host step. If it is 0, the rates of the model determine the number
    /// ([`Integration::per_time`]).
    pub substeps: u32,
    /// Rate, 1/s, that determines the number n of substeps if n is small; it follows from the model's stiffness. The
    /// product of `per_time` and the host step is n², or n^1.5 with `cubic`.
    pub per_time: f64,
    /// Whether `per_time` times the host step is n^1.5 instead of n², for n substeps.
    cubic: bool,
    /// Rate, 1/s, that determines the number n of substeps if n is large: n is at least this rate times the host step,
    /// minus ½.
    many_per_time: f64,
    /// Natural angular frequency, rad/s, of a ringing (weakly damped) internal mass ([`RINGS`]); 0 if the mass does not
    /// ring.
    rings_at: f64,
    /// Natural angular frequency, rad/s, of a ringing internal mass. Host steps too long to resolve its oscillation
    /// remove its energy ([`Integration::method_of`]). Equals `rings_at`, or 0 with an oil column or a void.
    quiets_at: f64,
    /// Longest host step, s, for which one substep of the method suffices.
    one_up_to: f64,
    /// Longest host step, s, for which one step of [`Method::Euler`] suffices; 0 with another method.
    pub(crate) cheap_up_to: f64,
}

/// Factor by which a spool valve's frequency, one over its time constant, is multiplied in the choice of substeps. The
/// larger of this product and the frequency of the mass determines the substeps.
const SPOOL: f64 = 12.0;

/// Mean derivative of the FV curve at which the internal mass overshoots as in the default damper (overshoot L = 1).
///
/// The value is relative to √(k_s m), N s/m, with the series stiffness k_s and the internal mass m.
const SLACK: f64 = 0.94;
/// Velocities, as fractions of the FV curve's range, at which the damping of an oscillating mass is evaluated.
///
/// Each is half the next one, down to an eighth of the range. A horizontal part of the curve around zero velocity is
/// detected if it extends to an eighth of the range; a shorter one is not.
const SPEEDS: [f64; 4] = [0.125, 0.25, 0.5, 1.0];
/// Limits of the automatic choice of method and substeps, for the internal mass behind a linear spring.
///
/// The method of three stages requires n² ≥ `EVEN` f L^1.6, that of four stages n³ ≥ `CUBIC` L f². Here n is the number
/// of substeps, f the angular frequency of the mass times the step, rad, and L its overshoot ([`SLACK`]). The limits
/// come from masses of 0.1 to 2 kg, springs of 0.3 to 30 MN/m and 0.3 to 3 times the default FV curve. The error is
/// below a thousandth in all these cases (core/tests/kernel/accuracy.rs). With smaller limits, the error exceeds a
/// thousandth in some cases.
const EVEN: f64 = 0.4;
const CUBIC: f64 = 0.12;

/// Factors on [`EVEN`] and [`CUBIC`] for elements of the force path, whose forces are nonlinear within a step.
///
/// The factors were determined with the test matrix (core/tests/kernel/paths_accuracy.rs). `KNEE` is for one element
/// with a knee, such as free play, a symmetric oil column or a valve with play. `SEVERAL` is for a cavitation void,
/// air, a valve with mass, or several elements. `TURNS` is for [`Nonlinearity::Turning`], such as an oil column whose
/// stiffness changes with the sign of the force. `WHOLE` is for friction behind the series spring.
///
/// `RUBBER` is not a factor, because the smooth force of a bushing is integrated with the fourth-order method. Its
/// number n of substeps meets n² ≥ `RUBBER` f, where f is the angular frequency of the mass times the step.
const KNEE: f64 = 1.3;
const SEVERAL: f64 = 2.0;
const TURNS: f64 = 4.0;
const WHOLE: f64 = 20.0;
const RUBBER: f64 = 0.33;
/// Rate of two substeps per millisecond, 1/s. It is the minimum for [`Nonlinearity::Several`] and
/// [`Nonlinearity::Turning`], even with a soft series spring. These elements make the force nonlinear by themselves.
/// With fewer substeps, the error of oil with air exceeds a thousandth at steps of 2 ms.
const TWO_A_MILLISECOND: f64 = 2e3;

/// Overshoot L from which a mass counts as ringing. L is the ratio of √(k_s m) to the damping, relative to the default
/// damper; k_s is the series stiffness, and m the internal mass.
///
/// At this limit, with a damping ratio of 0.06, each oscillation has two thirds of the amplitude of the previous one.
/// With a limit of 5, dampers with a third of the default damping exceeded an error of a thousandth, in steps where
/// other methods are accurate.
const RINGS: f64 = 8.0;
/// Largest phase angle of the oscillation in one substep, rad: six substeps per period.
///
/// Tested with 20,000 random masses of 0.5 to 20 kg on hardening rubber. A case failed if its force error disappears
/// with short steps. Failed cases: none at 1 rad, three at 1.5 rad, 14 at 2 rad, 250 without a limit. `cargo test -p
/// dashpot-abi --test search hard_rubber` runs a thousand of them.
const FOLLOWED: f64 = 1.0;

/// Largest number of substeps of the automatic choice.
const MOST_SUBSTEPS: u32 = 16;

/// Integration method of a substep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Diagonally implicit method of five stages, order 4 (Hairer & Wanner, *Solving Ordinary Differential Equations
    /// II*, table IV.6.5).
    Fourth,
    /// Diagonally implicit method of four stages, order 3, with the smallest diagonal entry γ for which it is L-stable.
    Third,
    /// Diagonally implicit method of three stages, order 2, with the smallest diagonal entry γ for which it is
    /// L-stable. It is the cheapest method with an error below a thousandth at 1 ms steps.
    ThreeStage,
    /// Diagonally implicit method of two stages, order 2 (Alexander, SIAM J. Numer. Anal. 14, 1977).
    Second,
    /// The cheap step: linearly implicit Euler method in closed form, order 1.
    Euler,
    /// Backward Euler: one stage, order 1, solved to convergence. Users cannot choose it: see
    /// [`Integration::method_of`].
    BackwardEuler,
}

impl Method {
    /// Returns the number of stages in a substep.
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
    /// One substep of the fourth-order method in every step.
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

    /// Chooses the integration from the parameters.
    pub fn prepare(params: &Params, elements: &Elements) -> Integration {
        let method = match params.number(number!("method")) {
            1.0 => Method::Second,
            2.0 => Method::Euler,
            3.0 => Method::Third,
            5.0 => Method::ThreeStage,
            _ => Method::Fourth,
        };
        let substeps = params.number(number!("substeps")) as u32;
        // The motion of the mass on its series spring is stiff. Let f be its angular frequency, rad/s, times the step,
        // and n the number of substeps for a given error. For few substeps, f is proportional to n²; for many, to n. In
        // the second case, f/n is 4 to 6 at 0.1 % error, and smaller with less damping
        // (tests/tests/system/hosts/bridge_accuracy.rs).
        let bushing = &elements.paths.bushing;
        let added = bushing.ratio + bushing.slow_ratio + bushing.stop_ratio;
        let stiffness = params.number(number!("series_stiffness")) * (1.0 + added);
        let mass = if elements.has_series() {
            elements.paths.series_compliance.mass
        } else {
            params.number(number!("internal_mass"))
        };
        let alone = libm::sqrt(stiffness / mass);
        let mut frequency = alone;
        if elements.paths.has_spool() {
            // In the damper the spool oscillates faster than alone, because the force that it causes also moves it.
            // With the factor [`SPOOL`], the measured error is 0.1 %.
            frequency = frequency.max(SPOOL * elements.paths.valve_hysteresis.per_time);
        }
        let (damping, impedance) = (least_derivative(elements), libm::sqrt(stiffness * mass));
        let swings = (SLACK * impedance / damping).clamp(0.25, 10.0);
        // The series damping also damps the oscillation of the mass, but it makes no force nonlinear, so it enters only
        // this criterion.
        let damped = damping + elements.paths.series_compliance.damping;
        let rings_at = if elements.has_series() && SLACK * impedance >= RINGS * damped { alone } else { 0.0 };
        let quiets_at = if elements.paths.has_column() || elements.paths.has_cavitation() { 0.0 } else { rings_at };
        if params.number(number!("method")) == 0.0 && substeps == 0 {
            return Integration::automatic(elements, frequency, swings).ringing_at(rings_at, quiets_at);
        }
        // Elements in the series or the hydraulic path make the force more nonlinear within a step. The effect is
        // stronger for an oil column whose stiffness changes with the sign of the force. It is strongest for friction
        // that reverses behind a spring.
        let sharpness = match acting::nonlinearity(&elements.paths) {
            Nonlinearity::Whole => 20.0,
            Nonlinearity::Turning => 8.0,
            Nonlinearity::Little if !acting::is_sharp(&elements.paths) => 1.0,
            _ => 2.0,
        };
        let per_time = even(sharpness, frequency, swings.max(1.0));
        Integration::new(method, substeps, per_time, 0.25 * frequency).ringing_at(rings_at, quiets_at)
    }

    /// Chooses the cheapest integration whose error is below a thousandth in a step of 1 ms. `frequency` is that of the
    /// mass or spool, rad/s, and `swings` the overshoot L of the mass.
    fn automatic(elements: &Elements, frequency: f64, swings: f64) -> Integration {
        // Elements of the series or the hydraulic path make the force nonlinear even if the mass does not overshoot.
        // The overshoot L therefore counts as at least 1.
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
        match acting::nonlinearity(&elements.paths) {
            Nonlinearity::Little => cheaper(1.0),
            Nonlinearity::Smoothly => Integration::new(Method::Fourth, 0, RUBBER * frequency, many),
            Nonlinearity::Knee => four(KNEE),
            Nonlinearity::Several => at_least_two(three(SEVERAL)),
            Nonlinearity::Turning => at_least_two(four(TURNS)),
            Nonlinearity::Whole => four(WHOLE),
        }
    }

    /// Makes an integration with a fixed method and a fixed number of substeps for every step.
    pub fn fixed(method: Method, substeps: u32) -> Integration {
        Integration::new(method, substeps.max(1), 0.0, 0.0).ringing_at(0.0, 0.0)
    }

    /// Sets the frequencies, rad/s, of a ringing mass, or 0 without such a mass, and the step lengths that depend on
    /// them.
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

    /// Returns the longest host step, s, whose substeps resolve a ringing mass on a spring with its stiffness at zero
    /// deflection. Infinite if no mass rings.
    pub fn longest_that_follows(&self) -> f64 {
        let substeps = if self.substeps > 0 { self.substeps } else { MOST_SUBSTEPS };
        if self.rings_at > 0.0 { FOLLOWED * f64::from(substeps) / self.rings_at } else { f64::INFINITY }
    }

    /// Returns whether host steps too long to resolve a ringing mass remove its energy ([`Integration::method_of`]).
    pub fn quiets(&self) -> bool {
        self.quiets_at > 0.0
    }

    /// Returns whether a host step of `dt`, s, is one substep of [`Integration::method`].
    #[inline(always)]
    pub(crate) fn is_one(&self, dt: f64) -> bool {
        dt <= self.one_up_to
    }

    /// Returns the number of substeps in a host step of `dt`, s. The number depends on the model and `dt` alone, never
    /// on the motion.
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

    /// Returns the method of a host step of `dt`, s, with this number of substeps. The result is backward Euler if the
    /// substeps do not resolve a ringing mass.
    ///
    /// A method of higher order shifts the frequency of such a mass. The shifted frequency may coincide with the
    /// excitation and give several times the correct force. Backward Euler removes the energy instead. It uses the
    /// velocity at the end of a substep for the whole substep, which is harmless for a spring. With an oil column or a
    /// void, that velocity would give a hundred times the correct force. The method therefore does not change with
    /// these elements.
    ///
    /// `stiffer` returns the ratio of the series spring's stiffness in the step to that at zero deflection.
    #[inline(always)]
    pub(crate) fn method_of(&self, dt: f64, substeps: u32, stiffer: impl FnOnce() -> f64) -> Method {
        if self.quiets_at > 0.0 && is_beyond(self.quiets_at * libm::sqrt(stiffer()) * dt, substeps) {
            return Method::BackwardEuler;
        }
        self.method
    }
}

/// Returns whether this number of substeps is too small for a ringing mass with phase angle `angle` per host step, rad.
#[inline(always)]
fn is_beyond(angle: f64, substeps: u32) -> bool {
    angle > FOLLOWED * f64::from(substeps)
}

/// Computes [`Integration::per_time`], 1/s, of the three-stage method: [`EVEN`] times `frequency`, rad/s, times L^1.6.
/// The factor `times` is that of the elements, and `swings` the overshoot L of the mass.
fn even(times: f64, frequency: f64, swings: f64) -> f64 {
    times * EVEN * frequency * libm::pow(swings, 1.6)
}

/// Returns the least mean derivative of the FV curve, N s/m, from zero velocity to the fractions [`SPEEDS`] of its
/// range.
///
/// This derivative measures the damping of the oscillating internal mass. The mean over the whole range alone would
/// overestimate the damping of a curve that is horizontal around zero velocity.
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
    // Without an FV curve the mass is undamped; a small positive value, N s/m, avoids a division by zero.
    if damping < f64::INFINITY { damping.max(1e-3) } else { 1e-3 }
}
