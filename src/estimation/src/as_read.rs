//! Forces of a model as the rig read them, and their derivatives over all that a fit may change.
//!
//! A mass may hang on the load cell, the force channel may come late, and gain and zero of the load cell may move with the campaign's clock. These numbers belong to the measurement: they stand behind those of the model in the vector of a fit.

use crate::measurement::{Artefact, earlier};
use crate::segment::Segment;
use crate::sensitivity::Run;
use crate::unknowns::Unknowns;
use nalgebra::DMatrix;
use std::borrow::Cow;

/// Share of the standard deviation over which the derivative of a moved motion is a difference: far above what rounding leaves, far below what
/// bends.
const STEP: f64 = 1e-3;

impl Unknowns {
    /// The number of the rig, where it is fitted.
    pub fn of_the_rig(&self, artefact: Artefact, theta: &[f64]) -> Option<f64> {
        let place = self.rig.iter().position(|number| number.artefact == artefact)?;
        theta.get(self.list.len() + place).copied()
    }

    /// The motion that the damper made when it made the force that was read.
    fn gone_through<'a>(&self, segment: &'a Segment, theta: &[f64]) -> Cow<'a, Segment> {
        match self.of_the_rig(Artefact::Delay, theta) {
            Some(tau) => Cow::Owned(earlier(segment, tau)),
            None => Cow::Borrowed(segment),
        }
    }

    /// What the load cell makes of a force. `segment` has the motion that the damper went through.
    fn read(&self, segment: &Segment, theta: &[f64], forces: &mut [f64]) {
        for (number, value) in self.rig.iter().zip(&theta[self.list.len()..]) {
            number.artefact.apply(*value, segment, forces);
        }
    }

    /// Forces at the samples as the rig read them.
    pub fn forces(&self, run: &Run, theta: &[f64], segment: &Segment) -> Vec<f64> {
        let there = self.gone_through(segment, theta);
        let mut forces = run.forces(&there);
        self.read(&there, theta, &mut forces);
        forces
    }

    /// The same with their derivatives: one column per sample, one row per number of the vector.
    pub fn jacobian(&self, run: &Run, theta: &[f64], segment: &Segment) -> (Vec<f64>, DMatrix<f64>) {
        let there = self.gone_through(segment, theta);
        let (pure, rows) = run.jacobian(&there, self, theta);
        if self.rig.is_empty() {
            return (pure, rows);
        }
        let mut forces = pure.clone();
        self.read(&there, theta, &mut forces);
        let gain = 1.0 + self.of_the_rig(Artefact::GainDrift, theta).unwrap_or(0.0) * segment.clock;
        let first = self.list.len();
        let mut all = DMatrix::zeros(theta.len(), forces.len());
        all.rows_mut(0, first).copy_from(&(rows * gain));
        for (place, number) in self.rig.iter().enumerate().map(|(k, number)| (first + k, number)) {
            let step = STEP * number.usual.1;
            let mut moved = theta.to_vec();
            moved[place] += step;
            let beside = match number.artefact {
                Artefact::Delay => self.forces(run, &moved, segment),
                _ => {
                    let mut beside = pure.clone();
                    self.read(&there, &moved, &mut beside);
                    beside
                }
            };
            for (k, (there, here)) in beside.iter().zip(&forces).enumerate() {
                all[(place, k)] = (there - here) / step;
            }
        }
        (forces, all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rig_number::RigNumber;
    use crate::sensitivity::Accuracy;
    use crate::unknowns::{CurveName, Unknown};
    use dashpot_core::number;
    use dashpot_core::parameter::Element;
    use dashpot_core::{Input, Params};

    fn segment(clock: f64) -> Segment {
        let (n, h, omega) = (400, 1e-3, 31.0);
        let at = |k: usize| omega * h * k as f64 + 0.2;
        Segment {
            name: String::new(),
            dt: (0..n).map(|k| if k == 0 { 0.0 } else { h }).collect(),
            input: (0..n).map(|k| Input::motion(0.01 * libm::sin(at(k)), 0.01 * omega * libm::cos(at(k)))).collect(),
            force: vec![0.0; n],
            from: 60,
            scale: 1.0,
            top: 1000.0,
            peak_velocity: 0.31,
            amplitude: 0.01,
            clock,
        }
    }

    fn everything() -> Unknowns {
        let mut base = Params::new();
        for element in ["fv_curve", "series_compliance", "gas_preload", "parallel_spring"] {
            base.enable(Element::find(element).unwrap(), true);
        }
        base.set(number!("spring_quadratic"), 4e4).unwrap();
        let mut list = Unknowns::rises(&base, CurveName::Fv);
        list.extend([
            Unknown::Log(number!("series_stiffness")),
            Unknown::Linear(number!("gas_force")),
            Unknown::Linear(number!("spring_quadratic")),
        ]);
        let number = |artefact, start, spread| RigNumber { artefact, start, usual: (0.0, spread) };
        let rig = vec![
            number(Artefact::Delay, 1.3e-3, 1e-3),
            number(Artefact::Mass, 1.5, 1.0),
            number(Artefact::GainDrift, 1e-5, 1e-4),
            number(Artefact::Drift, 0.01, 0.1),
        ];
        Unknowns { base, list, rig }
    }

    #[test]
    fn derivatives_over_numbers_of_damper_and_rig_are_those_of_differences() {
        let unknowns = everything();
        let theta = unknowns.start();
        let segment = segment(700.0);
        let run = |theta: &[f64]| Run::new(&unknowns, theta, Accuracy::Full).unwrap();
        let (forces, rows) = unknowns.jacobian(&run(&theta), &theta, &segment);
        assert_eq!(forces, unknowns.forces(&run(&theta), &theta, &segment));
        let (low, high) = unknowns.bounds();
        for k in 0..theta.len() {
            let step = 1e-4 * if k < unknowns.list.len() { theta[k].abs().max(1.0) } else { high[k] - low[k] };
            let at = |sign: f64| {
                let mut moved = theta.clone();
                moved[k] += sign * step;
                unknowns.forces(&run(&moved), &moved, &segment)
            };
            let (up, down) = (at(1.0), at(-1.0));
            let wanted: Vec<f64> = (60..400).map(|i| (up[i] - down[i]) / (2.0 * step)).collect();
            let size = wanted.iter().map(|w| w * w).sum::<f64>().sqrt();
            let off = wanted.iter().zip(60..).map(|(w, i)| (w - rows[(k, i)]).powi(2)).sum::<f64>().sqrt();
            assert!(off < 0.02 * size + 1e-9, "{k}: {off} of {size}");
        }
    }

    #[test]
    fn a_late_force_is_that_of_the_motion_before() {
        let mut unknowns = everything();
        unknowns.rig.truncate(1);
        let segment = segment(0.0);
        let on_time = Unknowns { rig: Vec::new(), ..unknowns.clone() };
        let of = |unknowns: &Unknowns, late: f64| {
            let mut theta = on_time.start();
            theta.extend((!unknowns.rig.is_empty()).then_some(late));
            let run = Run::new(unknowns, &theta, Accuracy::Full).unwrap();
            unknowns.forces(&run, &theta, &segment)
        };
        let (early, late) = (of(&on_time, 0.0), of(&unknowns, 4e-3));
        for k in 120..400 {
            assert!((late[k] - early[k - 4]).abs() < 1.0, "{k}: {} {}", late[k], early[k - 4]);
        }
    }
}
