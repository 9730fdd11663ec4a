//! Rig records: reads files of all common formats, cleans them and reports each change.
//!
//! [`load`] is the entry point. Its results are in SI units, with rebound (extension) and tension positive.
//!
//! Each folder of `src` uses only the files directly in `src` and the folders before it in this list: `messages`,
//! `quantities`, `dates`, `data`, `columns`, `formats`, `signal`, `cleaning`, `checks`, `settings`, `peaks`,
//! `campaign`.

mod campaign;
mod checks;
mod cleaning;
mod columns;
mod data;
mod dates;
mod error;
mod file_extensions;
#[cfg(test)]
mod fixtures;
mod formats;
pub mod glob;
mod messages;
mod numbers;
mod options;
mod peaks;
mod quantities;
mod settings;
mod signal;
mod source;
mod texts;
mod tuning;

pub use campaign::common_clock::apart;
pub use campaign::imposed_motion::{MotionRecord, read_force_of_motion, read_motion};
pub use campaign::loading::{Campaign, Progress, load};
pub use campaign::motion_setting::{MotionSetting, SettingSource};
pub use campaign::profile::Profile;
pub use campaign::rig_sign::agree_on_sign;
pub use campaign::unusable::Unusable;
pub use campaign::{groups, hold_out, profile};
pub use checks::sign::SignFinding;
pub use columns::delimiter;
pub use data::record::{self, Noise, NoiseSource, Note, Record};
pub use data::rig_frame::{RigFrame, RigSine};
pub use data::setting_signal::{SettingPattern, SettingSignal, SettingStep};
pub use data::test_metadata::TestMetadata;
pub use dates::clock;
pub use dates::date_order::DateOrder;
pub use error::{
    ColumnError, FilesUnit, ImposedMotionError, Place, PlausibilityError, RecordError, RecordFileError, SampleError,
    SelectionError,
};
pub use file_extensions::{EXTENSIONS, is_record_name};
pub use formats::csv::text;
pub use messages::newtons;
pub use numbers::{restrict, split_unit};
pub use options::{Options, Positive};
pub use peaks::columns::{PeakColumn, PeakOptions, PeakPair, Stroke, Taken};
pub use peaks::table::{PeakPoint, Peaks, StrokeSource, peak_clicks, read_peaks};
pub use quantities::channel::{Channel, assignment};
pub use quantities::load_cell;
pub use quantities::motion_limit::motion_limit;
pub use quantities::reading::{Reading, digits, round_figure};
pub use quantities::reading_unit::reading_unit;
pub use quantities::setting_rules::SettingRules;
pub use quantities::setting_value::{Setting, is_same_setting, restate_in_unit, setting_factor, setting_in_words};
pub use quantities::stated_setting::{StatedSetting, WITHOUT_SETTING};
pub use quantities::unit::{Dimension, Unit};
pub use settings::assignment::{not_one_damper, records_without_setting, unread_current};
pub use settings::correction::correct_setting;
pub use signal::delay::Delay;
pub use signal::{measurement_correction, smoothing};
pub use source::{read_regular, read_small, read_small_text};
pub use texts::{templates, words};
