//! The certificate of a check against limits, a separate page: verdict, diagram, table of every limit, and origin of the data.

use super::blocks::{Block, Column, Figure, Section, Table};
use super::made::{self, Made};
use super::numbers::digits;
use super::page;
use super::subject;
use crate::cells::Cell;
use crate::plot::peaks;
use crate::plot::ticks::number;
use crate::words::Words;
use dashpot_identification::limits::{BETWEEN, Certificate, Checked, Limit, NEAR, Overall, Quantity, Value, Verdict};
use dashpot_records::newtons::places;
use dashpot_records::{Record, setting_in_words};

/// Input of a certificate.
#[derive(Debug, Clone)]
pub struct CertificateInput<'a> {
    /// The checked limits and their overall verdict.
    pub certificate: &'a Certificate,
    /// The records from which the verdicts follow, with the test object, the date and the operator.
    pub records: &'a [&'a Record],
    /// Files or folders of the records, as named in the subtitle.
    pub data: String,
    /// Path of the file of limits.
    pub limits: String,
    /// Points of the model's curve: constant velocity, m/s, and force, N. May be empty.
    pub curve: &'a [[f64; 2]],
    /// Origin of the results: version, date, command and input files.
    pub made: &'a Made,
    /// Texts in the language of the certificate.
    pub words: &'a Words,
}

/// Renders the certificate as a separate page.
pub fn render(input: &CertificateInput<'_>) -> String {
    let words = input.words;
    let figure = peaks::against_limits(input.certificate, input.curve, words);
    let mut first = section(input.certificate, words);
    let place = first.blocks.iter().position(|b| matches!(b, Block::Table(_))).unwrap_or(first.blocks.len());
    first.blocks.insert(place, Block::List(subject::lines(input.records, words)));
    if let Some(svg) = figure {
        first.blocks.insert(place + 1, Block::Wide(Figure::new("force-at-peak", svg)));
    }
    let subtitle = words.fill(words.certificate_subtitle, &[("data", &input.data), ("limits", &input.limits)]);
    page::page(
        words.certificate_title,
        &subtitle,
        &[first, made::section(input.made, words)],
        words,
        page::Print::Certificate,
    )
}

/// Builds the section of a report with the verdict on the limits and the table of all limits.
pub fn section(found: &Certificate, words: &Words) -> Section {
    let mut blocks = vec![Block::Verdict(found.overall, headline(found, words))];
    if found.model_passed.is_some() {
        let other = found.limits.iter().filter(|l| l.model_verdict.is_some_and(|v| v != l.verdict)).count();
        blocks.push(Block::Paragraph(match other {
            0 => words.certificate_model_passes.to_owned(),
            _ => words.fill(words.certificate_model_fails, &[("count", &other.to_string())]),
        }));
    }
    blocks.push(Block::Table(table(found, words)));
    Section::new("limits", words.certificate_section, blocks)
}

fn headline(found: &Certificate, words: &Words) -> String {
    let count = |verdict| found.limits.iter().filter(|l| l.verdict == verdict).count();
    let (failed, untested) = (count(Verdict::Fail), count(Verdict::NotTested));
    let tested = found.limits.len() - untested;
    let text = match found.overall {
        Overall::Pass => words.certificate_pass,
        Overall::Fail if untested == 0 => words.certificate_fail,
        Overall::Fail => words.certificate_fail_untested,
        Overall::Incomplete if tested == 0 => words.certificate_nothing_tested,
        Overall::Incomplete => words.certificate_untested,
    };
    let [count, failed, tested, untested] = [found.limits.len(), failed, tested, untested].map(|n| n.to_string());
    let why = match found.limits.iter().any(|one| one.limit.setting.is_some()) {
        true => words.certificate_why_untested_at_setting,
        false => words.certificate_why_untested,
    };
    let figures = [("count", &*count), ("failed", &failed), ("tested", &tested), ("untested", &untested), ("why", why)];
    words.fill(text, &figures)
}

