//! Access by name to an element's own rows, and the element's view of a parameter set.

use core::marker::PhantomData;

use crate::fault::{Fault, Reason};
use crate::schema::kind::{Kind, Many, OTHER_KIND, One, same};
use crate::schema::{Describe, Parameter};

/// A parameter of the element `E`, looked up at compile time.
///
/// The name of another element's parameter is a compile error, and so is a list instead of a number.
///
/// ```
/// # use dashpot_core::schema::{Describe, Own, Parameter, kind::One};
/// struct Rope;
///
/// impl Describe for Rope {
///     const MEANING: &'static str = "a rope";
///     const PARAMETERS: &'static [Parameter] =
///         &[Parameter::scalar("rope_length", "m", &[1.0], (0.1, 10.0), "length at which it is taut")];
/// }
///
/// const LENGTH: Own<Rope, One> = Own::named("rope_length");
/// ```
///
/// ```compile_fail,E0080
/// # use dashpot_core::schema::{Describe, Own, Parameter, kind::One};
/// # struct Rope;
/// # impl Describe for Rope {
/// #     const MEANING: &'static str = "a rope";
/// #     const PARAMETERS: &'static [Parameter] =
/// #         &[Parameter::scalar("rope_length", "m", &[1.0], (0.1, 10.0), "length at which it is taut")];
/// # }
/// const STIFFNESS: Own<Rope, One> = Own::named("series_stiffness");
/// ```
///
/// ```compile_fail,E0080
/// # use dashpot_core::schema::{Describe, Own, Parameter, kind::Many};
/// # struct Rope;
/// # impl Describe for Rope {
/// #     const MEANING: &'static str = "a rope";
/// #     const PARAMETERS: &'static [Parameter] =
/// #         &[Parameter::scalar("rope_length", "m", &[1.0], (0.1, 10.0), "length at which it is taut")];
/// # }
/// const LENGTH: Own<Rope, Many> = Own::named("rope_length");
/// ```
pub struct Own<E, K> {
    /// Index of the parameter among the rows of the element.
    local: usize,
    /// Index of the parameter's first value among the values of the element.
    slot: usize,
    parameter: &'static Parameter,
    kind: PhantomData<fn() -> (E, K)>,
}

impl<E, K> Clone for Own<E, K> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<E, K> Copy for Own<E, K> {}

impl<E: Describe, K: Kind> Own<E, K> {
    /// Finds the element's row called `name`. In a constant, a name without a row is a compile error.
    pub const fn named(name: &str) -> Own<E, K> {
        let (mut local, mut slot) = (0, 0);
        while local < E::PARAMETERS.len() {
            let parameter = &E::PARAMETERS[local];
            if same(parameter.name, name) {
                assert!(K::IS_LIST == parameter.holds_list(), "{}", OTHER_KIND);
                return Own { local, slot, parameter, kind: PhantomData };
            }
            (local, slot) = (local + 1, slot + parameter.slots());
        }
        panic!("this element has no parameter of this name")
    }
}

/// Finds a row of the element by name, for its [`View`].
macro_rules! own {
    ($name:literal) => {
        const { $crate::schema::Own::named($name) }
    };
}
pub(crate) use own;

/// Rows of the element `E` in a parameter set, from which the element is prepared.
pub struct View<'a, E> {
    /// Index of the element's first row in the parameter table, for error reports ([`Fault`]).
    first: usize,
    /// Number of values of each row of the element, in the order of the rows.
    lengths: &'a [u32],
    /// Values of the element's rows, one row after the other. The slot of a row is the index of its first value.
    values: &'a [f64],
    owner: PhantomData<fn() -> E>,
}

impl<'a, E: Describe> View<'a, E> {
    /// Makes a view of the rows of `E`, the first of which has the index `first` in the parameter table.
    pub(crate) fn new(first: usize, lengths: &'a [u32], values: &'a [f64]) -> View<'a, E> {
        View { first, lengths, values, owner: PhantomData }
    }

    /// Returns the number in the row `own` of the element.
    pub fn number(&self, own: Own<E, One>) -> f64 {
        self.values.get(own.slot).copied().unwrap_or(0.0)
    }

    /// Returns the list in the row `own` of the element.
    pub fn list(&self, own: Own<E, Many>) -> &'a [f64] {
        let length = self.lengths.get(own.local).map_or(0, |l| *l as usize);
        let tail = self.values.get(own.slot..).unwrap_or(&[]);
        tail.get(..length.min(own.parameter.slots())).unwrap_or(&[])
    }

    /// Makes a fault with this reason that names a row of the element.
    pub fn fault<K>(&self, own: Own<E, K>, reason: Reason) -> Fault {
        Fault { parameter: (self.first + own.local) as u16, reason }
    }

    /// Makes a fault with this reason that names the element by its first row.
    pub fn fault_of_all(&self, reason: Reason) -> Fault {
        Fault { parameter: self.first as u16, reason }
    }
}
