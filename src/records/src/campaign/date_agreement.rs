//! Determines the order of day and month in the dates of the files.
//!
//! 3/11/2026 is the third of November in Europe and the eleventh of March in America. The evidence, in order of
//! precedence, is:
//!
//! - the user's statement,
//! - other dates of the same file with only one valid order (13/11/2026), then those of its campaign if they agree,
//! - the number format of the file,
//! - the order that puts the tests close together, else the default order for the separator of the date.
//!
//! The last item is an assumption, so a note reports the resulting order.

use crate::data::record::Note;
use crate::data::samples::Samples;
use crate::dates::clock;
use crate::dates::date_order::DateOrder;
use crate::dates::file_dates::{Dates, Open};
use crate::messages::phrases;
use crate::options::Options;
use crate::tuning::date_agreement::{APART, CLOSER};
use dashpot_messages::{Sentence, Template};
use std::collections::BTreeSet;

/// Determines the order of day and month in the dates of all tests and corrects their start times. Adds a note if an
/// order is assumed.
pub(crate) fn decide_order(tests: &mut [(&Options, Samples)], notes: &mut Vec<Note>) {
    let orders: BTreeSet<DateOrder> = tests.iter().filter_map(|(_, test)| test.dates.decided).collect();
    let of_all = orders.first().copied().filter(|_| orders.len() == 1);
    let mut assumed = Vec::new();
    for (k, (options, test)) in tests.iter_mut().enumerate() {
        let Dates { open: Some(open), decided, likely: usual } = &test.dates else { continue };
        match options.dates.or(*decided).or(of_all).or(*usual) {
            Some(order) if order != open.read => test.begins = test.begins.map(|begins| begins + open.shift),
            Some(_) => {}
            None => assumed.push((k, open.clone())),
        }
    }
    let Some((first, open)) = assumed.first().cloned() else { return };
    let span = |by: &dyn Fn(&Open) -> f64| {
        let begins = assumed.iter().filter_map(|(k, open)| Some(tests[*k].1.begins? + by(open)));
        let (low, high) = begins.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), t| (low.min(t), high.max(t)));
        high - low
    };
    let (as_read, other) = (span(&|_| 0.0), span(&|open| open.shift));
    let closer = |a: f64, b: f64| b > APART && b > CLOSER * a;
    let turned = closer(other, as_read);
    let why: Template = if turned || closer(as_read, other) {
        phrases::DATES_CLOSE
    } else if open.text.contains('/') {
        phrases::DATES_AMERICAN
    } else {
        phrases::DATES_USUAL
    };
    if turned {
        for (k, open) in &assumed {
            let test = &mut tests[*k].1;
            test.begins = test.begins.map(|begins| begins + open.shift);
        }
    }
    let Some(began) = tests[first].1.begins else { return };
    let text = Sentence::from(phrases::DATES_ASSUMED)
        .with("date", &open.text)
        .with("at", &tests[first].1.name)
        .with("read", clock::written(began).split(' ').next().unwrap_or_default())
        .with_sentence("why", why);
    notes.push(Note { kind: "clock", text });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::SineTest;

    /// Applies [`decide_order`] to tests whose files have the given lines above their tables. `usual` is the order of
    /// day and month by the number format of the files. Returns the days on which the tests began and the notes about
    /// dates.
    fn read(files: &[&str], options: &Options, usual: Option<DateOrder>) -> (Vec<String>, String) {
        let mut tests: Vec<(&Options, Samples)> = files
            .iter()
            .map(|lines| {
                let began = clock::begins(lines.lines()).unwrap();
                let mut test = SineTest::default().samples();
                test.begins = Some(began.at);
                test.dates = Dates { likely: usual, ..Dates::of_lines(lines.lines(), began.date) };
                (options, test)
            })
            .collect();
        let mut notes = Vec::new();
        decide_order(&mut tests, &mut notes);
        let day = |test: &Samples| clock::written(test.begins.unwrap()).split(' ').next().unwrap().to_owned();
        (tests.iter().map(|(_, test)| day(test)).collect(), notes.iter().map(|n| n.text.to_string()).collect())
    }

    #[test]
    fn what_a_date_leaves_open_is_decided_by_others_by_numbers_or_by_the_user() {
        let plain = Options::default();
        let open = "Date: 3/11/2026\nTime: 10:00:00";
        let (days, said) = read(&[open], &plain, None);
        assert_eq!(days, ["2026-03-11"]);
        assert!(said.contains("3/11/2026") && said.contains("2026-03-11") && said.contains("--dates"), "{said}");
        let european = (vec!["2026-11-03".to_owned()], String::new());
        // The order of day and month follows from another date of the same file, from the number format, or from the
        // user.
        assert_eq!(read(&["Calibrated 25/10/2025\nDate: 3/11/2026 10:00:00"], &plain, None), european);
        assert_eq!(read(&[open], &plain, Some(DateOrder::DayFirst)), european);
        let told = Options { dates: Some(DateOrder::DayFirst), ..Options::default() };
        assert_eq!(read(&[open], &told, None), european);
        assert_eq!(
            read(&["Date: 11/13/2025\nMeasured 3/11/2026 10:00:00"], &plain, Some(DateOrder::DayFirst)).0,
            ["2026-03-11"]
        );
        // The order of day and month follows from another file of the campaign, unless files contradict each other.
        let others = [open, "13/11/2026 10:00:00", "4/11/2026 10:00:00"];
        assert_eq!(
            read(&others, &plain, None),
            (["2026-11-03", "2026-11-13", "2026-11-04"].map(str::to_owned).to_vec(), String::new())
        );
        assert!(read(&[open, "13/11/2026 9:00:00", "11/13/2026 9:00:00"], &plain, None).1.contains("--dates"));
        // Dates that are equal in both orders, or that begin with the year, are unambiguous.
        assert_eq!(read(&["11/11/2026 10:00:00", "2026/03/11 10:00:00", "3.11.2026 10:00:00"], &plain, None).1, "");
        assert!(read(&["3-11-2026 10:00:00"], &plain, None).1.contains("2026-11-03"));
        assert_eq!(read(&["11-25-2026 10:00:00"], &plain, None), (vec!["2026-11-25".to_owned()], String::new()));
    }

    /// Loads as one campaign files that have the given lines above their tables. A file marked `true` has semicolons
    /// and decimal commas. Returns the days on which the tests began, and the campaign's notes about dates.
    fn loaded(above: &[(&str, bool)], profile: &str) -> (Vec<String>, String) {
        let folder = tempfile::tempdir().unwrap();
        for (k, (lines, semicolons)) in above.iter().enumerate() {
            let table = SineTest { seed: k as u64, frequency: 1.0 + k as f64, ..SineTest::default() }.csv();
            let table = if *semicolons { table.replace(',', ";").replace('.', ",") } else { table };
            std::fs::write(folder.path().join(format!("t{k}.csv")), format!("{lines}\n{table}")).unwrap();
        }
        std::fs::write(folder.path().join("campaign.toml"), profile).unwrap();
        let campaign = crate::load(&[folder.path().to_owned()], &Options::default(), &|_| ()).unwrap();
        let days = campaign.records.iter().map(|r| clock::written(r.begins.unwrap())[..10].to_owned()).collect();
        let told = campaign.notes.iter().map(|note| note.text.to_string()).filter(|text| text.contains("--dates"));
        (days, told.collect())
    }

    #[test]
    fn files_of_a_campaign_are_dated_alike() {
        let days = |days: &[&str]| days.iter().map(|day| (*day).to_owned()).collect::<Vec<_>>();
        let files = [("Date: 3/11/2026 10:00:00", false), ("Date: 13/11/2026 10:00:00", false)];
        assert_eq!(loaded(&files, ""), (days(&["2026-11-03", "2026-11-13"]), String::new()));
        let german = [("Datum;3/11/2026;10:00:00", true)];
        assert_eq!(loaded(&german, ""), (days(&["2026-11-03"]), String::new()));
        let (found, told) = loaded(&files[..1], "");
        assert_eq!(found, ["2026-03-11"]);
        assert!(told.contains("3/11/2026 (of t0)"), "{told}");
        let said = "format = \"dashpot campaign profile 1\"\ndates = \"day-first\"\n";
        assert_eq!(loaded(&files[..1], said), (days(&["2026-11-03"]), String::new()));
    }

    #[test]
    fn tests_of_one_campaign_lie_close_together() {
        let (days, said) =
            read(&["3/11/2026 9:00:00", "4/11/2026 9:00:00", "6/11/2026 9:00:00"], &Options::default(), None);
        assert_eq!(days, ["2026-11-03", "2026-11-04", "2026-11-06"]);
        assert!(said.contains("close together"), "{said}");
        let (days, said) = read(&["11/3/2026 9:00:00", "11/4/2026 9:00:00"], &Options::default(), None);
        assert_eq!(days, ["2026-11-03", "2026-11-04"]);
        assert!(said.contains("close together"), "{said}");
    }

    #[test]
    fn a_column_of_dates_does_not_jump_a_month_at_midnight() {
        let mut dates = Dates::default();
        let mut times: Vec<f64> = ["3/11/2026 23:59:59", "4/11/2026 0:00:01"]
            .iter()
            .map(|cell| {
                dates.see(cell);
                clock::seconds(cell).unwrap()
            })
            .collect();
        dates.resolve_column(&mut times);
        assert_eq!((times[1] - times[0], clock::written(times[0]).as_str()), (2.0, "2026-11-03 23:59:59"));
        assert_eq!(dates.decided, Some(DateOrder::DayFirst));
    }

    #[test]
    fn dates_decide_only_where_one_reading_lies_much_closer_together() {
        let said = |dates: &[&str]| read(dates, &Options::default(), None).1;
        // The tests lie 39 days apart in the American order and 243 days in the European order. The second pair lies 66
        // and 214 days apart. Only the ratio of the first pair exceeds `CLOSER`.
        assert!(said(&["1/2/2026 9:00:00", "2/10/2026 9:00:00"]).contains("close together"));
        assert!(!said(&["1/2/2026 9:00:00", "3/9/2026 9:00:00"]).contains("close together"));
    }
}
