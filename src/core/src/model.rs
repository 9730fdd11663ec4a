//! A model: checked parameters, prepared for evaluation.

use crate::assembly::Elements;
use crate::fault::{Fault, Reason};
use crate::integration::Integration;
use crate::parameter::{Element, Params};
use crate::paths;
use crate::tables::{ForceLaw, Owned, Tables};

use crate::{element, number};

/// Largest displacement from zero, m, up to which the springs on the internal mass must not be stiffer than the series
/// spring.
const STROKE: f64 = 0.1;
/// Number of displacements on each side of 0, half a millimeter apart, at which [`Model::check`] compares two
/// stiffnesses. These are the stiffness of the springs on the internal mass and that of the series spring.
const PLACES: i32 = 200;

/// Units of the internal states of parallel elements. The state of an element that is not listed has the unit "-".
const MEMORY_UNITS: [(Element, &str); 3] =
    [(element!("lagged_polynomial"), "N"), (element!("presliding_friction"), "m"), (element!("moving_mass"), "m/s")];

/// A prepared damper. It is constant during a run and serves any number of states.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Model<T: Tables = Owned> {
    pub(crate) elements: Elements<T>,
    pub(crate) integration: Integration,
    /// Layout of the model's states: the set of internal states that a state contains ([`crate::layout`]).
    pub(crate) layout: f64,
}

impl Model {
    /// A model without elements, the initial value for [`Model::set`].
    pub const OFF: Model = Model { elements: Elements::OFF, integration: Integration::OFF, layout: 0.0 };

    /// Checks the parameters and prepares all that stays constant in a run.
    ///
    /// # Errors
    /// Returns the parameter at fault and the reason.
    pub fn new(params: &Params) -> Result<Model, Fault> {
        let mut model = Model::OFF;
        model.set(params)?;
        Ok(model)
    }

    /// Checks whether a model can be made from the parameters.
    ///
    /// # Errors
    /// Returns the parameter at fault and the reason.
    pub fn check(params: &Params) -> Result<(), Fault> {
        params.check()?;
        Elements::check(params)?;
        crate::proportion::check(params)?;
        // A step uses the tangent of the springs on the internal mass at the predicted position. This is stable only if
        // the series spring determines the position of the mass, not the springs on the mass.
        let places = (-PLACES..=PLACES).map(|place| STROKE * f64::from(place) / f64::from(PLACES));
        let too_stiff = |stiffness: f64| Elements::steepest_inner(params, places).map(|steepest| steepest > stiffness);
        let stiffness = number!("series_stiffness");
        if params.is_on(element!("series_compliance")) && too_stiff(params.number(stiffness))? {
            return Err(stiffness.fault(Reason::SofterThanInner));
        }
        Ok(())
    }

    /// Returns the number of internal states of the damper with these parameters, which [`Model::check`] accepted.
    pub(crate) fn memories_of(params: &Params) -> usize {
        Elements::memories_of(params)
    }

    /// Prepares the model in place, because a model is too large for the stack of a small thread.
    ///
    /// # Errors
    /// Returns the parameter at fault and the reason; the model then stays unchanged.
    pub fn set(&mut self, params: &Params) -> Result<(), Fault> {
        Model::check(params)?;
        self.elements.set(params);
        self.elements.join();
        self.integration = Integration::prepare(params, &self.elements);
        self.layout = crate::layout::from_elements(&self.elements);
        Ok(())
    }

    /// Returns a copy of the model with another integration.
    pub fn with_integration(&self, integration: Integration) -> Model {
        Model { integration, ..*self }
    }
}

impl<T: Tables> Model<T> {
    /// Returns the number of states that a solver of the host integrates.
    ///
    /// These are the states of the internal mass, and the internal states of the elements that are on.
    pub fn states(&self) -> usize {
        2 + self.elements.memories()
    }

    /// Returns name and unit of state `index`, in the order of [`crate::Partials`]; `None` beyond the last.
    pub fn state_name(&self, index: usize) -> Option<(&'static str, &'static str)> {
        let e = &self.elements;
        let in_paths = (0..paths::STATES).find(|place| e.paths.slots().index(*place) == Some(index));
        if let Some(place) = in_paths {
            return Some(e.paths.state_name(place));
        }
        let (mut at, mut found) = (2 + e.paths.slots().count(), None);
        e.each_stateful_name(|name| {
            if at == index {
                found = Some((
                    name,
                    MEMORY_UNITS.iter().find(|(element, _)| element.name() == name).map_or("-", |(_, unit)| *unit),
                ));
            }
            at += 1;
        });
        found
    }

    /// Returns the prepared elements.
    pub fn elements(&self) -> &Elements<T> {
        &self.elements
    }

    /// Returns the method and the substeps of a step.
    pub fn integration(&self) -> Integration {
        self.integration
    }

