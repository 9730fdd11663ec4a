//! How strongly the records speak for one effect, and what confidence that deserves.

use super::refit::{Refit, gram};
use super::samples::Test;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// What a refit with an effect brought, in figures that mean the same for every campaign.
#[derive(Debug, Clone, Copy, Default, Serialize)]
pub struct Evidence {
    /// Fall of χ², each sample counted for what it is worth beside correlated noise.
    pub chi2_fall: f64,
    /// The same less what its numbers cost: fall of Schwarz's criterion (Ann. Stat. 6, 1978).
    pub bic_fall: f64,
    /// Share of the excess over the noise floor that it explains.
    pub share: f64,
    /// The same of the excess before any effect was named.
    pub of_all: f64,
    /// Root mean square of what it explains, in units of the noise.
    pub size: f64,
    /// Lead of its criterion over the best effect of another name, each as it counts.
    pub margin: f64,
    /// Mean fall of the logarithm of a test's error when that test is left out of the refit.
    pub left_out_gain: f64,
    /// Share of the tests that are predicted better when left out.
    pub tests_better: f64,
    /// Root mean square of the excess before, in units of the noise.
    pub excess: f64,
    /// How many fresh numbers it has.
    pub numbers: usize,
    /// The same, those that are held near an expected value counted half.
    pub free: f64,
    /// Share of them that are inside what dampers and rigs show.
    pub plausible: f64,
    /// Whether one that is not tells that it is another effect.
    pub contrary: bool,
    /// Whether it is of a kind that fits a little of everything.
    pub sponge: bool,
    /// Whether another effect was named before.
    pub later: bool,
    /// Whether the measured force grows or falls from cycle to cycle all through the tests, which the effect does not make.
    pub unsettled: bool,
}

/// What noise adds to the χ² of a test.
fn noise_of(test: &Test) -> f64 {
    test.allowed.iter().map(|a| (test.mean_noise / a).powi(2)).sum()
}

/// Expected χ² if nothing but noise were left. A variance estimated from few deviations is too small as often as it is too
/// large, and its inverse is too large in the mean: by ν/(ν − 2).
pub fn noise_chi2(tests: &[Test]) -> f64 {
    tests.iter().map(|t| noise_of(t) * (1.0 + 2.0 / (t.noise_freedom - 2.0).max(4.0))).sum()
}

/// Standard deviation of that: of the residuals themselves, and of the noise they are compared with.
pub fn noise_chi2_deviation(tests: &[Test]) -> f64 {
    let of = |t: &Test| noise_of(t).powi(2) * (2.0 / t.independent_count().max(1.0) + 2.0 / t.noise_freedom.max(4.0));
    tests.iter().map(of).sum::<f64>().sqrt()
}

/// Independent samples of all tests.
pub fn effective_count(tests: &[Test]) -> f64 {
    tests.iter().map(Test::independent_count).sum::<f64>().max(1.0)
}

/// Standard deviations, over all tests, of a growth from cycle to cycle that is no chance.
const GROWS: f64 = 6.0;

/// Whether the force grows or falls from cycle to cycle all through the tests: the damper remembers more than a cycle.
pub fn is_unsettled(tests: &[Test]) -> bool {
    let (sum, count) = tests.iter().filter(|t| t.growth != 0.0).fold((0.0, 0.0), |(s, n), t| (s + t.growth, n + 1.0));
    f64::abs(sum) > GROWS * f64::sqrt(count)
}

/// Share of the full information that stays when a test is left out which alone determines a number.
const RIDGE: f64 = 1e-3;

