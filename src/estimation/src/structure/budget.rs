//! Limits of the cost of a search step.

/// Numbers of refits that an expansion may spend.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    /// Starts that are refitted for each form: first those that keep the base parameters, then those that change
    /// them.
    pub starts: [usize; 2],
    /// Starts that are refitted in all.
    pub entrants: usize,
    /// Forms that are refitted in the second stage.
    pub forms: usize,
    /// Forms that are refitted with a Jacobian of their own.
    pub finals: usize,
}

impl Budget {
    /// Budget for every form of every effect.
    pub const WIDE: Budget = Budget { starts: [2, 2], entrants: 84, forms: 20, finals: 4 };
    /// Budget for a few promising forms.
    pub const NARROW: Budget = Budget { starts: [1, 1], entrants: 30, forms: 10, finals: 3 };
    /// Budget for the comparison of an effect with its rivals.
    pub const RIVALS: Budget = Budget { starts: [1, 1], entrants: 18, forms: 6, finals: 2 };
}
