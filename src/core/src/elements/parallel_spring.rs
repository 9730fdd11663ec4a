//! Parallel spring F_p on the internal mass (Jonnalagadda & Vyas, KTH 2020, chapter 3): the source of most of the
//! hysteresis.

use crate::curve::{Curve, Interpolation, MAX_POINTS};
use crate::element::{Force, OperatingPoint, Prepare, Response};
use crate::fault::{Fault, Reason};
use crate::math::pair;
use crate::schema::kind::{Many, One};
use crate::schema::{Describe, Own, Parameter, View};
use crate::tables::{Lookup, Owned, Tables};

/// Parallel spring with the force F_p(x) = k1 x + k2 x|x| + k3 x³ + k4 x³|x| + lookup(x).
///
/// x is the displacement of the internal mass, m, and lookup(x) a curve through given points, N. Jonnalagadda & Vyas
/// (KTH 2020) try one term at a time and choose the quadratic one.
#[derive(Clone, Copy, Debug)]
pub struct ParallelSpring<T: Tables = Owned> {
    /// For each power 0 to 3 of |x|: the coefficients in F_p/x and in dF_p/dx, which are evaluated in parallel.
    k: [[f64; 2]; 4],
    /// Whether the cubic or the quartic coefficient is not 0.
    has_higher: bool,
    lookup: T::Spring,
    has_lookup: bool,
}

/// Parameters of the spring's coefficients k1 (linear) to k4 (quartic).
const POWERS: [Own<ParallelSpring, One>; 4] = [
    Own::named("spring_linear"),
    Own::named("spring_quadratic"),
    Own::named("spring_cubic"),
    Own::named("spring_quartic"),
];
const DISPLACEMENT: Own<ParallelSpring, Many> = Own::named("spring_displacement");
const FORCE: Own<ParallelSpring, Many> = Own::named("spring_force");

impl Describe for ParallelSpring {
    const MEANING: &'static str =
        "spring parallel to the primary damper: linear, quadratic, cubic, quartic or lookup table";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::scalar("spring_linear", "N/m", &[0.0], (0.0, 1e7), "linear stiffness, k_p of k_p x"),
        Parameter::scalar("spring_quadratic", "N/m^2", &[10000.0], (0.0, 1e6), "quadratic stiffness, k_p of k_p x|x|"),
        Parameter::scalar("spring_cubic", "N/m^3", &[0.0], (0.0, 1e7), "cubic stiffness, k_p of k_p x^3"),
        Parameter::scalar("spring_quartic", "N/m^4", &[0.0], (0.0, 1e8), "quartic stiffness, k_p of k_p x^3|x|"),
        Parameter::list(
            "spring_displacement",
            "m",
            MAX_POINTS,
            &[],
            (-10.0, 10.0),
            "displacements of the spring's lookup table, increasing; empty: no table",
        ),
        Parameter::list(
            "spring_force",
            "N",
            MAX_POINTS,
            &[],
            (-1e6, 1e6),
            "forces of the spring's lookup table, non-decreasing",
        ),
    ];
}

impl Prepare for ParallelSpring {
    const OFF: Self = ParallelSpring { k: [[0.0; 2]; 4], has_higher: false, lookup: Curve::UNSET, has_lookup: false };

    fn prepare(p: &View<Self>) -> Result<Self, Fault> {
        let mut spring = Self::OFF;
        spring.set(p)?;
        Ok(spring)
    }

    fn set(&mut self, p: &View<Self>) -> Result<(), Fault> {
        let (x, f) = (p.list(DISPLACEMENT), p.list(FORCE));
        let has_lookup = !x.is_empty() || !f.is_empty();
        if has_lookup {
            self.lookup.set(x, f, Interpolation::MonotoneCubic).map_err(|reason| of_table(p, reason))?;
        } else {
            self.lookup.clear();
        }
        self.has_lookup = has_lookup;
        self.set_powers(p);
        Ok(())
    }

    fn check(p: &View<Self>) -> Result<(), Fault> {
        let (x, f) = (p.list(DISPLACEMENT), p.list(FORCE));
        if x.is_empty() && f.is_empty() {
            return Ok(());
        }
        Curve::check(x, f).map_err(|reason| of_table(p, reason))
    }

    fn clear(&mut self) {
        self.lookup.clear();
        (self.k, self.has_higher, self.has_lookup) = ([[0.0; 2]; 4], false, false);
    }
}

/// Makes the fault of an invalid lookup table, which names the wrong list: displacements or forces.
fn of_table(p: &View<ParallelSpring>, reason: Reason) -> Fault {
    let on_x = matches!(reason, Reason::NotIncreasing | Reason::TooClose);
    p.fault(if on_x { DISPLACEMENT } else { FORCE }, reason)
}

impl<T: Tables> Force for ParallelSpring<T> {
    #[inline(always)]
    fn force(&self, at: &OperatingPoint) -> Response {
        if self.has_higher || self.has_lookup { self.bent(at.displacement) } else { self.even(at.displacement) }
    }

    #[inline(always)]
    fn is_nonlinear(&self) -> bool {
        self.has_higher || self.has_lookup
    }

    #[inline(always)]
    fn linear_force(&self, at: &OperatingPoint) -> Response {
        self.even(at.displacement)
    }

    #[inline(always)]
    fn at_once(&self, at: &OperatingPoint) -> Option<Response> {
        if self.has_higher || self.has_lookup { None } else { Some(self.even(at.displacement)) }
    }
}

impl<T: Tables> ParallelSpring<T> {
    /// Returns this spring with another, possibly borrowed, table.
    pub(crate) fn with_table<U: Tables>(&self, lookup: U::Spring) -> ParallelSpring<U> {
        ParallelSpring { k: self.k, has_higher: self.has_higher, lookup, has_lookup: self.has_lookup }
    }

    /// Returns the lookup table of the spring.
    pub(crate) fn table(&self) -> &T::Spring {
        &self.lookup
    }

    /// Sets the coefficients of the linear to quartic terms; the lookup table does not change.
    pub(crate) fn set_powers(&mut self, p: &View<ParallelSpring>) {
        let k = POWERS.map(|power| p.number(power));
        self.k = [0, 1, 2, 3].map(|power| [k[power], (power + 1) as f64 * k[power]]);
        self.has_higher = self.k[2][0] != 0.0 || self.k[3][0] != 0.0;
    }

    /// Computes the force of the linear and the quadratic term at displacement `x`, m.
    #[inline(always)]
    fn even(&self, x: f64) -> Response {
        let [k1, k2, ..] = self.k;
        let [secant, by_x] = pair(|i| k1[i] + x.abs() * k2[i]);
        Response { force: x * secant, d_force_d_x: by_x, d_force_d_v: 0.0 }
    }

    /// Computes the force of all terms and the lookup table at displacement `x`, m. Not inlined, because most springs
    /// have neither higher terms nor a table.
    #[inline(never)]
    fn bent(&self, x: f64) -> Response {
        let r = x.abs();
        let [k1, k2, k3, k4] = self.k;
        let mut from_k2 = k2;
        if self.has_higher {
            from_k2 = pair(|i| k2[i] + r * (k3[i] + r * k4[i]));
        }
        let [secant, mut by_x] = pair(|i| k1[i] + r * from_k2[i]);
        let mut force = x * secant;
        if self.has_lookup {
            let value = self.lookup.lookup(x);
            force += value.value;
            by_x += value.derivative;
        }
        Response { force, d_force_d_x: by_x, d_force_d_v: 0.0 }
    }
}
