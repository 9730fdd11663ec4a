//! Identified parameters of a model file with their intervals.

use crate::uncertain::Uncertain;
use dashpot_core::parameter::Number;
use dashpot_core::{element, list, number};
use dashpot_identification::model_file::{Interval, ModelFile};

/// Status of a parameter in a model file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Standing {
    /// The element of the parameter is off.
    Off,
    /// The records do not determine the parameter, or the file does not state it.
    Open,
    /// The parameter has an interval. A stated parameter without an interval counts as exact.
    Known(Uncertain),
}

/// Model file whose parameters are read together with their intervals.
pub(super) struct Identified<'a>(pub &'a ModelFile);

impl Identified<'_> {
    /// Returns the status of a parameter.
    pub fn number(&self, number: Number) -> Standing {
        let Identified(file) = self;
        if number.row().element().is_some_and(|element| !file.params.is_on(element)) {
            return Standing::Off;
        }
        let value = file.params.number(number);
        let is_stated = file.specified.contains(&number.row().index);
        match file.identification.intervals.get(number.name()) {
            _ if file.identification.not_identified.iter().any(|name| name == number.name()) => Standing::Open,
            Some(Interval::Number([low, high])) if low.is_finite() && high.is_finite() => {
                Standing::Known(Uncertain { value, low: low.min(value), high: high.max(value) })
            }
            _ if is_stated => Standing::Known(Uncertain::within(value, 0.0)),
            _ => Standing::Open,
        }
    }

    /// Returns whether the fit of the model had a prior from the dimensions for a parameter, according to its notes.
    pub fn had_prior(&self, name: &str) -> bool {
        let said = [format!("{name} was expected at"), format!("{name} contradicts the dimensions")];
        // The notes of an adjustable damper begin with the setting and a colon.
        let is_said = |note: &str, said: &str| note.starts_with(said) || note.contains(&format!(": {said}"));
        self.0.identification.notes.iter().any(|note| said.iter().any(|said| is_said(note, said)))
    }

    /// Returns the element of a parameter with its probability as text, if the fit found it less probable than not.
    pub fn doubtful_effect(&self, name: &str) -> Option<(&'static str, String)> {
        let element = Number::find(name).ok()?.row().element()?.name();
        let is_own =
            |note: &&String| note.starts_with(&format!("{element}:")) || note.starts_with(&format!("{element} ("));
        let (_, text) = self.0.identification.notes.iter().find(is_own)?.rsplit_once("; probability ")?;
        let percent: f64 = text.trim_end_matches('%').trim().parse().ok()?;
        (percent < 50.0).then(|| (element, text.to_owned()))
    }

    /// Returns whether the FV curve of the model is a table.
    pub fn has_table(&self) -> bool {
        self.0.params.is_on(element!("fv_curve")) && self.0.params.number(number!("fv_form")) == 0.0
    }

    /// Returns speeds, m/s, and forces, N, of one stroke, slowest first. `stroke` is 1 for rebound and −1 for
    /// compression. Speeds and forces are positive, and the force at zero velocity is subtracted. Points whose force
    /// has the wrong sign are omitted.
    pub fn branch(&self, stroke: f64) -> Vec<(f64, Uncertain)> {
        let Identified(file) = self;
        let (velocities, forces) = (file.params.list(list!("fv_velocity")), file.params.list(list!("fv_force")));
        let ends = match file.identification.intervals.get("fv_force") {
            Some(Interval::List(ends)) if ends.len() == forces.len() => ends.as_slice(),
            _ => &[],
        };
        let still = at_standstill(velocities, forces);
        let mut points: Vec<(f64, Uncertain)> = velocities
            .iter()
            .zip(forces)
            .enumerate()
            .filter(|(_, (velocity, force))| **velocity * stroke > 0.0 && (**force - still) * stroke > 0.0)
            .map(|(k, (velocity, force))| {
                let value = (force - still).abs();
                let half = |end: f64| if end.is_finite() { (end - force).abs() } else { 0.0 };
                let [low, high] = ends.get(k).map_or([0.0; 2], |[low, high]| {
                    if stroke > 0.0 { [half(*low), half(*high)] } else { [half(*high), half(*low)] }
                });
                // If the interval of a point reaches zero, its lower end is replaced by the fraction [`SMALLEST`] of
                // the force.
                let low = (value - low).max(SMALLEST * value);
                (velocity.abs(), Uncertain { value, low, high: value + high })
            })
            .collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points
    }
}

/// Smallest lower end of a point's interval, as a fraction of the point's force.
const SMALLEST: f64 = 0.05;

/// Interpolates the force of an FV table, N, at zero velocity.
fn at_standstill(velocities: &[f64], forces: &[f64]) -> f64 {
    let right = velocities.partition_point(|v| *v < 0.0);
    match (right.checked_sub(1), velocities.get(right)) {
        (_, Some(0.0)) | (None, Some(_)) => forces[right],
        (Some(left), Some(v)) => {
            let part = -velocities[left] / (v - velocities[left]);
            forces[left] + part * (forces[right] - forces[left])
        }
        (_, None) => forces.last().copied().unwrap_or(0.0),
    }
}
