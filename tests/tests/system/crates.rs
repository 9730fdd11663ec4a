//! Checks the dependencies of the project on other crates.
//!
//! cargo-deny checks licenses, sources and security advisories against `deny.toml`. Without cargo-deny, these tests are
//! counted as skipped. If advisories cannot be fetched, the tests use the copy in the checkout (`tests/advisories`),
//! and report if this copy is old.

use dashpot_test_support::skipped;
use dashpot_tests::library::root;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::SystemTime;

/// Age, in days, above which the advisories of the checkout are reported as old. RustSec publishes several advisories a
/// week. The limit equals that of cargo-deny.
const OLD: i64 = 90;

/// Runs cargo-deny in the project's folder. Returns `None` if cargo-deny is not installed.
fn deny(args: &[&str]) -> Option<Output> {
    let run = |args: &[&str]| Command::new("cargo").arg("deny").args(args).current_dir(root()).output();
    run(&["--version"]).ok().filter(|out| out.status.success())?;
    run(args).ok()
}

/// Returns the days from 1970-01-01 to a date in the form 2026-08-21.
fn days(date: &str) -> i64 {
    let part = |range: std::ops::Range<usize>| date[range].parse::<i64>().expect("a date");
    let (y, m, d) = (part(0..4), part(5..7), part(8..10));
    // In this calculation, months count from March, so that the leap day is the last day of a year.
    let (y, m) = if m > 2 { (y, m - 3) } else { (y - 1, m + 9) };
    365 * y + y / 4 - y / 100 + y / 400 + (153 * m + 2) / 5 + d - 1 - 719_468
}

/// Returns date and commit of the advisories in the checkout.
fn snapshot() -> String {
    std::fs::read_to_string(root().join("tests/advisories/snapshot")).expect("tests/advisories/snapshot")
}

/// Returns a message if the advisories of the checkout are older than [`OLD`] on the day `today` (days since
/// 1970-01-01).
fn stale(snapshot: &str, today: i64) -> Option<String> {
    let date = snapshot.split(' ').next().unwrap_or_default();
    let age = today - days(date);
    (age > OLD).then(|| {
        format!("advisories after {date}: those of the checkout are {age} days old; sh tests/advisories/update fetches newer ones")
    })
}

fn run(program: &str, args: &[&str], at: &Path) {
    let out =
        Command::new(program).args(args).current_dir(at).output().unwrap_or_else(|error| panic!("{program}: {error}"));
    assert!(out.status.success(), "{program} {args:?}: {}", String::from_utf8_lossy(&out.stderr));
}

/// Runs cargo-deny with the advisories of the checkout. cargo-deny reads advisories from a git repository in a folder
/// of databases. This function creates the folder and the repository.
fn by_the_checkout(configuration: &str) -> Output {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let (databases, file) = (at.join("databases"), at.join("deny.toml"));
    std::fs::create_dir(&databases).expect("a directory");
    let mut deny_toml: toml::Table = configuration.parse().expect("deny.toml");
    let advisories = deny_toml["advisories"].as_table_mut().expect("[advisories]");
    advisories.insert("db-path".into(), databases.to_str().expect("a path in UTF-8").into());
    // Checking for yanked crates would need to fetch the registry's index.
    advisories.insert("yanked".into(), "allow".into());
    std::fs::write(&file, deny_toml.to_string()).expect("a file");
    let file = file.to_str().expect("a path in UTF-8");
    let check = ["--offline", "--color", "never", "--config", file, "check", "advisories"];
    // The first run fails and prints the expected path of the repository. cargo-deny derives the repository's name from
    // the address of the advisory database.
    let said = String::from_utf8_lossy(&deny(&check).expect("cargo-deny").stderr).into_owned();
    let path = said
        .split('"')
        .find(|part| part.starts_with(databases.to_str().unwrap()) && part.len() > databases.as_os_str().len());
    let repository = PathBuf::from(path.unwrap_or_else(|| panic!("where does cargo-deny look? {said}")));
    std::fs::create_dir(&repository).expect("a directory");
    let archive = root().join("tests/advisories/advisory-db.tar.gz");
    run("tar", &["xzf", archive.to_str().expect("a path in UTF-8")], &repository);
    run("git", &["init", "-q"], &repository);
    run("git", &["add", "-A"], &repository);
    let named = ["-c", "user.name=dashpot", "-c", "user.email=dashpot@localhost", "-c", "commit.gpgsign=false"];
    run("git", &[&named[..], &["commit", "-q", "-m", "advisories"]].concat(), &repository);
    deny(&check).expect("cargo-deny")
}

