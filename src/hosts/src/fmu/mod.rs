//! Export of a model as a functional mock-up unit (FMU).

mod archive;
mod carmaker;
mod description;
mod kernel;
mod page;
mod scales;
mod sources;
mod units;
mod variables;
mod veil;

pub use carmaker::{not_in_the_equilibrium, plug_info};
pub use scales::Scales;
pub use sources::Version;
pub use variables::Inputs;

use self::archive::Archive;
use crate::runtimes;
use anyhow::{Context as _, bail};
use dashpot_core::family::Definition;
use dashpot_identification::model_file;
use std::path::Path;
use std::process::Command;

/// Note for an export without the option `--inputs`, so that the FMU does not know for which instant of a step its inputs are set.
pub const INPUTS_HAVE_ZERO_ORDER_HOLD: &str = "note: in co-simulation, inputs set before a step count at its end. An importer that sets what it knows at the \
     beginning, as FMPy and most masters do, gets the force one step late: export with --inputs begin, and the FMU extrapolates. With --inputs end \
     nothing changes but this note";

/// Binary of the FMU for a further platform.
pub struct Binary {
    /// Folder below `binaries`, such as `win64`.
    pub platform: String,
    /// Contents of the shared library.
    pub content: Vec<u8>,
}

impl Binary {
    /// Reads a shared library for a platform.
    ///
    /// # Errors
    /// The platform is invalid, or the file cannot be read.
    pub fn read(platform: &str, file: &Path) -> anyhow::Result<Binary> {
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if platform.is_empty() || !platform.chars().all(plain) {
            bail!(
                "{platform:?} is no platform; FMI 2.0 has win64, linux64 and darwin64, FMI 3.0 x86_64-windows and so on"
            );
        }
        let content = dashpot_records::read_regular(file, LARGEST_BINARY)
            .with_context(|| format!("cannot read {}", file.display()))?;
        Ok(Binary { platform: platform.to_owned(), content })
    }

    fn suffix(&self) -> &'static str {
        match self.platform.as_str() {
            p if p.starts_with("win") || p.ends_with("-windows") => ".dll",
            p if p.contains("darwin") => ".dylib",
            _ => ".so",
        }
    }
}

/// Options of an FMU, in addition to its model.
pub struct Options<'a> {
    /// FMI version.
    pub version: Version,
    /// Conversion between host and damper: signs, units and zero of the displacement.
    pub scales: Scales,
    /// Instant of a step for which the importer sets the inputs.
    pub inputs: Inputs,
    /// Longest recommended step, s, of an explicit solver that integrates the states, or 0 if unknown.
    pub explicit_step: f64,
    /// Name of the model.
    pub name: &'a str,
    /// Static library of the kernel for this computer. With it, the binary is compiled from this FMU's own sources. `None` selects the
    /// prebuilt runtime.
    pub from_source: Option<&'a Path>,
    /// Whether the FMU contains its sources.
    pub sources: bool,
    /// Whether the parameters are concealed. Then no parameter is a variable of the FMU, and the model in its resources is obfuscated.
    pub conceal_parameters: bool,
    /// Binaries for further platforms.
    pub more: &'a [Binary],
    /// Remarks about this damper on the documentation page, such as chatter in a host with a zero-order hold of the force.
    pub remarks: &'a [String],
}

/// An FMU with its platforms.
pub struct Made {
    /// The bytes of the FMU file.
    pub bytes: Vec<u8>,
    /// Folders below `binaries`.
    pub platforms: Vec<String>,
    /// Identifier of the FMU, which must be equal in description and binary.
    pub guid: String,
}

/// Returns one damper for each corner of an FMU from one model, two models (front, rear) or four models (L1, R1, L2, R2). With `four`, one
/// model is used four times.
///
/// # Errors
/// There is any other number of models.
pub fn corners<D: Copy>(models: &[D], four: bool) -> anyhow::Result<Vec<D>> {
    match (models, four) {
        ([one], false) => Ok(vec![*one]),
        ([one], true) => Ok(vec![*one; 4]),
        ([front, rear], _) => Ok(vec![*front, *front, *rear, *rear]),
        ([_, _, _, _], _) => Ok(models.to_vec()),
        _ => bail!("give one model file, two (front, rear) or four (L1, R1, L2, R2)"),
    }
}

/// Size limit of a binary that the user supplies, bytes. The libraries of dashpot have a few megabytes.
const LARGEST_BINARY: u64 = 256 << 20;
/// Text in every prebuilt runtime, which runs any FMU of this format. It distinguishes such a runtime from a library that was compiled from
/// the sources of one FMU.
const RUNTIME_MARK: &[u8] = b"dashpot-fmu 3";

