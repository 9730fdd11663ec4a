//! Small files that are constructed to cost gigabytes or minutes.
//!
//! Examples are a part with many uses, counts beyond the content of a file, and trees in which two paths lead to one
//! node. Each file is read or rejected within a gibibyte and ten seconds of processor time.
//!
//! If a reader requests more memory, a signal ends this process, and the test fails.

use dashpot_records::{Options, Unit, load};
use std::io::Write as _;
use std::path::Path;

/// Address space of this process, bytes: a gibibyte for the reader, and memory for the program and its thread stacks.
#[cfg(target_os = "linux")]
const SPACE: u64 = (1 << 30) + (512 << 20);
/// Largest allowed processor time for one file, s.
const SECONDS: f64 = 10.0;

fn limit_memory() {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Resource, Rlimit, setrlimit};
        setrlimit(Resource::As, Rlimit { current: Some(SPACE), maximum: Some(SPACE) }).unwrap();
    }
}

/// Returns the processor time of this process, s. On systems other than Linux, it is the wall-clock time.
fn seconds() -> f64 {
    static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
    // User and system time in hundredths of a second.
    let used = std::fs::read_to_string("/proc/self/stat").ok().and_then(|stat| {
        let fields: Vec<&str> = stat.rsplit_once(')')?.1.split_whitespace().collect();
        Some(fields[11].parse::<f64>().ok()? + fields[12].parse::<f64>().ok()?)
    });
    used.map_or_else(|| START.elapsed().as_secs_f64(), |ticks| ticks / 100.0)
}

/// Loads a file and checks the time limit. Returns the number of records, or the message if the file is rejected.
fn answer(path: &Path) -> Result<usize, String> {
    let begin = seconds();
    let mut options = Options::default();
    options.units.insert("force".parse().unwrap(), Unit::Newton);
    let answer = load(&[path.to_path_buf()], &options, &|_| ()).map(|c| c.records.len()).map_err(|e| e.to_string());
    let took = seconds() - begin;
    println!("{}: {took:.1} s, {answer:?}", path.file_name().unwrap().display());
    assert!(took < SECONDS, "{}: {took} s", path.display());
    if let Err(message) = &answer {
        assert!(message.len() < 3000, "{}: a message of {} bytes", path.display(), message.len());
    }
    answer
}

fn rejected(folder: &Path, name: &str, bytes: &[u8]) -> String {
    assert!(bytes.len() < 11 << 20, "{name}: {}", bytes.len());
    let file = folder.join(name);
    std::fs::write(&file, bytes).unwrap();
    let message = answer(&file).expect_err(name);
    assert!(message.contains(name), "{message}");
    message
}

const MAIN: &str = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const RELATIONS: &str = "http://schemas.openxmlformats.org/package/2006/relationships";
const OFFICE: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

/// Makes a workbook whose sheets all refer to the same part.
fn workbook(sheets: usize, data: &str, others: &[(&str, String)]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let mut put = |name: &str, text: &str| {
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    };
    put("[Content_Types].xml", "<Types/>");
    put(
        "_rels/.rels",
        &format!(
            "<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"r1\" Type=\"{OFFICE}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
        ),
    );
    let list: String = (0..sheets).map(|k| format!("<sheet name=\"s{k}\" sheetId=\"{k}\" r:id=\"s0\"/>")).collect();
    put(
        "xl/workbook.xml",
        &format!("<workbook xmlns=\"{MAIN}\" xmlns:r=\"{OFFICE}\"><sheets>{list}</sheets></workbook>"),
    );
    put(
        "xl/_rels/workbook.xml.rels",
        &format!(
            "<Relationships xmlns=\"{RELATIONS}\"><Relationship Id=\"s0\" Type=\"{OFFICE}/worksheet\" Target=\"worksheets/sheet0.xml\"/><Relationship Id=\"s1\" Type=\"{OFFICE}/sharedStrings\" Target=\"sharedStrings.xml\"/></Relationships>"
        ),
    );
    put("xl/worksheets/sheet0.xml", &format!("<worksheet xmlns=\"{MAIN}\"><sheetData>{data}</sheetData></worksheet>"));
    for (name, text) in others {
        put(name, text);
    }
    archive.finish().unwrap().into_inner()
}

