//! Selection of the reader for a record file.

use std::path::Path;

use crate::data::samples::Samples;
use crate::error::{ColumnError, RecordError, RecordFileError};
use crate::file_extensions::{extension, is_record_name};
use crate::formats::{csv, mat, mdf, rpc, tdms, unsupported, xlsx};
use crate::options::Options;
use crate::peaks::table;
use crate::source::Source;

/// Reads the tests of one file. The extension selects the reader. For `.dat`, the content decides between MDF and text.
pub(super) fn read_file(file: &Path, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let name = file.file_stem().unwrap_or_default().to_string_lossy();
    let ending = extension(file);
    if !is_record_name(file) {
        return Err(RecordFileError::UnknownType { file: file.into() }.into());
    }
    let source = Source::read(file)?;
    let archives = ["xlsx", "xlsm", "mat"].contains(&ending.as_str());
    if !archives && let Some((is, instead)) = unsupported::known(&source.bytes) {
        return Err(RecordFileError::NotRead { file: file.into(), is, instead }.into());
    }
    let read = match ending.as_str() {
        // Many loggers write MDF files with the extension `.dat`, and many rigs write text files with it.
        "dat" if mdf::is_one(&source.bytes) => mdf::read(source, &name, options),
        "csv" | "txt" | "tsv" | "asc" | "dat" | "tra" | "lvm" => csv::read(source, &name, options),
        "xlsx" | "xlsm" => xlsx::read(source, &name, options),
        "mat" => mat::read(source, &name, options),
        "mf4" | "mdf" => mdf::read(source, &name, options),
        "tdms" => tdms::read(source, &name, options),
        "rsp" | "drv" | "tim" => rpc::read(source, &name, options),
        _ => Err(RecordFileError::UnknownType { file: file.into() }.into()),
    };
    match read {
        Err(
            RecordError::Column(ColumnError::Header { .. })
            | RecordError::Column(ColumnError::MissingColumn { missing: "time", .. }),
        ) if ["csv", "txt", "tsv", "asc", "dat", "xlsx", "xlsm"].contains(&ending.as_str()) && table::is_one(file) => {
            Err(RecordFileError::IsPeakTable { file: file.into() }.into())
        }
        read => read,
    }
}
