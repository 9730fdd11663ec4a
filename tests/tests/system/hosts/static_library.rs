//! Tests of the static library in other programs: one object with unique names, in every link order, with every
//! available compiler.

use dashpot_test_support::{skipped, target_folder};
use dashpot_tests::library::{directory, pack, root, static_library, succeed};
use std::path::{Path, PathBuf};
use std::process::Command;

/// C program that calls functions of compilers and C libraries that Rust's compiler library also defines.
const PROGRAM: &str = r#"
#include "dashpot.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char **argv)
{
    static dashpot_params params = DASHPOT_PARAMS_INIT;
    static dashpot_model model;
    dashpot_state state;
    volatile double x = argc + 0.3;
    volatile float y = argc + 0.3f;
    double force = 0.0, sum;

    (void)argv;
    dashpot_params_default(&params);
    dashpot_model_init(&model, &params);
    dashpot_state_init(&model, 0.0, &state);
    if (dashpot_force(&model, &state, 0.1, 1e-3, &force) < 0)
        return 1;
    sum = fmod(x, 0.7) + fma(x, x, x) + cbrt(x) + sqrt(x) + ceil(x) + floor(x) + trunc(x) + rint(x) + fmin(x, 2.0) + fmax(x, 2.0) +
          fdim(x, 0.1) + copysign(x, -1.0) + exp(x) + log(x) + pow(x, x) + tgamma(x) + tanh(x) + fmodf(y, 0.7f) + fmaf(y, y, y) +
          cbrtf(y) + roundf(y) + ldexp(x, 2);
    if (!(sum > 0.0))
        return 2;
    printf("%.17g\n", force);
    return 0;
}
"#;

/// C program that defines names that the library must not define: names of a C library, and names that Rust programs
/// define.
const NAMESAKES: &str = r#"
#include "dashpot.h"
#include <stdio.h>

double fmod(double a, double b) { return a + b; }
double cbrt(double a) { return a; }
double exp(double a) { return a; }
int rust_eh_personality(void) { return 7; }
int rust_begin_unwind(void) { return 8; }

int main(void)
{
    static dashpot_params params = DASHPOT_PARAMS_INIT;
    static dashpot_model model;
    dashpot_state state;
    double force = 0.0;

    dashpot_params_default(&params);
    dashpot_model_init(&model, &params);
    dashpot_state_init(&model, 0.0, &state);
    if (dashpot_force(&model, &state, 0.1, 1e-3, &force) < 0 || rust_eh_personality() != 7 || rust_begin_unwind() != 8)
        return 1;
    printf("%.17g\n", force);
    return 0;
}
"#;

fn kernel() -> f64 {
    let model = dashpot_core::Model::new(&dashpot_core::Params::new()).expect("a model");
    let state = model.steady_state(&dashpot_core::Input::motion(0.0, 0.0));
    dashpot_core::step(&model, &state, &dashpot_core::Input::velocity(0.1), 1e-3).1.force
}

fn is_here(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|out| out.status.success())
}

/// Writes the sources [`PROGRAM`], in C and in C++, and [`NAMESAKES`] to a folder.
fn sources() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a directory");
    for (name, text) in [("program.c", PROGRAM), ("program.cc", PROGRAM), ("namesakes.c", NAMESAKES)] {
        std::fs::write(folder.path().join(name), text).expect("a source");
    }
    folder
}

/// Compiles and runs a program, and compares its force with the kernel's bit for bit. `LIBRARY` in `words` stands for
/// the path of the library.
fn links(at: &Path, compiler: &str, words: &[&str]) {
    let program = at.join("program");
    let library = static_library();
    let mut compile = Command::new(compiler);
    compile.current_dir(at).arg("-I").arg(root().join("include")).arg("-o").arg(&program);
    compile.args(words.iter().map(|word| if *word == "LIBRARY" { library.as_os_str() } else { word.as_ref() }));
    succeed(&mut compile);
    let force: f64 = succeed(&mut Command::new(&program)).trim().parse().expect("a force");
    assert_eq!(force.to_bits(), kernel().to_bits(), "{compiler} {words:?}");
}

