//! Ids of messages, made from the names of constants and fields in code.

/// Id of a message with arguments. [`Catalog::format`](super::Catalog::format) inserts the arguments into the text of
/// the message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Message(pub &'static str);

/// Returns the bytes of a name in kebab-case: lowercase letters, and `-` for `_`. `N` is the length of the name.
pub const fn kebab<const N: usize>(name: &str) -> [u8; N] {
    let (from, mut bytes, mut k) = (name.as_bytes(), [0; N], 0);
    while k < N {
        bytes[k] = if from[k] == b'_' { b'-' } else { from[k].to_ascii_lowercase() };
        k += 1;
    }
    bytes
}

/// Makes the id of a message from a prefix and a name in code: `id!("diagnosis-", NOTHING_MISSING)` is
/// `diagnosis-nothing-missing`.
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
