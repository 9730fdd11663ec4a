//! Bleed, leak and blow-off, from the FV curve of each stroke.
//!
//! Below the knee of the FV curve, the force of the passages at the piston speed w is a w + b w². This law is from
//! Merritt, Hydraulic Control Systems, 1967, chapter 3. The coefficient b, N s²/m², belongs to an orifice. The inverse
//! 1/a of the coefficient a, N s/m, is proportional to the leak at very low speed. At the largest force, the flow in
//! excess of the bleed flow passes the blow-off valve.

use super::errors;
use super::model::Identified;
use super::report::{Explanation, Gap, Quantity};
use crate::dimensions::{Design, Dimensions};
use crate::entry::Entry;
use crate::geometry::{annulus, area};
use crate::orifice;
use crate::phrases;
use crate::uncertain::{Uncertain, through};
use dashpot_messages::Template;

/// Square meters per mm². [`CM3_PER_BAR`] is m³/(s Pa) per cm³/(s bar).
const MM2: f64 = 1e-6;
const CM3_PER_BAR: f64 = 1e-11;
/// Ratio of the slope of the FV curve to its steepest slope, below which a valve has opened.
const KNEE: f64 = 0.9;
/// Largest number of points below the knee from which the force law of the bleed is fitted. If there are more, only the
/// fastest are used, because further points add no information.
const POINTS: usize = 8;

/// A stroke with the names of its quantities.
struct Stroke {
    sign: f64,
    names: [&'static str; 3],
}

const STROKES: [Stroke; 2] = [
    Stroke { sign: 1.0, names: ["rebound_bleed_area", "rebound_leak", "rebound_blow_off_area"] },
    Stroke { sign: -1.0, names: ["compression_bleed_area", "compression_leak", "compression_blow_off_area"] },
];

/// Adds the passages of both strokes to the explanation.
pub(super) fn explain(model: &Identified, drawing: &Dimensions, to: &mut Explanation) {
    for stroke in &STROKES {
        stroke.explain(model, drawing, to);
    }
}

/// Returns the number of points up to the knee, beyond which a valve has opened.
///
/// The knee is the first segment whose slope is below [`KNEE`] times the steepest slope before it, beyond the
/// uncertainty of both points.
///
/// The segment from rest to the first point does not count. It contains the error of the friction, so it may be far too
/// steep.
fn bleed_points(points: &[(f64, Uncertain)]) -> usize {
    let half = |of: &Uncertain| 0.5 * (of.high - of.low);
    let mut steepest = 0.0f64;
    for (count, pair) in points.windows(2).enumerate() {
        let [(w0, h0), (w1, h1)] = [pair[0], pair[1]];
        let (width, rise, error) = ((w1 - w0).max(1e-12), h1.value - h0.value, half(&h0) + half(&h1));
        if rise + error < KNEE * steepest * width {
            return count + 1;
        }
        steepest = steepest.max((rise - error) / width);
    }
    points.len()
}

/// Fits h = `a` w + `b` w² to forces h, N, at speeds w, m/s, by least squares of relative errors. Neither coefficient
/// is negative.
fn bleed_law(speeds: &[f64], forces: &[f64]) -> (f64, f64) {
    // Relative errors mean that each equation is divided by its h: the target is 1, and the columns are w/h and w²/h.
    let sums = speeds.iter().zip(forces).fold([0.0; 5], |s, (w, h)| {
        let (p, q) = (w / h, w * w / h);
        [s[0] + p * p, s[1] + p * q, s[2] + q * q, s[3] + p, s[4] + q]
    });
    let [pp, pq, qq, p, q] = sums;
    let determinant = pp * qq - pq * pq;
    let (a, b) = ((p * qq - q * pq) / determinant, (q * pp - p * pq) / determinant);
    if !(determinant > 1e-12 * pp * qq) || b < 0.0 {
        (p / pp, 0.0)
    } else if a < 0.0 {
        (0.0, q / qq)
    } else {
        (a, b)
    }
}

impl Stroke {
    /// Returns the effective piston area of the stroke, m². The pressure difference of the valves acts on this area,
    /// and the area displaces their flow. The diameters of bore and rod are in m.
    fn area(&self, design: Option<Design>, bore: f64, rod: f64) -> f64 {
        if self.sign < 0.0 && design == Some(Design::TwinTube) { area(rod) } else { annulus(bore, rod) }
    }