/// Makes an FMU of one damper, or of four dampers at the corners of a vehicle.
///
/// # Errors
/// A required compiler is missing or fails, the prebuilt runtime is missing, or a supplied binary does not belong to this FMU.
pub fn fmu<D: Copy + Into<Definition>>(corners: &[D], options: &Options) -> anyhow::Result<Made> {
    let corners: Vec<Definition> = corners.iter().map(|damper| (*damper).into()).collect();
    let corners = corners.as_slice();
    let Options { version, scales, .. } = *options;
    let mut variables = variables::variables(corners, scales, options.inputs);
    if options.conceal_parameters {
        variables.retain(|v| !matches!(v.kind, variables::Kind::Parameter | variables::Kind::Choice));
    }
    // The recommended step would reveal stiffness and mass, so an FMU with concealed parameters has none.
    let explicit_step = if options.conceal_parameters { 0.0 } else { options.explicit_step };
    let mut texts: Vec<String> = corners.iter().map(|p| model_file::flat_family(p, |_| String::new())).collect();
    let describe =
        |guid: &str, sources: &[String]| description::description(version, &variables, guid, options.name, sources);
    let contents =
        |guid: &str| sources::contents(corners.len(), &variables, scales, (options.inputs, explicit_step), guid);
    let guid = guid(&[&contents(""), &texts.concat(), &describe("", &[]), env!("CARGO_PKG_VERSION")]);
    if options.conceal_parameters {
        texts.iter_mut().for_each(|text| *text = veil::veiled(text, &guid));
    }
    let contents = contents(&guid);
    let mut files: Vec<(String, Vec<u8>)> =
        sources::bundled().into_iter().map(|(name, text)| (name.to_owned(), text.into())).collect();
    files.push(("model_data.c".into(), sources::model_data(&contents, &texts).into()));
    let Compiled { binaries, kernel } = Compiled::collect(options, &files, &guid)?;
    // An importer can compile the FMU from these files: the C files, and the kernel as an object file.
    let compiled: Vec<String> = if options.sources && kernel.is_some() {
        let c = files.iter().map(|(name, _)| name.clone()).filter(|name| name.ends_with(".c"));
        c.chain([KERNEL.to_owned()]).collect()
    } else {
        Vec::new()
    };
    let mut archive = Archive::new();
    archive.add("modelDescription.xml", describe(&guid, &compiled).as_bytes())?;
    archive.add(if version == Version::Two { "model.png" } else { "terminalsAndIcons/icon.png" }, sources::ICON)?;
    // Remarks on chatter would reveal stiffness and damping, so an FMU with concealed parameters has none.
    let remarks = if options.conceal_parameters { &[] } else { options.remarks };
    archive.add("documentation/index.html", page::page(&variables, remarks).as_bytes())?;
    for Library { platform, suffix, content } in &binaries {
        archive.add(&format!("binaries/{platform}/{}{suffix}", description::IDENTIFIER), content)?;
    }
    archive.add("resources/contents.txt", contents.as_bytes())?;
    for (i, text) in texts.iter().enumerate() {
        archive.add(&format!("resources/{}", variables::model_file_name(i, corners.len())), text.as_bytes())?;
    }
    if options.sources {
        for (name, content) in &files {
            archive.add(&format!("sources/{name}"), content)?;
        }
        add_build_files(&mut archive, options, kernel.as_ref(), &compiled)?;
    }
    let platforms = binaries.into_iter().map(|library| library.platform).collect();
    Ok(Made { bytes: archive.finish()?, platforms, guid })
}

/// Shared library of the FMU for one platform.
struct Library {
    /// Folder below `binaries`.
    platform: String,
    suffix: &'static str,
    content: Vec<u8>,
}

/// The kernel as one object file, and its platform.
type KernelObject = (Vec<u8>, String);

/// Compiled parts of an FMU.
struct Compiled {
    binaries: Vec<Library>,
    kernel: Option<KernelObject>,
}

impl Compiled {
    /// Compiles the FMU, or takes the prebuilt runtimes, and adds the binaries of the user. `files` are the sources.
    fn collect(options: &Options, files: &[(String, Vec<u8>)], guid: &str) -> anyhow::Result<Compiled> {
        let mut compiled = match options.from_source {
            Some(library) => Compiled::from_source(options.version, files, library)?,
            None => Compiled::prebuilt(options.version),
        };
        for other in options.more {
            let holds = |what: &[u8]| other.content.windows(what.len()).any(|part| part == what);
            if !holds(guid.as_bytes()) && !holds(RUNTIME_MARK) {
                bail!(
                    "the binary for {} was not compiled from the sources of this FMU: export it without, compile its sources for \
                     that platform (sources/build.sh), and export it again with the result",
                    other.platform
                );
            }
            // The user's binaries replace the embedded binaries.
            compiled.binaries.retain(|library| library.platform != other.platform);
            let (platform, content) = (other.platform.clone(), other.content.clone());
            compiled.binaries.push(Library { platform, suffix: other.suffix(), content });
        }
        if compiled.binaries.is_empty() {
            bail!("this command holds no FMU runtime; {}, or compile the FMU here with --from-source", runtimes::HOW);
        }
        Ok(compiled)
    }

