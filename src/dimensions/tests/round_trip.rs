//! Round trip of the forward and the inverse formulas. A model with the parameters that a drawing implies is explained,
//! and the explanation gives the entries of the drawing again.

use dashpot_dimensions::orifice::quadratic_force;
use dashpot_dimensions::{Dimensions, explain, forward, geometry, read};
use dashpot_identification::model_file::of_text;
use dashpot_test_support::drawn;
use proptest::prelude::*;
use std::path::Path;

const RIGID: &str = "tube_wall_mm = 50\ntube_modulus_gpa = 400\n";
/// Eyes that are much stiffer than any oil column. The range is narrow: with the ordinary tolerance of eyes, a softer eye
/// is as likely a cause of a contradiction as a wrong length.
const STIFF_EYES: &str = "eye_stiffness_n_mm = [0.98e6, 1e6]\n";
/// Center of the range of [`STIFF_EYES`], N/m.
const STIFFNESS_OF_EYES: f64 = 0.99e9;

fn drawing(text: &str) -> Dimensions {
    read::parse(text, Path::new("drawing.toml")).unwrap()
}

/// Returns the value of a parameter that a drawing implies.
fn expected(of: &Dimensions, name: &str) -> f64 {
    let all = forward::expectations(of);
    all.iter().find(|e| e.number.name() == name).unwrap_or_else(|| panic!("{name}: {all:?}")).expected.value
}

/// Computes the stiffness of a column in series with [`STIFF_EYES`], N/m.
fn with_stiff_eyes(column: f64) -> f64 {
    1.0 / (1.0 / column + 1.0 / STIFFNESS_OF_EYES)
}

