//! `dashpot fit --setting`: fit of one damper over a setting.

use super::data::{DataArgs, name_of};
use super::record_notes::print_record_notes;
use super::validate::{compare_family, settings_table};
use crate::page::TextArgs;
use crate::plural::count_tests;
use crate::progress::Progress;
use dashpot_identification::family::{
    ActuatorDecision, ActuatorFit, FamilyEstimate, FamilyFigures, FamilyFit, FamilyItem, ForceAtSetting, SettingAxis,
    SettingDependence, SettingError, SettingReport, fit_family, model_file,
};
use dashpot_identification::model_file::{ModelFile, family_of_text};
use dashpot_identification::validation::validate;
use dashpot_identification::{Estimate, FitOptions, Standing, describe_item};
use dashpot_records::{Campaign, Record, setting_in_words};
use dashpot_report::family::errors;
use dashpot_report::numbers::{with_interval, with_unit};
use dashpot_report::words::TERMINAL;
use dashpot_report::{FamilyReport, Print, ReportInput, quality};
use dashpot_simulation::{comparison, whole_records};
use std::path::Path;

/// Paths of the output files.
pub struct Outputs<'a> {
    /// Path of the model file.
    pub model: &'a Path,
    /// Path of the JSON output, if requested.
    pub json: Option<&'a Path>,
    /// Path of the report, with its language and date, if requested.
    pub report: Option<(&'a Path, &'a TextArgs)>,
}

/// Fits an adjustable damper, and writes its model file and the results.
pub fn run(
    (campaign, records): (&Campaign, &[&Record]),
    setting: &str,
    options: &FitOptions,
    (data, outputs): (&DataArgs, &Outputs),
) -> anyhow::Result<()> {
    let (output, json) = (outputs.model, outputs.json);
    let progress = Progress::new("fitting");
    let found = fit_family(records, setting, options, |stage| progress.say(stage.done, stage.text.english()))?;
    drop(progress);
    let text = model_file::write(&found);
    dashpot_output::write(output, &text)?;
    let is_on_stdout = [Some(output), json].into_iter().flatten().any(dashpot_output::is_stdout);
    let say = |text: &str| dashpot_output::say(if is_on_stdout { Some(Path::new("-")) } else { None }, text);
    print_record_notes(campaign, &say)?;
    for line in format_family(&found) {
        say(&line)?;
    }
    for note in &found.notes {
        say(&format!("note: {note}"))?;
    }
    say(&format!("{} fitted; model in {}", count_tests(found.tests.len()), name_of(output)))?;
    let good = quality::sentence(&whole_records::quality_of_family(&found, records)?, &TERMINAL);
    let changing = whole_records::quality_where_the_setting_changes(&found, records)?;
    // The rating may apply only at the settings of the records. This is the case if the prediction at a left-out setting is worse than the
    // fit, or if no setting was left out.
    let is_worse_between = found.worst_left_out().is_none_or(|of| of.is_worse());
    let is_of_all = !is_worse_between && changing.is_none();
    say(&if is_of_all { good } else { format!("At the settings of the records: {}", lower_first(&good)) })?;
    if let Some(changing) = changing {
        let good = quality::sentence(&changing, &TERMINAL);
        say(&format!("Where the {} changes within a test: {}", found.setting.name, lower_first(&good)))?;
    }
    say(&errors::between(&found, &TERMINAL))?;
    if let Some(path) = json {
        dashpot_output::json(path, &FamilyFigures::new(&found, campaign, Some(output)))?;
    }
    if let Some((path, page)) = outputs.report {
        let model = family_of_text(&text, output)?;
        write_report((campaign, &model, &found), (data, output), (path, page), &say)?;
    }
    Ok(())
}

/// Largest number of tests that a line names. Among more names, a reader would overlook the number of tests.
const NAMED: usize = 6;

