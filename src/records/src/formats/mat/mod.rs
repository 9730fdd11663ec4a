//! Reads MAT files: numeric vectors whose names are read like column headings. This file reads versions up to 7, and
//! [`version73`] reads version 7.3.

mod version73;

use std::io::Read as _;

use matfile::{Array, MatFile, NumericData};

use crate::columns::heading::{Heading, HeadingUnit, heading};
use crate::columns::layout::Layout;
use crate::columns::table::{Rows, is_header, no_header};
use crate::data::samples::Samples;
use crate::error::{RecordError, RecordFileError};
use crate::options::Options;
use crate::quantities::channel::Channel;
use crate::quantities::unit::{Dimension, Unit};
use crate::source::{Budget, Source};

/// Signature of an HDF5 file. Version 7.3 writes HDF5 after a header block of 512 bytes.
const HDF5: &[u8] = b"\x89HDF\r\n\x1a\n";

/// Work for the interpretation of a variable name, in steps of about a nanosecond (see [`Budget`]).
const NAMING: u64 = 10_000;

/// A vector or a single number of a file.
struct Variable {
    name: String,
    is_vector: bool,
    values: Vec<f64>,
}

/// Reads the test of one MAT file.
pub(crate) fn read(source: Source, name: &str, options: &Options) -> Result<Vec<Samples>, RecordError> {
    let at = source.place();
    let Source { file, bytes, budget } = source;
    let is_hdf5 = bytes.starts_with(HDF5) || bytes.get(512..520) == Some(HDF5) || bytes.starts_with(b"MATLAB 7.3");
    let variables = if is_hdf5 { version73::variables(&bytes, &budget) } else { variables(bytes, &budget) };
    let variables = variables.map_err(|cause| RecordError::File(RecordFileError::Mat { file: file.clone(), cause }))?;
    let vectors: Vec<(&str, &[f64])> =
        variables.iter().filter(|v| v.is_vector).map(|v| (v.name.as_str(), v.values.as_slice())).collect();
    let scalars: Vec<(&str, f64)> =
        variables.iter().filter(|v| !v.is_vector).filter_map(|v| Some((v.name.as_str(), *v.values.first()?))).collect();
    let header: Vec<&str> = vectors.iter().map(|(name, _)| *name).collect();
    let sample_time = scalars.iter().find_map(|(name, value)| match heading(name) {
        Heading::SampleTime(unit) => Some((*name, unit, *value)),
        Heading::SampleRate if *value > 0.0 => Some((*name, HeadingUnit::Known(Unit::Second), 1.0 / *value)),
        _ => None,
    });
    if !is_header(&header, options) {
        if variables.is_empty() {
            let cause = "it holds no vector of numbers; of a struct or a timeseries save the fields as variables, with save(..., '-struct', 's')";
            return Err(RecordFileError::Mat { file: file.clone(), cause: cause.into() }.into());
        }
        let all: Vec<&str> = variables.iter().map(|v| v.name.as_str()).collect();
        return Err(no_header(&at, &all));
    }
    let layout = Layout::new(&at, 1, &header, None, options, sample_time.is_some())?;
    // Vectors of equal length belong together. A vector of another length belongs to another recording, so it is an
    // error.
    let length = layout.columns.iter().map(|c| vectors[c.index].1.len()).max().unwrap_or(0);
    for column in &layout.columns {
        let found = vectors[column.index].1.len();
        if found != length {
            return Err(RecordFileError::Mat {
                file: file.clone(),
                cause: format!("'{}' has {found} values where another channel has {length}", column.heading),
            }
            .into());
        }
    }
    let sample_time = match sample_time {
        None => None,
        Some((name, unit, value)) => {
            // By convention of MATLAB, `Ts` without a unit is in seconds.
            let given = options.units.get(&Channel::Time).copied().filter(|u| u.dimension() == Dimension::Time);
            let unit = match unit {
                HeadingUnit::Known(unit) => unit,
                _ => given.unwrap_or(Unit::Second),
            };
            let step = unit.to_si(value);
            if !(step.is_finite() && step > 0.0) {
                let cause = format!("the sample time '{name}' is {value}, which is no time step");
                return Err(RecordFileError::Mat { file: file.clone(), cause }.into());
            }
            Some(step)
        }
    };
    let mut rows = Rows::new(at, name.to_string(), layout, &budget);
    for i in 0..length {
        let row: Vec<f64> = rows.layout().columns.iter().map(|c| vectors[c.index].1[i]).collect();
        let test = rows.layout().test.map(|index| vectors[index].1.get(i).map(f64::to_string).unwrap_or_default());
        rows.push(i + 1, row.into_iter(), test.as_deref())?;
    }
    rows.finish(sample_time)
}

