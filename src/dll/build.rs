//! Links the shared library on Linux without the C runtime, which it does not need. The library then requires no version of glibc.
//! Names of internal functions are removed too.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() == Ok("linux") {
        println!("cargo::rustc-cdylib-link-arg=-nostdlib");
        // Internal names are a twentieth of the file, and no host can use them. The option goes directly to the linker. The compiler would
        // place a plain -s before cargo's option to keep the names, and that option would then override it.
        println!("cargo::rustc-cdylib-link-arg=-Wl,--strip-all");
    }
}
