//! Minimization of a failing case.

use crate::case::{Case, Failure};

/// Removes elements, parameters and steps while the case still fails.
pub fn minimise(mut case: Case, fails: impl Fn(&Case) -> Option<Failure>) -> (Case, Failure) {
    let mut failure = fails(&case).expect("a case that fails");
    // The ratio of the force to its limit (`by`) must stay at least at its original value or at 20, whichever is smaller. A smaller case
    // with a smaller ratio may show another failure.
    let enough = failure.by.min(20.0);
    let mut budget = 600;
    loop {
        let before = (case.on.len(), case.values.len(), case.motion.len());
        let until = failure.step + 1;
        let mut keep = |tried: Case, case: &mut Case| {
            if budget == 0 {
                return false;
            }
            budget -= 1;
            let Some(new) = fails(&tried).filter(|new| new.by >= enough) else { return false };
            (*case, failure) = (tried, new);
            true
        };
        // Steps after the failing step do not matter. Keep as few of the preceding steps as possible.
        let mut tried = case.clone();
        tried.motion.truncate(until);
        keep(tried, &mut case);
        let mut part = case.motion.len() / 2;
        while part > 0 {
            let mut from = 0;
            while from + part <= case.motion.len() {
                let mut tried = case.clone();
                tried.motion.drain(from..from + part);
                // The motion continues from the end of the removed part.
                if from == 0 {
                    tried.start = case.motion[part - 1].x.unwrap_or(case.start);
                }
                if !keep(tried, &mut case) {
                    from += part;
                }
            }
            part /= 2;
            if case.motion.len() > 64 && part < 4 {
                break;
            }
        }
        for name in case.on.clone() {
            let mut tried = case.clone();
            tried.on.retain(|n| *n != name);
            keep(tried, &mut case);
        }
        for (name, _) in case.values.clone() {
            let mut tried = case.clone();
            tried.values.retain(|(n, _)| *n != name && !(name.starts_with("fv_") && n.starts_with("fv_")));
            keep(tried, &mut case);
        }
        if budget == 0 || before == (case.on.len(), case.values.len(), case.motion.len()) {
            return (case, failure);
        }
    }
}
