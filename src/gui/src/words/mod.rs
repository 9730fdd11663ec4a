//! All texts of the window, in every language. `src/gui/locales` contains one Fluent file per language.

use crate::units;
use dashpot_messages::{Catalog, Message};
use dashpot_records::Channel;
use std::sync::LazyLock;

pub use dashpot_report::words::Language;

/// Returns the name of a language in that language.
pub fn name(language: Language) -> &'static str {
    match language {
        Language::English => "English",
        Language::German => "Deutsch",
        Language::French => "Français",
        Language::Chinese => "中文",
    }
}

/// Returns the texts of the window in a language. [`Language::words`] returns those of the reports.
pub fn texts(language: Language) -> &'static Words {
    match language {
        Language::English => &EN,
        Language::German => &DE,
        Language::French => &FR,
        Language::Chinese => &ZH,
    }
}

static EN: LazyLock<Words> = LazyLock::new(|| read(Language::English, "en", include_str!("../../locales/en.ftl")));
static DE: LazyLock<Words> = LazyLock::new(|| read(Language::German, "de", include_str!("../../locales/de.ftl")));
static FR: LazyLock<Words> = LazyLock::new(|| read(Language::French, "fr", include_str!("../../locales/fr.ftl")));
static ZH: LazyLock<Words> = LazyLock::new(|| read(Language::Chinese, "zh", include_str!("../../locales/zh.ftl")));

fn read(language: Language, code: &str, source: &str) -> Words {
    let catalog = Catalog::keep(code, source);
    Words::read(catalog, language, catalog)
}

/// Returns the language of the system from its environment variables, or English if they name no language of the reports.
pub fn of_system() -> Language {
    let said =
        ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(|name| std::env::var(name).ok().filter(|v| !v.is_empty()));
    of_locale(&said.unwrap_or_default())
}

fn of_locale(locale: &str) -> Language {
    locale.get(..2).unwrap_or_default().parse().unwrap_or_default()
}

impl Words {
    /// Formats a message with its arguments by name. Numbers and names have the format of the reports.
    pub fn fill(&self, message: Message, values: &[(&str, &str)]) -> String {
        self.of.words().fill_from(self.catalog, message, values)
    }

    /// Formats a number with four significant digits for this language. Input fields use [`Words::typed`].
    pub fn digits(&self, value: f64) -> String {
        self.of.words().number(&units::digits(value))
    }

    /// Formats a number with a given number of decimals for this language.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        self.of.words().number(&format!("{value:.decimals$}"))
    }

    /// Formats a number for an input field ([`units::typed`]). [`units::read`] parses it.
    pub fn typed(&self, value: f64) -> String {
        units::typed(value).replace('.', self.of.words().decimal_sign)
    }

    /// Returns the name of a channel.
    pub fn channel(&self, channel: Channel) -> &'static str {
        match channel {
            Channel::Time => self.time,
            Channel::Displacement => self.displacement,
            Channel::Velocity => self.velocity,
            Channel::Force => self.force,
            Channel::SideForce => self.side_force,
            Channel::Temperature => self.temperature,
            Channel::Current => self.current,
            Channel::Setting => self.setting,
        }
    }
}

