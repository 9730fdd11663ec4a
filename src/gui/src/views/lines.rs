//! The lines of the loop plots. They are thinned for the screen, and recomputed only after a change.

use crate::session::Session;
use crate::session::dampers::TestDamper;
use crate::session::simulation::OfTest;
use crate::session::two_ways::two_ways;
use crate::units::Units;
use crate::words::Words;
use dashpot_core::Model;
use dashpot_core::parameter::Element;
use dashpot_identification::setting_units::is_of_axis;
use dashpot_records::smoothing::Motion;
use dashpot_records::{Record, setting_factor, setting_in_words};
use dashpot_simulation::prediction::predict;
use egui_plot::PlotPoint;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Source of a line's forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Whose {
    /// Measurement on the rig.
    Measured,
    /// The corresponding test of the reference campaign.
    Reference,
    /// The identified model, if the user has tuned the model since.
    Identified,
    /// The model on screen.
    Model,
    /// The model with an additional effect.
    Effect,
}

/// The points of one test or model, for each of the plots.
pub struct Line {
    /// Source of the forces.
    pub whose: Whose,
    /// Index of the test among the selected tests, which determines the hue.
    pub place: usize,
    /// Name that the cursor shows.
    pub name: String,
    /// Force over velocity. All quantities are in the selected units.
    pub velocity: Vec<PlotPoint>,
    /// Force over displacement.
    pub displacement: Vec<PlotPoint>,
    /// Force over time, s.
    pub time: Vec<PlotPoint>,
    /// Mean force of both directions over displacement: gas and springs.
    pub gas: Vec<PlotPoint>,
    /// Half the difference of both directions: seal drag and friction.
    pub drag: Vec<PlotPoint>,
    /// Temperature over time, s and °C, if measured.
    pub temperature: Vec<PlotPoint>,
}

/// Inputs from which the lines were computed.
#[derive(PartialEq, Clone, Default)]
struct Key {
    generation: u64,
    selected: BTreeSet<usize>,
    effect: Option<(Element, u64)>,
    language: usize,
    units: Units,
}

/// The cached lines.
#[derive(Default)]
pub struct Cache {
    key: Option<Key>,
    /// Lines in drawing order.
    pub lines: Arc<Vec<Line>>,
}

/// Number of points to which all lines together are thinned, so that a frame is drawn quickly. The limit of a line follows from three lines
/// for each selected test.
const POINTS: usize = 24_000;
/// Upper bound of the limit of points of a line, for few selected tests.
const MOST: usize = 600;
/// Lower bound of the limit of points of a line, for many selected tests.
const LEAST: usize = 60;
/// Largest number of tests for which the loop with an additional effect is drawn. The loops are computed within a frame, and each takes a
/// millisecond.
const EFFECTS: usize = 6;

impl Cache {
    /// Returns the lines for the current state of the session. Computes them only after a change.
    pub fn lines(
        &mut self,
        session: &Session,
        effect: Option<(Element, f64)>,
        units: Units,
        words: &Words,
    ) -> Arc<Vec<Line>> {
        let key = Key {
            generation: session.generation,
            selected: session.selected.clone(),
            effect: effect.map(|(element, strength)| (element, strength.to_bits())),
            language: std::ptr::from_ref(words) as usize,
            units,
        };
        if self.key.as_ref() != Some(&key) {
            self.lines = Arc::new(make(session, effect, units, words));
            self.key = Some(key);
        }
        self.lines.clone()
    }
}

fn make(session: &Session, effect: Option<(Element, f64)>, units: Units, words: &Words) -> Vec<Line> {
    let Some(loaded) = &session.campaign else { return Vec::new() };
    let tests: Vec<usize> = session.selected.iter().copied().filter(|k| *k < loaded.tests.len()).collect();
    let most = (POINTS / (3 * tests.len().max(1))).clamp(LEAST, MOST);
    let mut lines = Vec::new();
    for (place, test) in tests.iter().enumerate() {
        let (record, seen) = (&loaded.campaign.records[*test], &loaded.tests[*test]);
        let at = at_setting(session, record, words);
        let over = |whose: Whose, force: &[f64], stride: usize| {
            let at = if whose == Whose::Measured { "" } else { at.as_str() };
            line(
                whose,
                place,
                format!("{} · {}{at}", record.name, named(whose, session, words)),
                record,
                seen,
                (force, stride),
                most,
                units,
            )
        };
        let simulated = |of: &Option<Arc<crate::session::simulation::Simulated>>| {
            of.as_ref().and_then(|s| s.tests.get(*test)).map(|t| (t.shown.clone(), t.stride))
        };
        lines.push(over(Whose::Measured, &record.force[seen.shown.clone()], 1));
        if let Some(other) = &session.reference
            && let Some(k) = other.like(record)
        {
            let (record, seen) = (&other.campaign.records[k], &other.tests[k]);
            let name = format!("{} · {}", record.name, words.reference);
            let force = (&record.force[seen.shown.clone()], 1);
            lines.push(line(Whose::Reference, place, name, record, seen, force, most, units));
        }
        if session.model.as_ref().is_some_and(crate::session::model::Tuned::is_tuned) {
            lines.extend(simulated(&session.identified).map(|(f, stride)| over(Whose::Identified, &f, stride)));
        }
        if session.model.is_some() {
            lines.extend(simulated(&session.simulated).map(|(f, stride)| over(Whose::Model, &f, stride)));
        }
        let with = effect
            .filter(|_| place < EFFECTS)
            .and_then(|(element, strength)| session.with_effect(record, element, strength));
        if let Some((params, model)) = with.and_then(|p| Some((p, Model::new(&p).ok()?))) {
            let rise = loaded.warm.rise(&params, *test);
            let along = |record: &Record, motion: &Motion| predict(&model, record, motion, rise);
            let of = OfTest::simulate(along, record, seen, true);
            lines.push(over(Whose::Effect, &of.shown, of.stride));
        }
    }
    // Sort the lines so that models are drawn over measurements.
    lines.sort_by_key(|l| l.whose as usize);
    lines
}

