//! Text files with the layouts of test rigs, testing machines and loggers.
//!
//! All contain the same motion and force, so all must give the same data.

use dashpot_records::{Campaign, Options, load};
use std::f64::consts::TAU;
use std::path::Path;

const AMPLITUDE: f64 = 0.02;
const FREQUENCY: f64 = 2.0;
const SAMPLES: usize = 2500;
const STEP: f64 = 0.001;

/// Returns time, s, displacement, m, and force, N, of a damper with a gas force of 90 N.
fn truth(sample: usize) -> (f64, f64, f64) {
    let t = sample as f64 * STEP;
    let v = AMPLITUDE * TAU * FREQUENCY * libm::cos(TAU * FREQUENCY * t);
    let f = if v > 0.0 { 4000.0 } else { 2000.0 } * v / (1.0 + v.abs()) - 90.0;
    (t, AMPLITUDE * libm::sin(TAU * FREQUENCY * t), f)
}

/// Formats the rows of a file. `row` receives the number of the sample, time in s, displacement in mm and force in N.
fn rows(row: impl Fn(usize, f64, f64, f64) -> String) -> String {
    (0..SAMPLES)
        .map(|k| {
            let (t, x, f) = truth(k);
            row(k, t, 1e3 * x, f) + "\n"
        })
        .collect()
}

fn comma(text: &str) -> String {
    text.replace('.', ",")
}

/// Formats rows of time in s, displacement in mm and force in N with a delimiter and decimal points.
fn plain(delimiter: &str) -> String {
    rows(|_, t, x, f| format!("{t:.4}{delimiter}{x:.5}{delimiter}{f:.4}"))
}

fn read(name: &str, bytes: &[u8], options: &Options) -> Result<Campaign, String> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(name), bytes).unwrap();
    // Read a folder, the form in which a laboratory delivers data.
    load(&[folder.path().to_owned()], options, &|_| ()).map_err(|e| e.to_string())
}

/// Reads a file and compares its record with the motion and force of `truth`.
fn check(what: &str, name: &str, bytes: &[u8], options: &Options) -> Campaign {
    let campaign = read(name, bytes, options).unwrap_or_else(|e| panic!("{what}: {e}"));
    assert_eq!(campaign.records.len(), 1, "{what}");
    let record = &campaign.records[0];
    // Cleaning removes the run-up and half cycles, so displacement and direction identify the samples.
    let (mut worst, mut extreme) = (0.0_f64, 0.0_f64);
    for ((x, v), f) in record.displacement.iter().zip(&record.velocity).zip(&record.force) {
        let phase = if *v >= 0.0 {
            libm::asin((x / AMPLITUDE).clamp(-1.0, 1.0))
        } else {
            TAU / 2.0 - libm::asin((x / AMPLITUDE).clamp(-1.0, 1.0))
        };
        let speed = AMPLITUDE * TAU * FREQUENCY * libm::cos(phase);
        let wanted = if speed > 0.0 { 4000.0 } else { 2000.0 } * speed / (1.0 + speed.abs()) - 90.0;
        // Near the ends of the stroke, a small error of the displacement changes the computed phase strongly.
        if (x / AMPLITUDE).abs() < 0.95 {
            worst = worst.max((f - wanted).abs());
        }
        extreme = extreme.max(x.abs());
    }
    assert!(worst < 3.0, "{what}: force is off by {worst} N");
    assert!((extreme - AMPLITUDE).abs() < 2e-5, "{what}: amplitude {extreme} m");
    let times = &record.time;
    let length = times[times.len() - 1] - times[0];
    assert!((length - (times.len() - 1) as f64 * STEP).abs() < 1e-6, "{what}: {length} s");
    campaign
}

fn check_text(what: &str, name: &str, text: &str) -> Campaign {
    check(what, name, text.as_bytes(), &Options::default())
}

fn notes(campaign: &Campaign) -> String {
    let all = campaign.notes.iter().chain(campaign.records.iter().flat_map(|r| &r.notes));
    all.map(|n| n.text.to_string()).collect::<Vec<_>>().join("\n")
}

