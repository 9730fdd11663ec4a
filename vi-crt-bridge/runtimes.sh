#!/bin/sh
# Compiles what `dashpot export fmu` and `dashpot export adams` write without a compiler: the FMU runtime, the kernel as one object, and
# the Adams library. They are written to target/runtimes, unless CARGO_TARGET_DIR or DASHPOT_RUNTIMES names another folder. The next build
# of the command includes them:
#
#   sh vi-crt-bridge/runtimes.sh                  for this platform; for 64-bit Windows too where mingw-w64 is installed
#   cargo build --release -p dashpot-cli
#
# The command does not include runtimes that were built from other sources than its own: build.rs compares target/runtimes/sources.txt with
# them.
#
# For Windows, rustup builds the kernel if `rustup target add x86_64-pc-windows-gnu` was run. Otherwise RUSTC_WINDOWS and CARGO_WINDOWS
# build it (by default /usr/bin/rustc and /usr/bin/cargo, which are Debian's rustc-web, cargo-web and rust-web-src). CC names the C compiler
# for this platform.
set -eu
cd "$(dirname "$0")/.."
build=${CARGO_TARGET_DIR:-target}
final=${DASHPOT_RUNTIMES:-$build/runtimes}
# Build in a temporary folder and rename it at the end, because the command's build may read the runtimes while this script runs.
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
        # This compiler has the sources of crate core, but not core compiled for Windows, so core is built, too.
        env -u RUSTUP_TOOLCHAIN -u CARGO RUSTC="${RUSTC_WINDOWS:-/usr/bin/rustc}" RUSTC_BOOTSTRAP=1 \
            CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER=$gcc "${CARGO_WINDOWS:-/usr/bin/cargo}" build --quiet --release -p dashpot-dll \
            -Zbuild-std=core --target $target
    else
        echo "not for Windows: needs rustup target add $target, or Debian's rustc-web, cargo-web and rust-web-src"
        return
    fi
    mkdir -p "$here"
    # The same sources give the same bytes: the linker writes no build time, and does not derive the base address from the path of the file.
    # Windows relocates libraries when it loads them.
    same_bytes=-Wl,--no-insert-timestamp,--disable-auto-image-base
    # The kernel's panic handler calls a function that does not exist, so that linking fails if a panic can be reached. It cannot, but this
    # linker keeps the handler, so abort() replaces the function.
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
# The sources of the runtimes, in the form that build.rs compares: every file of the kernel, the FMU runtime and the Adams library.
find src/core/src src/abi/src src/dll/src src/core/Cargo.toml src/abi/Cargo.toml src/dll/Cargo.toml include/dashpot.h \
    vi-crt-bridge/bridge/corner.c vi-crt-bridge/bridge/corner.h vi-crt-bridge/fmu adams-usersub/src \
    \( -name '*.rs' -o -name '*.c' -o -name '*.h' -o -name '*.toml' \) -type f | LC_ALL=C sort | while read -r file; do
    echo "== $file"
    cat "$file"
done >"$to/sources.txt"
rm -rf "$final"
mv "$to" "$final"
