//! Comparison of the laws of the second laboratory with those of the kernel's elements.
//!
//! If a law becomes part of the kernel, it is no longer independent evidence, so the laboratory must drop it.

use dashpot_core::parameter::GROUPS;
use dashpot_other_lab::effects::KNOWN;
use std::collections::{BTreeMap, BTreeSet};

/// Every element of the kernel: name, number of parameters, and the laws of the element by their names in the second
/// laboratory. A new parameter may mean a new form, so the test also compares the numbers of parameters.
const KERNEL: &[(&str, usize, &[&str])] = &[
    ("fv_curve", 12, &["table", "piecewise_linear"]),
    ("integration", 2, &[]),
    ("series_compliance", 4, &["voigt"]),
    ("bushing", 8, &["cubic", "maxwell", "berg", "smooth_stop"]),
    ("free_play", 3, &["softened_gap", "softened_gap_under_load"]),
    ("oil_compressibility", 4, &["column", "shortening_column", "uneven_column"]),
    ("aeration", 3, &["hyperbolic_bubbles"]),
    ("cavitation", 8, &["capped_void", "expanding_void", "unfilled_foot_valve"]),
    ("parallel_spring", 6, &["polynomial", "table"]),
    ("gas_preload", 1, &["constant"]),
    ("gas_warming", 2, &["in_proportion"]),
    ("gas_spring", 4, &["polytropic_wall_loss"]),
    ("coulomb_friction", 2, &["hyperbolic_tangent"]),
    ("stribeck_friction", 8, &["gaussian_peak", "generalised_stribeck"]),
    ("presliding_friction", 5, &["dahl", "symmetric_bouc_wen", "creeping_contact"]),
    ("viscous_friction", 1, &["square"]),
    ("side_force_friction", 2, &["proportional_load"]),
    ("position_dependent_damping", 7, &["smooth_zone_factor", "smooth_groove"]),
    ("bump_stop", 6, &["progressive_rubber", "hydraulic_exponent"]),
    ("rebound_stop", 6, &["progressive_rubber", "hydraulic_exponent"]),
    ("frequency_selective_damping", 7, &["lagged_filter", "filling_stroke", "filling_bypass"]),
    ("valve_hysteresis", 8, &["late_opening", "valve_play", "spool"]),
    ("temperature_fade", 7, &["exponential", "vogel"]),
    ("moving_mass", 3, &["constant_mass"]),
    ("lagged_polynomial", 5, &["lagged_polynomial"]),
];

/// Laws of the kernel as one set.
fn laws() -> BTreeSet<&'static str> {
    KERNEL.iter().flat_map(|(_, _, laws)| laws.iter().copied()).collect()
}

#[test]
fn every_form_of_every_element_has_been_compared_with_the_second_laboratory() {
    let listed: BTreeMap<&str, usize> = KERNEL.iter().map(|(name, count, _)| (*name, *count)).collect();
    let kernel: BTreeMap<&str, usize> = GROUPS.iter().map(|g| (g.name, g.parameters.len())).collect();
    assert_eq!(
        listed, kernel,
        "an element or a parameter is new: look whether a law of src/other_lab/src/effects is now one of the model's, take it out of the \
         laboratory if it is, and write its law down here"
    );
}

#[test]
fn no_law_that_is_hidden_is_one_of_the_models() {
    let kernel = laws();
    for effect in KNOWN {
        for (law, _) in effect.laws {
            assert!(
                !kernel.contains(law),
                "{}:{law} is in the kernel: another law has to be hidden in its place",
                effect.name
            );
        }
    }
}
