//! The one list of the elements in the way of the force.
//!
//! - `primary` (the FV curve) and `series` (the compliance with its mass) make the frame that the others act in;
//! - `series_law`: bends the law of the series compliance (see [`super::series`]);
//! - `hydraulic`: between the internal mass and the FV curve (see [`super::hydraulic`]);
//! - `late`: the last of these, which keeps a large table.
//!
//! `T` stands for whoever keeps the tables of an element ([`crate::tables`]): who calls the list has it in scope.
//!
//! What they need of each other is said in this folder: which states they have and where those are kept ([`super::slots`]), which of them act in a
//! stage ([`super::acting`]), and what one gives another ([`super::Paths::join`]).

/// Calls the macro `then!` with the list, and with what comes behind it.
macro_rules! each_path_element {
    ($then:ident $($behind:tt)*) => {
        $then! {
            primary { fv_curve: $crate::elements::fv_curve::FvCurve }
            series { series_compliance: $crate::elements::series_compliance::SeriesCompliance }
            series_law {
                free_play: $crate::elements::free_play::FreePlay,
                bushing: $crate::elements::bushing::Bushing,
            }
            hydraulic {
                oil_compressibility: $crate::elements::oil_compressibility::OilCompressibility,
                aeration: $crate::elements::aeration::Aeration,
                cavitation: $crate::elements::cavitation::Cavitation,
                position_dependent_damping: $crate::elements::position_dependent_damping::PositionDependentDamping,
                temperature_fade: $crate::elements::temperature_fade::TemperatureFade,
                frequency_selective_damping: $crate::elements::frequency_selective_damping::FrequencySelectiveDamping,
            }
            late { valve_hysteresis: $crate::elements::valve_hysteresis::ValveHysteresis<T> }
            $($behind)*
        }
    };
}
pub(crate) use each_path_element;
