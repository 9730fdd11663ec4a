//! Export of a damper for hosts: Adams files and an FMU, based on a model file.
//!
//! The C code of these files is in `adams-usersub/` and `vi-crt-bridge/`.

pub mod adams;
pub mod damper_length;
pub mod exports;
pub mod fmu;
pub mod plain_curve;
pub mod runtimes;
