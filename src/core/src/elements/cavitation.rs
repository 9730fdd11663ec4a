//! Cavitation: a void that opens in one stroke and closes in the other.
//!
//! The void opens because the gas pressure limits the force of the first stroke, or because the foot valve does not
//! refill the chamber.

use crate::dual::{Dual, Real};
use crate::element::Prepare;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Cavitation: in one direction, the capped one, the oil transmits at most the force C, the cap.
///
/// p = σ F_h is the hydraulic force in this direction, with σ = 1 for rebound and −1 for compression. Further stroke
/// opens a void, whose depth e is measured along the stroke. u is the velocity of the piston, v that of the moving end,
/// and w that of the oil at the valves. q is the deflection of the oil column.
///
/// ```text
/// u = w + dq/dt + σ de/dt
/// de/dt = R(p − C)/r − R(T − p)/r · e/(e + e_0)
/// T = C while the moving end moves in the capped direction, κ C on its return
/// ```
///
/// R(x) is max(x, 0) with a smooth onset. The resistance r is so small that at 1 m/s the force stays within 0.01 C of C
/// or T. While a void lasts, the valves pass the flow that the force T drives through them, so flow and motion close
/// the void. With κ = 1 the gas pressure still acts on the return; with κ = 0 the rod moves freely. Gas in the void
/// sets its pressure: the void opens at a fraction α of the cap. As the gas expands, C and T are multiplied by 1 − (1 −
/// α)/(1 + e/e_1); α = 1 is a void of vapor alone.
///
/// *Foot valve*: the force is not limited. Beyond the speed v_f in the direction σ, the valve does not refill the
/// chamber behind the piston completely. The fraction a of the further flow is missing. The return then begins with a
/// stroke without force, while the void closes at the rate c.
///
/// ```text
/// u = w − σ c,   de/dt = a R(σ v − v_f) − c,   c = R(−p)/r · e/(e + e_0)
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Cavitation {
    is_foot_valve: bool,
    /// a and v_f.
    unfilled: f64,
    filling: f64,
    /// C.
    cap: f64,
    /// σ.
    pub(crate) sign: f64,
    /// 1 − κ.
    lost: f64,
    /// Width of the onset of the ramp, as a force.
    rounding: f64,
    /// 1/r.
    per_resistance: f64,
    /// 1 − α.
    short_at_onset: f64,
    /// 1/e_1.
    per_expansion: f64,
}

/// r is C divided by this speed, m/s.
const SLACK: f64 = 100.0;
/// Width of the onset of the ramp, relative to C, or to 1 N for a foot valve.
const ROUNDING: f64 = 2e-3;
/// Speed of the moving end, m/s, within which T changes smoothly from C to κ C.
const TURNING: f64 = 3e-3;
/// e_0, m: a smaller void closes more slowly.
const CLOSED: f64 = 1e-5;
/// Width of the onset of the refill deficit, as a speed above v_f, m/s.
const LAGGING: f64 = 0.05;
/// Resistance of the rod while the void of a foot valve closes, N s/m.
const FREE: f64 = 10.0;
/// Longest void at rest, m; no damper has such a stroke. Without this limit, a lasting force close to the cap would
/// open a void of 10^12 m, which never closes.
const LONGEST: f64 = 1.0;
/// Largest number of steps for the void at the end of a stage, sufficient for pure bisection.
const STEPS: usize = 80;
/// Step of the iteration for the void, relative to e + e_0, at or below which the iteration ends.
const CLOSE: f64 = 1e-9;

impl Describe for Cavitation {
    const MEANING: &'static str =
        "cavitation: the hydraulic force of one stroke is capped, and a void remains to be closed";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("cavitation_force", "N", &[1500.0], (10.0, 1e6), "largest hydraulic force of that stroke, C"),
        Parameter::choice("cavitation_side", &["compression", "rebound"], "stroke whose force is capped"),
        Parameter::scalar(
            "cavitation_return",
            "-",
            &[0.0],
            (0.0, 1.0),
            "share of the cap that stays on the return while the void closes: 1 gas pushes on, 0 dead stroke",
        ),
        Parameter::choice(
            "cavitation_form",
            &["cap", "foot_valve"],
            "void by the limited force of that stroke, or by a foot valve that does not refill the chamber behind it",
        ),
        Parameter::scalar(
            "cavitation_velocity",
            "m/s",
            &[0.3],
            (0.0, 10.0),
            "foot valve: speed of that stroke beyond which the chamber is not refilled, v_f",
        )
        .in_form("cavitation_form", &["foot_valve"]),
        Parameter::scalar(
            "cavitation_unfilled",
            "-",
            &[0.05],
            (1e-4, 1.0),
            "foot valve: share of the flow beyond that speed that is missing, a",
        )
        .in_form("cavitation_form", &["foot_valve"]),
        Parameter::scalar(
            "cavitation_onset",
            "-",
            &[1.0],
            (0.0, 1.0),
            "cap: share of it at which the void opens, alpha; 1: at the cap itself",
        )
        .in_form("cavitation_form", &["cap"]),
        Parameter::scalar(
            "cavitation_expansion",
            "m",
            &[5e-4],
            (1e-5, 0.1),
            "cap: void over which half of the rest is gained as its gas expands, e_1",
        )
        .in_form("cavitation_form", &["cap"]),
    ];
}

