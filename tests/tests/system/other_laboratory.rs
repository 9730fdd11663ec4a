//! Tests the second laboratory (crate `other_lab`). Its known effects are exactly those that the diagnosis can name,
//! and its unknown effects are none of them. The crate uses no other crate of the project.

use dashpot_diagnosis::EFFECTS;
use std::collections::BTreeSet;

#[test]
fn hidden_effects_are_those_that_the_diagnosis_names() {
    let hidden: BTreeSet<&str> = dashpot_other_lab::effects::KNOWN.iter().map(|e| e.name).collect();
    assert_eq!(hidden, EFFECTS.iter().copied().collect());
    let unnamed = dashpot_other_lab::effects::UNKNOWN.iter().map(|u| u.effect.name);
    assert!(unnamed.into_iter().all(|name| !EFFECTS.contains(&name)));
}

#[test]
fn laboratory_depends_on_no_other_crate_of_the_project() {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/../src/other_lab/Cargo.toml");
    let manifest: toml::Table = std::fs::read_to_string(manifest).unwrap().parse().unwrap();
    for section in ["dependencies", "dev-dependencies", "build-dependencies"] {
        let names = manifest.get(section).and_then(toml::Value::as_table);
        for name in names.into_iter().flat_map(|table| table.keys()) {
            assert!(!name.starts_with("dashpot"), "{name} in {section}");
        }
    }
}
