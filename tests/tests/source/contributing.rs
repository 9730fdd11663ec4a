//! Tests that the instructions in CONTRIBUTING.md are valid: the named files exist, and contain the quoted lines. Lists in the code to
//! which a developer must add a new element contain all elements that belong to them.

use dashpot_core::parameter::{Acts, Element, GROUPS, acts, table};
use dashpot_core::step::step;
use dashpot_core::{Input, Model, Params};
use dashpot_tests::library::root;

fn page() -> String {
    std::fs::read_to_string(root().join("CONTRIBUTING.md")).expect("CONTRIBUTING.md")
}

/// Returns the texts between single backticks on a Markdown page, outside of code blocks.
fn quoted(page: &str) -> Vec<String> {
    let prose: Vec<&str> = page.split("```").step_by(2).collect();
    prose.iter().flat_map(|part| part.split('`').skip(1).step_by(2)).map(str::to_owned).collect()
}

#[test]
fn every_file_named_exists() {
    let names = quoted(&page());
    let paths: Vec<&String> = names.iter().filter(|name| name.contains('/') && !name.contains(' ')).collect();
    assert!(paths.len() > 20, "{names:?}");
    let missing: Vec<_> = paths.iter().filter(|path| !root().join(path).exists()).collect();
    assert!(missing.is_empty(), "CONTRIBUTING.md names what is not there: {missing:?}");
}

#[test]
fn every_quoted_line_stands_in_its_file_and_in_this_order() {
    let page = page();
    let mut blocks = 0;
    for block in page.split("```").skip(1).step_by(2) {
        let mut lines = block.lines().skip(1).map(str::trim).filter(|line| !line.is_empty());
        let path = lines.next().and_then(|line| line.strip_prefix("// in ")).expect("a block begins with its file");
        let source = std::fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        let mut rest = source.lines().map(str::trim);
        for line in lines {
            assert!(rest.any(|found| found == line), "{path} has no such line, or not in this order: {line}");
        }
        blocks += 1;
    }
    assert!(blocks > 8, "{blocks} blocks");
}

#[test]
fn a_fleet_takes_the_records_that_the_reader_takes() {
    let python = std::fs::read_to_string(root().join("src/python/python/dashpot/fleet/files.py")).unwrap();
    let list = python.split("RECORDS = frozenset(").nth(1).and_then(|rest| rest.split("\n)").next()).unwrap();
    let listed: Vec<&str> = list.split('"').skip(1).step_by(2).filter(|part| *part != ".{e}").collect();
    assert_eq!(listed, dashpot_records::EXTENSIONS);
}

/// Velocities, m/s. From [`SLOW`] to [`FAST`], the force of dry friction is nearly constant, whereas the force of other elements changes.
const SLOW: f64 = 1e-3;
const FAST: f64 = 0.1;

#[test]
fn a_locked_damper_is_linearized_without_any_dry_friction() {
    let shim = std::fs::read_to_string(root().join("adams-usersub/src/damper_model.c")).unwrap();
    let beside = (0..GROUPS.len()).filter(|group| matches!(acts(*group), Acts::Friction | Acts::Stateful));
    let mut dry = 0;
    for element in beside.filter_map(Element::of_group) {
        let name = element.name();
        let mut params = Params::new();
        params.disable_all();
        params.enable(element, true);
        let Ok(model) = Model::new(&params) else { continue };
        // Computes the force, N, at zero displacement after 20 mm of travel at a constant velocity, m/s. After this travel, the presliding
        // has ended.
        let at_zero = |velocity: f64| {
            let (steps, travel) = (100, 0.02);
            let dt = travel / velocity.abs() / f64::from(steps);
            let input = |k: u32| {
                let displacement = Some(velocity * dt * (f64::from(k) - f64::from(steps)));
                Input { displacement, velocity, side_force: 500.0, temperature: 20.0 }
            };
            let mut state = model.steady_state(&input(0));
            let mut force = 0.0;
            for k in 1..=steps {
                let (next, output) = step(&model, &state, &input(k), dt);
                (state, force) = (next, output.force);
            }
            force
        };
        let force = |speed: f64| 0.5 * (at_zero(speed) - at_zero(-speed));
        if force(SLOW) < 0.3 * force(FAST) || force(FAST) <= 0.0 {
            continue;
        }
        dry += 1;
        let own = table().filter(|row| row.element() == Some(element));
        let is_listed = own.map(|row| row.parameter.name).any(|name| shim.contains(&format!("\"{name}\"")));
        assert!(is_listed, "{name} locks at rest: add its force to DRY_FRICTION in adams-usersub/src/damper_model.c");
    }
    assert!(dry >= 4, "{dry} elements of dry friction");
}
