//! The crates that the project is built from: their licences, where they come from, and what is known against them, as
//! `deny.toml` allows and cargo-deny looks it up. Without the tool these are counted as skipped.

use dashpot_test_support::skipped;
use dashpot_tests::library::root;
use std::process::Command;

/// Runs one kind of check. Where it cannot run, a line says that it was skipped.
fn holds(kind: &str) {
    let deny = |args: &[&str]| Command::new("cargo").arg("deny").args(args).current_dir(root()).output();
    if !deny(&["--version"]).is_ok_and(|out| out.status.success()) {
        skipped("no cargo-deny (cargo install cargo-deny)");
        return;
    }
    let out = deny(&["--color", "never", "check", kind]).unwrap();
    let told = String::from_utf8_lossy(&out.stderr);
    // The list of known weaknesses is fetched, which not every machine may do.
    let not_fetched = ["failed to fetch", "unable to fetch", "failed to load advisory database"];
    if not_fetched.iter().any(|sign| told.contains(sign)) {
        skipped(format!("{kind} needs what cannot be fetched here"));
        return;
    }
    assert!(out.status.success(), "cargo deny check {kind}:\n{told}");
}

#[test]
fn every_licence_is_one_that_may_be_shipped() {
    holds("licenses");
}

#[test]
fn no_crate_opens_a_connection_or_comes_without_a_version() {
    holds("bans");
}

#[test]
fn every_crate_comes_from_the_registry() {
    holds("sources");
}

#[test]
fn nothing_is_known_against_a_crate() {
    holds("advisories");
}

/// The packages put the texts of the same licences beside the programs.
#[test]
fn the_licences_are_those_of_the_packages() {
    let deny: toml::Table = std::fs::read_to_string(root().join("deny.toml")).unwrap().parse().unwrap();
    let mut allowed: Vec<&str> =
        deny["licenses"]["allow"].as_array().unwrap().iter().filter_map(|l| l.as_str()).collect();
    let script = std::fs::read_to_string(root().join("dist/licences.py")).unwrap();
    let list = script.split_once("ALLOWED = {").unwrap().1.split_once("\n}").unwrap().0;
    let code = list.lines().map(|line| line.split('#').next().unwrap_or(line));
    let mut shipped: Vec<&str> = code.flat_map(|line| line.split('"').skip(1).step_by(2)).collect();
    allowed.sort_unstable();
    shipped.sort_unstable();
    assert!(!shipped.is_empty());
    assert_eq!(allowed, shipped);
}
