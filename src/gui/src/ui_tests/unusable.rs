//! Tests of campaigns with unusable records. The window opens the other records, and reports the unusable ones with the
//! reason.

use super::made_up::{campaign, until, window};
use super::{Harness, message, says};
use crate::app::App;
use std::path::Path;

/// Truncates a record to a few samples, and returns the expected message.
fn spoil(folder: &Path, name: &str) -> String {
    let file = folder.join(name);
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.lines().take(6).map(|line| format!("{line}\n")).collect::<String>()).unwrap();
    format!("left out: {}: has only 5 usable samples; a test needs at least 20, so measure it again", file.display())
}

fn is_listed(harness: &Harness<'_, App>, why: &str) -> bool {
    says(harness, &format!("• {why}"))
}

#[test]
fn one_spoilt_test_is_named_and_the_others_are_open() {
    let [own, other] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    campaign(own.path(), 6);
    campaign(other.path(), 6);
    let (of_own, of_other) = (spoil(own.path(), "a20_001.csv"), spoil(other.path(), "a08_002.csv"));
    let mut harness = window(vec![]);
    harness.state_mut().session.open(&[own.path().to_owned()]);
    until(&mut harness, "the records", |app| app.session.has_records());
    assert_eq!(harness.state().session.campaign.as_ref().unwrap().tests.len(), 5);
    assert_eq!(message(&harness), (of_own.clone(), false));
    assert!(is_listed(&harness, &of_own));
    harness.state_mut().session.open_reference(vec![other.path().to_owned()]);
    until(&mut harness, "the other campaign", |app| app.session.reference.is_some());
    harness.step();
    assert_eq!(message(&harness), (of_other.clone(), false));
    assert!(is_listed(&harness, &of_own) && is_listed(&harness, &of_other));
}
