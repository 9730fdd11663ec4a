//! How much a step of the search may spend.

/// How much an expansion may spend.
#[derive(Debug, Clone, Copy)]
pub struct Budget {
    /// Starts of one form that are refitted, of those that leave the base where it is and of those that move it.
    pub starts: [usize; 2],
    /// Starts that are refitted in all.
    pub entrants: usize,
    /// Forms that are refitted in the second heat.
    pub forms: usize,
    /// Forms that are refitted with a Jacobian of their own.
    pub finals: usize,
}

impl Budget {
    /// Every form of every effect.
    pub const WIDE: Budget = Budget { starts: [2, 2], entrants: 84, forms: 20, finals: 4 };
    /// Few forms, known to be promising.
    pub const NARROW: Budget = Budget { starts: [1, 1], entrants: 30, forms: 10, finals: 3 };
    /// To compare rivals of one effect.
    pub const RIVALS: Budget = Budget { starts: [1, 1], entrants: 18, forms: 6, finals: 2 };
}
