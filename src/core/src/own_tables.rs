//! Implementation of [`Tables`] for a model that owns its tables.

use crate::curve::{Above, Curve, Value};
use crate::elements::fv_curve::FvCurve;
use crate::elements::valve_hysteresis::Conductance;
use crate::tables::{ForceLaw, Lookup, Owned, OwnedElement, Tables};
use core::fmt::Debug;

impl Tables for Owned {
    const HAS_STAGES_OF_ITS_OWN: bool = true;
    type Fv = FvCurve;
    type Spring = Curve;
    type Conductance = Conductance;
    type Kept<E: Copy + Debug + 'static> = OwnedElement<E>;
}

impl ForceLaw for FvCurve {
    #[inline(always)]
    fn evaluate(&self, u: f64) -> Value {
        self.0.evaluate(u)
    }

    #[inline(always)]
    fn above_zero(&self, u: f64) -> Above {
        self.0.above_zero(u)
    }

    #[inline(always)]
    fn at_zero(&self) -> f64 {
        self.0.at_zero()
    }

    #[inline(always)]
    fn solve<const STEPS: usize>(&self, a: f64, r: f64) -> (f64, Value) {
        self.0.solve::<STEPS>(a, r)
    }

    #[inline(always)]
    fn range(&self) -> (f64, f64) {
        self.0.range()
    }
}

impl Lookup for Curve {
    #[inline(always)]
    fn lookup(&self, u: f64) -> Value {
        self.evaluate(u)
    }
}
