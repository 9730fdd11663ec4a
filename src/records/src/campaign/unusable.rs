//! Files and tests that a campaign leaves out: files that are not records, and faulty tests.
//!
//! One faulty test of fifty is no reason to reject the other forty-nine. Every report of the campaign names the faulty
//! test and the reason. A fault of all tests (a column, a unit, a sign) rejects the campaign, because only the user
//! knows the remedy.

use serde::{Deserialize, Serialize};

use crate::data::record::Note;
use crate::error::{ColumnError, RecordError, RecordFileError, SampleError};
use crate::messages::phrases;
use dashpot_messages::Sentence;

/// A file or test that a campaign leaves out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unusable {
    /// Reason, as a sentence that names the file and the test within it.
    pub why: Sentence,
    /// Whether the entry is a faulty test. Otherwise, it is a file that is not a record.
    pub is_test: bool,
}

impl Unusable {
    /// Returns the reason of the first entry and the number of further ones. Returns `None` for an empty list.
    pub fn first_of(several: &[Unusable]) -> Option<Sentence> {
        let (first, others) = several.split_first()?;
        Some(match others.len() {
            0 => first.why.clone(),
            more => {
                Sentence::from(phrases::FIRST_AND_MORE).with_sentence("first", first.why.clone()).with("count", more)
            }
        })
    }
}

/// Scope of the fault of a file or test.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reach {
    /// The file is not a record.
    NoRecord,
    /// The fault concerns this test only.
    Test,
    /// The fault concerns this test only, unless most tests have the same fault. Then a wrong column, unit or sign is
    /// more likely.
    TestUnlessMost,
    /// The fault rejects the campaign, because only the user can correct it.
    Campaign,
}

impl RecordError {
    /// Returns the scope of this fault.
    pub(crate) fn reach(&self) -> Reach {
        match self {
            RecordError::File(error) => reach_of_file(error),
            RecordError::Column(error) => reach_of_columns(error),
            RecordError::Sample(error) => reach_of_samples(error),
            // Implausible values and exchanged headings concern the campaign, because a wrong unit or column of all
            // tests may show only in a few strong tests.
            RecordError::Implausible(_) | RecordError::Selection(_) | RecordError::ImposedMotion(_) => Reach::Campaign,
        }
    }
}

fn reach_of_file(error: &RecordFileError) -> Reach {
    use RecordFileError as E;
    match error {
        E::UnknownType { .. }
        | E::NotRead { .. }
        | E::EmptyFile { .. }
        | E::NotRegular { .. }
        | E::IsPeakTable { .. }
        | E::TooLarge { .. }
        | E::TooCostly { .. }
        | E::Workbook { .. }
        | E::Rpc { .. }
        | E::Binary { .. }
        | E::Mat { .. } => Reach::NoRecord,
        E::NotFound { .. } | E::Read { .. } | E::PeakTable { .. } | E::Profile { .. } => Reach::Campaign,
    }
}

fn reach_of_columns(error: &ColumnError) -> Reach {
    use ColumnError as E;
    match error {
        E::TooManyColumns { .. } | E::Header { .. } => Reach::NoRecord,
        // A file without the columns of the other files is a damaged record or a table of another kind, unless most
        // files lack them.
        E::MissingColumn { .. } | E::NoSuchColumn { .. } => Reach::TestUnlessMost,
        E::SeveralColumns { .. } | E::NoSettingColumn { .. } | E::MissingUnit { .. } | E::UnknownUnit { .. } => {
            Reach::Campaign
        }
    }
}

fn reach_of_samples(error: &SampleError) -> Reach {
    use SampleError as E;
    match error {
        E::NoData { .. } => Reach::NoRecord,
        E::TooFew { .. }
        | E::Missing { .. }
        | E::TimeBackwards { .. }
        | E::Frozen { .. }
        | E::Clipped { .. }
        | E::NoMotion { .. }
        | E::ConstantForce { .. } => Reach::Test,
        E::Cell { .. } | E::Fields { .. } | E::ConstantTime { .. } | E::Contradiction { .. } => Reach::TestUnlessMost,
    }
}

/// Collection of the faults of the files and tests that a campaign leaves out.
pub(crate) struct FaultFilter {
    strict: bool,
    faults: Vec<RecordError>,
}

impl FaultFilter {
    /// Makes an empty collection. With `strict`, [`FaultFilter::pass`] returns every fault as an error.
    pub fn new(strict: bool) -> FaultFilter {
        FaultFilter { strict, faults: Vec::new() }
    }

