//! Everything the window knows and can do, without a window: what is open, what is chosen, what is under way.
//!
//! | file | what |
//! |---|---|
//! | [`campaign`] | the records that are open |
//! | [`dampers`], [`comparison`] | the damper of each test, and the ticked tests beside its forces |
//! | [`model`], [`history`] | the model that is tuned, with undo |
//! | [`simulation`] | its forces for every test, computed beside the window |
//! | [`tasks`] | long work with progress and cancel |
//! | [`verbs`] | fit, validate, diagnose |
//! | [`outputs`], [`exports`] | everything that is written |
//! | [`answers`] | what the verbs found, and whether it is of what is on screen |
//! | [`replacing`] | another model in the place of this one, with undo |
//! | [`matrix`], [`study`] | the error matrix, one number at several values |
//! | [`two_ways`] | gas and drag of a cycle |
//! | [`velocities`] | forces at peak velocities and at given ones |
//! | [`valve`] | how the valve of a damper over a setting answers a step |
//! | [`drawing`] | the drawing of the damper, and what the model says by it |
//! | [`recent`] | campaigns that were open lately |

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
use dashpot_records::{Options, Profile, Record, Unusable};
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

/// Called from any thread when there is something new to show.
pub type Waker = Arc<dyn Fn() + Send + Sync>;

/// What was said last.
#[derive(Debug, Clone)]
pub struct Message {
    /// The sentence.
    pub text: Sentence,
    /// Whether something went wrong.
    pub wrong: bool,
}

/// Everything that is open.
pub struct Session {
    /// The records.
    pub campaign: Option<Arc<Loaded>>,
    /// Another campaign of the same tests, to compare with.
    pub reference: Option<Arc<Loaded>>,
    /// The model.
    pub model: Option<Tuned>,
    /// Tests that are drawn.
    pub selected: BTreeSet<usize>,
    /// Tests that fit, validation and diagnosis leave out.
    pub unticked: BTreeSet<usize>,
    /// Whether each test is compared with a damper over a setting at its own setting.
    pub own_settings: bool,
    /// The model's forces, newest.
    pub simulated: Option<Arc<Simulated>>,
    /// Forces of the identified model, to compare with.
    pub identified: Option<Arc<Simulated>>,
    /// Results of the verbs.
    pub results: Results,
    /// How the force of the open tests answers steps of the setting.
    pub responses: valve::Responses,
    /// The drawing of the damper.
    pub drawing: Option<drawing::Drawing>,
    /// Whether it was opened since the window looked last.
    pub is_drawing_new: bool,
    /// A family of loops.
    pub study: Option<Study>,
    /// What was said last.
    pub message: Option<Message>,
    /// Campaigns that were open lately.
    pub recent: Recent,
    /// How the records are to be read, as set by hand.
    pub reading: Options,
    /// Goes up with everything that plots show.
    pub generation: u64,
    /// Work under way.
    pub task: Option<Task>,
    /// A model that waits for the user's leave to take the place of the one on screen.
    pub pending: Option<replacing::Replacement>,
    /// Whose answer came since the window looked last.
    pub arrived: Option<Kind>,
    others: replacing::Others,
    /// How often records were read.
    read: u64,
    simulator: Simulator,
    waker: Waker,
    /// When a slider moved last, while a full computation is due.
    moving: Option<Instant>,
}

/// How long a slider has to rest before all cycles of all tests are computed.
const REST: std::time::Duration = std::time::Duration::from_millis(250);

