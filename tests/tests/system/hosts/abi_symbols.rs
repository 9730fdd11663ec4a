//! Tests of the imported and exported symbols, size and data of the built shared library.

use std::process::Command;

use dashpot_tests::library::{shared, succeed};

fn symbols(flag: &str) -> Vec<String> {
    let listing = succeed(Command::new("nm").args(["-D", flag, "--format=posix"]).arg(shared()));
    listing.lines().filter_map(|line| Some(line.split_whitespace().next()?.to_string())).collect()
}

/// Checks that the library needs no allocator, panic handler, thread or file, only functions such as `memcpy` that
/// compilers call.
#[test]
fn imports_nothing() {
    for symbol in symbols("--undefined-only") {
        assert_ne!(
            symbol, "dashpot_panic_path_exists",
            "some path panics: an index or slice that the compiler cannot prove, a division, an unwrap"
        );
        assert_ne!(
            symbol, "rust_eh_personality",
            "a function of the precompiled core library is linked, such as from_utf8 or str::parse"
        );
        assert!(["memcpy", "memmove", "memset", "memcmp", "bcmp"].contains(&symbol.as_str()), "imports {symbol}");
    }
}

#[test]
fn needs_no_library() {
    let dynamic = succeed(Command::new("readelf").args(["--dynamic", "--wide"]).arg(shared()));
    assert!(dynamic.contains("Dynamic section"), "{dynamic}");
    for line in dynamic.lines() {
        assert!(!line.contains("NEEDED") && !line.contains("SONAME"), "{line}");
    }
}

#[test]
fn exports_what_the_header_declares_and_nothing_else() {
    let header = std::fs::read_to_string(dashpot_tests::header::path()).expect("include/dashpot.h");
    let mut declared: Vec<String> = header
        .lines()
        .filter(|line| {
            !line.starts_with(['/', ' ', '#']) && !line.starts_with("static") && !line.starts_with("typedef")
        })
        .filter_map(|line| Some(line.split_once('(')?.0.rsplit([' ', '*']).next()?.to_string()))
        .collect();
    let mut exported = symbols("--defined-only");
    declared.sort();
    exported.sort();
    assert!(declared.len() > 10);
    assert!(exported.iter().all(|name| name.starts_with("dashpot_")), "{exported:?}");
    assert_eq!(exported, declared);
}

/// Checks the size of the library. A larger size reveals an accidental second compilation of the step function, for example for an element
/// or number type.
///
/// The size is 964 KB with Rust 1.95, of which 450 KB are for the ordinary damper. An adjustable damper needs another 450 KB, because its
/// tables are borrowed and its step is therefore compiled separately. If all sets of elements shared one compiled stage of the integration
/// method, the size would be 837 KB. A step with an oil column would then take 10,500 instructions instead of 6,500.
#[test]
fn is_no_larger_than_it_was() {
    let size = std::fs::metadata(shared()).expect("the library").len();
    assert!(size < 1_060_000, "{size} bytes");
}

/// Checks that the library has no writable data that threads could share.
#[test]
fn has_no_writable_data() {
    let sections = succeed(Command::new("readelf").args(["--sections", "--wide"]).arg(shared()));
    for line in sections.lines() {
        let words: Vec<&str> = line.split(']').nth(1).unwrap_or("").split_whitespace().collect();
        if let [".bss" | ".data", _, _, _, size, ..] = words[..] {
            assert_eq!(u64::from_str_radix(size, 16), Ok(0), "{line}");
        }
    }
}
