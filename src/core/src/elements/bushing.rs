//! Rubber bushing in series with the damper: it hardens, and returns less energy than it absorbs.

use crate::dual::{Dual, Real};
use crate::element::Prepare;
use crate::fault::Fault;
use crate::schema::own::own;
use crate::schema::{Describe, Parameter, View};

/// Rubber bushing with the force F_s = φ (1 + (φ/(k_s d_h))²) + k_e P(φ/k_s) + k_1 z + k_2 y.
///
/// φ is the force of the linear series spring, N, and k_s its stiffness, N/m. At the deflection d_h, m, the hardened
/// force is twice φ. With free play in series, the deflection d in this law and in the stop is that of the spring,
/// φ/k_s. The two relaxing elements, z and y, follow the deflection of the whole series path.
///
/// *Stop*: P(d) = sgn(d) ((d⁴ + L⁴)^¼ − L) is a smooth form of the deflection d beyond the stop at L. It tends to
/// |d| − L far beyond L, and to d⁴/(4 L³) far below it. The stop adds a stiffness that rises toward k_e.
///
/// *Losses*: two relaxing elements are parallel to the spring. One of stiffness k_1 and deflection z relaxes with the
/// time τ (Maxwell) and over the deflection d_f, as filler friction does (Berg, Veh. Syst. Dyn. 30, 1998): dz/dt =
/// dd/dt − z/τ − |dd/dt| z/d_f. The other, of stiffness k_2 and deflection y, relaxes more slowly: dy/dt = dd/dt −
/// y/τ_2. Two elements are necessary, because the relaxation times of rubber span several decades.
#[derive(Clone, Copy, Debug)]
pub struct Bushing {
    /// One over the deflection d_h at which hardening doubles the force, 1/m.
    per_length: f64,
    /// Stiffness of the first relaxing element over that of the series spring, k_1/k_s.
    pub(crate) ratio: f64,
    /// One over the relaxation time τ of the first element, 1/s.
    per_time: f64,
    /// One over the deflection d_f in which filler friction relaxes the first element, 1/m.
    per_slip: f64,
    /// Deflection L at which the rubber meets its stop, m.
    stop: f64,
    /// Additional stiffness of the stop over that of the series spring, k_e/k_s.
    pub(crate) stop_ratio: f64,
    /// Stiffness of the slowly relaxing element over that of the series spring, k_2/k_s.
    pub(crate) slow_ratio: f64,
    /// One over the relaxation time τ_2 of the slow element, 1/s.
    per_slow_time: f64,
}

/// Deflections z and y, m, of the two relaxing elements after an implicit stage. The derivatives are with respect to
/// the rate of the series deflection, and to the known parts of z and y.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Relaxed {
    pub at: [f64; 2],
    pub by_rate: [f64; 2],
    pub by_known: [f64; 2],
}

impl Relaxed {
    pub const NONE: Relaxed = Relaxed { at: [0.0; 2], by_rate: [0.0; 2], by_known: [0.0; 2] };
}

/// Rate of the series deflection, m/s, over which the filler friction sets in smoothly.
const TURNING: f64 = 2e-3;

impl Describe for Bushing {
    const MEANING: &'static str =
        "rubber bushing in series with the damper: stiffening spring with hysteresis; needs series_compliance";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar(
            "bushing_hardening",
            "m",
            &[2e-3],
            (2e-4, 1.0),
            "deflection at which stiffening doubles the force of the series spring, d_h",
        ),
        Parameter::scalar(
            "bushing_loss_stiffness",
            "-",
            &[0.3],
            (0.0, 30.0),
            "stiffness of the fast relaxing (Maxwell) branch over the series stiffness, k_1/k_s",
        ),
        Parameter::scalar("bushing_loss_time", "s", &[0.01], (1e-4, 1e3), "relaxation time of the fast branch, tau"),
        Parameter::scalar(
            "bushing_slip",
            "m",
            &[1e3],
            (1e-6, 1e3),
            "deflection over which filler friction relaxes the fast branch, d_f; large: relaxation in time only",
        ),
        Parameter::scalar(
            "bushing_stop",
            "m",
            &[1e-3],
            (1e-5, 1.0),
            "deflection at which the rubber meets a stop, in either direction, L",
        ),
        Parameter::scalar(
            "bushing_stop_stiffness",
            "-",
            &[0.0],
            (0.0, 100.0),
            "stiffness that the stop adds, over the series stiffness, k_e/k_s; 0: no stop",
        ),
        Parameter::scalar(
            "bushing_slow_stiffness",
            "-",
            &[0.0],
            (0.0, 30.0),
            "stiffness of the slowly relaxing (Maxwell) branch over the series stiffness, k_2/k_s; 0: no such branch",
        ),
        Parameter::scalar("bushing_slow_time", "s", &[0.1], (1e-3, 1e3), "relaxation time of the slow branch, tau_2"),
    ];
}

