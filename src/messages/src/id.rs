//! Ids of messages, made of the names that code gives them.

/// A message with arguments, by its id; [`Catalog::format`](super::Catalog::format) puts them into its text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Message(pub &'static str);

/// The bytes of a name in kebab-case: small letters, and `-` for `_`.
pub const fn kebab<const N: usize>(name: &str) -> [u8; N] {
    let (from, mut bytes, mut k) = (name.as_bytes(), [0; N], 0);
    while k < N {
        bytes[k] = if from[k] == b'_' { b'-' } else { from[k].to_ascii_lowercase() };
        k += 1;
    }
    bytes
}

/// The id of a message, of a prefix and a name in code: `id!("diagnosis-", NOTHING_MISSING)` is `diagnosis-nothing-missing`.
#[macro_export]
macro_rules! id {
    ($prefix:expr, $name:ident) => {{
        const NAME: &str = concat!($prefix, stringify!($name));
        const BYTES: [u8; NAME.len()] = $crate::kebab(NAME);
        const ID: &str = match ::core::str::from_utf8(&BYTES) {
            Ok(id) => id,
            Err(_) => NAME,
        };
        ID
    }};
}

#[cfg(test)]
mod tests {
    #[test]
    fn an_id_is_the_name_in_kebab_case() {
        assert_eq!(id!("diagnosis-", NOTHING_MISSING), "diagnosis-nothing-missing");
        assert_eq!(id!("", col_t63_from_10), "col-t63-from-10");
    }
}