#[test]
fn it_is_one_object_and_its_names_are_its_own() {
    let library = static_library();
    let members = succeed(Command::new("ar").arg("t").arg(&library));
    assert_eq!(members.trim(), "dashpot.o");
    let listing = |flags: &[&str], file: &Path| -> Vec<String> {
        let text = succeed(Command::new("nm").args(["--format=posix"]).args(flags).arg(file));
        let mut names: Vec<String> = text
            .lines()
            .filter_map(|line| {
                let mut words = line.split(' ');
                let (name, kind) = (words.next()?, words.next()?);
                (kind.len() == 1).then(|| name.to_owned())
            })
            .collect();
        names.sort();
        names
    };
    let shared = listing(&["-D", "--defined-only"], &directory().join("libdashpot.so"));
    assert_eq!(listing(&["--extern-only", "--defined-only"], &library), shared);
    let wanted = listing(&["--undefined-only"], &library);
    for name in &wanted {
        assert!(["memcpy", "memmove", "memset", "memcmp", "bcmp"].contains(&name.as_str()), "asks for {name}");
    }
    // Packing is deterministic: a second run gives the same bytes.
    let again = tempfile::tempdir().expect("a directory");
    let to = again.path().join("again.a");
    pack(&directory().join("libdashpot.a"), &to, "");
    assert!(std::fs::read(to).expect("a library") == std::fs::read(library).expect("a library"));
}

#[test]
fn it_links_beside_c_and_cxx_in_any_order() {
    let folder = sources();
    let at = folder.path();
    for words in [
        &["program.c", "LIBRARY", "-lm"][..],
        &["program.c", "-lm", "LIBRARY"],
        &["LIBRARY", "program.c", "LIBRARY", "-lm"],
        &["-static", "program.c", "LIBRARY", "-lm"],
        &["-O2", "-flto", "program.c", "LIBRARY", "-lm"],
        &["-Wl,--gc-sections", "program.c", "LIBRARY", "-lm"],
        &["-Wl,--whole-archive", "LIBRARY", "-Wl,--no-whole-archive", "program.c", "-lm"],
        &["-fno-builtin", "namesakes.c", "LIBRARY"],
        &["-fno-builtin", "LIBRARY", "namesakes.c", "LIBRARY"],
    ] {
        links(at, "gcc", words);
    }
    for words in
        [&["program.cc", "LIBRARY"][..], &["LIBRARY", "program.cc", "LIBRARY"], &["program.cc", "-lm", "LIBRARY"]]
    {
        links(at, "g++", words);
    }
}

#[test]
fn it_links_with_clang_and_lld() {
    if !is_here("clang") {
        skipped("no clang");
        return;
    }
    let folder = sources();
    links(folder.path(), "clang", &["program.c", "LIBRARY", "-lm"]);
    links(folder.path(), "clang", &["program.c", "-lm", "LIBRARY"]);
    links(folder.path(), "clang", &["-fno-builtin", "namesakes.c", "LIBRARY"]);
    links(folder.path(), "clang++", &["program.cc", "LIBRARY"]);
    if !is_here("ld.lld") {
        skipped("no lld");
        return;
    }
    links(folder.path(), "clang", &["-fuse-ld=lld", "program.c", "LIBRARY", "-lm"]);
}

#[test]
fn it_links_with_musl() {
    if !is_here("musl-gcc") {
        skipped("no musl-gcc (Debian: musl-tools)");
        return;
    }
    let folder = sources();
    links(folder.path(), "musl-gcc", &["program.c", "LIBRARY"]);
    links(folder.path(), "musl-gcc", &["-static", "program.c", "LIBRARY"]);
    links(folder.path(), "musl-gcc", &["-fno-builtin", "namesakes.c", "LIBRARY"]);
}

/// Makes a folder with library, header and build files in the layout of the installed package.
fn prefix() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a directory");
    let at = folder.path();
    let put = |from: &Path, to: &str| {
        let to = at.join(to);
        std::fs::create_dir_all(to.parent().expect("a folder")).expect("a folder");
        std::fs::copy(from, to).expect("a copy");
    };
    put(&directory().join("libdashpot.so"), "lib/libdashpot.so");
    put(&static_library(), "lib/libdashpot.a");
    put(&root().join("include/dashpot.h"), "include/dashpot.h");
    for (from, to) in [
        ("dist/linux/dashpot.pc", "lib/pkgconfig/dashpot.pc"),
        ("dist/cmake/dashpotConfig.cmake", "lib/cmake/dashpot/dashpotConfig.cmake"),
        ("dist/cmake/dashpotConfigVersion.cmake", "lib/cmake/dashpot/dashpotConfigVersion.cmake"),
    ] {
        let text = std::fs::read_to_string(root().join(from)).expect("a file");
        put(&root().join(from), to);
        std::fs::write(at.join(to), text.replace("@VERSION@", env!("CARGO_PKG_VERSION"))).expect("a file");
    }
    folder
}