/// Validates the adjustable damper over whole records, and writes the report.
fn write_report(
    (campaign, model, found): (&Campaign, &ModelFile, &FamilyFit),
    (data, output): (&DataArgs, &Path),
    (path, page): (&Path, &TextArgs),
    say: &dyn Fn(&str) -> anyhow::Result<()>,
) -> anyhow::Result<()> {
    let mut campaign = campaign.clone();
    let has_setting = |record: &Record| {
        let constant = record.setting.as_ref().map(|of| &of.name);
        let changing = record.setting_signal.as_ref().map(|of| &of.name);
        constant.or(changing) == Some(&found.setting.name)
    };
    // Only a held-out test may lack its setting. The fit requires a setting for all other tests.
    let without: Vec<String> =
        campaign.records.iter().filter(|record| !has_setting(record)).map(|record| record.name.clone()).collect();
    if !without.is_empty() {
        say(&format!(
            "note: the report leaves out the held-out tests that state no {}: {} (tests: {})",
            found.setting.name,
            without.join(", "),
            without.len()
        ))?;
        campaign.records.retain(has_setting);
    }
    campaign.notes.extend(model.identification.right(&mut campaign.records));
    let compared = compare_family(model, &campaign, None)?;
    let mut validation = validate(&compared)?;
    comparison::summarize_settings(&mut validation, model, (&campaign, &compared), None)?;
    validation.unusable.clone_from(&campaign.unusable);
    let is_unused = |record: &&Record| !found.tests.contains(&record.name);
    let unused: Vec<&str> = campaign.records.iter().filter(is_unused).map(|record| record.name.as_str()).collect();
    say(&format!("over whole records{}:\n{}", unused_tests(&unused), settings_table(model, &validation)))?;
    let mut input = ReportInput {
        print: Print::Brief,
        made: page.date.made(campaign.files.iter().cloned())?,
        data: data.named(),
        family: Some(FamilyReport { model, fit: Some(found) }),
        model_file: name_of(output),
        ..ReportInput::from_validation(model, &campaign, &compared, &validation, page.words())?
    };
    // The figure of peak forces gets no curve, because the curve at one setting does not represent the other settings.
    input.curve.clear();
    dashpot_report::write_atomic(&input, path)?;
    say(&format!("report: {}", path.display()))
}

/// Describes the tests that the fit did not use, for the heading of a table that contains them.
fn unused_tests(names: &[&str]) -> String {
    match names.len() {
        0 => String::new(),
        count @ 1..=NAMED => format!(", with {} that the fit did not use: {}", count_tests(count), names.join(", ")),
        count => format!(", with {} that the fit did not use", count_tests(count)),
    }
}

/// Formats the result of the fit: effects, dependences on the setting, parameters, actuator, and errors at each
/// setting.
fn format_family(found: &FamilyFit) -> Vec<String> {
    let axis = &found.setting;
    let mut out: Vec<String> =
        found.inventory.iter().map(|of| format!("  {}{}", describe_item(&of.item), format_forces(of, axis))).collect();
    let listed = |varies: bool| {
        let own = found.dependences.iter().filter(|of| of.varies == varies);
        let one = |of: &SettingDependence| format!("{} ({:.2})", of.name, of.probability);
        own.map(one).collect::<Vec<_>>().join(", ")
    };
    for (varies, words) in [(true, format!("depends on {}", axis.name)), (false, "shared by all settings".to_owned())] {
        let names = listed(varies);
        if !names.is_empty() {
            out.push(format!("{words} (probability that it depends): {names}"));
        }
    }
    for FamilyEstimate { setting, estimate: e } in found.estimates.iter().filter(|e| e.estimate.index.is_none()) {
        let name =
            setting.map_or(e.name.to_owned(), |value| format!("{} at {}", e.name, setting_in_words(value, &axis.unit)));
        out.push(format_estimate(&name, e));
    }
    out.extend(found.actuator.iter().flat_map(format_actuator));
    out.push(format_errors(axis, &found.settings));
    out
}

/// Largest difference between the forces of an effect at its settings, relative to the largest of them, at which the text calls the forces
/// alike. With a larger difference, the text lists them.
const ALIKE: f64 = 0.02;