/// Reads the vectors and single numbers of a file up to version 7.
fn variables(bytes: Vec<u8>, budget: &Budget) -> Result<Vec<Variable>, String> {
    let bytes = unpack(bytes)?;
    // Small number types are converted to numbers of eight bytes, so the values may need several times the memory of
    // the file.
    budget.hold(4 * bytes.len() as u64)?;
    if let Some(cause) = damage(&bytes) {
        return Err(cause.into());
    }
    let mat = MatFile::parse(bytes.as_slice()).map_err(|cause| cause.to_string())?;
    let is_number = |a: &Array| a.size().iter().all(|&n| n == 1);
    let of = |a: &Array| Variable { name: a.name().to_owned(), is_vector: is_vector(a), values: values(a.data()) };
    // The comparison of each name with the headings of all channels costs time.
    budget.work(NAMING * mat.arrays().len() as u64)?;
    let numbers: usize = mat.arrays().iter().map(|a| a.size().iter().product::<usize>()).sum();
    budget.numbers(2 * numbers as u64)?;
    let mut found: Vec<Variable> = mat.arrays().iter().filter(|a| is_vector(a) || is_number(a)).map(of).collect();
    mat.arrays().iter().for_each(|a| found.extend(columns(a)));
    Ok(found)
}

/// Splits a matrix such as [time, signals] into its columns or rows, and gives them names that the user can state.
fn columns(array: &Array) -> Vec<Variable> {
    /// Largest number of channels of a matrix. A matrix with more channels is not a record.
    const MOST: usize = 32;
    let &[rows, columns] = &array.size()[..] else { return Vec::new() };
    let channels = rows.min(columns);
    let values = values(array.data());
    if !(2..=MOST).contains(&channels) || rows == columns || values.len() != rows * columns {
        return Vec::new();
    }
    // The numbers are stored column by column.
    let (what, to_channel, to_next) = if columns < rows { ("column", rows, 1) } else { ("row", 1, rows) };
    let named = |k: usize| Variable {
        name: format!("{} {what} {}", array.name(), k + 1),
        is_vector: true,
        values: values.iter().skip(k * to_channel).step_by(to_next).take(rows.max(columns)).copied().collect(),
    };
    (0..channels).map(named).collect()
}

/// Type number of a compressed element in a MAT file.
const COMPRESSED: u32 = 15;
/// Unpacked size that is always allowed, bytes. Each byte may become a value of eight bytes in several copies.
const UNPACKED: usize = 32 << 20;
/// Allowed ratio of unpacked size to file size, if the result exceeds [`UNPACKED`].
const RATIO: usize = 3;

