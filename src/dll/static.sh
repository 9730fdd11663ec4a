#!/bin/sh
# Makes the static library that links into any C or C++ program, target/lib/libdashpot.a:
#
#   sh src/dll/static.sh                          builds libdashpot with cargo, for this platform
#   sh src/dll/static.sh FROM TO [PREFIX]         packs a library that cargo has built; TO is an archive (.a) or an object (.o)
#
# Cargo's own archive contains Rust's compiler library. A linker may use its fmod, fma or cbrt for a program that calls these functions, and
# then requires rust_eh_personality. The library made here is one object with all that the interface needs. All its names are local, except
# dashpot_*.
#
# Requires binutils. PREFIX selects the binutils of another platform, such as x86_64-w64-mingw32- or aarch64-linux-gnu-.
set -eu
if [ $# -eq 0 ]; then
    cd "$(dirname "$0")/../.."
    build=${CARGO_TARGET_DIR:-target}
    cargo build --quiet --release -p dashpot-dll
    mkdir -p "$build/lib"
    set -- "$build/release/libdashpot.a" "$build/lib/libdashpot.a"
    echo "$2"
fi
from=$1 to=$2 prefix=${3:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Sections that the interface does not reach are removed. A path to a panic would remain, and appear as an undefined name.
roots=$("${prefix}nm" --defined-only "$from" 2>/dev/null | sed -n 's/^[0-9a-f]* T \(dashpot_[a-z_0-9]*\)$/-u \1/p' | sort -u)
[ -n "$roots" ] || { echo "static.sh: $from holds no function of dashpot" >&2; exit 1; }
# shellcheck disable=SC2086
"${prefix}ld" -r --gc-sections --strip-debug $roots -o "$work/dashpot.o" "$from"
"${prefix}objcopy" --wildcard --keep-global-symbol='dashpot_*' "$work/dashpot.o"
case $to in
*.a)
    # The archive contains no times and owners, so that the same sources give the same file.
    (cd "$work" && "${prefix}ar" rcsD dashpot.a dashpot.o)
    made=$work/dashpot.a
    ;;
*) made=$work/dashpot.o ;;
esac
# The file is replaced in one step, because a linker may read it at the same time.
cp "$made" "$to.$$"
mv "$to.$$" "$to"