    fn from_source(version: Version, files: &[(String, Vec<u8>)], library: &Path) -> anyhow::Result<Compiled> {
        let content = compile(files, library)?;
        let binary = Library { platform: platform(version), suffix: std::env::consts::DLL_SUFFIX, content };
        Ok(Compiled { binaries: vec![binary], kernel: Some((needed_of(library)?, platform(version))) })
    }

    fn prebuilt(version: Version) -> Compiled {
        let runtime = |(platform, suffix): (&str, &'static str)| {
            let content = runtimes::compiled(platform, &format!("{}{suffix}", description::IDENTIFIER))?;
            Some(Library { platform: platform_of(platform, version), suffix, content: content.to_vec() })
        };
        let binaries = [("linux64", ".so"), ("win64", ".dll")].into_iter().filter_map(runtime).collect();
        let object = runtimes::compiled("linux64", "kernel.o");
        Compiled { binaries, kernel: object.map(|object| (object.to_vec(), platform_of("linux64", version))) }
    }
}

/// Adds the files with which an importer compiles the FMU: instructions, kernel and build description. `compiled` lists the source files to
/// compile.
fn add_build_files(
    archive: &mut Archive,
    options: &Options,
    kernel: Option<&KernelObject>,
    compiled: &[String],
) -> anyhow::Result<()> {
    let version = options.version;
    archive.add("sources/README.txt", sources::README.as_bytes())?;
    archive.add("sources/build.sh", sources::BUILD.as_bytes())?;
    if let Some((object, platform)) = kernel {
        archive.add(&format!("sources/{KERNEL}"), object)?;
        if version == Version::Three {
            let text = description::build_description(platform, compiled);
            archive.add("sources/buildDescription.xml", text.as_bytes())?;
        }
        let system = if options.from_source.is_some() { system() } else { "Linux-x86_64".to_owned() };
        for (name, text) in [("platform", platform), ("system", &system)] {
            archive.add(&format!("sources/lib/{name}"), format!("{text}\n").as_bytes())?;
        }
    }
    let fmi = if version == Version::Two { "2\n" } else { "3\n" };
    archive.add("sources/lib/fmi", fmi.as_bytes())?;
    for (name, text) in kernel::files() {
        archive.add(&format!("sources/kernel/{name}"), text.as_bytes())?;
    }
    Ok(())
}

/// Path of the kernel as one object file, below `sources`.
const KERNEL: &str = "lib/kernel.o";

/// Converts a platform name of FMI 2.0 to the given version of FMI.
fn platform_of(two: &str, version: Version) -> String {
    match (version, two) {
        (Version::Three, "linux64") => "x86_64-linux".into(),
        (Version::Three, "win64") => "x86_64-windows".into(),
        _ => two.into(),
    }
}

/// Returns the name of this computer's platform, which is the folder below `binaries`.
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

/// Returns the output of `uname -s` and `uname -m` on this computer.
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

/// Returns whether a shared library has the binary format of this computer's operating system.
fn is_of_this_computer(binary: &[u8]) -> bool {
    match std::env::consts::OS {
        "windows" => binary.starts_with(b"MZ"),
        "macos" => !binary.starts_with(b"MZ") && !binary.starts_with(b"\x7fELF"),
        _ => binary.starts_with(b"\x7fELF"),
    }
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
    command.arg(library).args(["-Wl,--exclude-libs,ALL", "-s", "-o"]).arg(&output);
    let ran = command.output().with_context(|| {
        format!("--from-source: {} cannot be run; install gcc or set CC", compiler.to_string_lossy())
    })?;
    if !ran.status.success() {
        bail!("--from-source: the compiler refuses the FMU: {}", String::from_utf8_lossy(&ran.stderr).trim());
    }
    let binary = std::fs::read(&output).or_else(|_| std::fs::read(output.with_extension("bin.exe")))?;
    if !is_of_this_computer(&binary) {
        bail!(
            "--from-source: {} compiles for another platform than this computer; unset CC, and compile the FMU's sources with it \
             by sources/build.sh (TARGET=... CC=...), then give --binary",
            compiler.to_string_lossy()
        );
    }
    Ok(binary)
}

/// Links the kernel's static library `library` to one object file without debugging information.
fn needed_of(library: &Path) -> anyhow::Result<Vec<u8>> {
    let folder = tempfile::tempdir()?;
    let object = folder.path().join("kernel.o");
    let compiler = std::env::var_os("CC").unwrap_or("cc".into());
    let mut link = Command::new(&compiler);
    // The linker adds only the objects that an undefined symbol requires. The symbol `dashpot_step` is enough, because it adds the whole
    // interface.
    link.args(["-r", "-nostdlib", "-Wl,--strip-debug", "-Wl,-u,dashpot_step", "-o"]).arg(&object);
    let ran = link.arg(std::path::absolute(library)?).output()?;
    if !ran.status.success() {
        bail!("--from-source: {}: {}", library.display(), String::from_utf8_lossy(&ran.stderr).trim());
    }
    Ok(std::fs::read(object)?)
}

/// Computes a GUID from the texts of the FMU, as two FNV-1a hashes with different start values.
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
