//! Writes a simulated campaign of the second laboratory (this crate) into a folder.
//!
//! `cargo run --release -p dashpot-other-lab --example campaign -- --plant twin_tube --hide cavitation=1 --seed 3 -o DIR`

use dashpot_other_lab::{Case, Kind, Plan, Protocol};
use std::path::PathBuf;
use std::process::ExitCode;

const HELP: &str = "\
campaign --plant thesis_like|monotube|twin_tube [--hide NAME[:LAW]=STRENGTH]... [--seed N] [--noise-seed N]
         [--plan sines|thesis|reduced|ramps|roads] [--laboratory N] [--noise PERCENT] [--reference] -o FOLDER
  --laboratory N  sampling, cycles, bits, hum and colour of the noise as some laboratory has them
  --reference     the same damper without what is hidden, measured once more";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), String> {
    let mut case = Case::new(Kind::ThesisLike, 1);
    let (mut folder, mut plan, mut noise, mut laboratory) = (None, Plan::Sines, None, None);
    let (mut noise_seed, mut is_reference) = (None, false);
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if word == "--help" {
            println!("{HELP}");
            return Ok(());
        }
        if word == "--reference" {
            is_reference = true;
            continue;
        }
        let value = words.next().ok_or_else(|| format!("'{word}' needs a value\n{HELP}"))?;
        let number = || value.parse::<f64>().map_err(|_| format!("'{value}' after {word} is no number"));
        let seed = || value.parse::<u64>().map_err(|_| format!("'{value}' after {word} is no whole number"));
        match word.as_str() {
            "--plant" => {
                case.plant = *Kind::ALL
                    .iter()
                    .find(|kind| kind.name() == value)
                    .ok_or_else(|| format!("there is no plant '{value}'\n{HELP}"))?;
            }
            "--hide" => {
                let (name, strength) = value.split_once('=').unwrap_or((&value, "1"));
                let strength =
                    strength.parse().map_err(|_| format!("the strength in '{value}' after {word} is no number"))?;
                case = case.hiding(name, strength);
            }
            "--seed" => case.seed = seed()?,
            "--noise-seed" => noise_seed = Some(seed()?),
            "--laboratory" => laboratory = Some(seed()?),
            "--noise" => noise = Some(number()?),
            "--plan" => {
                plan = match value.as_str() {
                    "sines" => Plan::Sines,
                    "thesis" => Plan::Thesis,
                    "reduced" => Plan::Reduced,
                    "ramps" => Plan::Ramps,
                    "roads" => Plan::Roads,
                    _ => return Err(format!("there is no plan '{value}'\n{HELP}")),
                }
            }
            "-o" => folder = Some(PathBuf::from(value)),
            _ => return Err(format!("'{word}' is not known\n{HELP}")),
        }
    }
    case.protocol = match laboratory {
        Some(seed) => Protocol::of_laboratory(plan, seed),
        None => Protocol { plan, ..Protocol::default() },
    };
    case.protocol.noise_percent = noise.unwrap_or(case.protocol.noise_percent);
    case.noise_seed = noise_seed.unwrap_or(case.seed);
    let case = if is_reference { case.reference() } else { case };
    let folder = folder.ok_or_else(|| format!("-o FOLDER is missing\n{HELP}"))?;
    let campaign = case.run().map_err(|error| error.to_string())?;
    campaign.write(&folder).map_err(|error| error.to_string())?;
    println!("{} tests in '{}'", campaign.tests.len(), folder.display());
    Ok(())
}
