//! The bytes of a record file, and the budget of work and memory for reading them.
//!
//! Every reader obtains its bytes from this module. Readers charge the budget for each size that a file states, and for
//! each use of a shared block or text. Thus, the size of the file limits the cost of reading.

use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use crate::error::{Place, RecordError, RecordFileError};

/// Size of the largest record file that is read, bytes. As text, an hour of four channels at 1 kHz has 130 MB.
pub(crate) const LARGEST: u64 = 256 << 20;
/// Memory for the data that a reader makes of a file, bytes. The first number is a constant for any file, and the
/// second is a factor on the file size. A number of 16 bits becomes eight bytes long, and a compressed file may have a
/// third of the size of its numbers. Cleaning then uses up to three times the memory. A file of 10 MiB stays within 1
/// GiB.
const MEMORY: (u64, u64) = (192 << 20, 10);
/// Work for reading a file, in steps of about a nanosecond: a constant for any file, and a number per byte of the file.
/// A text requires 30 steps per byte.
const WORK: (u64, u64) = (2_000_000_000, 200);

/// A record file in memory.
pub(crate) struct Source {
    pub file: PathBuf,
    pub bytes: Vec<u8>,
    pub budget: Budget,
}

impl Source {
    /// Reads a whole file.
    ///
    /// # Errors
    /// The file cannot be read, is not a regular file, is empty, or is larger than [`LARGEST`].
    pub fn read(file: &Path) -> Result<Source, RecordError> {
        let bytes = bytes(file, LARGEST)?;
        if bytes.is_empty() {
            return Err(RecordFileError::EmptyFile { file: file.into() }.into());
        }
        Ok(Source { file: file.into(), budget: Budget::new(bytes.len() as u64), bytes })
    }

    /// Returns the location of the file, for messages.
    pub fn place(&self) -> Place {
        Place::file(&self.file)
    }
}

