//! Tests of `dashpot` with a file of a damper's dimensions: explanation of a model, priors, and mistakes in the file.

use dashpot_tests::cli::{done, json, refused};
use std::path::Path;

/// Model file of a monotube. Its parameters correspond to a gas pressure of 25 bar on a rod of 12 mm diameter, and to
/// an oil modulus of 1.2 GPa.
const MODEL: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"oil_compressibility\"]\ngas_force = 282.74\n\
     oil_stiffness = 1.0554e7\noil_shortening = 7.69\nfv_velocity = [-1.0, -0.3, -0.1, -0.05, 0.0, 0.05, 0.1, 0.3, 1.0]\n\
     fv_force = [-900.0, -500.0, -300.0, -100.0, 0.0, 200.0, 600.0, 1000.0, 1500.0]\n\n[identification.intervals]\n\
     gas_force = [275.0, 290.0]\noil_stiffness = [1.0e7, 1.1e7]\n";
const DRAWING: &str = "design = \"monotube\"\nbore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = 130\n\
     tube_wall_mm = 50\ntube_modulus_gpa = 400\neye_stiffness_n_mm = 1e6\n";

fn folder(model: &str, drawing: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("m.toml"), model).unwrap();
    std::fs::write(folder.path().join("d.toml"), drawing).unwrap();
    folder
}

fn explained(dir: &Path) -> serde_json::Value {
    done(dir, &["explain", "m.toml", "--dimensions", "d.toml", "--json", "e.json"]);
    json(&dir.join("e.json"))
}

fn quantity<'a>(of: &'a serde_json::Value, name: &str) -> &'a serde_json::Value {
    of["quantities"].as_array().unwrap().iter().find(|q| q["name"] == name).unwrap_or_else(|| panic!("{name}: {of}"))
}

#[test]
fn pressure_and_modulus_come_back_with_intervals() {
    let folder = folder(MODEL, DRAWING);
    let found = explained(folder.path());
    for (name, truth, unit) in [("gas_pressure", 25.0, "bar gauge"), ("oil_modulus_effective", 1.2, "GPa")] {
        let quantity = quantity(&found, name);
        let number = |key: &str| quantity[key].as_f64().unwrap();
        // The stiffness of the eyes in the dimensions changes the modulus by about 1 %.
        assert!((number("value") / truth - 1.0).abs() < 0.015, "{quantity}");
        assert!(number("low") < truth && truth < number("high") && quantity["unit"] == unit, "{quantity}");
        assert!(number("model_error") > 1.0 && !quantity["from"].as_array().unwrap().is_empty(), "{quantity}");
    }
    assert_eq!(found["contradictions"].as_array().unwrap().len(), 0, "{found}");
    let told = done(folder.path(), &["explain", "m.toml", "--dimensions", "d.toml"]);
    assert!(told.contains("gas pressure             25.0 bar gauge, 95 %: "), "{told}");
}

#[test]
fn what_cannot_be_told_names_the_entry_or_the_parameter_that_is_missing() {
    let folder = folder(MODEL, "bore_mm = 40\n");
    let found = explained(folder.path());
    let gap = |name: &str| {
        let all = found["unknown"].as_array().unwrap();
        all.iter().find(|gap| gap["name"] == name).unwrap_or_else(|| panic!("{name}: {found}")).clone()
    };
    assert_eq!(gap("gas_pressure")["entries"], serde_json::json!(["rod_mm"]));
    assert_eq!(gap("gas_volume")["parameters"], serde_json::json!(["gas_stiffness"]));
    assert_eq!(gap("compression_bleed_area")["entries"], serde_json::json!(["rod_mm", "design"]));
    assert_eq!(gap("oil_modulus_effective")["entries"], serde_json::json!(["rod_mm", "rebound_chamber_mm"]));
}

#[test]
fn a_drawing_that_the_model_contradicts_is_reported_with_the_number_and_by_how_much() {
    let folder = folder(
        &MODEL.replace("282.74", "240.0").replace("[275.0, 290.0]", "[230.0, 250.0]"),
        "rod_mm = 11\ngas_pressure_bar = 12\n",
    );
    let found = explained(folder.path());
    let contradiction = &found["contradictions"][0];
    assert_eq!(
        contradiction["text"],
        "The gas force of the model, 240 N, is 2.1 times the 114 N that 12 bar on a rod of 11 mm give. \
         The smallest single change of the drawing that explains it is gas_pressure_bar = 25.3."
    );
    assert_eq!(contradiction["parameter"], "gas_force");
    assert!((contradiction["ratio"].as_f64().unwrap() - 240.0 / 114.04).abs() < 0.01, "{found}");
    let quantities = found["quantities"].as_array().unwrap();
    let pressure = quantities.iter().find(|of| of["name"] == "gas_pressure").unwrap();
    // The pressure follows from the gas force and the rod. With the stated pressure, the rod would need a diameter of
    // 16 mm, which is a rod of another damper. So the pressure is reported as the first cause.
    assert!(pressure.get("note").is_none(), "{found}");
    assert_eq!(contradiction["causes"][0]["entry"], "gas_pressure_bar", "{found}");
    assert_eq!(contradiction["entries"].as_array().unwrap().len(), 2);
}

