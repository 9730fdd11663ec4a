//! Figures of the fit of a damper family, for output as JSON. `dashpot fit --setting --json` writes them, and Python reads them.

use super::actuator::ActuatorFit;
use super::fit::{FamilyEstimate, FamilyFit, FamilyItem, SettingDependence};
use super::left_out::SettingReport;
use crate::Measured;
use dashpot_messages::Sentence;
use dashpot_records::{Campaign, SignFinding, Unusable};
use serde::Serialize;
use std::path::Path;

/// Name, unit and values of the setting of a family.
#[derive(Debug, Clone, Copy, Serialize)]
struct SettingFigures<'a> {
    name: &'a str,
    unit: &'a str,
    grid: &'a [f64],
}

/// All figures of the fit of a family.
#[derive(Debug, Clone, Serialize)]
pub struct FamilyFigures<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    model: Option<&'a Path>,
    setting: SettingFigures<'a>,
    tests: &'a [String],
    /// Estimates of all numbers. A number that depends on the setting appears once for each value of the setting.
    parameters: &'a [FamilyEstimate],
    depends_on_setting: &'a [SettingDependence],
    #[serde(skip_serializing_if = "Option::is_none")]
    actuator: Option<&'a ActuatorFit>,
    inventory: &'a [FamilyItem],
    measured: &'a [Measured],
    /// Errors at each value of the setting, including the errors of the family fitted without that setting.
    settings: &'a [SettingReport],
    notes: &'a [Sentence],
    misfit: f64,
    sign: &'a SignFinding,
    unusable: &'a [Unusable],
}

impl<'a> FamilyFigures<'a> {
    /// Collects the figures of a fit to a campaign. `model` is the path of the written model file.
    pub fn new(fit: &'a FamilyFit, campaign: &'a Campaign, model: Option<&'a Path>) -> FamilyFigures<'a> {
        FamilyFigures {
            model,
            setting: SettingFigures { name: &fit.setting.name, unit: &fit.setting.unit, grid: fit.settings_grid() },
            tests: &fit.tests,
            parameters: &fit.estimates,
            depends_on_setting: &fit.dependences,
            actuator: fit.actuator.as_ref(),
            inventory: &fit.inventory,
            measured: &fit.measured,
            settings: &fit.settings,
            notes: &fit.notes,
            misfit: fit.misfit,
            sign: &campaign.sign,
            unusable: &campaign.unusable,
        }
    }
}
