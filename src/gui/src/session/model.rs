//! The model on screen: its tuned and identified values, and the undo steps.

use crate::session::dampers::Dampers;
use crate::session::history::History;
use dashpot_core::family::{Axis, Definition};
use dashpot_core::parameter::{self, Element, List, Number, Row, Shape};
use dashpot_core::{Model, Params};
use dashpot_estimation::priors::{self, Distribution};
use dashpot_estimation::scale::Scale;
use dashpot_identification::family::at_setting;
use dashpot_identification::model_file::{self, Identification, Interval, ModelFile};
use dashpot_messages::Sentence;
use dashpot_records::restrict;
use std::path::{Path, PathBuf};

/// Index of the start setting among the numbers of a setting axis.
const START: usize = 0;

/// An open model file.
#[derive(Clone)]
pub struct Tuned {
    /// Path of the file that was read or last saved.
    pub path: Option<PathBuf>,
    /// Parameter values as read or fitted. Tuned values are compared with them, and a reset restores them.
    pub identified: Params,
    /// Results of the fit. For an adjustable damper, they contain the results of all settings.
    pub identification: Identification,
    /// Results of the fit that hold at the setting of the values; `None` for an ordinary damper.
    at_setting: Option<Identification>,
    /// Remark on an adjustable damper whose parameters depend on the setting in such a way that a change of the setting may do work.
    energy: Option<Sentence>,
    /// Indices of the parameters that the file contains.
    given: Vec<usize>,
    /// The adjustable damper and the setting of the parameter values; `None` for an ordinary damper.
    over: Option<(Definition, f64)>,
    /// Text of the file that was read, or that a fit or a diagnosis made. It is valid while no value is tuned.
    text: Option<String>,
    /// Current and earlier parameter values.
    history: History<Params, Change>,
    /// Parameter values as last saved, or `None` if the model was never saved.
    saved: Option<Params>,
    /// Reason why the last change was rejected, or `None` if it was accepted.
    pub rejected: Option<String>,
}

/// Subject of a change. Successive changes of one subject are undone together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    /// A value of a parameter: the index in the parameter table, and the index of the entry in a list.
    Value(usize, usize),
    /// An element switched on or off.
    Element(Element),
    /// All values.
    Whole,
}

impl Tuned {
    /// Reads a model file.
    ///
    /// # Errors
    /// The file cannot be read or is not a model file.
    pub fn read(path: &Path) -> Result<Tuned, String> {
        let file = model_file::read_family(path).map_err(|e| e.to_string())?;
        let text = dashpot_records::read_small_text(path).ok();
        let model = Tuned::new(file);
        Ok(Tuned { path: Some(path.to_owned()), saved: Some(model.identified), text, ..model })
    }

    fn new(file: ModelFile) -> Tuned {
        // The window shows an adjustable damper at one setting, at first the start setting.
        let over = file.axis.is_some().then(|| {
            let (mut damper, start) = (file.definition(), file.axis.start());
            // A missing start setting is NaN, which is unequal to itself and would disturb comparisons of dampers. So it is replaced by the
            // start of the axis, which is always valid.
            let _ = damper.axis.set_number(START, start);
            (damper, start)
        });
        let params = over.as_ref().map_or(file.params, |(damper, setting)| damper.params_at(*setting));
        let at_setting = over.as_ref().map(|(_, setting)| at_setting(&file, *setting).identification);
        let energy = file.remark_on_energy();
        let ModelFile { identification, specified: given, .. } = file;
        Tuned {
            path: None,
            over,
            identified: params,
            identification,
            at_setting,
            energy,
            given,
            text: None,
            history: History::new(params),
            saved: None,
            rejected: None,
        }
    }

    /// Makes an unsaved model from the text of a model file that a fit or a diagnosis made.
    ///
    /// # Errors
    /// The text is not a model file. Fits and diagnoses always make a valid one.
    pub fn identified(text: String) -> Result<Tuned, String> {
        let file = model_file::family_of_text(&text, Path::new("model")).map_err(|e| e.to_string())?;
        Ok(Tuned { text: Some(text), ..Tuned::new(file) })
    }

    /// Returns the remarks on the model: parameters without effect, and a dependence on the setting through which a change of the setting
    /// may do work.
    pub fn remarks(&self) -> Vec<Sentence> {
        self.idle().into_iter().chain(self.energy.clone()).collect()
    }

