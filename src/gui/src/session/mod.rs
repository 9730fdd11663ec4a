//! The state and the functions of the window, independent of the display.
//!
//! | file | contents |
//! |---|---|
//! | [`campaign`] | the open records |
//! | [`dampers`], [`comparison`] | the damper of each test, and the comparison of its forces with the ticked tests |
//! | [`model`], [`history`] | the tuned model, with undo |
//! | [`simulation`] | forces of the model for every test, computed in the background |
//! | [`tasks`] | long tasks with progress and cancel |
//! | [`verbs`] | fit, validate, diagnose |
//! | [`outputs`], [`exports`] | all written files |
//! | [`results`] | the results of fit, validation and diagnosis, and whether they match the data on screen |
//! | [`replacing`] | replacement of the model, with undo |
//! | [`settings`] | corrections of the settings of tests, with undo |
//! | [`matrix`], [`study`] | the error matrix, and variation of one parameter |
//! | [`two_ways`] | gas and drag of a cycle |
//! | [`velocities`] | forces at peak velocities and at given velocities |
//! | [`valve`] | response of an adjustable damper's valve to a step |
//! | [`drawing`] | the dimensions of the damper, and the quantities that follow from them |
//! | [`recent`] | recently opened campaigns |

pub mod campaign;
pub mod comparison;
pub mod dampers;
pub mod drawing;
pub mod exports;
pub mod guarded;
pub mod history;
pub mod matrix;
pub mod model;
pub mod outputs;
pub mod papers;
pub mod progress;
pub mod recent;
pub mod replacing;
pub mod results;
pub mod settings;
pub mod simulation;
pub mod study;
pub mod tasks;
pub mod two_ways;
pub mod valve;
pub mod velocities;
pub mod verbs;

use campaign::Loaded;
use dampers::{Dampers, TestDamper};
use dashpot_core::Params;
use dashpot_core::parameter::Element;
use dashpot_identification::Estimate;
use dashpot_identification::setting_units::restate_settings;
use dashpot_messages::Sentence;
use dashpot_records::{Options, Profile, Record, SettingRules, Unusable};
use model::Tuned;
use recent::Recent;
use replacing::Replacement;
use results::{Finding, Results};
use simulation::{Simulated, Simulator, Wanted};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;
use study::Study;
use tasks::{Kind, Outcome, Standing, Task};

/// Callback for new results. Any thread may call it.
pub type Waker = Arc<dyn Fn() + Send + Sync>;

/// A message in the status line.
#[derive(Debug, Clone)]
pub struct Message {
    /// Text of the message.
    pub text: Sentence,
    /// Whether the message reports an error.
    pub wrong: bool,
}

/// All open data and running tasks.
pub struct Session {
    /// The open records.
    pub campaign: Option<Arc<Loaded>>,
    /// The reference: another campaign of the same tests, for comparison.
    pub reference: Option<Arc<Loaded>>,
    /// The model on screen.
    pub model: Option<Tuned>,
    /// Indices of the plotted tests.
    pub selected: BTreeSet<usize>,
    /// Indices of the tests that are excluded from fit, validation and diagnosis.
    pub unticked: BTreeSet<usize>,
    /// Whether each test is simulated at its own setting of an adjustable damper.
    pub own_settings: bool,
    /// The newest forces of the model on screen.
    pub simulated: Option<Arc<Simulated>>,
    /// Forces of the identified model, for comparison.
    pub identified: Option<Arc<Simulated>>,
    /// Results of fit, validation and diagnosis.
    pub results: Results,
    /// Responses of the force to steps of the setting in the open tests.
    pub responses: valve::Responses,
    /// The dimensions of the damper.
    pub drawing: Option<drawing::Drawing>,
    /// Whether the dimensions were opened since the last frame.
    pub is_drawing_new: bool,
    /// Loops of one test for several values of one parameter.
    pub study: Option<Study>,
    /// The last message in the status line.
    pub message: Option<Message>,
    /// Recently opened campaigns.
    pub recent: Recent,
    /// Options of reading that the user set.
    pub reading: Options,
    /// Counter that increases with every change of the plotted data.
    pub generation: u64,
    /// The running task.
    pub task: Option<Task>,
    /// A model that replaces the model on screen once the user agrees.
    pub pending: Option<replacing::Replacement>,
    /// Task whose result arrived since the last frame.
    pub arrived: Option<Kind>,
    others: replacing::Others,
    corrections: settings::Corrections,
    /// Number of times that records were read with other tests or other samples.
    read: u64,
    /// Number of times that a reference was read.
    read_reference: u64,
    simulator: Simulator,
    waker: Waker,
    /// Time of the last movement of a slider, while the simulation of whole records is pending.
    moving: Option<Instant>,
}

