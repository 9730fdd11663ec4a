//! Damaged and malicious files. Each is read or rejected with a message, within a gibibyte of memory.
//!
//! If a reader requests more memory, a signal ends this process, and the test fails.

#[allow(dead_code)] // other tests use the functions that damage texts
#[path = "../../../tests/hostile.rs"]
mod damage;

use damage::{Random, keep_for_fuzzer, mutate, rounds};
use dashpot_records::{Options, Unit, load};
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// Address space of this process, bytes: a gibibyte for the reader, and memory for the program and its thread stacks.
#[cfg(target_os = "linux")]
const SPACE: u64 = (1 << 30) + (512 << 20);

fn limit_memory() {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Resource, Rlimit, setrlimit};
        setrlimit(Resource::As, Rlimit { current: Some(SPACE), maximum: Some(SPACE) }).unwrap();
    }
}

/// Loads a file. A panic or a signal fails the test. A record and an error message are both acceptable.
fn answer(folder: &Path, name: &str, bytes: &[u8]) -> Result<usize, String> {
    let file = folder.join(name);
    std::fs::write(&file, bytes).unwrap();
    let mut options = Options::default();
    options.units.insert("force".parse().unwrap(), Unit::Newton);
    let answer = load(&[file], &options, &|_| ()).map(|c| c.records.len()).map_err(|e| e.to_string());
    if let Err(message) = &answer {
        let is_of_all = ["in all", "tests", "in the only test"].iter().any(|of_all| message.contains(of_all));
        assert!(message.contains(name) || is_of_all, "{name}: {message}");
    }
    answer
}

/// Returns time in s, displacement in mm and force in N of a damper on a sine.
fn rows() -> Vec<[f64; 3]> {
    (0..120)
        .map(|i| {
            let t = 0.01 * f64::from(i);
            let v = 0.3 * libm::cos(6.0 * t);
            [t, 50.0 * libm::sin(6.0 * t), 1500.0 * v + 40.0 * libm::tanh(v / 0.01) + f64::from(i * i % 7)]
        })
        .collect()
}

fn text(delimiter: &str, header: &str) -> Vec<u8> {
    let mut out = format!("{header}\n");
    for row in rows() {
        out += &row.map(|v| format!("{v:.4}")).join(delimiter);
        out.push('\n');
    }
    out.into_bytes()
}

const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const RELATIONS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

/// Makes the parts of a workbook with one sheet.
fn workbook() -> Vec<(&'static str, Vec<u8>)> {
    let strings = ["time_s", "x_mm", "F_N"];
    let mut sheet = format!("<worksheet xmlns=\"{MAIN}\"><sheetData><row r=\"1\">");
    for (k, column) in ["A", "B", "C"].iter().enumerate() {
        sheet += &format!("<c r=\"{column}1\" t=\"s\"><v>{k}</v></c>");
    }
    sheet += "</row>";
    for (r, row) in rows().iter().enumerate() {
        sheet += &format!("<row r=\"{}\">", r + 2);
        for (column, value) in ["A", "B", "C"].iter().zip(row) {
            sheet += &format!("<c r=\"{column}{}\"><v>{value:.4}</v></c>", r + 2);
        }
        sheet += "</row>";
    }
    sheet += "</sheetData></worksheet>";
    let shared: String = strings.iter().map(|s| format!("<si><t>{s}</t></si>")).collect();
    vec![
        ("[Content_Types].xml", b"<Types/>".to_vec()),
        (
            "_rels/.rels",
            format!("<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"r1\" Type=\"{OFFICE}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>").into_bytes(),
        ),
        (
            "xl/workbook.xml",
            format!("<workbook xmlns=\"{MAIN}\" xmlns:r=\"{OFFICE}\"><sheets><sheet name=\"one\" sheetId=\"1\" r:id=\"s0\"/></sheets></workbook>").into_bytes(),
        ),
        (
            "xl/_rels/workbook.xml.rels",
            format!("<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"s0\" Type=\"{OFFICE}/worksheet\" Target=\"worksheets/sheet0.xml\"/><Relationship Id=\"s1\" Type=\"{OFFICE}/sharedStrings\" Target=\"sharedStrings.xml\"/></Relationships>").into_bytes(),
        ),
        ("xl/sharedStrings.xml", format!("<sst xmlns=\"{MAIN}\" count=\"3\" uniqueCount=\"3\">{shared}</sst>").into_bytes()),
        ("xl/worksheets/sheet0.xml", sheet.into_bytes()),
    ]
}

