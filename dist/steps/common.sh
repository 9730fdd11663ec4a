# Folders, names and flags of all steps. With these flags the same sources give the same bytes.
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)
root=$PWD
work=$root/target/dist
staged=$work/staged
packages=$work/packages
cargo_home=${CARGO_HOME:-$HOME/.cargo}
# The newest glibc whose symbols a program may need: that of RHEL 8, which Adams and VI-CarRealTime support.
glibc=2.28
linux_target=x86_64-unknown-linux-gnu
arm_target=aarch64-unknown-linux-gnu
windows_target=x86_64-pc-windows-gnu
linux_name=dashpot-$version-linux-x86_64
arm_name=dashpot-$version-linux-aarch64
windows_name=dashpot-$version-windows-x86_64
# One wheel for every Python from 3.10 on, as pyproject.toml promises.
linux_wheel=dashpot-$version-cp310-abi3-manylinux_${glibc/./_}_x86_64.whl
windows_wheel=dashpot-$version-cp310-abi3-win_amd64.whl

# Every archive has the time of the commit instead of the build time.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH CARGO_TARGET_DIR=$work/cargo LC_ALL=C TZ=UTC
# The folder that runtimes.sh writes and the build of the command reads, whatever the caller has set.
export DASHPOT_RUNTIMES=$CARGO_TARGET_DIR/runtimes
# Panic messages contain the paths of sources; remove the folders of this machine from these paths.
maps="--remap-path-prefix=$root=/dashpot --remap-path-prefix=$cargo_home=/cargo"
# A release build without symbol names, which would be a third of the file.
profile=(--config profile.release.strip=true)
fail() {
    echo "$1" >&2
    exit 1
}
say() { echo "dist: $1"; }
case $root in *[[:space:]]*) fail "dist/build: cargo's flags cannot name a folder with spaces; clone into another one than $root" ;; esac

# Fails if a Linux program needs a newer glibc or other libraries than every supported system has.
asks_for_no_more() { # folder, file, the system's loader
    local newest needed library
    newest=$(objdump -T "$1/$2" | sed -n 's/.*GLIBC_\([0-9.]*\).*/\1/p' | sort -Vu | tail -1)
    needed=$(objdump -p "$1/$2" | sed -n 's/^ *NEEDED *//p' | tr '\n' ' ')
    say "$2 asks for glibc ${newest:-of any version}, libraries: ${needed:-none}"
    if [ "$(printf '%s\n' "${newest:-0}" "$glibc" | sort -V | tail -1)" != "$glibc" ]; then
        fail "dist/build: $2 needs glibc $newest, and $glibc is promised"
    fi
    for library in $needed; do
        case $library in
            libc.so.6 | libm.so.6 | libpthread.so.0 | libdl.so.2 | librt.so.1 | "$3") ;;
            *) fail "dist/build: $2 needs $library, which not every Linux has" ;;
        esac
    done
}

missing=()
# command:package
need_debian() {
    local pair
    for pair in "$@"; do command -v "${pair%%:*}" >/dev/null || missing+=("${pair#*:}"); done
}
settle_missing() {
    [ ${#missing[@]} -gt 0 ] || return 0
    if [ "${install_missing:-no}" = yes ]; then
        apt-get update -q
        apt-get install -qy --no-install-recommends "${missing[@]}"
    else
        fail "dist/build: missing here: apt-get install ${missing[*]}  (or dist/build --install)"
    fi
}
