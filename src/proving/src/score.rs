//! Table of the benchmark's results.

use crate::outcome::{Outcome, plain};
use dashpot_diagnosis::Verdict;
use std::collections::BTreeMap;
use std::fmt::Write as _;

fn share(hits: usize, of: usize) -> String {
    if of == 0 {
        return "-".to_owned();
    }
    // Wilson's 95 % interval of a proportion (J. Am. Stat. Assoc. 22, 1927).
    let (n, p) = (of as f64, hits as f64 / of as f64);
    let z = 1.96f64;
    let middle = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    let half = z / (1.0 + z * z / n) * (p * (1.0 - p) / n + z * z / (4.0 * n * n)).sqrt();
    format!("{p:.3} ({hits}/{of}; {:.2}–{:.2})", (middle - half).max(0.0), (middle + half).min(1.0))
}

fn median(mut values: Vec<f64>) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    values.sort_by(f64::total_cmp);
    Some(values[values.len() / 2])
}

/// Computes the fraction of the error against the noise-free force of the left-out tests that the improved model
/// removes.
fn closed(o: &Outcome) -> f64 {
    1.0 - o.clean_after / o.clean_before.max(1e-9)
}

/// Returns the outcomes of one block of the suite.
fn of_block<'a>(all: &'a [Outcome], block: &str) -> Vec<&'a Outcome> {
    all.iter().filter(|o| o.block == block).collect()
}

fn is_right_first(o: &&Outcome) -> bool {
    o.named.first().is_some_and(|(name, _)| Some(name.as_str()) == o.truth())
}

fn is_wrong_first(o: &&Outcome) -> bool {
    o.named.first().is_some_and(|(name, _)| Some(name.as_str()) != o.truth())
}

/// Formats two fractions of outcomes: those whose most probable named effect is right, and those whose most probable
/// named effect is wrong.
fn first_names(label: &str, some: &[&Outcome]) -> String {
    format!(
        "{label}, right name first: {}; wrong name first: {}",
        share(some.iter().filter(|o| is_right_first(o)).count(), some.len()),
        share(some.iter().filter(|o| is_wrong_first(o)).count(), some.len())
    )
}

/// Formats the results of the benchmark, one measure on each line.
pub fn table(all: &[Outcome]) -> String {
    let mut lines = Vec::new();
    let single = of_block(all, "single");
    let taken_up = single.iter().filter(|o| o.in_the_model).count();
    let named = single.iter().filter(|o| o.in_the_model && !o.named.is_empty()).count();
    lines.push(format!(
        "in the model that the fit has made already: {taken_up} of {}, {named} of them with a name",
        single.len()
    ));
    let single: Vec<_> = single.into_iter().filter(|o| !o.in_the_model).collect();
    lines.extend(single_names(&single));
    let elsewhere: Vec<_> = of_block(all, "elsewhere").into_iter().filter(|o| !o.in_the_model).collect();
    lines.push(first_names("measured as some laboratory would", &elsewhere));
    lines.push(first_names("started from a fit with all elements", &of_block(all, "whole_fit")));
    for block in ["null_white", "null_coloured", "null_form", "null_whole_fit", "null_elsewhere"] {
        lines.extend(false_alarms(block, &of_block(all, block)));
    }
    lines.extend(found_effects(all));
    lines.extend(closed_gaps(&single));
    let worse = all.iter().filter(|o| o.clean_after > 1.02 * o.clean_before).count();
    lines.push(format!("left-out tests made worse: {}", share(worse, all.len())));
    lines.push(calibration(all));
    lines.extend(poor_plans(&of_block(all, "poor")));
    if let Some(m) = median(all.iter().map(|o| o.seconds).collect()) {
        lines.push(format!("seconds per diagnosis, median: {m:.2}"));
    }
    lines.join("\n") + "\n"
}

/// Returns the severity of the first injected effect.
fn severity(o: &Outcome) -> f64 {
    o.injected[0].1
}