/// Unpacks the compressed variables of a file, within the size limit.
fn unpack(bytes: Vec<u8>) -> Result<Vec<u8>, String> {
    let little = bytes.get(126..128) == Some(b"IM");
    let word = |at: usize| {
        let word: [u8; 4] = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
        Some(if little { u32::from_le_bytes(word) } else { u32::from_be_bytes(word) })
    };
    if bytes.len() < 128 || word(128) != Some(COMPRESSED) {
        // A file compresses all its variables or none, except that small variables may be uncompressed.
        let mut at = 128;
        let mut compressed = false;
        while let (Some(kind), Some(size)) = (word(at), word(at + 4)) {
            compressed |= kind == COMPRESSED;
            at = at.saturating_add(8).saturating_add(size as usize);
        }
        if !compressed {
            return Ok(bytes);
        }
    }
    let limit = UNPACKED.max(RATIO * bytes.len());
    let mut out = bytes[..128].to_vec();
    let mut at = 128;
    while let (Some(kind), Some(size)) = (word(at), word(at + 4)) {
        let end = (at + 8).saturating_add(size as usize);
        let Some(body) = bytes.get(at + 8..end) else {
            return Err("it ends in the middle of a variable".to_owned());
        };
        if kind == COMPRESSED {
            let allowed = limit.saturating_sub(out.len()) as u64;
            let mut inflated = flate2::read::ZlibDecoder::new(body).take(allowed + 1);
            let before = out.len();
            inflated.read_to_end(&mut out).map_err(|e| format!("a compressed variable is damaged: {e}"))?;
            if (out.len() - before) as u64 > allowed {
                return Err(format!("it unpacks to more than {} MiB", limit >> 20));
            }
        } else {
            out.extend_from_slice(&bytes[at..end]);
        }
        at = end;
    }
    if at < bytes.len() {
        return Err("it ends in the middle of a variable".to_owned());
    }
    Ok(out)
}

/// Detects damage that the parser ignores, or at which it fails.
///
/// Such damage is a last variable beyond the end of the file, or a variable with more elements than the file has bytes.
fn damage(bytes: &[u8]) -> Option<&'static str> {
    const MATRIX: u32 = 14;
    let little = bytes.get(126..128) == Some(b"IM");
    let word = |at: usize| {
        let word: [u8; 4] = bytes.get(at..at.checked_add(4)?)?.try_into().ok()?;
        Some(if little { u32::from_le_bytes(word) } else { u32::from_be_bytes(word) })
    };
    let mut at = 128;
    while let (Some(kind), Some(size)) = (word(at), word(at + 4)) {
        if kind == MATRIX {
            // Tag and array flags take 8 + 16 bytes. The tag of the dimensions and the dimensions follow.
            let count = word(at + 28).unwrap_or(0) as usize / 4;
            let mut elements = 1_u64;
            for k in 0..count.min(64) {
                elements = elements.saturating_mul(u64::from(word(at + 32 + 4 * k).unwrap_or(0)));
            }
            if count > 64 || elements > bytes.len() as u64 {
                return Some("a variable has more elements than the file has bytes");
            }
        }
        at += 8 + size as usize;
    }
    (at > bytes.len()).then_some("it ends in the middle of a variable")
}

fn is_vector(array: &Array) -> bool {
    array.size().iter().filter(|&&n| n != 1).count() == 1
}

