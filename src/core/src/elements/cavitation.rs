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
/// p = σ F_h, N, is the hydraulic force in this direction, with σ = 1 for rebound and −1 for compression. If p reaches
/// C, further stroke opens a void, whose depth e, m, is measured along the stroke. u is the velocity of the piston, v
/// that of the moving end, and w that of the oil at the valves. q is the deflection of the oil column. T is the force
/// while the void closes.
///
/// ```text
/// u = w + dq/dt + σ de/dt
/// de/dt = R(p − C)/r − R(T − p)/r · e/(e + e_0)
/// T = C while the moving end moves in the capped direction, κ C on its return
/// ```
///
/// R(x) is max(x, 0) with a smooth onset, and e_0 a void of 10 µm. The resistance r, N s/m, is so small that at 1 m/s
/// the force stays within 0.01 C of C or T. While a void lasts, the valves pass the flow that the force T drives
/// through them, so flow and motion close the void. κ is the fraction of the cap that remains on the return. With κ = 1
/// the gas pressure still acts; with κ = 0 the rod moves freely. Gas in the void sets its pressure: the void opens at a
/// fraction α of the cap. As the gas expands, C and T are multiplied by 1 − (1 − α)/(1 + e/e_1). The void e_1 halves
/// the deficit, and α = 1 means a void of vapor alone.
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
    /// Missing fraction a of the flow through a foot valve; `filling` is the speed v_f above which flow is missing,
    /// m/s.
    unfilled: f64,
    filling: f64,
    /// Cap C: largest hydraulic force of the capped stroke, N.
    cap: f64,
    /// Sign σ of the capped stroke: 1 for rebound, −1 for compression.
    pub(crate) sign: f64,
    /// Fraction of the cap that is lost on the return, 1 − κ.
    lost: f64,
    /// Excess of the force, N, over which the opening or closing of the void sets in smoothly.
    rounding: f64,
    /// One over the resistance r of the opening void, m/(N s).
    per_resistance: f64,
    /// Deficit 1 − α of the force at which the void opens, relative to the cap.
    short_at_onset: f64,
    /// One over the void e_1 at which expanded gas has halved the deficit, 1/m.
    per_expansion: f64,
}

/// Speed, m/s, at which the void would open if the force were twice the cap C: the resistance is C over this speed.
const SLACK: f64 = 100.0;
/// Excess of the force over which the void's motion sets in smoothly, relative to the cap C (1 N for a foot valve).
const ROUNDING: f64 = 2e-3;
/// Speed of the moving end, m/s, over which the closing force changes smoothly from the cap C to its remainder κ C.
const TURNING: f64 = 3e-3;
/// Depth of void e_0, m, below which a void closes more slowly.
const CLOSED: f64 = 1e-5;
/// Speed above `cavitation_velocity`, m/s, over which the refill deficit of a foot valve sets in smoothly.
const LAGGING: f64 = 0.05;
/// Resistance of the rod while the void of a foot valve closes, N s/m.
const FREE: f64 = 10.0;
/// Deepest void in the steady state, as a stroke, m; no damper has such a stroke. Without this limit, a lasting force
/// close to the cap would open a void of 10^12 m, which never closes.
const LONGEST: f64 = 1.0;
/// Largest number of iterations for the void at the end of a stage, sufficient for pure bisection.
const STEPS: usize = 80;
/// Step of the iteration for the void e, relative to e + 10 µm, at or below which the iteration ends.
const CLOSE: f64 = 1e-9;

