//! The tests of a fit: the same samples that a diagnosis looks at, each test whole and weighed by its size.

use super::road::Extent;
use super::{Test, of_record};
use crate::segment::Segment;
use dashpot_records::Record;
use rayon::prelude::*;

/// Share of a test's largest force below which no model is expected to be right; it keeps clean tests from outweighing all others.
/// Smaller values give the fastest tests to noise, larger ones the slow tests.
const MODEL_FLOOR: f64 = 0.01;
/// Samples that one test counts at most: a road has as many as it likes, but is one test.
const PER_TEST: f64 = 400.0;

/// The segments of all records, in their order.
pub fn segments(records: &[&Record]) -> Vec<Segment> {
    records
        .par_iter()
        .enumerate()
        .flat_map_iter(|(place, record)| of_record(place, record, 1, Extent::Whole).into_iter().map(weighed))
        .collect()
}

fn weighed(test: Test) -> Segment {
    let count = test.count() as f64;
    let crowd = (count / PER_TEST).max(1.0).sqrt();
    let segment = test.segment;
    let scale = crowd * (test.mean_noise.powi(2) + (MODEL_FLOOR * segment.top).powi(2)).sqrt().max(1e-6);
    Segment { scale, ..segment }
}
