#!/bin/sh
# Compiles the binary of this FMU into ../binaries, from the sources in this folder alone.
#
#   sh build.sh                                    on the platform the FMU was exported on: a C compiler is enough
#   KERNEL=cargo sh build.sh                       the kernel from its sources too (needs Rust, https://rustup.rs)
#   TARGET=x86_64-pc-windows-gnu CC=x86_64-w64-mingw32-gcc sh build.sh      for another platform (rustup target add TARGET)
#   LIBRARY=/path/to/libdashpot.a CC=your-cc sh build.sh                    with a kernel built elsewhere
#
# FMI_PLATFORM names the folder below ../binaries if it does not follow from TARGET.
set -eu
cd "$(dirname "$0")"
target=${TARGET:-}
exported=$(cat lib/platform 2>/dev/null || true)
library=${LIBRARY:-}

if [ -z "$library" ] && [ -z "$target" ] && [ "${KERNEL:-}" != cargo ] && [ "$(uname -s)-$(uname -m)" = "$(cat lib/system 2>/dev/null)" ]; then
    library=lib/kernel.o
fi
if [ -z "$library" ]; then
    command -v cargo >/dev/null || {
        echo "the kernel for this platform is built by cargo, which is not here: install Rust from https://rustup.rs, or name a libdashpot.a with LIBRARY" >&2
        exit 1
    }
    built=${CARGO_TARGET_DIR:-kernel/target}
    CARGO_TARGET_DIR="$built" cargo build --quiet --release --manifest-path kernel/Cargo.toml -p dashpot-dll ${target:+--target "$target"}
    library=$built/${target:+$target/}release/libdashpot.a
fi

fmi=$(cat lib/fmi)
platform=${FMI_PLATFORM:-}
if [ -z "$platform" ]; then
    case "$fmi-$target" in
    2-x86_64-*windows*) platform=win64 ;;
    2-x86_64-*linux*) platform=linux64 ;;
    2-*-apple-darwin*) platform=darwin64 ;;
    3-*windows*) platform=${target%%-*}-windows ;;
    3-*linux*) platform=${target%%-*}-linux ;;
    3-*-apple-darwin*) platform=${target%%-*}-darwin ;;
    *-) platform=$exported ;;
    *) echo "name the platform with FMI_PLATFORM" >&2; exit 1 ;;
    esac
fi
case $platform in
win* | *-windows)
    # The kernel's panic handler calls a function that does not exist, so that linking fails if a panic can be reached. It cannot, but this
    # linker keeps the handler, so abort() replaces the function. The same sources give the same bytes: the linker writes no build time, and
    # does not derive the base address from the path of the file.
    end=.dll position=-static-libgcc
    options=-Wl,--defsym=dashpot_panic_path_exists=abort,--no-insert-timestamp,--disable-auto-image-base
    ;;
darwin* | *-darwin) end=.dylib position=-fPIC options= ;;
*) end=.so position=-fPIC options=-Wl,--exclude-libs,ALL ;;
esac

mkdir -p "../binaries/$platform"
${CC:-cc} -std=c99 -O2 $position -shared -fvisibility=hidden -I. ./*.c "$library" $options -s -o "../binaries/$platform/dashpot_damper$end"
echo "binaries/$platform/dashpot_damper$end"
