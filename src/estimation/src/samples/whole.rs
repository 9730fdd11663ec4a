//! Tests of a fit: the samples that a diagnosis uses, but with each test whole and weighted by its largest force.

use super::road::Extent;
use super::{Test, of_record};
use crate::segment::Segment;
use dashpot_records::Record;
use rayon::prelude::*;

/// Expected model error as a fraction of a test's largest force; it limits the weight of tests with little noise. With
/// a smaller value, noise dominates the fastest tests. With a larger value, noise dominates the slow tests.
const MODEL_FLOOR: f64 = 0.01;
/// Largest number of samples with which one test counts in a fit. If a test has more samples, such as a road, its
/// errors are divided by a larger scale.
const PER_TEST: f64 = 400.0;

/// Makes the segments of all records, in their order.
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
