//! Protection of existing files: an output may only replace an older output of its own kind.

use super::inputs;
use super::kind::Kind;
use super::run;
use anyhow::bail;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the user gave `--force`.
static FORCE: AtomicBool = AtomicBool::new(false);

/// Sets whether the user gave `--force`.
pub fn set_force(force: bool) {
    FORCE.store(force, Ordering::Relaxed);
}

/// Target of an output path.
#[derive(Debug, PartialEq, Eq)]
pub enum Target {
    /// A file, new or old, after all symbolic links. It is replaced as a whole.
    File(PathBuf),
    /// A device or a pipe. The output goes to it, and it is never replaced.
    Stream(PathBuf),
}

/// Largest number of symbolic links that are followed, as in Linux.
const LINKS: usize = 40;
/// Largest file that is read to detect its kind, bytes. Outputs are smaller.
const LOOKED_INTO: u64 = 1 << 28;

/// Follows links and determines the target. `new` is the kind of the output, if known.
///
/// # Errors
/// Without `--force`, an output that would destroy an existing file or go to a device, or whose extension implies
/// another kind of file. A folder, a disk or a socket is always an error.
pub fn target(path: &Path, new: Option<&Kind>) -> anyhow::Result<Target> {
    target_forced(path, new, FORCE.load(Ordering::Relaxed) || run::is_forced())
}

fn target_forced(path: &Path, new: Option<&Kind>, force: bool) -> anyhow::Result<Target> {
    let shown = path.display();
    let path = follow(path)?;
    let Ok(there) = fs::metadata(&path) else {
        if !force
            && let Some(new) = new
            && let Some(extension) = new.contradicting_extension(&path)
        {
            bail!(
                "{shown} would hold {new}, which no program looks for in a .{extension} file; name it otherwise, or give --force"
            );
        }
        return Ok(Target::File(path));
    };
    if there.is_dir() {
        bail!("{shown}: it is a folder; name a file in it");
    }
    if !there.is_file() {
        return match stream(&there) {
            Stream::Pipe => Ok(Target::Stream(path)),
            Stream::Device if force => Ok(Target::Stream(path)),
            Stream::Device => {
                bail!("{shown} is a device; name a file, - for standard output, or give --force to write into it")
            }
            Stream::Disk => bail!("{shown} is a disk or a socket; name a file"),
        };
    }
    if force {
        return Ok(Target::File(path));
    }
    if inputs::reads(&path) {
        bail!("{shown} is read by this run and would be lost; name another file, or give --force to replace it");
    }
    if there.permissions().readonly() {
        bail!("{shown} is write-protected; name another file, or give --force to replace it");
    }
    if is_listed_record(&path) {
        bail!("{shown} is a record of the campaign in its folder; name another file, or give --force to replace it");
    }
    let old = match there.len() {
        0 => Kind::Empty,
        size if size > LOOKED_INTO => Kind::Other("a very large file"),
        _ => Kind::detect(&fs::read(&path)?),
    };
    match new {
        Some(new) if old != Kind::Empty && old != *new => bail!(
            "{shown} is there already and holds {old}, no older version of what is to be written ({new}); name another \
             file, or give --force to replace it"
        ),
        _ => Ok(Target::File(path)),
    }
}

/// Follows symbolic links, whether or not a file exists at their end. Links that form a circle are an error.
fn follow(path: &Path) -> anyhow::Result<PathBuf> {
    let mut at = path.to_owned();
    for _ in 0..LINKS {
        match fs::read_link(&at) {
            Ok(to) => at = at.parent().unwrap_or(Path::new("")).join(to),
            Err(_) => return Ok(at),
        }
    }
    bail!("{} is a symbolic link that leads in a circle", path.display())
}

// On Windows, metadata do not distinguish pipes and disks from other files, so only one variant is used there.
#[cfg_attr(not(unix), allow(dead_code))]
enum Stream {
    Pipe,
    Device,
    Disk,
}

