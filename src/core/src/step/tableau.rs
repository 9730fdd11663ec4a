//! Tableaus of the integration methods: diagonally implicit Runge–Kutta, L-stable and stiffly accurate.

use crate::integration::Method;

/// Largest number of stages of a method.
pub(super) const MOST_STAGES: usize = 5;

/// Coefficients a_ij of a diagonally implicit Runge–Kutta method. The last row gives the result of the step (stiffly
/// accurate).
pub(super) struct Tableau {
    /// Number of stages.
    pub stages: usize,
    /// Diagonal coefficient γ, equal for all stages.
    pub gamma: f64,
    /// Reciprocal of the diagonal coefficient, 1/γ.
    pub per_gamma: f64,
    /// Coefficients below the diagonal, divided by the diagonal coefficient: a_ij/γ. They are the weights of the gains
    /// of the previous stages. A gain is γ times the length of the substep times the rate.
    pub weights: [[f64; MOST_STAGES]; MOST_STAGES],
    /// Times of the stages as fractions of the substep.
    pub c: [f64; MOST_STAGES],
    /// Index of the stage with the latest time before the last stage; 0 if the force at the end is not checked: see
    /// [`super::paths`].
    pub latest: usize,
    /// Whether the plain step of this method linearizes the forces and has a closed form ([`super::cheap`]).
    pub along_lines: bool,
    /// Time from the stage `latest` to the end, relative to the time from the first stage to `latest`, and at least a
    /// given minimum. It scales the allowed change of the force at the end.
    pub goes_on: f64,
}

impl Tableau {
    /// Returns the tableau of a method.
    #[inline(always)]
    pub fn for_method(method: Method) -> &'static Tableau {
        match method {
            Method::Fourth => &FOURTH,
            Method::Third => &THIRD,
            Method::ThreeStage => &THREE_STAGE,
            Method::Second => &SECOND,
            Method::Euler => &ALONG_LINES,
            Method::BackwardEuler => &EULER,
        }
    }

    /// Builds a tableau from γ and the rows below the diagonal. `ends_within` is the least value of
    /// [`Tableau::goes_on`]. The times of the stages are the sums of the rows; unused entries of the rows are 0.
    const fn new(stages: usize, gamma: f64, below: [[f64; MOST_STAGES]; MOST_STAGES], ends_within: f64) -> Tableau {
        let mut rows = Tableau {
            stages,
            gamma,
            per_gamma: 1.0 / gamma,
            weights: [[0.0; MOST_STAGES]; MOST_STAGES],
            c: [1.0; MOST_STAGES],
            latest: 0,
            along_lines: false,
            goes_on: 0.0,
        };
        let mut i = 0;
        while i + 1 < stages {
            let (mut j, mut sum) = (0, 0.0);
            while j < i {
                sum += below[i][j];
                j += 1;
            }
            rows.c[i] = sum + gamma;
            i += 1;
        }
        i = 0;
        while i < stages {
            let mut j = 0;
            while j < i {
                rows.weights[i][j] = below[i][j] / gamma;
                j += 1;
            }
            i += 1;
        }
        i = 0;
        while i + 1 < stages {
            if rows.c[i] > rows.c[rows.latest] {
                rows.latest = i;
            }
            i += 1;
        }
        if rows.latest > 0 {
            let (first, latest) = (rows.c[0], rows.c[rows.latest]);
            let straight = (1.0 - latest) / (latest - first);
            rows.goes_on = if straight > ends_within { straight } else { ends_within };
        }
        rows
    }
}

/// Smallest value of [`Tableau::goes_on`] for steps through the force paths. With half of this value, the check of the
/// four-stage method wrongly detected an overshoot in every twentieth step with free play.
const ENDS_WITHIN: f64 = 1.0;

/// [`Method::BackwardEuler`].
pub(super) static EULER: Tableau = Tableau::new(1, 1.0, [[0.0; 5]; 5], ENDS_WITHIN);

/// [`Method::Euler`], whose plain step is linearized; in other steps it equals [`EULER`].
pub(super) static ALONG_LINES: Tableau =
    Tableau { along_lines: true, ..Tableau::new(1, 1.0, [[0.0; 5]; 5], ENDS_WITHIN) };

