//! Sources of the kernel inside an FMU, from which a user can compile the kernel for another platform.

include!(concat!(env!("OUT_DIR"), "/kernel.rs"));

/// Returns the files of `sources/kernel`: the kernel's three crates as a separate workspace, with the same compiler settings.
pub fn files() -> Vec<(String, String)> {
    let mut files: Vec<(String, String)> = KERNEL
        .iter()
        .map(|(name, text)| {
            // The FMU does not contain the tests of the kernel, so the manifest omits the dependencies of the tests.
            let text = if name.ends_with("Cargo.toml") { without_dev_dependencies(text) } else { (*text).to_owned() };
            // The manifest omits the shared library, because the FMU links only the static library.
            let text = if *name == "dll/Cargo.toml" {
                text.replace("[\"cdylib\", \"staticlib\"]", "[\"staticlib\"]")
            } else {
                text
            };
            ((*name).to_owned(), text)
        })
        .collect();
    files.push(("Cargo.toml".to_owned(), workspace()));
    files
}

fn without_dev_dependencies(manifest: &str) -> String {
    manifest.split("\n[dev-dependencies]").next().unwrap_or_default().to_owned()
}

fn workspace() -> String {
    format!(
        "[workspace]\nresolver = \"3\"\nmembers = [\"core\", \"abi\", \"dll\"]\n\n\
         [workspace.package]\nversion = \"{}\"\nedition = \"2024\"\nrust-version = \"{}\"\nlicense = \"{}\"\npublish = false\n\n\
         [workspace.dependencies]\ndashpot-core = {{ path = \"core\" }}\ndashpot-abi = {{ path = \"abi\" }}\nlibm = \"={LIBM}\"\n\n\
         [workspace.lints.rust]\nunsafe_op_in_unsafe_fn = \"deny\"\n\n\
         [profile.release]\npanic = \"abort\"\ncodegen-units = 1\n\n\
         [profile.release.package.libm]\ncodegen-units = 1024\n",
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_RUST_VERSION"),
        env!("CARGO_PKG_LICENSE"),
    )
}
