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

/// Formats the results of the benchmark, one measure on each line.
pub fn table(all: &[Outcome]) -> String {
    let mut out = String::new();
    let of = |block: &str| all.iter().filter(|o| o.block == block).collect::<Vec<_>>();
    let right = |o: &&Outcome| o.named.first().is_some_and(|(name, _)| Some(name.as_str()) == o.truth());
    let first_wrong = |o: &&Outcome| o.named.first().is_some_and(|(name, _)| Some(name.as_str()) != o.truth());
    let single = of("single");
    let taken_up = single.iter().filter(|o| o.in_the_model).count();
    let named = single.iter().filter(|o| o.in_the_model && !o.named.is_empty()).count();
    let _ = writeln!(
        out,
        "in the model that the fit has made already: {taken_up} of {}, {named} of them with a name",
        single.len()
    );
    let single: Vec<_> = single.into_iter().filter(|o| !o.in_the_model).collect();
    let severity = |o: &Outcome| o.injected[0].1;
    for (label, low, high) in [("severity >= 0.75", 0.75, f64::MAX), ("severity 0.5", 0.0, 0.75)] {
        let some: Vec<_> = single.iter().copied().filter(|o| (low..high).contains(&severity(o))).collect();
        let hits = some.iter().filter(|o| right(o)).count();
        let _ = writeln!(out, "right name first, {label}: {}", share(hits, some.len()));
    }
    let wrong = single.iter().filter(|o| first_wrong(o)).count();
    let _ = writeln!(out, "wrong name first: {}", share(wrong, single.len()));
    let sure = single.iter().filter(|o| o.named.iter().any(|(n, c)| !o.is_injected(n) && *c >= 0.9)).count();
    let _ = writeln!(out, "wrong name given as sure (>= 0.9), anywhere: {}", share(sure, single.len()));
    let extra = single.iter().filter(|o| o.named.len() > 1).count();
    let _ = writeln!(out, "a second name where one is hidden: {}", share(extra, single.len()));
    let elsewhere: Vec<_> = of("elsewhere").into_iter().filter(|o| !o.in_the_model).collect();
    let _ = writeln!(
        out,
        "measured as some laboratory would, right name first: {}; wrong name first: {}",
        share(elsewhere.iter().filter(|o| right(o)).count(), elsewhere.len()),
        share(elsewhere.iter().filter(|o| first_wrong(o)).count(), elsewhere.len())
    );
    let whole = of("whole_fit");
    let _ = writeln!(
        out,
        "started from a fit with all elements, right name first: {}; wrong name first: {}",
        share(whole.iter().filter(|o| right(o)).count(), whole.len()),
        share(whole.iter().filter(|o| first_wrong(o)).count(), whole.len())
    );
    for block in ["null_white", "null_coloured", "null_form", "null_whole_fit", "null_elsewhere"] {
        let some = of(block);
        let _ = writeln!(
            out,
            "false alarm, {block}: {}",
            share(some.iter().filter(|o| !o.named.is_empty()).count(), some.len())
        );
        let names = || some.iter().flat_map(|o| o.named.iter().map(|(name, _)| o.is_true(name)));
        let _ = writeln!(
            out,
            "  of these names, true of the damper though not hidden in it: {}",
            share(names().filter(|is| *is).count(), names().count())
        );
        let changed = some.iter().filter(|o| o.verdict == Verdict::Changed).count();
        let _ = writeln!(
            out,
            "  nothing_missing said: {}, with other numbers than the reference's {changed}",
            share(some.iter().filter(|o| o.verdict.nothing_is_missing()).count(), some.len())
        );
    }
    let unknown = of("unknown");
    let named = unknown.iter().filter(|o| !o.named.is_empty()).count();
    let _ = writeln!(out, "outside the vocabulary, given a known name: {}", share(named, unknown.len()));
    let injected: Vec<_> = all.iter().filter(|o| !o.injected.is_empty() && o.block != "unknown").collect();
    let found = injected.iter().filter(|o| o.truth().is_some_and(|t| o.found.iter().any(|n| n == t)));
    let _ = writeln!(out, "injected effect among the names or in the model: {}", share(found.count(), injected.len()));
    let names: Vec<bool> = all.iter().flat_map(|o| o.named.iter().map(|(name, _)| o.is_true(name))).collect();
    let _ = writeln!(out, "names in the true set: {}", share(names.iter().filter(|is| **is).count(), names.len()));
    let pairs = of("pair");
    let both =
        pairs.iter().filter(|o| o.injected.iter().all(|(h, _)| o.named.iter().any(|(n, _)| n == plain(h)))).count();
    let extras: usize = pairs.iter().map(|o| o.named.iter().filter(|(n, _)| !o.is_injected(n)).count()).sum();
    let _ = writeln!(
        out,
        "pairs, both named: {}; both found, by a name or in the fit: {}; other names per case: {:.2}",
        share(both, pairs.len()),
        share(pairs.iter().filter(|o| o.found.len() == o.injected.len()).count(), pairs.len()),
        extras as f64 / pairs.len().max(1) as f64
    );
    for (label, low) in [("severity >= 0.75", 0.75), ("severity >= 3", 3.0)] {
        let gaps: Vec<f64> = single.iter().filter(|o| severity(o) >= low).map(|o| closed(o)).collect();
        if let Some(m) = median(gaps) {
            let _ = writeln!(out, "gap to the noise-free force closed on left-out tests, median, {label}: {m:.3}");
        }
        let gaps: Vec<f64> =
            single.iter().filter(|o| severity(o) >= low).map(|o| o.gap_closed.unwrap_or(0.0)).collect();
        if let Some(m) = median(gaps) {
            let _ = writeln!(out, "gap to the noise closed on left-out tests, median, {label}: {m:.3}");
        }
    }
    let worse = all.iter().filter(|o| o.clean_after > 1.02 * o.clean_before).count();
    let _ = writeln!(out, "left-out tests made worse: {}", share(worse, all.len()));
    let _ = writeln!(out, "{}", calibration(all));
    let poor = of("poor");
    let honest = poor
        .iter()
        .filter(|o| {
            right(o)
                || (o.named.is_empty() && !o.verdict.nothing_is_missing())
                || o.truth().is_some_and(|t| o.could_not_test.iter().any(|c| c == t))
        })
        .count();
    let _ = writeln!(out, "poor plans, named right or said so: {}", share(honest, poor.len()));
    for (label, name) in [
        (
            "the test proposed first, run as well, decides",
            (|o| o.with_proposed.as_deref()) as fn(&Outcome) -> Option<&str>,
        ),
        ("all sines proposed, run as well, decide", |o| o.with_all_proposed.as_deref()),
    ] {
        let after: Vec<bool> = poor.iter().filter_map(|o| name(o).map(|name| Some(name) == o.truth())).collect();
        let _ = writeln!(out, "  {label}: {}", share(after.iter().filter(|right| **right).count(), after.len()));
    }
    if let Some(m) = median(all.iter().map(|o| o.seconds).collect()) {
        let _ = writeln!(out, "seconds per diagnosis, median: {m:.2}");
    }
    out
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