/// Mean square of each test's weighted residual as predicted from all other tests, to first order (Cook & Weisberg,
/// *Residuals and Influence in Regression*, 1982).
pub fn left_out(tests: &[Test], refit: &Refit) -> Vec<f64> {
    let n = refit.jacobian.ncols();
    let mut row = 0;
    let parts: Vec<_> = tests
        .iter()
        .map(|test| {
            let rows = refit.jacobian.rows(row, test.count());
            let residual: DVector<f64> = refit.residual.rows(row, test.count()).into_owned();
            row += test.count();
            (gram(&rows), rows, residual)
        })
        .collect();
    let hessian = parts.iter().fold(DMatrix::zeros(n, n), |sum, (of_test, ..)| sum + of_test);
    parts
        .into_iter()
        .map(|(of_test, rows, residual)| {
            let mut others: DMatrix<f64> = &hessian - of_test;
            for i in 0..n {
                others[(i, i)] += RIDGE * hessian[(i, i)] + 1e-300;
            }
            let moved = others.cholesky().map(|c| c.solve(&rows.tr_mul(&residual)));
            let predicted = match moved {
                Some(moved) => &residual + rows * moved,
                None => residual,
            };
            // No test can be predicted better than to a part of its allowed error.
            predicted.norm_squared() / predicted.len().max(1) as f64 + 0.05
        })
        .collect()
}

/// Mean excess, in σ², that the form of right names leaves: a share of the excess is one of what goes beyond.
const FORM: f64 = 0.1;
/// Least excess that a share is taken of, in σ².
const LEAST: f64 = 0.06;
/// Share of the excess that an effect must explain; of what a name has left, a smaller one will do; those that fit a little
/// of everything need more.
const SHARE: f64 = 0.4;
const LATER_SHARE: f64 = 0.25;
const SPONGE_SHARE: f64 = 0.55;
/// The same where the force changes from cycle to cycle, which the effect does not: it then fits its mean.
const UNSETTLED_SHARE: f64 = 0.8;
const UNSETTLED_SPONGE_SHARE: f64 = 0.85;
/// Root mean square of an effect, in units of the noise, below which it is not named: curves through a dozen points and
/// steps of finite length leave as much.
const SMALLEST: f64 = 0.2;
/// Mean fall of the logarithm of a left-out test's error below which an effect predicts nothing, much as it explains.
const LEFT_OUT: f64 = -0.15;
/// Share of the tests that must be predicted better where the mean is spoilt by few.
const MOST_TESTS: f64 = 0.65;
/// Confidence from which a disagreement gets a name that is as small as what the form of the curves leaves.
const SURELY: f64 = 0.8;
/// Share of the excess below which it explains a part.
const PART: f64 = 0.6;
/// Numbers from which an effect has many.
const MANY: usize = 4;
/// Share of the excess that is nearly all of it.
const NEARLY_ALL: f64 = 0.9;
/// The same where nothing is allowed for the form.
const MOST: f64 = 0.7;
/// What a criterion is worth that needs numbers which no damper shows.
const FAR_FETCHED: f64 = 0.9;
/// What it loses by each free number beyond a few: where the form of the curves is all that is left to explain, any further
/// number explains some of it.
const PER_NUMBER: f64 = 0.03;
const FEW: f64 = 3.0;
/// Lead over all rivals that no sponge has, and that of one which explains nearly everything.
const FAR_AHEAD: f64 = 0.5;
const AHEAD: f64 = 0.25;
const MUCH: f64 = 0.8;

/// Share of the excess before any name that a later name is expected to explain: less is often the form of the first.
const LATER_PART: f64 = 0.3;

/// Weights of the logistic that turns evidence into confidence; fitted to dampers with hidden effects whose seeds are
/// used for nothing else.
const WEIGHTS: [f64; FEATURES] = [-11.142, 1.176, 2.697, -2.423, 1.774, 2.572, -4.502, 1.063];
/// Number of features.
pub const FEATURES: usize = 8;
/// How much steeper the logistic is for names that are given: it was fitted to all that may be named, of which the bars beside it
/// take the wrong ones back (Platt, in *Advances in Large Margin Classifiers*, 2000; on the same seeds).
const STEEPER: f64 = 1.4;
/// Most that is claimed: as many hidden effects as were tried show no more.
const SUREST: f64 = 0.99;

/// Share of an excess, both in σ² per independent sample, beyond what the form of right names leaves.
pub fn share_beyond_form(fall: f64, excess: f64) -> f64 {
    fall / (excess - FORM).max(LEAST)
}

impl Evidence {
    /// Its criterion as it counts against rivals.
    pub fn standing(&self) -> f64 {
        let worth = if self.plausible >= 1.0 { self.bic_fall } else { FAR_FETCHED * self.bic_fall };
        worth * (1.0 - PER_NUMBER * (self.free - FEW).max(0.0))
    }

