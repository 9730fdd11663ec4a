//! The answer in one word, and in sentences.

use super::evidence::effective_count;
use super::outcome::{Rival, Verdict};
use super::round::{Round, Tried};
use super::samples::Test;
use super::search::Search;

/// Mean excess, in σ², that the form of the curves alone may leave.
const FORM: f64 = 0.4;
/// Share of the excess that a suspect must explain.
const SUSPECT_SHARE: f64 = 0.5;
/// Share of the excess below which an effect is no suspect and no rival.
pub const LISTED: f64 = 0.2;
/// Share of the remaining excess within which a rival explains as much as the best.
const AS_WELL: f64 = 0.15;

/// A verdict with its reasons.
pub struct Judged {
    /// The word.
    pub verdict: Verdict,
    /// The sentences.
    pub summary: String,
    /// What explains about as well as each other a disagreement, or the rest of one, that got no name; likeliest first.
    pub suspects: Vec<Rival>,
    /// Remarks.
    pub notes: Vec<String>,
    /// Whether all in all the model is within the noise.
    pub is_quiet: bool,
}

/// Judges a finished search; `missed` where single tests are missed by more than noise, whatever all in all says.
pub fn judge(found: &Search, tests: &[Test], most_effects: usize, missed: bool) -> Judged {
    let count = effective_count(tests);
    let excess = |chi2: f64| ((chi2 - found.floor) / count).max(0.0);
    let (before, after) = (excess(found.base.1.chi2), excess(found.last.1.chi2));
    let mut notes = Vec::new();
    let in_noise = |x: f64| format!("{:.2} times the noise", x.sqrt());
    if !found.added.is_empty() {
        let names: Vec<String> = found
            .added
            .iter()
            .map(|a| format!("{} ({:.0} % sure)", a.candidate.effect, 100.0 * a.confidence))
            .collect();
        // A round that added nothing is the last look at what is left.
        let is_added = |t: &Tried| found.added.iter().any(|a| a.candidate.effect == t.candidate.effect);
        let last = found.rounds.last().filter(|r| !r.tried.first().is_some_and(is_added));
        let rest = last.map_or(Vec::new(), suspects);
        let may_be = rest.first().is_some_and(|s| s.share >= SUSPECT_SHARE);
        if after > found.quiet && (may_be || after > 0.15 * before) {
            let left = in_noise(after);
            notes.push(if may_be {
                let names: Vec<&str> = rest.iter().map(|s| s.effect).collect();
                format!(
                    "what is left ({left} beyond it) is no noise: {} would explain {:.0} % of it, but these records do not \
                     make that sure",
                    names.join(" or "),
                    100.0 * rest[0].share
                )
            } else {
                format!("what is left ({left} beyond it) is no noise, but no further effect is justified by these records")
            });
        }
        let suspects = if may_be && after > found.quiet { rest } else { Vec::new() };
        return Judged {
            verdict: Verdict::Named,
            summary: format!(
                "missing: {}; the disagreement falls from {} to {}",
                names.join(", "),
                in_noise(before),
                in_noise(after)
            ),
            suspects,
            notes,
            is_quiet: false,
        };
    }
    if !found.taken_back.is_empty() {
        notes.push(format!(
            "{} would explain a part of it, but together too little, at the cost of left-out tests, or no better than \
             something without a name: no name is given",
            found.taken_back.join(" and ")
        ));
    }
    let suspects = found.rounds.first().map_or(Vec::new(), suspects);
    let best = found.rounds.first().and_then(|r| r.named().next());
    let convincing = best.is_some_and(Tried::convinces);
    let looks_like = found.rounds.first().and_then(looks_like);
    if before < found.quiet || (before < FORM && !convincing) {
        let within = format!("the model is within {} of these records beyond the noise itself", in_noise(before));
        let (verdict, summary) = if missed {
            let says = "all in all, but misses single tests by far more, and none of the known effects explains that";
            (Verdict::UnknownEffect, format!("{within} {says}"))
        } else {
            let says = "no effect is justified by them";
            (Verdict::NothingMissing, format!("nothing is missing: {within}, and {says}"))
        };
        return Judged { verdict, summary, suspects: Vec::new(), notes, is_quiet: true };
    }
    if suspects.len() >= 2 && suspects[0].share >= SUSPECT_SHARE && looks_like.is_none() {
        let names: Vec<&str> = suspects.iter().map(|s| s.effect).collect();
        return Judged {
            verdict: Verdict::CannotTell,
            summary: format!(
                "something is missing ({} beyond the noise), and these records cannot tell {} apart",
                in_noise(before),
                names.join(" and ")
            ),
            suspects,
            notes,
            is_quiet: false,
        };
    }
    if most_effects == 0 {
        return Judged {
            verdict: Verdict::UnknownEffect,
            summary: format!("model and records disagree by {} beyond it; no effect was to be added", in_noise(before)),
            suspects,
            notes,
            is_quiet: false,
        };
    }
    let percent = |t: &Tried| 100.0 * t.evidence.share.clamp(0.0, 1.0);
    let nearest = match looks_like {
        Some((what, t)) => format!("; it looks like {what}, which explains {:.0} %", percent(t)),
        None => best
            .map_or(String::new(), |t| format!("; the nearest, {}, explains {:.0} %", t.candidate.effect, percent(t))),
    };
    Judged {
        verdict: Verdict::UnknownEffect,
        summary: format!(
            "model and records disagree by {} beyond it, and none of the known effects explains that{nearest}",
            in_noise(before)
        ),
        suspects,
        notes,
        is_quiet: false,
    }
}

