#!/bin/sh
# Compiles what `dashpot export fmu` and `dashpot export adams` write for those who have no compiler: the FMU runtime, the kernel as
# one object, and the Adams library. They go to target/runtimes (CARGO_TARGET_DIR or DASHPOT_RUNTIMES elsewhere); the next build of the command takes them in:
#
#   sh vi-crt-bridge/runtimes.sh                  for this platform; for 64-bit Windows too where mingw-w64 is installed
#   cargo build --release -p dashpot-cli
#
# A runtime built of other sources than the command is not taken in: build.rs compares target/runtimes/sources.txt with them.
#
# For Windows the kernel is built by RUSTC_WINDOWS / CARGO_WINDOWS (Debian: rustc-web, cargo-web and rust-web-src as /usr/bin/rustc and
# /usr/bin/cargo), or by rustup with `rustup target add x86_64-pc-windows-gnu`. CC names the compiler for this platform.
set -eu
cd "$(dirname "$0")/.."
build=${CARGO_TARGET_DIR:-target}
final=${DASHPOT_RUNTIMES:-$build/runtimes}
# Whole or not at all: the command's build may look while this runs.
to=$final.$$
trap 'rm -rf "$to"' EXIT
mkdir -p "$to"
face="vi-crt-bridge/fmu/*.c vi-crt-bridge/bridge/corner.c"
flags="-std=c99 -O2 -fvisibility=hidden -Iinclude -Ivi-crt-bridge/bridge -Ivi-crt-bridge/fmu"

linux() {
    here=$to/linux64
    mkdir -p "$here"
    cargo build --quiet --release -p dashpot-dll
    sh src/dll/static.sh "$build/release/libdashpot.a" "$here/kernel.o"
    # shellcheck disable=SC2086
    ${CC:-cc} $flags -fPIC -shared $face "$here/kernel.o" -Wl,--exclude-libs,ALL -s \
        -o "$here/dashpot_damper.so"
    make -s -C adams-usersub OUTPUT="$(realpath "$here")/dashpot_adams.so" LIBRARY="$(realpath "$build/release/libdashpot.a")" \
        ${CC:+CC="$CC"}
    strip "$here/dashpot_adams.so"
    echo "$final/linux64"
}

windows() {
    here=$to/win64
    target=x86_64-pc-windows-gnu
    gcc=x86_64-w64-mingw32-gcc
    command -v $gcc >/dev/null || { echo "not for Windows: needs $gcc (Debian: gcc-mingw-w64-x86-64-win32)"; return; }
    if rustup target list --installed 2>/dev/null | grep -q $target; then
        cargo build --quiet --release -p dashpot-dll --target $target
    elif [ -x "${RUSTC_WINDOWS:-/usr/bin/rustc}" ] && [ -x "${CARGO_WINDOWS:-/usr/bin/cargo}" ]; then
        # A compiler that has the sources of core and none of it compiled for Windows.
        env -u RUSTUP_TOOLCHAIN -u CARGO RUSTC="${RUSTC_WINDOWS:-/usr/bin/rustc}" RUSTC_BOOTSTRAP=1 \
            CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER=$gcc "${CARGO_WINDOWS:-/usr/bin/cargo}" build --quiet --release -p dashpot-dll \
            -Zbuild-std=core --target $target
    else
        echo "not for Windows: needs rustup target add $target, or Debian's rustc-web, cargo-web and rust-web-src"
        return
    fi
    mkdir -p "$here"
    # The same sources give the same file: without the time, and without a base address that the linker draws from the path of the file. Windows
    # moves libraries when it loads them.
    same_bytes=-Wl,--no-insert-timestamp,--disable-auto-image-base
    # The kernel's panic handler calls a function that exists nowhere, so that a link fails where it could be reached. Here it
    # cannot, but unlike elsewhere the linker keeps it.
    # shellcheck disable=SC2086
    $gcc $flags -shared -static-libgcc $face "$build/$target/release/libdashpot.a" -Wl,--defsym=dashpot_panic_path_exists=abort -s \
        $same_bytes \
        -o "$here/dashpot_damper.dll"
    make -s -C adams-usersub windows WINDOWS_OUTPUT="$(realpath "$here")/dashpot_adams.dll" \
        WINDOWS_LIBRARY="$(realpath "$build/$target/release/libdashpot.a")"
    echo "$final/win64"
}

linux
windows
# What they were built of, as build.rs lists it: every file of the kernel and of the faces.
find src/core/src src/abi/src src/dll/src src/core/Cargo.toml src/abi/Cargo.toml src/dll/Cargo.toml include/dashpot.h \
    vi-crt-bridge/bridge/corner.c vi-crt-bridge/bridge/corner.h vi-crt-bridge/fmu adams-usersub/src \
    \( -name '*.rs' -o -name '*.c' -o -name '*.h' -o -name '*.toml' \) -type f | LC_ALL=C sort | while read -r file; do
    echo "== $file"
    cat "$file"
done >"$to/sources.txt"
rm -rf "$final"
mv "$to" "$final"
