//! A whole cycle of a periodic test, as found by [`crate::cleaning`].

/// A whole cycle, from one upward crossing of the mean displacement to the next: its samples, the crossing times, and
/// its extremes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cycle {
    /// First sample.
    pub start: usize,
    /// One past the last sample.
    pub end: usize,
    /// Time of the upward crossing of the mean displacement at the start, s, interpolated between samples.
    pub start_time: f64,
    /// Time of the upward crossing of the mean displacement at the end, s.
    pub end_time: f64,
    /// Lowest displacement, m.
    pub low: f64,
    /// Highest displacement, m.
    pub high: f64,
}

impl Cycle {
    pub fn period(&self) -> f64 {
        self.end_time - self.start_time
    }

    pub fn stroke(&self) -> f64 {
        self.high - self.low
    }
}