#[test]
fn a_drawing_without_gas_pressure_is_contradicted_without_a_ratio() {
    let folder = folder(MODEL, "rod_mm = 12\ngas_pressure_bar = 0\n");
    let found = explained(folder.path());
    let text = found["contradictions"][0]["text"].as_str().unwrap();
    assert!(
        text.starts_with("The gas force of the model, 283 N, contradicts the 0 N of 0 bar on a rod of 12 mm."),
        "{text}"
    );
    assert!(text.contains("gas_pressure_bar = 25.0"), "{text}");
}

#[test]
fn a_quantity_from_a_doubtful_effect_says_so() {
    let note = "[identification]\nnotes = [\"oil_compressibility: 30 N rms, 9 % of the force; probability 11 %\"]\n\n";
    let model = MODEL.replace("[identification.intervals]", &format!("{note}[identification.intervals]"));
    let folder = folder(
        &model,
        &DRAWING.replace("tube_wall_mm = 50", "tube_wall_mm = 50\ngas_pressure_bar = 20\noil_modulus_gpa = 1.7"),
    );
    let found = explained(folder.path());
    // The air content follows from the modulus, so it is as doubtful.
    for name in ["oil_modulus_effective", "air_content"] {
        let said = quantity(&found, name)["note"].to_string();
        assert!(said.contains("only if the damper has oil_compressibility") && said.contains("11 %"), "{name}: {said}");
    }
    assert!(!quantity(&found, "gas_pressure")["note"].to_string().contains("11 %"), "{found}");
}

#[test]
fn a_slip_in_the_drawing_is_named_and_nothing_is_written() {
    for (text, part) in [
        ("bor_mm = 40\n", "line 1: bor_mm is no entry of a drawing; did you mean bore_mm?"),
        ("rod_mm = 12\nbore_mm = 4000\n", "line 2: bore_mm = 4000 lies outside 5 to 300"),
        ("bore_mm = 10\nrod_mm = 12\n", "does not fit into bore_mm"),
        ("bore_mm = \"wide\"\n", "is no number"),
        ("[bore]\n", "bore is no entry"),
        ("bore_mm 40\n", "is not a TOML file"),
    ] {
        let folder = folder(MODEL, text);
        let told = refused(folder.path(), &["explain", "m.toml", "--dimensions", "d.toml", "--json", "e.json"]);
        assert!(told.contains("d.toml") && told.contains(part), "{text}: {told}");
        assert!(!folder.path().join("e.json").exists());
    }
    let folder = folder(MODEL, DRAWING);
    let told = refused(folder.path(), &["explain", "m.toml", "--dimensions", "absent.toml"]);
    assert!(told.contains("cannot read the dimensions absent.toml"), "{told}");
    let told = refused(folder.path(), &["fit", ".", "-o", "o.toml", "--model", "fv", "--dimensions", "d.toml"]);
    assert!(told.contains("--dimensions gives priors to --model thesis"), "{told}");
}

/// Writes the motions of a short campaign, each with four cycles of a sine of 20 mm. Returns their names.
fn motions(dir: &Path) -> [&'static str; 3] {
    let sines = [("slow", 0.04), ("middle", 1.5), ("fast", 6.0)];
    for (name, frequency) in sines {
        let (amplitude, step) = (0.02, 1.0 / (200.0 * frequency));
        let rows = (0..=800).map(|k| f64::from(k) * step).map(|t| {
            let phase = std::f64::consts::TAU * frequency * t;
            format!("{t},{},{}\n", amplitude * phase.sin(), amplitude * std::f64::consts::TAU * frequency * phase.cos())
        });
        let text = format!("time_s,displacement_m,velocity_m_s\n{}", rows.collect::<String>());
        std::fs::write(dir.join(format!("{name}.csv")), text).unwrap();
    }
    sines.map(|(name, _)| name)
}

/// Model file of a damper whose FV curve and friction depend on a current.
const FAMILY: &str = "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"coulomb_friction\"]\nsetting = [0.0, 1.0]\n\
     setting_name = \"current\"\nsetting_unit = \"A\"\ngas_force = 150.0\ncoulomb_force = [20.0, 60.0]\n\
     fv_velocity = [-1.0, -0.1, 0.0, 0.1, 1.0]\n\
     fv_force = [[-900.0, -200.0, 0.0, 400.0, 1500.0], [-1500.0, -500.0, 0.0, 900.0, 3000.0]]\n";

