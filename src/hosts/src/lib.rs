//! What a damper becomes for a host: Adams files and an FMU, written from a model file.
//!
//! The C code that these files compile with or hold lies in `adams-usersub/` and `vi-crt-bridge/`.

pub mod adams;
pub mod damper_length;
pub mod fmu;
pub mod handed_out;
pub mod plain_curve;
pub mod runtimes;
