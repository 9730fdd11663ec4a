//! All text of the reports, in the languages that they are written in.
//!
//! Every language is one value of [`Words`]: the compiler refuses a language that lacks a text. Sentences with figures carry
//! `{name}` where [`fill`] puts a figure; the tests hold all languages to the same names. What reading, a fit and a diagnosis say is made
//! by their crates in English and looked up in [`said`], what a parameter means in the kernel's and looked up in [`meanings`].

use dashpot_records::sentence::is_number;
use names::MARK;

mod choices;
mod de;
mod en;
mod fr;
mod meanings;
mod names;
mod said;
mod zh;

pub use de::DE;
pub use en::{EN, TERMINAL};
pub use fr::FR;
pub use zh::ZH;

/// A language of the reports.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
    /// French.
    French,
    /// Chinese, simplified.
    Chinese,
}

impl Language {
    /// All, by the code that users write.
    pub const ALL: [(&'static str, Language); 4] =
        [("en", Language::English), ("de", Language::German), ("fr", Language::French), ("zh", Language::Chinese)];

    /// Its texts.
    pub fn words(self) -> &'static Words {
        match self {
            Language::English => &EN,
            Language::German => &DE,
            Language::French => &FR,
            Language::Chinese => &ZH,
        }
    }
}

impl std::str::FromStr for Language {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.iter().find(|(code, _)| code.eq_ignore_ascii_case(text.trim()));
        found
            .map(|(_, language)| *language)
            .ok_or_else(|| format!("reports are written in en, de, fr and zh, not {text:?}"))
    }
}

impl Words {
    /// A number, or several with their units, as this language writes them; they come with a decimal point, as programs write them. What is
    /// copied from a report into a command or a file (options, names, versions) is no number in this sense.
    pub fn number(&self, plain: &str) -> String {
        let letters: Vec<char> = plain.chars().collect();
        let is_digit = |k: Option<usize>| k.and_then(|k| letters.get(k)).is_some_and(char::is_ascii_digit);
        let written = letters.iter().enumerate().map(|(k, letter)| match letter {
            '.' if is_digit(k.checked_sub(1)) && is_digit(Some(k + 1)) => self.decimal_sign.to_owned(),
            // One minus sign everywhere, that of the figures.
            '-' if self.code != TERMINAL.code
                && is_digit(Some(k + 1))
                && (k == 0 || letters[k - 1].is_whitespace()) =>
            {
                "\u{2212}".to_owned()
            }
            other => other.to_string(),
        });
        written.collect()
    }

    /// A text with its figures put in, by name: numbers as this language writes them, effects and parameters in words.
    pub fn fill(&self, text: &str, figures: &[(&str, &str)]) -> String {
        let written: Vec<(&str, String)> =
            figures.iter().map(|(place, value)| (*place, self.at_place(place, value))).collect();
        let figures: Vec<(&str, &str)> = written.iter().map(|(place, value)| (*place, value.as_str())).collect();
        self.with_names(&fill(text, &figures))
    }

    /// What stands at a place of a sentence, in this language; names are marked for [`Words::with_names`].
    fn at_place(&self, place: &str, value: &str) -> String {
        match () {
            () if is_number(place, value) => self.number(value),
            () if self.is_named(place, value) => format!("{MARK}{value}{MARK}"),
            () => value.to_owned(),
        }
    }
}

/// A text with its figures put in as they are, by name.
pub(crate) fn fill(text: &str, figures: &[(&str, &str)]) -> String {
    figures.iter().fold(text.to_owned(), |text, (name, value)| text.replace(&format!("{{{name}}}"), value))
}

