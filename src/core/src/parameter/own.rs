//! An element's own rows by their names, and what it sees of a parameter set.

use core::marker::PhantomData;

use crate::elements::{Describe, GROUPS};
use crate::fault::{Fault, Reason};
use crate::parameter::id::{Kind, Many, OTHER_KIND, One, same};
use crate::parameter::{Parameter, Params, Row};

/// A row that the element `E` brings, looked up among its rows when the code is compiled: a row of another element, or a list
/// where a number is meant, does not compile.
///
/// ```
/// # use dashpot_core::elements::Describe;
/// # use dashpot_core::parameter::{Own, Parameter, id::One};
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
/// # use dashpot_core::elements::Describe;
/// # use dashpot_core::parameter::{Own, Parameter, id::One};
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
/// # use dashpot_core::elements::Describe;
/// # use dashpot_core::parameter::{Own, Parameter, id::Many};
/// # struct Rope;
/// # impl Describe for Rope {
/// #     const MEANING: &'static str = "a rope";
/// #     const PARAMETERS: &'static [Parameter] =
/// #         &[Parameter::scalar("rope_length", "m", &[1.0], (0.1, 10.0), "length at which it is taut")];
/// # }
/// const LENGTH: Own<Rope, Many> = Own::named("rope_length");
/// ```
pub struct Own<E, K> {
    /// Place among the rows of the element.
    local: usize,
    /// Place of its first value among theirs.
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
    /// The row called `name`. For constants: where the element has no such row, there is no program.
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

/// The row of that name of the element whose [`View`] is asked.
macro_rules! own {
    ($name:literal) => {
        const { $crate::parameter::Own::named($name) }
    };
}
pub(crate) use own;

/// What an element sees of a parameter set when it prepares itself: its own rows.
pub struct View<'a, E> {
    params: &'a Params,
    group: usize,
    /// Places of its first row and of that row's first value.
    first: (usize, usize),
    owner: PhantomData<fn() -> E>,
}

impl<'a, E: Describe> View<'a, E> {
    /// The rows of group `group`, which are those of `E`.
    pub fn new(params: &'a Params, group: usize) -> View<'a, E> {
        let before = GROUPS.iter().take(group).flat_map(|group| group.parameters);
        let first = before.fold((0, 0), |(index, slot), row| (index + 1, slot + row.slots()));
        View { params, group, first, owner: PhantomData }
    }

    fn row<K>(&self, own: Own<E, K>) -> Row {
        let (index, slot) = self.first;
        Row { index: index + own.local, group: self.group, slot: slot + own.slot, parameter: own.parameter }
    }

    /// The number in a row of the element.
    pub fn number(&self, own: Own<E, One>) -> f64 {
        self.params.get(&self.row(own)).first().copied().unwrap_or(0.0)
    }

    /// The list in a row of the element.
    pub fn list(&self, own: Own<E, Many>) -> &'a [f64] {
        self.params.get(&self.row(own))
    }

    /// A fault that names a row of the element.
    pub fn fault<K>(&self, own: Own<E, K>, reason: Reason) -> Fault {
        self.row(own).fault(reason)
    }

    /// A fault that names the element by its first row.
    pub fn fault_of_all(&self, reason: Reason) -> Fault {
        Fault { parameter: self.first.0 as u16, reason }
    }
}
