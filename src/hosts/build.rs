//! Embeds the kernel's sources, which the command writes into an FMU's source folder. Also embeds the binaries that
//! `vi-crt-bridge/runtimes.sh` compiled from these sources.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
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
    runtimes(src.parent().expect("the project"));
}

/// Compiled files to embed, each with the name that FMI 2.0 gives to its platform.
const COMPILED: [(&str, &str); 5] = [
    ("linux64", "dashpot_damper.so"),
    ("linux64", "kernel.o"),
    ("linux64", "dashpot_adams.so"),
    ("win64", "dashpot_damper.dll"),
    ("win64", "dashpot_adams.dll"),
];

/// Embeds the compiled files of target/runtimes, or of the folder DASHPOT_RUNTIMES, if they were compiled from the current sources.
fn runtimes(project: &Path) {
    println!("cargo::rerun-if-env-changed=DASHPOT_RUNTIMES");
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("cargo runs build scripts"));
    let usual = target_folder(&out).unwrap_or_else(|| project.join("target")).join("runtimes");
    // While a watched path is absent, cargo reruns this script at every build, and then recompiles all dependents. An empty folder prevents
    // that.
    let _ = fs::create_dir_all(&usual);
    let folder = env::var_os("DASHPOT_RUNTIMES").map_or(usual, |path| project.join(path));
    println!("cargo::rerun-if-changed={}", folder.display());
    for part in ["include", "vi-crt-bridge/bridge", "vi-crt-bridge/fmu", "adams-usersub/src"] {
        println!("cargo::rerun-if-changed={}", project.join(part).display());
    }
    println!("cargo::rerun-if-env-changed=DASHPOT_COMPILE_RUNTIMES");
    let wanted = sources(project);
    let is_current = |folder: &Path| fs::read(folder.join("sources.txt")).is_ok_and(|text| text == wanted);
    // If maturin alone builds the Python package, nobody ran runtimes.sh before. DASHPOT_COMPILE_RUNTIMES makes this build run it, so that
    // the package can export FMUs.
    let compiles = env::var_os("DASHPOT_COMPILE_RUNTIMES").is_some() && env::var_os("DASHPOT_RUNTIMES").is_none();
    let folder = if compiles && !is_current(&folder) { compiled_here(project, &out).unwrap_or(folder) } else { folder };
    let (built, current) = (folder.join("sources.txt").is_file(), is_current(&folder));
    if built && !current {
        println!(
            "cargo::warning=the FMU libraries in {} are of earlier sources, so this command cannot export FMUs: run sh vi-crt-bridge/runtimes.sh for that",
            folder.display()
        );
    }
    let mut list = String::from("/// Platform, file and content.\npub const COMPILED: &[(&str, &str, &[u8])] = &[\n");
    for (platform, file) in COMPILED {
        let path = folder.join(platform).join(file);
        if current && path.is_file() {
            let _ = writeln!(list, "    ({platform:?}, {file:?}, include_bytes!({path:?})),");
        }
    }
    list.push_str("];\n");
    fs::write(out.join("runtimes.rs"), list).expect("a file");
}

/// Runs `vi-crt-bridge/runtimes.sh` with the output folder of this build. If the script fails, for example without a C compiler, warns and
/// returns `None`.
fn compiled_here(project: &Path, out: &Path) -> Option<PathBuf> {
    let to = out.join("compiled");
    let mut script = Command::new("sh");
    // The script uses a separate target folder, because cargo locks the target folder of this build. The script must not inherit the
    // environment variables that cargo sets for this build.
    for (name, _) in env::vars_os() {
        let name = name.to_string_lossy().into_owned();
        let prefixes = ["CARGO_PKG_", "CARGO_CFG_", "CARGO_FEATURE_", "CARGO_PROFILE_"];
        let names = ["CARGO_ENCODED_RUSTFLAGS", "CARGO_BUILD_TARGET", "RUSTFLAGS", "TARGET", "HOST"];
        if prefixes.iter().any(|p| name.starts_with(p)) || names.contains(&name.as_str()) {
            script.env_remove(name);
        }
    }
    script.arg("vi-crt-bridge/runtimes.sh").current_dir(project);
    script.env("CARGO_TARGET_DIR", out.join("kernel")).env("DASHPOT_RUNTIMES", &to);
    let reason = match script.output() {
        Ok(ran) if ran.status.success() => return Some(to),
        Ok(ran) => String::from_utf8_lossy(&ran.stderr).trim().replace('\n', "; "),
        Err(error) => error.to_string(),
    };
    println!(
        "cargo::warning=this build can export no FMU without a C compiler: vi-crt-bridge/runtimes.sh failed: {reason}"
    );
    None
}

/// Returns cargo's target folder, which contains cargo's tag file and the output of runtimes.sh.
///
/// With --target, a tagged folder named after the target triple lies between this folder and OUT_DIR.
fn target_folder(out: &Path) -> Option<PathBuf> {
    let nearest = out.ancestors().find(|folder| folder.join("CACHEDIR.TAG").is_file())?;
    let of_a_triple = nearest.file_name() == env::var_os("TARGET").as_deref();
    Some(if of_a_triple { nearest.parent()? } else { nearest }.to_owned())
}

/// Returns the sources of the compiled files as one text, in the order and format of `sources.txt` from runtimes.sh.
fn sources(project: &Path) -> Vec<u8> {
    let mut files = Vec::new();
    for part in ["core", "abi", "dll"] {
        files.push(project.join("src").join(part).join("Cargo.toml"));
        collect(&project.join("src").join(part).join("src"), &mut files);
    }
    for folder in ["vi-crt-bridge/fmu", "adams-usersub/src"] {
        let entries = fs::read_dir(project.join(folder)).expect("a folder of sources");
        let c = |path: &PathBuf| path.extension().is_some_and(|e| e == "c" || e == "h");
        files.extend(entries.map(|e| e.expect("an entry").path()).filter(c));
    }
    for file in ["include/dashpot.h", "vi-crt-bridge/bridge/corner.c", "vi-crt-bridge/bridge/corner.h"] {
        files.push(project.join(file));
    }
    let mut named: Vec<(String, PathBuf)> = files
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(project).expect("below the project").to_str().expect("a name in UTF-8");
            (name.replace('\\', "/"), path)
        })
        .collect();
    named.sort();
    let mut all = Vec::new();
    for (name, path) in named {
        all.extend(format!("== {name}\n").into_bytes());
        all.extend(fs::read(path).expect("a source"));
    }
    all
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
