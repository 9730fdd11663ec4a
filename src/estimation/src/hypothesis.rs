//! A hypothesis about the records: a model with free parameters, measurement errors, and priors of both.

use super::bleed::prior_rise;
use super::heating::Heating;
use super::measurement::{Artefact, earlier, finer, low_pass};
use super::samples::Test;
use crate::curve_part::CurvePart;
use crate::prior_set::PriorSet;
use crate::priors::in_search;
use crate::scale::Scale;
use crate::segment::Segment;
use crate::sensitivity::{Accuracy, Run, forces};
use crate::unknowns::{Unknown, Unknowns};
use dashpot_core::number;
use dashpot_core::{Model, Parameter, Params};
use dashpot_records::restrict;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use std::borrow::Cow;

/// Number of simulation steps per sample if the force channel is filtered. One step per sample is too coarse, because
/// friction can reverse within a sample.
const PARTS: usize = 3;

/// Kind of a free parameter of a hypothesis.
#[derive(Debug, Clone, PartialEq)]
pub enum Free {
    /// A parameter of the model.
    Model(Unknown),
    /// Difference of a parameter of the model from its value in the base, in the search coordinate of the unknown (for
    /// example its logarithm).
    Shift(Unknown),
    /// Relative change of a part of the FV curve of the base.
    Curve(CurvePart),
    /// The magnitude of a measurement error of the rig.
    Rig(Artefact),
    /// Logarithm of the cooling rate, 1/s: heat transfer to the surroundings over heat capacity.
    Cooling,
    /// Logarithm of the heat capacity, J/K.
    HeatCapacity,
}

/// A free parameter with its prior.
#[derive(Debug, Clone)]
pub struct Number {
    /// Quantity of the model or of the rig that is free.
    pub free: Free,
    /// Start value, in the search coordinate of the parameter (for example its logarithm).
    pub start: f64,
    /// Typical size of a change of the parameter in a search, in the search coordinate.
    pub step: f64,
    /// Lowest and highest value, in the search coordinate.
    pub bounds: (f64, f64),
    /// Mean and standard deviation of the prior, in the search coordinate, if there is one.
    pub prior: Option<(f64, f64)>,
}

/// A model with free parameters, and the measurement errors of the rig.
#[derive(Debug, Clone)]
pub struct Hypothesis {
    /// Parameter set of the model, in which the values of the free parameters replace those of the set.
    pub base: Params,
    /// Free parameters.
    pub numbers: Vec<Number>,
    /// Heat input of the damper, if its heating is computed.
    pub heating: Option<std::sync::Arc<Heating>>,
    /// Priors of this damper. They replace the priors of all dampers.
    pub priors: PriorSet,
}

/// Weighted residuals of all tests, concatenated: measured minus computed, divided by the allowed error.
pub type Residual = DVector<f64>;

impl Hypothesis {
    /// Computes the ends of the 95 % interval of the parameter with the index `place`, in its search coordinate.
    /// `deviation` is the standard deviation of `value`. The ends are within the bounds of the parameter: a loss
    /// factor, for example, is never negative.
    pub fn interval(&self, place: usize, value: f64, deviation: f64) -> [f64; 2] {
        /// Half-width of a 95 % interval in standard deviations.
        const Z: f64 = 1.96;
        let (low, high) = self.numbers[place].bounds;
        [-Z, Z].map(|z| restrict(value + z * deviation, low, high))
    }

    /// Returns the index of a parameter in the vector, if it is free.
    pub fn position(&self, free: &Free) -> Option<usize> {
        self.numbers.iter().position(|n| n.free == *free)
    }

    /// Returns the start values of the free parameters.
    pub fn start(&self) -> Vec<f64> {
        self.numbers.iter().map(|n| n.start).collect()
    }

    /// Returns the hypothesis with the priors of this damper.
    pub fn with_priors(mut self, priors: &PriorSet) -> Hypothesis {
        self.priors = priors.clone();
        let numbers = std::mem::take(&mut self.numbers);
        self.numbers = numbers.into_iter().map(|number| self.with_own_prior(number)).collect();
        self
    }

    /// Returns a free parameter with the prior of this damper, if there is such a prior.
    pub fn with_own_prior(&self, mut number: Number) -> Number {
        if let Free::Model(unknown) = &number.free {
            number.prior = self.priors.in_search(unknown).or(number.prior);
        }
        number
    }

    /// Returns the hypothesis with the start values `theta`.
    pub fn starting_at(mut self, theta: &[f64]) -> Hypothesis {
        for (number, value) in self.numbers.iter_mut().zip(theta) {
            number.start = *value;
        }
        self
    }