    /// Returns one sentence for each disabled element whose entries in the file have no effect.
    pub fn idle(&self) -> Vec<Sentence> {
        dashpot_identification::remarks::idle(&self.given, self.params())
    }

    /// Returns the name of the model's file, or an empty text if the model was never saved.
    pub fn name(&self) -> String {
        let file = self.path.as_ref().and_then(|p| p.file_name());
        file.map_or_else(String::new, |n| n.to_string_lossy().into_owned())
    }

    /// Returns the axis of an adjustable damper and the setting of the parameter values, or `None` for an ordinary damper.
    pub fn over_setting(&self) -> Option<(&Axis, f64)> {
        self.over.as_ref().map(|(damper, setting)| (&damper.axis, *setting))
    }

    /// Returns the adjustable damper of the file, or `None` for an ordinary damper.
    pub fn definition(&self) -> Option<&Definition> {
        self.over.as_ref().map(|(damper, _)| damper)
    }

    /// Returns the file of the adjustable damper over all settings, or `None` for an ordinary damper.
    pub fn whole_file(&self) -> Option<ModelFile> {
        let Definition { params, axis } = *self.definition()?;
        Some(ModelFile::new(params, axis, self.identification.clone(), self.given.clone()))
    }

    /// Returns the damper of each test with the values `params` at the current setting. If `own` is set, each test has its own setting.
    pub fn dampers(&self, params: &Params, own: bool) -> Dampers {
        match &self.over {
            Some((damper, at)) if own => Dampers::over_setting(*params, *damper, *at),
            _ => Dampers::shown(*params),
        }
    }

    /// Moves to the damper at another setting. A tuned model keeps its setting, because its values belong to that setting. Returns whether
    /// the setting changed.
    pub fn move_to(&mut self, setting: f64) -> bool {
        if self.is_tuned() {
            return false;
        }
        let Some((damper, at)) = &mut self.over else { return false };
        if *at == setting {
            return false;
        }
        *at = setting;
        let params = damper.params_at(setting);
        // The values at the other setting come from the same model file, so there is no undo step and nothing to save.
        let is_saved = self.saved.as_ref() == Some(&self.identified);
        self.identified = params;
        self.at_setting = self.whole_file().map(|file| at_setting(&file, setting).identification);
        self.history = History::new(params);
        self.rejected = None;
        if is_saved {
            self.saved = Some(params);
        }
        true
    }

    /// Returns the current values.
    pub fn params(&self) -> &Params {
        self.history.now()
    }

    /// Makes the model of the current values. Returns `None` if they are not valid.
    pub fn model(&self) -> Option<Model> {
        Model::new(self.params()).ok()
    }

    /// Returns the model on screen as the contents of a model file. For an adjustable damper, this is the ordinary damper at the current
    /// setting.
    pub fn file(&self) -> ModelFile {
        let (Some(whole), Some((_, setting))) = (self.whole_file(), self.over_setting()) else {
            let (identification, specified) = (self.identification.clone(), self.given.clone());
            return ModelFile::new(*self.params(), Axis::NONE, identification, specified);
        };
        let of = at_setting(&whole, setting);
        let mut file = ModelFile::new(*self.params(), Axis::NONE, of.identification, of.specified);
        file.edited.extend(of.edited);
        file
    }

    /// Returns whether closing would lose values.
    pub fn is_unsaved(&self) -> bool {
        self.saved.as_ref() != Some(self.params())
    }

    /// Returns whether the parameter values differ from the identified values.
    pub fn is_tuned(&self) -> bool {
        self.identified != *self.params()
    }

    /// Sets the parameter values if they make a valid model. Otherwise stores the reason in `rejected`. Returns whether the values changed.
    pub fn change(&mut self, change: Change, params: Params) -> bool {
        match Model::new(&params) {
            Ok(_) => {
                self.rejected = None;
                self.history.change(change, params)
            }
            Err(fault) => {
                let name = parameter::table().nth(fault.parameter as usize).map_or("", |row| row.parameter.name);
                self.rejected = Some(format!("{name} {}", fault.reason.text()));
                false
            }
        }
    }