    fn explain(&self, model: &Identified, drawing: &Dimensions, to: &mut Explanation) {
        let points = model.branch(self.sign);
        let mut entries = drawing.missing(&[Entry::Bore, Entry::Rod]);
        if self.sign < 0.0 && drawing.design.is_none() {
            entries.push(crate::entry::DESIGN);
        }
        let has_table = model.has_table() && !points.is_empty();
        if !has_table || !entries.is_empty() {
            let parameters: &[_] = if has_table { &[] } else { &["fv_force"] };
            for name in self.names {
                to.unknown.push(gap(name, phrases::PASSAGE_FROM, &entries, parameters));
            }
            return;
        }
        let Some(inputs) = drawing.all(&[Entry::Bore, Entry::Rod, Entry::DischargeCoefficient, Entry::OilDensity])
        else {
            return;
        };
        let count = bleed_points(&points);
        let below = points[count.saturating_sub(POINTS)..count].to_vec();
        let speeds = below.iter().map(|point| point.0).collect();
        let passages = Passages { stroke: self, design: drawing.design, inputs, below, speeds };
        passages.explain_bleed(to);
        passages.explain_blow_off(&points[count..], to);
    }
}

/// Drawing and FV curve of a stroke, from which its passages follow.
struct Passages<'a> {
    stroke: &'a Stroke,
    design: Option<Design>,
    /// Bore, rod, discharge coefficient and oil density.
    inputs: Vec<Uncertain>,
    /// Points of the curve below the knee: speed, m/s, and force, N.
    below: Vec<(f64, Uncertain)>,
    /// Speeds of these points, m/s.
    speeds: Vec<f64>,
}

impl Passages<'_> {
    /// Returns the uncertain numbers from which a quantity follows.
    ///
    /// They are the inputs, the error factor of the quantity, the forces below the knee, and the numbers `more`, in
    /// this order.
    fn numbers(&self, error: f64, more: &[Uncertain]) -> Vec<Uncertain> {
        let mut all = self.inputs.clone();
        all.push(Uncertain::within_factor(1.0, error));
        all.extend(self.below.iter().map(|point| point.1));
        all.extend(more);
        all
    }

    /// Returns the forces below the knee among the [`Passages::numbers`].
    fn forces<'x>(&self, numbers: &'x [f64]) -> &'x [f64] {
        &numbers[5..5 + self.below.len()]
    }

    /// Returns the piston area, m², from the [`Passages::numbers`].
    fn area(&self, numbers: &[f64]) -> f64 {
        self.stroke.area(self.design, numbers[0], numbers[1])
    }

    /// Adds the bleed and the leak to the explanation, or the reasons why they are unknown.
    fn explain_bleed(&self, to: &mut Explanation) {
        let [bleed, leak, _] = self.stroke.names;
        if self.below.len() < 2 {
            for name in [bleed, leak] {
                to.unknown.push(gap(name, phrases::FEW_SLOW_POINTS, &[], &["fv_force at two slow speeds"]));
            }
            return;
        }
        let law = |x: &[f64]| bleed_law(&self.speeds, self.forces(x));
        let found = through(&self.numbers(errors::BLEED, &[]), |x| {
            orifice::passage_of_quadratic(law(x).1, self.area(x), x[2], x[3]) * x[4]
        });
        let from = sources(Entry::DischargeCoefficient.key());
        let quantity = Quantity::new(bleed, "mm²", found.scaled(1.0 / MM2), from, errors::BLEED);
        to.quantities.push(bounded(quantity, phrases::NO_ORIFICE));
        let found =
            through(&self.numbers(errors::LEAK, &[]), |x| orifice::leak_of_linear(law(x).0, self.area(x)) * x[4]);
        let quantity = Quantity::new(leak, "cm³/(s bar)", found.scaled(1.0 / CM3_PER_BAR), sources(""), errors::LEAK);
        // Without an upper end the curve has no laminar part. The bleed and passages in series with it have a laminar
        // part, too, so the true leak may be smaller, or zero.
        let note = Some(phrases::OF_ALL_PASSAGES.into());
        match quantity.high {
            Some(_) => to.quantities.push(Quantity { low: None, value: None, note, ..quantity }),
            None => to.unknown.push(gap(leak, phrases::NO_LEAK, &[], &[])),
        }
    }

    /// Adds the blow-off valve to the explanation, or the reason why it is unknown. `above` are the points beyond the
    /// knee.
    fn explain_blow_off(&self, above: &[(f64, Uncertain)], to: &mut Explanation) {
        let [.., blow_off] = self.stroke.names;
        let unknown = |why: Template| gap(blow_off, why, &[], &["fv_force at a fast speed"]);
        let Some(&(speed, force)) = above.last() else {
            to.unknown.push(unknown(phrases::NO_KNEE));
            return;
        };
        let last = 5 + self.below.len();
        let found = through(&self.numbers(errors::BLOW_OFF, &[force]), |x| {
            let piston = self.area(x);
            let bled = match self.below.len() {
                0 => 0.0,
                1 => self.speeds[0] * libm::sqrt(x[last] / x[5]),
                _ => {
                    let (a, b) = bleed_law(&self.speeds, self.forces(x));
                    orifice::bleed_speed(x[last], a, b)
                }
            };
            orifice::passage_area(piston * (speed - bled).max(0.0), x[last] / piston, x[2], x[3]) * x[4]
        });
        if found.low == Some(0.0) && found.high == Some(0.0) {
            to.unknown.push(unknown(phrases::BLEED_PASSES_ALL));
            return;
        }
        let from = sources(Entry::DischargeCoefficient.key());
        to.quantities.push(Quantity {
            note: Some(phrases::OPENING_AT.into()),
            ..Quantity::new(blow_off, "mm²", found.scaled(1.0 / MM2), from, errors::BLOW_OFF)
        });
    }
}