/// [`Method::Second`].
pub(super) static SECOND: Tableau = {
    let gamma = 1.0 - core::f64::consts::FRAC_1_SQRT_2;
    let below = [[0.0; 5], [1.0 - gamma, 0.0, 0.0, 0.0, 0.0], [0.0; 5], [0.0; 5], [0.0; 5]];
    Tableau::new(2, gamma, below, ENDS_WITHIN)
};

/// Smallest diagonal coefficient with which three stages of order 2 are L-stable, rounded up. It also gives the
/// smallest error (Hairer & Wanner, table IV.6.4).
const THREE_STAGE_GAMMA: f64 = 0.180_425_4;
/// Time of the second stage as a fraction of the substep, which the order conditions do not determine. With this value,
/// the error over all kinds of dampers at 1 ms steps has a flat minimum.
const THREE_STAGE_PLACE: f64 = 0.663;

/// [`Method::ThreeStage`].
pub(super) static THREE_STAGE: Tableau = {
    let (gamma, c2) = (THREE_STAGE_GAMMA, THREE_STAGE_PLACE);
    // The last row is b₁, b₂, γ, and the times are γ, c₂, 1. The order conditions are b₁ + b₂ + γ = 1 and b₁ γ + b₂ c₂
    // + γ = ½.
    let b2 = (0.5 - gamma - (1.0 - gamma) * gamma) / (c2 - gamma);
    let below = [[0.0; 5], [c2 - gamma, 0.0, 0.0, 0.0, 0.0], [1.0 - gamma - b2, b2, 0.0, 0.0, 0.0], [0.0; 5], [0.0; 5]];
    Tableau::new(3, gamma, below, ENDS_WITHIN)
};

/// Smallest diagonal coefficient with which four stages of order 3 are L-stable, rounded up (Hairer & Wanner, table
/// IV.6.4).
const THIRD_GAMMA: f64 = 0.223_647_9;
/// Times of the second and the third stage as fractions of the substep, which the order conditions do not determine.
/// They are chosen like [`THREE_STAGE_PLACE`].
const THIRD_PLACES: [f64; 2] = [0.607, 0.877];

/// [`Method::Third`].
pub(super) static THIRD: Tableau = {
    let (g, [c2, c3]) = (THIRD_GAMMA, THIRD_PLACES);
    // The order conditions for weights b and times c are Σ b = 1, Σ b c = ½, Σ b c² = ⅓. The last stage, with c = 1 and
    // b = γ, is subtracted.
    let sums = [1.0 - g, 0.5 - g, 1.0 / 3.0 - g];
    const fn weight(sums: [f64; 3], own: f64, other: f64, third: f64) -> f64 {
        (sums[2] - (other + third) * sums[1] + other * third * sums[0]) / ((own - other) * (own - third))
    }
    let (b1, b2, b3) = (weight(sums, g, c2, c3), weight(sums, c2, g, c3), weight(sums, c3, g, c2));
    // The order condition Σ b_i a_ij c_j = ⅙, solved for a₃₂.
    let others = 0.5 * g + b1 * g * g + b2 * ((c2 - g) * g + g * c2) + b3 * ((c3 - g) * g + g * c3);
    let a32 = (1.0 / 6.0 - others) / (b3 * (c2 - g));
    let below =
        [[0.0; 5], [c2 - g, 0.0, 0.0, 0.0, 0.0], [c3 - g - a32, a32, 0.0, 0.0, 0.0], [b1, b2, b3, 0.0, 0.0], [0.0; 5]];
    Tableau::new(4, g, below, ENDS_WITHIN)
};

/// [`Method::Fourth`]. Its weights (coefficients over the diagonal one) reach 31, so the check of its end force uses no
/// minimum of [`Tableau::goes_on`].
pub(super) static FOURTH: Tableau = Tableau::new(
    5,
    0.25,
    [
        [0.0; 5],
        [1.0 / 2.0, 0.0, 0.0, 0.0, 0.0],
        [17.0 / 50.0, -1.0 / 25.0, 0.0, 0.0, 0.0],
        [371.0 / 1360.0, -137.0 / 2720.0, 15.0 / 544.0, 0.0, 0.0],
        [25.0 / 24.0, -49.0 / 48.0, 125.0 / 16.0, -85.0 / 12.0, 0.0],
    ],
    0.0,
);
