#!/bin/sh
# Makes the static library that links beside any C and C++ program, target/lib/libdashpot.a:
#
#   sh src/dll/static.sh                          builds libdashpot with cargo, for this platform
#   sh src/dll/static.sh FROM TO [PREFIX]         packs a library that cargo has built; TO is an archive (.a) or an object (.o)
#
# Cargo's own archive holds Rust's compiler library, whose fmod, fma or cbrt a linker takes for a program that calls them, and which
# then asks for rust_eh_personality. Here all that the interface needs is one object, and every name in it but dashpot_* is local.
#
# Needs binutils: PREFIX is that of another platform's, such as x86_64-w64-mingw32- or aarch64-linux-gnu-.
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
# What is not reached from the interface goes, section by section: a path to a panic would stay, and show as a name that nothing defines.
roots=$("${prefix}nm" --defined-only "$from" 2>/dev/null | sed -n 's/^[0-9a-f]* T \(dashpot_[a-z_0-9]*\)$/-u \1/p' | sort -u)
[ -n "$roots" ] || { echo "static.sh: $from holds no function of dashpot" >&2; exit 1; }
# shellcheck disable=SC2086
"${prefix}ld" -r --gc-sections --strip-debug $roots -o "$work/dashpot.o" "$from"
"${prefix}objcopy" --wildcard --keep-global-symbol='dashpot_*' "$work/dashpot.o"
case $to in
*.a)
    # Without times and owners: the same sources give the same file.
    (cd "$work" && "${prefix}ar" rcsD dashpot.a dashpot.o)
    made=$work/dashpot.a
    ;;
*) made=$work/dashpot.o ;;
esac
# Whole or not at all: a linker may look while this runs.
cp "$made" "$to.$$"
mv "$to.$$" "$to"
