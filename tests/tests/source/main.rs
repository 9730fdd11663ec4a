//! Rules of the source: names, texts, arrows between crates, and files that are written from the source. They form one
//! program, so that they run in parallel.

mod abi_header;
mod architecture;
mod book_figures;
mod circles;
mod computed_limits;
mod contributing;
mod documents;
mod file_reads;
mod messages;
mod parameter_page;
mod same_digits;
mod style;
mod terminal;
mod tuning;