impl Prepare for Cavitation {
    const OFF: Self = Cavitation {
        is_foot_valve: false,
        unfilled: 0.0,
        filling: 0.0,
        cap: 1.0,
        sign: 1.0,
        lost: 0.0,
        rounding: 1.0,
        per_resistance: 0.0,
        short_at_onset: 0.0,
        per_expansion: 0.0,
    };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let cap = p.number(own!("cavitation_force"));
        let sign = if p.number(own!("cavitation_side")) == 1.0 { 1.0 } else { -1.0 };
        let is_foot_valve = p.number(own!("cavitation_form")) == 1.0;
        Ok(Cavitation {
            is_foot_valve,
            unfilled: p.number(own!("cavitation_unfilled")),
            filling: p.number(own!("cavitation_velocity")),
            cap,
            sign,
            lost: 1.0 - p.number(own!("cavitation_return")),
            rounding: if is_foot_valve { ROUNDING } else { ROUNDING * cap },
            per_resistance: if is_foot_valve { 1.0 / FREE } else { SLACK / cap },
            short_at_onset: if is_foot_valve { 0.0 } else { 1.0 - p.number(own!("cavitation_onset")) },
            per_expansion: 1.0 / p.number(own!("cavitation_expansion")),
        })
    }
}

/// Clamps a void to values of at least 0.
#[inline(always)]
fn opened<R: Real>(void: R) -> R {
    if void.value() > 0.0 { void } else { R::constant(0.0) }
}

/// Computes max(x, 0) with a smooth onset over a width.
#[inline(always)]
fn softly<R: Real>(x: R, width: f64) -> R {
    let at = x.value();
    if at <= 0.0 {
        R::constant(0.0)
    } else if at < width {
        x * x * (0.5 / width)
    } else {
        x.plus(-0.5 * width)
    }
}

/// Computes e/(e + e_0).
#[inline(always)]
fn share_open<R: Real>(void: R) -> R {
    let e = opened(void);
    e * e.plus(CLOSED).inverse()
}

impl Cavitation {
    /// Returns the factor by which gas in the void reduces C and T: 1 − (1 − α)/(1 + e/e_1).
    #[inline(always)]
    fn expanded<R: Real>(&self, void: R) -> R {
        if self.short_at_onset == 0.0 {
            return R::constant(1.0);
        }
        (-((opened(void) * self.per_expansion).plus(1.0).inverse() * self.short_at_onset)).plus(1.0)
    }

    /// Returns T/C, the fraction of the cap that remains on the return, or 1 for a foot valve. `velocity` is the
    /// velocity of the moving end.
    #[inline(always)]
    fn kept<R: Real>(&self, velocity: R) -> R {
        if self.is_foot_valve {
            return R::constant(1.0);
        }
        let returning = (-(velocity * (self.sign / TURNING)).tanh()).plus(1.0);
        (-(returning * (0.5 * self.lost))).plus(1.0)
    }

    /// Returns the excess p − C of the force over the cap, and its deficit T − p below the closing force T.
    ///
    /// `pressure` is p, and `expanded` is the factor by which the expanded gas reduces C and T. A foot valve has no
    /// cap: its excess is always negative, and its deficit is −p.
    #[inline(always)]
    fn beyond_and_short<R: Real>(&self, pressure: R, kept: R, expanded: R) -> (R, R) {
        if self.is_foot_valve {
            return (R::constant(-1.0), -pressure);
        }
        let cap = expanded * self.cap;
        (pressure - cap, cap * kept - pressure)
    }

    /// Computes R(x)/r with a smooth onset.
    #[inline(always)]
    fn ramp<R: Real>(&self, x: R) -> R {
        softly(x, self.rounding) * self.per_resistance
    }

    /// Returns the rate at which the refill deficit of a foot valve opens the void, m/s; 0 in the other form.
    #[inline(always)]
    pub(crate) fn lags<R: Real>(&self, velocity: R) -> R {
        if !self.is_foot_valve {
            return R::constant(0.0);
        }
        let beyond = (velocity * self.sign).plus(-self.filling);
        softly(beyond, LAGGING) * self.unfilled
    }

