//! Zip archive with uncompressed entries. Files with equal names and contents give an archive with equal bytes.

use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, System, ZipWriter};

/// A zip archive to which files are added.
pub struct Archive {
    writer: ZipWriter<Cursor<Vec<u8>>>,
}

impl Archive {
    /// Makes an archive without files.
    pub fn new() -> Archive {
        Archive { writer: ZipWriter::new(Cursor::new(Vec::new())) }
    }

    /// Adds a file. `name` contains the folders of the file, separated by `/`.
    pub fn add(&mut self, name: &str, content: &[u8]) -> anyhow::Result<()> {
        // The date is always 1 January 1980, the system DOS and the attributes 0. So the bytes do not depend on the computer.
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::default())
            .system(System::Dos)
            .external_attributes(0);
        self.writer.start_file(name, options)?;
        self.writer.write_all(content)?;
        Ok(())
    }

    /// Returns the finished archive.
    pub fn finish(self) -> anyhow::Result<Vec<u8>> {
        Ok(self.writer.finish()?.into_inner())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Read as _;

    #[test]
    fn an_archive_depends_on_its_files_alone() {
        let make = || {
            let mut archive = Archive::new();
            archive.add("a/b.txt", b"stored as it is").unwrap();
            archive.add("c", b"").unwrap();
            archive.finish().unwrap()
        };
        let bytes = make();
        assert_eq!(bytes, make());
        // These bytes of the first local header are the time and date: 1 January 1980.
        assert_eq!(bytes[10..14], [0, 0, 0x21, 0]);
        let mut read = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
        let mut text = String::new();
        let mut file = read.by_name("a/b.txt").unwrap();
        assert_eq!((file.compression(), file.unix_mode()), (CompressionMethod::Stored, None));
        file.read_to_string(&mut text).unwrap();
        assert_eq!(text, "stored as it is");
    }
}
