//! Tests of all readers of text files, except those of records, with damaged or malicious texts.
//!
//! Each text must be read, or rejected with a message, in bounded time. The tests also use the data that were read,
//! because an accepted file must not cause a failure of later steps.
//!
//! `src/records/tests/hostile.rs` tests the readers of records, `tests/tests/system/hosts/damaged.rs` the readers in C.
//! DASHPOT_HOSTILE=100 multiplies the number of texts by a hundred.

use dashpot_core::parameter::Element;
use dashpot_core::{Params, model_file as kernel};
use dashpot_hosts::adams::patch::{Damper, patch};
use dashpot_hosts::adams::property;
use dashpot_identification::literature::observation::{self, SampledMotion};
use dashpot_identification::literature::{Literature, file as literature};
use dashpot_identification::model_file;
use dashpot_identification::{limits, model_file::prepared};
use dashpot_records::{Options, PeakOptions, Record, load, profile, read_motion, read_peaks};
use dashpot_rig::Matrix;
use dashpot_simulation::vehicle::Car;
use dashpot_tests::hostile::{Random, keep_for_fuzzer, mutate, mutate_text, rounds};
use std::f64::consts::TAU;
use std::path::Path;
use std::time::{Duration, Instant};

/// Number of damaged texts that are made from each valid text.
const ROUNDS: usize = 1500;
/// Longest time in which a text must be read or rejected. It is long for texts of a few kilobytes, because other
/// programs may run in parallel.
const PATIENCE: Duration = Duration::from_secs(20);

/// A reader of a file; the error is the user's message.
type Reader<'a> = &'a dyn Fn(&Path, &[u8]) -> Result<(), String>;

/// Damages each valid text of `seeds` at random [`ROUNDS`] times, and passes the results to `reader`. `name` is the
/// name of the file.
fn every_damage_is_read_or_refused(name: &str, seeds: &[String], reader: Reader<'_>) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    let mut random = Random(11);
    let (mut read, mut refused) = (0, 0);
    for (place, seed) in seeds.iter().enumerate() {
        keep_for_fuzzer(name, place, seed.as_bytes());
        let sound = reader(&file, seed.as_bytes());
        assert_eq!(sound, Ok(()), "the seed of {name} itself is sound:\n{seed}");
        for round in 0..rounds(ROUNDS) {
            let bytes = if round % 3 == 0 {
                let mut bytes = seed.clone().into_bytes();
                mutate(&mut random, &mut bytes);
                bytes
            } else {
                let mut text = seed.clone();
                mutate_text(&mut random, &mut text);
                text.into_bytes()
            };
            let began = Instant::now();
            match reader(&file, &bytes) {
                Ok(()) => read += 1,
                Err(words) => {
                    refused += 1;
                    assert!(!words.trim().is_empty() && words.len() < 20_000, "{name}: {words:.300}");
                }
            }
            let text = String::from_utf8_lossy(&bytes);
            assert!(began.elapsed() < PATIENCE, "{name} took {:?}:\n{text}", began.elapsed());
        }
    }
    // If the reader accepted all or none of the damaged texts, the test would check only one of its cases.
    assert!(read > 0 && refused > 0, "{name}: {read} read, {refused} refused");
    println!("{name}: {} texts, {read} read, {refused} refused", read + refused);
}

fn text(bytes: &[u8]) -> Result<&str, String> {
    std::str::from_utf8(bytes).map_err(|e| e.to_string())
}

/// Computes the record of a simple damper in a sine test; `amplitude` is in m, `frequency` in Hz.
fn record(amplitude: f64, frequency: f64) -> Record {
    let time: Vec<f64> = (0..241).map(|i| f64::from(i) / (80.0 * frequency)).collect();
    let omega = TAU * frequency;
    let displacement: Vec<f64> = time.iter().map(|t| amplitude * (omega * t).sin()).collect();
    let velocity: Vec<f64> = time.iter().map(|t| amplitude * omega * (omega * t).cos()).collect();
    let force = velocity.iter().zip(&displacement).map(|(v, x)| 1500.0 * v + 40.0 * (v / 0.01).tanh() + 800.0 * x);
    Record {
        name: format!("{amplitude} {frequency}"),
        force: force.collect(),
        cycles: vec![0..80, 80..160, 160..240],
        amplitude,
        frequency,
        peak_velocity: amplitude * omega,
        displacement,
        velocity,
        time,
        ..Record::default()
    }
}