/// Runs `files`, which reads files in a folder, in a separate process.
///
/// The memory and the processor time of this process are then those of `files` alone, so several tests can run at the
/// same time.
fn in_own_process(test: &str, files: fn(&Path)) {
    const INNER: &str = "DASHPOT_COSTLY_FILES";
    if std::env::var_os(INNER).is_some() {
        limit_memory();
        let folder = tempfile::tempdir().unwrap();
        files(folder.path());
        return;
    }
    let mut own = std::process::Command::new(std::env::current_exe().unwrap());
    let ran = own.args([test, "--exact", "--nocapture"]).env(INNER, "1").output().unwrap();
    let printed = String::from_utf8_lossy(&ran.stdout);
    println!("{printed}");
    let found = printed.contains("1 passed");
    assert!(ran.status.success() && found, "{}: {}", ran.status, String::from_utf8_lossy(&ran.stderr));
}

#[test]
fn small_texts_and_workbooks_never_cost_more_than_a_gibibyte_and_ten_seconds() {
    in_own_process("small_texts_and_workbooks_never_cost_more_than_a_gibibyte_and_ten_seconds", |folder| {
        texts(folder);
        workbooks(folder);
        known();
    });
    // The process above is not a child of cargo, so skipped tests that it reports would not be counted. This process
    // therefore reports them.
    if !Path::new(KNOWN).is_dir() {
        dashpot_test_support::skipped(format!("there is no {KNOWN}"));
    }
}

#[test]
fn small_binary_files_never_cost_more_than_a_gibibyte_and_ten_seconds() {
    in_own_process("small_binary_files_never_cost_more_than_a_gibibyte_and_ten_seconds", |folder| {
        mdf::files(folder);
        hdf5::files(folder);
        rpc(folder);
        tdms(folder);
    });
}

/// Folder of known costly files.
const KNOWN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/hostile");

/// Loads the known costly files, if their folder is available.
fn known() {
    let Ok(entries) = std::fs::read_dir(KNOWN) else { return };
    for entry in entries.flatten().map(|entry| entry.path()).filter(|path| path.extension().is_none_or(|e| e != "md")) {
        let _ = answer(&entry);
    }
}

fn texts(folder: &Path) {
    // These rows of a damper on a sine have ten mebibytes in total.
    let rows: String = (0..560_000_u32)
        .map(|i| {
            let t = 0.001 * f64::from(i);
            format!("{t:.3},{:.1},{:.0}\n", 50.0 * libm::sin(6.0 * t), 1500.0 * libm::cos(6.0 * t))
        })
        .collect();
    std::fs::write(folder.join("rows.csv"), format!("time_s,x_mm,F_N\n{rows}")).unwrap();
    assert_eq!(answer(&folder.join("rows.csv")), Ok(1));
    let short: String = (0..1_700_000_u32).map(|i| format!("{},{},{}\n", i % 10, i / 7 % 5, i % 7)).collect();
    std::fs::write(folder.join("short.csv"), format!("time_s,x_mm,F_N\n{short}")).unwrap();
    let _ = answer(&folder.join("short.csv"));
    rejected(folder, "line.csv", "a,".repeat(5 << 20).as_bytes());
    rejected(folder, "quotes.csv", "\"a\"\"".repeat(5 << 19).as_bytes());
    // The header has many keys, and the heading has many names. The reader would compare each key with each name.
    let head = "LabVIEW Measurement\nSeparator\tTab\nX_Columns\tOne\n***End_of_Header***\n\nChannels\t2\n";
    let keys = "k\tv\n".repeat(400_000);
    let names = "n\t".repeat(400_000);
    rejected(
        folder,
        "keys.lvm",
        format!("{head}{keys}***End_of_Header***\nX_Value\tx_mm\tF_N\t{names}\n0\t1\t2\n").as_bytes(),
    );
    // The long name of a column gives a long note, which would be stored with each of many tests.
    let tests: String = (0..300_000).map(|i| format!("t{i},0.1,1,2\n")).collect();
    let columns = "c".repeat(20_000);
    rejected(folder, "notes.csv", format!("test,time_s,x_mm,F_N,{columns}\n{tests}").as_bytes());
}

