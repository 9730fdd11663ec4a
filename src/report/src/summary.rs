//! The result of a validation in a few sentences: the error of the model, compared with the FV curve alone and with the
//! noise.

use super::blocks::{Block, Column, Section, Table};
use super::numbers::{digits, error, force, percent};
use crate::cells::Cell;
use crate::words::Words;
use dashpot_identification::validation::{Errors, TestValidation, Validation};

/// Builds the first section of the report: the error of the model, of left-out tests and of the worst test, and the
/// noise.
pub fn section(validation: &Validation, words: &Words) -> Section {
    let mut blocks = vec![Block::Lead(headline(validation, words))];
    blocks.extend(left_out(validation, words).map(Block::Paragraph));
    blocks.extend(worst_in_words(validation, words).map(Block::Paragraph));
    blocks.extend(noise(validation, words).map(Block::Paragraph));
    Section::new("answer", words.answer, blocks)
}

/// Builds the section with the table of the errors of model and FV curve that support the result.
pub fn figures(validation: &Validation, words: &Words) -> Section {
    Section::new("key", words.key_section, vec![Block::Table(key_table(validation, words))])
}

/// Compares the error of the model with the error of the force–velocity curve alone.
fn headline(validation: &Validation, words: &Words) -> String {
    let Errors { model, fv_only } = validation.overall.errors;
    let closer = validation.tests.iter().filter(|test| is_closer(test)).count().to_string();
    let tests = validation.tests.len();
    let count = tests.to_string();
    let over =
        if tests == 1 { words.over_one_test.to_owned() } else { words.fill(words.over_tests, &[("tests", &count)]) };
    let ratio = fv_only.mean_error_n / model.mean_error_n;
    let verdict = if !ratio.is_finite() {
        words.verdict_exact.to_owned()
    } else if ratio >= 1.05 {
        words.fill(words.verdict_smaller, &[("ratio", &digits(ratio, 2))])
    } else if ratio > 0.95 {
        words.verdict_same.to_owned()
    } else {
        words.fill(words.verdict_larger, &[("ratio", &digits(1.0 / ratio, 2))])
    };
    let closer =
        if tests == 1 { String::new() } else { words.fill(words.closer_in, &[("closer", &closer), ("tests", &count)]) };
    let figures = [
        ("over", over.as_str()),
        ("verdict", &verdict),
        ("closer", &closer),
        ("error", &error(model.mean_error_n)),
        ("percent", &percent(model.error_percent)),
        ("curve_error", &error(fv_only.mean_error_n)),
        ("curve_percent", &percent(fv_only.error_percent)),
    ];
    words.fill(words.headline, &figures)
}

/// Describes the error of the model in the left-out tests, or states that all tests were used in the fit. Returns
/// `None` if the fit used none of the tests.
fn left_out(validation: &Validation, words: &Words) -> Option<String> {
    let figures = |errors: &Errors| {
        let figures = [
            ("error", error(errors.model.mean_error_n)),
            ("percent", percent(errors.model.error_percent)),
            ("curve_error", error(errors.fv_only.mean_error_n)),
            ("curve_percent", percent(errors.fv_only.error_percent)),
        ];
        words.fill(words.left_out_figures, &figures.each_ref().map(|(name, value)| (*name, value.as_str())))
    };
    match (&validation.used_in_fit, &validation.left_out) {
        (Some(fitted), Some(left)) => Some(words.fill(
            words.left_out_sentence,
            &[
                ("left", &left.tests.to_string()),
                ("left_figures", &figures(&left.errors)),
                ("fitted", &fitted.tests.to_string()),
                ("fitted_figures", &figures(&fitted.errors)),
            ],
        )),
        (Some(_), None) => Some(words.only_fitted.to_owned()),
        _ => None,
    }
}

/// Returns the index of the test with the largest relative error. If several tests have this error, returns the first
/// of them.
pub fn worst(validation: &Validation) -> Option<usize> {
    let percent = |i: &usize| validation.tests[*i].errors.model.error_percent;
    (0..validation.tests.len()).min_by(|a, b| percent(b).total_cmp(&percent(a)))
}

fn worst_in_words(validation: &Validation, words: &Words) -> Option<String> {
    let test = worst(validation).filter(|_| validation.tests.len() > 1).map(|i| &validation.tests[i])?;
    Some(words.fill(
        words.largest_error,
        &[
            ("test", &test.name),
            ("percent", &percent(test.errors.model.error_percent)),
            ("error", &error(test.errors.model.mean_error_n)),
            ("force", &force(test.max_force_n)),
        ],
    ))
}

/// Describes the mean noise of the measured forces, which is the lower bound of any model's error. Returns `None` if
/// the noise is unknown.
fn noise(validation: &Validation, words: &Words) -> Option<String> {
    let known: Vec<f64> = validation.tests.iter().map(|test| test.noise_rms_n).filter(|rms| *rms > 0.0).collect();
    if known.is_empty() {
        return None;
    }
    // The mean magnitude of normally distributed noise is √(2/π) of its root mean square.
    let mean = known.iter().sum::<f64>() / known.len() as f64 * std::f64::consts::FRAC_2_PI.sqrt();
    Some(words.fill(words.noise_sentence, &[("noise", &digits(mean, 2))]))
}

/// Builds the table that compares model and FV curve, for all tests, fitted tests and left-out tests.
fn key_table(validation: &Validation, words: &Words) -> Table {
    let mut rows = Vec::new();
    let groups = [
        (words.all_tests, Some(&validation.overall)),
        (words.used_in_fit, validation.used_in_fit.as_ref()),
        (words.left_out_of_fit, validation.left_out.as_ref()),
    ];
    for (name, summary) in groups.into_iter().filter_map(|(name, summary)| Some((name, summary?))) {
        for (what, figures) in [(words.model, summary.errors.model), (words.group_curve, summary.errors.fv_only)] {
            rows.push(vec![
                name.into(),
                Cell::count(summary.tests),
                what.into(),
                Cell::number(figures.mean_error_n, error),
                Cell::number(figures.error_percent, percent),
                Cell::number(figures.region1_n, error),
                Cell::number(figures.region2_n, error),
                Cell::number(figures.rmse_n, error),
            ]);
        }
    }
    let columns = vec![
        Column::words(words.col_tests),
        Column::figures(words.col_number),
        Column::words(words.col_force_of),
        Column::figures(words.col_mean_error),
        Column::figures(words.col_error_percent),
        Column::figures(words.col_region1),
        Column::figures(words.col_region2),
        Column::figures(words.col_rms),
    ];
    let caption = words.fill(words.key_caption, &[("boundary", &digits(1e3 * validation.region_boundary_m_s, 3))]);
    Table { caption, columns, rows, sortable: false }
}

fn is_closer(test: &TestValidation) -> bool {
    test.errors.model.mean_error_n < test.errors.fv_only.mean_error_n
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::of_test::tests::{compared, record};
    use crate::words::EN;
    use dashpot_identification::validation::validate;

    #[test]
    fn the_headline_does_not_flatter() {
        let record = record(2, true);
        let mut test = compared(&record);
        let text = |test: &_| headline(&validate(std::slice::from_ref(test)).unwrap(), &EN);
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
        let text = left_out(&validate(&[test]).unwrap(), &EN).unwrap();
        assert!(text.contains("not how well it predicts"));
    }
}
