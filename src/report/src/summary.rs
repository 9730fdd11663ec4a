//! The answer: how close the model comes, in a few sentences and one table.

use super::blocks::{Block, Column, Figure, Section, Table};
use super::numbers::{digits, error, force, percent};
use crate::plot::overview;
use dashpot_identification::validation::{Errors, TestValidation, Validation};

/// The first section.
pub fn section(validation: &Validation) -> Section {
    let mut blocks = vec![Block::Lead(headline(validation))];
    blocks.extend(left_out(validation).map(Block::Paragraph));
    blocks.extend(worst(validation).map(Block::Paragraph));
    blocks.extend(noise(validation).map(Block::Paragraph));
    blocks.push(Block::Table(key_table(validation)));
    blocks.push(Block::Wide(Figure::new("overview-tests", overview::error_of_tests(validation))));
    Section::new("summary", "Summary", blocks)
}

/// The result beside that of the force–velocity curve alone.
fn headline(validation: &Validation) -> String {
    let Errors { model, fv_only } = validation.overall.errors;
    let closer = validation.tests.iter().filter(|test| is_closer(test)).count();
    let tests = validation.tests.len();
    let over = if tests == 1 { "In the one test".into() } else { format!("Over {tests} tests") };
    let ratio = fv_only.mean_error_n / model.mean_error_n;
    let verdict = if !ratio.is_finite() {
        "the model follows the measurement exactly".to_owned()
    } else if ratio >= 1.05 {
        format!("the model's mean error is smaller by a factor of {}", digits(ratio, 2))
    } else if ratio > 0.95 {
        "the model gains nothing worth having over the curve".to_owned()
    } else {
        format!(
            "the model's mean error is larger by a factor of {}: it does worse than the curve",
            digits(1.0 / ratio, 2)
        )
    };
    let count = if tests == 1 {
        String::new()
    } else {
        format!(", and it is the closer of the two in {closer} of {tests} tests")
    };
    format!(
        "{over} the model misses the measured force by {} N on average, {} % of a test's largest force. \
         The force–velocity curve alone misses it by {} N, {} %: {verdict}{count}.",
        error(model.mean_error_n),
        percent(model.error_percent),
        error(fv_only.mean_error_n),
        percent(fv_only.error_percent),
    )
}

/// How the model does where identification did not look.
fn left_out(validation: &Validation) -> Option<String> {
    let figures = |errors: &Errors| {
        format!(
            "{} N or {} % (curve alone {} N or {} %)",
            error(errors.model.mean_error_n),
            percent(errors.model.error_percent),
            error(errors.fv_only.mean_error_n),
            percent(errors.fv_only.error_percent),
        )
    };
    match (&validation.used_in_fit, &validation.left_out) {
        (Some(fitted), Some(left)) => Some(format!(
            "On the {} tests that identification did not see the mean error is {}; on the {} it was fitted to, {}.",
            left.tests,
            figures(&left.errors),
            fitted.tests,
            figures(&fitted.errors),
        )),
        (Some(_), None) => Some(
            "Every test was used to identify the model, so these figures show how well it fits, not how well it predicts."
                .to_owned(),
        ),
        _ => None,
    }
}

/// The test with the largest error percent.
fn worst(validation: &Validation) -> Option<String> {
    let by_percent = |a: &&TestValidation, b: &&TestValidation| {
        a.errors.model.error_percent.total_cmp(&b.errors.model.error_percent)
    };
    let test = validation.tests.iter().max_by(by_percent).filter(|_| validation.tests.len() > 1)?;
    Some(format!(
        "The largest error in percent is that of test “{}”: {} %, which is {} N of {} N.",
        test.name,
        percent(test.errors.model.error_percent),
        error(test.errors.model.mean_error_n),
        force(test.max_force_n),
    ))
}

/// What no model can do better than.
fn noise(validation: &Validation) -> Option<String> {
    let known: Vec<f64> = validation.tests.iter().map(|test| test.noise_rms_n).filter(|rms| *rms > 0.0).collect();
    if known.is_empty() {
        return None;
    }
    // The mean magnitude of normally distributed noise is √(2/π) of its root mean square.
    let mean = known.iter().sum::<f64>() / known.len() as f64 * std::f64::consts::FRAC_2_PI.sqrt();
    Some(format!(
        "The noise of the measured force alone would give a mean error of about {} N; no model can come closer than that.",
        digits(mean, 2)
    ))
}

/// Model beside curve, overall and for fitted and left-out tests.
fn key_table(validation: &Validation) -> Table {
    let mut rows = Vec::new();
    let groups = [
        ("all tests", Some(&validation.overall)),
        ("used in the fit", validation.used_in_fit.as_ref()),
        ("left out of the fit", validation.left_out.as_ref()),
    ];
    for (name, summary) in groups.into_iter().filter_map(|(name, summary)| Some((name, summary?))) {
        for (what, figures) in [("model", summary.errors.model), ("FV curve alone", summary.errors.fv_only)] {
            rows.push(vec![
                name.to_owned(),
                summary.tests.to_string(),
                what.to_owned(),
                error(figures.mean_error_n),
                percent(figures.error_percent),
                error(figures.region1_n),
                error(figures.region2_n),
                error(figures.rmse_n),
            ]);
        }
    }
    let columns = vec![
        Column::words("tests"),
        Column::figures("number"),
        Column::words("force of"),
        Column::figures("mean error,\u{a0}N"),
        Column::figures("error,\u{a0}%"),
        Column::figures("region 1,\u{a0}N"),
        Column::figures("region 2,\u{a0}N"),
        Column::figures("rms error,\u{a0}N"),
    ];
    let caption = format!(
        "Mean error: mean of |simulated − measured| over a test's samples. Error in percent of the largest measured \
         force of the test. Regions 1 and 2: the parts of the mean error from samples slower and faster than {} mm/s; \
         they add up to it. All are means over tests, each test with equal weight.",
        digits(1e3 * validation.region_boundary_m_s, 3),
    );
    Table { caption, columns, rows, sortable: false }
}

fn is_closer(test: &TestValidation) -> bool {
    test.errors.model.mean_error_n < test.errors.fv_only.mean_error_n
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::of_test::tests::{compared, record};
    use dashpot_identification::validation::validate;

    #[test]
    fn the_headline_does_not_flatter() {
        let record = record(2, true);
        let mut test = compared(&record);
        let text = |test: &_| headline(&validate(std::slice::from_ref(test)).unwrap());
        assert!(text(&test).contains("smaller by a factor of"), "{}", text(&test));
        std::mem::swap(&mut test.model, &mut test.fv_only);
        assert!(text(&test).contains("does worse than the curve"), "{}", text(&test));
        test.model = test.fv_only.clone();
        assert!(text(&test).contains("gains nothing"), "{}", text(&test));
    }

    #[test]
    fn a_fit_without_left_out_tests_says_so() {
        let record = record(2, true);
        let mut test = compared(&record);
        test.used_in_fit = true;
        let text = left_out(&validate(&[test]).unwrap()).unwrap();
        assert!(text.contains("not how well it predicts"));
    }
}