/// Converts the real values of an array to doubles. Infinite values become missing values.
fn values(data: &NumericData) -> Vec<f64> {
    fn convert<T: Copy>(real: &[T], f: impl Fn(T) -> f64) -> Vec<f64> {
        real.iter().map(|&v| f(v)).collect()
    }
    match data {
        NumericData::Int8 { real, .. } => convert(real, f64::from),
        NumericData::UInt8 { real, .. } => convert(real, f64::from),
        NumericData::Int16 { real, .. } => convert(real, f64::from),
        NumericData::UInt16 { real, .. } => convert(real, f64::from),
        NumericData::Int32 { real, .. } => convert(real, f64::from),
        NumericData::UInt32 { real, .. } => convert(real, f64::from),
        NumericData::Int64 { real, .. } => convert(real, |v| v as f64),
        NumericData::UInt64 { real, .. } => convert(real, |v| v as f64),
        NumericData::Single { real, .. } => convert(real, |v| if v.is_finite() { f64::from(v) } else { f64::NAN }),
        NumericData::Double { real, .. } => convert(real, |v| if v.is_finite() { v } else { f64::NAN }),
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use dashpot_test_support::drawn;
    use proptest::prelude::*;

    use super::*;

    /// Makes a MAT file of version 5, uncompressed, little-endian (MathWorks, MAT-File Format, section 1).
    fn mat(variables: &[(&str, &[f64])]) -> Vec<u8> {
        fn element(kind: u32, data: &[u8]) -> Vec<u8> {
            let mut out = [kind.to_le_bytes(), (data.len() as u32).to_le_bytes()].concat();
            out.extend_from_slice(data);
            out.resize(out.len().next_multiple_of(8), 0);
            out
        }
        let mut out = vec![b' '; 124];
        out[..19].copy_from_slice(b"MATLAB 5.0 MAT-file");
        out.extend([0x00, 0x01, b'I', b'M']);
        for (name, values) in variables {
            let mut matrix = element(6, &[6, 0, 0, 0, 0, 0, 0, 0]); // class double
            matrix.extend(element(5, &[(values.len() as i32).to_le_bytes(), 1_i32.to_le_bytes()].concat()));
            matrix.extend(element(1, name.as_bytes()));
            matrix.extend(element(9, &values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>()));
            out.extend(element(14, &matrix));
        }
        out
    }

    fn read_bytes(bytes: &[u8], options: &Options) -> Result<Vec<Samples>, RecordError> {
        let mut file = tempfile::Builder::new().suffix(".mat").tempfile().unwrap();
        file.write_all(bytes).unwrap();
        read(Source::read(file.path())?, "rig", options)
    }

    #[test]
    fn vectors_are_read_by_name_with_a_scalar_sample_time() {
        let bytes = mat(&[("displacement_mm", &[1.0, 2.0, f64::NAN]), ("F_kN", &[0.1, 0.2, 0.3]), ("Ts", &[0.01])]);
        let samples = read_bytes(&bytes, &Options::default()).unwrap().remove(0);
        assert_eq!(samples.name, "rig");
        assert_eq!(samples.time, [0.0, 0.01, 0.02]);
        assert_eq!(samples.force, [100.0, 200.0, 300.0]);
        let x = samples.displacement.unwrap();
        assert!(x[0] == 0.001 && x[1] == 0.002 && x[2].is_nan());
    }

    #[test]
    fn units_may_come_from_the_options() {
        let bytes = mat(&[("dist", &[1.0, 2.0]), ("forc", &[3.0, 4.0]), ("time_s", &[0.0, 1.0])]);
        let mut options = Options::default();
        for (channel, name, unit) in
            [(Channel::Displacement, "dist", Unit::Millimetre), (Channel::Force, "forc", Unit::Newton)]
        {
            options.columns.insert(channel, name.into());
            options.units.insert(channel, unit);
        }
        let samples = read_bytes(&bytes, &options).unwrap().remove(0);
        assert_eq!(samples.displacement.unwrap(), [0.001, 0.002]);
    }

    #[test]
    fn channels_of_a_matrix_are_named_by_the_user() {
        // The matrix contains time, displacement and force, as columns or as rows.
        for (size, values, what) in [
            ([4, 3], [0.0, 1.0, 2.0, 3.0, 5.0, 6.0, 7.0, 8.0, 10.0, 20.0, 30.0, 40.0], "column"),
            ([3, 4], [0.0, 5.0, 10.0, 1.0, 6.0, 20.0, 2.0, 7.0, 30.0, 3.0, 8.0, 40.0], "row"),
        ] {
            let mut bytes = mat(&[("log", &values)]);
            // In the file, the size follows the tag of the matrix, its flags, and the tag of the size.
            bytes[128 + 32..128 + 40].copy_from_slice(&size.map(u32::to_le_bytes).concat());
            let mut options = Options::default();
            for (k, channel, unit) in [
                (1, Channel::Time, Unit::Second),
                (2, Channel::Displacement, Unit::Millimetre),
                (3, Channel::Force, Unit::Newton),
            ] {
                options.columns.insert(channel, format!("log {what} {k}"));
                options.units.insert(channel, unit);
            }
            let samples = read_bytes(&bytes, &options).unwrap().remove(0);
            assert_eq!(
                (samples.time.as_slice(), samples.force.as_slice()),
                (&[0.0, 1.0, 2.0, 3.0][..], &[10.0, 20.0, 30.0, 40.0][..])
            );
            assert_eq!(samples.displacement.unwrap(), [0.005, 0.006, 0.007, 0.008]);
            let message = read_bytes(&bytes, &Options::default()).unwrap_err().to_string();
            assert!(message.contains(&format!("log {what} 1, log {what} 2")), "{message}");
        }
        let message = read_bytes(&mat(&[]), &Options::default()).unwrap_err().to_string();
        assert!(message.contains("no vector of numbers") && message.contains("-struct"), "{message}");
    }

    #[test]
    fn other_files_are_refused_in_words() {
        let message = |bytes: &[u8]| read_bytes(bytes, &Options::default()).unwrap_err().to_string();
        let mut new = vec![0; 600];
        new[512..520].copy_from_slice(HDF5);
        assert!(message(&new).contains("'-v7'"));
        assert!(message(b"MATLAB 7.3 MAT-file, Platform: GLNXA64").contains("cannot be read as a MAT file"));
        assert!(message(b"no mat file at all").contains("cannot be read as a MAT file"));
        let whole = mat(&[("time_s", &[0.0, 1.0]), ("x_mm", &[0.0, 1.0]), ("F_N", &[0.0, 1.0])]);
        assert!(message(&whole[..whole.len() - 9]).contains("middle of a variable"));
        assert!(
            message(&mat(&[("time_s", &[0.0, 1.0]), ("x_mm", &[0.0]), ("F_N", &[0.0, 1.0])]))
                .contains("no column for displ")
        );
        let uneven = mat(&[("time_s", &[0.0, 1.0]), ("x_mm", &[0.0, 1.0, 2.0]), ("F_N", &[0.0, 1.0])]);
        assert!(message(&uneven).contains("has 2 values where another channel has 3"));
        assert!(message(&mat(&[("a", &[0.0, 1.0])])).contains("no header"));
    }

    #[test]
    fn compressed_variables_are_unpacked_within_bounds() {
        let plain = mat(&[("time_s", &[0.0, 1.0]), ("x_mm", &[0.0, 1.0]), ("F_N", &[5.0, 6.0])]);
        let compress = |variable: &[u8]| {
            let mut packer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
            packer.write_all(variable).unwrap();
            let packed = packer.finish().unwrap();
            [&15_u32.to_le_bytes()[..], &(packed.len() as u32).to_le_bytes()[..], &packed].concat()
        };
        let (mut packed, mut at) = (plain[..128].to_vec(), 128);
        while at < plain.len() {
            let size = u32::from_le_bytes(plain[at + 4..at + 8].try_into().unwrap()) as usize + 8;
            packed.extend(compress(&plain[at..at + size]));
            at += size;
        }
        assert_eq!(read_bytes(&packed, &Options::default()).unwrap()[0].force, [5.0, 6.0]);
        // This decompression bomb contains zeros.
        let zeros = mat(&[("time_s", &vec![0.0; 6 << 20])]);
        let bomb = [&plain[..128], &compress(&zeros[128..])].concat();
        assert!(bomb.len() < 100_000);
        let message = read_bytes(&bomb, &Options::default()).unwrap_err().to_string();
        assert!(message.contains("unpacks to more than 32 MiB"), "{message}");
    }

    proptest! {
        #![proptest_config(drawn(3000))]
        #[test]
        fn a_damaged_file_is_read_or_refused(at in 0..500_usize, byte in any::<u8>(), keep in 0..600_usize) {
            let mut bytes = mat(&[("time_s", &[0.0, 1.0]), ("x_mm", &[0.0, 1.0]), ("F_N", &[0.0, 1.0])]);
            let at = at % bytes.len();
            bytes[at] = byte;
            bytes.truncate(keep.max(1));
            if let Ok(tests) = read_bytes(&bytes, &Options::default()) {
                prop_assert!(tests.iter().all(|t| t.len() == t.force.len()));
            }
        }
    }
}