/// Formats a suffix for the name of a simulated line. It states the test's own setting at which the model is simulated.
///
/// If the parameter values on screen are simulated instead, the suffix states that the test's setting changes or belongs to another damper.
/// Otherwise the suffix is empty.
fn at_setting(session: &Session, record: &Record, words: &Words) -> String {
    let Some(dampers) = session.dampers() else { return String::new() };
    let axis = session.model.as_ref().and_then(|model| Some(model.over_setting()?.0));
    let unit = axis.map_or("", |axis| axis.unit());
    match dampers.of_test(record) {
        TestDamper::AtSetting(value) => format!(" ({})", format!("{} {unit}", words.typed(value)).trim_end()),
        TestDamper::Shown if record.setting_signal.is_some() => format!(" ({})", words.setting_changes),
        TestDamper::Shown => match (&record.setting, axis) {
            (Some(of), Some(axis)) if !is_of_axis(axis, &of.name) || setting_factor(&of.unit, unit).is_none() => {
                let own = setting_in_words(of.value, &of.unit);
                format!(" ({})", words.fill(words.setting_of_another, &[("setting", &own)]))
            }
            _ => String::new(),
        },
        TestDamper::Changing => String::new(),
    }
}

/// Returns the displayed name of the model before it was tuned. Only a fit makes an identified model.
pub fn identified_name(session: &Session, words: &Words) -> &'static str {
    let is_of_a_fit = session.model.as_ref().is_none_or(crate::session::model::Tuned::is_of_a_fit);
    if is_of_a_fit { words.identified_model } else { words.opened_model }
}

/// Returns the displayed name of a source.
pub fn named(whose: Whose, session: &Session, words: &Words) -> &'static str {
    match whose {
        Whose::Measured => words.measured,
        Whose::Reference => words.reference,
        Whose::Identified => identified_name(session, words),
        Whose::Model => words.model,
        Whose::Effect => words.with_effect,
    }
}

#[allow(clippy::too_many_arguments)] // each is a distinct quantity
fn line(
    whose: Whose,
    place: usize,
    name: String,
    record: &dashpot_records::Record,
    seen: &crate::session::campaign::Seen,
    (force, stride): (&[f64], usize),
    most: usize,
    units: Units,
) -> Line {
    let [f, v, x] = [units.force(), units.velocity(), units.length()].map(|shown| shown.factor);
    let from = seen.shown.start;
    // The index of `force` counts decimated samples. The index of the motion counts all samples of the record.
    let n = seen.shown.len().div_ceil(stride).min(force.len());
    let at = |i: usize| from + i * stride;
    let step = n.div_ceil(most).max(1);
    let mut kept: Vec<usize> = (0..n).step_by(step).collect();
    // Close the loop.
    if !record.cycles.is_empty() && n > 0 {
        kept.push(0);
    }
    let start = record.time.get(from).copied().unwrap_or(0.0);
    let points =
        |across: &dyn Fn(usize) -> f64| kept.iter().map(|i| PlotPoint::new(across(*i), f * force[*i])).collect();
    let motion = |channel: &[f64]| -> Vec<f64> { (0..n).map(|i| channel[at(i)]).collect() };
    let places = two_ways(&motion(&seen.motion.displacement), &motion(&seen.motion.velocity), &force[..n]);
    let in_time: Vec<usize> = (0..n).step_by(step).collect();
    Line {
        whose,
        place,
        name,
        velocity: points(&|i| v * seen.motion.velocity[at(i)]),
        displacement: points(&|i| x * seen.motion.displacement[at(i)]),
        time: in_time.iter().map(|i| PlotPoint::new(record.time[at(*i)] - start, f * force[*i])).collect(),
        gas: places.iter().map(|p| PlotPoint::new(x * p.at, f * p.mean)).collect(),
        drag: places.iter().map(|p| PlotPoint::new(x * p.at, f * 0.5 * p.difference)).collect(),
        temperature: match (&record.temperature, whose) {
            (Some(temperature), Whose::Measured) => {
                let all = 0..record.time.len();
                all.step_by(record.time.len().div_ceil(most).max(1))
                    .map(|i| PlotPoint::new(record.time[i], temperature[i]))
                    .collect()
            }
            _ => Vec::new(),
        },
    }
}