#[cfg(unix)]
fn stream(there: &fs::Metadata) -> Stream {
    use std::os::unix::fs::FileTypeExt as _;
    let kind = there.file_type();
    match () {
        () if kind.is_fifo() => Stream::Pipe,
        () if kind.is_char_device() => Stream::Device,
        () => Stream::Disk,
    }
}

#[cfg(not(unix))]
fn stream(_: &fs::Metadata) -> Stream {
    Stream::Device
}

/// Returns whether the campaign description in the same folder lists this file as a record.
fn is_listed_record(path: &Path) -> bool {
    let description = path.with_file_name("campaign.toml");
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    dashpot_records::read_small_text(&description)
        .is_ok_and(|text| text.lines().any(|line| line.trim() == format!("file = {:?}", name.as_ref())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(path: &Path, new: Option<&Kind>) -> String {
        target_forced(path, new, false).map_or_else(|e| e.to_string(), |t| format!("{t:?}"))
    }

    #[test]
    fn an_output_replaces_its_own_kind_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.toml");
        assert!(said(&path, Some(&Kind::Model)).starts_with("File"));
        fs::write(&path, "").unwrap();
        assert!(said(&path, Some(&Kind::Model)).starts_with("File"));
        fs::write(&path, "format = 1\nelements = []\n").unwrap();
        assert!(said(&path, Some(&Kind::Model)).starts_with("File"));
        fs::write(&path, "time_s,force_N\n0,1\n").unwrap();
        let message = said(&path, Some(&Kind::Model));
        assert!(message.contains("a table that begins with \"time_s,force_N\"") && message.contains("--force"));
        assert!(target_forced(&path, Some(&Kind::Model), true).is_ok());
    }

    #[test]
    fn a_name_that_promises_another_kind_is_rejected() {
        let folder = tempfile::tempdir().unwrap();
        for (name, kind, is_fit) in [
            ("a.csv", Kind::Model, false),
            ("a.toml", Kind::Model, true),
            ("a.toml", Kind::Report, false),
            ("a.HTML", Kind::Report, true),
            ("a.json", Kind::Figures, true),
            ("a.json", Kind::Workbook, false),
            ("a", Kind::Model, true),
            ("a.model", Kind::Model, true),
            ("a.csv", Kind::Table("time_s".into()), true),
        ] {
            let path = folder.path().join(name);
            assert_eq!(said(&path, Some(&kind)).starts_with("File"), is_fit, "{name}: {kind}");
            assert!(target_forced(&path, Some(&kind), true).is_ok());
        }
    }

    #[test]
    fn records_that_a_campaign_lists_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("campaign.toml"), "[[test]]\nfile = \"a.csv\"\n").unwrap();
        for (name, kept) in [("a.csv", true), ("b.csv", false)] {
            let path = folder.path().join(name);
            fs::write(&path, "time_s,force_N\n").unwrap();
            let kind = Kind::Table("time_s,force_N".into());
            assert_eq!(said(&path, Some(&kind)).contains("is a record of the campaign"), kept, "{name}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_and_devices_are_not_replaced() {
        let folder = tempfile::tempdir().unwrap();
        let link = |to: &str, name: &str| {
            let path = folder.path().join(name);
            std::os::unix::fs::symlink(to, &path).unwrap();
            path
        };
        let dangling = link("new.toml", "dangling");
        assert_eq!(target_forced(&dangling, None, false).unwrap(), Target::File(folder.path().join("new.toml")));
        assert!(said(&link("circle", "circle"), None).contains("circle"));
        let null = link("/dev/null", "null");
        assert!(said(&null, None).contains("is a device"));
        assert_eq!(target_forced(&null, None, true).unwrap(), Target::Stream("/dev/null".into()));
        let locked = folder.path().join("locked");
        fs::write(&locked, "x").unwrap();
        fs::set_permissions(&locked, std::os::unix::fs::PermissionsExt::from_mode(0o444)).unwrap();
        assert!(said(&locked, None).contains("write-protected"));
    }
}
