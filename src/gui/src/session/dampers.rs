//! Selection of the damper of each test: the damper on screen, or the damper at the test's own setting.

use crate::session::campaign::Loaded;
use dashpot_core::family::{Definition, Family};
use dashpot_core::{Model, Params};
use dashpot_identification::model_file::prepared_family;
use dashpot_records::smoothing::Motion;
use dashpot_records::{Record, is_same_setting};
use dashpot_simulation::own_setting::OwnSetting;
use dashpot_simulation::prediction::{predict, predict_family};

/// The adjustable damper to which the parameter values on screen belong.
#[derive(Debug, Clone, PartialEq)]
struct Over {
    damper: Box<Definition>,
    /// Setting to which the parameter values on screen belong.
    at: f64,
    /// Whether the user tuned the parameter values at this setting.
    is_tuned: bool,
}

/// The dampers of all tests.
#[derive(Debug, Clone, PartialEq)]
pub struct Dampers {
    /// Parameter values on screen.
    params: Params,
    /// The adjustable damper, if tests have their own settings.
    over: Option<Over>,
}

/// The damper of one test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TestDamper {
    /// The damper on screen.
    Shown,
    /// The damper at the test's own constant setting.
    AtSetting(f64),
    /// The adjustable damper, with a setting that changes within the test.
    Changing,
}

impl Dampers {
    /// Makes dampers that use the parameter values on screen for all tests.
    pub fn shown(params: Params) -> Dampers {
        Dampers { params, over: None }
    }

    /// Makes dampers that use each test's own setting.
    ///
    /// The parameter values on screen, `params`, apply to tests without a setting. Tuned values also apply to tests at the setting `at`, at
    /// which they were tuned.
    pub fn over_setting(params: Params, damper: Definition, at: f64) -> Dampers {
        let is_tuned = damper.params_at(at) != params;
        Dampers { params, over: Some(Over { damper: Box::new(damper), at, is_tuned }) }
    }

    /// Returns the parameter values on screen.
    pub fn params(&self) -> &Params {
        &self.params
    }

    /// Returns the damper of a test.
    pub fn of_test(&self, record: &Record) -> TestDamper {
        let Some(over) = &self.over else { return TestDamper::Shown };
        match OwnSetting::find(&over.damper.axis, record) {
            OwnSetting::Changing => TestDamper::Changing,
            OwnSetting::Constant(value) if !over.is_tuned || !is_same_setting(value, over.at) => {
                TestDamper::AtSetting(value)
            }
            _ => TestDamper::Shown,
        }
    }

    /// Returns whether a test belongs to the setting of the parameter values on screen: it has this setting, or no setting.
    pub fn is_at_shown(&self, record: &Record) -> bool {
        let Some(over) = &self.over else { return true };
        match OwnSetting::find(&over.damper.axis, record) {
            OwnSetting::Changing => false,
            OwnSetting::Constant(value) => is_same_setting(value, over.at),
            OwnSetting::Unstated => true,
        }
    }

    /// Returns the parameters of a test's damper, or `None` if the setting of the test changes.
    pub fn params_of(&self, record: &Record) -> Option<Params> {
        match (self.of_test(record), &self.over) {
            (TestDamper::AtSetting(value), Some(over)) => Some(over.damper.params_at(value)),
            (TestDamper::Changing, _) => None,
            _ => Some(self.params),
        }
    }

    /// Returns the constant settings at which tests are simulated, in increasing order, with the parameters at each setting.
    pub fn settings(&self, records: &[Record]) -> Vec<(f64, Params)> {
        let Some(over) = &self.over else { return Vec::new() };
        let own = records.iter().filter_map(|record| match self.of_test(record) {
            TestDamper::AtSetting(value) => Some(value),
            _ => None,
        });
        let mut all: Vec<f64> = own.collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all.into_iter().map(|value| (value, over.damper.params_at(value))).collect()
    }

    /// Returns whether the parameter values on screen affect one of these tests.
    pub fn uses_shown(&self, records: &[&Record]) -> bool {
        records.iter().any(|record| self.of_test(record) == TestDamper::Shown)
    }