/// Formats, for dampers with one injected effect, how often the diagnosis names the right effect first, names a wrong
/// effect, or names a second effect.
fn single_names(single: &[&Outcome]) -> Vec<String> {
    let mut lines = Vec::new();
    for (label, low, high) in [("severity >= 0.75", 0.75, f64::MAX), ("severity 0.5", 0.0, 0.75)] {
        let some: Vec<_> = single.iter().copied().filter(|o| (low..high).contains(&severity(o))).collect();
        let hits = some.iter().filter(|o| is_right_first(o)).count();
        lines.push(format!("right name first, {label}: {}", share(hits, some.len())));
    }
    let wrong = single.iter().filter(|o| is_wrong_first(o)).count();
    lines.push(format!("wrong name first: {}", share(wrong, single.len())));
    let sure = single.iter().filter(|o| o.named.iter().any(|(n, c)| !o.is_injected(n) && *c >= 0.9)).count();
    lines.push(format!("wrong name given as sure (>= 0.9), anywhere: {}", share(sure, single.len())));
    let extra = single.iter().filter(|o| o.named.len() > 1).count();
    lines.push(format!("a second name where one is hidden: {}", share(extra, single.len())));
    lines
}

/// Formats how often the diagnosis names an effect of a healthy damper. Also formats how many of these names are true,
/// and how often it reports that nothing is missing.
fn false_alarms(block: &str, some: &[&Outcome]) -> [String; 3] {
    let alarms = some.iter().filter(|o| !o.named.is_empty()).count();
    let names = || some.iter().flat_map(|o| o.named.iter().map(|(name, _)| o.is_true(name)));
    let changed = some.iter().filter(|o| o.verdict == Verdict::Changed).count();
    let nothing = some.iter().filter(|o| o.verdict.nothing_is_missing()).count();
    [
        format!("false alarm, {block}: {}", share(alarms, some.len())),
        format!(
            "  of these names, true of the damper though not hidden in it: {}",
            share(names().filter(|is| *is).count(), names().count())
        ),
        format!(
            "  nothing_missing said: {}, with other numbers than the reference's {changed}",
            share(nothing, some.len())
        ),
    ]
}

/// Formats how often the diagnosis gives an unknown effect a known name, how often it finds injected effects, and how
/// many names are true. The last line is for pairs of injected effects.
fn found_effects(all: &[Outcome]) -> [String; 4] {
    let unknown = of_block(all, "unknown");
    let named = unknown.iter().filter(|o| !o.named.is_empty()).count();
    let injected: Vec<_> = all.iter().filter(|o| !o.injected.is_empty() && o.block != "unknown").collect();
    let found = injected.iter().filter(|o| o.truth().is_some_and(|t| o.found.iter().any(|n| n == t)));
    let names: Vec<bool> = all.iter().flat_map(|o| o.named.iter().map(|(name, _)| o.is_true(name))).collect();
    let pairs = of_block(all, "pair");
    let has_both = |o: &&&Outcome| o.injected.iter().all(|(h, _)| o.named.iter().any(|(n, _)| n == plain(h)));
    let extras: usize = pairs.iter().map(|o| o.named.iter().filter(|(n, _)| !o.is_injected(n)).count()).sum();
    [
        format!("outside the vocabulary, given a known name: {}", share(named, unknown.len())),
        format!("injected effect among the names or in the model: {}", share(found.count(), injected.len())),
        format!("names in the true set: {}", share(names.iter().filter(|is| **is).count(), names.len())),
        format!(
            "pairs, both named: {}; both found, by a name or in the fit: {}; other names per case: {:.2}",
            share(pairs.iter().filter(has_both).count(), pairs.len()),
            share(pairs.iter().filter(|o| o.found.len() == o.injected.len()).count(), pairs.len()),
            extras as f64 / pairs.len().max(1) as f64
        ),
    ]
}