    fn explained(&self) -> f64 {
        let excess = self.excess * self.excess;
        share_beyond_form(self.share * excess, excess).clamp(-1.0, 1.05)
    }

    /// Whether it stands against others: its numbers do not tell that it is another effect, nor are most of them such as no
    /// damper shows while it leaves much.
    pub fn is_rival(&self) -> bool {
        !self.contrary && (self.plausible >= 0.5 || self.explained() >= NEARLY_ALL)
    }

    /// Its margin as a share of its own standing.
    fn lead(&self) -> f64 {
        self.margin / self.standing().abs().max(1.0)
    }

    /// Whether it explains nearly all and no rival comes near: what fits a little of everything does neither.
    fn is_alone(&self) -> bool {
        self.share >= MOST && self.explained() >= NEARLY_ALL && self.lead() >= FAR_AHEAD
    }

    /// Whether it is sure of a disagreement so small that it would not matter otherwise.
    pub fn is_sure(&self) -> bool {
        self.explained() >= NEARLY_ALL && self.confidence() >= SURELY
    }

    /// What the logistic sees.
    pub fn features(&self) -> [f64; FEATURES] {
        let lead = self.lead();
        let repair = if self.later { (LATER_PART - self.of_all).max(0.0) / LATER_PART } else { 0.0 };
        [
            1.0,
            (self.bic_fall / 10.0).asinh(),
            self.plausible,
            f64::from(u8::from(self.sponge && !self.is_alone())),
            // Of two that explain nearly the same, the form of the curves decides, not the effect.
            (4.0 * lead).clamp(-1.0, 1.0),
            (10.0 * lead).clamp(-1.0, 1.0),
            repair,
            self.explained(),
        ]
    }

    /// Whether it may be named at all, however confident: it explains a fair share of the disagreement, is large enough to
    /// matter, and predicts tests better that it has not seen.
    pub fn is_admissible(&self) -> bool {
        let share = match (self.sponge, self.later) {
            (true, _) if self.unsettled => UNSETTLED_SPONGE_SHARE,
            (false, false) if self.unsettled => UNSETTLED_SHARE,
            (true, _) => SPONGE_SHARE,
            (false, true) => LATER_SHARE,
            (false, false) => SHARE,
        };
        // What fits a little of everything does so with numbers that no damper shows, and others then fit it too.
        // Of many numbers one may be far-fetched, or more where nearly everything is explained.
        let likely = if self.sponge {
            let (lead, explained) = (self.lead(), self.explained());
            let needed = if explained >= MUCH { AHEAD } else { FAR_AHEAD };
            // One number cannot fit a little of everything and nearly all of this: its value is extreme, not its name wrong.
            let only = self.free <= 1.0 && explained >= NEARLY_ALL;
            self.plausible >= 1.0 || (self.plausible > 0.5 && lead >= needed) || (only && lead >= FAR_AHEAD)
        } else {
            let most = if self.numbers < MANY { self.plausible >= 0.5 } else { self.plausible > 0.5 };
            self.numbers == 1 || most || self.explained() >= NEARLY_ALL
        };
        // What explains a part and predicts no test better that it has not seen has fitted the rest of something else.
        // Where it explains nearly all, one test that alone shows its strength says nothing against it.
        let predicts = self.left_out_gain > if self.explained() >= PART { LEFT_OUT } else { 0.0 }
            || self.explained() >= NEARLY_ALL && self.tests_better >= MOST_TESTS;
        // What is left beside another effect is the memory itself.
        let settled = !(self.sponge && self.unsettled && self.later);
        likely
            && settled
            && !self.contrary
            && self.explained() >= share
            && self.size >= SMALLEST
            && predicts
            && self.bic_fall > 10.0
    }

    /// Logarithm of the odds that the name is right, beyond what is claimed: what orders effects that are all sure.
    pub fn log_odds(&self) -> f64 {
        STEEPER * self.features().iter().zip(WEIGHTS).map(|(f, w)| f * w).sum::<f64>()
    }

    /// Probability that the name is right.
    pub fn confidence(&self) -> f64 {
        (1.0 / (1.0 + (-self.log_odds()).exp())).min(SUREST)
    }
}
