//! Lists the kernel's own sources for the command, which writes them into an FMU's source folder.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let manifest = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("cargo runs build scripts"));
    let src = manifest.parent().expect("the folder of all crates");
    let mut files = Vec::new();
    for part in ["core", "abi", "dll"] {
        files.push(src.join(part).join("Cargo.toml"));
        collect(&src.join(part).join("src"), &mut files);
        println!("cargo::rerun-if-changed={}", src.join(part).display());
    }
    files.sort();
    let lock = src.parent().expect("the project").join("Cargo.lock");
    println!("cargo::rerun-if-changed={}", lock.display());
    let mut out =
        String::from("/// Path below the kernel's folder, and text.\npub const KERNEL: &[(&str, &str)] = &[\n");
    for file in &files {
        let name =
            file.strip_prefix(src).expect("below the folder").to_str().expect("a name in UTF-8").replace('\\', "/");
        let _ = writeln!(out, "    ({name:?}, include_str!({:?})),", file.to_str().expect("a path in UTF-8"));
    }
    let _ =
        writeln!(out, "];\n\n/// The version of libm that this kernel is built with: another may give other digits.");
    let _ = writeln!(out, "pub const LIBM: &str = {:?};", libm(&fs::read_to_string(lock).expect("Cargo.lock")));
    let to = PathBuf::from(env::var_os("OUT_DIR").expect("cargo runs build scripts")).join("kernel.rs");
    fs::write(to, out).expect("a file");
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
}

fn libm(lock: &str) -> String {
    let after = lock.split("name = \"libm\"").nth(1).expect("libm in Cargo.lock");
    after.split('"').nth(1).expect("its version").to_owned()
}
