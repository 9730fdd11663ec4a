//! Tests that `include/dashpot.h` matches the sources of the C interface, and that a C and a C++ compiler accept this
//! header without a warning.

use std::fs;

use dashpot_tests::header;
use dashpot_tests::library::{Language, compiler, succeed};

#[test]
fn is_up_to_date() {
    let (path, text) = (header::path(), header::text());
    if std::env::var_os("UPDATE_HEADER").is_some() {
        fs::write(&path, &text).expect("include/dashpot.h");
    }
    let kept = fs::read_to_string(&path).expect("include/dashpot.h");
    if let Some((line, (kept, text))) = kept.lines().zip(text.lines()).enumerate().find(|(_, (a, b))| a != b) {
        panic!(
            "include/dashpot.h, line {}: has\n{kept}\nbut the sources say\n{text}\nWrite it anew: UPDATE_HEADER=1 cargo test --profile tests -p dashpot-tests --test source abi_header",
            line + 1
        );
    }
    assert_eq!(
        kept.len(),
        text.len(),
        "include/dashpot.h ends too early or too late; write it anew with UPDATE_HEADER=1"
    );
}

#[test]
fn compiles_as_c99_and_cxx11_without_a_warning() {
    let directory = tempfile::tempdir().expect("a directory");
    for (language, name) in [(Language::C, "header.c"), (Language::Cxx, "header.cc")] {
        let source = directory.path().join(name);
        // The double inclusion tests the include guard. The program uses an initializer and a function of the header,
        // so that compiler warnings about them appear.
        fs::write(
            &source,
            "#include \"dashpot.h\"\n#include \"dashpot.h\"\n\
             dashpot_params params = DASHPOT_PARAMS_INIT;\n\
             double use(void);\n\
             double use(void) { return dashpot_input_motion(1.0, 2.0).displacement; }\n",
        )
        .expect("a source file");
        succeed(compiler(language).args(["-Wshadow", "-Wconversion", "-fsyntax-only"]).arg(&source));
    }
}