/// Writes a model file with every element and every parameter, followed by the tables of a fit.
fn whole_model() -> String {
    let mut params = Params::new();
    for element in Element::all() {
        // An element that another enabled element excludes stays disabled.
        let before = params;
        params.enable(element, true);
        if prepared(&params).is_err() {
            params = before;
        }
    }
    model_file::flat(&params, |_| String::new())
        + "\n[identification]\ntests = [\"a\"]\nnotes = [\"n\"]\nmessages = [{ id = \"identification-no-test\" }, { id = \"\", text = { list = [\"n\"], between = \"identification-comma\" } }]\n\n[identification.fv_only]\nvelocity = [-1.0, 0.0, 1.0]\nforce = [-1500.0, 0.0, 2000.0]\ngas_force = 100.0\n"
}

#[test]
fn model_files() {
    let seeds = [whole_model(), "format = 1\nelements = [\"fv_curve\"]\n".to_owned()];
    let records = [record(0.02, 1.0)];
    every_damage_is_read_or_refused("damper.toml", &seeds, &|file, bytes| {
        // The C interface, the FMU and Adams use the kernel's reader.
        let mut params = Params::new();
        let by_kernel = kernel::read(bytes, &mut params).map_err(|e| e.problem.text().to_owned());
        std::fs::write(file, bytes).unwrap();
        let read = model_file::read(file).map_err(|e| e.to_string())?;
        by_kernel?;
        assert_eq!(&params, &read.params, "both readers read the same");
        let model = prepared(&read.params).map_err(|e| e.to_string())?;
        let motion = dashpot_records::smoothing::smooth(&records[0]);
        let forces = dashpot_simulation::prediction::predict(&model, &records[0], &motion, 0.0);
        assert_eq!(forces.len(), records[0].force.len());
        if let Some(curve) = &read.identification.fv_only {
            curve.params()?;
        }
        let mut own = records.to_vec();
        read.identification.right(&mut own);
        Ok(())
    });
}

#[test]
fn files_of_models_of_the_literature() {
    let records = [record(0.04, 0.5), record(0.02, 2.0), record(0.01, 8.0)];
    let refs: Vec<&Record> = records.iter().collect();
    let tests = observation::of_records(&refs);
    let names = ["fv", "piecewise", "lag", "surface", "dahl", "kwok"];
    let seeds = names.map(|name| literature::write(&Literature::fit(name, &tests).unwrap(), &["a".to_owned()]));
    let motion = SampledMotion::from_record(&records[1]);
    every_damage_is_read_or_refused("rival.toml", &seeds, &|file, bytes| {
        std::fs::write(file, bytes).unwrap();
        let read = literature::read(file).map_err(|e| e.to_string())?;
        assert_eq!(read.forces(&motion).len(), motion.dt.len());
        Ok(())
    });
}

#[test]
fn profiles_of_campaigns() {
    let seed = "format = \"dashpot campaign profile 1\"\nexclude = [\"warm*\", \"*.tmp\"]\npositive = \"compression\"\ndelay_s = 0.001\n\
                gain = 1.02\nforce_zero_n = -3.5\nrig_mass_kg = 0.4\nflip = [\"force\", \"motion\"]\nignore = [\"temperature\"]\n\n[columns]\ntime = \"A\"\n\
                displacement = \"2\"\nforce = \"C\"\n\n[units]\ntime = \"s\"\ndisplacement = \"m\"\nforce = \"N\"\n";
    let measured = record(0.02, 1.0);
    let rows: String = (0..measured.time.len())
        .map(|i| format!("{},{},{}\n", measured.time[i], measured.displacement[i], measured.force[i]))
        .collect();
    every_damage_is_read_or_refused(profile::FILE, &[seed.to_owned()], &|file, bytes| {
        std::fs::write(file, bytes).unwrap();
        let folder = file.parent().unwrap();
        let beside = folder.join("a.csv");
        if !beside.exists() {
            std::fs::write(&beside, format!("A,B,C\n{rows}")).unwrap();
        }
        load(&[folder.to_owned()], &Options::default(), &|_| ()).map(|_| ()).map_err(|e| e.to_string())
    });
}