    /// Sets a parameter, or an entry of a list, within the bounds of the parameter. Returns whether the values changed.
    pub fn set(&mut self, row: &Row, entry: usize, value: f64) -> bool {
        let p = row.parameter;
        let mut params = *self.params();
        let value = restrict(value, p.low, p.high);
        let done = match p.shape {
            Shape::List(_) => {
                let mut list = params.get(row).to_vec();
                let Some(place) = list.get_mut(entry) else { return false };
                *place = value;
                List::try_from(*row).and_then(|of| params.set_list(of, &list))
            }
            _ => Number::try_from(*row).and_then(|of| params.set(of, value)),
        };
        done.is_ok() && self.change(Change::Value(row.index, entry), params)
    }

    /// Enables or disables an element.
    pub fn switch(&mut self, element: Element, on: bool) -> bool {
        let mut params = *self.params();
        params.enable(element, on);
        let changed = self.change(Change::Element(element), params);
        self.seal();
        changed
    }

    /// Ends the current change, so that the next change has its own undo step.
    pub fn seal(&mut self) {
        self.history.seal();
    }

    /// Undoes the last change. Returns whether there was one.
    pub fn undo(&mut self) -> bool {
        self.rejected = None;
        self.history.undo()
    }

    /// Redoes the last undone change. Returns whether there was one.
    pub fn redo(&mut self) -> bool {
        self.rejected = None;
        self.history.redo()
    }

    /// Discards the redo steps.
    pub fn forget_future(&mut self) {
        self.history.forget_future();
    }

    /// Returns the serial numbers of the changes that undo would undo and redo would redo.
    pub fn steps(&self) -> (Option<u64>, Option<u64>) {
        self.history.steps()
    }

    /// Resets to the identified values in one undo step.
    pub fn reset(&mut self) -> bool {
        self.history.seal();
        let changed = self.change(Change::Whole, self.identified);
        self.history.seal();
        changed
    }

    /// Returns the text of the model file.
    ///
    /// An untuned model keeps the text of its file. Otherwise the text contains the values and a note on manual tuning.
    pub fn text(&self) -> String {
        match &self.text {
            Some(text) if !self.is_tuned() => text.clone(),
            _ => self.tuned_text(),
        }
    }

    fn tuned_text(&self) -> String {
        // Parameters of disabled elements stay in the file, because a reader of the file may enable these elements.
        let flat = model_file::flat_keeping(self.params(), &self.given, |row| {
            let p = row.parameter;
            let unit = if p.unit == "-" { String::new() } else { format!("{}; ", p.unit) };
            let before = self.identified.get(row);
            let now = self.params().get(row);
            let changed = match p.shape {
                Shape::Scalar if before != now => format!("; tuned by hand, was {:?}", before[0]),
                _ if before != now => "; tuned by hand".to_owned(),
                _ => String::new(),
            };
            format!("{unit}{}{changed}", p.meaning)
        });
        // The results of the fit stay in the text: its tests, its FV curve, and the intervals of the identified values. For an adjustable
        // damper, these results apply to all settings, so they are omitted.
        let text = self.text.as_ref().filter(|_| self.over.is_none());
        let tables = text.and_then(|t| t.find("\n[identification]").map(|at| &t[at..]));
        let (announced, tables) = match tables {
            Some(tables) => ("[identification] are the damper; what follows is for people and tools", tables),
            None => ("[end] are the damper", "\n[end]\n"),
        };
        let at = self.over.as_ref().map_or_else(String::new, |(damper, setting)| {
            let name = if damper.axis.name().is_empty() { "setting" } else { damper.axis.name() };
            format!("# Of a damper over a setting, at {name} = {setting} {}\n", damper.axis.unit())
        });
        format!(
            "# A damper tuned by hand in dashpot. SI units; extension (rebound) and tension positive.\n\
             # The lines up to {announced}.\n{at}\n{flat}{tables}"
        )
    }

    /// Records that the values were saved to a file.
    pub fn saved_to(&mut self, path: &Path, params: Params) {
        self.path = Some(path.to_owned());
        self.saved = Some(params);
    }

    /// Returns whether the fit did not identify a parameter or an entry of a list.
    pub fn is_loose(&self, name: &str, entry: Option<usize>) -> bool {
        let identifier = entry.map_or_else(|| name.to_owned(), |k| format!("{name}[{k}]"));
        self.shown_identification().not_identified.contains(&identifier)
    }