/// Makes the [`Gap`] of an unknown quantity. It states the entries of the drawing and the parameters of the model that
/// the quantity needs.
fn gap(name: &'static str, why: Template, entries: &[&'static str], parameters: &[&'static str]) -> Gap {
    Gap { name, why: why.into(), entries: entries.to_vec(), parameters: parameters.to_vec() }
}

/// Lists the parameters and entries from which a quantity follows. An empty name is left out.
fn sources(more: &'static str) -> Vec<&'static str> {
    ["fv_force", Entry::Bore.key(), Entry::Rod.key(), more].into_iter().filter(|key| !key.is_empty()).collect()
}

/// Removes the value and adds a note if a quantity has no upper end.
fn bounded(quantity: Quantity, note: Template) -> Quantity {
    if quantity.high.is_some() { quantity } else { Quantity { value: None, note: Some(note.into()), ..quantity } }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_law_of_a_bleed_comes_back_and_ends_at_the_knee() {
        let (a, b) = (2000.0, 40_000.0);
        let mut points: Vec<(f64, Uncertain)> =
            [0.02, 0.05, 0.09].map(|w| (w, Uncertain::within(a * w + b * w * w, 0.0))).to_vec();
        points.push((0.3, Uncertain::within(900.0, 0.0)));
        assert_eq!(bleed_points(&points), 3);
        // Friction that is 20 N too small raises all points. It increases only the slope from rest to the first point,
        // which does not count.
        let raised: Vec<(f64, Uncertain)> =
            points.iter().map(|(w, h)| (*w, Uncertain::within(h.value + 20.0, 0.0))).collect();
        assert_eq!(bleed_points(&raised), 3);
        // A lower slope within the uncertainty of the points is no knee.
        let last = Uncertain::within(a * 0.12 + b * 0.0144 - 100.0, 60.0);
        let unsure: Vec<(f64, Uncertain)> = points[..3].iter().copied().chain([(0.12, last)]).collect();
        assert_eq!(bleed_points(&unsure), 4);
        let speeds = [0.02, 0.05, 0.09];
        let (found_a, found_b) = bleed_law(&speeds, &speeds.map(|w| a * w + b * w * w));
        assert!((found_a / a - 1.0).abs() < 1e-9 && (found_b / b - 1.0).abs() < 1e-9);
        assert_eq!(bleed_law(&speeds, &speeds.map(|w| a * w)).1.max(1e-6), 1e-6);
        assert_eq!(bleed_law(&speeds, &speeds.map(|w| 9e4 * w * w * w)).0, 0.0);
    }
}
