//! A veil over the model of an FMU whose parameters are hidden: its numbers cannot be read off the archive any more. It is no lock, for what
//! opens it lies in the same archive; `vi-crt-bridge/fmu/veil.c` is what does.

use std::fmt::Write as _;

/// The text under a veil that the FMU's GUID opens.
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