impl Prepare for Bushing {
    const OFF: Self = Bushing {
        per_length: 0.0,
        ratio: 0.0,
        per_time: 1.0,
        per_slip: 0.0,
        stop: 1.0,
        stop_ratio: 0.0,
        slow_ratio: 0.0,
        per_slow_time: 1.0,
    };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        Ok(Bushing {
            per_length: 1.0 / p.number(own!("bushing_hardening")),
            ratio: p.number(own!("bushing_loss_stiffness")),
            per_time: 1.0 / p.number(own!("bushing_loss_time")),
            per_slip: 1.0 / p.number(own!("bushing_slip")),
            stop: p.number(own!("bushing_stop")),
            stop_ratio: p.number(own!("bushing_stop_stiffness")),
            slow_ratio: p.number(own!("bushing_slow_stiffness")),
            per_slow_time: 1.0 / p.number(own!("bushing_slow_time")),
        })
    }
}

impl Bushing {
    /// Computes the relaxation rate of z, 1/τ + |dd/dt|/d_f, 1/s, with a smooth onset of the second term, the filler
    /// friction. `rate` is the rate dd/dt of the series deflection, m/s.
    #[inline(always)]
    fn gives_way<R: Real>(&self, rate: R) -> R {
        (rate * rate * rate.abs().plus(TURNING).inverse() * self.per_slip).plus(self.per_time)
    }

    /// Computes dz/dt and dy/dt, m/s, of the relaxing deflections z and y; `rate` is the rate of the series deflection,
    /// m/s.
    #[inline(always)]
    pub(crate) fn rates<R: Real>(&self, rate: R, [z, y]: [R; 2]) -> [R; 2] {
        [rate - z * self.gives_way(rate), rate - y * self.per_slow_time]
    }

    /// Computes the relaxing deflections z and y after an implicit stage: z − g dz/dt and y − g dy/dt equal `known`.
    /// `rate` is the rate of the series deflection, m/s, and `g` the weight of the stage, s. y is 0 unless `SLOW` is
    /// true.
    #[inline(always)]
    pub(crate) fn stage<const SLOW: bool>(&self, rate: f64, known: [f64; 2], g: f64) -> Relaxed {
        let gives_way = self.gives_way(Dual::<1>::along(rate, 0));
        let divide = 1.0 / (1.0 + g * gives_way.value);
        let z = (known[0] + rate * g) * divide;
        let mut relaxed = Relaxed {
            at: [z, 0.0],
            by_rate: [g * divide * (1.0 - z * gives_way.derivative(0)), 0.0],
            by_known: [divide, 0.0],
        };
        if SLOW {
            let divide = 1.0 / (1.0 + g * self.per_slow_time);
            relaxed.at[1] = (known[1] + rate * g) * divide;
            relaxed.by_rate[1] = g * divide;
            relaxed.by_known[1] = divide;
        }
        relaxed
    }

    /// Computes (k_1 z + k_2 y)/k_s, m: the force of the relaxing elements over the series stiffness.
    #[inline(always)]
    pub(crate) fn relaxing<R: Real>(&self, [z, y]: [R; 2]) -> R {
        z * self.ratio + y * self.slow_ratio
    }

    /// Returns the ratio of the rubber's stiffness at its largest deflection to that at zero deflection.
    ///
    /// The largest deflection stores the elastic energy of the present `deflection`, m, plus the kinetic energy of the
    /// mass. `moving` is that kinetic energy divided by ½ k_s, in m², with the series stiffness k_s. The stop is not
    /// included, because its stiffness never exceeds the constant k_e.
    ///
    /// In units of the hardening deflection d_h, a deflection d stores ½ k_s (d² + ½ d⁴), and the stiffness ratio is 1
    /// + 3 d².
    pub(crate) fn stiffer(&self, deflection: f64, moving: f64) -> f64 {
        let unit = self.per_length * self.per_length;
        let square = deflection * deflection * unit;
        let held = square + 0.5 * square * square + moving * unit;
        1.0 + 3.0 * (libm::sqrt(1.0 + 2.0 * held) - 1.0)
    }

    /// Computes the hardened force, N, and stiffness, N/m, of a spring with `force` and `stiffness`; `k` is the series
    /// stiffness k_s.
    #[inline(always)]
    pub(crate) fn hardened<R: Real>(&self, k: R, force: R, stiffness: R) -> (R, R) {
        let deflection = force * k.inverse();
        let square = (deflection * self.per_length) * (deflection * self.per_length);
        let (mut hard, mut factor) = (force * square.plus(1.0), (square * 3.0).plus(1.0));
        if self.stop_ratio > 0.0 {
            // The form (r − 1) = (r⁴ − 1)/((r + 1)(r² + 1)) with r = (1 + x⁴)^¼ avoids cancellation.
            let x = deflection * (1.0 / self.stop);
            let cube = x * x * x.abs();
            let root = (x.abs() * cube).plus(1.0).sqrt();
            let r = root.sqrt();
            hard = hard + k * x * cube * (r.plus(1.0) * root.plus(1.0)).inverse() * (self.stop * self.stop_ratio);
            factor = factor + cube * (r * root).inverse() * self.stop_ratio;
        }
        (hard, stiffness * factor)
    }
}
