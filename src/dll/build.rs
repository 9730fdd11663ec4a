//! Links the shared library on Linux without the C runtime: it needs none, and so asks for no glibc version.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo::rustc-cdylib-link-arg=-nostdlib");
    }
}
