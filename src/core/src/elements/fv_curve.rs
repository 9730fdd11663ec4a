//! The primary damper: force F_d of the valves over the velocity of the internal mass (Jonnalagadda & Vyas, KTH 2020,
//! chapter 3).

use crate::curve::{Above, Curve, Interpolation, MAX_POINTS, Value};
use crate::element::Prepare;
use crate::fault::{Fault, Reason};
use crate::number;
use crate::parameter::Params;
use crate::schema::kind::{Many, One};
use crate::schema::own::own;
use crate::schema::{Describe, Own, Parameter, View};

/// Force F_d(v), N, of the valves over velocity v, m/s (FV curve). It is a table with linear or one of two cubic
/// interpolations, or a piecewise-linear form with knees.
#[derive(Clone, Copy, Debug)]
pub struct FvCurve(pub(crate) Curve);

const VELOCITY: Own<FvCurve, Many> = Own::named("fv_velocity");
const FORCE: Own<FvCurve, Many> = Own::named("fv_force");
const REBOUND_C: [Own<FvCurve, One>; 3] =
    [Own::named("fv_rebound_c1"), Own::named("fv_rebound_c2"), Own::named("fv_rebound_c3")];
const REBOUND_V: [Own<FvCurve, One>; 2] = [Own::named("fv_rebound_v1"), Own::named("fv_rebound_v2")];
const COMPRESSION_C: [Own<FvCurve, One>; 2] = [Own::named("fv_compression_c1"), Own::named("fv_compression_c2")];

impl Describe for FvCurve {
    const MEANING: &'static str = "primary damper: the force-velocity (FV) curve";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice(
            "fv_form",
            &["table", "piecewise"],
            "source of the FV curve: table, or damping coefficients and knee velocities",
        ),
        Parameter::choice(
            "fv_interpolation",
            &["monotone_cubic", "linear", "cubic_each_side"],
            "interpolation between the points of the FV table",
        )
        .in_form("fv_form", &["table"]),
        Parameter::list(
            "fv_velocity",
            "m/s",
            MAX_POINTS,
            &[-1.571, -1.047, -0.524, -0.262, -0.131, -0.052, 0.0, 0.052, 0.131, 0.262, 0.524, 1.047, 1.571],
            (-20.0, 20.0),
            "velocities of the FV table, rebound positive, increasing",
        )
        .in_form("fv_form", &["table"]),
        Parameter::list(
            "fv_force",
            "N",
            MAX_POINTS,
            &[-1800.0, -1330.0, -860.0, -600.0, -410.0, -200.0, 0.0, 330.0, 760.0, 1130.0, 1640.0, 2530.0, 3400.0],
            (-1e6, 1e6),
            "forces of the FV table, tension positive, non-decreasing",
        )
        .in_form("fv_form", &["table"]),
        Parameter::scalar(
            "fv_rebound_c1",
            "N s/m",
            &[6000.0],
            (0.0, 1e6),
            "Cr1: rebound damping coefficient below the first knee",
        )
        .in_form("fv_form", &["piecewise"]),
        Parameter::scalar(
            "fv_rebound_c2",
            "N s/m",
            &[2500.0],
            (0.0, 1e6),
            "Cr2: rebound damping coefficient between the knees",
        )
        .in_form("fv_form", &["piecewise"]),
        Parameter::scalar(
            "fv_rebound_c3",
            "N s/m",
            &[1600.0],
            (0.0, 1e6),
            "Cr3: rebound damping coefficient above the second knee",
        )
        .in_form("fv_form", &["piecewise"]),
        Parameter::scalar("fv_rebound_v1", "m/s", &[0.13], (1e-4, 10.0), "velocity of the first rebound knee")
            .in_form("fv_form", &["piecewise"]),
        Parameter::scalar("fv_rebound_v2", "m/s", &[0.40], (1e-4, 10.0), "velocity of the second rebound knee")
            .in_form("fv_form", &["piecewise"]),
        Parameter::scalar(
            "fv_compression_c1",
            "N s/m",
            &[3500.0],
            (0.0, 1e6),
            "Cc1: compression damping coefficient below the knee",
        )
        .in_form("fv_form", &["piecewise"]),
        Parameter::scalar(
            "fv_compression_c2",
            "N s/m",
            &[950.0],
            (0.0, 1e6),
            "Cc2: compression damping coefficient above the knee",
        )
        .in_form("fv_form", &["piecewise"]),
        Parameter::scalar("fv_compression_v1", "m/s", &[0.13], (1e-4, 10.0), "speed at the compression knee, positive")
            .in_form("fv_form", &["piecewise"]),
    ];
}

impl Prepare for FvCurve {
    const OFF: Self = FvCurve(Curve::UNSET);

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let mut curve = Self::OFF;
        curve.set(p)?;
        Ok(curve)
    }

    fn set(&mut self, p: &View<Self>) -> Result<(), Fault> {
        if p.number(own!("fv_form")) == 1.0 {
            return self.set_piecewise(p);
        }
        let interpolation = interpolation_of_choice(p.number(own!("fv_interpolation")));
        self.0.set(p.list(VELOCITY), p.list(FORCE), interpolation).map_err(|reason| of_table(p, reason))
    }

    fn check(p: &View<Self>) -> Result<(), Fault> {
        if p.number(own!("fv_form")) == 1.0 {
            check_order(p)?;
            let (v, f) = knees(p);
            return Curve::check(&v, &f).map_err(|reason| of_knees(p, reason));
        }
        Curve::check(p.list(VELOCITY), p.list(FORCE)).map_err(|reason| of_table(p, reason))
    }

    fn clear(&mut self) {
        self.0.clear();
    }
}

