# What `dashpot export` writes for those without a compiler, and the libraries; the command takes them in as it is built.
say "kernel, FMU runtime and Adams library"
RUSTFLAGS="$maps" sh vi-crt-bridge/runtimes.sh