/// Runs one kind of check of cargo-deny, and reports the check as skipped if it cannot run.
fn holds(kind: &str) {
    let Some(out) = deny(&["--color", "never", "check", kind]) else {
        skipped(WITHOUT);
        return;
    };
    let told = String::from_utf8_lossy(&out.stderr);
    if !was_fetched(&told) {
        skipped(format!("{kind} needs what cannot be fetched here"));
        return;
    }
    assert!(out.status.success(), "cargo deny check {kind}:\n{told}");
}

const WITHOUT: &str = "no cargo-deny (cargo install cargo-deny)";

/// Returns whether cargo-deny could fetch its data, which not every machine allows.
fn was_fetched(told: &str) -> bool {
    !["failed to fetch", "unable to fetch", "failed to load advisory database"].iter().any(|sign| told.contains(sign))
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
    let Some(fetched) = deny(&["--color", "never", "check", "advisories"]) else {
        skipped(WITHOUT);
        return;
    };
    let told = String::from_utf8_lossy(&fetched.stderr).into_owned();
    if was_fetched(&told) {
        assert!(fetched.status.success(), "cargo deny check advisories:\n{told}");
        return;
    }
    let today = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).expect("a clock").as_secs() / 86_400;
    if let Some(what) = stale(&snapshot(), today as i64) {
        skipped(what);
    }
    let configuration = std::fs::read_to_string(root().join("deny.toml")).expect("deny.toml");
    let out = by_the_checkout(&configuration);
    assert!(out.status.success(), "cargo deny check advisories:\n{}", String::from_utf8_lossy(&out.stderr));
}

/// Checks that cargo-deny uses the advisories of the checkout. Without the exceptions in `deny.toml`, cargo-deny must
/// report the advisories of these exceptions.
#[test]
fn the_advisories_of_the_checkout_are_used() {
    if deny(&[]).is_none() {
        skipped(WITHOUT);
        return;
    }
    let mut configuration: toml::Table =
        std::fs::read_to_string(root().join("deny.toml")).expect("deny.toml").parse().expect("deny.toml");
    let ignored =
        configuration["advisories"].as_table_mut().expect("[advisories]").remove("ignore").expect("exceptions");
    let out = by_the_checkout(&configuration.to_string());
    let told = String::from_utf8_lossy(&out.stderr);
    assert!(!out.status.success());
    for exception in ignored.as_array().expect("a list") {
        let id = exception["id"].as_str().expect("an id");
        assert!(told.contains(id), "{id} is no longer found: take it out of deny.toml");
    }
}

#[test]
fn old_advisories_are_said_to_be_old() {
    assert_eq!((days("1970-01-01"), days("2000-03-01"), days("2026-08-21")), (0, 11_017, 20_686));
    let of = |today: &str| stale("2026-08-21 bf5c0d2", days(today));
    assert_eq!((of("2026-08-21"), of("2026-11-19")), (None, None));
    assert!(
        of("2026-11-20").is_some_and(|what| what.contains("91 days old") && what.contains("tests/advisories/update"))
    );
    assert!(days(&snapshot()[..10]) > days("2026-01-01"));
}

/// Checks that `dist/licences.py` allows the same licenses in the packages as `deny.toml`.
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
