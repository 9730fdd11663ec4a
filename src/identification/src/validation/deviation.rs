//! Error figures of a simulated force, compared with the measured force.

use serde::Serialize;

/// Speed that separates region 1 (slow: friction, bleed, hysteresis) from region 2 (fast: valve shims, blow-off), m/s.
///
/// The thesis of Jonnalagadda & Vyas prints the errors of both regions but not the boundary. Its tables imply a boundary between two peak
/// velocities of its schedule, 0.262 m/s and 0.524 m/s. The value is the rounded middle of these two.
pub const REGION_BOUNDARY: f64 = 0.4;

/// Error figures of a simulated force, compared with the measured force over a test.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Deviation {
    /// Mean of |simulated − measured| over the samples, N.
    pub mean_error_n: f64,
    /// 100 · mean error / largest |measured force|, %.
    pub error_percent: f64,
    /// Contribution of the samples slower than [`REGION_BOUNDARY`] to the mean error, N. The contributions of both regions add up to the
    /// mean error.
    pub region1_n: f64,
    /// Contribution of the samples at or above [`REGION_BOUNDARY`] to the mean error, N.
    pub region2_n: f64,
    /// Root mean square of simulated − measured, N.
    pub rmse_n: f64,
}

/// Error figures of the full model, and of the force–velocity curve alone for comparison.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Figures of the full model.
    #[serde(flatten)]
    pub model: Deviation,
    /// Figures of the force–velocity curve alone.
    pub fv_only: Deviation,
}

impl Deviation {
    /// Computes the figures of one test. The slices have equal lengths and finite values. `max_force` is the largest |measured force|, N,
    /// and not zero.
    pub(super) fn of_test(simulated: &[f64], measured: &[f64], velocity: &[f64], max_force: f64) -> Self {
        let (mut region1, mut region2, mut squares) = (0.0, 0.0, 0.0);
        for ((simulated, measured), velocity) in simulated.iter().zip(measured).zip(velocity) {
            let error = simulated - measured;
            squares += error * error;
            if velocity.abs() < REGION_BOUNDARY {
                region1 += error.abs();
            } else {
                region2 += error.abs();
            }
        }
        let samples = measured.len() as f64;
        let mean_error_n = (region1 + region2) / samples;
        Self {
            mean_error_n,
            error_percent: percent(mean_error_n, max_force),
            region1_n: region1 / samples,
            region2_n: region2 / samples,
            rmse_n: (squares / samples).sqrt(),
        }
    }

    /// Averages every figure. Each test counts once, regardless of its length.
    pub(super) fn mean(of: &[Self]) -> Self {
        let mean = |figure: fn(&Self) -> f64| of.iter().map(figure).sum::<f64>() / of.len() as f64;
        Self {
            mean_error_n: mean(|d| d.mean_error_n),
            error_percent: mean(|d| d.error_percent),
            region1_n: mean(|d| d.region1_n),
            region2_n: mean(|d| d.region2_n),
            rmse_n: mean(|d| d.rmse_n),
        }
    }
}

impl Errors {
    /// Averages every figure over tests with equal weights. Returns `None` without tests.
    pub(super) fn mean(of: &[Self]) -> Option<Self> {
        if of.is_empty() {
            return None;
        }
        let model: Vec<Deviation> = of.iter().map(|errors| errors.model).collect();
        let fv_only: Vec<Deviation> = of.iter().map(|errors| errors.fv_only).collect();
        Some(Self { model: Deviation::mean(&model), fv_only: Deviation::mean(&fv_only) })
    }

    /// Returns the figures with errors in percent of another largest force, N, such as that of a whole row of tests.
    pub(super) fn in_percent_of(mut self, max_force: f64) -> Self {
        for deviation in [&mut self.model, &mut self.fv_only] {
            deviation.error_percent = percent(deviation.mean_error_n, max_force);
        }
        self
    }
}

/// Computes the error in percent with the definition of Jonnalagadda & Vyas.
fn percent(mean_error: f64, max_force: f64) -> f64 {
    100.0 * mean_error / max_force
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_table_is_reproduced() {
        // In Table 5.1 of Jonnalagadda & Vyas, Test 1 has an error of 148.1041 N at 3466 N, printed as 4.27 %.
        let measured = [3466.0, -1000.0, 0.0, 500.0];
        let simulated = measured.map(|force| force - 148.1041);
        let got = Deviation::of_test(&simulated, &measured, &[1.0, -1.0, 0.0, 0.1], 3466.0);
        assert!((got.mean_error_n - 148.1041).abs() < 1e-9);
        assert!((got.error_percent - 4.2731).abs() < 1e-4, "{}", got.error_percent);
    }

    #[test]
    fn a_constant_offset_has_equal_mean_and_root_mean_square() {
        let measured = [100.0, -40.0, 7.0];
        let got = Deviation::of_test(&measured.map(|f| f + 20.0), &measured, &[0.0, 0.5, -0.5], 100.0);
        assert!((got.mean_error_n - 20.0).abs() < 1e-12 && (got.rmse_n - 20.0).abs() < 1e-12);
        assert!((got.error_percent - 20.0).abs() < 1e-12);
        assert!((got.region1_n - 20.0 / 3.0).abs() < 1e-12 && (got.region2_n - 40.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn the_boundary_speed_itself_is_fast_in_both_strokes() {
        let got = Deviation::of_test(&[1.0; 4], &[0.0; 4], &[0.4, -0.4, 0.399, -0.399], 1.0);
        assert_eq!((got.region1_n, got.region2_n), (0.5, 0.5));
    }

    #[test]
    fn every_test_counts_once() {
        let test = |error: f64| {
            let deviation = Deviation { mean_error_n: error, error_percent: error / 10.0, ..Deviation::default() };
            Errors { model: deviation, fv_only: deviation }
        };
        let mean = Errors::mean(&[test(10.0), test(30.0)]).unwrap();
        assert_eq!((mean.model.mean_error_n, mean.fv_only.error_percent), (20.0, 2.0));
        assert_eq!(mean.in_percent_of(400.0).model.error_percent, 5.0);
        assert_eq!(Errors::mean(&[]), None);
    }
}
