//! The texts of an interface (the reports, the window) as fields of a structure. Code names them so, and a wrong name does not compile.

/// A structure with every text of an interface, and `MESSAGES` with their ids and arguments.
///
/// First come fields of its own, then behind a semicolon the texts. `name` is one without arguments, a `&'static str`; `name(a b)` is one
/// with arguments, a [`Message`](crate::Message) to format. The id of a text is the field's name in kebab-case.
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

            /// The texts of a language; where it lacks one, its id stands instead.
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
