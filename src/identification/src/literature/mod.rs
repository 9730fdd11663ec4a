//! Models for comparison with dashpot's own model: the models of today's vehicle simulation, and damper models of the literature.
//!
//! Each model has a separate source file that names the paper with its definition. All models are identified from the tests of dashpot's
//! model by the same least squares, and then predict the force of any motion. The models serve for comparison only. The kernel can run the
//! models for which it has elements ([`Literature::params`]). The other models are stored in a separate file format ([`mod@file`]).
//!
//! | file | model |
//! |---|---|
//! | [`fv_curve`] | force-velocity curve with the points that an engineer would choose, with friction step and gas force |
//! | [`piecewise_linear`] | straight lines with two rebound knees and one compression knee |
//! | [`lagged_polynomial`] | polynomial in velocity, followed by a first-order lag |
//! | [`restoring_force_surface`] | Chebyshev surface over displacement and velocity |
//! | [`dahl`] | Dahl friction in parallel with spring and dashpot |
//! | [`bouc_wen`] | Bouc-Wen hysteresis in parallel with spring and dashpot |
//! | [`spencer`] | Spencer's modified Bouc-Wen model |
//! | [`kwok`] | Kwok's hyperbolic tangent |
//! | [`neural_network`] | a small feed-forward network of displacement, velocity and acceleration |
//!
//! | file | shared part |
//! |---|---|
//! | [`observation`] | tests in the format of these models, from the prepared tests of a fit or from a record |
//! | [`law`] | parameters, starts and least squares of models that consist of a formula |
//! | [`bristle`] | relative hysteretic force of Dahl, Bouc-Wen and Spencer as a function of travel |
//! | [`mod@file`] | file of a model that the kernel cannot run |

mod bouc_wen;
mod bristle;
mod dahl;
pub mod file;
pub mod fv_curve;
mod kwok;
mod lagged_polynomial;
mod law;
mod neural_network;
pub mod observation;
pub mod piecewise_linear;
mod restoring_force_surface;
mod spencer;

use dashpot_core::Params;
use observation::{Observation, SampledMotion};
use serde::{Deserialize, Serialize};

/// A model of the literature with its parameters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "literature_model", rename_all = "snake_case")]
pub enum Literature {
    /// Plain FV curve.
    Fv(fv_curve::FvCurve),
    /// Piecewise-linear FV curve.
    Piecewise(piecewise_linear::PiecewiseLinear),
    /// Polynomial FV curve with lag.
    Lag(lagged_polynomial::LaggedPolynomial),
    /// Restoring-force surface.
    Surface(restoring_force_surface::Surface),
    /// Dahl friction with spring and dashpot.
    Dahl(dahl::Dahl),
    /// Bouc-Wen hysteresis with spring and dashpot.
    BoucWen(bouc_wen::BoucWen),
    /// Spencer's modified Bouc-Wen model.
    Spencer(spencer::Spencer),
    /// Kwok's hyperbolic tangent model.
    Kwok(kwok::Kwok),
    /// Neural network.
    Network(neural_network::Network),
}

/// Names of the models on the command line, each with a description of the model.
pub const MODELS: [(&str, &str); 9] = [
    ("fv", "force-velocity curve with friction step and gas force"),
    ("piecewise", "piecewise-linear force-velocity curve"),
    ("lag", "polynomial in velocity with a first-order lag"),
    ("surface", "restoring-force surface (Masri & Caughey 1979)"),
    ("dahl", "Dahl friction with spring and dashpot (Dahl 1968)"),
    ("bouc-wen", "Bouc-Wen hysteresis with spring and dashpot (Wen 1976)"),
    ("spencer", "modified Bouc-Wen (Spencer et al. 1997)"),
    ("kwok", "hyperbolic tangent (Kwok et al. 2006)"),
    ("network", "small neural network of displacement, velocity and acceleration"),
];

/// Reason why the identification of a model of the literature failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LiteratureError {
    /// No model has the given name.
    #[error("there is no model called {name:?} to compare with; there are {}", MODELS.map(|m| m.0).join(", "))]
    Unknown {
        /// Unknown name.
        name: String,
    },
    /// No test has scored samples.
    #[error("there is no test to fit {name} to")]
    NoTests {
        /// Name of the model.
        name: &'static str,
    },
    /// No start gives finite forces.
    #[error("{name} gives no finite force on these tests from any of its starts; leave it out of --against")]
    NotFinite {
        /// Name of the model.
        name: &'static str,
    },
}

impl Literature {
    /// Identifies the model with the name `name` from tests.
    ///
    /// # Errors
    /// The name is unknown, there are no tests, or no start gives finite forces.
    pub fn fit(name: &str, tests: &[Observation]) -> Result<Literature, LiteratureError> {
        let Some((name, _)) = MODELS.iter().find(|m| m.0 == name) else {
            return Err(LiteratureError::Unknown { name: name.to_owned() });
        };
        if tests.iter().all(|t| t.from >= t.force.len()) {
            return Err(LiteratureError::NoTests { name });
        }
        let found = match *name {
            "fv" => Some(Literature::Fv(fv_curve::fit(tests))),
            "piecewise" => law::fit(tests).map(Literature::Piecewise),
            "lag" => lagged_polynomial::fit(tests).map(Literature::Lag),
            "surface" => restoring_force_surface::fit(tests).map(Literature::Surface),
            "dahl" => law::fit(tests).map(Literature::Dahl),
            "bouc-wen" => law::fit(tests).map(Literature::BoucWen),
            "spencer" => spencer::fit(tests).map(Literature::Spencer),
            "kwok" => law::fit(tests).map(Literature::Kwok),
            _ => neural_network::fit(tests).map(Literature::Network),
        };
        found.ok_or(LiteratureError::NotFinite { name })
    }

    /// Returns the name of the model on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Literature::Fv(_) => "fv",
            Literature::Piecewise(_) => "piecewise",
            Literature::Lag(_) => "lag",
            Literature::Surface(_) => "surface",
            Literature::Dahl(_) => "dahl",
            Literature::BoucWen(_) => "bouc-wen",
            Literature::Spencer(_) => "spencer",
            Literature::Kwok(_) => "kwok",
            Literature::Network(_) => "network",
        }
    }

    /// Returns the force of the model at every sample of a motion, N.
    pub fn forces(&self, motion: &SampledMotion) -> Vec<f64> {
        use law::Law as _;
        match self {
            Literature::Fv(model) => model.forces(motion),
            Literature::Piecewise(model) => model.forces(motion),
            Literature::Lag(model) => model.forces(motion),
            Literature::Surface(model) => model.forces(motion),
            Literature::Dahl(model) => model.forces(motion),
            Literature::BoucWen(model) => model.forces(motion),
            Literature::Spencer(model) => model.forces(motion),
            Literature::Kwok(model) => model.forces(motion),
            Literature::Network(model) => model.forces(motion),
        }
    }

    /// Converts the model to a parameter set. Returns `None` if the kernel has no elements for it.
    pub fn params(&self) -> Option<Params> {
        match self {
            Literature::Fv(model) => Some(model.params()),
            Literature::Piecewise(model) => Some(model.params()),
            Literature::Lag(model) => Some(model.params()),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests;
