# What `dashpot export` writes for those without a compiler, and the libraries; the command takes them in as it is built.
say "kernel, FMU runtime and Adams library"
RUSTFLAGS="$maps" sh vi-crt-bridge/runtimes.sh
for file in linux64/dashpot_damper.so linux64/dashpot_adams.so win64/dashpot_damper.dll win64/dashpot_adams.dll; do
    [ -s "$DASHPOT_RUNTIMES/$file" ] || fail "dist/build: $file was not made; for Windows apt-get install rustc-web cargo-web rust-web-src gcc-mingw-w64-x86-64-win32"
done