dashpot_messages::interface! {
    /// All texts of the window in one language. `src/gui/locales` contains them under these names in kebab-case.
    #[allow(missing_docs)] // the texts are their meaning
    pub struct Words {
        pub of: Language,
        catalog: &'static Catalog,
        ;
        file,
        open_folder,
        open_files,
        open_model,
        compare_campaign,
        compare_no_more,
        recent,
        save,
        save_as,
        write_report,
        save_tables,
        undo,
        redo,
        reset,
        reset_hint,
        fit,
        fit_hint,
        /// Fit of one damper over `{setting}`.
        fit_over(setting),
        fit_over_hint,
        fit_ordinary,
        fit_ordinary_hint,
        validate,
        validate_hint,
        diagnose,
        diagnose_hint,
        /// Reason why no ticked test can be diagnosed.
        diagnose_elsewhere,
        export,
        export_fmu,
        export_fmu3,
        export_vehicle,
        export_adams,
        export_property,
        cancel,
        reading,
        fitting,
        validating,
        diagnosing,
        studying,
        writing,
        stopping,
        tests_in,
        computed_in,
        tests,
        all,
        all_hint,
        filter,
        tick_hint,
        use_test,
        exclude,
        exclude_hint,
        welcome,
        welcome_hint,
        drop_here,
        amplitude,
        frequency,
        peak_velocity,
        largest_force,
        cycles,
        work,
        noise,
        mean_error,
        mean,
        rebound_positive,
        compression_positive,
        force,
        velocity,
        displacement,
        time,
        temperature,
        current,
        force_velocity,
        force_displacement,
        force_time,
        peaks,
        measured,
        reference,
        model,
        identified_model,
        opened_model,
        with_effect,
        fv_curve,
        fv_points,
        save_plot,
        error_matrix,
        error_hint,
        slow_tests,
        language,
        light,
        dark,
        not_periodic,
        tune,
        result,
        records,
        study,
        no_model,
        /// Name of the setting of an adjustable damper whose model file does not name it.
        setting,
        /// Meaning of the slider over the setting.
        setting_hint,
        /// Meaning of the field for the setting of a test.
        test_setting_hint,
        /// Meaning of the button that removes a correction of a test's setting.
        setting_as_read,
        /// Label of the choice that each test is simulated at its own setting.
        own_settings,
        own_settings_hint,
        /// Reason why the slider over the setting is disabled.
        setting_tuned,
        /// Suffix to the name of a test whose setting changes.
        setting_changes,
        /// Suffix to the name of a test whose setting is not that of the model.
        setting_of_another(setting),
        unsaved_model,
        not_saved,
        rejected,
        prior,
        interval,
        identified,
        as_opened,
        not_identified,
        back_to_identified,
        elements_off,
        drag_points,
        no_result,
        fit_result,
        validation_result,
        diagnosis_result,
        tests_fitted,
        used_in_fit,
        left_out,
        all_tests,
        fitted,
        before,
        after,
        rms,
        sure,
        of_the_rig,
        next_test,
        copy_rows,
        copy_rows_hint,
        save_matrix,
        save_matrix_hint,
        gas_and_drag,
        both_ways,
        drag,
        changed,
        take_improved,
        how_read,
        how_read_hint,
        positive,
        from_data,
        rebound,
        compression,
        flip_force,
        flip_motion,
        delay,
        force_zero,
        displacement_zero,
        gain,
        rig_mass,
        sample_rate,
        dates,
        day_first,
        month_first,
        subfolders,
        unit_of,
        as_file_says,
        excluded,
        take_back,
        read_again,
        read_again_hint,
        keep_reading,
        keep_reading_hint,
        study_hint,
        from,
        to,
        loops,
        compute,
        area,
        gap,
        effect_inspect,
        effect_hint,
        strength,
        none,
        closing,
        closing_task,
        closing_unsaved,
        stay,
        save_first,
        close_anyway,
        replacing,
        replacing_unsaved,
        replace_anyway,
        old_result,
        percent_of,
        diagnosed_at(tests setting),
        provisional,
        steady_force,
        stop_at_rest,
        stop_force,
        stop_velocity,
        stop_bound,
        unit_of_velocity,
        unit_of_force,
        tables,
        tables_hint,
        pvp,
        cvp,
        opening,
        closing_speed,
        save_table,
        test,
        choose_path,
        choose_folder,
        no_dialog,
        path,
        folder_up,
        ok,
        is_there_already,
        side_force,
        open_dimensions,
        valve,
        of_force,
        of_valve,
        awaiting,
        all_steps,
        drawing,
        no_explained,
        nothing_explained,
        contradictions,
        quantities,
        unknown_quantities,
        drawing_lacks,
        model_lacks,
        at_least,
        at_most,
        no_bound,
        follows_from,
        form_error,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_messages::file;
    use std::collections::BTreeMap;

    /// Name and text of the Fluent file of each language.
    const FILES: [(&str, &str); 4] = [
        ("src/gui/locales/en.ftl", include_str!("../../locales/en.ftl")),
        ("src/gui/locales/de.ftl", include_str!("../../locales/de.ftl")),
        ("src/gui/locales/fr.ftl", include_str!("../../locales/fr.ftl")),
        ("src/gui/locales/zh.ftl", include_str!("../../locales/zh.ftl")),
    ];

    #[test]
    fn every_file_has_every_message_that_the_code_uses_and_no_other() {
        let of = |arguments: &[&str]| arguments.iter().map(ToString::to_string).collect();
        let used = Words::MESSAGES.iter().map(|(id, arguments)| (id.to_string(), of(arguments))).collect();
        let faults: Vec<String> = FILES.iter().flat_map(|(name, source)| file::faults(name, source, &used)).collect();
        assert!(faults.is_empty(), "{}", faults.join("\n"));
    }

    #[test]
    fn sentences_are_translated_and_not_copied() {
        let [english, others @ ..] = FILES.map(|(name, source)| (name, file::read(source)));
        let english: BTreeMap<String, String> = english.1.into_iter().map(|entry| (entry.id, entry.text)).collect();
        for (name, entry) in others.into_iter().flat_map(|(name, all)| all.into_iter().map(move |entry| (name, entry)))
        {
            let is_sentence = english[&entry.id].split(' ').count() > 3;
            assert!(!is_sentence || entry.text != english[&entry.id], "{name}: {}", entry.id);
        }
    }

    #[test]
    fn the_locale_chooses_the_language() {
        for (locale, wanted) in [
            ("de_DE.UTF-8", Language::German),
            ("fr", Language::French),
            ("zh_CN", Language::Chinese),
            ("C.UTF-8", Language::English),
            ("", Language::English),
        ] {
            assert_eq!(of_locale(locale), wanted, "{locale}");
        }
    }
}
