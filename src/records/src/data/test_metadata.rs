//! Metadata of a test in the lines above its table, such as the part on the rig and the tester.

use crate::quantities::unit::plain;
use serde::{Deserialize, Serialize};

/// Metadata of a test, as written in the file.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct TestMetadata {
    /// Number or name of the part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// Serial number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub serial: Option<String>,
    /// Name of the tester.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tester: Option<String>,
    /// Name of the rig.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rig: Option<String>,
}

/// Names of the entry that states the part: without accents, in lower case, with blanks between the words. The lists of
/// the names of other entries have the same form.
const PART: &[&str] = &[
    "part",
    "part no",
    "part nr",
    "part number",
    "damper",
    "specimen",
    "component",
    "teil",
    "teil nr",
    "teilenummer",
    "teilenr",
    "teile nr",
    "sachnummer",
    "bauteil",
    "prufling",
    "artikel",
    "artikelnummer",
    "artikelnr",
    "dampfer",
    "piece",
    "reference",
    "numero de piece",
    "ref piece",
    "eprouvette",
    "amortisseur",
    "零件",
    "零件号",
    "零件编号",
    "产品",
    "产品编号",
    "图号",
    "试件",
    "减振器",
];
const SERIAL: &[&str] = &[
    "serial",
    "serial no",
    "serial nr",
    "serial number",
    "s/n",
    "sn",
    "seriennummer",
    "seriennr",
    "serien nr",
    "numero de serie",
    "n de serie",
    "no de serie",
    "序列号",
    "出厂编号",
];
const TESTER: &[&str] = &[
    "tester",
    "tested by",
    "operator",
    "engineer",
    "technician",
    "prufer",
    "bediener",
    "bearbeiter",
    "gepruft von",
    "operateur",
    "essayeur",
    "technicien",
    "teste par",
    "操作员",
    "操作者",
    "试验员",
    "检验员",
    "测试人",
    "测试人员",
];
const RIG: &[&str] = &[
    "rig",
    "test rig",
    "test bench",
    "bench",
    "test machine",
    "prufstand",
    "prufmaschine",
    "banc",
    "banc d essai",
    "machine d essai",
    "试验台",
    "台架",
    "试验机",
];

/// Longest entry, characters. A longer text is not a name.
const LONGEST: usize = 80;

impl TestMetadata {
    /// Reads the metadata from the lines above a table.
    pub(crate) fn of_lines<'a>(lines: impl Iterator<Item = &'a str>) -> TestMetadata {
        let mut about = TestMetadata::default();
        for line in lines {
            let line = line.trim_start().trim_start_matches(['#', '%', '/']).trim();
            // If another separator follows the name, a comma may belong to the value.
            let separator = line.chars().find(|c| "\t;:=|".contains(*c)).unwrap_or(',');
            if let Some((name, value)) = line.split_once(separator) {
                let value = value.split(['\t', ';']).map(unquoted).find(|cell| !cell.is_empty());
                about.take(unquoted(name), value.unwrap_or_default());
            }
        }
        about
    }

    /// Reads the metadata from a row above the table of a workbook.
    ///
    /// The value is in the next nonempty cell, or in the same cell as the name.
    pub(crate) fn of_row(&mut self, cells: impl Iterator<Item = String>) {
        let cells: Vec<String> = cells.filter(|cell| !cell.trim().is_empty()).collect();
        match &cells[..] {
            [one] => {
                if let Some((name, value)) = one.split_once([':', '=']) {
                    self.take(name, value.trim());
                }
            }
            [name, value, ..] => self.take(name.trim_end_matches([':', '=', ' ']), value.trim()),
            [] => {}
        }
    }

    /// Stores an entry, unless a previous one exists.
    fn take(&mut self, name: &str, value: &str) {
        if value.is_empty() || value.chars().count() > LONGEST {
            return;
        }
        let name = plain(name).to_lowercase().replace(['_', '-', '.', '\'', '’'], " ");
        let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
        for (names, place) in
            [(PART, &mut self.part), (SERIAL, &mut self.serial), (TESTER, &mut self.tester), (RIG, &mut self.rig)]
        {
            if names.contains(&name.as_str()) && place.is_none() {
                *place = Some(value.to_owned());
            }
        }
    }

    /// Returns whether there are no entries.
    pub fn is_empty(&self) -> bool {
        *self == TestMetadata::default()
    }
}

fn unquoted(cell: &str) -> &str {
    cell.trim().trim_matches('"').trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn part_serial_tester_and_rig_are_told_in_every_language() {
        let german = "Prüfstand;PS 3 - MTS 25 kN\r\nPrüfer;K. Brandt\r\nTeil;8K0 513 035 A\r\nDatum;23.11.2026\r\nSerien-Nr.;0042";
        let about = TestMetadata::of_lines(german.lines());
        let some = |text: &str| Some(text.to_owned());
        let told = TestMetadata {
            part: some("8K0 513 035 A"),
            serial: some("0042"),
            tester: some("K. Brandt"),
            rig: some("PS 3 - MTS 25 kN"),
        };
        assert_eq!(about, told);
        let french = TestMetadata::of_lines("# Pièce : 12,5 A\n# Opérateur : M. Petit\n".lines());
        assert_eq!((french.part, french.tester), (some("12,5 A"), some("M. Petit")));
        let english = TestMetadata::of_lines("\"Part Number\",\"A-17\"\nS/N: 9\n".lines());
        assert_eq!((english.part, english.serial), (some("A-17"), some("9")));
        assert_eq!(TestMetadata::of_lines("零件号\t4711\n".lines()).part, some("4711"));
        // A sentence that begins with the name of an entry is not an entry. A name without a value is not an entry
        // either.
        assert!(TestMetadata::of_lines("Part of the campaign: 3\nTeil;;\n".lines()).is_empty());
        let mut row = TestMetadata::default();
        row.of_row(["Teil:", "", "4711"].map(str::to_owned).into_iter());
        row.of_row(["Prüfer: K. Brandt".to_owned()].into_iter());
        assert_eq!((row.part, row.tester), (some("4711"), some("K. Brandt")));
    }
}
