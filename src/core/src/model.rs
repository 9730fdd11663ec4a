//! A model: parameters checked and made ready for evaluation.

use crate::elements::Elements;
use crate::fault::Fault;
use crate::parameter::Params;
use crate::step::Integration;

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
        Ok(Model { elements: Elements::prepare(params)?, integration: Integration::prepare(params)? })
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
