//! Every text of the window, in every language; one file a language. A text that a language lacks does not compile.

mod chinese;
mod english;
mod french;
mod german;

use crate::units;
use dashpot_records::Channel;

pub use dashpot_report::words::Language;

/// The name of a language in itself.
pub fn name(language: Language) -> &'static str {
    match language {
        Language::English => "English",
        Language::German => "Deutsch",
        Language::French => "Français",
        Language::Chinese => "中文",
    }
}

/// The window's texts in a language; [`Language::words`] has those of its reports.
pub fn texts(language: Language) -> &'static Words {
    match language {
        Language::English => &english::WORDS,
        Language::German => &german::WORDS,
        Language::French => &french::WORDS,
        Language::Chinese => &chinese::WORDS,
    }
}

/// The language that the system speaks, as its environment says; English where it says nothing known.
pub fn of_system() -> Language {
    let said =
        ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(|name| std::env::var(name).ok().filter(|v| !v.is_empty()));
    of_locale(&said.unwrap_or_default())
}

fn of_locale(locale: &str) -> Language {
    locale.get(..2).unwrap_or_default().parse().unwrap_or_default()
}

impl Words {
    /// A number with four significant digits, as this language writes it; also on axes and in tables. What is typed and files are [`Words::typed`]'s
    /// and the verbs'.
    pub fn digits(&self, value: f64) -> String {
        self.of.words().number(&units::digits(value))
    }

    /// A number with so many decimals.
    pub fn fixed(&self, value: f64, decimals: usize) -> String {
        self.of.words().number(&format!("{value:.decimals$}"))
    }

    /// A number for a field that is typed into ([`units::typed`]); [`units::read`] takes it back.
    pub fn typed(&self, value: f64) -> String {
        units::typed(value).replace('.', self.of.words().decimal_sign)
    }

