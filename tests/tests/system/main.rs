//! Tests of the system as a whole: fits, diagnoses, the program `dashpot` and the hosts. They form one program, so that
//! long tests run in parallel.

mod accuracy;
mod cli;
mod crates;
mod diagnosis;
mod dimensions;
mod family;
mod fuzzing;
mod hidden_effects;
mod hostile_texts;
mod hosts;
mod identification;
mod memory_safety;
mod notes_and_tables;
mod other_laboratory;
mod other_sizes;
mod packages;
mod report_languages;
mod reported_campaigns;
