//! Export of a model as a functional mock-up unit.

mod description;
mod kernel;
mod page;
mod sources;
mod variables;
mod zip;

pub use sources::Version;
pub use variables::Scales;

use anyhow::{Context as _, bail};
use dashpot_core::Params;
use dashpot_lab::model_file;
use std::path::Path;
use std::process::Command;

/// A binary of the FMU for another platform.
pub struct Binary {
    /// Folder below `binaries`, such as `win64`.
    pub platform: String,
    /// The library itself.
    pub content: Vec<u8>,
}

impl Binary {
    fn suffix(&self) -> &'static str {
        match self.platform.as_str() {
            p if p.starts_with("win") || p.ends_with("-windows") => ".dll",
            p if p.contains("darwin") => ".dylib",
            _ => ".so",
        }
    }
}

/// An FMU of one or four corners, as the bytes of its file. `library` is the static library for this computer.
///
/// # Errors
/// Where the compiler is missing or refuses.
pub fn fmu(
    corners: &[Params],
    version: Version,
    scales: Scales,
    library: &Path,
    more: &[Binary],
) -> anyhow::Result<Vec<u8>> {
    let variables = variables::variables(corners, scales);
    let texts: Vec<String> = corners.iter().map(|p| model_file::flat(p, |_| String::new())).collect();
    let guid = guid(&[
        &sources::model_data(&texts, &variables, scales, ""),
        &description::description(version, &variables, ""),
        env!("CARGO_PKG_VERSION"),
    ]);
    let mut files: Vec<(String, Vec<u8>)> =
        sources::bundled(version).into_iter().map(|(name, text)| (name.to_owned(), text.into())).collect();
    files.push(("model_data.h".into(), sources::model_data(&texts, &variables, scales, &guid).into()));
    files.push(("model_data.c".into(), sources::MODEL_DATA_C.into()));
    let binary = compile(&files, library)?;

    let mut archive = zip::Zip::default();
    archive.add("modelDescription.xml", description::description(version, &variables, &guid).as_bytes());
    archive.add(if version == Version::Two { "model.png" } else { "terminalsAndIcons/icon.png" }, sources::ICON);
    archive.add("documentation/index.html", page::page(&variables).as_bytes());
    archive.add(
        &format!("binaries/{}/{}{}", platform(version), description::IDENTIFIER, std::env::consts::DLL_SUFFIX),
        &binary,
    );
    for other in more {
        if !other.content.windows(guid.len()).any(|part| part == guid.as_bytes()) {
            bail!(
                "the binary for {} was not compiled from the sources of this FMU: export it without, compile its sources for \
                 that platform (sources/build.sh), and export it again with the result",
                other.platform
            );
        }
        archive
            .add(&format!("binaries/{}/{}{}", other.platform, description::IDENTIFIER, other.suffix()), &other.content);
    }
    for (name, content) in &files {
        archive.add(&format!("sources/{name}"), content);
    }
    archive.add("sources/README.txt", sources::README.as_bytes());
    archive.add("sources/build.sh", sources::BUILD.as_bytes());
    archive.add("sources/lib/libdashpot.a", &needed_of(library)?);
    for (name, text) in [
        ("platform", platform(version)),
        ("system", system()),
        ("fmi", if version == Version::Two { "2" } else { "3" }.to_owned()),
    ] {
        archive.add(&format!("sources/lib/{name}"), format!("{text}\n").as_bytes());
    }
    for (name, text) in kernel::files() {
        archive.add(&format!("sources/kernel/{name}"), text.as_bytes());
    }
    for (i, text) in texts.iter().enumerate() {
        archive.add(&format!("resources/model{}.toml", i + 1), text.as_bytes());
    }
    Ok(archive.finish())
}

/// The folder of binaries for this computer.
fn platform(version: Version) -> String {
    use std::env::consts::{ARCH, OS};
    match (version, OS) {
        (Version::Two, "windows") => "win64".into(),
        (Version::Two, "macos") => "darwin64".into(),
        (Version::Two, _) => "linux64".into(),
        (Version::Three, "macos") => format!("{ARCH}-darwin"),
        (Version::Three, _) => format!("{ARCH}-{OS}"),
    }
}

/// What `uname -s` and `uname -m` say on this computer.
fn system() -> String {
    use std::env::consts::{ARCH, OS};
    let name = match OS {
        "linux" => "Linux",
        "macos" => "Darwin",
        other => other,
    };
    let machine = if OS == "macos" && ARCH == "aarch64" { "arm64" } else { ARCH };
    format!("{name}-{machine}")
}

fn compile(files: &[(String, Vec<u8>)], library: &Path) -> anyhow::Result<Vec<u8>> {
    let folder = tempfile::tempdir()?;
    for (name, content) in files {
        std::fs::write(folder.path().join(name), content)?;
    }
    let compiler = std::env::var_os("CC").unwrap_or("cc".into());
    let output = folder.path().join("fmu.bin");
    let library = std::path::absolute(library)?;
    let mut command = Command::new(&compiler);
    command.current_dir(folder.path()).args(["-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-I."]);
    command.args(files.iter().map(|(name, _)| name).filter(|name| name.ends_with(".c")));
    command.arg(library).args(["-Wl,--exclude-libs,ALL", "-s", "-lm", "-o"]).arg(&output);
    let ran = command.output().with_context(|| {
        format!(
            "an FMU is compiled when it is exported, and {} cannot be run; install gcc or set CC",
            compiler.to_string_lossy()
        )
    })?;
    if !ran.status.success() {
        bail!("the compiler refuses the FMU: {}", String::from_utf8_lossy(&ran.stderr).trim());
    }
    Ok(std::fs::read(output)?)
}

/// The library without the parts that nobody calls and without debugging: a tenth of it. All of it where the tools for that are
/// missing.
fn needed_of(library: &Path) -> anyhow::Result<Vec<u8>> {
    let folder = tempfile::tempdir()?;
    let at = |name: &str| folder.path().join(name);
    let compiler = std::env::var_os("CC").unwrap_or("cc".into());
    let mut link = Command::new(&compiler);
    // One function pulls the whole interface in: it is one object.
    link.args(["-r", "-nostdlib", "-Wl,--strip-debug", "-Wl,-u,dashpot_step", "-o"]).arg(at("kernel.o"));
    link.arg(std::path::absolute(library)?);
    let mut pack = Command::new("ar");
    pack.arg("crsD").arg(at("small.a")).arg(at("kernel.o"));
    let runs = |command: &mut Command| command.output().is_ok_and(|ran| ran.status.success());
    let small = runs(&mut link) && runs(&mut pack);
    let from = if small { at("small.a") } else { library.to_path_buf() };
    std::fs::read(&from).with_context(|| from.display().to_string())
}

/// A GUID that follows from what the FMU is: two FNV-1a sums of its texts.
fn guid(texts: &[&str]) -> String {
    let sum = |seed: u64| {
        texts.iter().flat_map(|t| t.bytes()).fold(seed, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3))
    };
    let (a, b) = (sum(0xcbf2_9ce4_8422_2325), sum(0x6c62_272e_07bb_0142));
    format!(
        "{{{:08x}-{:04x}-{:04x}-{:04x}-{:012x}}}",
        a >> 32,
        a >> 16 & 0xffff,
        a & 0xffff,
        b >> 48,
        b & 0xffff_ffff_ffff
    )
}