#[test]
fn tables_of_limits_peaks_and_tests() {
    let limits_seeds = [
        "quantity,velocity_m_s,low,high,name\nforce,0.26,800,1100,rebound\nforce,-0.26,-500,-300,compression\ngas_force,,100,200,\n",
        "# ours\nquantity;velocity_m_s;nominal;tolerance;unit\nforce;0,52;1200,5;10 %;N\nfriction;;0;40;N\n",
    ];
    every_damage_is_read_or_refused("limits.csv", &limits_seeds.map(str::to_owned), &|file, bytes| {
        let found = limits::parse(file, text(bytes)?).map_err(|e| e.to_string())?;
        let tests = [record(0.04, 0.5), record(0.02, 2.0)];
        let judged = limits::judge(&found, &tests.iter().collect::<Vec<_>>(), None);
        assert_eq!(judged.limits.len(), found.len());
        Ok(())
    });
    let peaks = [
        "velocity_mm_s,force_N\n-520,-600\n-130,-250\n130,400\n520,1200\n",
        "velocity [m/s]\trebound [N]\tcompression [N]\n0.13\t400\t-250\n0.52\t1200\t-600\n",
    ];
    every_damage_is_read_or_refused("peaks.csv", &peaks.map(str::to_owned), &|file, bytes| {
        std::fs::write(file, bytes).unwrap();
        let points = read_peaks(file, &PeakOptions::default()).map_err(|e| e.to_string())?.points;
        assert!(points.windows(2).all(|w| w[0].velocity_m_s < w[1].velocity_m_s), "{points:?}");
        Ok(())
    });
    let matrix = "name,amplitude_mm,frequency_hz,peak_velocity_mm_s,mean_displacement_mm,side_force_n,cycles\na,50,0.1667,,0,0,3\nb,,2,262,5,100,4\n";
    every_damage_is_read_or_refused("matrix.csv", &[matrix.to_owned()], &|file, bytes| {
        std::fs::write(file, bytes).unwrap();
        let read = Matrix::read(file).map_err(|e| e.to_string())?;
        assert!(read.points().iter().all(|p| p.amplitude_m.is_finite() && p.frequency_hz > 0.0), "{read:?}");
        Ok(())
    });
    let motion = "time_s,displacement_mm,velocity_mm_s\n0,0,100\n0.01,1,99\n0.02,1.98,97\n0.03,2.9,93\n";
    every_damage_is_read_or_refused("motion.csv", &[motion.to_owned()], &|file, bytes| {
        std::fs::write(file, bytes).unwrap();
        let read = read_motion(file, &Options::default()).map_err(|e| e.to_string())?;
        assert!(read.time.windows(2).all(|w| w[1] > w[0]), "{:?}", read.time);
        Ok(())
    });
}

#[test]
fn vehicles() {
    let seed = Car::default().values().iter().map(|v| format!("{} = {:?}\n", v.name, v.value)).collect();
    every_damage_is_read_or_refused("car.toml", &[seed], &|_, bytes| {
        let car = Car::read(text(bytes)?).map_err(|e| e.to_string())?;
        assert!(car.values().iter().all(|v| v.value.is_finite() && v.value >= 0.0));
        Ok(())
    });
}

