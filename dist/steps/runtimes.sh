# Builds the libraries that `dashpot export` writes without a compiler. The build of the command includes them.
say "kernel, FMU runtime and Adams library"
RUSTFLAGS="$maps" sh vi-crt-bridge/runtimes.sh
for file in linux64/dashpot_damper.so linux64/dashpot_adams.so win64/dashpot_damper.dll win64/dashpot_adams.dll; do
    [ -s "$DASHPOT_RUNTIMES/$file" ] || fail "dist/build: $file was not made; for Windows apt-get install rustc-web cargo-web rust-web-src gcc-mingw-w64-x86-64-win32"
done