fn workbooks(folder: &Path) {
    let heading = "<row r=\"1\"><c t=\"inlineStr\"><is><t>time_s</t></is></c><c t=\"inlineStr\"><is><t>x_mm</t></is></c>\
                   <c t=\"inlineStr\"><is><t>F_N</t></is></c></row>";
    let row = "<row><c><v>1</v></c><c><v>2</v></c><c><v>3</v></c></row>";
    let exhausted = "unpacks to more than a file of its size may";
    let describe = |message: String| assert!(message.contains(exhausted), "{message}");
    describe(rejected(folder, "sheets.xlsx", &workbook(5000, &format!("{heading}{}", row.repeat(200_000)), &[])));
    describe(rejected(folder, "empty.xlsx", &workbook(5000, &"<row/>".repeat(3_000_000), &[])));
    describe(rejected(folder, "list.xlsx", &workbook(2_000_000, "", &[])));
    let long = "x".repeat(30_000);
    let strings = format!("<sst xmlns=\"{MAIN}\"><si><t>{long}</t></si></sst>");
    let cells = "<c t=\"s\"><v>0</v></c>".repeat(1000);
    let shared = ("xl/sharedStrings.xml", strings);
    describe(rejected(
        folder,
        "string.xlsx",
        &workbook(1, &format!("<row>{cells}</row>").repeat(50), &[shared.clone()]),
    ));
    describe(rejected(
        folder,
        "below.xlsx",
        &workbook(1, &format!("{heading}{}", format!("<row>{cells}</row>").repeat(500)), &[shared]),
    ));
    let attributes: String = (0..300_000).map(|k| format!(" a{k}=\"\"")).collect();
    let message = rejected(folder, "attributes.xlsx", &workbook(1, &format!("<row{attributes}></row>"), &[]));
    assert!(message.contains("which no cell can"), "{message}");
    let message = rejected(
        folder,
        "text.xlsx",
        &workbook(1, &format!("<row><c t=\"inlineStr\"><is><t>{}</t></is></c></row>", "y".repeat(200 << 20)), &[]),
    );
    assert!(message.contains("which no cell can"), "{message}");
    let font = format!("<fonts><font><name val=\"{}\"/></font></fonts>", "f".repeat(1 << 19));
    let styles = format!(
        "<styleSheet xmlns=\"{MAIN}\">{font}<cellXfs>{}</cellXfs></styleSheet>",
        "<xf fontId=\"0\"/>".repeat(500_000)
    );
    describe(rejected(folder, "styles.xlsx", &workbook(1, row, &[("xl/styles.xml", styles)])));
    // Every cell has its own row and is in a remote column.
    let far: String = (2..2_000_000).map(|k| format!("<row><c r=\"ALL{k}\"><v>1</v></c></row>")).collect();
    describe(rejected(folder, "far.xlsx", &workbook(1, &format!("{heading}{far}"), &[])));
}

mod mdf {
    use super::rejected;
    use std::path::Path;

    /// An MDF 4 file under construction: consecutive blocks.
    struct File(Vec<u8>);

    impl File {
        fn new() -> File {
            let mut bytes = vec![0; 64];
            bytes[..16].copy_from_slice(b"MDF     4.10    ");
            // The header block comes first. `done` inserts its link to the first data group.
            let mut file = File(bytes);
            file.put(b"HD", &[0; 6], &[0; 32]);
            file
        }