#[test]
fn files_of_mts_stations_in_their_three_forms() {
    let tabs = "MTS793|MPT|DEU|1|2|,|.|:|49|1|1|A\r\n\r\nDatenerfassung: Zeitgesteuert\t\t\tZeit:\t12,034\tSek\t01.09.2014 13:25:39\r\n\
                Stationsname:\tD1.cfg\r\nZeit\tAchse-2 Weg\tAchse-2 Kraft Filter\r\nSek\tmm\tkN\r\n"
        .to_owned()
        + &rows(|_, t, x, f| comma(&format!("{t:.5}\t{x:.5}\t{:.7}\r", f / 1e3)));
    check_text("tabs, German", "specimen.dat", &tabs);
    let commas = "\"MTS793|BTW|ENU|1|1|.|/|:|1|0|0|A\"\n\n\"Data Header:\",,,\"Time:\",12.3,\"Sec\",\"3/29/2016 1:54:32 PM\"\n\
                  \"Data Acquisition: Timed\"\n\"Running Time\",\"Axial Displacement\",\"Axial Force\",\"Axial Count\"\n\
                  \"Sec\",\"mm\",\"N\",\"cycles\"\n"
        .to_owned()
        + &rows(|_, t, x, f| format!("{t:.4},{x:.5},{f:.4},{}", (t * FREQUENCY) as usize));
    check_text("commas", "specimen.dat", &commas);
    // In the plain form of MTS files, a single blank separates names that are wider than their columns.
    let blanks =
        "MTS793|MPT|ENU|1|0|.|/|:|1|0|0|A\n\nData Acquisition: Timed\nStation Name: EML.cfg\nTest File Name: d.000\n\
                  Time      Axial Force Axial Displacement Axial Count\ns         N         mm       cycles\n"
            .to_owned()
            + &rows(|_, t, x, f| format!("{t:.4}    {f:.4} {x:.5}  0"));
    check_text("blanks", "specimen.dat", &blanks);
}

#[test]
fn exports_of_testing_machines() {
    let zwick = "\"Prüfzeit\";\"Standardweg\";\"Standardkraft\"\r\n\"s\";\"mm\";\"N\"\r\n".to_owned()
        + &rows(|_, t, x, f| comma(&format!("{t:.4};{x:.5};{f:.4}\r")));
    let latin: Vec<u8> = zwick.chars().map(|c| c as u8).collect();
    check("testXpert", "d.TRA", &latin, &Options::default());
    let instron =
        "\"Total Time (s)\",\"Cycle Elapsed Time (s)\",\"Total Cycles\",\"Position(Linear:Digital Position) (mm)\",\
                   \"Load(Linear:Load) (kN)\"\n"
            .to_owned()
            + &rows(|_, t, x, f| format!("{t:.4},{:.4},{},{x:.5},{:.7}", t % 0.5, (t * 2.0) as usize, f / 1e3));
    check_text("WaveMatrix", "d.csv", &instron);
    let bluehill = "Specimen label,\"D7\"\n\nTime,Extension,Load\n(sec),(mm),(N)\n".to_owned()
        + &rows(|_, t, x, f| format!("\"{t:.5}\",\"{x:.5}\",\"{f:.5}\""));
    check_text("Bluehill", "d.csv", &bluehill);
}

#[test]
fn exports_of_loggers_with_names_of_sensors_and_rates_below_the_heading() {
    let catman = "HBM_CATMAN ASCII\nKanäle: 3\n\nZeit 1 - Standardmessrate\tWeg\tKraft\ns\tmm\tkN\nSR=1000Hz\tSR=1000Hz\tSR=1000Hz\n"
        .to_owned()
        + &rows(|_, t, x, f| comma(&format!("{t:.4}\t{x:.5}\t{:.7}", f / 1e3)));
    let told = notes(&check_text("catman", "d.asc", &catman));
    assert!(told.contains("line 6, below the heading, holds no figures: 'SR=1000Hz"), "{told}");
    let english =
        "File:\tx\nTime  1 - default sample rate [s]\tDisplacement [mm]\tForce [N]\n".to_owned() + &plain("\t");
    check_text("catman, English", "d.txt", &english);
    let sensors = "Zeit;Weg/AI 1;Kraft/AI 2\ns;mm;N\nZeitkanal;LVDT 1;U9B\n".to_owned() + &comma(&plain(";"));
    check_text("sensors below units", "d.csv", &sensors);
    // Six lines of text below the heading are too many for labels, so the file is rejected.
    let text = "Time [s],x [mm],F [N]\n".to_owned() + &"some,more,text\n".repeat(6) + &plain(",");
    assert!(read("d.csv", text.as_bytes(), &Options::default()).unwrap_err().contains("'some' is no number"));
}

#[test]
fn what_stands_below_a_table_is_told_and_not_read() {
    let table = "Time [s],Displacement [mm],Force [N]\n".to_owned() + &plain(",");
    let foot = "\nMax,,20.0\nMin,,-20.0\nEnd of test\n";
    let told = notes(&check_text("results", "d.csv", &(table.clone() + foot)));
    assert!(told.contains("from line 2503 on, below the table, not read: 'Max 20.0'"), "{told}");
    // If rows of numbers follow the text, the text is an error.
    let broken = read("d.csv", (table + foot + &plain(",")).as_bytes(), &Options::default()).unwrap_err();
    assert!(broken.contains("line 2503") && broken.contains("'Max' is no number"), "{broken}");
}