fn table(found: &Certificate, words: &Words) -> Table {
    let cell = |v: Option<f64>, decimals: usize| Cell::known(v, |v| Cell::number(v, |v| number(v, decimals)));
    let shown = |one: &Checked, v: Option<f64>| v.map(|v| one.limit.quantity.display().1 * v);
    let of_value = |one: &Checked, v: &Option<Value>| shown(one, v.as_ref().map(|v| v.value));
    // All velocities in a report and its figures are in mm/s.
    let speed = |one: &Checked| one.limit.velocity_m_s.map(|v| 1e3 * v);
    let decimals_of = |of: &dyn Fn(&Checked) -> Option<f64>| {
        found.limits.iter().filter_map(of).map(|v| places(v, 1)).max().unwrap_or(1)
    };
    let [low, high] = [decimals_of(&|one| shown(one, one.limit.low)), decimals_of(&|one| shown(one, one.limit.high))];
    let [measured, modelled] =
        [decimals_of(&|one| of_value(one, &one.measured)), decimals_of(&|one| of_value(one, &one.model))];
    let speeds = found.limits.iter().filter_map(speed).map(written_decimals).max().unwrap_or(0);
    let verdict = |v: Verdict| match v {
        Verdict::Pass => words.pass,
        Verdict::Fail => words.fail,
        Verdict::NotTested => words.not_tested,
    };
    let remark = |text, one: &Checked, value: f64| {
        words.fill(text, &[("verdict", verdict(one.verdict)), ("value", &*digits(value, 2))])
    };
    // A remark on a response time states the uncertainty, ms, that can change the verdict. A remark on a friction force states the damping
    // force, N, that the measured friction contains.
    let measured_verdict = |one: &Checked| match (one.deciding_uncertainty(), one.damping_in_friction()) {
        (Some(uncertainty), _) => remark(words.certificate_unsure, one, 1e3 * uncertainty),
        (None, Some(damping)) => remark(words.certificate_damping, one, damping),
        (None, None) => verdict(one.verdict).to_owned(),
    };
    let row = |one: &Checked| {
        let limit = &one.limit;
        let tests = one.measured.as_ref().map_or_else(String::new, |v| in_short(&v.tests));
        // The force was interpolated between two tests, so neither test measured it.
        let between = limit.quantity == Quantity::Force && one.measured.as_ref().is_some_and(|v| v.tests.len() > 1);
        let tests = if between { words.fill(words.certificate_interpolated, &[("tests", &tests)]) } else { tests };
        let step = one.measured.as_ref().and_then(|value| value.step);
        let tests = match step {
            Some((from, to)) => {
                let values =
                    [("tests", tests), ("from", at_setting(from, limit, words)), ("to", at_setting(to, limit, words))];
                words.fill(words.certificate_step, &values.each_ref().map(|(name, value)| (*name, &**value)))
            }
            None => tests,
        };
        vec![
            label(one, words).into(),
            cell(speed(one), speeds),
            // Each row states the unit of its bounds, because times in ms and forces in N share the table.
            limit.quantity.display().0.into(),
            cell(shown(one, limit.low), low),
            cell(shown(one, limit.high), high),
            cell(of_value(one, &one.measured), measured),
            measured_verdict(one).into(),
            cell(of_value(one, &one.model), modelled),
            one.model_verdict.map_or("–", verdict).into(),
            tests.into(),
        ]
    };
    let columns = vec![
        Column::words(words.col_limit),
        Column::figures(words.col_at),
        Column::words(words.col_unit),
        Column::figures(words.col_low_limit),
        Column::figures(words.col_high_limit),
        Column::figures(words.measured),
        Column::words(words.col_verdict),
        Column::figures(words.model),
        Column::words(words.col_verdict),
        Column::words(words.col_from),
    ];
    Table {
        caption: words
            .fill(words.certificate_caption, &[("ratio", &digits(BETWEEN, 1)), ("percent", &digits(100.0 * NEAR, 1))]),
        columns,
        rows: found.limits.iter().map(row).collect(),
        sortable: false,
    }
}

/// Returns the number of decimals that an exact velocity, mm/s, has. At most two decimals are returned, because rigs are not more accurate.
fn written_decimals(velocity: f64) -> usize {
    const MOST: usize = 2;
    let is_exact = |decimals: &usize| {
        let scaled = velocity * 10f64.powi(*decimals as i32);
        (scaled - scaled.round()).abs() < 1e-6 * scaled.abs().max(1.0)
    };
    (0..MOST).find(is_exact).unwrap_or(MOST)
}

/// Lists names of tests. If there are more than three, lists only the first and the last.
fn in_short(tests: &[String]) -> String {
    match tests {
        [first, .., last] if tests.len() > 3 => format!("{first} … {last} ({})", tests.len()),
        few => few.join(", "),
    }
}

/// Formats a value of the setting with the unit that the limit states.
fn at_setting(value: f64, limit: &Limit, words: &Words) -> String {
    words.number(&setting_in_words(value, &limit.setting_unit))
}