        fn put(&mut self, id: &[u8], links: &[u64], data: &[u8]) -> u64 {
            self.0.resize(self.0.len().next_multiple_of(8), 0);
            let at = self.0.len() as u64;
            let length = (24 + 8 * links.len() + data.len()) as u64;
            self.0.extend(b"##");
            self.0.extend(id);
            self.0.extend([0; 4]);
            self.0.extend(length.to_le_bytes());
            self.0.extend((links.len() as u64).to_le_bytes());
            self.0.extend(links.iter().flat_map(|link| link.to_le_bytes()));
            self.0.extend(data);
            at
        }

        fn text(&mut self, text: &str) -> u64 {
            self.put(b"TX", &[], &[text.as_bytes(), &[0]].concat())
        }

        /// Adds a channel of one byte with links to the next channel, its name and its conversion.
        fn channel(&mut self, next: u64, name: u64, conversion: u64) -> u64 {
            let mut data = [0_u8; 72];
            data[8] = 8;
            self.put(b"CN", &[next, 0, name, 0, conversion, 0, 0, 0], &data)
        }

        /// Adds a group of records of one byte.
        fn group(&mut self, next: u64, channel: u64, id: u64, records: u64) -> u64 {
            let data = [&id.to_le_bytes()[..], &records.to_le_bytes(), &[0; 8], &1_u32.to_le_bytes(), &[0; 4]].concat();
            self.put(b"CG", &[next, channel, 0, 0, 0, 0], &data)
        }

        fn data_group(&mut self, next: u64, group: u64, data: u64, id_size: u8) -> u64 {
            self.put(b"DG", &[next, group, data, 0], &[id_size, 0, 0, 0, 0, 0, 0, 0])
        }

        fn done(mut self, first: u64) -> Vec<u8> {
            self.0[64 + 24..64 + 32].copy_from_slice(&first.to_le_bytes());
            self.0
        }
    }

    pub fn files(folder: &Path) {
        // Thousands of groups share one block of data.
        let mut file = File::new();
        let name = file.text("force");
        let channel = file.channel(0, name, 0);
        let data = file.put(b"DT", &[], &vec![1; 8 << 20]);
        let group = file.group(0, channel, 0, 8 << 20);
        let first = (0..4000).fold(0, |next, _| file.data_group(next, group, data, 0));
        rejected(folder, "data.mf4", &file.done(first));
        // Thousands of groups share one list, which refers many times to one compressed block of data.
        let mut file = File::new();
        let name = file.text("force");
        let channel = file.channel(0, name, 0);
        let plain = vec![1; 8 << 20];
        let mut packer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
        std::io::Write::write_all(&mut packer, &plain).unwrap();
        let packed = packer.finish().unwrap();
        let sizes = [(plain.len() as u64).to_le_bytes(), (packed.len() as u64).to_le_bytes()].concat();
        let packed = file.put(b"DZ", &[], &[b"DT\0\0\0\0\0\0", &sizes[..], &packed].concat());
        let list = file.put(b"DL", &[&[0][..], &[packed; 6]].concat(), &[0; 8]);
        let group = file.group(0, channel, 0, 48 << 20);
        let first = (0..4000).fold(0, |next, _| file.data_group(next, group, list, 0));
        rejected(folder, "list.mf4", &file.done(first));
        // Thousands of groups have the same thousands of channels.
        let mut file = File::new();
        let name = file.text("force");
        let mut channel = 0;
        for _ in 0..4000 {
            channel = file.channel(channel, name, 0);
        }
        let data = file.put(b"DT", &[], &[1; 1000]);
        let mut first = 0;
        for _ in 0..4000 {
            let group = file.group(0, channel, 0, 1000);
            first = file.data_group(first, group, data, 0);
        }
        rejected(folder, "channels.mf4", &file.done(first));
        // Many channels share one long name and one long conversion table.
        let mut file = File::new();
        let name = file.text(&"n".repeat(1 << 20));
        let mut head = [0_u8; 24];
        (head[0], head[6], head[7]) = (4, 0xff, 0xff);
        let table = [&head[..], &vec![0; 8 * 65_535]].concat();
        let conversion = file.put(b"CC", &[0; 4], &table);
        let mut first = 0;
        let data = file.put(b"DT", &[], &[1; 1000]);
        for _ in 0..10 {
            let mut channel = 0;
            for _ in 0..4000 {
                channel = file.channel(channel, name, conversion);
            }
            let group = file.group(0, channel, 0, 1000);
            first = file.data_group(first, group, data, 0);
        }
        rejected(folder, "texts.mf4", &file.done(first));
        // An identification number before each record states its group. Of thousands of groups, only one has records.
        let mut file = File::new();
        let name = file.text("force");
        let channel = file.channel(0, name, 0);
        let data = file.put(b"DT", &[], &[1, 0, 9].repeat(3 << 20));
        let group = (0..4000).rev().fold(0, |next, id| file.group(next, channel, id, 0));
        let first = file.data_group(0, group, data, 2);
        rejected(folder, "numbers.mf4", &file.done(first));
    }
}

