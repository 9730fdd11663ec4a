//! The model file of a family: the kernel's flat part, then tables with what the fit knows.

use super::fit::{FamilyEstimate, FamilyFit};
use crate::intervals::Standing;
use crate::model_file::{flat_family, number, text};
use crate::short::short;
use crate::{Estimate, Measured, describe_item, off};
use dashpot_core::parameter::{List, Row};
use dashpot_records::clock;
use std::fmt::Write as _;

/// The pair of an interval; the value twice where it has none.
fn format_pair(estimate: Option<&Estimate>, value: f64) -> String {
    match estimate {
        Some(Estimate { low: Some(low), high: Some(high), .. }) => format!("[{}, {}]", number(*low), number(*high)),
        _ => format!("[{0}, {0}]", number(value)),
    }
}

/// Estimates of a parameter at a setting; at none for a shared one.
fn estimates_of<'f>(fit: &'f FamilyFit, name: &str, setting: Option<f64>) -> Vec<&'f Estimate> {
    let own = fit.estimates.iter().filter(|e| e.estimate.name == name && e.setting == setting);
    own.map(|e| &e.estimate).collect()
}

/// Intervals of the points of a curve, where its fixed point is exact by definition.
fn format_points(estimates: &[&Estimate], values: &[f64]) -> String {
    let pairs: Vec<String> = values
        .iter()
        .enumerate()
        .map(|(k, value)| format_pair(estimates.iter().find(|e| e.index == Some(k)).copied(), *value))
        .collect();
    format!("[{}]", pairs.join(", "))
}

/// Names of the estimates that are shared, or that are not, each once.
fn names(fit: &FamilyFit, is_shared: bool) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = Vec::new();
    for FamilyEstimate { estimate, .. } in fit.estimates.iter().filter(|e| e.setting.is_none() == is_shared) {
        if !names.contains(&estimate.name) {
            names.push(estimate.name);
        }
    }
    names
}

/// The model file.
pub fn write(fit: &FamilyFit) -> String {
    let comment = |row: &Row| {
        let p = row.parameter;
        let mut words = if p.unit == "-" { String::new() } else { format!("{}; ", p.unit) };
        words += p.meaning;
        if let [estimate] = estimates_of(fit, p.name, None)[..] {
            match (&estimate.standing, estimate.low, estimate.high) {
                (Standing::NotIdentified, ..) => words += "; not identified from this data",
                (_, Some(low), Some(high)) => {
                    let _ = write!(words, "; 95 %: {} to {}; from {}", short(low), short(high), estimate.from);
                }
                _ => {}
            }
        }
        words
    };
    let mut out = String::from(
        "# A damper over a setting, identified by dashpot. SI units; extension (rebound) and tension positive.\n\
         # The lines up to [identification] are the damper; what follows is for people and tools.\n\n",
    );
    out += &flat_family(&fit.damper, comment);
    let list =
        |items: &[String]| format!("[\n{}]", items.iter().map(|i| format!("    {},\n", text(i))).collect::<String>());
    let _ = writeln!(out, "\n[identification]\ntests = {}", list(&fit.tests));
    let _ = writeln!(out, "fingerprints = {}", list(&fit.fingerprints));
    let not: Vec<String> = fit
        .estimates
        .iter()
        .filter(|e| e.estimate.standing == Standing::NotIdentified)
        .map(|FamilyEstimate { setting, estimate }| {
            let name = estimate.index.map_or(estimate.name.to_owned(), |i| format!("{}[{i}]", estimate.name));
            setting.map_or(name.clone(), |setting| format!("{name}@{setting}"))
        })
        .collect();
    let _ = writeln!(out, "not_identified = {}", list(&not));
    let inventory = fit.inventory.iter().map(describe_item);
    let notes: Vec<String> = inventory.chain(fit.notes.iter().cloned()).map(|said| said.to_string()).collect();
    let _ = writeln!(out, "notes = {}", list(&notes));
    let off = off(&fit.measured);
    let drifts = off.gain_per_s != 0.0 || off.zero_n_per_s != 0.0;
    if let Some(from) = fit.clock_from.filter(|_| drifts) {
        let _ =
            writeln!(out, "clock_from = \"{}\"  # when what drifts in the measurement was right", clock::written(from));
    }
    out += "\n[identification.intervals]  # 95 %, of what all settings share\n";
    for name in names(fit, true) {
        let own = estimates_of(fit, name, None);
        if let [estimate @ Estimate { index: None, .. }] = own[..] {
            if estimate.low.is_some() {
                let _ = writeln!(out, "{name} = {}", format_pair(Some(estimate), estimate.value));
            }
        } else {
            let values = List::find(name).map_or(&[][..], |list| fit.damper.params.list(list));
            let _ = writeln!(out, "{name} = {}", format_points(&own, values));
        }
    }
    out += "\n[identification.intervals_over_setting]  # 95 %, of what depends on the setting: one entry for each of its values\n";
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
    if !fit.measured.is_empty() {
        out += "\n[identification.measurement]  # what the records are off by, value and 95 %; taken out of them, never of the damper\n";
        for Measured { name, value, low, high, .. } in &fit.measured {
            let _ = writeln!(out, "{name} = [{}, {}, {}]", number(*value), number(*low), number(*high));
        }
    }
    out += "\n[identification.sources]  # share of the information by kind of test\n";
    for name in names(fit, true) {
        if let [Estimate { index: None, from, .. }] = estimates_of(fit, name, None)[..] {
            let _ = writeln!(out, "{name} = {}", text(&from.to_string()));
        }
    }
    out += "\n[identification.depends_on_setting]  # probability\n";
    for of in &fit.dependences {
        let _ = writeln!(out, "{} = {:.3}", of.name, of.probability);
    }
    out
}
