//! Results of the kernel for a case, under the names of the book's page of equations.

use super::draw::Case;
use dashpot_core::{Model, State, evaluate};

/// Returns names and values of the states of a model, in the order of the model.
pub fn states<'a>(model: &'a Model, state: &'a State) -> impl Iterator<Item = (&'static str, f64)> + 'a {
    let values = [state.mass_displacement, state.mass_velocity].into_iter().chain(state.internal);
    (0..model.states()).zip(values).map(|(i, value)| (model.state_name(i).expect("a state").0, value))
}

/// Returns kind, name and value of every number of a case: force components, state derivatives and steady state.
pub fn answers(case: &Case) -> Vec<(&'static str, &'static str, f64)> {
    let (output, rates) = evaluate(&case.model, &case.state, &case.input);
    let parts = [
        ("force", output.force),
        ("primary_force", output.primary_force),
        ("spring_force", output.spring_force),
        ("friction_force", output.friction_force),
        ("gas_force", output.gas_force),
        ("stop_force", output.stop_force),
        ("series_deflection", output.series_deflection),
        ("oil_temperature", output.oil_temperature),
    ];
    let mut all: Vec<_> = parts.into_iter().map(|(name, value)| ("part", name, value)).collect();
    all.extend(states(&case.model, &rates).map(|(name, value)| ("rate", name, value)));
    let settled = case.model.steady_state(&case.input);
    all.extend(states(&case.model, &settled).map(|(name, value)| ("settled", name, value)));
    all
}