#[test]
fn a_family_is_explained_at_a_setting_with_the_intervals_there() {
    let intervals = "\n[identification.intervals]\ngas_force = [140.0, 160.0]\n";
    let folder = folder(&format!("{FAMILY}{intervals}"), "rod_mm = 12\n");
    let explain = ["explain", "m.toml", "--dimensions", "d.toml"];
    let told = refused(folder.path(), &explain);
    assert!(told.contains("m.toml is a damper over a setting: say at which to explain it, as --setting 0"), "{told}");
    let told = refused(folder.path(), &[&explain[..], &["--setting", "1.5"]].concat());
    assert!(told.contains("outside those of m.toml, 0 A to 1 A"), "{told}");
    done(folder.path(), &[&explain[..], &["--setting", "0.5", "--json", "e.json"]].concat());
    let found = json(&folder.path().join("e.json"));
    let pressure = quantity(&found, "gas_pressure");
    assert!((pressure["value"].as_f64().unwrap() / 13.26 - 1.0).abs() < 0.01, "{found}");
    // An ordinary damper has no setting.
    std::fs::write(folder.path().join("m.toml"), MODEL).unwrap();
    let told = refused(folder.path(), &[&explain[..], &["--setting", "0.5"]].concat());
    assert!(told.contains("depends on no setting"), "{told}");
}

/// Checks that dimensions also give priors of an adjustable damper. Its gas force is common to all settings, and
/// contradicts wrong dimensions.
#[test]
fn a_family_is_fitted_and_diagnosed_with_dimensions() {
    let folder = folder(FAMILY, "rod_mm = 12\ngas_pressure_bar = 60\n");
    let dir = folder.path();
    std::fs::create_dir(dir.join("records")).unwrap();
    for name in motions(dir) {
        for current in ["0.0", "1.0"] {
            let record = format!("records/{name}_{current}A.csv");
            done(dir, &["simulate", "m.toml", &format!("{name}.csv"), "--setting", current, "-o", &record]);
        }
    }
    let fit = ["fit", "records", "--setting", "current", "-o", "family.toml", "--dimensions", "d.toml"];
    let told = done(dir, &fit);
    assert!(told.contains("note: gas_force contradicts the dimensions of the damper"), "{told}");
    std::fs::write(dir.join("d.toml"), "rod_mm = 12\ngas_pressure_bar = 13\n").unwrap();
    let told = done(dir, &fit);
    assert!(told.contains("note: gas_force was expected at 147.0 N"), "{told}");
    let explained = done(dir, &["explain", "family.toml", "--dimensions", "d.toml", "--setting", "1"]);
    assert!(explained.contains("the fit had a prior of the dimensions for it"), "{explained}");
    done(dir, &["diagnose", "family.toml", "records", "--dimensions", "d.toml", "--json", "diagnosis.json"]);
    let found = json(&dir.join("diagnosis.json"));
    assert_eq!(found["settings"].as_array().map(Vec::len), Some(2), "{found}");
    let told = refused(dir, &["diagnose", "family.toml", "records", "--dimensions", "absent.toml"]);
    assert!(told.contains("cannot read the dimensions absent.toml"), "{told}");
}

/// Checks a fit of a short campaign with dimensions. The printed notes state the prior of the gas force, or that the
/// records contradict wrong dimensions.
#[test]
fn a_fit_says_what_the_dimensions_made_it_expect_and_what_its_records_contradict() {
    let folder = folder("", "rod_mm = 12\ngas_pressure_bar = 60\n");
    let dir = folder.path();
    std::fs::write(
        dir.join("truth.toml"),
        "format = 1\nelements = [\"fv_curve\", \"gas_preload\", \"coulomb_friction\"]\ngas_force = 150.0\ncoulomb_force = 30.0\n",
    )
    .unwrap();
    std::fs::create_dir(dir.join("records")).unwrap();
    for name in motions(dir) {
        let record = format!("records/{name}.csv");
        done(dir, &["simulate", "truth.toml", &format!("{name}.csv"), "-o", &record]);
    }
    let told = done(dir, &["fit", "records", "-o", "fitted.toml", "--dimensions", "d.toml"]);
    assert!(told.contains("note: gas_force contradicts the dimensions of the damper"), "{told}");
    std::fs::write(dir.join("d.toml"), "rod_mm = 12\ngas_pressure_bar = 13\n").unwrap();
    let told = done(dir, &["fit", "records", "-o", "fitted.toml", "--dimensions", "d.toml"]);
    assert!(told.contains("note: gas_force was expected at 147.0 N"), "{told}");
    let file = std::fs::read_to_string(dir.join("fitted.toml")).unwrap();
    assert!(file.contains("gas_pressure_bar, rod_mm"), "{file}");
    let explained = done(dir, &["explain", "fitted.toml", "--dimensions", "d.toml"]);
    assert!(explained.contains("the fit had a prior of the dimensions for it"), "{explained}");
}