mod hdf5 {
    use super::rejected;
    use std::path::Path;

    const LOW: [u8; 8] = [0; 8];
    const NOWHERE: [u8; 8] = [0xff; 8];

    fn messages(all: &[(u16, Vec<u8>)]) -> Vec<u8> {
        let mut out = Vec::new();
        for (kind, data) in all {
            let size = data.len().next_multiple_of(8);
            out.extend(kind.to_le_bytes());
            out.extend((size as u16).to_le_bytes());
            out.extend([0; 4]);
            out.extend(data);
            out.resize(out.len() + size - data.len(), 0);
        }
        let head = [
            &[1, 0][..],
            &(all.len() as u16).to_le_bytes(),
            &1_u32.to_le_bytes(),
            &(out.len() as u32).to_le_bytes(),
            &[0; 4],
        ];
        [head.concat(), out].concat()
    }

    fn doubles(count: u64) -> [(u16, Vec<u8>); 2] {
        let shape = [&[1, 1, 0, 0, 0, 0, 0, 0][..], &count.to_le_bytes()].concat();
        let number = [&[0x11, 0x20, 0x3f, 0][..], &8_u32.to_le_bytes(), &[0; 12]].concat();
        [(1, shape), (3, number)]
    }

    /// Makes a file with `names` links to one object. The argument of `object` is the position of the object.
    fn file(names: usize, object: impl Fn(u64) -> Vec<u8>) -> Vec<u8> {
        let (root, tree, heap) = (96_u64, 200_u64, 300_u64);
        let segment: Vec<u8> = (0..names).flat_map(|k| format!("n{k:05}\0\0").into_bytes()).collect();
        let symbols = heap + 32 + segment.len() as u64;
        let at = symbols + 8 + 40 * names as u64;
        let mut out = b"\x89HDF\r\n\x1a\n\0\0\0\0\0\x08\x08\0\x04\0\x10\0\0\0\0\0".to_vec();
        out.extend([LOW, NOWHERE, NOWHERE, NOWHERE, LOW].concat());
        out.extend(root.to_le_bytes());
        out.resize(root as usize, 0);
        out.extend(messages(&[(0x11, [tree.to_le_bytes(), heap.to_le_bytes()].concat())]));
        out.resize(tree as usize, 0);
        out.extend(b"TREE\0\0\x01\0");
        out.extend([NOWHERE, NOWHERE, LOW, symbols.to_le_bytes(), LOW].concat());
        out.resize(heap as usize, 0);
        out.extend(b"HEAP\0\0\0\0");
        out.extend([(segment.len() as u64).to_le_bytes(), NOWHERE, (heap + 32).to_le_bytes()].concat());
        out.extend(segment);
        out.extend(b"SNOD\x01\0");
        out.extend((names as u16).to_le_bytes());
        for k in 0..names as u64 {
            out.extend([(8 * k).to_le_bytes(), at.to_le_bytes(), LOW, LOW, LOW].concat());
        }
        out.extend(object(at));
        out
    }