    /// Returns the results of the fit that hold for the values on screen.
    fn shown_identification(&self) -> &Identification {
        self.at_setting.as_ref().unwrap_or(&self.identification)
    }

    /// Returns whether a fit made the file. The values of any other file are not identified.
    pub fn is_of_a_fit(&self) -> bool {
        self.identification.is_of_a_fit()
    }

    /// Returns the identified value of a parameter, or `None` if the fit did not identify it. Without a fit, this is the value in the file.
    pub fn identified_value(&self, row: &Row, entry: usize) -> Option<f64> {
        let p = row.parameter;
        let place = matches!(p.shape, Shape::List(_)).then_some(entry);
        let by_hand = !self.is_of_a_fit();
        let value = self.identified.get(row).get(entry).or(p.default.first()).copied();
        value.filter(|_| !self.is_loose(p.name, place) && (by_hand || self.interval(p.name, entry).is_some()))
    }

    /// Returns the 95 % interval of a parameter from the fit, if there is one.
    pub fn interval(&self, name: &str, entry: usize) -> Option<[f64; 2]> {
        match self.shown_identification().intervals.get(name)? {
            Interval::Number(ends) => Some(*ends),
            Interval::List(all) => all.get(entry).copied(),
        }
        .filter(|[low, high]| low.is_finite() && high.is_finite() && high > low)
    }
}

/// Range and scale of a slider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// Value at the left end, in the unit of the parameter.
    pub low: f64,
    /// Value at the right end, in the unit of the parameter.
    pub high: f64,
    /// Whether the scale of the slider is logarithmic.
    pub factors: bool,
}

/// Range of a slider to either side, in standard deviations of the prior. It covers typical dampers.
const SPREADS: f64 = 3.0;

impl Reach {
    /// Computes the range of a slider. The range contains the values within [`SPREADS`] standard deviations of the prior, the interval of
    /// the fit, the identified value and the current value.
    ///
    /// The range lies within the bounds of the parameter table.
    pub fn new(row: &Row, scale: Scale, identified: f64, now: f64, interval: Option<[f64; 2]>) -> Reach {
        let p = row.parameter;
        let usual = Number::try_from(*row).ok().and_then(|number| priors::distribution(number, scale));
        let (mut low, mut high, factors) = match usual {
            Some(Distribution::Size(median, factor)) => {
                (median / libm::pow(factor, SPREADS), median * libm::pow(factor, SPREADS), true)
            }
            Some(Distribution::Strength(median, factor)) => {
                (median / (10.0 * libm::pow(factor, SPREADS)), median * libm::pow(factor, SPREADS), true)
            }
            Some(usual @ (Distribution::Place(..) | Distribution::Skewed(..))) => {
                let (low, high) = usual.interval(SPREADS);
                (low, high, false)
            }
            None => {
                let size = identified.abs().max(now.abs());
                if size > 0.0 {
                    (identified - 2.0 * size, identified + 2.0 * size, false)
                } else {
                    (p.low.max(-1.0), p.high.min(1.0), false)
                }
            }
        };
        for value in [Some(identified), Some(now), interval.map(|i| i[0]), interval.map(|i| i[1])].into_iter().flatten()
        {
            low = low.min(value);
            high = high.max(value);
        }
        (low, high) = (low.max(p.low), high.min(p.high));
        Reach { low, high, factors: factors && low > 0.0 }
    }

    /// Returns the position of a value on the slider, 0..1.
    pub fn place(&self, value: f64) -> f64 {
        let of = |v: f64| if self.factors { libm::log(v.max(1e-300)) } else { v };
        let (low, high) = (of(self.low), of(self.high));
        if high > low { ((of(value) - low) / (high - low)).clamp(0.0, 1.0) } else { 0.5 }
    }
}

/// Returns the range of a parameter within one standard deviation of its prior. For a strength, the range begins at zero. Returns `None`
/// without a prior.
pub fn prior_band(row: &Row, scale: Scale) -> Option<[f64; 2]> {
    Some(match priors::distribution(Number::try_from(*row).ok()?, scale)? {
        Distribution::Size(median, factor) => [median / factor, median * factor],
        Distribution::Strength(median, factor) => [0.0, median * factor],
        usual @ (Distribution::Place(..) | Distribution::Skewed(..)) => usual.interval(1.0).into(),
    })
}

