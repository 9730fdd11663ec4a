//! File formats, one module each. A reader converts a file to samples.

pub(crate) mod csv;
pub(crate) mod lvm;
pub(crate) mod mat;
pub(crate) mod mdf;
pub(crate) mod rpc;
pub(crate) mod tdms;
pub(crate) mod unsupported;
pub(crate) mod xlsx;