    /// Makes a chunked data set of doubles, optionally deflated, followed by its tree.
    fn chunked(count: u64, chunk: u32, deflated: bool, at: u64, tree: impl Fn(u64) -> Vec<u8>) -> Vec<u8> {
        let [shape, number] = doubles(count);
        let layout = |tree: u64| {
            let sizes = [chunk.to_le_bytes(), 8_u32.to_le_bytes()].concat();
            (8, [&[3, 2, 2][..], &tree.to_le_bytes(), &sizes].concat())
        };
        let mut all = vec![shape, number, layout(0)];
        all.extend(deflated.then(|| {
            (0x0b, [&[1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0][..], &[6, 0, 0, 0, 0, 0, 0, 0]].concat())
        }));
        let below = at + messages(&all).len() as u64;
        all[2] = layout(below);
        [messages(&all), tree(below)].concat()
    }

    fn node(level: u8, stored: u32, children: &[u64]) -> Vec<u8> {
        let mut out = [&b"TREE\x01"[..], &[level], &(children.len() as u16).to_le_bytes(), &NOWHERE, &NOWHERE].concat();
        for child in children {
            out.extend([&stored.to_le_bytes()[..], &[0; 20], &child.to_le_bytes()].concat());
        }
        out.extend([0; 24]);
        out
    }

    pub fn files(folder: &Path) {
        // In this tree, each level refers twice to the next level, which gives 2³⁰ paths.
        let dag = |first: u64| -> Vec<u8> {
            let length = node(1, 0, &[0, 0]).len() as u64;
            let levels = (0..30).flat_map(|k| node(30 - k, 0, &[first + length * (u64::from(k) + 1); 2]));
            levels.chain(node(0, 0, &[])).collect()
        };
        let message = rejected(folder, "tree.mat", &file(1, |at| chunked(1000, 100, false, at, dag)));
        assert!(message.contains("twice to the same node"), "{message}");
        // A tree lists one chunk of zeros thousands of times.
        let mut packer = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
        std::io::Write::write_all(&mut packer, &vec![0; 32 << 20]).unwrap();
        let packed = packer.finish().unwrap();
        let many = |first: u64| {
            let length = node(0, 0, &[0; 3000]).len() as u64;
            [node(0, packed.len() as u32, &[first + length; 3000]), packed.clone()].concat()
        };
        rejected(folder, "chunk.mat", &file(1, |at| chunked(1000, 4 << 20, true, at, many)));
        // Thousands of names refer to one data set. In the second file, a data set of 2⁴⁰ numbers was never written.
        let set = |at: u64| -> Vec<u8> {
            let [shape, number] = doubles(1 << 20);
            let layout = |data: u64| (8, [&[3, 1][..], &data.to_le_bytes(), &(8_u64 << 20).to_le_bytes()].concat());
            let size = messages(&[shape.clone(), number.clone(), layout(0)]).len() as u64;
            [messages(&[shape, number, layout(at + size)]), vec![0; 8 << 20]].concat()
        };
        rejected(folder, "names.mat", &file(4000, set));
        let nothing = |_: u64| {
            let [shape, number] = doubles(1 << 40);
            messages(&[shape, number, (8, [&[3, 1][..], &NOWHERE, &LOW].concat())])
        };
        rejected(folder, "nothing.mat", &file(1, nothing));
        // The continuation of this header is the header itself.
        let circle = |at: u64| messages(&[(0x10, [(at + 16).to_le_bytes(), 24_u64.to_le_bytes()].concat())]);
        rejected(folder, "circle.mat", &file(1, circle));
    }
}

