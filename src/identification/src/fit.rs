//! Fit of a model to records, with all its stages.

use super::expected::describe_priors;
use super::intervals::{Estimate, Standing, estimates};
use super::literature::piecewise_linear::COEFFICIENTS_AND_KNEES;
use super::literature::{Literature, LiteratureError, fv_curve, observation::observations};
use super::of_the_rig::{self, Measured};
use super::phrases;
use super::rare_values::describe_rare;
use dashpot_core::parameter::{Element, Number, names};
use dashpot_core::{Model, Params};
use dashpot_core::{element, list, number};
use dashpot_estimation::campaign_clock::{clock_from, clock_runs_on};
use dashpot_estimation::first_guess::SLOW;
use dashpot_estimation::heating::Heating;
use dashpot_estimation::hypothesis::{Free, Hypothesis, Number as FreeNumber, number as free_number};
use dashpot_estimation::measurement::Artefact;
use dashpot_estimation::prior_set::PriorSet;
use dashpot_estimation::refit::{self, Refit, refit};
use dashpot_estimation::samples::road::{Shortened, shortened};
use dashpot_estimation::samples::selection::select;
use dashpot_estimation::samples::{self, Test, segments};
use dashpot_estimation::scale::Scale;
use dashpot_estimation::segment::Segment;
use dashpot_estimation::sensitivity::{self, Accuracy};
use dashpot_estimation::situation::Situation;
use dashpot_estimation::step_at_rest::has_dry_friction;
use dashpot_estimation::structure::alternatives::{Alternative, alternatives};
use dashpot_estimation::structure::component::Component;
use dashpot_estimation::structure::context::{SearchContext, Structure};
use dashpot_estimation::structure::inventory::{InventoryItem, inventory};
use dashpot_estimation::structure::search::{StructureSearch, Temperatures};
use dashpot_estimation::structure::starts;
use dashpot_estimation::unknowns::{CurveName, Unknown, Unknowns};
use dashpot_estimation::vocabulary::Candidate;
use dashpot_estimation::warmth::temperatures;
use dashpot_messages::{Sentence, Template};
use dashpot_records::measurement_correction::MeasurementError;
use dashpot_records::{Record, round_figure};
use std::sync::Arc;

/// Kind of model to fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Family {
    /// The model of the thesis (Jonnalagadda & Vyas 2020) with further elements.
    #[default]
    Thesis,
    /// The plain FV curve with a constant gas force, which vehicle models use today.
    Fv,
    /// Piecewise-linear FV curve with a constant gas force.
    Piecewise,
    /// Polynomial FV curve with a first-order lag.
    Lag,
}

/// Element of the polynomial with lag. It excludes all other elements.
const LAG: Element = element!("lagged_polynomial");

/// Options of a fit.
#[derive(Debug, Clone, Default)]
pub struct FitOptions {
    /// Kind of model.
    pub family: Family,
    /// Elements that the fit may use. With `None`, the fit uses all typical elements of dampers.
    pub elements: Option<Vec<String>>,
    /// Prior knowledge of this damper, in addition to its records.
    pub priors: PriorSet,
}

impl FitOptions {
    /// Returns whether the fit may use an element.
    fn allows(&self, element: &str) -> bool {
        self.elements.as_ref().is_none_or(|names| names.iter().any(|name| name == element))
    }
}