/// Pause of a slider after which the session simulates the whole records of all tests.
const REST: std::time::Duration = std::time::Duration::from_millis(250);

impl Session {
    /// Makes an empty session.
    pub fn new(recent: Recent, waker: Waker) -> Session {
        Session {
            campaign: None,
            reference: None,
            model: None,
            selected: BTreeSet::new(),
            unticked: BTreeSet::new(),
            own_settings: true,
            simulated: None,
            identified: None,
            results: Results::default(),
            responses: valve::Responses::default(),
            drawing: None,
            is_drawing_new: false,
            study: None,
            message: None,
            recent,
            reading: Options::default(),
            generation: 0,
            task: None,
            pending: None,
            arrived: None,
            others: replacing::Others::default(),
            corrections: settings::Corrections::default(),
            read: 0,
            read_reference: 0,
            simulator: Simulator::new(waker.clone()),
            waker,
            moving: None,
        }
    }

    /// Shows a message.
    pub fn say(&mut self, text: impl Into<String>) {
        self.message = Some(Message { text: Sentence::as_it_is(text.into()), wrong: false });
    }

    /// Shows an error message.
    pub fn complain(&mut self, text: Sentence) {
        self.message = Some(Message { text, wrong: true });
    }

    /// Opens dropped or chosen paths: model files, files of dimensions, record files and folders.
    pub fn open(&mut self, paths: &[PathBuf]) {
        self.open_with(paths, Options::default());
    }

    /// Opens files and folders like [`Session::open`], and reads records with `options`.
    pub fn open_with(&mut self, paths: &[PathBuf], options: Options) {
        let is_model = |p: &PathBuf| {
            p.is_file()
                && p.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"))
                && p.file_name().is_none_or(|n| n != dashpot_records::profile::FILE)
        };
        let (files, records): (Vec<PathBuf>, Vec<PathBuf>) = paths.iter().cloned().partition(is_model);
        let (drawings, models): (Vec<PathBuf>, Vec<PathBuf>) =
            files.into_iter().partition(|path| drawing::is_drawing(path));
        if let Some(model) = models.last() {
            self.replace(replacing::Replacement::File(model.clone()));
        }
        if !records.is_empty() {
            self.open_records(records, options);
        }
        if let Some(drawing) = drawings.last() {
            self.open_drawing(drawing);
        }
    }

    /// Reads records in the background. Returns whether the reading began.
    pub fn open_records(&mut self, paths: Vec<PathBuf>, options: Options) -> bool {
        let paths = paths.iter().map(|p| profile_stands_for_its_folder(p)).collect();
        self.begin(Kind::Read, move |report| {
            Loaded::read(paths, options, report).map(Outcome::Read).map_err(|e| e.sentence())
        })
    }

    /// Reads records for comparison, with the options of the open records. Rules for settings name tests of the open records, so they do
    /// not apply to tests of equal name of another damper.
    pub fn open_reference(&mut self, paths: Vec<PathBuf>) {
        let options = Options { settings: SettingRules::default(), ..self.reading.clone() };
        self.begin(Kind::ReadReference, move |report| {
            Loaded::read(paths, options, report).map(Outcome::Reference).map_err(|e| e.sentence())
        });
    }