    /// Returns whether `velocity` lies within the points of the FV curve; outside, the curve is extrapolated linearly.
    /// A model without an FV curve covers every velocity.
    #[inline(always)]
    pub fn covers(&self, velocity: f64) -> bool {
        let (low, high) = self.elements.paths.fv_curve.range();
        velocity >= low && velocity <= high || low == high
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::list;
    use crate::parameter::Number;

    /// The number of states counted from the parameters equals that counted from the prepared model, for any set of
    /// elements.
    #[test]
    fn states_are_counted_alike_before_and_after() {
        let all: std::vec::Vec<_> = Element::all().collect();
        let (mut fit, mut too_many) = (0, 0);
        for seed in 0u64..4000 {
            let mut params = Params::new();
            let bits = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            for (i, element) in all.iter().enumerate() {
                params.enable(*element, *element == element!("series_compliance") || bits >> (i + 7) & 1 == 1);
            }
            params.set(number!("valve_form"), (bits >> 40 & 3).min(2) as f64).unwrap();
            params.set(number!("fade_source"), (bits >> 42 & 1) as f64).unwrap();
            params.set(number!("bushing_slow_stiffness"), (bits >> 43 & 1) as f64).unwrap();
            match Model::new(&params) {
                Ok(model) => {
                    assert_eq!(paths::slots::states_of(&params), model.elements.paths.slots().count());
                    let named: std::collections::BTreeSet<_> =
                        (0..model.states()).map(|i| model.state_name(i).unwrap().0).collect();
                    assert_eq!(named.len(), model.states(), "{named:?}");
                    assert_eq!(model.state_name(model.states()), None);
                    fit += 1;
                }
                Err(fault) => {
                    assert_eq!(fault.reason, Reason::TooManyStates);
                    too_many += 1;
                }
            }
        }
        assert!(fit > 500 && too_many > 100, "{fit} {too_many}");
    }

    #[test]
    fn a_refused_set_leaves_the_model_as_it_was() {
        let mut params = Params::new();
        let mut model = Model::new(&params).unwrap();
        let before = std::format!("{model:?}");
        params.set(number!("spring_linear"), 5e6).unwrap();
        assert_eq!(model.set(&params).unwrap_err().reason, Reason::SofterThanInner);
        params.set(number!("spring_linear"), 0.0).unwrap();
        params.set_list(list!("fv_force"), &[1.0]).unwrap();
        assert_eq!(model.set(&params).unwrap_err().reason, Reason::CurveLengths);
        assert_eq!(std::format!("{model:?}"), before);
    }

    /// The check covers the stiffness of the springs on the mass on both sides of zero, over the whole stroke.
    #[test]
    fn a_series_spring_softer_than_what_it_drives_is_refused() {
        let fault = |changes: &[(Number, f64)], lookup: Option<(&[f64], &[f64])>| {
            let mut params = Params::new();
            params.set(number!("spring_quadratic"), 0.0).unwrap();
            for (number, value) in changes {
                params.set(*number, *value).unwrap();
            }
            if let Some((x, f)) = lookup {
                params.set_list(list!("spring_displacement"), x).unwrap();
                params.set_list(list!("spring_force"), f).unwrap();
            }
            Model::new(&params).err().map(|fault| {
                assert_eq!(fault, number!("series_stiffness").fault(fault.reason));
                fault.reason
            })
        };
        let softer = Some(Reason::SofterThanInner);
        let k = (number!("series_stiffness"), 1e5);
        assert_eq!(fault(&[k, (number!("spring_linear"), 0.99e5)], None), None);
        assert_eq!(fault(&[k, (number!("spring_linear"), 1e5)], None), None);
        assert_eq!(fault(&[k, (number!("spring_linear"), 1.01e5)], None), softer);
        // The stiffness of the quadratic spring is 2 k |x|, largest at 0.1 m.
        assert_eq!(fault(&[k, (number!("spring_quadratic"), 4.9e5)], None), None);
        assert_eq!(fault(&[k, (number!("spring_quadratic"), 5.1e5)], None), softer);
        // The spring is steep on one side only.
        let (x, f) = ([-0.2, -0.06, -0.05, 0.2], [-20e3, -2e3, 0.0, 0.0]);
        assert_eq!(fault(&[k], Some((&x, &f))), softer);
        let (x, f) = ([-0.2, 0.05, 0.06, 0.2], [0.0, 0.0, 2e3, 20e3]);
        assert_eq!(fault(&[k], Some((&x, &f))), softer);
        // The spring is steep only at displacements that a damper of 200 mm stroke cannot reach.
        let (x, f) = ([-0.2, 0.12, 0.13, 0.2], [0.0, 0.0, 2e3, 16e3]);
        assert_eq!(fault(&[k], Some((&x, &f))), None);
        // Without the series spring there is no internal mass to drive.
        let mut params = Params::new();
        params.set(number!("spring_linear"), 1e7).unwrap();
        params.enable(element!("series_compliance"), false);
        assert!(Model::new(&params).is_ok());
    }
}