/// What a disagreement without a name looks like, where that explains it better than any name.
fn looks_like(round: &Round) -> Option<(&'static str, &Tried)> {
    let best = round.tried.iter().max_by(|a, b| a.evidence.standing().total_cmp(&b.evidence.standing()))?;
    best.candidate.unnamed.filter(|_| best.evidence.share >= SUSPECT_SHARE).map(|what| (what, best))
}

/// The effects that explain about as much as the best.
fn suspects(round: &Round) -> Vec<Rival> {
    let Some(best) = round.named().next() else { return Vec::new() };
    round
        .named()
        .filter(|t| t.evidence.bic_fall > 0.0 && t.evidence.share > LISTED.max(best.evidence.share - AS_WELL))
        .take(4)
        .map(|t| rival(t, best))
        .collect()
}

/// The names that lost a round.
pub fn rivals(round: &Round) -> Vec<Rival> {
    let Some(best) = round.named().next() else { return Vec::new() };
    round.named().skip(1).take(4).map(|t| rival(t, best)).collect()
}

/// Whether it adds a force that never changes: gas and the zero of a load cell are one to all records in motion.
fn is_constant(t: &Tried) -> bool {
    matches!((t.candidate.effect, t.candidate.form), ("gas_preload" | "force_offset", ""))
}

fn rival(t: &Tried, best: &Tried) -> Rival {
    let why = if std::ptr::eq(t, best) {
        format!("explains {:.0} % of the excess", 100.0 * t.evidence.share)
    } else if t.evidence.bic_fall <= 0.0 {
        "brings less than its numbers cost".to_owned()
    } else if t.evidence.plausible < 1.0 && t.evidence.share > best.evidence.share - AS_WELL {
        "needs numbers that no damper shows".to_owned()
    } else if is_constant(t) && is_constant(best) {
        "the same constant force: to be sure, read the load cell with the damper hooked out".to_owned()
    } else {
        format!(
            "explains {:.0} % of the excess, {} {:.0} %",
            100.0 * t.evidence.share,
            best.candidate.effect,
            100.0 * best.evidence.share
        )
    };
    Rival {
        effect: t.candidate.effect,
        confidence: if std::ptr::eq(t, best) { t.confidence } else { t.confidence.min(1.0 - best.confidence) },
        share: t.evidence.share,
        why,
    }
}