/// Formats the quantity of a limit with its amplitude and setting, and with the name from the limit file.
fn label(one: &Checked, words: &Words) -> String {
    let limit = &one.limit;
    let quantity = match limit.quantity {
        Quantity::Force if limit.velocity_m_s.unwrap_or(0.0) > 0.0 => words.force_rebound,
        Quantity::Force => words.force_compression,
        Quantity::GasForce => words.gas_force,
        Quantity::Friction => words.friction,
        Quantity::Hysteresis => words.hysteresis,
        Quantity::ResponseTimeUp => words.response_time_up,
        Quantity::ResponseTimeDown => words.response_time_down,
        Quantity::RiseTimeUp => words.rise_time_up,
        Quantity::RiseTimeDown => words.rise_time_down,
    };
    let stroke = limit.amplitude_m.map_or_else(String::new, |a| format!(" (±{} mm)", digits(1e3 * a, 3)));
    let setting = limit
        .setting
        .map_or_else(String::new, |value| format!(" ({} {})", words.col_setting, at_setting(value, limit, words)));
    let stroke = format!("{stroke}{setting}");
    let is_named = !Quantity::NAMES.iter().any(|(name, _)| limit.name.eq_ignore_ascii_case(name));
    if is_named { format!("{}: {quantity}{stroke}", limit.name) } else { format!("{quantity}{stroke}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::of_test::tests::record;
    use crate::words::Language;
    use dashpot_identification::limits::{judge, parse};

    fn page_of(text: &str, language: Language) -> String {
        let record = record(4, true);
        let found = judge(&parse("l.csv".as_ref(), text).unwrap(), &[&record], None);
        render(&CertificateInput {
            certificate: &found,
            records: &[&record],
            data: "rig".into(),
            limits: "l.csv".into(),
            curve: &[],
            made: &Made::default(),
            words: language.words(),
        })
    }

    #[test]
    fn a_column_of_limits_has_one_number_of_decimals() {
        let columns = |text: &str| -> Vec<Vec<String>> {
            let found = judge(&parse("l.csv".as_ref(), text).unwrap(), &[&record(4, true)], None);
            let table = table(&found, Language::English.words());
            (1..6).filter(|k| *k != 2).map(|k| table.rows.iter().map(|row| row[k].text.clone()).collect()).collect()
        };
        let text = "quantity,velocity_m_s,low,high\nforce,0.131,1.5,930\nforce,0.524,880,1000\nforce,3,0.5,12345\n";
        let found = columns(text);
        assert_eq!(found[0], ["131", "524", "3000"]);
        assert_eq!(found[1], ["1.50", "880.00", "0.50"]);
        assert_eq!(found[2], ["930.0", "1000.0", "12345.0"]);
        let fine = columns(&text.replace("0.131", "0.1311").replace("0.524", "0.52425"));
        assert_eq!(fine[0], ["131.10", "524.25", "3000.00"]);
    }

    #[test]
    fn the_verdict_stands_first_and_in_the_language_asked_for() {
        let kept = "quantity,velocity_m_s,low,high\nforce,0.31,880,930\n";
        assert!(page_of(kept, Language::English).contains("PASS. The damper keeps all limits (1)."));
        let missed = kept.replace("930", "890");
        let german = page_of(&missed, Language::German);
        assert!(german.contains("NICHT BESTANDEN. Der Dämpfer hält 1 von 1 Grenzwert nicht ein."));
        assert!(german.contains("Kraft, Zugstufe") && german.contains("<html lang=\"de\">"));
        // The certificate leaves missing metadata blank for handwriting, and has no date from the clock.
        assert!(german.contains(&format!("Seriennummer: {}", crate::words::DE.to_fill_in)));
        let untested = page_of("quantity,velocity_m_s,low,high\nfriction,,1,2\n", Language::English);
        assert!(untested.contains("INCOMPLETE. The limit could not be tested") && untested.contains("NOT TESTED"));
        assert!(untested.contains("class=\"lead verdict incomplete\"") && !untested.contains("FAIL"));
        let some = page_of(&format!("{kept}friction,,1,2\n"), Language::English);
        assert!(some.contains("INCOMPLETE. The limit tested is kept; 1 more could not be tested"));
        let both = page_of(&format!("{missed}friction,,1,2\n"), Language::English);
        assert!(both.contains("FAIL. 1 of the 1 limit tested is not kept; 1 more could not be tested"));
        // The certificate explains the interpolation of a force between two tests.
        assert!(
            untested
                .contains("interpolated linearly between two tests whose velocities differ by a factor of 2 at most")
        );
        assert!(untested.find("<svg").unwrap() < untested.find("<table").unwrap(), "picture before table");
    }
}