    /// Rereads the records with the options that the user set.
    pub fn read_again(&mut self) {
        let Some(campaign) = &self.campaign else { return };
        self.open_records(campaign.paths.clone(), self.reading.clone());
    }

    /// Opens a model file.
    pub fn open_model(&mut self, path: &Path) {
        match Tuned::read(path) {
            Ok(model) => {
                self.take_model(model);
                self.say(path.display().to_string());
            }
            Err(error) => self.complain(Sentence::as_it_is(error)),
        }
    }

    /// Shows a model and discards the forces of the previous one.
    fn show_model(&mut self, model: Tuned) {
        self.model = Some(model);
        self.simulated = None;
        self.identified = None;
        self.study = None;
        self.see_as_the_fit_saw();
        self.forget_explanation();
        self.order(false);
        self.order_responses();
    }

    /// Applies the measurement corrections of the model's fit to the open records, like the command `dashpot`. If the model has no
    /// corrections, restores the records as they were read.
    fn see_as_the_fit_saw(&mut self) {
        let (Some(model), Some(own)) = (&self.model, &self.campaign) else { return };
        let others = self.reference.as_ref();
        let was_changed = |loaded: &Arc<Loaded>| !std::ptr::eq(loaded.original(), &raw const loaded.campaign);
        if model.identification.measurement.is_empty() && !was_changed(own) && !others.is_some_and(was_changed) {
            return;
        }
        let mut records = own.original().records.clone();
        let mut of_reference = others.map_or_else(Vec::new, |others| others.original().records.clone());
        if let Some((axis, _)) = model.over_setting() {
            // Each record's setting is converted to the model's unit separately. A setting with an incompatible unit belongs to another
            // damper and must not prevent the conversion of the other records.
            for record in records.iter_mut().chain(&mut of_reference) {
                let _ = restate_settings(axis, [record]);
            }
        }
        let note = model.identification.right(records.iter_mut().chain(&mut of_reference));
        let reference = others.map(|others| Arc::new(others.seen_as(of_reference, note.clone())));
        self.campaign = Some(Arc::new(own.seen_as(records, note)));
        self.reference = reference;
        self.generation += 1;
    }

    /// Returns the working folder of the user: the folder of the records, or else the folder of the model.
    pub fn folder(&self) -> Option<PathBuf> {
        let records = self.campaign.as_ref().and_then(|loaded| {
            let beside = || loaded.paths.first().and_then(|path| path.parent()).map(Path::to_owned);
            loaded.folder.clone().or_else(beside)
        });
        let model = || self.model.as_ref()?.path.as_ref()?.parent().map(Path::to_owned);
        let folder = std::path::absolute(records.or_else(model)?).ok()?;
        folder.is_dir().then_some(folder)
    }

    /// Returns whether records are open.
    pub fn has_records(&self) -> bool {
        self.campaign.is_some()
    }