    fn unknowns(&self, theta: &[f64]) -> (Unknowns, Vec<f64>, Vec<usize>) {
        let (mut list, mut values, mut places) = (Vec::new(), Vec::new(), Vec::new());
        for (place, (number, value)) in self.numbers.iter().zip(theta).enumerate() {
            match &number.free {
                Free::Model(_) => values.push(*value),
                Free::Shift(unknown) => {
                    let own = Unknowns { base: self.base, list: vec![*unknown] };
                    values.push(own.start()[0] + value);
                }
                _ => continue,
            }
            let (Free::Model(unknown) | Free::Shift(unknown)) = &number.free else { continue };
            list.push(*unknown);
            places.push(place);
        }
        (Unknowns { base: self.base, list }, values, places)
    }

    /// Returns the parameter set for the values `theta` of the free parameters, without the measurement errors.
    pub fn params(&self, theta: &[f64]) -> Params {
        let (unknowns, values, _) = self.unknowns(theta);
        let mut params = unknowns.params(&values);
        for (number, value) in self.numbers.iter().zip(theta) {
            if let Free::Curve(part) = number.free {
                part.scale(&mut params, *value);
            }
        }
        if let Some(capacity) = self.exponential(&Free::HeatCapacity, theta) {
            let _ = params.set(number!("heat_capacity"), capacity);
        }
        if let Some(cooling) = self.exponential(&Free::Cooling, theta) {
            let _ = params.set(number!("heat_transfer"), cooling * params.number(number!("heat_capacity")));
        }
        params
    }

    /// Returns the value of a parameter whose logarithm is free, or `None` if this logarithm is not free.
    fn exponential(&self, free: &Free, theta: &[f64]) -> Option<f64> {
        self.position(free).map(|place| libm::exp(theta[place]))
    }

    /// Returns the value of a rig parameter, or `None` if it is not free.
    fn of_the_rig(&self, artefact: Artefact, theta: &[f64]) -> Option<f64> {
        self.position(&Free::Rig(artefact)).map(|place| theta[place])
    }

