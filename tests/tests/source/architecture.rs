//! Tests that ARCHITECTURE.md and its picture of the crates match the Cargo manifests; `UPDATE_DOCS=1` redraws the
//! picture.

use dashpot_tests::library::root;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Crates of the workspace, each with the crates of the workspace that it uses.
type Uses = BTreeMap<String, BTreeSet<String>>;

/// Returns the name of a package's folder below `src`.
fn folder(package: &str) -> String {
    package.trim_start_matches("dashpot-").replace('-', "_")
}

/// Reads the dependencies between crates from the manifests of the crates below `src`. The crates of the tests are
/// omitted.
fn of_manifests() -> Uses {
    let read = |path: &str| -> toml::Table {
        std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}")).parse().unwrap()
    };
    let members = read("Cargo.toml")["workspace"]["members"].clone();
    let members = members.as_array().unwrap().iter().map(|m| m.as_str().unwrap().to_owned());
    let crates = members.filter_map(|m| Some(m.strip_prefix("src/")?.to_owned()));
    crates
        .map(|name| {
            let manifest = read(&format!("src/{name}/Cargo.toml"));
            let table = manifest.get("dependencies").and_then(toml::Value::as_table).cloned().unwrap_or_default();
            let uses = table.keys().filter(|k| k.starts_with("dashpot-")).map(|k| folder(k)).collect();
            (name, uses)
        })
        .collect()
}

/// Reads the dependencies between crates from the table of crates in ARCHITECTURE.md.
fn of_page() -> Uses {
    let page = std::fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let table = page.split("| crate | what it is | uses |").nth(1).expect("the table of crates");
    let names = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<BTreeSet<_>>();
    let rows = table.lines().skip(2).take_while(|line| line.starts_with('|'));
    rows.map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").collect();
        let [name, _, uses] = cells[..] else { panic!("three cells: {row}") };
        (names(name).pop_first().expect("a crate"), names(uses))
    })
    .collect()
}

/// Returns the dependencies, as pairs (crate, used crate), that do not follow from other dependencies by transitivity.
fn arrows(uses: &Uses) -> Vec<(&str, &str)> {
    fn reaches(uses: &Uses, from: &str, to: &str) -> bool {
        uses[from].iter().any(|next| next == to || reaches(uses, next, to))
    }
    let mut found = Vec::new();
    for (from, all) in uses {
        for to in all {
            if !all.iter().any(|other| other != to && reaches(uses, other, to)) {
                found.push((from.as_str(), to.as_str()));
            }
        }
    }
    found
}

/// Returns the height of a crate in the picture: the length of its longest chain of dependencies.
fn level(uses: &Uses, name: &str) -> usize {
    uses[name].iter().map(|below| 1 + level(uses, below)).max().unwrap_or(0)
}

const WIDTH: f64 = 860.0;
const BOX: (f64, f64) = (118.0, 34.0);
/// Vertical distance of neighboring rows of boxes, in units of the SVG, with space for the arrows.
const STEP: f64 = 84.0;

/// Draws the crates as boxes in rows by [`level`], with arrows to their dependencies.
fn picture(uses: &Uses) -> String {
    let arrows = arrows(uses);
    let mut levels: Vec<Vec<&str>> = Vec::new();
    for name in uses.keys() {
        let at = level(uses, name);
        levels.resize(levels.len().max(at + 1), Vec::new());
        levels[at].push(name);
    }
    let mut place: BTreeMap<&str, f64> = BTreeMap::new();
    fn spread<'a>(row: &[&'a str], place: &mut BTreeMap<&'a str, f64>) {
        for (i, name) in row.iter().enumerate() {
            place.insert(name, WIDTH * (i as f64 + 0.5) / row.len() as f64);
        }
    }
    levels.iter().for_each(|row| spread(row, &mut place));
    // Each row is sorted by the mean position of the crates that an arrow connects with a crate. Eight repetitions
    // reduce the crossings of arrows.
    for _ in 0..8 {
        for row in &mut levels {
            let middle = |name: &str| {
                let ends = arrows.iter().filter(|(a, b)| *a == name || *b == name);
                let others: Vec<f64> = ends.map(|(a, b)| place[if *a == name { b } else { a }]).collect();
                if others.is_empty() { place[name] } else { others.iter().sum::<f64>() / others.len() as f64 }
            };
            row.sort_by(|a, b| middle(a).total_cmp(&middle(b)).then(a.cmp(b)));
            spread(row, &mut place);
        }
    }
    let height = STEP * levels.len() as f64;
    let top = |name: &str| height - STEP * level(uses, name) as f64 - STEP + (STEP - BOX.1) / 2.0;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" font-family=\"sans-serif\" font-size=\"14\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <defs><marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">\
         <path d=\"M0 0 L8 4 L0 8 z\" fill=\"#56657a\"/></marker></defs>\n"
    );
    for (from, to) in &arrows {
        let (x0, y0, x1, y1) = (place[from], top(from) + BOX.1, place[to], top(to));
        let bend = 0.5 * (y1 - y0).min(STEP);
        let _ = writeln!(
            out,
            "<path class=\"{from} {to}\" d=\"M{x0:.0} {y0:.0} C{x0:.0} {:.0} {x1:.0} {:.0} {x1:.0} {y1:.0}\" fill=\"none\" \
             stroke=\"#56657a\" stroke-width=\"1.3\" marker-end=\"url(#tip)\"/>",
            y0 + bend,
            y1 - bend
        );
    }
    for name in uses.keys() {
        let (x, y) = (place[name.as_str()], top(name));
        // A different color marks crates that no other crate uses.
        let fill = if uses.values().any(|u| u.contains(name)) { "#eef2f8" } else { "#d9e8d4" };
        let _ = writeln!(
            out,
            "<rect x=\"{:.0}\" y=\"{y:.0}\" width=\"{}\" height=\"{}\" rx=\"5\" fill=\"{fill}\" stroke=\"#56657a\"/>\
             <text x=\"{x:.0}\" y=\"{:.0}\" text-anchor=\"middle\" fill=\"#1c2733\">{name}</text>",
            x - BOX.0 / 2.0,
            BOX.0,
            BOX.1,
            y + 22.0
        );
    }
    out += "</svg>\n";
    out
}

#[test]
fn the_page_follows_the_manifests() {
    let (manifests, page) = (of_manifests(), of_page());
    assert!(manifests.len() > 10);
    for (name, uses) in &manifests {
        let told = page.get(name).unwrap_or_else(|| panic!("ARCHITECTURE.md has no row for src/{name}"));
        assert_eq!(told, uses, "ARCHITECTURE.md, row {name}: what it uses");
    }
    assert!(page.keys().eq(manifests.keys()), "ARCHITECTURE.md has a row for a crate that is not there");
}

#[test]
fn the_picture_follows_the_manifests() {
    let path = root().join("docs/architecture.svg");
    let drawn = picture(&of_manifests());
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(&path, &drawn).unwrap();
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(written == drawn, "docs/architecture.svg is out of date; run this test with UPDATE_DOCS=1");
}