    /// Begins a task if none is running. Returns whether it began.
    pub fn begin(
        &mut self,
        kind: Kind,
        work: impl FnOnce(progress::Report<'_>) -> Result<Outcome, Sentence> + Send + 'static,
    ) -> bool {
        if self.task.is_some() {
            return false;
        }
        self.message = None;
        self.task = Some(Task::begin(kind, self.waker.clone(), work));
        true
    }

    /// Requests the running task to stop.
    pub fn cancel(&self) {
        if let Some(task) = &self.task {
            task.cancel();
        }
    }

    /// Returns the indices of the ticked records.
    pub fn ticked(&self) -> Vec<usize> {
        let count = self.campaign.as_ref().map_or(0, |c| c.campaign.records.len());
        (0..count).filter(|k| !self.unticked.contains(k)).collect()
    }

    /// Returns a record by its index.
    pub fn record(&self, test: usize) -> Option<&Record> {
        self.campaign.as_ref()?.campaign.records.get(test)
    }

    /// Returns whether closing would lose a running task or unsaved values.
    pub fn would_lose(&self) -> bool {
        self.task.is_some() || self.is_unsaved()
    }

    /// Returns whether the model has unsaved values.
    pub fn is_unsaved(&self) -> bool {
        self.model.as_ref().is_some_and(Tuned::is_unsaved)
    }

    /// Changes the model, and discards the models that redo would restore. The plots show the new forces of one cycle immediately. The
    /// whole records of all tests are simulated after a pause of the slider.
    pub fn tune(&mut self, change: impl FnOnce(&mut Tuned) -> bool) {
        if self.step(change) {
            self.forget_future();
        }
    }

    /// Moves to another setting of an adjustable damper. Undo then returns to values that were tuned at the previous setting.
    pub fn move_to(&mut self, setting: f64) {
        let before = self.model.as_ref().filter(|model| model.steps().0.is_some()).cloned();
        if self.step(|model| model.move_to(setting)) {
            if let Some(before) = before {
                self.keep(before);
            }
            // Forces of the identified model at the previous setting are not comparable, so they are discarded.
            self.identified = None;
        }
    }

    /// Selects whether each test has its own setting, or all tests have the setting on screen.
    pub fn use_own_settings(&mut self, own: bool) {
        if self.own_settings != own {
            self.own_settings = own;
            self.identified = None;
            self.order(false);
            self.generation += 1;
        }
    }

    /// Returns the damper of each test, or `None` without a model.
    pub fn dampers(&self) -> Option<Dampers> {
        let model = self.model.as_ref()?;
        Some(model.dampers(model.params(), self.own_settings))
    }

    /// Returns whether the current errors and forces are provisional.
    ///
    /// They are provisional until the whole records are simulated with the model on screen. Before that, they come from one cycle of each
    /// test, or from the previous model.
    pub fn are_errors_provisional(&self) -> bool {
        self.simulated.as_ref().is_some_and(|of| of.quick || self.dampers().is_none_or(|now| now != of.dampers))
    }

    /// Returns whether an open test has its own setting of the adjustable damper.
    pub fn has_own_settings(&self) -> bool {
        let (Some(model), Some(loaded)) = (&self.model, &self.campaign) else { return false };
        let dampers = model.dampers(&model.identified, true);
        loaded.campaign.records.iter().any(|record| dampers.of_test(record) != TestDamper::Shown)
    }

    /// Changes the model by tuning, undo or redo, and requests its forces. Returns whether the model changed.
    fn step(&mut self, change: impl FnOnce(&mut Tuned) -> bool) -> bool {
        let Some(model) = &mut self.model else { return false };
        let changed = change(model);
        if changed {
            self.moving = Some(Instant::now());
            self.order(true);
        }
        changed
    }

    /// Requests the forces of the current model. If `quick` is set, one cycle of each test is simulated, otherwise the whole test.
    pub fn order(&mut self, quick: bool) {
        let (Some(model), Some(loaded)) = (&self.model, &self.campaign) else { return };
        let dampers = model.dampers(model.params(), self.own_settings);
        self.simulator.order(Wanted { dampers, loaded: loaded.clone(), quick });
    }

    /// Collects finished results. Returns whether a running task needs another poll soon.
    pub fn poll(&mut self) -> bool {
        if let Some(simulated) = self.simulator.take() {
            let current = self.campaign.as_ref().is_some_and(|c| Arc::ptr_eq(c, &simulated.loaded));
            if current {
                let simulated = Arc::new(simulated);
                let own = self.own_settings;
                let is_of = |m: &Tuned| m.dampers(&m.identified, own) == simulated.dampers;
                let is_identified = self.model.as_ref().is_some_and(is_of);
                if is_identified && !simulated.quick {
                    self.identified = Some(simulated.clone());
                }
                // While the model is tuned, forces of the identified model must not replace those of the tuned model.
                if self.model.as_ref().is_some_and(|m| !m.is_tuned() || !is_identified) {
                    self.simulated = Some(simulated);
                }
                self.generation += 1;
            }
        }
        if self.moving.is_some_and(|at| at.elapsed() >= REST) && !self.simulator.is_busy() {
            self.moving = None;
            self.order(false);
        }
        self.compare_with_identified();
        let standing = self.task.as_ref().map(Task::standing);
        match standing {
            Some(Standing::Working) | None => {}
            Some(Standing::Cancelled) => {
                self.task = None;
                self.corrections.take_pending();
            }
            Some(Standing::Done(result)) => {
                self.task = None;
                match result {
                    Ok(outcome) => self.take(outcome),
                    Err(error) => self.complain(error),
                }
                // A change of settings whose reading failed is dropped.
                self.corrections.take_pending();
            }
        }
        let responding = self.poll_responses();
        responding || self.task.is_some() || self.moving.is_some() || self.simulator.is_busy()
    }

    /// Requests the identified model's forces if the model was tuned before these forces were available.
    fn compare_with_identified(&mut self) {
        if self.identified.is_some() || self.moving.is_some() || self.simulator.is_busy() {
            return;
        }
        let (Some(model), Some(loaded)) = (&self.model, &self.campaign) else { return };
        if model.is_tuned() && self.simulated.is_some() {
            let dampers = model.dampers(&model.identified, self.own_settings);
            self.simulator.order(Wanted { dampers, loaded: loaded.clone(), quick: false });
        }
    }

    fn take(&mut self, outcome: Outcome) {
        match outcome {
            Outcome::Read(loaded) => self.take_records(loaded),
            Outcome::Reference(loaded) => {
                self.tell_unusable(&loaded);
                self.reference = Some(Arc::new(loaded));
                self.read_reference += 1;
                self.see_as_the_fit_saw();
                self.generation += 1;
            }
            Outcome::Fitted(fit) => {
                self.fit_is_done(Replacement::Fitted(fit));
            }
            Outcome::FittedFamily(fit) => {
                self.fit_is_done(Replacement::FittedFamily(fit));
            }
            Outcome::Validated(validation, basis) => {
                self.results.validation = Some(Finding::of_validation(validation, *basis));
                self.arrived = Some(Kind::Validate);
            }
            Outcome::Diagnosed(diagnosed, basis) => {
                self.results.diagnosis = Some(Finding::of_diagnosis(diagnosed, *basis));
                self.arrived = Some(Kind::Diagnose);
            }
            // `poll_responses` collects the results of the separate task `Kind::Respond`, so they do not arrive here.
            Outcome::Responded(_) => {}
            Outcome::Studied(study) => {
                self.study = Some(study);
                self.generation += 1;
            }
            Outcome::Written(path, said) => {
                let path = path.display().to_string();
                self.say(if said.is_empty() { path } else { format!("{path}: {}", said.join(" ")) });
            }
        }
    }

    /// Reports the first unusable record. The list of tests shows all unusable records.
    fn tell_unusable(&mut self, loaded: &Loaded) {
        if let Some(text) = Unusable::first_of(&loaded.campaign.unusable) {
            self.message = Some(Message { text, wrong: false });
        }
    }

    fn take_records(&mut self, loaded: Loaded) {
        self.tell_unusable(&loaded);
        if let Some(first) = loaded.paths.first() {
            self.recent.add(first);
        }
        outputs::register_inputs(&loaded);
        let change = self.corrections.take_pending();
        let edited = self.reading.clone();
        // Show the options stored with the records, for editing.
        self.reading = loaded.options.clone();
        if let Some(Ok(Some(profile))) = loaded.folder.as_ref().map(|folder| Profile::read(folder))
            && let Ok(said) = profile.options()
        {
            self.reading = self.reading.over(&said);
            self.reading.exclude.sort();
            self.reading.exclude.dedup();
        }
        let again = self.campaign.as_ref().is_some_and(|c| c.paths == loaded.paths);
        let has_same_samples = self.campaign.as_ref().is_some_and(|c| c.has_same_samples(&loaded));
        match change {
            Some(change) => {
                if matches!(change, settings::Change::Correct(_)) {
                    self.forget_future();
                    self.model.iter_mut().for_each(Tuned::forget_future);
                }
                self.corrections.complete(change);
                // Options that the user changed without reading again stay in the panel.
                self.reading = Options { settings: self.reading.settings.clone(), ..edited };
            }
            None => self.corrections.restart(&self.reading.settings, again),
        }
        let names = |of: &Loaded, chosen: &BTreeSet<usize>| -> BTreeSet<String> {
            chosen.iter().filter_map(|k| of.campaign.records.get(*k)).map(|r| r.name.clone()).collect()
        };
        let by_name = |names: &BTreeSet<String>| -> BTreeSet<usize> {
            let records = loaded.campaign.records.iter().enumerate();
            records.filter(|(_, r)| names.contains(&r.name)).map(|(k, _)| k).collect()
        };
        (self.selected, self.unticked) = match (&self.campaign, again) {
            (Some(before), true) => (by_name(&names(before, &self.selected)), by_name(&names(before, &self.unticked))),
            _ => (BTreeSet::new(), BTreeSet::new()),
        };
        if self.selected.is_empty() {
            self.selected = first_look(&loaded.campaign.records);
        }
        if !again {
            self.reference = None;
        }
        // If only settings differ, the results still belong to these tests. They are then marked as old, until an undo.
        if !has_same_samples {
            let (fit, family_fit) = (self.results.fit.take(), self.results.family_fit.take());
            self.results = Results { fit, family_fit, ..Results::default() };
            self.read += 1;
        }
        self.study = None;
        self.simulated = None;
        self.identified = None;
        self.campaign = Some(Arc::new(loaded));
        self.see_as_the_fit_saw();
        self.generation += 1;
        self.order(false);
        self.order_responses();
    }

    /// Replaces the model by the improved model of the last diagnosis.
    pub fn take_improved(&mut self) {
        let text = self.improved_text();
        match text.map(Tuned::identified) {
            Some(Ok(model)) => self.take_model(model),
            Some(Err(error)) => self.complain(Sentence::as_it_is(error)),
            None => {}
        }
    }

    /// Returns the parameters of a test's damper with an additional effect, or `None` if the setting of the test changes.
    pub fn with_effect(&self, record: &Record, element: Element, strength: f64) -> Option<Params> {
        Some(model::with_prior(&self.dampers()?.params_of(record)?, element, strength))
    }

    /// Returns the estimates of the last fit.
    pub fn estimates(&self) -> &[Estimate] {
        self.results.fit.as_ref().map_or(&[], |f| &f.found.fit.estimates)
    }
}

/// Returns the folder that contains a file `campaign.toml`, because this file describes the folder's records. Returns any other path
/// unchanged.
fn profile_stands_for_its_folder(path: &Path) -> PathBuf {
    if path.file_name().is_some_and(|n| n == dashpot_records::profile::FILE) && path.is_file() {
        return dashpot_records::profile::folder_of(path);
    }
    path.to_owned()
}

/// Selects the tests for the first display: up to eight tests of the amplitude with most tests, like a run on a dyno. Selects the first test
/// if all tests are slow or without cycles.
fn first_look(records: &[Record]) -> BTreeSet<usize> {
    let grid = matrix::Grid::new(records, matrix::Across::Velocity);
    let row = |k: usize| -> Vec<usize> { (0..grid.columns.len()).flat_map(|c| grid.cell(k, c).to_vec()).collect() };
    let best = (0..grid.rows.len()).map(row).max_by_key(Vec::len).unwrap_or_default();
    /// Largest number of loops that the first display shows, because more are not distinguishable in one plot.
    const LOOPS: usize = 8;
    if best.is_empty() { (0..records.len().min(1)).collect() } else { best.into_iter().take(LOOPS).collect() }
}