/// Reason why a fit failed.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.sentence())]
pub enum FitError {
    /// There is no test to fit.
    NoTests,
    /// An element name is unknown.
    UnknownElement {
        /// Name of the element.
        name: String,
    },
    /// The element exists, but no fit identifies it.
    NotFitted {
        /// Name of the element.
        name: String,
    },
    /// The element is the lagged polynomial, which is a separate model and allows no other element.
    OtherFamily,
    /// The tests never move in the given direction, `rebound` or `compression`.
    OneSided(&'static str),
    /// The fit of a model of the literature failed.
    Literature(#[from] LiteratureError),
    /// A measured force is not finite, or the search finds no finite simulated forces.
    NotFinite {
        /// Name of the test with the measured force, or of the first test if the search fails.
        test: String,
    },
}

impl FitError {
    /// Returns the error and its remedy as a sentence that can be translated.
    pub fn sentence(&self) -> Sentence {
        let quoted = |name: &str| format!("{name:?}");
        match self {
            FitError::NoTests => phrases::NO_TESTS.into(),
            FitError::UnknownElement { name } => Sentence::from(phrases::UNKNOWN_ELEMENT)
                .with("name", quoted(name))
                .with_names("known", names(), phrases::COMMA),
            FitError::NotFitted { name } => Sentence::from(phrases::NOT_FITTED).with("name", name).with_names(
                "known",
                identified().iter().map(|element| element.name()),
                phrases::COMMA,
            ),
            FitError::OtherFamily => Sentence::from(phrases::OTHER_FAMILY).with("name", LAG),
            FitError::OneSided(direction) => Sentence::from(phrases::ONE_SIDED).with_word("direction", direction),
            FitError::Literature(error) => Sentence::as_it_is(error),
            FitError::NotFinite { test } => Sentence::from(phrases::NOT_FINITE).with("test", quoted(test)),
        }
    }
}

/// Stage of a fit, for a progress display.
#[derive(Debug, Clone, Copy)]
pub struct Stage {
    /// Completed fraction, 0..1.
    pub done: f64,
    /// Description of the stage.
    pub text: Template,
}

/// An identified model.
#[derive(Debug, Clone)]
pub struct Fit {
    /// Parameters of the model.
    pub params: Params,
    /// Estimates of all fitted numbers.
    pub estimates: Vec<Estimate>,
    /// Every effect of the model, with its force and probability. Empty for a model of the literature.
    pub inventory: Vec<InventoryItem>,
    /// Measurement errors of the records. The fit adds them to the computed forces, and later comparisons correct the records for them. The
    /// model never contains them.
    pub measured: Vec<Measured>,
    /// Time at which the drifts of the force channel's gain and zero are zero, s since 1970. `None` if the records have no common clock
    /// with date and time.
    pub clock_from: Option<f64>,
    /// Prior knowledge of the damper that the fit used in addition to the records.
    pub priors: PriorSet,
    /// Remarks for the engineer.
    pub notes: Vec<Sentence>,
    /// Names of the tests that the fit used.
    pub tests: Vec<String>,
    /// Fingerprints of the contents of the tests that the fit used, in the order of `tests`.
    pub fingerprints: Vec<String>,
    /// Plain FV curve fitted to the tests that the fit used, for comparison.
    pub fv_only: Params,
    /// Root mean square of the weighted residual. At 1, the residual equals noise and form error, the error of a curve between its points.
    pub misfit: f64,
}

impl Fit {
    /// Returns the notes except those about unidentified numbers, which the estimates already state.
    pub fn further_notes(&self) -> impl Iterator<Item = &Sentence> {
        let repeats = [phrases::NOT_IDENTIFIED, phrases::HELD];
        self.notes.iter().filter(move |note| !repeats.contains(&note.template()))
    }
}

/// Results of the search and the least-squares fits. [`Fit`] adds the names and fingerprints of the records.
struct Found {
    params: Params,
    estimates: Vec<Estimate>,
    inventory: Vec<InventoryItem>,
    measured: Vec<Measured>,
    notes: Vec<Sentence>,
    misfit: f64,
}

impl Found {
    /// Adds a note and an estimate for a parameter that the records cannot determine. The element of the parameter stays off.
    fn leave_out(&mut self, number: Number, why: Template) {
        self.notes.push(Sentence::from(phrases::NOT_IDENTIFIED).with("name", number).with_sentence("why", why));
        let (name, unit) = (number.name(), number.parameter().unit);
        let standing = Standing::NotIdentified;
        let from = why.into();
        self.estimates.push(Estimate { name, index: None, value: 0.0, low: None, high: None, unit, from, standing });
    }
}

/// Mixes the intervals with the intervals of alternative structures. `others` gives a weight for each alternative, relative to 1 for the
/// structure of `estimates`.
fn mix(estimates: &mut [Estimate], others: &[(f64, Vec<Estimate>)]) {
    for estimate in estimates {
        let (name, index) = (estimate.name, estimate.index);
        estimate.mix(
            others
                .iter()
                .filter_map(|(weight, all)| all.iter().find(|e| e.name == name && e.index == index)?.part(*weight)),
        );
    }
}

/// Widens the intervals of `estimates` until they contain the intervals of `others`, another fit of the same numbers. The records do not
/// exclude that fit.
pub(crate) fn hold_too<'e>(estimates: &mut [Estimate], others: impl Iterator<Item = &'e Estimate> + Clone) {
    for estimate in estimates {
        let same = |e: &&Estimate| e.name == estimate.name && e.index == estimate.index;
        let Some(other) = others.clone().find(same) else { continue };
        if let (Some(from), Some(to)) = (other.low, other.high) {
            estimate.widen([from, to]);
        }
    }
}

/// Prior standard deviation of the delay of the force channel, s. A low-pass filter with a cutoff of 200 Hz delays by about 1 ms.
const USUAL_DELAY: f64 = 1e-3;
/// Prior standard deviation of the mass between load cell and damper, kg. It covers eye, clamp and joint of a car's damper, and scales with
/// the force of other dampers.
const USUAL_MASS: f64 = 2.0;

/// Makes a hypothesis in which the delay of the force channel and the mass on the load cell are also free within their priors.
///
/// An error that the hypothesis `of` already contains, or that the user stated in `given`, stays unchanged. Returns `None` if this applies
/// to both errors.
pub(crate) fn with_free_measurement(of: &Hypothesis, given: &MeasurementError) -> Option<Hypothesis> {
    let mut freed = of.clone();
    let scale = Scale::from_params(&freed.base).force();
    let open = [(Artefact::Delay, USUAL_DELAY, given.delay_s), (Artefact::Mass, USUAL_MASS * scale, given.mass_kg)];
    for (artefact, spread, _) in open.into_iter().filter(|(_, _, given)| *given == 0.0) {
        let free = Free::Rig(artefact);
        if freed.position(&free).is_none() {
            let (low, high) = artefact.bounds();
            // A mass has the lower bound 0, so it starts above the bound.
            let start = if artefact == Artefact::Mass { 0.1 * spread } else { 0.0 };
            freed.numbers.push(FreeNumber {
                free,
                start,
                step: 0.3 * spread,
                bounds: (low, high),
                prior: Some((0.0, spread)),
            });
        }
    }
    (freed.numbers.len() > of.numbers.len()).then_some(freed)
}

/// Estimates the numbers again with the delay of the force channel and the mass on the load cell free within their priors. A soft series
/// path may become stiff once these errors are free. Returns no estimates if neither error can be free, or if the refit fails.
fn with_open_measurement(structure: &Structure, tests: &[Test], given: &MeasurementError) -> Vec<Estimate> {
    let Some(freed) = with_free_measurement(&structure.hypothesis, given) else { return Vec::new() };
    let start = freed.start();
    refit(&freed, tests, &start, None, refit::Effort::JUDGE).map_or_else(Vec::new, |end| estimates(&freed, &end, tests))
}

/// Checks that a fit can identify all elements of the options.
pub(crate) fn check_elements(options: &FitOptions) -> Result<(), FitError> {
    if let Some(names) = &options.elements
        && let Some(name) = names.iter().find(|n| Element::find(n).is_err())
    {
        return Err(FitError::UnknownElement { name: name.clone() });
    }
    if options.family == Family::Thesis && options.elements.as_ref().is_some_and(|n| n.iter().any(|n| n == LAG.name()))
    {
        return Err(FitError::OtherFamily);
    }
    let mut can = identified();
    can.push(LAG);
    if let Some(name) = options.elements.iter().flatten().find(|n| !can.iter().any(|element| element.name() == **n)) {
        return Err(FitError::NotFitted { name: name.clone() });
    }
    Ok(())
}

/// Checks that the tests move in both directions and have finite forces.
pub(crate) fn check_motion(segments: &[Segment]) -> Result<(), FitError> {
    let any = |test: fn(f64) -> bool| segments.iter().any(|s| s.input.iter().any(|i| test(i.velocity)));
    if !any(|v| v > 0.0) {
        return Err(FitError::OneSided("rebound"));
    }
    if !any(|v| v < 0.0) {
        return Err(FitError::OneSided("compression"));
    }
    if let Some(s) = segments.iter().find(|s| !s.force.iter().all(|f| f.is_finite())) {
        return Err(FitError::NotFinite { test: s.name.clone() });
    }
    Ok(())
}

/// Fits a model to records.
///
/// # Errors
/// There are no tests, an element is unknown or cannot be fitted, the tests move in one direction only, or forces are not finite. For a
/// model of the literature, also the errors of [`Literature::fit`].
pub fn fit(records: &[&Record], options: &FitOptions, progress: impl Fn(Stage)) -> Result<Fit, FitError> {
    if records.is_empty() {
        return Err(FitError::NoTests);
    }
    check_elements(options)?;
    progress(Stage { done: 0.0, text: phrases::PREPARING });
    let selection = select_tests(records);
    let selected: Vec<&Record> = match &selection {
        Some((places, _)) => places.iter().map(|place| records[*place]).collect(),
        None => records.to_vec(),
    };
    let records = &selected[..];
    let segments = segments(records);
    check_motion(&segments)?;
    let about = About::from_records(records);
    let tests = samples::tests(records);
    progress(Stage { done: 0.05, text: phrases::PLAIN_CURVE });
    let fv_only = plain_curve(&segments);
    let mut found = match options.family {
        Family::Thesis => fit_thesis(records, &tests, options, &about, &progress)?,
        Family::Fv => as_found(&tests, fv_unknowns(&fv_only)),
        Family::Piecewise => fit_piecewise((&segments, &tests), &progress)?,
        Family::Lag => fit_lag((&segments, &tests), &progress)?,
    };
    found.notes.extend(selection.map(|(_, note)| note));
    found.notes.extend(describe_roads(&tests));
    found.notes.extend(coverage_notes(&segments, &found.params));
    if options.family == Family::Thesis && found.measured.is_empty() && found.misfit > OFF {
        found.notes.extend(zero_moves(&segments, &found.params));
    }
    progress(Stage { done: 1.0, text: phrases::DONE });
    let Found { params, estimates, inventory, measured, mut notes, misfit } = found;
    let measured: Vec<Measured> = measured.into_iter().map(|m| m.with_stated(&about.stated)).collect();
    notes.extend(measured.iter().map(Measured::in_words));
    notes.extend(describe_priors(&options.priors, &estimates));
    notes.extend(estimates.iter().filter_map(|estimate| describe_rare(estimate, &params, &options.priors)));
    if params.is_on(element!("gas_warming")) {
        let reference = params.number(number!("gas_warming_reference"));
        notes.push(Sentence::from(phrases::GAS_AT).with("temperature", format!("{reference:.1}")));
    }
    if measured.iter().any(|m| m.name == "drift" && m.value < 0.0) && about.temperature.is_none() {
        notes.push(phrases::OR_WARM_GAS.into());
    }
    Ok(Fit {
        params,
        estimates,
        inventory,
        measured,
        clock_from: clock_from(records),
        priors: options.priors.clone(),
        notes,
        tests: records.iter().map(|r| r.name.clone()).collect(),
        fingerprints: records.iter().map(|r| r.fingerprint()).collect(),
        fv_only,
        misfit,
    })
}

/// Fits an FV curve with a gas force to tests, without any other effect.
pub(crate) fn plain_curve(segments: &[Segment]) -> Params {
    fv_curve::fit(&observations(segments)).params()
}

fn fv_unknowns(from: &Params) -> (Params, Vec<Unknown>) {
    let mut base = *from;
    base.disable_all();
    base.enable(element!("fv_curve"), true);
    base.enable(element!("gas_preload"), true);
    let mut list = Unknowns::rises(&base, CurveName::Fv);
    list.push(Unknown::Linear(number!("gas_force")));
    (base, list)
}

/// Information about the records in addition to motion and force.
pub(crate) struct About {
    /// Whether the clocks of the records continue from test to test through the campaign.
    clock_runs_on: bool,
    /// Measurement errors that the user stated.
    pub(crate) stated: MeasurementError,
    /// Middle of the range of the measured temperatures, °C. `None` if a record has no temperatures, or if they vary by at most 3 K.
    temperature: Option<f64>,
}

impl About {
    pub(crate) fn from_records(records: &[&Record]) -> About {
        let temperature = temperatures(records).map(|(low, high)| 0.5 * (low + high));
        About { clock_runs_on: clock_runs_on(records), stated: MeasurementError::stated(records), temperature }
    }
}

/// Effects that a fit tries, because they are typical of dampers and rigs. A diagnosis searches for all other effects.
const USUAL: [&str; 16] = [
    "series_compliance",
    "oil_compressibility",
    "gas_preload",
    "gas_warming",
    "gas_spring",
    "parallel_spring",
    "bump_stop",
    "rebound_stop",
    "coulomb_friction",
    "stribeck_friction",
    "presliding_friction",
    "side_force_friction",
    "channel_delay",
    "moving_mass",
    "gain_drift",
    "force_drift",
];

/// Returns the elements that a fit can identify.
pub fn identified() -> Vec<Element> {
    let mut all = vec![element!("fv_curve"), element!("viscous_friction")];
    all.extend(USUAL.iter().filter(|name| **name != "moving_mass").filter_map(|name| Element::find(name).ok()));
    all
}

/// Smallest number of tests at which a fit tries a drift. Fewer tests cannot distinguish a drift from differences between the tests.
const FEWEST: usize = 6;
/// Duration of the campaign, s, above which a fit tries a drift. In less than a minute, the drift of a load cell is below the noise.
const SHORTEST: f64 = 60.0;

/// Returns whether a fit of these records may try a candidate for an effect.
fn is_usual(candidate: &Candidate, situation: &Situation, about: &About, options: &FitOptions, tests: &[Test]) -> bool {
    let effect = candidate.effect;
    let is_fault = candidate.is_artefact();
    if !USUAL.contains(&effect) || candidate.unnamed.is_some() || candidate.form.starts_with("hydraulic") {
        return false;
    }
    if is_fault {
        return match effect {
            "channel_delay" => candidate.form.is_empty() && of_the_rig::can_distinguish_delay(tests),
            "moving_mass" => of_the_rig::can_distinguish_delay(tests),
            "gain_drift" | "force_drift" => {
                candidate.form.is_empty()
                    && about.clock_runs_on
                    && tests.len() >= FEWEST
                    && situation.clock_span > SHORTEST
            }
            _ => false,
        };
    }
    // This candidate `moving_mass` is a mass of the damper, which only a diagnosis identifies. A mass on the load cell is a measurement
    // error and was decided above.
    effect != "moving_mass" && effects_can_be_shown(effect, situation, about) && options.allows(effect)
}

/// Range of the side forces of a campaign, N, above which a fit tries friction under side force. It applies to a damper of a car; for other
/// dampers, it scales with their force.
const VARIED_SIDE_FORCE: f64 = 20.0;

fn effects_can_be_shown(effect: &str, situation: &Situation, about: &About) -> bool {
    match effect {
        "side_force_friction" => situation.side_force_span > VARIED_SIDE_FORCE * situation.scale.force(),
        "gas_warming" => about.temperature.is_some(),
        _ => true,
    }
}

/// Effects of every damper, with their numbers. If the most probable structure lacks such an effect, a note states that no test shows it.
/// Effects of one row are alternatives.
const IN_EVERY_DAMPER: [(&[&str], &[Number]); 3] = [
    (&["series_compliance"], &[number!("series_stiffness"), number!("internal_mass"), number!("series_damping")]),
    (&["gas_preload"], &[number!("gas_force")]),
    (&["coulomb_friction", "stribeck_friction", "presliding_friction"], &[number!("coulomb_force")]),
];

/// Searches for the effects of an ordinary damper, starting from its records alone.
pub(crate) fn search_structure(
    records: &[&Record],
    tests: &[Test],
    options: &FitOptions,
    about: &About,
) -> Result<StructureSearch, FitError> {
    let allowed = |element: Element| options.allows(element.name());
    let heating = Arc::new(Heating::new(records, tests));
    let may = |candidate: &Candidate, situation: &Situation| is_usual(candidate, situation, about, options, tests);
    let context = SearchContext {
        records,
        tests,
        is_allowed: &may,
        changes: &[],
        priors: &options.priors,
        most: usize::MAX,
        progress: &|_| (),
    };
    let plain = starts::plain(tests, &heating, &allowed);
    let test = || tests.first().map_or(String::new(), |t| t.segment.name.clone());
    StructureSearch::run(&context, None, plain).ok_or_else(|| FitError::NotFinite { test: test() })
}

fn fit_thesis(
    records: &[&Record],
    tests: &[Test],
    options: &FitOptions,
    about: &About,
    progress: &impl Fn(Stage),
) -> Result<Found, FitError> {
    let allowed = |element: Element| options.allows(element.name());
    progress(Stage { done: 0.1, text: phrases::FIRST_FIT });
    progress(Stage { done: 0.3, text: phrases::CHOOSING_STRUCTURE });
    let search = search_structure(records, tests, options, about)?;
    let not_finite = || FitError::NotFinite { test: tests.first().map_or(String::new(), |t| t.segment.name.clone()) };
    progress(Stage { done: 0.85, text: phrases::REFINING });
    let best = search.best.refitted(tests, refit::Effort::FINE).ok_or_else(not_finite)?;
    let probabilities = search.probabilities(Temperatures::WITHOUT_REFERENCE);
    let probability = |effect: &str| probabilities.get(effect).copied().unwrap_or(0.0);
    let inventory = inventory(&best, None, tests, &probability);
    let mut found = finish(&best, tests, &about.stated);
    let others = alternatives(&search, &best, Temperatures::WITHOUT_REFERENCE, tests);
    let of =
        |other: &Alternative| (other.weight, estimates(&other.structure.hypothesis, &other.structure.refit, tests));
    mix(&mut found.estimates, &others.iter().map(of).collect::<Vec<_>>());
    found.notes.extend(doubtful_errors(&best.components, &probability));
    found.inventory = inventory;
    // The note also applies if the best structure has no series path, because a leading force channel can cancel the phase of a series
    // path.
    if allowed(element!("series_compliance")) && !of_the_rig::can_distinguish_delay(tests) {
        found.notes.push(if tests.len() > 1 { phrases::ONE_RATE } else { phrases::ONE_TEST }.into());
    }
    for (effects, numbers) in IN_EVERY_DAMPER {
        let is_in = best.components.iter().any(|c| effects.contains(&c.effect));
        let is_tried = Element::find(effects[0]).is_ok_and(allowed);
        for number in numbers.iter().filter(|_| !is_in && is_tried) {
            found.leave_out(*number, phrases::NO_TEST);
        }
    }
    let situation = Situation::new(&best.hypothesis.base, records, tests);
    if !effects_can_be_shown("side_force_friction", &situation, about) && allowed(element!("side_force_friction")) {
        found.leave_out(number!("side_force_coefficient"), phrases::NEEDS_SIDE_FORCES);
    }
    if allowed(element!("viscous_friction")) {
        found.leave_out(number!("viscous_coefficient"), phrases::TAKEN_UP);
    }
    Ok(found)
}

/// Returns notes on the measurement errors of a structure that are more improbable than probable. The most probable structure can contain
/// such an error, because the probability is a sum over all structures with tempered weights.
fn doubtful_errors(components: &[Component], probability: &impl Fn(&str) -> f64) -> Vec<Sentence> {
    let is_doubtful = |component: &&Component| probability(component.effect) < 0.5;
    let note = |component: &Component| {
        let percent = format!("{:.0} %", 100.0 * probability(component.effect));
        Sentence::from(phrases::DOUBTFUL_ERROR).with("effect", component.effect).with("probability", percent)
    };
    components.iter().filter(|c| c.is_of_measurement()).filter(is_doubtful).map(note).collect()
}

/// Returns whether the damper has a compliance, whose phase resembles that of a delay of the force channel.
pub(crate) fn has_compliance(params: &Params) -> bool {
    params.is_on(element!("series_compliance")) || params.is_on(element!("oil_compressibility"))
}

/// Computes the intervals and measurement errors of the best structure. Adds notes on numbers that the records do not determine or that are
/// at a bound.
fn finish(structure: &Structure, tests: &[Test], given: &MeasurementError) -> Found {
    let Structure { hypothesis, refit, .. } = structure;
    let mut notes = Vec::new();
    let mut estimates = estimates(hypothesis, refit, tests);
    if has_compliance(&hypothesis.base) && of_the_rig::can_distinguish_delay(tests) {
        hold_too(&mut estimates, with_open_measurement(structure, tests, given).iter());
    }
    for estimate in &estimates {
        match estimate.standing {
            Standing::NotIdentified if estimate.index.is_none() => notes.push(of_number(phrases::HELD, estimate)),
            Standing::AtBound => notes.push(of_number(phrases::AT_BOUND, estimate)),
            _ => {}
        }
    }
    let mut measured = of_the_rig::measured(hypothesis, refit, tests);
    measured.sort_by_key(|m| m.name);
    let params = hypothesis.params(&refit.theta);
    let misfit = misfit_of(refit, tests);
    Found { params, estimates, inventory: Vec::new(), measured, notes, misfit }
}

/// Formats a sentence about a number of the model, with the digits and the unit of the table of numbers.
pub(crate) fn of_number(template: Template, estimate: &Estimate) -> Sentence {
    Sentence::from(template).with("name", estimate.name).with("value", estimate.reading().with_unit())
}

/// Computes the root mean square of the weighted residual over the scored samples.
fn misfit_of(refit: &Refit, tests: &[Test]) -> f64 {
    let scored: usize = tests.iter().flat_map(|t| &t.allowed).filter(|a| a.is_finite()).count();
    (refit.residual.norm_squared() / scored.max(1) as f64).sqrt()
}

fn misfit(tests: &[Test], params: &Params) -> f64 {
    let hypothesis = Hypothesis { base: *params, numbers: Vec::new(), heating: None, priors: PriorSet::default() };
    let residual = hypothesis.residual_by(Accuracy::Full, tests, &[]);
    let scored: usize = tests.iter().flat_map(|t| &t.allowed).filter(|a| a.is_finite()).count();
    residual.map_or(f64::NAN, |r| (r.norm_squared() / scored.max(1) as f64).sqrt())
}

/// Makes the result of a model of the literature from the parameters of its own least-squares fit, with intervals.
fn as_found(tests: &[Test], (base, list): (Params, Vec<Unknown>)) -> Found {
    let numbers = list.into_iter().map(|unknown| free_number(&base, unknown)).collect();
    let hypothesis = Hypothesis { base, numbers, heating: None, priors: PriorSet::default() };
    let theta = hypothesis.start();
    let misfit = misfit(tests, &base);
    let at = hypothesis
        .residual(tests, &theta)
        .zip(hypothesis.jacobian(Accuracy::Single, tests, &theta))
        .map(|(residual, jacobian)| Refit::from_point(&hypothesis, theta, residual, jacobian));
    let estimates = at.map_or_else(Vec::new, |refit| estimates(&hypothesis, &refit, tests));
    Found { params: base, estimates, inventory: Vec::new(), measured: Vec::new(), notes: Vec::new(), misfit }
}

/// Fits the piecewise-linear curve of the literature, with intervals.
fn fit_piecewise((segments, tests): (&[Segment], &[Test]), progress: &impl Fn(Stage)) -> Result<Found, FitError> {
    progress(Stage { done: 0.3, text: phrases::PIECEWISE });
    let base = kernel_model("piecewise", segments)?;
    let mut list: Vec<Unknown> = COEFFICIENTS_AND_KNEES.map(Unknown::Log).to_vec();
    list.push(Unknown::Linear(number!("gas_force")));
    Ok(as_found(tests, (base, list)))
}

/// Fits the polynomial with lag of the literature, with intervals.
fn fit_lag((segments, tests): (&[Segment], &[Test]), progress: &impl Fn(Stage)) -> Result<Found, FitError> {
    progress(Stage { done: 0.3, text: phrases::WITH_LAG });
    let base = kernel_model("lag", segments)?;
    let terms = base.list(list!("polynomial")).len();
    let mut list: Vec<Unknown> = (0..terms).map(|k| Unknown::Entry(list!("polynomial"), k)).collect();
    list.extend([Unknown::Log(number!("lag_slow")), Unknown::Log(number!("lag_fast"))]);
    Ok(as_found(tests, (base, list)))
}

/// Fits a model of the literature for which the kernel has elements.
fn kernel_model(name: &'static str, segments: &[Segment]) -> Result<Params, FitError> {
    let found = Literature::fit(name, &observations(segments))?;
    found.params().ok_or(FitError::Literature(LiteratureError::NotFinite { name }))
}

/// Fraction of the residual mean square due to a constant force in each test above which [`zero_moves`] reports these constant forces.
///
/// A model that fits stays below this limit and below [`OFF`]. A model distorted by force zeros that differ between tests exceeds both.
const CONSTANT: f64 = 0.2;
/// Ratio of the root mean square residual to noise and form error above which a fit searches the residual for constant forces.
const OFF: f64 = 2.0;

/// Returns a remark if the residuals of at least three tests consist to a large part of a constant force in each test.
///
/// A model has the same numbers in all tests, so it already contains any force that all tests share. Such residuals therefore mean that the
/// zero of the force channel drifts, or that the gas force changes with its temperature.
fn zero_moves(segments: &[Segment], params: &Params) -> Option<Sentence> {
    let model = Model::new(params).ok()?;
    let (mut constant, mut rest) = (Vec::new(), 0.0);
    for s in segments {
        let forces = sensitivity::forces(&model, s);
        let left: Vec<f64> = s.force.iter().zip(&forces).skip(s.from).map(|(m, f)| m - f).collect();
        let mean = left.iter().sum::<f64>() / left.len().max(1) as f64;
        rest += left.iter().map(|l| (l - mean).powi(2)).sum::<f64>() / left.len().max(1) as f64;
        constant.push(mean);
    }
    let squares: f64 = constant.iter().map(|c| c * c).sum();
    let (low, high) = constant.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), c| (l.min(*c), h.max(*c)));
    (segments.len() >= 3 && squares > CONSTANT * (squares + rest)).then(|| {
        Sentence::from(phrases::ZERO_MOVES).with("low", format!("{low:.1}")).with("high", format!("{high:.1}"))
    })
}