fn rpc(folder: &Path) {
    let file = |changes: &[(&str, &str)]| {
        let mut entries = vec![
            ("FORMAT", "BINARY_IEEE_LITTLE_END"),
            ("NUM_HEADER_BLOCKS", "4"),
            ("FILE_TYPE", "TIME_HISTORY"),
            ("DELTA_T", "1.0e-2"),
            ("PTS_PER_FRAME", "120"),
            ("CHANNELS", "2"),
            ("PTS_PER_GROUP", "120"),
            ("FRAMES", "1"),
            ("DATA_TYPE", "FLOATING_POINT"),
        ];
        for entry in &mut entries {
            entry.1 = changes.iter().find(|(key, _)| *key == entry.0).map_or(entry.1, |(_, value)| value);
        }
        let mut out = vec![0; 2048 + 960];
        for (k, (key, value)) in entries.iter().enumerate() {
            out[128 * k..128 * k + key.len()].copy_from_slice(key.as_bytes());
            out[128 * k + 32..128 * k + 32 + value.len()].copy_from_slice(value.as_bytes());
        }
        out
    };
    for zero in [&[][..], &[("FRAMES", "0")], &[("PTS_PER_FRAME", "0")], &[("PTS_PER_GROUP", "0")]] {
        for (key, count) in [
            ("CHANNELS", "18446744073709551615"),
            ("CHANNELS", "100000000"),
            ("PTS_PER_GROUP", "18446744073709551615"),
            ("FRAMES", "9223372036854775808"),
            ("NUM_HEADER_BLOCKS", "18446744073709551615"),
        ] {
            rejected(folder, "counts.rsp", &file(&[zero, &[(key, count)]].concat()));
        }
    }
}

fn tdms(folder: &Path) {
    let segment = |flags: u32, meta: &[u8], raw: &[u8]| {
        let (next, data) = ((meta.len() + raw.len()) as u64, meta.len() as u64);
        [
            &b"TDSm"[..],
            &flags.to_le_bytes(),
            &4713_u32.to_le_bytes(),
            &next.to_le_bytes(),
            &data.to_le_bytes(),
            meta,
            raw,
        ]
        .concat()
    };
    let objects = |count: u32, values: u64| -> Vec<u8> {
        let mut out = count.to_le_bytes().to_vec();
        for k in 0..count {
            let path = format!("/'g'/'c{k}'");
            out.extend((path.len() as u32).to_le_bytes());
            out.extend(path.bytes());
            // The data are single bytes in one dimension, with the stated number of values. The object has no
            // properties.
            out.extend(20_u32.to_le_bytes());
            out.extend([5_u32.to_le_bytes(), 1_u32.to_le_bytes()].concat());
            out.extend(values.to_le_bytes());
            out.extend(0_u32.to_le_bytes());
        }
        out
    };
    // Many segments refer to the long list of channels of an earlier segment.
    let first = segment(0b1110, &objects(16_000, 1), &[]);
    let again = segment(0b1000, &[], &[]);
    rejected(folder, "segments.tdms", &[first.clone(), again.repeat(300_000)].concat());
    // Each segment lists all objects again.
    let named = segment(0b1010, &objects(16_000, 1)[..], &[]);
    rejected(folder, "objects.tdms", &[first, named.repeat(12)].concat());
    // Of 16 000 channels, only one has values. Each chunk consists of one byte.
    let mut meta = objects(16_000, 0);
    let last = meta.len() - 12;
    meta[last..last + 8].copy_from_slice(&1_u64.to_le_bytes());
    rejected(folder, "chunks.tdms", &segment(0b1110, &meta, &vec![1; 9 << 20]));
    let interleaved = segment(0b10_1110, &objects(16_000, 1), &vec![1; 9 << 20]);
    let _ = std::fs::write(folder.join("turns.tdms"), &interleaved);
    let _ = answer(&folder.join("turns.tdms"));
}
