//! Reproducible random damage to files, of kinds that often cause failures of file readers.
//!
//! `src/records/tests/hostile.rs` includes this file to damage records.

/// Random number generator (xorshift64*; Vigna 2016).
pub struct Random(pub u64);

impl Random {
    /// Returns a number from 0 to below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % n.max(1)
    }
}

/// Returns the number of damaged files of a test: `usual`, multiplied by the environment variable DASHPOT_HOSTILE if it is set for a long
/// run.
///
/// # Panics
/// If the variable is not a number.
pub fn rounds(usual: usize) -> usize {
    usual * std::env::var("DASHPOT_HOSTILE").map_or(1, |times| times.parse().expect("DASHPOT_HOSTILE is a number"))
}

/// Stores a valid file for the fuzzer (`tests/fuzz`) in the folder that the environment variable DASHPOT_SEEDS names.
///
/// One target of the fuzzer reads all small tables and selects the reader by the first byte. The function writes this byte before a table.
/// `place` makes the file's name unique. Without the variable, nothing is stored.
///
/// # Panics
/// If the folder is not writable.
pub fn keep_for_fuzzer(name: &str, place: usize, bytes: &[u8]) {
    const TABLES: [&str; 7] =
        ["campaign.toml", "limits.csv", "peaks.csv", "matrix.csv", "motion.csv", "car.toml", "dimensions.toml"];
    let Some(folder) = std::env::var_os("DASHPOT_SEEDS") else { return };
    let kind = TABLES.iter().position(|table| *table == name);
    let target = match name.rsplit('.').next().unwrap_or_default() {
        _ if kind.is_some() => "settings",
        "toml" => "model",
        "dpr" | "adm" => "adams",
        "mf4" | "mdf" => "mdf",
        "rsp" => "rpc",
        "csv" | "txt" | "tsv" | "asc" | "dat" | "tra" | "lvm" => "text",
        other => other,
    };
    let folder = std::path::Path::new(&folder).join(target);
    std::fs::create_dir_all(&folder).unwrap();
    let whole = [kind.map(|kind| vec![kind as u8]).unwrap_or_default(), bytes.to_vec()].concat();
    std::fs::write(folder.join(format!("{place}-{name}")), whole).unwrap();
}

/// Words that often cause failures of file readers. They are limits of number types, addresses of the last cell of a worksheet, quotes,
/// terminal escapes, and characters outside ASCII.
const POISON: [&[u8]; 32] = [
    b"4294967295",
    b"18446744073709551615",
    b"-1",
    b"1e308",
    b"-1e308",
    b"1e-320",
    b"nan",
    b"inf",
    b"\"",
    b"'",
    b"\0",
    b"\n",
    b",",
    b";",
    b"\t",
    b"\x1b[31m",
    b"XFD1048576",
    b"\xff\xfe",
    b"\xf0\x9f\x92\xa9",
    b"99:99:99",
    b"<row r=\"0\">",
    b"&#0;",
    b"[",
    b"]",
    b"{",
    b"}",
    b"(",
    b"=",
    b"#",
    b"9223372036854775808",
    b"0",
    b"[[[[[[[[[[[[[[[[",
];

/// Damages the bytes of a file in one to three positions. Changes bytes, truncates the file, inserts words of `POISON`, overwrites bytes
/// with such words, repeats or removes parts.
pub fn mutate(random: &mut Random, bytes: &mut Vec<u8>) {
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len());
        match random.below(6) {
            0 if !bytes.is_empty() => bytes[at] = random.below(256) as u8,
            1 => bytes.truncate(at),
            2 => {
                let word = POISON[random.below(POISON.len())];
                bytes.splice(at..at, word.iter().copied());
            }
            3 => {
                let word = POISON[random.below(POISON.len())];
                let end = (at + word.len()).min(bytes.len());
                bytes.splice(at..end, word.iter().copied());
            }
            4 => {
                let end = (at + random.below(200)).min(bytes.len());
                let part = bytes[at..end].to_vec();
                let to = random.below(bytes.len());
                bytes.splice(to..to, part);
            }
            _ => {
                let end = (at + random.below(60)).min(bytes.len());
                bytes.drain(at..end);
            }
        }
    }
}

/// Damages words or lines of a text in one to three positions.
///
/// Unexpected numbers replace numbers, words replace other words, and lines are repeated, removed or exchanged. The result still resembles
/// a valid file, so a parser processes more of it than of a file with damaged bytes.
pub fn mutate_text(random: &mut Random, text: &mut String) {
    const NUMBERS: [&str; 18] = [
        "0",
        "-0.0",
        "1",
        "-1",
        "2",
        "1e308",
        "-1e308",
        "1e-320",
        "nan",
        "inf",
        "-inf",
        "4294967296",
        "9223372036854775807",
        "18446744073709551615",
        "0x10",
        "1_000",
        "1,5",
        "",
    ];
    for _ in 0..=random.below(3) {
        if random.below(3) == 0 {
            let mut lines: Vec<&str> = text.split('\n').collect();
            let (a, b) = (random.below(lines.len()), random.below(lines.len()));
            match random.below(3) {
                0 => lines.swap(a, b),
                1 => lines.insert(b, lines[a]),
                _ => drop(lines.remove(a)),
            }
            *text = lines.join("\n");
            continue;
        }
        let words = words(text);
        if words.is_empty() {
            return;
        }
        let (a, b) = (words[random.below(words.len())].clone(), words[random.below(words.len())].clone());
        let other = text[b].to_owned();
        let is_number = text[a.clone()].parse::<f64>().is_ok();
        let new = if is_number && random.below(4) > 0 { NUMBERS[random.below(NUMBERS.len())] } else { &other };
        text.replace_range(a, new);
    }
}

/// Returns the positions of the words and numbers in a text.
fn words(text: &str) -> Vec<std::ops::Range<usize>> {
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '.' | '_' | '-' | '+');
    let mut words: Vec<std::ops::Range<usize>> = Vec::new();
    for (at, c) in text.char_indices().filter(|(_, c)| is_part(*c)) {
        match words.last_mut() {
            Some(word) if word.end == at => word.end += c.len_utf8(),
            _ => words.push(at..at + c.len_utf8()),
        }
    }
    words
}
