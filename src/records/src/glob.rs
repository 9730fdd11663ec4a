//! Patterns for names of files and tests: `*` matches any text, `?` matches one character.

use wildmatch::WildMatch;

/// Returns whether a name matches a pattern. For every pattern, the computing time is at most proportional to the
/// product of both lengths.
pub fn matches(pattern: &str, name: &str) -> bool {
    WildMatch::new(pattern).matches(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns() {
        for (pattern, name, want) in [
            ("a40*", "a40mm_v0052", true),
            ("a40*", "a4mm", false),
            ("*52*", "a40mm_v0052mm_s", true),
            ("a?0*", "a50mm", true),
            ("slow", "slower", false),
            ("*", "", true),
            ("", "", true),
            ("?", "试", true),
            ("*.csv", "a.b.csv", true),
        ] {
            assert_eq!(matches(pattern, name), want, "{pattern} {name}");
        }
        assert!(!matches(&"*a".repeat(40), &"a".repeat(39)));
    }
}
