//! Links the shared library on Linux without the C runtime: it needs none, and so asks for no glibc version. Without the names of
//! its inner functions too.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo::rustc-cdylib-link-arg=-nostdlib");
        // Names of what is not exported: a twentieth of the file, and nothing that a host can use. Said to the linker itself, since a plain -s
        // comes before what cargo says, to keep them.
        println!("cargo::rustc-cdylib-link-arg=-Wl,--strip-all");
    }
}