/// Formats the rms force of an effect at each setting, N. If the forces are alike, states only that they are.
fn format_forces(of: &FamilyItem, axis: &SettingAxis) -> String {
    let forces = || of.settings.iter().map(|here| here.force_n_rms);
    let (low, high) = (forces().fold(f64::INFINITY, f64::min), forces().fold(0.0, f64::max));
    if high - low <= ALIKE * high {
        return " (alike at all settings)".to_owned();
    }
    let at = |of: &ForceAtSetting| format!("{}: {:.1} N", setting_in_words(of.setting, &axis.unit), of.force_n_rms);
    format!(" ({})", of.settings.iter().map(at).collect::<Vec<_>>().join(", "))
}

/// Formats the components and the parameters of the actuator.
fn format_actuator(fit: &ActuatorFit) -> Vec<String> {
    let part = |of: &ActuatorDecision| {
        let word = match of.is_present {
            _ if of.is_undecided() => "undecided: ",
            true => "",
            false => "no ",
        };
        format!("{word}{} ({:.2})", of.name, of.probability)
    };
    let parts: Vec<String> = fit.parts.iter().map(part).collect();
    let mut out = vec![format!(
        "actuator from {} (probability that the valve has it): {}",
        count_tests(fit.tests.len()),
        parts.join(", ")
    )];
    out.extend(fit.estimates.iter().map(|e| format_estimate(e.name, e)));
    out
}

/// Formats a parameter with its interval.
fn format_estimate(name: &str, e: &Estimate) -> String {
    match (&e.standing, e.low, e.high) {
        (Standing::NotIdentified, ..) => {
            format!("  {name:<38} {:>16}  not identified from this data", with_unit(e.value, e.unit))
        }
        (_, Some(low), Some(high)) => {
            let (value, interval) = with_interval(e.value, low, high, e.unit, &TERMINAL);
            format!("  {name:<38} {value:>16}  95 %: {interval}")
        }
        _ => format!("  {name:<38} {:>16}", with_unit(e.value, e.unit)),
    }
}

/// Converts the first letter of a sentence to lower case, for use after a colon.
fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_lowercase().chain(letters).collect())
}

/// Formats the errors at each setting.
fn format_errors(axis: &SettingAxis, settings: &[SettingReport]) -> String {
    let mut out = format!(
        "mean error on mean cycles:\n{:>14}{:>7}{:>20}{:>20}{:>22}{:>9}",
        axis.name, "tests", "fit of it alone", "family", "family without it", "ratio"
    );
    let error = |e: &SettingError| format!("{:.2} N ({:.2} %)", e.mean_error_n, e.error_percent);
    for of in settings {
        let left_out = of.left_out.as_ref().map_or_else(|| "-".to_owned(), error);
        let ratio = of.left_out_ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.2}"));
        out += &format!(
            "\n{:>14}{:>7}{:>20}{:>20}{left_out:>22}{ratio:>9}",
            setting_in_words(of.setting, &axis.unit),
            of.tests,
            error(&of.own_fit),
            error(&of.family)
        );
    }
    out += "\npercent: of the largest force of each test";
    if settings.iter().any(|of| of.family.mean_error_n < of.own_fit.mean_error_n) {
        out += "; a fit of one setting alone has fewer points of the FV curve, so the family may be better than it";
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_errors_say_what_their_percent_is_of_and_why_a_fit_alone_may_be_worse() {
        let error = |mean_error_n: f64| SettingError { mean_error_n, error_percent: 0.1 * mean_error_n };
        let of = |own: f64, family: f64| SettingReport {
            setting: 1.0,
            tests: 4,
            own_fit: error(own),
            family: error(family),
            left_out: None,
            left_out_ratio: None,
        };
        let axis = SettingAxis { name: "current".into(), unit: "A".into() };
        let said = format_errors(&axis, &[of(10.0, 12.0)]);
        assert!(said.ends_with("percent: of the largest force of each test"), "{said}");
        let said = format_errors(&axis, &[of(10.0, 12.0), of(13.0, 12.0)]);
        assert!(said.ends_with("has fewer points of the FV curve, so the family may be better than it"), "{said}");
    }

    #[test]
    fn tests_that_the_fit_did_not_use_are_named_if_they_are_few() {
        assert_eq!(unused_tests(&[]), "");
        assert_eq!(unused_tests(&["walk"]), ", with 1 test that the fit did not use: walk");
        assert_eq!(unused_tests(&["walk"; NAMED + 1]), ", with 7 tests that the fit did not use");
    }
}
