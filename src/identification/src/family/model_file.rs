//! Model file of a damper family: first the lines that the kernel reads, then tables with the results of the fit.

use super::fit::{FamilyEstimate, FamilyFit};
use crate::intervals::Standing;
use crate::model_file::{
    Account, FvOnly, describe_parameter, flat_family, format_pair, format_points, sources, write_account,
    write_interval, write_origins,
};
use crate::{Estimate, InventoryItem};
use std::fmt::Write as _;

/// Returns the estimates of a parameter at a setting. If `setting` is `None`, returns the estimates of a shared parameter.
fn estimates_of<'f>(fit: &'f FamilyFit, name: &str, setting: Option<f64>) -> Vec<&'f Estimate> {
    let own = fit.estimates.iter().filter(|e| e.estimate.name == name && e.setting == setting);
    own.map(|e| &e.estimate).collect()
}

/// Returns the names of the numbers that all settings share, or of all other numbers if `is_shared` is false. Each name appears once.
fn names(fit: &FamilyFit, is_shared: bool) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = Vec::new();
    for FamilyEstimate { estimate, .. } in fit.estimates.iter().filter(|e| e.setting.is_none() == is_shared) {
        if !names.contains(&estimate.name) {
            names.push(estimate.name);
        }
    }
    names
}

/// Formats the model file of a family.
pub fn write(fit: &FamilyFit) -> String {
    let mut out = String::from(
        "# A damper over a setting, identified by dashpot. SI units; extension (rebound) and tension positive.\n\
         # The lines up to [identification] are the damper; what follows is for people and tools.\n\n",
    );
    out += &flat_family(&fit.damper, |row| describe_parameter(row, &estimates_of(fit, row.parameter.name, None)));
    let not_identified: Vec<String> = fit
        .estimates
        .iter()
        .filter(|e| e.estimate.standing == Standing::NotIdentified)
        .map(|FamilyEstimate { setting, estimate }| {
            let name = estimate.index.map_or(estimate.name.to_owned(), |i| format!("{}[{i}]", estimate.name));
            setting.map_or(name.clone(), |setting| format!("{name}@{setting}"))
        })
        .collect();
    let inventory: Vec<InventoryItem> = fit.inventory.iter().map(|of| of.item.clone()).collect();
    let account = Account {
        tests: &fit.tests,
        fingerprints: &fit.fingerprints,
        not_identified: &not_identified,
        inventory: &inventory,
        notes: &fit.notes,
        sources: sources(fit.estimates.iter().map(|of| &of.estimate)),
        measured: &fit.measured,
        clock_from: fit.clock_from,
    };
    write_account(&mut out, &account);
    out += "\n[identification.intervals]  # 95 %, of what all settings share\n";
    for name in names(fit, true) {
        write_interval(&mut out, name, &estimates_of(fit, name, None), &fit.damper.params);
    }
    for estimate in fit.actuator.iter().flat_map(|fit| &fit.estimates) {
        write_interval(&mut out, estimate.name, &[estimate], &fit.damper.params);
    }
    out += "\n[identification.intervals_over_setting]  # 95 %, of what depends on the setting: one entry for each of its values; equal ends: not identified\n";
    for name in names(fit, false) {
        let entries: Vec<String> = fit
            .settings_grid()
            .iter()
            .enumerate()
            .map(|(index, setting)| {
                let own = estimates_of(fit, name, Some(*setting));
                match own[..] {
                    [estimate @ Estimate { index: None, .. }] => format_pair(Some(estimate), estimate.value),
                    _ => format_points(&own, fit.damper.axis.forces(index).unwrap_or(&[])),
                }
            })
            .collect();
        let _ = writeln!(out, "{name} = [\n    {},\n]", entries.join(",\n    "));
    }
    let shared = names(fit, true).into_iter().map(|name| (name, estimates_of(fit, name, None)));
    write_origins(&mut out, &fit.measured, shared);
    for (setting, curve) in fit.settings_grid().iter().zip(&fit.fv_only) {
        let heading =
            "[[identification.fv_only_over_setting]]  # the plain FV curve fitted to the tests of this setting";
        let _ = write!(out, "\n{heading}\nsetting = {setting:?}\n{}", FvOnly::from_params(curve).lines());
    }
    out += "\n[identification.depends_on_setting]  # probability\n";
    for of in &fit.dependences {
        let _ = writeln!(out, "{} = {:.3}", of.name, of.probability);
    }
    if let Some(actuator) = &fit.actuator {
        out += "\n[identification.actuator]  # probability of each part\n";
        for of in &actuator.parts {
            let _ = writeln!(out, "{} = {:.3}", of.name, of.probability);
        }
    }
    out
}