proptest! {
    #![proptest_config(drawn(60))]

    #[test]
    fn a_model_of_a_drawing_explains_it(
        bore in 25.0f64..60.0,
        part in 0.25f64..0.7,
        length in 60.0f64..300.0,
        pressure in 1.0f64..40.0,
        volume in 40.0f64..300.0,
        modulus in 0.9f64..1.7,
        bleed in 1.0f64..10.0,
        laminar in 200.0f64..3000.0,
    ) {
        let rod = part * bore;
        let text = format!(
            "design = \"monotube\"\nbore_mm = {bore}\nrod_mm = {rod}\nrebound_chamber_mm = {length}\n\
             gas_pressure_bar = {pressure}\ngas_volume_cm3 = {volume}\noil_modulus_gpa = {modulus}\n{RIGID}{STIFF_EYES}"
        );
        let full = drawing(&text);
        let area = geometry::annulus(1e-3 * bore, 1e-3 * rod);
        let b = quadratic_force(1e-6 * bleed, area, 0.7, 850.0);
        let force = |w: f64| laminar * w + b * w * w;
        // The blow-off valve opens at 0.1 m/s, the knee of the curve.
        let knee = force(0.1);
        let forces = [-1.2 * knee, -knee, -force(0.05), -force(0.02), 0.0, force(0.02), force(0.05), knee, 1.2 * knee];
        let model = of_text(
            &format!(
                "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"gas_spring\", \"oil_compressibility\"]\n\
                 gas_force = {}\ngas_stiffness = {}\noil_stiffness = {}\noil_shortening = 0.0\n\
                 fv_velocity = [-0.5, -0.1, -0.05, -0.02, 0.0, 0.02, 0.05, 0.1, 0.5]\nfv_force = {forces:?}\n",
                expected(&full, "gas_force"),
                expected(&full, "gas_stiffness"),
                with_stiff_eyes(expected(&full, "oil_stiffness")),
            ),
            Path::new("model.toml"),
        ).unwrap();
        let explanation = explain(&model, &full);
        prop_assert!(explanation.contradictions.is_empty(), "{explanation:?}");
        for (name, truth) in [
            ("gas_pressure", pressure),
            ("gas_volume", volume),
            ("oil_modulus", modulus),
            ("rebound_bleed_area", bleed),
            ("compression_bleed_area", bleed),
        ] {
            let found = explanation.find(name).unwrap();
            let value = found.value.unwrap();
            // Density and discharge coefficient have the central values of the handbooks, so the error of the result is
            // due only to the tube.
            prop_assert!((value / truth - 1.0).abs() < 0.01, "{name}: {value}, {truth}");
            prop_assert!(found.low.unwrap() < truth && truth < found.high.unwrap(), "{found:?}");
        }
    }

    #[test]
    fn a_narrower_entry_gives_a_narrower_interval_and_a_longer_column_a_softer_one(
        length in 60.0f64..200.0,
        wide in 1.05f64..1.5,
    ) {
        let column = |length: f64, factor: f64| {
            let text = format!("bore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = [{}, {}]\n{RIGID}", length / factor, length * factor);
            let all = forward::expectations(&drawing(&text));
            all.into_iter().find(|e| e.number.name() == "oil_stiffness").unwrap().expected
        };
        let (narrow, wider) = (column(length, 1.01), column(length, wide));
        prop_assert!(narrow.factor() < wider.factor());
        prop_assert!(column(1.2 * length, 1.01).value < narrow.value);
    }

    #[test]
    fn a_wrong_entry_is_named_with_its_value_and_doubts_no_other(
        length in 80.0f64..200.0,
        factor in prop_oneof![0.35f64..0.5, 2.0f64..3.0],
    ) {
        let text = |length: f64| format!(
            "bore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = {length}\ngas_pressure_bar = 20\noil_modulus_gpa = [1.2, 1.3]\n{RIGID}{STIFF_EYES}"
        );
        let (right, wrong) = (drawing(&text(length)), drawing(&text(factor * length)));
        let model = of_text(
            &format!(
                "format = 1\nelements = [\"gas_preload\", \"oil_compressibility\"]\ngas_force = {}\noil_stiffness = {}\noil_shortening = 0.0\n",
                expected(&right, "gas_force"), with_stiff_eyes(expected(&right, "oil_stiffness")),
            ),
            Path::new("model.toml"),
        ).unwrap();
        prop_assert!(explain(&model, &right).contradictions.is_empty());
        let explanation = explain(&model, &wrong);
        let found = &explanation.contradictions[0];
        prop_assert_eq!(found.causes[0].entry, "rebound_chamber_mm");
        prop_assert!((found.causes[0].value / length - 1.0).abs() < 0.02, "{found:?}");
        // A wrong rod diameter would need a far larger change to explain the contradiction, so the gas pressure is not
        // in doubt.
        let pressure = explanation.find("gas_pressure").unwrap();
        prop_assert!(pressure.note.is_none(), "{pressure:?}");
        let modulus = explanation.find("oil_modulus_effective").unwrap();
        prop_assert!(modulus.note.as_ref().unwrap().to_string().contains("rebound_chamber_mm"), "{modulus:?}");
    }

    #[test]
    fn a_spring_stiffer_than_the_drawn_gas_is_partly_another_spring(ratio in 2.5f64..5.0, volume in 60.0f64..300.0) {
        let of = |drawn: &str| {
            let text = format!("rod_mm = 12\ngas_pressure_bar = 20\n{drawn}");
            let stated = drawing(&format!("rod_mm = 12\ngas_pressure_bar = 20\ngas_volume_cm3 = {volume}\n"));
            let spring = ratio * expected(&stated, "gas_stiffness");
            let model = of_text(
                &format!("format = 1\nelements = [\"parallel_spring\"]\nspring_linear = {spring}\n"),
                Path::new("model.toml"),
            ).unwrap();
            explain(&model, &drawing(&text)).find("gas_volume").unwrap().clone()
        };
        let found = of("");
        prop_assert!((found.value.unwrap() * ratio / volume - 1.0).abs() < 0.01, "{found:?}");
        prop_assert!(!found.note.unwrap().to_string().contains("another spring"));
        let noted = of(&format!("gas_volume_cm3 = {volume}\n")).note.unwrap().to_string();
        prop_assert!(noted.contains(&format!("give about {:.0} %", 100.0 / ratio)), "{noted}, {ratio}");
    }

    #[test]
    fn eyes_belong_to_the_column_of_a_model_without_a_series_spring(
        length in 80.0f64..200.0,
        modulus in 0.9f64..1.5,
        share in 4.0f64..8.0,
    ) {
        let text = format!("bore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = {length}\noil_modulus_gpa = {modulus}\n{RIGID}");
        let column = expected(&drawing(&text), "oil_stiffness");
        let eyes = share * column;
        let stated = drawing(&format!("{text}eye_stiffness_n_mm = {}\n", 1e-3 * eyes));
        let model = of_text(
            &format!(
                "format = 1\nelements = [\"oil_compressibility\"]\noil_stiffness = {}\noil_shortening = 0.0\n",
                1.0 / (1.0 / column + 1.0 / eyes),
            ),
            Path::new("model.toml"),
        ).unwrap();
        let explanation = explain(&model, &stated);
        prop_assert!(explanation.contradictions.is_empty(), "{explanation:?}");
        let found = explanation.find("oil_modulus").unwrap();
        prop_assert!((found.value.unwrap() / modulus - 1.0).abs() < 0.02, "{found:?}");
    }

    #[test]
    fn eyes_softer_than_the_whole_give_no_bound_of_the_modulus(
        length in 80.0f64..200.0,
        modulus in 0.9f64..1.5,
        share in 0.2f64..1.0,
        is_series in any::<bool>(),
    ) {
        let text = format!("bore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = {length}\n{RIGID}");
        let whole = expected(&drawing(&format!("{text}oil_modulus_gpa = {modulus}\n")), "oil_stiffness");
        let stated = drawing(&format!("{text}eye_stiffness_n_mm = {}\n", 1e-3 * share * whole));
        let model = match is_series {
            true => format!("elements = [\"series_compliance\"]\nseries_stiffness = {whole}\n"),
            false => format!("elements = [\"oil_compressibility\"]\noil_stiffness = {whole}\noil_shortening = 0.0\n"),
        };
        let model = of_text(&format!("format = 1\n{model}"), Path::new("model.toml")).unwrap();
        let explanation = explain(&model, &stated);
        prop_assert!(explanation.find("oil_modulus_effective").is_none(), "{explanation:?}");
        let gap = explanation.unknown.iter().find(|gap| gap.name == "oil_modulus_effective").unwrap();
        prop_assert!(gap.why.to_string().contains("softer than eyes and oil together"), "{gap:?}");
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in "[a-z_0-9 =.\\[\\]\"\n-]{0,80}", key in 0usize..5) {
        let key = ["bore_mm", "rod_mm", "design", "gas_pressure_bar", "air_percent"][key];
        let _ = read::parse(&text, Path::new("drawing.toml"));
        let _ = read::parse(&format!("{key} = {text}"), Path::new("drawing.toml"));
    }
}