/// Reads the bytes of a regular file of at most `largest` bytes.
///
/// # Errors
/// The file cannot be read, is larger than `largest`, or is not a regular file. Reading a pipe could block forever, and
/// a device never ends.
pub(crate) fn bytes(file: &Path, largest: u64) -> Result<Vec<u8>, RecordError> {
    let unreadable = |source| RecordError::File(RecordFileError::Read { file: file.into(), source });
    let metadata = std::fs::metadata(file).map_err(unreadable)?;
    if !metadata.is_file() {
        return Err(RecordFileError::NotRegular { file: file.into() }.into());
    }
    let too_large = |bytes| RecordError::File(RecordFileError::TooLarge { file: file.into(), bytes, largest });
    if metadata.len() > largest {
        return Err(too_large(metadata.len()));
    }
    // A file may grow while it is read, and some files state no size. The size is therefore checked again after
    // reading.
    let mut bytes = Vec::with_capacity(metadata.len() as usize + 1);
    File::open(file).map_err(unreadable)?.take(largest + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > largest {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// Reads the text of a regular file of at most `largest` bytes, in UTF-8.
///
/// # Errors
/// The errors of [`bytes`], or a file that is not text.
pub(crate) fn text(file: &Path, largest: u64) -> Result<String, RecordError> {
    String::from_utf8(bytes(file, largest)?).map_err(|error| {
        let source = std::io::Error::new(std::io::ErrorKind::InvalidData, error.utf8_error());
        RecordError::File(RecordFileError::Read { file: file.into(), source })
    })
}

/// Size limit of files that are not records, such as tables, models and descriptions, bytes.
const LARGEST_SMALL: u64 = 16 << 20;

/// Reads the bytes of a table, a model or a description: a regular file of at most 16 MiB.
///
/// # Errors
/// The file cannot be read, is no regular file (such as a folder, a pipe or a device), or is larger than 16 MiB.
pub fn read_small(file: &Path) -> std::io::Result<Vec<u8>> {
    read_regular(file, LARGEST_SMALL)
}

/// Reads the bytes of a regular file of at most `largest` bytes.
///
/// # Errors
/// The file cannot be read, is no regular file (such as a folder, a pipe or a device), or is larger than `largest`.
pub fn read_regular(file: &Path, largest: u64) -> std::io::Result<Vec<u8>> {
    bytes(file, largest).map_err(|error| match error {
        RecordError::File(RecordFileError::Read { source, .. }) => source,
        RecordError::File(RecordFileError::NotRegular { .. }) if file.is_dir() => {
            std::io::Error::other("it is a folder; give a file in it")
        }
        RecordError::File(RecordFileError::NotRegular { .. }) => std::io::Error::other("it is no regular file"),
        _ => std::io::Error::other(format!("it is larger than {} MiB", largest >> 20)),
    })
}

/// Reads the text of a table, a model or a description, in UTF-8.
///
/// # Errors
/// The errors of [`read_small`], or a file that is not text.
pub fn read_small_text(file: &Path) -> std::io::Result<String> {
    String::from_utf8(read_small(file)?)
        .map_err(|_| std::io::Error::new(std::io::ErrorKind::InvalidData, "it is no text in UTF-8"))
}

/// The remaining work and memory for reading one file. Clones share one remainder.
#[derive(Debug, Clone)]
pub(crate) struct Budget(Arc<Left>);

#[derive(Debug)]
struct Left {
    work: AtomicU64,
    memory: AtomicU64,
}

/// Error for an exhausted budget.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Exhausted;

impl Budget {
    /// Makes the budget of a file from its number of bytes.
    pub fn new(bytes: u64) -> Budget {
        let of = |(any, per_byte): (u64, u64)| AtomicU64::new(any + per_byte * bytes);
        Budget(Arc::new(Left { work: of(WORK), memory: of(MEMORY) }))
    }

    /// Charges work, in steps of about a nanosecond, for example for a visited block or an unpacked byte. It is an
    /// error if less work remains.
    pub fn work(&self, steps: u64) -> Result<(), Exhausted> {
        charge(&self.0.work, steps)
    }

    /// Charges `bytes` of memory, and one step of work for each byte. [`Budget::free`] returns memory that was in use
    /// only temporarily.
    pub fn hold(&self, bytes: u64) -> Result<(), Exhausted> {
        charge(&self.0.memory, bytes)?;
        self.work(bytes)
    }

    /// Returns memory that was in use temporarily to the budget.
    pub fn free(&self, bytes: u64) {
        self.0.memory.fetch_add(bytes, Relaxed);
    }

    /// Charges the memory of `count` numbers of eight bytes.
    pub fn numbers(&self, count: u64) -> Result<(), Exhausted> {
        self.hold(count.saturating_mul(8))
    }

    /// Returns the remaining memory, bytes.
    pub fn bytes_remaining(&self) -> u64 {
        self.0.memory.load(Relaxed)
    }
}

fn charge(left: &AtomicU64, amount: u64) -> Result<(), Exhausted> {
    // Only one thread reads a file, so a separate load and store suffice. The counter is atomic only so that parts of
    // the reader can share it.
    let rest = left.load(Relaxed).checked_sub(amount);
    left.store(rest.unwrap_or(0), Relaxed);
    rest.map(|_| ()).ok_or(Exhausted)
}

impl Exhausted {
    /// Description of this error in the messages of readers.
    pub const CAUSE: &'static str = "it unpacks to more than a file of its size may, or uses its parts too often";

    /// Converts this error to the record error at a location.
    pub fn into_error(self, at: &Place) -> RecordError {
        RecordError::File(RecordFileError::TooCostly { at: at.clone() })
    }
}

impl From<Exhausted> for String {
    fn from(_: Exhausted) -> String {
        Exhausted::CAUSE.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_is_charged_at_every_use_and_shared_by_clones() {
        let budget = Budget::new(0);
        let part = budget.clone();
        part.hold(MEMORY.0 - 8).unwrap();
        budget.numbers(1).unwrap();
        assert_eq!(part.hold(1), Err(Exhausted));
        budget.free(16);
        assert_eq!(part.bytes_remaining(), 16);
        assert_eq!(Budget::new(0).work(u64::MAX), Err(Exhausted));
        assert_eq!(Budget::new(0).numbers(u64::MAX), Err(Exhausted));
    }

    #[test]
    fn only_regular_files_of_the_stated_size_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let message = |error: RecordError| error.to_string();
        assert!(message(bytes(folder.path(), 10).unwrap_err()).contains("no regular file"));
        let file = folder.path().join("a.csv");
        std::fs::write(&file, "12345678901").unwrap();
        assert_eq!(bytes(&file, 11).unwrap().len(), 11);
        assert!(message(bytes(&file, 10).unwrap_err()).contains("a.csv: has 11 bytes"));
        // The file is sparse and uses no space on the disk.
        std::fs::File::create(&file).unwrap().set_len(2 << 30).unwrap();
        assert!(message(Source::read(&file).err().unwrap()).contains("2048 MiB"));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn pipes_and_devices_are_no_records() {
        let folder = tempfile::tempdir().unwrap();
        let device = folder.path().join("zero.csv");
        std::os::unix::fs::symlink("/dev/zero", &device).unwrap();
        assert!(Source::read(&device).err().unwrap().to_string().contains("no regular file"));
        let pipe = folder.path().join("pipe.csv");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        assert!(Source::read(&pipe).err().unwrap().to_string().contains("no regular file"));
        assert!(read_small(&pipe).is_err() && read_small_text(&device).is_err());
    }
}
