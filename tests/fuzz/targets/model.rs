#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| dashpot_fuzz::model(bytes));
