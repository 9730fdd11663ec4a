//! A model: parameters checked and made ready for evaluation.

use crate::elements::{Elements, Motion};
use crate::fault::{Fault, NO_PARAMETER, Reason};
use crate::parameter::{Params, find};
use crate::step::Integration;

/// Displacements within which the springs on the mass must stay softer than the series spring, m.
const STROKE: f64 = 0.1;
/// Places on each side at which their slope is looked at: every half millimetre.
const PLACES: i32 = 200;

/// Largest slope of the springs on the internal mass. A step takes their tangent where it expects the mass; that is only
/// stable where the series spring decides where the mass can be.
fn steepest_inner(elements: &Elements) -> f64 {
    let mut steepest = 0.0;
    for place in -PLACES..=PLACES {
        let displacement = STROKE * f64::from(place) / f64::from(PLACES);
        let at = Motion { displacement, velocity: 0.0, side_force: 0.0, temperature: 20.0 };
        let slope = elements.inner(&at).by_x;
        steepest = if slope > steepest { slope } else { steepest };
    }
    steepest
}

/// A prepared damper. Constant while it runs; one model serves any number of states.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Model {
    pub(crate) elements: Elements,
    pub(crate) integration: Integration,
}

impl Model {
    /// Checks the parameters and prepares all that does not change in a run.
    ///
    /// # Errors
    /// The parameter at fault, and why.
    pub fn new(params: &Params) -> Result<Model, Fault> {
        params.check()?;
        let mut elements = Elements::prepare(params)?;
        elements.join();
        if elements.has_series() && steepest_inner(&elements) > elements.series_compliance.stiffness {
            let parameter = find("series_stiffness").map_or(NO_PARAMETER, |row| row.index as u16);
            return Err(Fault { parameter, reason: Reason::SofterThanInner });
        }
        let integration = Integration::prepare(params, &elements)?;
        Ok(Model { elements, integration })
    }

    /// The prepared elements.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    /// How a step is integrated.
    pub fn integration(&self) -> Integration {
        self.integration
    }

    /// The same model with another integration.
    pub fn with_integration(&self, integration: Integration) -> Model {
        Model { integration, ..*self }
    }

    /// Whether `velocity` lies inside the identified FV curve; outside, the curve is prolonged straight.
    #[inline(always)]
    pub fn covers(&self, velocity: f64) -> bool {
        let (low, high) = self.elements.fv_curve.range();
        velocity >= low && velocity <= high || low == high
    }
}
