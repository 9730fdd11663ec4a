//! Tests of rules for the source code: names, texts, dependencies between crates, and files that are generated from the
//! source. They form one program, so that they run in parallel.

mod abi_header;
mod architecture;
mod book_figures;
mod circles;
mod computed_limits;
mod contributing;
mod documents;
mod file_reads;
mod long_functions;
mod messages;
mod parameter_page;
mod same_digits;
mod style;
mod terminal;
mod tuning;
