//! The test matrix: the tests of a campaign.

mod point;
mod table;
mod thesis;

use std::collections::BTreeMap;

use crate::RigError;

pub use point::{DEFAULT_CYCLES_FAST, DEFAULT_CYCLES_SLOW, TestPoint, default_cycles};
pub use thesis::{MatrixOptions, RIG_FREQUENCY_LIMIT_HZ};

/// The tests of a campaign, in the order of execution.
#[derive(Debug, Clone, PartialEq)]
pub struct Matrix {
    points: Vec<TestPoint>,
}

impl Matrix {
    /// Makes a test matrix of the given tests.
    ///
    /// # Errors
    /// [`RigError::TestPoint`] if a test is outside the rig's limits, or if two names are equal except for case.
    /// [`RigError::Option`] if the list is empty.
    pub fn new(points: Vec<TestPoint>) -> Result<Self, RigError> {
        if points.is_empty() {
            return Err(RigError::Option {
                option: "matrix",
                problem: "it contains no test; give at least one".into(),
            });
        }
        let mut seen = BTreeMap::new();
        for (index, point) in points.iter().enumerate() {
            point.check().map_err(|fault| RigError::TestPoint { test: point.name.clone(), problem: fault.problem })?;
            if let Some(first) = seen.insert(point.name.to_lowercase(), index) {
                return Err(RigError::TestPoint {
                    test: point.name.clone(),
                    problem: format!(
                        "test {} of the matrix has this name too; every test needs a name of its own",
                        first + 1
                    ),
                });
            }
        }
        Ok(Self { points })
    }

    /// Returns the tests, in the order of execution.
    pub fn points(&self) -> &[TestPoint] {
        &self.points
    }

    /// Returns whether any test has side force, so that the records have a side-force column.
    pub fn has_side_force(&self) -> bool {
        self.points.iter().any(|point| point.side_force_n != 0.0)
    }
}
