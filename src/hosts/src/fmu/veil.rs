//! Obfuscation of the model in an FMU with concealed parameters, so that its numbers cannot be read in the archive. It is not encryption,
//! because the archive also contains the decoder, `vi-crt-bridge/fmu/veil.c`.

use std::fmt::Write as _;

/// Obfuscates a text. The key is the identifier (GUID) of the FMU.
pub fn veiled(text: &str, guid: &str) -> String {
    let mut state = guid
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3))
        .max(1);
    let mut out = String::from("veiled 1\n");
    for (k, byte) in text.bytes().enumerate() {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        let over = (state.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 56) as u8;
        let end = if k % 40 == 39 { "\n" } else { "" };
        let _ = write!(out, "{:02x}{end}", byte ^ over);
    }
    out + "\n"
}