    /// What an element or a parameter means; the reports say it with the same words.
    pub fn meaning(&self, english: &'static str) -> &'static str {
        self.of.words().meaning(english)
    }

    /// The name of a channel.
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

/// The texts; the English ones say what each is.
#[allow(missing_docs)] // the texts are their meaning
pub struct Words {
    pub of: Language,
    pub file: &'static str,
    pub open_folder: &'static str,
    pub open_files: &'static str,
    pub open_model: &'static str,
    pub compare_campaign: &'static str,
    pub compare_no_more: &'static str,
    pub recent: &'static str,
    pub save: &'static str,
    pub save_as: &'static str,
    pub write_report: &'static str,
    pub save_tables: &'static str,
    pub undo: &'static str,
    pub redo: &'static str,
    pub reset: &'static str,
    pub reset_hint: &'static str,
    pub fit: &'static str,
    pub fit_hint: &'static str,
    /// A fit of one damper over `{setting}`.
    pub fit_over: &'static str,
    pub fit_over_hint: &'static str,
    pub fit_ordinary: &'static str,
    pub fit_ordinary_hint: &'static str,
    pub validate: &'static str,
    pub validate_hint: &'static str,
    pub diagnose: &'static str,
    pub diagnose_hint: &'static str,
    /// Why there is nothing to diagnose.
    pub diagnose_elsewhere: &'static str,
    pub export: &'static str,
    pub export_fmu: &'static str,
    pub export_fmu3: &'static str,
    pub export_vehicle: &'static str,
    pub export_adams: &'static str,
    pub export_property: &'static str,
    pub cancel: &'static str,
    pub reading: &'static str,
    pub fitting: &'static str,
    pub validating: &'static str,
    pub diagnosing: &'static str,
    pub studying: &'static str,
    pub writing: &'static str,
    pub stopping: &'static str,
    pub tests_in: &'static str,
    pub computed_in: &'static str,
    pub tests: &'static str,
    pub all: &'static str,
    pub all_hint: &'static str,
    pub filter: &'static str,
    pub tick_hint: &'static str,
    pub use_test: &'static str,
    pub exclude: &'static str,
    pub exclude_hint: &'static str,
    pub welcome: &'static str,
    pub welcome_hint: &'static str,
    pub drop_here: &'static str,
    pub amplitude: &'static str,
    pub frequency: &'static str,
    pub peak_velocity: &'static str,
    pub largest_force: &'static str,
    pub cycles: &'static str,
    pub work: &'static str,
    pub noise: &'static str,
    pub mean_error: &'static str,
    pub mean: &'static str,
    pub rebound_positive: &'static str,
    pub compression_positive: &'static str,
    pub force: &'static str,
    pub velocity: &'static str,
    pub displacement: &'static str,
    pub time: &'static str,
    pub temperature: &'static str,
    pub current: &'static str,
    pub force_velocity: &'static str,
    pub force_displacement: &'static str,
    pub force_time: &'static str,
    pub peaks: &'static str,
    pub measured: &'static str,
    pub reference: &'static str,
    pub model: &'static str,
    pub identified_model: &'static str,
    pub with_effect: &'static str,
    pub fv_curve: &'static str,
    pub fv_points: &'static str,
    pub save_plot: &'static str,
    pub error_matrix: &'static str,
    pub error_hint: &'static str,
    pub slow_tests: &'static str,
    pub language: &'static str,
    pub light: &'static str,
    pub dark: &'static str,
    pub not_periodic: &'static str,
    pub tune: &'static str,
    pub result: &'static str,
    pub records: &'static str,
    pub study: &'static str,
    pub no_model: &'static str,
    /// The setting of a damper that depends on one and does not name it.
    pub setting: &'static str,
    /// What its slider shows.
    pub setting_hint: &'static str,
    /// Whether each test is compared with the damper at its own setting.
    pub own_settings: &'static str,
    pub own_settings_hint: &'static str,
    /// Why its slider stands still.
    pub setting_tuned: &'static str,
    /// Behind the name of a test whose setting changes.
    pub setting_changes: &'static str,
    /// Behind the name of a test whose setting is none of the model.
    pub setting_of_another: &'static str,
    pub unsaved_model: &'static str,
    pub not_saved: &'static str,
    pub rejected: &'static str,
    pub prior: &'static str,
    pub interval: &'static str,
    pub identified: &'static str,
    pub not_identified: &'static str,
    pub back_to_identified: &'static str,
    pub elements_off: &'static str,
    pub drag_points: &'static str,
    pub no_result: &'static str,
    pub fit_result: &'static str,
    pub validation_result: &'static str,
    pub diagnosis_result: &'static str,
    pub tests_fitted: &'static str,
    pub used_in_fit: &'static str,
    pub left_out: &'static str,
    pub all_tests: &'static str,
    pub fitted: &'static str,
    pub before: &'static str,
    pub after: &'static str,
    pub rms: &'static str,
    pub sure: &'static str,
    pub of_the_rig: &'static str,
    pub next_test: &'static str,
    pub copy_rows: &'static str,
    pub copy_rows_hint: &'static str,
    pub save_matrix: &'static str,
    pub save_matrix_hint: &'static str,
    pub gas_and_drag: &'static str,
    pub both_ways: &'static str,
    pub drag: &'static str,
    pub changed: &'static str,
    pub take_improved: &'static str,
    pub how_read: &'static str,
    pub how_read_hint: &'static str,
    pub positive: &'static str,
    pub from_data: &'static str,
    pub rebound: &'static str,
    pub compression: &'static str,
    pub flip_force: &'static str,
    pub flip_motion: &'static str,
    pub delay: &'static str,
    pub force_zero: &'static str,
    pub displacement_zero: &'static str,
    pub gain: &'static str,
    pub rig_mass: &'static str,
    pub sample_rate: &'static str,
    pub dates: &'static str,
    pub day_first: &'static str,
    pub month_first: &'static str,
    pub subfolders: &'static str,
    pub unit_of: &'static str,
    pub as_file_says: &'static str,
    pub excluded: &'static str,
    pub take_back: &'static str,
    pub read_again: &'static str,
    pub read_again_hint: &'static str,
    pub keep_reading: &'static str,
    pub keep_reading_hint: &'static str,
    pub study_hint: &'static str,
    pub from: &'static str,
    pub to: &'static str,
    pub loops: &'static str,
    pub compute: &'static str,
    pub area: &'static str,
    pub gap: &'static str,
    pub effect_inspect: &'static str,
    pub effect_hint: &'static str,
    pub strength: &'static str,
    pub none: &'static str,
    pub closing: &'static str,
    pub closing_task: &'static str,
    pub closing_unsaved: &'static str,
    pub stay: &'static str,
    pub save_first: &'static str,
    pub close_anyway: &'static str,
    pub replacing: &'static str,
    pub replacing_unsaved: &'static str,
    pub replace_anyway: &'static str,
    pub old_result: &'static str,
    pub steady_force: &'static str,
    pub stop_at_rest: &'static str,
    pub stop_force: &'static str,
    pub stop_velocity: &'static str,
    pub stop_bound: &'static str,
    pub unit_of_velocity: &'static str,
    pub unit_of_force: &'static str,
    pub tables: &'static str,
    pub tables_hint: &'static str,
    pub pvp: &'static str,
    pub cvp: &'static str,
    pub opening: &'static str,
    pub closing_speed: &'static str,
    pub save_table: &'static str,
    pub test: &'static str,
    pub choose_path: &'static str,
    pub choose_folder: &'static str,
    pub no_dialog: &'static str,
    pub path: &'static str,
    pub folder_up: &'static str,
    pub ok: &'static str,
    pub is_there_already: &'static str,
    pub side_force: &'static str,
    pub open_dimensions: &'static str,
    pub valve: &'static str,
    pub of_force: &'static str,
    pub of_valve: &'static str,
    pub awaiting: &'static str,
    pub all_steps: &'static str,
    pub drawing: &'static str,
    pub no_explained: &'static str,
    pub nothing_explained: &'static str,
    pub contradictions: &'static str,
    pub quantities: &'static str,
    pub unknown_quantities: &'static str,
    pub drawing_lacks: &'static str,
    pub model_lacks: &'static str,
    pub at_least: &'static str,
    pub at_most: &'static str,
    pub no_bound: &'static str,
    pub follows_from: &'static str,
    pub form_error: &'static str,
}

#[cfg(test)]
mod tests {
    use super::*;

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
