//! The settings of the step as rows of the parameter table, from which [`crate::integration::Integration`] is prepared.

use crate::schema::{Describe, Parameter};

/// Settings of the integration: the last group of the parameter table.
#[derive(Clone, Copy, Debug)]
pub struct Settings;

impl Describe for Settings {
    const MEANING: &'static str = "settings of the fixed-step integration";
    const PARAMETERS: &'static [Parameter] = &[
        Parameter::choice(
            "method",
            &["automatic", "second_order", "euler", "third_order", "fourth_order", "three_stage"],
            "integration method within a step; automatic: the cheapest with an error below a thousandth in a step of 1 ms",
        ),
        Parameter::scalar(
            "substeps",
            "-",
            &[0.0],
            (0.0, 64.0),
            "substeps within one step of the host; 0: as many as stiffness and damping of the model require",
        ),
    ];
}