#[test]
fn numbers_as_programs_write_them() {
    let quoted = "\"Zeit [s]\",\"Weg [mm]\",\"Kraft [N]\"\n".to_owned()
        + &rows(|_, t, x, f| comma(&format!("\"{t:.4}\"|\"{x:.5}\"|\"{f:.4}\"")).replace('|', ","));
    check_text("decimal commas in quotes", "d.csv", &quoted);
    let minus = ("Time (s),Displacement (mm),Force (N)\n".to_owned() + &plain(",")).replace('-', "\u{2212}");
    check_text("a typesetter's minus", "d.csv", &minus);
    let exponents = "Time [s]   Displacement [mm]   Force [N]\n".to_owned()
        + &rows(|_, t, x, f| format!(" {t:.5E}   {x:.6E}   {f:.6E}").replace('E', "D"));
    check_text("Fortran", "d.dat", &exponents);
    // In this file, the blank that replaces a plus sign is the only separator between two columns of numbers.
    let fixed = "    Time    Displ    Force\n       s       mm        N\n".to_owned()
        + &rows(|_, t, x, f| format!("{t:8.4} {x:8.5} {f:9.4}"));
    check_text("columns of fixed width", "d.asc", &fixed);
    let returns = ("Time (s),Displacement (mm),Force (N)\n".to_owned() + &plain(",")).replace('\n', "\r");
    check_text("returns alone", "d.csv", &returns);
    check_text("bars", "d.txt", &("Time [s]|Displacement [mm]|Force [N]\n".to_owned() + &plain("|")));
    let thousands = "Zeit [s];Weg [mm];Kraft [N]\n0,0;0,0;1.234,5\n0,1;0,1;1.234,5\n";
    let refused = read("d.csv", thousands.as_bytes(), &Options::default()).unwrap_err();
    assert!(refused.contains("without thousands separators"), "{refused}");
}

#[test]
fn headings_behind_a_comment_mark() {
    let spaced = "# Time(s) Displacement(mm) Force(N)\n".to_owned() + &plain(" ");
    check_text("units in the heading", "d.dat", &spaced);
    let below = "% damper 7\n% t, x, F\n% s, mm, N\n".to_owned() + &plain(",");
    check_text("units below", "d.txt", &below);
    // A valid heading has precedence over a comment.
    let both =
        "# Time [ms], Displacement [in], Force [N]\nTime [s],Displacement [mm],Force [N]\n".to_owned() + &plain(",");
    check_text("a heading and a comment", "d.csv", &both);
}

#[test]
fn files_without_a_column_of_time() {
    let table = |above: &str| {
        above.to_owned() + "Displacement [mm]\tForce [N]\n" + &rows(|_, _, x, f| format!("{x:.6}\t{f:.4}"))
    };
    for above in [
        "Sample Rate: 1000 Hz\n",
        "Abtastrate\t1,0 kHz\n",
        "dt [ms]\t1,0\n",
        "Sampling frequency = 1000\n",
        "Sample time: 0.001 s\n",
    ] {
        check_text(above, "d.txt", &table(above));
    }
    let numbered = "CTW Probe 4.0,,\nRun,1,\nSample,Displacement (in),Force (lb)\n".to_owned()
        + &rows(|k, _, x, f| format!("{k},{:.7},{:.6}", x / 25.4, f / 4.448_221_615_260_5));
    let message = read("d.csv", numbered.as_bytes(), &Options::default()).unwrap_err();
    assert!(message.contains("no column for time") && message.contains("--sample-rate"), "{message}");
    let options = Options { sample_rate_hz: Some(1.0 / STEP), ..Options::default() };
    check("rate by the user", "d.csv", numbered.as_bytes(), &options);
}

#[test]
fn times_and_units_of_other_countries() {
    let elapsed = "Elapsed Time,Displacement (mm),Force (N)\n".to_owned()
        + &rows(|_, t, x, f| format!("59:{:06.3},{x:.5},{f:.4}", 12.0 + t));
    check_text("minutes and seconds", "d.csv", &elapsed);
    let kips = "Time (s),Disp (in),Load (kip)\n".to_owned()
        + &rows(|_, t, x, f| format!("{t:.4},{:.7},{:.9}", x / 25.4, f / 4_448.221_615_260_5));
    check_text("kip", "d.csv", &kips);
    let kilograms =
        "Time(s),Stroke(mm),Load(Kg)\n".to_owned() + &rows(|_, t, x, f| format!("{t:.4},{x:.5},{:.6}", f / 9.80665));
    check_text("kg", "d.csv", &kilograms);
}

#[test]
fn labview_files_lie_in_a_folder_like_others() {
    let text = "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nMulti_Headings\tNo\nX_Columns\tOne\n***End_of_Header***\t\n\t\n\
                Channels\t2\nSamples\t2500\t2500\nY_Unit_Label\tmm\tN\nX_Dimension\tTime\tTime\nX0\t0.0E+0\t0.0E+0\n\
                Delta_X\t0.001\t0.001\n***End_of_Header***\t\t\nX_Value\tDisplacement\tForce\tComment\n"
        .to_owned()
        + &plain("\t");
    check_text("LabVIEW", "d.lvm", &text);
    check_text("LabVIEW, renamed", "d.txt", &text);
    assert!(dashpot_records::is_record_name(Path::new("D.LVM")));
}