/// Formats the medians of the gaps that the improved models close.
fn closed_gaps(single: &[&Outcome]) -> Vec<String> {
    let mut lines = Vec::new();
    for (label, low) in [("severity >= 0.75", 0.75), ("severity >= 3", 3.0)] {
        let strong = || single.iter().filter(|o| severity(o) >= low);
        if let Some(m) = median(strong().map(|o| closed(o)).collect()) {
            lines.push(format!("gap to the noise-free force closed on left-out tests, median, {label}: {m:.3}"));
        }
        if let Some(m) = median(strong().map(|o| o.gap_closed.unwrap_or(0.0)).collect()) {
            lines.push(format!("gap to the noise closed on left-out tests, median, {label}: {m:.3}"));
        }
    }
    lines
}

/// Formats, for poor test plans, how often the diagnosis names the right effect or reports that it cannot. Also formats
/// how often the proposed tests lead to the right name.
fn poor_plans(poor: &[&Outcome]) -> Vec<String> {
    let is_honest = |o: &&&Outcome| {
        is_right_first(o)
            || (o.named.is_empty() && !o.verdict.nothing_is_missing())
            || o.truth().is_some_and(|t| o.could_not_test.iter().any(|c| c == t))
    };
    let honest = poor.iter().filter(is_honest).count();
    let mut lines = vec![format!("poor plans, named right or said so: {}", share(honest, poor.len()))];
    for (label, name) in [
        (
            "the test proposed first, run as well, decides",
            (|o| o.with_proposed.as_deref()) as fn(&Outcome) -> Option<&str>,
        ),
        ("all sines proposed, run as well, decide", |o| o.with_all_proposed.as_deref()),
    ] {
        let after: Vec<bool> = poor.iter().filter_map(|o| name(o).map(|name| Some(name) == o.truth())).collect();
        lines.push(format!("  {label}: {}", share(after.iter().filter(|right| **right).count(), after.len())));
    }
    lines
}

/// Formats the expected calibration error, and the precision of names with a confidence of at least 0.9.
fn calibration(all: &[Outcome]) -> String {
    let given: Vec<(f64, bool)> = all.iter().flat_map(|o| o.named.iter().map(|(n, c)| (*c, o.is_true(n)))).collect();
    let mut error = 0.0;
    for bin in 0..10 {
        let (low, high) = (f64::from(bin) / 10.0, f64::from(bin + 1) / 10.0 + if bin == 9 { 1.0 } else { 0.0 });
        let some: Vec<_> = given.iter().filter(|(c, _)| (low..high).contains(c)).collect();
        if some.is_empty() {
            continue;
        }
        let n = some.len() as f64;
        let mean = some.iter().map(|(c, _)| c).sum::<f64>() / n;
        let hit = some.iter().filter(|(_, h)| *h).count() as f64 / n;
        error += n / given.len() as f64 * (mean - hit).abs();
    }
    let sure: Vec<_> = given.iter().filter(|(c, _)| *c >= 0.9).collect();
    format!(
        "expected calibration error of names given: {error:.3}; precision at 0.9: {}",
        share(sure.iter().filter(|(_, h)| *h).count(), sure.len())
    )
}

/// Formats the confusion matrix: for each injected effect, the effects that were named first, with their counts.
pub fn confusion(all: &[Outcome]) -> String {
    let mut counts: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
    for o in all.iter().filter(|o| o.block == "single" || o.block == "unknown" || o.block.starts_with("null")) {
        let truth =
            if o.block.starts_with("null") { o.block.to_owned() } else { o.truth().unwrap_or("nothing").to_owned() };
        let answer = match (o.named.first(), o.verdict) {
            (Some((name, _)), _) => name.clone(),
            (None, Verdict::NothingMissing | Verdict::Changed) => "(nothing missing)".to_owned(),
            (None, Verdict::Ambiguous) => "(cannot tell)".to_owned(),
            (None, _) => "(unknown)".to_owned(),
        };
        *counts.entry(truth).or_default().entry(answer).or_default() += 1;
    }
    let mut out = String::new();
    for (truth, answers) in counts {
        let mut list: Vec<_> = answers.into_iter().collect();
        list.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        let words: Vec<String> = list.iter().map(|(a, n)| format!("{a} {n}")).collect();
        let _ = writeln!(out, "{truth:>32}: {}", words.join(", "));
    }
    out
}
