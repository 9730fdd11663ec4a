//! The characteristic diagram of a damper: peak force over peak velocity, with the identified curve and optional
//! limits.

use super::axes::{Axis, Marks, Plane, Series};
use super::palette::Role;
use crate::words::Words;
use dashpot_identification::limits::{Certificate, Quantity};
use dashpot_identification::validation::Validation;

/// Width and height of the figure, px. The width fills a printed page.
const SIZE: [f64; 2] = [880.0, 400.0];

/// Draws measured and computed peak forces of all tests over peak velocity. Returns `None` if no test has a peak
/// velocity.
///
/// `curve` contains velocities, m/s, and the model's force, N, at each constant velocity.
pub fn force_at_peak(validation: &Validation, curve: &[[f64; 2]], words: &Words) -> Option<String> {
    let peaks: Vec<_> = validation.tests.iter().flat_map(|t| &t.peaks).collect();
    let measured = peaks.iter().map(|p| [1e3 * p.velocity_m_s, p.force_n.measured]).collect();
    let model = peaks.iter().map(|p| [1e3 * p.velocity_m_s, p.force_n.model]).collect();
    draw(measured, model, curve, validation.limits.as_ref(), words)
}

/// Draws the peak forces and the limits of a certificate over peak velocity. Returns `None` without measured peaks.
pub fn against_limits(certificate: &Certificate, curve: &[[f64; 2]], words: &Words) -> Option<String> {
    let peaks = &certificate.peaks;
    let measured = peaks.iter().map(|p| [1e3 * p.velocity_m_s, p.force_n]).collect();
    let model = peaks.iter().filter_map(|p| Some([1e3 * p.velocity_m_s, p.model_n?])).collect();
    draw(measured, model, curve, Some(certificate), words)
}

fn draw(
    measured: Vec<[f64; 2]>,
    model: Vec<[f64; 2]>,
    curve: &[[f64; 2]],
    limits: Option<&Certificate>,
    words: &Words,
) -> Option<String> {
    if measured.is_empty() {
        return None;
    }
    let curve: Vec<[f64; 2]> = curve.iter().map(|[v, f]| [1e3 * v, *f]).collect();
    let all = || measured.iter().chain(&model).chain(&curve).copied();
    let mut x = Axis::around(words.axis_velocity, all().map(|p| p[0]));
    let mut y = Axis::around(words.axis_force, all().map(|p| p[1]));
    let mut series = Vec::new();
    if let Some(certificate) = limits {
        let windows: Vec<[f64; 3]> = certificate
            .limits
            .iter()
            .map(|l| &l.limit)
            .filter(|l| l.quantity == Quantity::Force)
            .filter_map(|l| {
                let v = 1e3 * l.velocity_m_s?;
                // A one-sided limit extends to the edge of the figure.
                Some([v, l.low.unwrap_or(y.low), l.high.unwrap_or(y.high)])
            })
            .collect();
        x = Axis::around(words.axis_velocity, all().map(|p| p[0]).chain(windows.iter().map(|w| w[0])));
        y = Axis::around(words.axis_force, all().map(|p| p[1]).chain(windows.iter().flat_map(|w| [w[1], w[2]])));
        let cap = 0.008 * (x.high - x.low);
        let lines: Vec<Vec<[f64; 2]>> = windows
            .iter()
            .map(|[v, low, high]| {
                vec![[v - cap, *low], [v + cap, *low], [*v, *low], [*v, *high], [v - cap, *high], [v + cap, *high]]
            })
            .collect();
        series.push(Series { role: Role::Limit, label: words.window, lines, marks: Marks::Line });
    }
    let dots = |role, label, points| Series { role, label, lines: vec![points], marks: Marks::Dots };
    series.push(Series { role: Role::FvOnly, label: words.identified_curve, lines: vec![curve], marks: Marks::Line });
    series.push(Series { marks: Marks::LargeDots, ..dots(Role::Measured, words.measured_peaks, measured) });
    series.push(dots(Role::Model, words.model_peaks, model));
    series.retain(|s| s.lines.iter().any(|l| !l.is_empty()));
    Some(Plane { title: words.plot_peaks.into(), x, y, series }.draw_sized(SIZE, words))
}

#[cfg(test)]
mod tests {
    use super::super::of_test::tests::{compared, record};
    use super::*;
    use crate::words::EN;
    use dashpot_identification::limits::{judge, parse};
    use dashpot_identification::validation::validate;

    #[test]
    fn peaks_curve_and_windows_are_drawn() {
        let record = record(4, true);
        let mut validation = validate(&[compared(&record)]).unwrap();
        let text = "quantity,velocity_m_s,low,high\nforce,0.31,900,940\nforce,-0.31,-940,-850\n";
        validation.limits = Some(judge(&parse("l.csv".as_ref(), text).unwrap(), &[&record], None));
        let figure = force_at_peak(&validation, &[[-0.3, -860.0], [0.3, 880.0]], &EN).unwrap();
        for class in ["measured", "model", "fv-only", "limit"] {
            assert!(figure.contains(&format!("class=\"l {class}\"")), "{class}");
        }
        assert!(!figure.contains("NaN"));
        validation.tests[0].peaks.clear();
        assert!(force_at_peak(&validation, &[], &EN).is_none());
    }
}