/// Returns the indices of the tests that a search uses, with a note. Returns `None` if it uses all tests.
pub fn select_tests(records: &[&Record]) -> Option<(Vec<usize>, Sentence)> {
    let selected = select(records)?;
    let note = Sentence::from(phrases::SELECTED).with("all", records.len()).with("selected", selected.len());
    Some((selected, note))
}

/// Returns a note that long tests without cycles are simulated in stretches. Returns `None` without such tests.
pub fn describe_roads(tests: &[Test]) -> Option<Sentence> {
    let Shortened { roads, stretches, seconds } = shortened(tests)?;
    let said = Sentence::from(phrases::ROADS).with("roads", roads).with("stretches", stretches);
    Some(said.with("seconds", format!("{seconds:.1}")))
}

/// Returns notes about tests that the campaign lacks: slow tests, and tests whose amplitudes differ by a factor of at least two. The amplitudes
/// concern only models with a spring or a series stiffness.
pub(crate) fn coverage_notes(segments: &[Segment], params: &Params) -> Vec<Sentence> {
    let mut notes = Vec::new();
    let velocity = round_figure(1e3 * SLOW);
    if !segments.iter().any(|s| s.peak_velocity < SLOW) {
        let has_friction = has_dry_friction(params) || params.is_on(element!("side_force_friction"));
        let said = if has_friction { phrases::NO_SLOW_TEST } else { phrases::NO_SLOW_TEST_NO_FRICTION };
        notes.push(Sentence::from(said).with("velocity", &velocity));
    }
    let are_one = |amplitudes: &mut dyn Iterator<Item = f64>| {
        let (count, low, high) =
            amplitudes.fold((0, f64::INFINITY, 0.0f64), |(n, l, h), a| (n + 1, l.min(a), h.max(a)));
        count > 1 && high > 0.0 && high < 2.0 * low
    };
    let has_spring = params.is_on(element!("gas_spring")) || params.is_on(element!("parallel_spring"));
    if are_one(&mut segments.iter().map(|s| s.amplitude)) {
        notes.extend(match (has_spring, has_compliance(params)) {
            (true, true) => Some(phrases::ONE_AMPLITUDE.into()),
            (true, false) => Some(phrases::ONE_AMPLITUDE_OF_SPRING.into()),
            (false, true) => Some(phrases::ONE_AMPLITUDE_OF_SERIES.into()),
            (false, false) => None::<Sentence>,
        });
    } else if has_compliance(params)
        && are_one(&mut segments.iter().filter(|s| s.peak_velocity >= SLOW).map(|s| s.amplitude))
    {
        // Slow tests show friction and gas force, but hardly the spring in series, so the fast tests also need different amplitudes.
        notes.push(Sentence::from(phrases::ONE_FAST_AMPLITUDE).with("velocity", velocity));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_measurement_error_that_is_hardly_probable_is_said_to_be_doubtful() {
        let component = |effect: &'static str, elements: Vec<Element>, frees: Vec<Free>| Component {
            effect,
            form: "",
            elements,
            fixed: Vec::new(),
            frees,
            numbers: 1.0,
        };
        let both = [
            component("gas_spring", vec![element!("gas_spring")], Vec::new()),
            component("channel_delay", Vec::new(), vec![Free::Rig(Artefact::Delay)]),
        ];
        let told = |probability: f64| doubtful_errors(&both, &|_: &str| probability);
        assert!(told(0.6).is_empty());
        let [note] = &told(0.11)[..] else { panic!("one note is expected") };
        assert!(note.to_string().starts_with("channel_delay has a probability of 11 % only"), "{note}");
    }

    #[test]
    fn a_campaign_of_thousands_says_how_many_tests_stand_for_all() {
        let records = [slow_sine(), slow_sine()];
        let many: Vec<&Record> = records.iter().cycle().take(8000).collect();
        let (selected, note) = select_tests(&many).unwrap();
        let note = note.to_string();
        assert!(selected.len() < 300 && note.contains("8000 tests"), "{note}");
        assert!(note.contains(&format!("{} of them stand for all", selected.len())), "{note}");
        assert!(select_tests(&many[..100]).is_none());
    }

    #[test]
    fn notes_on_amplitudes_are_true_of_the_tests_that_they_name() {
        let segment = |amplitude: f64, peak_velocity: f64| {
            let mut segment = crate::fit::segments(&[&slow_sine()]).remove(0);
            (segment.amplitude, segment.peak_velocity) = (amplitude, peak_velocity);
            segment
        };
        let said = |all: &[(f64, f64)], elements: &[&str]| -> Vec<String> {
            let all: Vec<Segment> = all.iter().map(|(amplitude, peak)| segment(*amplitude, *peak)).collect();
            let mut params = Params::default();
            params.disable_all();
            for name in elements {
                params.enable(Element::find(name).unwrap(), true);
            }
            let notes = coverage_notes(&all, &params).iter().map(ToString::to_string).collect::<Vec<_>>();
            notes.into_iter().filter(|note| note.contains("amplitude")).collect()
        };
        let (slow, fast) = (0.5 * SLOW, 10.0 * SLOW);
        let both: &[&str] = &["parallel_spring", "series_compliance"];
        assert!(said(&[(0.005, slow), (0.05, slow)], both).is_empty());
        assert!(said(&[(0.005, fast), (0.05, fast), (0.05, slow)], both).is_empty());
        assert!(said(&[(0.05, slow), (0.05, fast)], both)[0].contains("the spring and the series stiffness rest"));
        assert!(said(&[(0.005, slow), (0.05, fast), (0.05, fast)], both)[0].contains("tests faster than 6 mm/s have"));
        // A single test gives no note on the amplitudes of all tests. A model without spring and series stiffness gives no note at all.
        assert!(said(&[(0.05, slow)], both).is_empty() && said(&[(0.005, slow), (0.05, fast)], both).is_empty());
        assert!(said(&[(0.05, slow), (0.05, fast)], &["gas_spring"])[0].contains("the spring rests"));
        assert!(
            said(&[(0.05, slow), (0.05, fast)], &["oil_compressibility"])[0].contains("the series stiffness rests")
        );
        assert!(said(&[(0.05, slow), (0.05, fast)], &["coulomb_friction"]).is_empty());
        assert!(said(&[(0.005, slow), (0.05, fast), (0.05, fast)], &["gas_spring"]).is_empty());
    }

    #[test]
    fn where_no_test_is_slow_the_note_is_true_of_a_model_with_friction_and_of_one_without() {
        let fast = Segment { peak_velocity: 10.0 * SLOW, ..crate::fit::segments(&[&slow_sine()]).remove(0) };
        let mut params = Params::default();
        params.disable_all();
        let said = |params: &Params| coverage_notes(std::slice::from_ref(&fast), params)[0].to_string();
        assert!(said(&params).ends_with("the model has none"), "{}", said(&params));
        for name in ["coulomb_friction", "presliding_friction"] {
            let mut with = params;
            with.enable(Element::find(name).unwrap(), true);
            assert!(said(&with).contains("friction is taken from"), "{}", said(&with));
        }
    }

    #[test]
    fn a_number_that_is_held_is_told_by_its_digits() {
        let said = |name: &'static str, value: f64, unit: &'static str| {
            let (from, standing) = (Sentence::from(phrases::HELD), Standing::NotIdentified);
            let held = Estimate { name, index: None, value, low: None, high: None, unit, from, standing };
            of_number(phrases::HELD, &held).to_string()
        };
        assert!(said("presliding_length", 1.524_89e-4, "m").ends_with("held at 0.1525 mm"));
        assert!(said("presliding_creep", 1e-9, "m/s").ends_with("held at 1.000·10⁻⁶ mm/s"));
        assert!(said("gas_force", 58.040_02, "N").ends_with("held at 58.04 N"));
    }

    /// Makes a sine test of ±12 mm at 0.9 Hz on a damper with spring, viscous damping and friction.
    fn slow_sine() -> Record {
        let n = 1000;
        let time: Vec<f64> = (0..n).map(|i| i as f64 * 0.01).collect();
        let phase = |t: f64| TAU * 0.9 * t;
        let displacement: Vec<f64> = time.iter().map(|t| 0.012 * libm::sin(phase(*t))).collect();
        let velocity: Vec<f64> = time.iter().map(|t| 0.012 * TAU * 0.9 * libm::cos(phase(*t))).collect();
        let force =
            displacement.iter().zip(&velocity).map(|(x, v)| 1700.0 * x + 800.0 * v + 55.0 * libm::tanh(300.0 * v));
        Record {
            name: "slow".to_owned(),
            force: force.collect(),
            cycles: (0..8).map(|k| (k as f64 * 111.1) as usize..((k + 1) as f64 * 111.1) as usize).collect(),
            amplitude: 0.012,
            frequency: 0.9,
            peak_velocity: 0.0679,
            time,
            displacement,
            velocity,
            ..Record::default()
        }
    }

    #[test]
    fn a_single_slow_record_is_no_reason_to_panic_for_any_kind_of_model() {
        // The polynomial's seventh power of 0.07 m/s would need coefficients that the parameter table rejects. The fit must still give a
        // valid model.
        let record = slow_sine();
        for family in [Family::Lag, Family::Piecewise, Family::Fv] {
            let found = fit(&[&record], &FitOptions { family, ..FitOptions::default() }, |_| ()).unwrap();
            assert!(found.misfit.is_finite() && dashpot_core::Model::new(&found.params).is_ok(), "{family:?}");
        }
    }
}