impl Session {
    /// Nothing is open.
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
            read: 0,
            simulator: Simulator::new(waker.clone()),
            waker,
            moving: None,
        }
    }

    /// Says something.
    pub fn say(&mut self, text: impl Into<String>) {
        self.message = Some(Message { text: Sentence::as_it_is(text.into()), wrong: false });
    }

    /// Says what went wrong.
    pub fn complain(&mut self, text: Sentence) {
        self.message = Some(Message { text, wrong: true });
    }

    /// Opens whatever was dropped or named: model files, files of dimensions, record files and folders.
    pub fn open(&mut self, paths: &[PathBuf]) {
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
            self.open_records(records, Options::default());
        }
        if let Some(drawing) = drawings.last() {
            self.open_drawing(drawing);
        }
    }

    /// Reads records beside the window.
    pub fn open_records(&mut self, paths: Vec<PathBuf>, options: Options) {
        let paths = paths.iter().map(|p| profile_stands_for_its_folder(p)).collect();
        self.begin(Kind::Read, move |report| {
            Loaded::read(paths, options, report).map(Outcome::Read).map_err(|e| e.sentence())
        });
    }

    /// Reads records to compare with, as the open ones were read.
    pub fn open_reference(&mut self, paths: Vec<PathBuf>) {
        let options = self.reading.clone();
        self.begin(Kind::ReadReference, move |report| {
            Loaded::read(paths, options, report).map(Outcome::Reference).map_err(|e| e.sentence())
        });
    }

    /// Reads the records again, with what was set by hand.
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

    /// Shows a model; its forces are computed anew.
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

    /// Takes out of the open records what the model's fit found them to be off by, as the verbs of the command do.
    ///
    /// A model without such a finding gets them as they were read.
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
            // Records in a unit of another kind state no setting of this damper.
            let _ = restate_settings(axis, records.iter_mut().chain(&mut of_reference));
        }
        let note = model.identification.right(records.iter_mut().chain(&mut of_reference));
        let reference = others.map(|others| Arc::new(others.seen_as(of_reference, note.clone())));
        self.campaign = Some(Arc::new(own.seen_as(records, note)));
        self.reference = reference;
        self.generation += 1;
    }

    /// Where the user works: the folder of the records, or that of the model.
    pub fn folder(&self) -> Option<PathBuf> {
        let records = self.campaign.as_ref().and_then(|loaded| {
            let beside = || loaded.paths.first().and_then(|path| path.parent()).map(Path::to_owned);
            loaded.folder.clone().or_else(beside)
        });
        let model = || self.model.as_ref()?.path.as_ref()?.parent().map(Path::to_owned);
        let folder = std::path::absolute(records.or_else(model)?).ok()?;
        folder.is_dir().then_some(folder)
    }

    /// Whether the verbs have something to work on.
    pub fn has_records(&self) -> bool {
        self.campaign.is_some()
    }

    /// Begins work where none is under way; whether it did.
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

    /// Tells the work under way to stop.
    pub fn cancel(&self) {
        if let Some(task) = &self.task {
            task.cancel();
        }
    }

    /// The ticked records.
    pub fn ticked(&self) -> Vec<usize> {
        let count = self.campaign.as_ref().map_or(0, |c| c.campaign.records.len());
        (0..count).filter(|k| !self.unticked.contains(k)).collect()
    }

    /// A record by its number.
    pub fn record(&self, test: usize) -> Option<&Record> {
        self.campaign.as_ref()?.campaign.records.get(test)
    }

    /// Whether something would be lost by closing: work under way, or values that are not saved.
    pub fn would_lose(&self) -> bool {
        self.task.is_some() || self.is_unsaved()
    }

    /// Whether values are not saved.
    pub fn is_unsaved(&self) -> bool {
        self.model.as_ref().is_some_and(Tuned::is_unsaved)
    }

    /// Changes the model; the loops follow at once, all cycles of all tests when it rests.
    pub fn tune(&mut self, change: impl FnOnce(&mut Tuned) -> bool) {
        if self.step(change) {
            self.forget_future();
        }
    }

    /// Goes to the damper at another setting, where the model depends on one.
    pub fn move_to(&mut self, setting: f64) {
        if self.step(|model| model.move_to(setting)) {
            // Forces at the setting before are compared with nothing.
            self.identified = None;
        }
    }

    /// Puts each test at its own setting, or all at the one on screen.
    pub fn use_own_settings(&mut self, own: bool) {
        if self.own_settings != own {
            self.own_settings = own;
            self.identified = None;
            self.order(false);
            self.generation += 1;
        }
    }

    /// The damper of each test; none without a model.
    pub fn dampers(&self) -> Option<Dampers> {
        let model = self.model.as_ref()?;
        Some(model.dampers(model.params(), self.own_settings))
    }

    /// Whether some open test states the setting that the model depends on.
    pub fn has_own_settings(&self) -> bool {
        let (Some(model), Some(loaded)) = (&self.model, &self.campaign) else { return false };
        let dampers = model.dampers(&model.identified, true);
        loaded.campaign.records.iter().any(|record| dampers.of_test(record) != TestDamper::Shown)
    }

    /// Changes the model, or goes a step back or forth in it.
    fn step(&mut self, change: impl FnOnce(&mut Tuned) -> bool) -> bool {
        let Some(model) = &mut self.model else { return false };
        let changed = change(model);
        if changed {
            self.moving = Some(Instant::now());
            self.order(true);
        }
        changed
    }

    /// Orders the forces of the model as it is.
    pub fn order(&mut self, quick: bool) {
        let (Some(model), Some(loaded)) = (&self.model, &self.campaign) else { return };
        let dampers = model.dampers(model.params(), self.own_settings);
        self.simulator.order(Wanted { dampers, loaded: loaded.clone(), quick });
    }

    /// Takes over what threads have finished. Returns whether work is under way that the window should look at again soon.
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
                // Forces of the identified model alone are not those of the tuned one.
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
            }
            Some(Standing::Done(result)) => {
                self.task = None;
                match result {
                    Ok(outcome) => self.take(outcome),
                    Err(error) => self.complain(error),
                }
            }
        }
        let responding = self.poll_responses();
        responding || self.task.is_some() || self.moving.is_some() || self.simulator.is_busy()
    }

    /// The identified model's forces are computed too where the model was tuned before they were there.
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
                self.see_as_the_fit_saw();
                self.generation += 1;
            }
            Outcome::Fitted(fit) => {
                self.fit_is_done(Replacement::Fitted(fit));
                self.arrived = Some(Kind::Fit);
            }
            Outcome::FittedFamily(fit) => {
                self.fit_is_done(Replacement::FittedFamily(fit));
                self.arrived = Some(Kind::Fit);
            }
            Outcome::Validated(validation, basis) => {
                self.results.validation = Some(Finding::of_validation(validation, *basis));
                self.arrived = Some(Kind::Validate);
            }
            Outcome::Diagnosed(diagnosed, basis) => {
                self.results.diagnosis = Some(Finding::of_diagnosis(diagnosed, *basis));
                self.arrived = Some(Kind::Diagnose);
            }
            // They come by a task of their own: see `poll_responses`.
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

    /// Says what was left out of records that were just read; the list of tests names each.
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
        // What is kept beside the records is shown and can be changed.
        self.reading = loaded.options.clone();
        if let Some(Ok(Some(profile))) = loaded.folder.as_ref().map(|folder| Profile::read(folder))
            && let Ok(said) = profile.options()
        {
            self.reading = self.reading.over(&said);
            self.reading.exclude.sort();
            self.reading.exclude.dedup();
        }
        let again = self.campaign.as_ref().is_some_and(|c| c.paths == loaded.paths);
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
        let (fit, family_fit) = (self.results.fit.take(), self.results.family_fit.take());
        self.results = Results { fit, family_fit, ..Results::default() };
        self.read += 1;
        self.study = None;
        self.simulated = None;
        self.identified = None;
        self.campaign = Some(Arc::new(loaded));
        self.see_as_the_fit_saw();
        self.generation += 1;
        self.order(false);
        self.order_responses();
    }

    /// The improved model of the diagnosis takes the place of the model.
    pub fn take_improved(&mut self) {
        let text = self.improved_text();
        match text.map(Tuned::identified) {
            Some(Ok(model)) => self.take_model(model),
            Some(Err(error)) => self.complain(Sentence::as_it_is(error)),
            None => {}
        }
    }

    /// Values of a test's damper with an effect more; none where its setting changes.
    pub fn with_effect(&self, record: &Record, element: Element, strength: f64) -> Option<Params> {
        Some(model::with_prior(&self.dampers()?.params_of(record)?, element, strength))
    }

    /// What the last fit says of its numbers.
    pub fn estimates(&self) -> &[Estimate] {
        self.results.fit.as_ref().map_or(&[], |f| &f.found.fit.estimates)
    }
}

/// A profile that was dropped stands for the records beside it.
fn profile_stands_for_its_folder(path: &Path) -> PathBuf {
    if path.file_name().is_some_and(|n| n == dashpot_records::profile::FILE) && path.is_file() {
        return dashpot_records::profile::folder_of(path);
    }
    path.to_owned()
}

/// What is drawn first: all speeds of the amplitude with most tests, as a dyno shows a run.
fn first_look(records: &[Record]) -> BTreeSet<usize> {
    let grid = matrix::Grid::new(records, matrix::Across::Velocity);
    let row = |k: usize| -> Vec<usize> { (0..grid.columns.len()).flat_map(|c| grid.cell(k, c).to_vec()).collect() };
    let best = (0..grid.rows.len()).map(row).max_by_key(Vec::len).unwrap_or_default();
    /// Loops beyond this are a tangle.
    const LOOPS: usize = 8;
    if best.is_empty() { (0..records.len().min(1)).collect() } else { best.into_iter().take(LOOPS).collect() }
}