    /// Returns the segment with the motion shifted by the delay of the force channel, if this delay is a free
    /// parameter.
    fn delayed<'a>(&self, test: &'a Test, theta: &[f64]) -> Cow<'a, Segment> {
        match self.of_the_rig(Artefact::Delay, theta) {
            Some(tau) => Cow::Owned(earlier(&test.segment, tau)),
            None => Cow::Borrowed(&test.segment),
        }
    }

    /// Returns the test's segment with the inputs that caused the measured forces.
    ///
    /// The inputs precede the force samples by the delay of the force channel. The temperatures include self-heating if
    /// `place` is the index of the test. If the force channel has a low-pass filter, each time step is divided into
    /// [`PARTS`].
    fn gone_through<'a>(&self, test: &'a Test, place: Option<usize>, theta: &[f64]) -> Cow<'a, Segment> {
        let mut segment = self.delayed(test, theta);
        let free = |free| self.exponential(&free, theta);
        if let (Some(heating), Some(place), Some(cooling), Some(capacity)) =
            (&self.heating, place, free(Free::Cooling), free(Free::HeatCapacity))
        {
            let rise = heating.rise(place, cooling) / capacity;
            for input in &mut segment.to_mut().input {
                input.temperature += rise;
            }
        }
        if self.of_the_rig(Artefact::LowPass, theta).is_some() {
            segment = Cow::Owned(finer(&segment, PARTS));
        }
        segment
    }

    /// Sets the model to use the temperature of its input if heating is computed from the records, so that heat does
    /// not count twice.
    fn take_heat_as_measured(&self, params: &mut Params) {
        if self.heating.is_some() {
            let _ = params.set(number!("fade_source"), 0.0);
        }
    }

    /// Makes the model for the comparison with the records. Returns `None` if the parameters are not a valid model.
    fn model(&self, theta: &[f64]) -> Option<Model> {
        let mut params = self.params(theta);
        self.take_heat_as_measured(&mut params);
        Model::new(&params).ok()
    }

    /// Makes the model with an integration of the given accuracy. Returns `None` if the parameters are not a valid
    /// model.
    pub fn model_by(&self, accuracy: Accuracy, theta: &[f64]) -> Option<Model> {
        let model = self.model(theta)?;
        Some(model.with_integration(accuracy.integration(&self.base, &model)))
    }

    /// Applies the low-pass filter of the force channel, if there is one, and retains only the values at the samples.
    ///
    /// `values` may be forces or their derivatives.
    fn filtered(&self, segment: &Segment, theta: &[f64], values: &mut Vec<f64>) {
        if let Some(tau) = self.of_the_rig(Artefact::LowPass, theta) {
            low_pass(tau, &segment.dt, values);
            *values = values.iter().step_by(PARTS).copied().collect();
        }
    }

    /// Adds the measurement errors to the forces, N, in their order along the force channel. A mass between damper and
    /// load cell is first, then load cell and amplifier. The delay of the channel applies to all of them.
    fn adjust(&self, test: &Test, theta: &[f64], forces: &mut [f64]) {
        let of_number = |(number, value): (&Number, &f64)| match number.free {
            Free::Rig(artefact) => Some((artefact, *value)),
            _ => None,
        };
        let mut faults: Vec<(Artefact, f64)> = self.numbers.iter().zip(theta).filter_map(of_number).collect();
        if faults.is_empty() {
            return;
        }
        faults.sort_by_key(|(artefact, _)| artefact.position_in_channel());
        let segment = self.delayed(test, theta);
        for (artefact, value) in faults {
            artefact.apply(value, &segment, forces);
        }
    }

    /// Computes the forces of one test at its scored samples, N. `place` is the index of the test, if its heating is
    /// known.
    fn forces_of(&self, model: &Model, test: &Test, place: Option<usize>, theta: &[f64]) -> Vec<f64> {
        self.measured_forces(test, place, theta, &|segment| forces(model, segment))
    }

    /// Computes the forces that the rig measures at the scored samples of one test, N. `run` computes the forces of the
    /// damper along a segment.
    pub fn measured_forces(
        &self,
        test: &Test,
        place: Option<usize>,
        theta: &[f64],
        run: &dyn Fn(&Segment) -> Vec<f64>,
    ) -> Vec<f64> {
        let segment = self.gone_through(test, place, theta);
        let mut all = run(&segment);
        self.filtered(&segment, theta, &mut all);
        self.adjust(test, theta, &mut all);
        all.split_off(test.segment.from)
    }

    /// Computes the forces of a prepared model in an arbitrary test, N, with the measurement errors but without
    /// self-heating.
    pub fn forces_with(&self, model: &Model, test: &Test, theta: &[f64]) -> Vec<f64> {
        self.forces_of(model, test, None, theta)
    }

    /// Computes forces at the scored samples of all tests, N, with the model's own integration. Returns `None` if the
    /// parameters are not a valid model, or if a force is not finite.
    pub fn forces(&self, tests: &[Test], theta: &[f64]) -> Option<Vec<Vec<f64>>> {
        self.forces_by(&self.model(theta)?, tests, theta)
    }

    /// Computes the forces of a prepared model at the scored samples of all tests, N. Returns `None` if a force is not
    /// finite.
    pub fn forces_by(&self, model: &Model, tests: &[Test], theta: &[f64]) -> Option<Vec<Vec<f64>>> {
        let all: Vec<Vec<f64>> =
            tests.par_iter().enumerate().map(|(k, test)| self.forces_of(model, test, Some(k), theta)).collect();
        all.iter().flatten().all(|f| f.is_finite()).then_some(all)
    }

    /// Computes the weighted residuals of all tests with the accuracy [`Accuracy::Single`], which suffices for a
    /// search. Returns `None` if the parameters are not a valid model, or if a force is not finite.
    pub fn residual(&self, tests: &[Test], theta: &[f64]) -> Option<Residual> {
        self.residual_by(Accuracy::Single, tests, theta)
    }

    /// Computes the weighted residuals with an integration of the given accuracy. Returns `None` if the parameters are
    /// not a valid model, or if a force is not finite.
    pub fn residual_by(&self, accuracy: Accuracy, tests: &[Test], theta: &[f64]) -> Option<Residual> {
        let all = self.forces_by(&self.model_by(accuracy, theta)?, tests, theta)?;
        let list: Vec<f64> = tests
            .iter()
            .zip(&all)
            .flat_map(|(test, forces)| {
                test.forces().iter().zip(forces).zip(&test.allowed).map(|((m, f), a)| (m - f) / a)
            })
            .collect();
        Some(DVector::from_vec(list))
    }

    /// Computes derivatives of the forces with respect to the free parameters, divided by the allowed errors. The
    /// matrix has one row per scored sample and one column per free parameter. Returns `None` if the parameters are not
    /// a valid model, or if a force is not finite.
    ///
    /// A prepared [`Run`] gives the derivatives for all parameters of the model. Each other parameter, such as a
    /// measurement error or the cooling rate, requires a finite difference. A low-accuracy integration suffices if
    /// errors of a few tenths of a percent are acceptable.
    pub fn jacobian(&self, accuracy: Accuracy, tests: &[Test], theta: &[f64]) -> Option<DMatrix<f64>> {
        let rows = tests.iter().map(Test::count).sum();
        let mut matrix = DMatrix::zeros(rows, self.numbers.len());
        let (mut unknowns, values, places) = self.unknowns(theta);
        self.take_heat_as_measured(&mut unknowns.base);
        let is_filtered = self.of_the_rig(Artefact::LowPass, theta).is_some();
        let run = Run::new(&unknowns, &values, accuracy)?;
        let parts: Vec<DMatrix<f64>> = tests
            .par_iter()
            .enumerate()
            .map(|(place, test)| {
                let segment = self.gone_through(test, Some(place), theta);
                let (_, rows) = run.jacobian(&segment, &unknowns, &values);
                let mut columns = rows.transpose();
                if is_filtered {
                    // The filter also applies to the derivatives of the force.
                    let mut at_samples = DMatrix::zeros(test.segment.input.len(), columns.ncols());
                    for (mut to, from) in at_samples.column_iter_mut().zip(columns.column_iter()) {
                        let mut along = from.as_slice().to_vec();
                        self.filtered(&segment, theta, &mut along);
                        to.copy_from_slice(&along);
                    }
                    columns = at_samples;
                }
                for (mut row, allowed) in columns.row_iter_mut().skip(test.segment.from).zip(&test.allowed) {
                    row /= *allowed;
                }
                columns.rows(test.segment.from, test.count()).into_owned()
            })
            .collect();
        let mut row = 0;
        for part in &parts {
            for (k, place) in places.iter().enumerate() {
                matrix.view_mut((row, *place), (part.nrows(), 1)).copy_from(&part.column(k));
            }
            row += part.nrows();
        }
        if places.len() < self.numbers.len() {
            let residual = |theta: &[f64]| self.residual_by(accuracy, tests, theta);
            let at = residual(theta)?;
            for place in (0..self.numbers.len()).filter(|place| !places.contains(place)) {
                matrix.set_column(place, &self.column(theta, &at, place, residual)?);
            }
        }
        Some(matrix)
    }

    /// Computes the derivative of the weighted forces with respect to the parameter with the index `place`. The
    /// derivative is a finite difference of `residual`, relative to its value `at` the parameters `theta`. Returns
    /// `None` if `residual` does.
    pub fn column(
        &self,
        theta: &[f64],
        at: &Residual,
        place: usize,
        residual: impl Fn(&[f64]) -> Option<Residual>,
    ) -> Option<DVector<f64>> {
        let number = &self.numbers[place];
        let (low, high) = number.bounds;
        let mut step = 1e-3 * number.step;
        let mut moved = theta.to_vec();
        if moved[place] + step > high
            || (low..=high).contains(&(moved[place] - step)) && moved[place] > 0.5 * (low + high)
        {
            step = -step;
        }
        moved[place] += step;
        Some((at - residual(&moved)?) / step)
    }
}

/// Makes a free parameter of the model, with a start from a parameter set and the prior of all dampers.
pub fn number(base: &Params, unknown: Unknown) -> Number {
    let one = Unknowns { base: *base, list: vec![unknown] };
    let start = one.start()[0];
    let (low, high) = one.bounds();
    let scale = Scale::from_params(base);
    let by_default = |parameter: &Parameter, factor: f64| {
        let typical = factor * parameter.default.first().map_or(1.0, |d| d.abs());
        (0.3 * start.abs()).max(0.1 * typical).max(1e-3 * factor)
    };
    let step = match &unknown {
        Unknown::Log(_) | Unknown::Above(..) => 0.3,
        Unknown::Rise { .. } => start.abs().max(10.0 * scale.force()),
        Unknown::Linear(number) => by_default(number.parameter(), scale.of_number(*number)),
        Unknown::Entry(list, _) => by_default(list.parameter(), 1.0),
    };
    let bounds = (low[0], high[0]);
    let start = restrict(start, bounds.0, bounds.1);
    let prior = in_search(&unknown, scale).or_else(|| Some((0.0, prior_rise(base, &unknown)?)));
    Number { free: Free::Model(unknown), start, step, bounds, prior }
}
