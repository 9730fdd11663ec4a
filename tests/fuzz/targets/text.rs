#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    for ending in ["csv", "dat"] {
        dashpot_fuzz::records(ending, bytes);
    }
});