    /// Prepares the dampers of these tests for simulation. Returns `None` if one of them is not a valid model.
    pub fn prepare(&self, records: &[Record]) -> Option<PreparedDampers<'_>> {
        let shown = Model::new(&self.params).ok()?;
        let own = self
            .settings(records)
            .into_iter()
            .map(|(setting, params)| Some(AtSetting { setting, model: Model::new(&params).ok()?, params }));
        let own: Option<Vec<AtSetting>> = own.collect();
        let changes = records.iter().any(|record| self.of_test(record) == TestDamper::Changing);
        let family = match (&self.over, changes) {
            (Some(over), true) => Some(prepared_family(&over.damper).ok()?),
            _ => None,
        };
        Some(PreparedDampers { dampers: self, shown, own: own?, family })
    }
}

/// The damper at a setting, ready for simulation.
struct AtSetting {
    setting: f64,
    params: Params,
    model: Model,
}

/// Dampers ready for simulation.
pub struct PreparedDampers<'a> {
    dampers: &'a Dampers,
    shown: Model,
    own: Vec<AtSetting>,
    family: Option<Box<Family>>,
}

impl PreparedDampers<'_> {
    /// Computes the forces along `record`, which is a part or the whole of the test with index `test`. Returns no forces if the damper of
    /// the test was not prepared.
    pub fn predict(&self, loaded: &Loaded, test: usize, record: &Record, motion: &Motion) -> Vec<f64> {
        let warm = |model: &Model, params: &Params| predict(model, record, motion, loaded.warm.rise(params, test));
        match self.dampers.of_test(&loaded.campaign.records[test]) {
            TestDamper::AtSetting(value) => match self.own.iter().find(|of| of.setting == value) {
                Some(of) => warm(&of.model, &of.params),
                None => Vec::new(),
            },
            TestDamper::Changing => {
                self.family.as_ref().map_or_else(Vec::new, |family| predict_family(family, record, motion))
            }
            TestDamper::Shown => warm(&self.shown, &self.dampers.params),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::number;
    use dashpot_records::{Setting, SettingSignal};

    fn record(value: Option<f64>) -> Record {
        let setting = value.map(|value| Setting { name: "current".into(), unit: "A".into(), value });
        Record { setting, ..Record::default() }
    }

    #[test]
    fn each_test_has_the_damper_of_its_own_setting() {
        let text = "format = 1\nelements = [\"fv_curve\", \"gas_preload\"]\nsetting = [0.0, 1.0]\nsetting_name = \"current\"\n\
                    gas_force = [80.0, 100.0]\n";
        let file = dashpot_identification::model_file::family_of_text(text, "f.toml".as_ref()).unwrap();
        let damper = file.definition();
        let gas = |params: Option<Params>| params.map(|params| params.number(number!("gas_force")));
        let at_zero = Dampers::over_setting(damper.params_at(0.0), damper, 0.0);
        let signal = SettingSignal::new("current", "A", &[0.0, 1.0]);
        let changing = Record { setting_signal: Some(signal), ..Record::default() };
        for (record, expected) in [(record(Some(1.0)), Some(100.0)), (record(None), Some(80.0)), (changing, None)] {
            assert_eq!(gas(at_zero.params_of(&record)), expected);
        }
        assert!((gas(at_zero.params_of(&record(Some(0.5)))).unwrap() - 90.0).abs() < 1e-9);
        assert_eq!(at_zero.settings(&[record(Some(1.0)), record(None), record(Some(1.0))]).len(), 1);
        // A setting of another quantity does not apply.
        let clicks = Setting { name: "clicks".into(), unit: String::new(), value: 1.0 };
        assert_eq!(gas(at_zero.params_of(&Record { setting: Some(clicks), ..Record::default() })), Some(80.0));
        // Tuned values apply only at the setting at which they were tuned.
        let mut tuned = damper.params_at(1.0);
        tuned.set(number!("gas_force"), 150.0).unwrap();
        let tuned = Dampers::over_setting(tuned, damper, 1.0);
        assert_eq!(gas(tuned.params_of(&record(Some(1.0)))), Some(150.0));
        assert_eq!(gas(tuned.params_of(&record(Some(0.0)))), Some(80.0));
        assert_eq!(gas(Dampers::shown(damper.params_at(0.0)).params_of(&record(Some(1.0)))), Some(80.0));
    }
}