impl FvCurve {
    /// Sets the comparison model of Jonnalagadda & Vyas (KTH 2020): straight lines from the origin with two rebound
    /// knees and one compression knee.
    fn set_piecewise(&mut self, p: &View<Self>) -> Result<(), Fault> {
        check_order(p)?;
        let (v, f) = knees(p);
        self.0.set(&v, &f, Interpolation::Linear).map_err(|reason| of_knees(p, reason))
    }
}

/// Returns the kind of interpolation between the points of a parameter set's FV curve.
pub fn fv_interpolation(params: &Params) -> Interpolation {
    if params.number(number!("fv_form")) == 1.0 {
        Interpolation::Linear
    } else {
        interpolation_of_choice(params.number(number!("fv_interpolation")))
    }
}

/// Converts a kind of interpolation to the value of `fv_interpolation`.
pub fn choice_of_interpolation(interpolation: Interpolation) -> f64 {
    match interpolation {
        Interpolation::MonotoneCubic => 0.0,
        Interpolation::Linear => 1.0,
        Interpolation::CubicEachSide => 2.0,
    }
}

/// Converts a value of `fv_interpolation` to the kind of interpolation.
fn interpolation_of_choice(choice: f64) -> Interpolation {
    if choice == 1.0 {
        Interpolation::Linear
    } else if choice == 2.0 {
        Interpolation::CubicEachSide
    } else {
        Interpolation::MonotoneCubic
    }
}

/// Makes the fault of an invalid FV table, which names the wrong list: velocities or forces.
fn of_table(p: &View<FvCurve>, reason: Reason) -> Fault {
    let row = if matches!(reason, Reason::NotIncreasing | Reason::TooClose) { VELOCITY } else { FORCE };
    p.fault(row, reason)
}

/// Makes the fault of an invalid piecewise form. The bounds of the parameters limit the derivatives, so the only
/// expected error is that two knees are too close.
fn of_knees(p: &View<FvCurve>, reason: Reason) -> Fault {
    let row = if reason == Reason::TooClose { REBOUND_V[1] } else { REBOUND_C[0] };
    p.fault(row, reason)
}

fn check_order(p: &View<FvCurve>) -> Result<(), Fault> {
    let [vr1, vr2] = REBOUND_V.map(|row| p.number(row));
    if vr2 <= vr1 { Err(p.fault(REBOUND_V[1], Reason::Order)) } else { Ok(()) }
}

/// Returns the velocities, m/s, and the forces, N, of the six points of the piecewise-linear form.
pub(crate) fn knees(p: &View<FvCurve>) -> ([f64; 6], [f64; 6]) {
    let [cr1, cr2, cr3] = REBOUND_C.map(|row| p.number(row));
    let [vr1, vr2] = REBOUND_V.map(|row| p.number(row));
    let [cc1, cc2] = COMPRESSION_C.map(|row| p.number(row));
    let vc1 = p.number(own!("fv_compression_v1"));
    let (fr1, fc1) = (cr1 * vr1, cc1 * vc1);
    let fr2 = fr1 + cr2 * (vr2 - vr1);
    // A further point beyond the outermost knee of each stroke continues the curve with the last derivative.
    let v = [-2.0 * vc1, -vc1, 0.0, vr1, vr2, 2.0 * vr2];
    let f = [-fc1 - cc2 * vc1, -fc1, 0.0, fr1, fr2, fr2 + cr3 * vr2];
    (v, f)
}

impl FvCurve {
    /// Computes the force F_d, N, and its derivative, N s/m, at velocity `v` of the oil, m/s.
    #[inline(always)]
    pub fn evaluate(&self, v: f64) -> Value {
        self.0.evaluate(v)
    }

    /// Computes the force relative to standstill, F_d(v) − F_d(0), N, with its derivative and curvature; see
    /// [`Curve::above_zero`].
    #[inline(always)]
    pub fn above_zero(&self, v: f64) -> Above {
        self.0.above_zero(v)
    }

    /// Returns the force at standstill, F_d(0), N: 0 unless the curve has an offset.
    #[inline(always)]
    pub fn at_zero(&self) -> f64 {
        self.0.at_zero()
    }

    /// Computes the velocity u, m/s, with `a u + F_d(u) = r`, for `a` in N s/m and `r` in N; see [`Curve::solve`].
    #[inline(always)]
    pub fn solve<const STEPS: usize>(&self, a: f64, r: f64) -> (f64, Value) {
        self.0.solve::<STEPS>(a, r)
    }

    /// Returns the first and the last velocity of the points, m/s; beyond them the curve is extrapolated linearly.
    pub fn range(&self) -> (f64, f64) {
        self.0.range()
    }
}