    /// Returns the value that was read from a file or test without a fault. Stores the fault and returns `None` if the
    /// campaign can leave the file or test out. Returns other faults, and all faults of a strict run, as errors.
    pub fn pass<T>(&mut self, read: Result<T, RecordError>) -> Result<Option<T>, RecordError> {
        match read {
            Ok(value) => Ok(Some(value)),
            Err(error) if error.reach() != Reach::Campaign && !self.strict => {
                self.faults.push(error);
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    /// Returns whether no fault was stored.
    pub fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }

    /// Returns a fault as an error if no usable test remains: the first fault of a test, else of a file. Returns the
    /// first possibly systematic fault ([`Reach::TestUnlessMost`]) if such faults are at least as many as the `usable`
    /// tests.
    ///
    /// A wrong column, unit or sign can cause the same fault in many tests.
    pub fn reject_most(&mut self, usable: usize) -> Result<(), RecordError> {
        let doubtful = |error: &RecordError| error.reach() == Reach::TestUnlessMost;
        let first = if usable == 0 {
            // The fault of a test is more informative than that of a file that is not a record.
            let of_test = self.faults.iter().position(|e| e.reach() != Reach::NoRecord);
            of_test.or((!self.faults.is_empty()).then_some(0))
        } else if self.faults.iter().filter(|e| doubtful(e)).count() >= usable {
            self.faults.iter().position(doubtful)
        } else {
            None
        };
        first.map_or(Ok(()), |k| Err(self.faults.remove(k)))
    }

    /// Returns the files and tests with faults as entries of the campaign's list, and adds notes about the first of
    /// them.
    pub fn report(self, noted: &mut Vec<Note>) -> Vec<Unusable> {
        let unusable: Vec<Unusable> = self.faults.iter().map(in_words).collect();
        noted.extend(notes(&unusable));
        unusable
    }
}

/// Returns one note for each of the first files and tests that are left out, and a single note for the others.
pub(crate) fn notes(unusable: &[Unusable]) -> Vec<Note> {
    /// Largest number of notes about single files and tests, so that other notes stay visible. The list `unusable` of
    /// the campaign contains all files and tests that are left out.
    const NAMED: usize = 20;
    let note = |text| Note { kind: "left_out", text };
    let mut notes: Vec<Note> = unusable.iter().take(NAMED).map(|one| note(one.why.clone())).collect();
    let more = unusable.len().saturating_sub(NAMED);
    if more > 0 {
        notes.push(note(Sentence::from(phrases::MORE_LEFT_OUT).with("count", more)));
    }
    notes
}

/// Converts a fault to an entry of the campaign's list of unusable files and tests.
fn in_words(error: &RecordError) -> Unusable {
    let is_test = error.reach() != Reach::NoRecord;
    let left_out = if is_test { phrases::LEFT_OUT } else { phrases::NO_RECORD };
    Unusable { why: Sentence::from(left_out).with_sentence("fault", error.fault()), is_test }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Place;
    use crate::error::{PlausibilityError, SelectionError};
    use crate::quantities::channel::Channel;

    fn short() -> RecordError {
        RecordError::Sample(SampleError::TooFew { at: Place::file("s.csv"), samples: 3, needed: 20 })
    }

    fn doubtful() -> RecordError {
        RecordError::Sample(SampleError::ConstantTime { at: Place::file("a.csv"), time: 7.0 })
    }

    fn absurd() -> RecordError {
        RecordError::Implausible(PlausibilityError::Absurd {
            record: "a.csv".into(),
            what: Sentence::as_it_is("a force of 900 kN"),
            advice: phrases::SAY_N,
        })
    }

    fn stray() -> RecordError {
        RecordError::File(RecordFileError::EmptyFile { file: "e.csv".into() })
    }

    fn filter(faults: Vec<RecordError>) -> FaultFilter {
        let mut filter = FaultFilter::new(false);
        for fault in faults {
            assert!(filter.pass::<()>(Err(fault)).unwrap().is_none());
        }
        filter
    }

    #[test]
    fn one_faulty_test_is_left_out_and_most_are_refused() {
        let mut some = filter(vec![stray(), short(), doubtful()]);
        some.reject_most(2).unwrap();
        let mut notes = Vec::new();
        let unusable = some.report(&mut notes);
        assert_eq!(unusable.iter().map(|u| u.is_test).collect::<Vec<_>>(), [false, true, true]);
        assert!(
            unusable[0].why.to_string().starts_with("left out, as it is no record: e.csv: is empty"),
            "{unusable:?}"
        );
        assert!(unusable[1].why.to_string().starts_with("left out: s.csv: has only 3 usable samples"), "{unusable:?}");
        assert!(notes.iter().zip(&unusable).all(|(n, u)| n.text == u.why && n.kind == "left_out"));
        // Two tests have a constant time, and two have a valid time. Either pair may be at fault, so the campaign is
        // rejected.
        let refused = filter(vec![short(), doubtful(), doubtful()]).reject_most(2).unwrap_err();
        assert!(refused.to_string().contains("a.csv"), "{refused}");
        // Short tests never count as a systematic fault.
        filter(vec![short(), short(), short()]).reject_most(1).unwrap();
        // If no test remains, the fault of a test is more informative than a stray file.
        let refused = filter(vec![stray(), short()]).reject_most(0).unwrap_err();
        assert!(refused.to_string().contains("s.csv"), "{refused}");
    }

    #[test]
    fn a_file_without_the_columns_of_the_others_is_left_out() {
        let other_table = || {
            RecordError::Column(ColumnError::MissingColumn {
                at: Place::file("peaks.csv"),
                line: 1,
                missing: "time",
                example: Channel::Time,
                found: "'speed', 'force'".into(),
                near: None,
                angle: None,
                units: Vec::new(),
            })
        };
        let mut one = filter(vec![other_table()]);
        one.reject_most(2).unwrap();
        assert!(one.report(&mut Vec::new())[0].why.to_string().contains("peaks.csv, line 1: no column for time"));
        assert!(filter(vec![other_table(), other_table()]).reject_most(2).is_err());
    }

    #[test]
    fn questions_to_the_user_and_strict_runs_stay_errors() {
        for question in [RecordError::Selection(SelectionError::NoPaths), absurd()] {
            assert!(FaultFilter::new(false).pass::<()>(Err(question)).is_err());
        }
        assert!(FaultFilter::new(true).pass::<()>(Err(short())).is_err());
        assert_eq!(FaultFilter::new(true).pass(Ok(1)).unwrap(), Some(1));
    }

    #[test]
    fn hundreds_are_told_in_a_few_lines_and_kept_in_full() {
        let mut notes = Vec::new();
        let unusable = filter((0..300).map(|_| short()).collect()).report(&mut notes);
        assert_eq!((unusable.len(), notes.len()), (300, 21));
        assert!(notes[20].text.to_string().contains("280 more"), "{}", notes[20].text);
    }
}