impl Describe for Cavitation {
    const MEANING: &'static str = "cavitation: one stroke opens a void, which the return stroke must close";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "cavitation_force",
            "N",
            &[1500.0],
            (10.0, 1e6),
            "largest hydraulic force on the cavitating stroke, C",
        ),
        Parameter::choice("cavitation_side", &["compression", "rebound"], "stroke on which cavitation occurs"),
        Parameter::scalar(
            "cavitation_return",
            "-",
            &[0.0],
            (0.0, 1.0),
            "fraction of C that acts on the return while the void closes; 1: gas still pushes, 0: no force",
        ),
        Parameter::choice(
            "cavitation_form",
            &["cap", "foot_valve"],
            "cause of the void: limited force on the cavitating stroke, or a foot valve that does not refill the chamber behind the piston",
        ),
        Parameter::scalar(
            "cavitation_velocity",
            "m/s",
            &[0.3],
            (0.0, 10.0),
            "foot valve: speed on the cavitating stroke above which the chamber is not refilled completely, v_f",
        )
        .in_form("cavitation_form", &["foot_valve"]),
        Parameter::scalar(
            "cavitation_unfilled",
            "-",
            &[0.05],
            (1e-4, 1.0),
            "foot valve: fraction of the flow above v_f that is not refilled, a",
        )
        .in_form("cavitation_form", &["foot_valve"]),
        Parameter::scalar(
            "cavitation_onset",
            "-",
            &[1.0],
            (0.0, 1.0),
            "cap: force at which the void opens, as a fraction of C, alpha; 1: at C",
        )
        .in_form("cavitation_form", &["cap"]),
        Parameter::scalar(
            "cavitation_expansion",
            "m",
            &[5e-4],
            (1e-5, 0.1),
            "cap: void depth at which the expanding gas has raised the force halfway from alpha C to C, e_1",
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

/// Computes max(x, 0) with a smooth onset from x = 0 to x = `width`.
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

/// Computes e/(e + e_0) for a void of depth e, m: near 1, and 0 for a closed void. e_0 is [`CLOSED`].
#[inline(always)]
fn share_open<R: Real>(void: R) -> R {
    let e = opened(void);
    e * e.plus(CLOSED).inverse()
}

impl Cavitation {
    /// Returns the factor by which gas in the void e reduces the cap and the closing force, 1 − (1 − α)/(1 + e/e_1).
    #[inline(always)]
    fn expanded<R: Real>(&self, void: R) -> R {
        if self.short_at_onset == 0.0 {
            return R::constant(1.0);
        }
        (-((opened(void) * self.per_expansion).plus(1.0).inverse() * self.short_at_onset)).plus(1.0)
    }

    /// Returns the closing force T over the cap C: 1 in the capped direction, κ on the return, always 1 for a foot
    /// valve. `velocity` is the velocity of the moving end, m/s.
    #[inline(always)]
    fn kept<R: Real>(&self, velocity: R) -> R {
        if self.is_foot_valve {
            return R::constant(1.0);
        }
        let returning = (-(velocity * (self.sign / TURNING)).tanh()).plus(1.0);
        (-(returning * (0.5 * self.lost))).plus(1.0)
    }

    /// Returns the excess p − C, N, of the force p over the cap C, and its deficit T − p, N, below the closing force T.
    ///
    /// `pressure` is p, `kept` is T/C, and `expanded` is the factor by which the expanded gas reduces C and T. A foot
    /// valve has no cap: its excess is always negative, and its deficit is −p.
    #[inline(always)]
    fn beyond_and_short<R: Real>(&self, pressure: R, kept: R, expanded: R) -> (R, R) {
        if self.is_foot_valve {
            return (R::constant(-1.0), -pressure);
        }
        let cap = expanded * self.cap;
        (pressure - cap, cap * kept - pressure)
    }

    /// Computes the rate of the void, m/s, that an excess or deficit `x` of the force, N, causes; 0 for a negative `x`.
    #[inline(always)]
    fn ramp<R: Real>(&self, x: R) -> R {
        softly(x, self.rounding) * self.per_resistance
    }

    /// Returns the rate at which the refill deficit of a foot valve opens the void, m/s; 0 in the other form.
    /// `velocity` is that of the moving end, m/s.
    #[inline(always)]
    pub(crate) fn lags<R: Real>(&self, velocity: R) -> R {
        if !self.is_foot_valve {
            return R::constant(0.0);
        }
        let beyond = (velocity * self.sign).plus(-self.filling);
        softly(beyond, LAGGING) * self.unfilled
    }

    /// Returns the part of the void's rate, m/s, that depends on the hydraulic force `force`, N: without the refill
    /// deficit. `velocity` is that of the moving end, m/s, and `void` the depth, m.
    #[inline(always)]
    pub(crate) fn rate<R: Real>(&self, force: R, velocity: R, void: R) -> R {
        self.rate_at(force * self.sign, self.kept(velocity), void)
    }

    #[inline(always)]
    fn rate_at<R: Real>(&self, pressure: R, kept: R, void: R) -> R {
        let (beyond, short) = self.beyond_and_short(pressure, kept, self.expanded(void));
        self.ramp(beyond) - self.ramp(short) * share_open(void)
    }

    /// Returns the void, m, under a lasting hydraulic force, N, where the gas in the void has expanded until the cap
    /// equals the force. Returns 0 if no void opens, if the gas cannot balance the force, or if the void would exceed
    /// [`LONGEST`].
    pub(crate) fn rests(&self, force: f64) -> f64 {
        let share = force * self.sign / self.cap;
        if self.is_foot_valve || share <= 1.0 - self.short_at_onset || share >= 1.0 {
            return 0.0;
        }
        let void = (self.short_at_onset / (1.0 - share) - 1.0) / self.per_expansion;
        if void < LONGEST { void } else { 0.0 }
    }

    /// Computes the void e, m, at the end of an implicit stage, e − g de/dt = `known`. `force` is the hydraulic force,
    /// N, `velocity` that of the moving end, m/s, and `g` the weight of the stage, s. `known` includes the refill
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
        // The void e solves e² + (e_0 − E + g R/r) e = E e_0. E is `known`, and R/r the closing rate `ramp(short)` of a
        // wide void.
        let half = ((self.ramp(short) * g - known).plus(CLOSED)) * 0.5;
        let product = known * CLOSED;
        let root = (half * half + product).sqrt();
        if half.value() > 0.0 { product * (half + root).inverse() } else { root - half }
    }

    /// Solves the implicit stage e − g de/dt = `known` for the void e if the cap grows with the void.
    ///
    /// e − g de/dt rises with e, because the opening cap and the closing pressure both grow. Its difference from
    /// `known` is negative at the lower end of the bracket and positive at the upper end, so there is one root. A
    /// Newton step longer than half the previous step is replaced by bisection (rtsafe: Press et al., *Numerical
    /// Recipes*, 9.4).
    fn stage_with_gas<R: Real>(&self, pressure: R, kept: R, known: R, g: f64) -> R {
        let (p, k) = (Dual::<1>::constant(pressure.value()), Dual::constant(kept.value()));
        let target = known.value();
        let opens = softly(p.value - self.cap * (1.0 - self.short_at_onset), self.rounding) * self.per_resistance * g;
        let (mut low, mut high) = (target.min(0.0), target.max(0.0) + opens);
        // The initial guess assumes a rate proportional to the excess, and no closing flow. Then y = 1 + e/e_1
        // satisfies y² − b y = c.
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
        // A further Newton step gives the solution its derivatives with respect to pressure and known part.
        let end = R::constant(void);
        let missed = end - self.rate_at(pressure, kept, end) * g - known;
        end - missed * (1.0 / derivative)
    }
}
