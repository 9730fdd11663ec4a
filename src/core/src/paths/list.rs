//! The list of the elements in the force path.
//!
//! - `primary` (the FV curve) and `series` (the compliance with its mass): the two elements that all others extend;
//! - `series_law`: elements that change the force law of the series compliance (see [`super::series`]);
//! - `hydraulic`: between the internal mass and the FV curve (see [`super::hydraulic`]);
//! - `late`: the last element of the hydraulic list, which contains a large table.
//!
//! `T` is the owner of an element's tables ([`crate::tables`]). `T` must be in scope where the list is expanded.
//!
//! The folder of this file also defines what the elements share. [`super::slots`] defines their states,
//! [`super::acting`] the elements that act in a stage, and [`super::Paths::join`] the data that one element passes to
//! another.

/// Calls the macro `then!` with the list and with the tokens that follow the macro's name.
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