    /// Returns the part of de/dt that depends on the hydraulic force, without the refill deficit.
    #[inline(always)]
    pub(crate) fn rate<R: Real>(&self, force: R, velocity: R, void: R) -> R {
        self.rate_at(force * self.sign, self.kept(velocity), void)
    }

    #[inline(always)]
    fn rate_at<R: Real>(&self, pressure: R, kept: R, void: R) -> R {
        let (beyond, short) = self.beyond_and_short(pressure, kept, self.expanded(void));
        self.ramp(beyond) - self.ramp(short) * share_open(void)
    }

    /// Returns the void under a lasting force, where the gas in it has expanded until the cap equals the force. Returns
    /// 0 if no void opens, if the gas cannot balance the force, or if the void would exceed [`LONGEST`].
    pub(crate) fn rests(&self, force: f64) -> f64 {
        let share = force * self.sign / self.cap;
        if self.is_foot_valve || share <= 1.0 - self.short_at_onset || share >= 1.0 {
            return 0.0;
        }
        let void = (self.short_at_onset / (1.0 - share) - 1.0) / self.per_expansion;
        if void < LONGEST { void } else { 0.0 }
    }

    /// Computes the void e at the end of an implicit stage, e − g de/dt = E. The `known` part E includes the refill
    /// deficit.
    #[inline(always)]
    pub(crate) fn stage<R: Real>(&self, force: R, velocity: R, known: R, g: f64) -> R {
        let (pressure, kept) = (force * self.sign, self.kept(velocity));
        if self.short_at_onset > 0.0 {
            return self.stage_with_gas(pressure, kept, known, g);
        }
        let (beyond, short) = self.beyond_and_short(pressure, kept, R::constant(1.0));
        if beyond.value() >= 0.0 {
            return known + self.ramp(beyond) * g;
        }
        if known.value() <= 0.0 || short.value() <= 0.0 {
            return known;
        }
        // e² + (e_0 − E + g R/r) e = E e_0
        let half = ((self.ramp(short) * g - known).plus(CLOSED)) * 0.5;
        let product = known * CLOSED;
        let root = (half * half + product).sqrt();
        if half.value() > 0.0 { product * (half + root).inverse() } else { root - half }
    }

    /// Solves the stage of an implicit step if the cap grows with the void.
    ///
    /// e − g de/dt rises with e, because the opening cap and the closing pressure both grow. Its difference from E is
    /// negative at the lower end of the bracket and positive at the upper end, so there is one root. A Newton step
    /// longer than half the previous step is replaced by bisection (rtsafe: Press et al., *Numerical Recipes*, 9.4).
    fn stage_with_gas<R: Real>(&self, pressure: R, kept: R, known: R, g: f64) -> R {
        let (p, k) = (Dual::<1>::constant(pressure.value()), Dual::constant(kept.value()));
        let target = known.value();
        let opens = softly(p.value - self.cap * (1.0 - self.short_at_onset), self.rounding) * self.per_resistance * g;
        let (mut low, mut high) = (target.min(0.0), target.max(0.0) + opens);
        // The initial guess assumes a linear ramp and no closing flow. Then y = 1 + e/e_1 satisfies y² − b y = c.
        let b = 1.0 + self.per_expansion * (target + g * self.per_resistance * (p.value - self.cap));
        let c = g * self.per_resistance * self.cap * self.short_at_onset * self.per_expansion;
        let root = libm::sqrt(0.25 * b * b + c);
        let straight = (0.5 * b + root - 1.0) / self.per_expansion;
        let mut void = if opens > 0.0 && straight > low && straight < high { straight } else { target.max(0.0) };
        let (mut derivative, mut last) = (1.0, high - low);
        for _ in 0..STEPS {
            let at = Dual::along(void, 0);
            let there = at - self.rate_at(p, k, at) * g;
            let over = there.value() - target;
            derivative = there.derivative(0).max(1.0);
            if over > 0.0 {
                high = void;
            } else {
                low = void;
            }
            let newton = void - over / derivative;
            let inside = newton >= low && newton <= high && (newton - void).abs() <= 0.5 * last;
            let next = if inside { newton } else { 0.5 * (low + high) };
            last = (next - void).abs();
            void = next;
            if last <= CLOSE * (void.abs() + CLOSED) {
                break;
            }
        }
        // A further Newton step adds the derivatives of the solution with respect to the inputs.
        let end = R::constant(void);
        let missed = end - self.rate_at(pressure, kept, end) * g - known;
        end - missed * (1.0 / derivative)
    }
}