macro_rules! words {
    ($($name:ident),* $(,)?) => {
        /// Every text of the reports in one language.
        #[derive(Debug, Clone, Copy)]
        #[allow(missing_docs)] // the English text is the meaning
        pub struct Words { $(pub $name: &'static str),* }

        impl Words {
            /// Every text with its name.
            pub fn all(&self) -> Vec<(&'static str, &'static str)> {
                vec![$((stringify!($name), self.$name)),*]
            }
        }
    };
}

words!(
    // The page.
    code,
    decimal_sign,
    note,
    all_tests_shown,
    previous,
    next,
    test_shown,
    figure_help,
    zoom_reset,
    save_table,
    save_about,
    sort_help,
    printed_brief,
    // Figures.
    measured,
    model,
    fv_curve,
    noise_alone,
    axis_velocity,
    axis_displacement,
    axis_force,
    axis_error,
    axis_time,
    axis_gap,
    axis_error_percent,
    axis_peak_velocity,
    axis_amplitude,
    plot_force_velocity,
    plot_force_displacement,
    plot_force_time,
    plot_error_velocity,
    plot_error_displacement,
    plot_force_space,
    plot_error_space,
    plot_gap,
    plot_error_of_tests,
    plot_error_map,
    plot_error_map_note,
    plot_both_curves,
    plot_peaks,
    identified_curve,
    measured_peaks,
    model_peaks,
    window,
    // Validation: title and answer.
    title_validation,
    subtitle_validation,
    answer,
    over_one_test,
    over_tests,
    headline,
    verdict_exact,
    verdict_smaller,
    verdict_same,
    verdict_larger,
    closer_in,
    left_out_figures,
    left_out_sentence,
    only_fitted,
    largest_error,
    noise_sentence,
    // Its sections.
    fv_section,
    fv_caption_by_setting,
    fv_caption,
    worst_section,
    worst_caption,
    matrix_section,
    key_section,
    tests_section,
    single_section,
    single_about,
    single_most,
    hysteresis_section,
    identification_section,
    parameters_section,
    parameters_range,
    made_section,
    // Tables.
    col_tests,
    col_number,
    col_force_of,
    col_mean_error,
    col_error_percent,
    col_region1,
    col_region2,
    col_rms,
    col_test,
    col_amplitude,
    col_frequency,
    col_peak_velocity,
    col_max_force,
    col_in_fit,
    yes,
    no,
    group_curve,
    all_tests,
    used_in_fit,
    left_out_of_fit,
    key_caption,
    row_rule,
    by_amplitude,
    by_peak_velocity,
    tests_caption,
    row_amplitude,
    row_peak_velocity,
    row_slow,
    row_not_periodic,
    col_cycles,
    group_gap,
    group_gap_error,
    group_area,
    group_energy,
    col_measured,
    col_curve,
    hysteresis_caption,
    col_name,
    col_value,
    col_unit,
    col_low,
    col_high,
    col_source,
    parameter_at,
    col_note,
    not_identified,
    not_identified_assumed,
    not_identified_off,
    assumed_usual,
    assumed_dimensions,
    assumed_default,
    assumed_held,
    // Single tests.
    notes_of_test,
    motion_periodic,
    motion_other,
    temperature,
    force_noise,
    test_used,
    test_left_out,
    test_sentence,
    // The literature.
    family_section,
    family_between,
    family_between_worse,
    family_about,
    family_interpolated,
    plot_family,
    family_caption,
    family_table,
    family_clamped,
    family_errors_section,
    family_left_out_table,
    family_own_fit,
    family_fit,
    family_without,
    col_ratio,
    family_loops_section,
    family_loops_about,
    family_worst_about,
    family_worst_caption,
    plot_over_setting,
    over_setting_caption,
    plot_ratio,
    ratio_caption,
    axis_speed,
    axis_ratio,
    number_varies,
    number_shared,
    family_numbers_section,
    family_numbers_table,
    family_varies,
    family_effects,
    family_dependences,
    responses_section,
    responses_about,
    responses_table,
    col_step,
    col_steps,
    col_t63,
    col_t90,
    col_t63_from_10,
    col_t90_from_10,
    col_overshoot,
    plot_step_up,
    plot_step_down,
    axis_since_step,
    axis_way,
    actuator_table,
    actuator_parts,
    col_has_it,
    plot_hysteresis_setting,
    hysteresis_setting_caption,
    way_up,
    way_down,
    family_changing,
    response_time_up,
    response_time_down,
    rise_time_up,
    rise_time_down,
    settings_section,
    settings_all,
    settings_caption,
    settings_changes,
    settings_answers,
    col_setting,
    against_section,
    against_about,
    against_caption,
    col_model,
    col_meaning,
    // Limits.
    certificate_title,
    certificate_subtitle,
    certificate_section,
    certificate_pass,
    certificate_fail,
    certificate_fail_untested,
    certificate_untested,
    certificate_nothing_tested,
    certificate_why_untested,
    certificate_why_untested_at_setting,
    certificate_interpolated,
    certificate_unsure,
    certificate_model_passes,
    certificate_model_fails,
    certificate_caption,
    subject_part,
    subject_serial,
    subject_tester,
    subject_rig,
    subject_measured,
    subject_temperature,
    to_fill_in,
    col_limit,
    col_at,
    col_low_limit,
    col_high_limit,
    col_verdict,
    col_from,
    pass,
    fail,
    not_tested,
    force_rebound,
    force_compression,
    gas_force,
    friction,
    hysteresis,
    // How it was made.
    made_version,
    made_date,
    made_command,
    made_again,
    col_file,
    col_bytes,
    made_all,
    made_files,
    // Manoeuvres.
    manoeuvre_title,
    manoeuvre_subtitle,
    manoeuvre_answer,
    manoeuvre_answer_same,
    manoeuvre_beyond,
    manoeuvre_quiet,
    manoeuvre_chassis,
    corner_section,
    corner_force_velocity,
    corner_force_time,
    corner_difference,
    axis_difference,
    corners_table,
    corners_caption,
    col_corner,
    group_largest_force,
    group_energy_j,
    col_rms_difference,
    road_section,
    road_caption,
    plot_road,
    axis_road,
    chassis_section,
    plot_heave,
    plot_heave_acceleration,
    plot_roll,
    plot_lateral,
    axis_heave,
    axis_heave_acceleration,
    axis_roll,
    axis_lateral,
    region_section,
    region_with_tests,
    region_without_tests,
    plot_region,
    in_vehicle,
    rig_tests,
    vehicle_section,
    vehicle_caption,
    wheel_left,
    wheel_right,
    coupling_unstable,
    coupling_chatter,
    col_near_tests,
    saw_displacement,
    saw_velocity,
    // The workbook.
    workbook_contents,
    workbook_sheet,
    workbook_about,
    // What a fit found.
    fit_title,
    fit_subtitle,
    fit_answer,
    quality_sentence,
    quality_noise,
    quality_good,
    quality_fair,
    quality_poor,
    quality_beside_noise,
    quality_noise_unknown,
    quality_curve_worse,
    quality_curve_no_worse,
    fit_measured,
    fit_tests,
    remarks,
    col_why,
    col_interval,
    // Of figures and tables everywhere.
    comma,
    sentence_end,
    semicolon,
    colon,
    // The direction that the files count positive.
    sign_given,
    sign_found,
    sign_found_by,
    range,
    before,
    after,
    // Figures before and after.
    axis_residual,
    axis_residual_rms,
    axis_resistance,
    axis_since_reversal,
    axis_error_rms,
    plot_error_rms,
    plot_left_velocity,
    plot_left_size,
    plot_left_up,
    plot_left_down,
    plot_left_reversal,
    plot_left_map,
    fitted_tests,
    left_out,
    stretch,
    // Diagnosis: title and answer.
    diagnosis_title,
    errors_caption,
    error_unseen,
    error_fitted,
    gap_is_closed,
    nothing_stays,
    changed_stays,
    nothing_added_rivals,
    nothing_added_unknown,
    worse_tests,
    row_before,
    col_fitted_rms,
    col_their_noise,
    col_left_out_rms,
    mean_cycles_caption,
    whole_deviation,
    whole_records,
    // The picture of a diagnosis.
    name_and_sure,
    picture_named,
    picture_nothing,
    picture_cannot_tell,
    picture_unknown,
    picture_below,
    kind_left_out,
    kind_fitted,
    // Where they disagree.
    where_section,
    no_region,
    left_map_caption,
    left_size_caption,
    left_reversal_caption,
    speeding_up_caption,
    slowing_down_caption,
    all_there,
    rebound,
    compression,
    speeding_up,
    slowing_down,
    both,
    col_direction,
    col_speed,
    col_mean_n,
    col_rms_n,
    col_noise_n,
    col_in_words,
    regions_caption,
    // What is missing.
    findings_section,
    suspects_section,
    suspects_cannot_tell,
    suspects_beside,
    suspects_nearest,
    rig_added,
    changed_section,
    inventory_section,
    col_force_rms,
    col_share_of_force,
    col_status,
    status_kept,
    status_added,
    status_replaced,
    status_removed,
    replaces,
    or_instead,
    inventory_caption,
    other_effects,
    plot_inventory,
    axis_effect_force,
    inventory_bands_caption,
    shifts_section,
    finding_heading,
    finding_form,
    finding_gap,
    finding_of_rig,
    finding_added,
    finding_what,
    finding_why,
    rivals_caption,
    col_parameter,
    col_judged,
    plausible,
    not_plausible,
    col_effect,
    col_confidence,
    col_explains,
    col_reference,
    col_this_damper,
    changed_caption,
    col_change,
    shifts_caption,
    // Loops.
    loops_section,
    more_loops_section,
    loops_about,
    loop_heading,
    loop_errors,
    loop_closed,
    // Errors by amplitude and peak velocity, before and after.
    map_before,
    map_after,
    map_before_caption,
    map_after_caption,
    mean_cycles_rule,
    // Everything that was tried.
    tried_section,
    tried_about,
    col_form,
    col_probability,
    col_error_left,
    col_log_odds,
    col_strange,
    col_tests_better,
    look,
    // What to measure next.
    limits_section,
    next_tests_section,
    cannot_show_section,
    all_would_show,
    col_cannot_show,
    cannot_show_caption,
    col_next_amplitude,
    col_next_frequency,
    col_next_mean,
    col_side_force,
    col_difference_rms,
    col_what_to_do,
    next_tests_caption,
    // Parameters of the improved model.
    source_refitted,
    source_added,
    // Many dampers.
    groups_title,
    groups_subtitle,
    groups_section,
    groups_caption,
    group_against,
    col_group,
    col_answer,
    col_named,
    col_before_n,
    col_after_n,
    col_group_noise,
    no_change,
    not_compared,
    other_groups,
    plot_group_curves,
    group_curves_caption,
    numbers_section,
    numbers_caption,
    col_quantity,
    measurement_section,
    aside_section,
    aside,
    without_test,
);

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Names of the figures that a text takes.
    pub fn figures(text: &str) -> BTreeSet<&str> {
        text.split('{').skip(1).filter_map(|rest| rest.split('}').next()).collect()
    }

    #[test]
    fn every_language_has_every_text_with_the_same_figures() {
        for (code, language) in Language::ALL {
            let words = language.words();
            assert_eq!(words.code, code);
            for ((name, text), (_, english)) in words.all().into_iter().zip(EN.all()) {
                assert!(!text.trim().is_empty(), "{code}: {name} is empty");
                assert_eq!(figures(text), figures(english), "{code}: {name}");
                // Sentences are translated, not copied.
                let is_sentence = english.split(' ').count() > 3;
                assert!(language == Language::English || !is_sentence || text != english, "{code}: {name}");
            }
        }
    }

    #[test]
    fn titles_of_axes_end_with_their_unit() {
        // The read-out of the figures takes name and unit from here.
        for (code, language) in Language::ALL {
            for (name, text) in language.words().all().into_iter().filter(|(name, _)| name.starts_with("axis_")) {
                assert!(text.contains(", "), "{code}: {name} is {text:?}");
            }
        }
    }

    #[test]
    fn languages_are_asked_for_by_their_code() {
        assert_eq!("DE".parse(), Ok(Language::German));
        assert!("klingon".parse::<Language>().unwrap_err().contains("en, de, fr and zh"));
    }

    #[test]
    fn numbers_are_written_as_the_language_does() {
        for (words, expected) in [(&EN, "−1.048 … 2.5 N/mm"), (&DE, "−1,048 … 2,5 N/mm"), (&FR, "−1,048 … 2,5 N/mm")]
        {
            assert_eq!(words.number("-1.048 … 2.5 N/mm"), expected);
        }
        assert_eq!(TERMINAL.number("-1.048"), "-1.048");
        assert_eq!(DE.number("2.50·10⁻⁸"), "2,50·10⁻⁸");
        assert_eq!(DE.number("1.2e-5"), "1,2e-5");
        // A command keeps its point, and so does a name.
        let figures = [("value", "1.5"), ("option", "--delay=0.0065"), ("test", "2.5")];
        assert_eq!(DE.fill("{value} {option} {test}", &figures), "1,5 --delay=0.0065 2.5");
    }

    #[test]
    fn no_text_in_german_or_french_has_a_decimal_point() {
        for words in [DE, FR] {
            for (name, text) in words.all() {
                let parts: Vec<&str> = text.split('.').collect();
                let point = parts.windows(2).any(|p| {
                    p[0].ends_with(|c: char| c.is_ascii_digit()) && p[1].starts_with(|c: char| c.is_ascii_digit())
                });
                assert!(!point, "{}: {name}", words.code);
            }
        }
    }

    #[test]
    fn figures_are_put_in_by_name() {
        assert_eq!(fill("{a} of {b}, {a}", &[("a", "1"), ("b", "{a}")]), "1 of {a}, 1");
    }
}
