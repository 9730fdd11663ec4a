//! Texts of an interface (the reports, the window) as fields of a structure, so that a wrong name of a text does not
//! compile.

/// Defines a structure with every text of an interface, and the constant `MESSAGES` with the ids and arguments of the
/// texts.
///
/// Ordinary fields come first, then a semicolon and the texts. `name` is a text without arguments, a `&'static str`.
/// `name(a b)` is a text with arguments, a [`Message`](crate::Message) to format. The id of a text is the name of the
/// field in kebab-case.
#[macro_export]
macro_rules! interface {
    (
        $(#[$of_all:meta])* $public:vis struct $Interface:ident {
            $($(#[$of_own:meta])* $of_whom:vis $own:ident: $Own:ty,)* ;
            $($(#[$of_text:meta])* $name:ident $(($($argument:ident)*))?,)*
        }
    ) => {
        $(#[$of_all])*
        $public struct $Interface {
            $($(#[$of_own])* $of_whom $own: $Own,)*
            $($(#[$of_text])* pub $name: $crate::interface!(@type $(($($argument)*))?),)*
        }

        impl $Interface {
            /// Ids of all texts, with the arguments that the code gives.
            pub const MESSAGES: &[(&'static str, &'static [&'static str])] =
                &[$(($crate::id!("", $name), &[$($(stringify!($argument)),*)?])),*];

            /// Returns the texts of a language. If the language lacks a text, its id is used instead.
            pub(crate) fn read(catalog: &'static $crate::Catalog, $($own: $Own),*) -> Self {
                Self {
                    $($own,)*
                    $($name: $crate::interface!(@value catalog, $crate::id!("", $name) $(, ($($argument)*))?),)*
                }
            }
        }
    };
    (@type) => { &'static str };
    (@type ($($argument:ident)*)) => { $crate::Message };
    (@value $catalog:ident, $id:expr) => { $catalog.text($id).unwrap_or($id) };
    (@value $catalog:ident, $id:expr, ($($argument:ident)*)) => { $crate::Message($id) };
}
