//! Size of the effects that a diagnosis without a finding cannot exclude.

use crate::decisions::CLEARLY;
use crate::phrases;
use dashpot_estimation::samples::Test;
use dashpot_messages::Sentence;

/// Returns a note if the residual is more than [`CLEARLY`] times the noise of the mean cycles, otherwise `None`.
///
/// The part of the residual beyond the noise counts as form error of the FV curve. An effect whose force is as large as
/// this part cannot be distinguished from the form error. `mean_squares` contains the mean square residual of each
/// test, in units of the squared error expected from noise and curve form ([`Test::unit`]).
pub fn note(tests: &[Test], mean_squares: &[f64]) -> Option<Sentence> {
    let count = tests.len().max(1) as f64;
    let squares: f64 = tests.iter().zip(mean_squares).map(|(test, square)| square * test.unit().powi(2)).sum();
    let noise: f64 = tests.iter().map(|test| test.mean_noise.powi(2)).sum();
    note_of((squares / count).sqrt(), (noise / count).sqrt())
}

/// Returns the note for a residual and a noise, N rms, or `None` if the residual is at most [`CLEARLY`] times the
/// noise.
fn note_of(residual: f64, noise: f64) -> Option<Sentence> {
    (residual > CLEARLY * noise).then(|| {
        Sentence::from(phrases::DETECTION_LIMIT)
            .with("residual", format!("{residual:.1}"))
            .with("noise", format!("{noise:.1}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_residual_above_twice_the_noise_is_stated_with_it() {
        assert_eq!(note_of(2.3, 1.2), None);
        let text = note_of(2.5, 1.2).unwrap().to_string();
        assert!(text.contains("by 2.5 N rms, and their noise is 1.2 N"), "{text}");
    }
}
