//! The groups of the parameter table: the rows of each element, and its position in the model.

use crate::list::each_element;
use crate::schema::{Describe, Group};
use crate::tables::Owned as T;

/// Position of an element in the model; corresponds to the blocks of the element list ([`mod@crate::list`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Acts {
    /// The FV curve.
    Primary,
    /// The series compliance.
    Series,
    /// A part of the force law of the series compliance.
    SeriesLaw,
    /// Between the internal mass and the FV curve.
    Hydraulic,
    /// On the internal mass.
    Inner,
    /// Parallel to the damper: friction.
    Friction,
    /// Parallel to the damper: gas forces without internal state.
    Preload,
    /// Parallel to the damper, with an internal state.
    Stateful,
    /// Parallel to the damper, at the ends of the stroke.
    Stop,
    /// No position: the settings of the integration.
    Nowhere,
}

/// Expands the list of elements into the groups of the parameter table.
macro_rules! groups {
    (
        primary { $primary:ident: $Primary:ty }
        series { $series:ident: $Series:ty }
        series_law { $($law:ident: $Law:ty,)* }
        hydraulic { $($hydraulic:ident: $Hydraulic:ty,)* }
        late { $late:ident: $Late:ty }
        inner { $($inner:ident: $Inner:ty,)* }
        friction { $($friction:ident: $Friction:ty,)* }
        preload { $($preload:ident: $Preload:ty,)* }
        stateful { $($stateful:ident: $Stateful:ty,)* }
        stops { $($stop:ident: $Stop:ty,)* }
        default { $($default:ident,)* }
        settings { $settings:ident: $Settings:ty }
    ) => {
        /// Indices of the elements in [`GROUPS`].
        #[allow(non_camel_case_types, missing_docs, clippy::upper_case_acronyms)]
        #[derive(Clone, Copy)]
        pub(crate) enum GroupIndex { $primary, $series, $($law,)* $($hydraulic,)* $late, $($inner,)* $($friction,)* $($preload,)* $($stateful,)* $($stop,)* $settings }

        /// Groups of the parameter table: the elements in the order of the element list, then the settings of the
        /// integration.
        // This is a static, so that a program contains the texts only once instead of once per crate.
        pub static GROUPS: &[Group] = &[
            Group { name: stringify!($primary), meaning: <$Primary>::MEANING, parameters: <$Primary>::PARAMETERS },
            Group { name: stringify!($series), meaning: <$Series>::MEANING, parameters: <$Series>::PARAMETERS },
            $(Group { name: stringify!($law), meaning: <$Law>::MEANING, parameters: <$Law>::PARAMETERS },)*
            $(Group {
                name: stringify!($hydraulic),
                meaning: <$Hydraulic>::MEANING,
                parameters: <$Hydraulic>::PARAMETERS,
            },)*
            Group { name: stringify!($late), meaning: <$Late>::MEANING, parameters: <$Late>::PARAMETERS },
            $(Group { name: stringify!($inner), meaning: <$Inner>::MEANING, parameters: <$Inner>::PARAMETERS },)*
            $(Group { name: stringify!($friction), meaning: <$Friction>::MEANING, parameters: <$Friction>::PARAMETERS },)*
            $(Group { name: stringify!($preload), meaning: <$Preload>::MEANING, parameters: <$Preload>::PARAMETERS },)*
            $(Group { name: stringify!($stateful), meaning: <$Stateful>::MEANING, parameters: <$Stateful>::PARAMETERS },)*
            $(Group { name: stringify!($stop), meaning: <$Stop>::MEANING, parameters: <$Stop>::PARAMETERS },)*
            Group { name: stringify!($settings), meaning: <$Settings>::MEANING, parameters: <$Settings>::PARAMETERS },
        ];

        /// Returns the position of a group's element in the model.
        pub fn acts(group: usize) -> Acts {
            const fn acts(place: Acts, _: GroupIndex) -> Acts {
                place
            }
            const ACTS: &[Acts] = &[
                Acts::Primary,
                Acts::Series,
                $(acts(Acts::SeriesLaw, GroupIndex::$law),)*
                $(acts(Acts::Hydraulic, GroupIndex::$hydraulic),)*
                Acts::Hydraulic,
                $(acts(Acts::Inner, GroupIndex::$inner),)*
                $(acts(Acts::Friction, GroupIndex::$friction),)*
                $(acts(Acts::Preload, GroupIndex::$preload),)*
                $(acts(Acts::Stateful, GroupIndex::$stateful),)*
                $(acts(Acts::Stop, GroupIndex::$stop),)*
            ];
            ACTS.get(group).copied().unwrap_or(Acts::Nowhere)
        }

        /// Number of elements, which is the number of groups without that of the integration's settings.
        pub const ELEMENTS: usize = GroupIndex::$settings as usize;

        /// Bit set of the elements of the default model; the bit of an element is its index in [`GROUPS`].
        pub const DEFAULT_ON: u64 = 0 $(| 1 << GroupIndex::$default as usize)*;
    };
}

each_element!(groups);

/// Returns the names of all elements, in the order of the element list.
pub fn names() -> impl Iterator<Item = &'static str> {
    GROUPS.iter().take(ELEMENTS).map(|group| group.name)
}