#[test]
fn cmake_links_it_into_c_and_cxx() {
    if !is_here("cmake") {
        skipped("no cmake");
        return;
    }
    let (folder, prefix) = (sources(), prefix());
    let at = folder.path();
    std::fs::write(
        at.join("CMakeLists.txt"),
        "cmake_minimum_required(VERSION 3.10)\nproject(host C CXX)\nfind_package(dashpot REQUIRED)\n\
         add_executable(in_c program.c)\ntarget_link_libraries(in_c dashpot::static m)\n\
         add_executable(in_cxx program.cc)\ntarget_link_libraries(in_cxx dashpot::static)\n\
         add_executable(m_first program.c)\ntarget_link_libraries(m_first m dashpot::static)\n",
    )
    .expect("a file");
    let path = format!("-DCMAKE_PREFIX_PATH={}", prefix.path().display());
    succeed(Command::new("cmake").args(["-S", ".", "-B", "build", &path]).current_dir(at));
    succeed(Command::new("cmake").args(["--build", "build"]).current_dir(at));
    for program in ["in_c", "in_cxx", "m_first"] {
        let force: f64 = succeed(&mut Command::new(at.join("build").join(program))).trim().parse().expect("a force");
        assert_eq!(force.to_bits(), kernel().to_bits(), "{program}");
    }
}

#[test]
fn pkg_config_names_it() {
    if !is_here("pkg-config") {
        skipped("no pkg-config");
        return;
    }
    let (folder, prefix) = (sources(), prefix());
    let mut ask = Command::new("pkg-config");
    ask.args(["--cflags", "--libs", "dashpot"]).env("PKG_CONFIG_PATH", prefix.path().join("lib/pkgconfig"));
    let said = succeed(&mut ask);
    let flags: Vec<&str> = said.split_whitespace().collect();
    links(
        folder.path(),
        "gcc",
        &[&["program.c", "-Wl,-Bstatic"], flags.as_slice(), &["-Wl,-Bdynamic", "-lm"]].concat(),
    );
    links(folder.path(), "g++", &[&["program.cc", "-Wl,-Bstatic"], flags.as_slice(), &["-Wl,-Bdynamic"]].concat());
}

/// Builds cargo's archive for 64-bit Windows, with rustup's target or else with Debian's Rust compiler. Returns `None`
/// if neither is available.
fn windows_archive() -> Option<PathBuf> {
    const TARGET: &str = "x86_64-pc-windows-gnu";
    let folder = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output().ok()?;
    let rustup = Path::new(String::from_utf8_lossy(&folder.stdout).trim()).is_dir();
    let debian = Path::new("/usr/lib/rustlib/src/rust/library/core").is_dir() && Path::new("/usr/bin/cargo").is_file();
    let words = ["build", "--release", "--quiet", "-p", "dashpot-dll", "--target", TARGET];
    let mut build = if rustup {
        Command::new(env!("CARGO"))
    } else if debian {
        let mut cargo = Command::new("/usr/bin/cargo");
        cargo
            .env_remove("RUSTUP_TOOLCHAIN")
            .env_remove("CARGO")
            .env("RUSTC", "/usr/bin/rustc")
            .env("RUSTC_BOOTSTRAP", "1");
        cargo.env("CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER", "x86_64-w64-mingw32-gcc").arg("-Zbuild-std=core");
        cargo
    } else {
        return None;
    };
    // Each compiler has its own folder, because neither accepts the other's output.
    let target = if rustup { target_folder() } else { target_folder().join("second-compiler") };
    succeed(build.args(words).env("CARGO_TARGET_DIR", &target).current_dir(root()));
    Some(target.join(TARGET).join("release/libdashpot.a"))
}

#[test]
fn it_links_with_mingw() {
    if !is_here("x86_64-w64-mingw32-gcc") {
        skipped("no x86_64-w64-mingw32-gcc (Debian: gcc-mingw-w64-x86-64-win32)");
        return;
    }
    let Some(archive) = windows_archive() else {
        skipped(
            "no Rust for Windows (rustup target add x86_64-pc-windows-gnu, or Debian's rustc-web, cargo-web and rust-web-src)",
        );
        return;
    };
    let folder = sources();
    let at = folder.path();
    let library = at.join("libdashpot.a");
    pack(&archive, &library, "x86_64-w64-mingw32-");
    for words in [
        &["program.c", "libdashpot.a", "-lm"][..],
        &["program.c", "-lm", "libdashpot.a"],
        &["-fno-builtin", "namesakes.c", "libdashpot.a"],
    ] {
        let mut compile = Command::new("x86_64-w64-mingw32-gcc");
        compile.current_dir(at).arg("-I").arg(root().join("include")).args(["-o", "program.exe"]);
        succeed(compile.args(words));
    }
}