#[test]
fn files_of_adams() {
    let dpr = "$ a comment\n[MDI_HEADER]\nFILE_TYPE = 'dpr'\n(COMMENTS)\n{comment_string}\n'a table = 3, $5'\n[UNITS]\nLENGTH = 'inch'\n\
               FORCE = 'pound_force'\nTIME = 'sec'\n[CURVE]\n{ vel force}\n-10 -1 ! first\n10 2\n";
    let xml = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<afc xmlns:afc=\"http://a/:afc\">\n<afc:Units>\n\
               <afc:UnitSetting name=\"force\" current=\"newton\"/>\n<afc:UnitSetting name=\"length\" current=\"mm\"/>\n<afc:UnitSetting name=\"time\" current=\"second\"/>\n\
               </afc:Units>\n<DamperProperties dampingMethod=\"non_linear\" rate=\"0.5\" gasPreloadMethod=\"non_linear\" gasPreloadConstant=\"1000\">\n\
               <Spline name=\"spline_data\" xUnit=\"m/sec\" yUnit=\"kN\">\n<![CDATA[\n -1270 -1495.5\n 0 0\n 254 1423.4\n]]>\n</Spline>\n\
               <Spline name=\"gasPreloadForceCurve\">\n 0 2000\n 500 1000\n</Spline>\n</DamperProperties>\n</afc>\n";
    let seeds = [dpr, xml].map(str::to_owned);
    every_damage_is_read_or_refused("damper.dpr", &seeds, &|_, bytes| {
        let read = property::read(bytes).map_err(|e| format!("{e:#}"))?;
        let form = property::Form::Xml;
        // The data of an accepted file can be written as a file, and reading this file gives the same values.
        let again = property::read(property::write(&read, form).as_bytes()).map_err(|e| format!("{e:#}"));
        let again = again.unwrap_or_else(|e| panic!("{e}\n{read:?}"));
        assert_eq!(again.curve.forces, read.curve.forces, "{read:?}");
        Ok(())
    });
    let adm = "A title\n!  adams_view_name='susp.dal_ride_damper.force'\nSFORCE/1\n, TRANSLATIONAL\n, I = 75\n, J = 76\n\
               , FUNCTION = step(vr(75,76), -1e-4, 1.0, 1e-4, 1.0)\n,*akispl(vr(75,76),0,9)\n!\nSTRING/103\n, STRING = a.tir\nSPLINE/9\n, X = -100, 0, 100\n\
               , Y = 500, 0, -900\nEND\n";
    let damper = [Damper { name: "dal_ride_damper.force".into(), length: 412.5, model_file: "damper.toml".into() }];
    every_damage_is_read_or_refused("car.adm", &[adm.to_owned()], &|_, bytes| {
        let patched = patch(bytes, &damper, false).map_err(|e| format!("{e:#}"))?;
        let new = String::from_utf8_lossy(&patched.model);
        assert!(new.contains("dashpot_adams::Dashpot_sfosub"), "{new}");
        // The id of the STRING with the name of the model file differs from all other ids.
        let ids: Vec<String> = new
            .lines()
            .filter_map(|line| line.strip_prefix("STRING/"))
            .map(|rest| rest.chars().take_while(char::is_ascii_digit).collect())
            .collect();
        let own = ids.last().unwrap();
        assert!(own != "0" && ids.iter().filter(|id| *id == own).count() == 1, "{ids:?}");
        Ok(())
    });
}

/// Number of accepted dimension files for each one that is also used to explain a model. The other files are only read,
/// because an explanation takes longer.
const EXPLAINED: usize = 50;

#[test]
fn dimensions() {
    let seeds = [
        "design = \"monotube\"\nbore_mm = 40\nrod_mm = 12\nrebound_chamber_mm = [128, 132]\ngas_pressure_bar = 25\ngas_volume_cm3 = 90\n",
        "design = \"twin_tube\"\nbore_mm = 30\nrod_mm = 16\nreserve_volume_cm3 = 200\nreserve_oil_cm3 = 80\nair_percent = 1\n\
         oil_modulus_gpa = 1.3\ntube_wall_mm = 1.5\neye_stiffness_n_mm = 2500\ndischarge_coefficient = 0.7\n",
    ]
    .map(str::to_owned);
    let model = model_file::of_text(&whole_model(), Path::new("damper.toml")).unwrap();
    let count = std::cell::Cell::new(0);
    every_damage_is_read_or_refused("dimensions.toml", &seeds, &|file, bytes| {
        std::fs::write(file, bytes).unwrap();
        let drawing = dashpot_dimensions::read(file).map_err(|e| e.to_string())?;
        count.set(count.get() + 1);
        if count.get() % EXPLAINED == 1 {
            let explanation = dashpot_dimensions::explain(&model, &drawing);
            assert!(!explanation.lines().is_empty());
            for expectation in dashpot_dimensions::forward::expectations(&drawing) {
                assert!(expectation.expected.value.is_finite(), "{expectation:?}");
            }
        }
        Ok(())
    });
}