fn zip(parts: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for (name, part) in parts {
        archive.start_file(*name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(part).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// Makes one variable of a MAT file of version 5.
fn variable(name: &str, values: &[f64]) -> Vec<u8> {
    let element = |kind: u32, data: &[u8]| {
        let mut out = [kind.to_le_bytes(), (data.len() as u32).to_le_bytes()].concat();
        out.extend_from_slice(data);
        out.resize(out.len().next_multiple_of(8), 0);
        out
    };
    let mut matrix = element(6, &[6, 0, 0, 0, 0, 0, 0, 0]);
    matrix.extend(element(5, &[(values.len() as i32).to_le_bytes(), 1_i32.to_le_bytes()].concat()));
    matrix.extend(element(1, name.as_bytes()));
    matrix.extend(element(9, &values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>()));
    element(14, &matrix)
}

fn mat(variables: &[Vec<u8>], packed: bool) -> Vec<u8> {
    let mut out = vec![b' '; 124];
    out[..19].copy_from_slice(b"MATLAB 5.0 MAT-file");
    out.extend([0x00, 0x01, b'I', b'M']);
    for variable in variables {
        if packed {
            let mut packer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
            packer.write_all(variable).unwrap();
            let packed = packer.finish().unwrap();
            out.extend(15_u32.to_le_bytes());
            out.extend((packed.len() as u32).to_le_bytes());
            out.extend(packed);
        } else {
            out.extend(variable);
        }
    }
    out
}

fn variables() -> Vec<Vec<u8>> {
    let column = |k: usize| rows().iter().map(|r| r[k]).collect::<Vec<f64>>();
    vec![variable("time_s", &column(0)), variable("x_mm", &column(1)), variable("F_N", &column(2))]
}

fn rpc() -> Vec<u8> {
    let entries = [
        ("FORMAT", "BINARY_IEEE_LITTLE_END"),
        ("NUM_HEADER_BLOCKS", "4"),
        ("NUM_PARAMS", "14"),
        ("FILE_TYPE", "TIME_HISTORY"),
        ("DELTA_T", "1.0e-2"),
        ("PTS_PER_FRAME", "120"),
        ("CHANNELS", "2"),
        ("PTS_PER_GROUP", "120"),
        ("FRAMES", "1"),
        ("DATA_TYPE", "FLOATING_POINT"),
        ("DESC.CHAN_1", "Stroke"),
        ("UNITS.CHAN_1", "mm"),
        ("DESC.CHAN_2", "Force"),
        ("UNITS.CHAN_2", "N"),
    ];
    let mut out = vec![0; 2048];
    for (k, (key, value)) in entries.iter().enumerate() {
        out[128 * k..128 * k + key.len()].copy_from_slice(key.as_bytes());
        out[128 * k + 32..128 * k + 32 + value.len()].copy_from_slice(value.as_bytes());
    }
    for channel in [1, 2] {
        out.extend(rows().iter().flat_map(|r| (r[channel] as f32).to_le_bytes()));
    }
    out
}

/// Reads a file of a third-party writer.
fn foreign(name: &str) -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/foreign").join(name)).unwrap()
}

/// Makes valid files of every format as seeds of the mutations.
fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    let mts =
        [b"MTS793|BTW|ENU|1|2|.|/|:|1|0|0|A\n".to_vec(), text("\t", "Time Sec\tAxial Displacement mm\tAxial Force N")]
            .concat();
    let labview = [
        b"LabVIEW Measurement\nSeparator\tTab\nX_Columns\tOne\n***End_of_Header***\n\nChannels\t2\nY_Unit_Label\tmm\tN\nDelta_X\t0.01\n\
          ***End_of_Header***\n"
            .to_vec(),
        text("\t", "X_Value\tDisplacement\tForce"),
    ]
    .concat();
    let beside = [text(",", "# t_s,x_mm,F_N\nVoltage,LVDT,U9B"), b"\nMax,1,2\nMin,1,2\n".to_vec()].concat();
    vec![
        ("o.lvm", labview),
        ("p.asc", beside),
        ("a.csv", text(",", "time_s,displacement_mm,force_N")),
        ("b.txt", text("   ", "Zeit [s]   Weg [mm]   Kraft [N]")),
        ("c.dat", [mts.clone(), mts].concat()),
        ("d.csv", text(";", "test;t_s;x_mm;F_N")),
        ("e.xlsx", zip(&workbook())),
        ("f.mat", mat(&variables(), false)),
        ("g.mat", mat(&variables(), true)),
        ("h.rsp", rpc()),
        ("i.mf4", foreign("plain.mf4")),
        ("j.mf4", foreign("transposed.mf4")),
        ("m.mat", foreign("matlab73.mat")),
        ("n.mdf", foreign("counts.mdf")),
        ("k.tdms", foreign("time.tdms")),
        ("l.tdms", foreign("waves.tdms")),
    ]
}

#[test]
fn thousands_of_damaged_files_and_known_bombs_are_read_or_refused() {
    limit_memory();
    let folder = tempfile::tempdir().unwrap();
    let folder: &PathBuf = &folder.path().to_path_buf();
    for (name, seed) in seeds() {
        keep_for_fuzzer(name, 0, &seed);
        if name != "d.csv" {
            assert_eq!(answer(folder, name, &seed), Ok(if name == "c.dat" { 2 } else { 1 }), "{name} itself is sound");
        }
    }
    let mut random = Random(7);
    let seeds = seeds();
    for round in 0..rounds(4500) {
        let (name, seed) = &seeds[round % seeds.len()];
        let mut bytes = seed.clone();
        if *name == "e.xlsx" && round % 3 > 0 {
            // The parts are damaged before compression, so the checksums of the archive are correct.
            let mut parts = workbook();
            let k = random.below(parts.len());
            mutate(&mut random, &mut parts[k].1);
            bytes = zip(&parts);
        } else if *name == "g.mat" && round % 3 > 0 {
            let mut variables = variables();
            let k = random.below(3);
            mutate(&mut random, &mut variables[k]);
            bytes = mat(&variables, true);
        } else {
            mutate(&mut random, &mut bytes);
        }
        let _ = answer(folder, name, &bytes);
    }
    bombs(folder);
}

fn bombs(folder: &Path) {
    // This sheet unpacks to about 350 MB, from a file below 10 MiB.
    let mut parts = workbook();
    let cells = "<row><c><v>1</v></c><c><v>2</v></c><c><v>3</v></c></row>".repeat(6 << 20).into_bytes();
    let sheet = String::from_utf8(parts[5].1.clone()).unwrap();
    let (head, tail) = sheet.split_at(sheet.find("</sheetData>").unwrap());
    parts[5].1 = [head.as_bytes(), &cells, tail.as_bytes()].concat();
    drop(cells);
    let bomb = zip(&parts);
    drop(parts);
    assert!(bomb.len() < 10 << 20);
    assert!(answer(folder, "bomb.xlsx", &bomb).unwrap_err().contains("unpacks to more"));
    // The first workbook announces strings that do not exist. The second has a cell at the end of the largest possible
    // sheet.
    let mut parts = workbook();
    parts[4].1 = String::from_utf8(parts[4].1.clone())
        .unwrap()
        .replace("uniqueCount=\"3\"", "uniqueCount=\"4294967295\"")
        .into();
    assert!(answer(folder, "count.xlsx", &zip(&parts)).unwrap_err().contains("4294967295 strings"));
    let mut parts = workbook();
    let far = "<row r=\"1048576\"><c r=\"XFD1048576\"><v>1</v></c></row></sheetData>";
    parts[5].1 = String::from_utf8(parts[5].1.clone()).unwrap().replace("</sheetData>", far).into();
    assert_eq!(answer(folder, "far.xlsx", &zip(&parts)), Ok(1));
    // The unpacked size of this variable is far above the size of the file.
    let zeros = variable("time_s", &vec![0.0; 8 << 20]);
    let bomb = mat(&[zeros], true);
    assert!(bomb.len() < 1 << 20);
    assert!(answer(folder, "bomb.mat", &bomb).unwrap_err().contains("unpacks to more"));
    // One file has hundreds of thousands of tests with one row each, one has a million columns, and one has thousands
    // of equal periods.
    let names: String = (0..450_000).map(|i| format!("t{i},0.1,1,2\n")).collect();
    let refused = answer(folder, "names.csv", format!("test,time_s,x_mm,F_N\n{names}").as_bytes()).unwrap_err();
    assert!(refused.contains("only 1 usable") && refused.len() < 1000, "{refused}");
    let columns = (0..1_500_000).map(|i| format!("c{i}")).collect::<Vec<_>>().join(",");
    let refused = answer(folder, "columns.csv", format!("time_s,F_N,{columns}\n0,1\n").as_bytes()).unwrap_err();
    assert!(refused.contains("more") && refused.len() < 2000, "{}", refused.len());
    let period = rows();
    let periodic: String = (0..300_000_usize)
        .map(|i| format!("{:.2},{:.3},{:.1}\n", 0.01 * i as f64, period[i % 105][1], period[i % 105][2]))
        .collect();
    let _ = answer(folder, "periodic.csv", format!("time_s,x_mm,F_N\n{periodic}").as_bytes());
}