/// Enables an effect, and sets its parameters to the centers of their priors. The factor `strength` scales strengths. A parameter whose
/// prior has mean zero is set to `strength` standard deviations.
pub fn with_prior(params: &Params, element: Element, strength: f64) -> Params {
    let mut with = *params;
    with.enable(element, true);
    let scale = Scale::from_params(params);
    let rows = parameter::table().filter(|row| row.element() == Some(element));
    for number in rows.filter_map(|row| Number::try_from(row).ok()) {
        let value =
            match priors::distribution(number, scale) {
                Some(Distribution::Size(median, _)) => median,
                Some(Distribution::Strength(median, _)) => strength * median,
                Some(Distribution::Place(mean, deviation) | Distribution::Skewed(mean, _, deviation)) => {
                    if mean == 0.0 { strength * deviation } else { mean }
                }
                None => continue,
            };
        let _ = with.set(number, number.inside(value));
    }
    with
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::number;
    use dashpot_core::parameter::find;

    fn tuned() -> Tuned {
        Tuned::new(ModelFile::new(Params::new(), Axis::NONE, Identification::default(), Vec::new()))
    }

    #[test]
    fn a_damper_over_a_setting_moves_along_it_and_stays_while_it_is_tuned() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("family.toml");
        let text = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\nsetting_unit = \"A\"\n\
                    gas_force = [80.0, 100.0]\n";
        std::fs::write(&path, text).unwrap();
        let mut model = Tuned::read(&path).unwrap();
        let gas = |model: &Tuned| model.params().number(number!("gas_force"));
        assert_eq!(gas(&model), 80.0);
        assert!(model.move_to(0.5) && (gas(&model) - 90.0).abs() < 1e-9);
        assert!(!model.is_tuned() && !model.is_unsaved() && model.text() == text);
        assert!(model.set(number!("gas_force").row(), 0, 95.0) && model.is_tuned());
        assert!(!model.move_to(1.0) && model.over_setting().unwrap().1 == 0.5);
        // The text of a tuned model describes an ordinary damper at this setting.
        let tuned = model.text();
        assert!(tuned.contains("at current = 0.5 A") && !tuned.contains("setting = ["), "{tuned}");
        model.reset();
        assert!(model.move_to(1.0) && gas(&model) == 100.0);
    }

    #[test]
    fn intervals_and_open_numbers_are_those_of_the_setting_on_screen() {
        let text = "format = 1\nelements = [\"fv_curve\", \"coulomb_friction\", \"gas_preload\"]\nsetting = [0.0, 1.0, 2.0]\n\
                    gas_force = 100.0\ncoulomb_force = [20.0, 60.0, 100.0]\n\n[identification]\nnot_identified = [\"coulomb_force@1\"]\n\n\
                    [identification.intervals_over_setting]\ncoulomb_force = [\n    [15.0, 25.0],\n    [60.0, 60.0],\n    [90.0, 110.0],\n]\n";
        let mut model = Tuned::identified(text.to_owned()).unwrap();
        let (friction, gas) = (*number!("coulomb_force").row(), *number!("gas_force").row());
        assert!(model.is_of_a_fit());
        assert_eq!(model.interval("coulomb_force", 0), Some([15.0, 25.0]));
        assert_eq!(model.identified_value(&friction, 0), Some(20.0));
        // No interval in this file applies to all settings, but a fit made the file. So a parameter without an interval is not identified.
        assert_eq!(model.identified_value(&gas, 0), None);
        assert!(model.move_to(1.0) && model.is_loose("coulomb_force", None));
        assert_eq!((model.interval("coulomb_force", 0), model.identified_value(&friction, 0)), (None, None));
        assert!(model.move_to(2.0) && !model.is_loose("coulomb_force", None));
        assert_eq!(model.identified_value(&friction, 0), Some(100.0));
        assert!(!tuned().is_of_a_fit());
    }

    #[test]
    fn a_drag_is_undone_in_one_step_and_two_drags_in_two() {
        let mut tuned = tuned();
        let row = find("series_stiffness").unwrap();
        let first = tuned.params().number(number!("series_stiffness"));
        for value in [1e6, 1.1e6, 1.2e6] {
            assert!(tuned.set(&row, 0, value));
        }
        tuned.seal();
        assert!(tuned.set(&row, 0, 4e6));
        assert!(tuned.undo());
        assert_eq!(tuned.params().number(number!("series_stiffness")), 1.2e6);
        assert!(tuned.undo());
        assert_eq!(tuned.params().number(number!("series_stiffness")), first);
        assert!(!tuned.undo());
        assert!(tuned.redo() && tuned.redo() && !tuned.redo());
        assert_eq!(tuned.params().number(number!("series_stiffness")), 4e6);
        assert!(tuned.reset() && !tuned.is_tuned());
        assert!(tuned.undo() && tuned.is_tuned());
    }

    #[test]
    fn what_makes_no_model_is_refused_and_said() {
        let mut tuned = tuned();
        let row = find("fv_velocity").unwrap();
        let before = *tuned.params();
        // The velocities of a curve must increase.
        let last = tuned.params().get(&row).to_vec().last().copied().unwrap();
        assert!(!tuned.set(&row, 0, last + 1.0));
        assert!(tuned.rejected.as_ref().unwrap().contains("fv_velocity"), "{:?}", tuned.rejected);
        assert_eq!(*tuned.params(), before);
    }

    #[test]
    fn tuned_values_are_written_with_what_they_were_and_read_back() {
        let mut tuned = tuned();
        let row = find("gas_force").unwrap();
        assert!(tuned.set(&row, 0, -210.0));
        let text = tuned.text();
        assert!(text.contains("tuned by hand"), "{text}");
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.toml");
        std::fs::write(&path, &text).unwrap();
        let back = Tuned::read(&path).unwrap();
        assert_eq!(back.params().number(number!("gas_force")), -210.0);
        assert!(!back.is_unsaved() && tuned.is_unsaved());
    }

    #[test]
    fn numbers_of_elements_that_are_off_stay_in_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("m.toml");
        let text = "format = 1\nelements = [\"fv_curve\", \"coulomb_friction\"]\ngas_force = 173.25\nspring_displacement = [-0.1, 0.1]\n\
                    spring_force = [-50.0, 60.0]\ncoulomb_force = 41.5\n";
        std::fs::write(&path, text).unwrap();
        let mut tuned = Tuned::read(&path).unwrap();
        let told: Vec<String> = tuned.idle().iter().map(ToString::to_string).collect();
        assert!(tuned.set(&find("fv_compression_c1").unwrap(), 0, 3000.0));
        // An element that the user disables while the file is open also keeps its parameters.
        assert!(tuned.switch(find("coulomb_force").unwrap().element().unwrap(), false));
        let saved = folder.path().join("saved.toml");
        std::fs::write(&saved, tuned.text()).unwrap();
        let back = Tuned::read(&saved).unwrap();
        assert_eq!(back.params(), tuned.params());
        for line in [
            "gas_force = 173.25 ",
            "spring_displacement = [-0.1, 0.1] ",
            "spring_force = [-50.0, 60.0] ",
            "coulomb_force = 41.5 ",
        ] {
            assert!(tuned.text().contains(line), "{line}: {}", tuned.text());
        }
        // The saved file has no parameters that were missing in the original. It has the notes of the original, and one note on the element
        // that the user disabled.
        assert!(
            !tuned.text().contains("spring_linear") && !tuned.text().contains("viscous_coefficient"),
            "{}",
            tuned.text()
        );
        let after: Vec<String> = back.idle().iter().map(ToString::to_string).collect();
        assert!(told.iter().all(|note| after.contains(note)) && after.len() == told.len() + 1, "{told:?} {after:?}");
    }

    #[test]
    fn sliders_reach_from_the_usual_to_the_value() {
        for row in parameter::table().filter(|r| matches!(r.parameter.shape, Shape::Scalar)) {
            let default = row.parameter.default[0];
            let reach = Reach::new(&row, Scale::CAR, default, default, None);
            assert!(reach.low <= default && default <= reach.high, "{} {reach:?}", row.parameter.name);
            assert!(reach.low.is_finite() && reach.high.is_finite() && reach.low <= reach.high);
            assert!((0.0..=1.0).contains(&reach.place(default)));
        }
    }
}
