//! Effects that a user requests for a neutral damper, and their strengths: for the command line and for Python.

use crate::SeverityError;
use crate::case::Case;
use dashpot_messages::format_number;
use dashpot_rig::{NOTHING, Options, Plan, RigError};

/// Requested effects: name, or `name:form` for one physical form, with its severity or strength if stated.
pub type RequestedEffects = Vec<(String, Option<f64>)>;

/// Meaning of the numbers of requested effects.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    /// Severities: the part that a refit of the model cannot absorb, relative to the noise.
    Severities,
    /// Physical strengths; 1 is a typical strong case.
    Strengths,
}

/// Strength of a typical strong case. It is the default if no number is stated.
const TYPICAL: f64 = 1.0;

/// Highest accepted severity, in units of the noise. A strong effect has a severity of 4. With the sensors of a rig, no effect reaches the
/// highest accepted severity.
const HIGHEST: f64 = 1000.0;

fn refused(problem: String) -> SeverityError {
    RigError::Option { option: "hide", problem }.into()
}

/// Converts requested effects to names with strengths. An effect without a number has the strength of a typical strong
/// case. The result is empty for `nothing`. Severities require a `plan` of the rig, because its tests determine the
/// strengths. For every trial strength, `watch` receives the number of measured tests and of all tests.
///
/// # Errors
/// `nothing` together with an effect, an invalid number, severities without plan or noise, a severity that no strength
/// reaches, or errors of the rig.
pub fn strengths(
    asked: RequestedEffects,
    numbers: Numbers,
    plan: Option<Plan>,
    options: &Options,
    watch: &dyn Fn(usize, usize),
) -> Result<Vec<(String, f64)>, SeverityError> {
    let is_nothing = |(name, number): &(String, Option<f64>)| name == NOTHING && number.is_none();
    if asked.iter().any(is_nothing) {
        if asked.len() > 1 {
            return Err(refused(format!("'{NOTHING}' stands beside an effect; give one or the other")));
        }
        return Ok(Vec::new());
    }
    if numbers == Numbers::Strengths {
        return Ok(asked.into_iter().map(|(name, number)| (name, number.unwrap_or(TYPICAL))).collect());
    }
    let severities: Vec<(String, f64)> = asked.iter().filter_map(|(n, s)| s.map(|s| (n.clone(), s))).collect();
    let mut found = Vec::new();
    if !severities.is_empty() {
        if let Some((name, number)) = severities.iter().find(|(_, number)| !(0.0..=HIGHEST).contains(number)) {
            let number = format_number(*number);
            return Err(refused(format!("'{number}' is no severity of '{name}'; give 0 to {HIGHEST}")));
        }
        let Some(plan) = plan else { return Err(SeverityError::OwnTests) };
        if options.noise_percent <= 0.0 {
            return Err(SeverityError::NoNoise);
        }
        let options = Options { threads: Some(1), ..options.clone() };
        let case = Case { effects: severities, plan, options, ..Case::nothing(0) };
        found = case.strengths_watched(watch)?;
    }
    let mut found = found.into_iter();
    let mut strength = |number: Option<f64>| number.and_then(|_| found.next()).unwrap_or(TYPICAL);
    Ok(asked.into_iter().map(|(name, number)| (name, strength(number))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn describe(asked: &[(&str, Option<f64>)], numbers: Numbers, plan: Option<Plan>, noise_percent: f64) -> String {
        let asked = asked.iter().map(|(name, number)| ((*name).to_owned(), *number)).collect();
        let options = Options { noise_percent, ..Options::default() };
        match strengths(asked, numbers, plan, &options, &|_, _| ()) {
            Ok(found) => format!("{found:?}"),
            Err(error) => error.to_string(),
        }
    }

    #[test]
    fn a_name_alone_is_a_typical_strong_case_whatever_the_numbers_are() {
        for numbers in [Numbers::Severities, Numbers::Strengths] {
            assert_eq!(describe(&[("bushing", None)], numbers, None, 0.0), r#"[("bushing", 1.0)]"#);
            assert_eq!(describe(&[(NOTHING, None)], numbers, None, 0.0), "[]");
            assert_eq!(describe(&[], numbers, None, 0.0), "[]");
        }
        assert_eq!(describe(&[("bushing", Some(0.25))], Numbers::Strengths, None, 0.0), r#"[("bushing", 0.25)]"#);
    }

    #[test]
    fn what_makes_no_severity_is_refused_with_what_to_do() {
        let asked = [("bushing", Some(2.0))];
        let plan = Some(Plan::Diagnosis);
        assert!(describe(&asked, Numbers::Severities, None, 1.0).contains("give strengths (--strength)"));
        assert!(describe(&asked, Numbers::Severities, plan, 0.0).contains("in units of the noise"));
        assert!(
            describe(&[("ghosts", Some(2.0))], Numbers::Severities, plan, 1.0)
                .contains("gas_spring, stribeck_friction")
        );
        for severity in [1e308, -1e308, -1e-308, 1001.0, f64::NAN, f64::INFINITY] {
            let message = describe(&[("bushing", Some(severity))], Numbers::Severities, plan, 1.0);
            let named = format!("'{}' is no severity of 'bushing'; give 0 to 1000", format_number(severity));
            assert!(message.contains(&named) && message.len() < 300, "{message}");
        }
        let beside = describe(&[(NOTHING, None), ("bushing", None)], Numbers::Strengths, plan, 1.0);
        assert!(beside.contains("give one or the other"), "{beside}");
    }

    #[test]
    fn severities_become_strengths_at_their_own_places() {
        let asked = [("force_offset", None), ("force_drift", Some(0.0)), ("channel_delay", None)];
        assert_eq!(
            describe(&asked, Numbers::Severities, Some(Plan::Diagnosis), 1.0),
            r#"[("force_offset", 1.0), ("force_drift", 0.0), ("channel_delay", 1.0)]"#
        );
    }
}
