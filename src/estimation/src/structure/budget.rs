//! Limits of the cost of a search step.

/// Numbers of refits that an expansion may spend.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    /// Numbers of starts that are refitted for each form: starts with unchanged base parameters, then starts that
    /// change base parameters. Base parameters are those of the model without the effect.
    pub starts: [usize; 2],
    /// Number of starts that are refitted in total. The best start of every effect is refitted even beyond this number.
    pub entrants: usize,
    /// Number of forms that are refitted in the second stage of the successive halving.
    pub forms: usize,
    /// Number of forms that are refitted in the third stage, each with a newly computed Jacobian.
    pub finals: usize,
}

impl Budget {
    /// Budget for every form of every effect.
    pub const WIDE: Budget = Budget { starts: [2, 2], entrants: 84, forms: 20, finals: 4 };
    /// Budget for the forms that were not promising before, at the end of a search.
    pub const REMAINING: Budget = Budget { starts: [1, 1], entrants: 50, forms: 10, finals: 2 };
    /// Budget for a few promising forms.
    pub const NARROW: Budget = Budget { starts: [1, 1], entrants: 30, forms: 10, finals: 3 };
    /// Budget for the comparison of an effect with its rivals.
    pub const RIVALS: Budget = Budget { starts: [1, 1], entrants: 18, forms: 6, finals: 2 };
}
