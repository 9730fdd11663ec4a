# The Python package for Linux and Windows, one wheel each for every Python from 3.10 on. maturin builds the wheels. They are unpacked, get
# the licenses and the bill of materials, and are packed again by archive.py.
wheel_of() { # target, maturin's own options...
    local target=$1 made said folder information
    shift
    say "Python wheel for $target"
    rm -rf "$work/wheel"
    (cd src/python && "$work/venv/bin/maturin" build --quiet --release --locked --strip --target "$target" --out "$work/wheel" "$@")
    made=$(basename "$work"/wheel/*.whl)
    folder=$staged/wheels/${made%.whl}
    mkdir -p "$folder"
    python3 -m zipfile -e "$work/wheel/$made" "$folder"
    information=$folder/dashpot-$version.dist-info
    # maturin's own bill of materials has another serial number in every build.
    rm -rf "$information/sboms"
    mkdir -p "$information/licenses" "$information/sboms"
    said=$work/said/wheel.$target
    mkdir -p "$work/said"
    python3 dist/licences.py texts "$target" dashpot-python >"$said.licences"
    "$work/venv/bin/python" dist/licences.py bill "$target" dashpot-python >"$said.bill"
    install -m 644 "$said.bill" "$information/sboms/dashpot.cdx.json"
    install -m 644 "$said.licences" "$information/licenses/THIRD-PARTY.txt"
    install -m 644 LICENSE-MIT LICENSE-APACHE "$information/licenses"
    # The metadata of a wheel must name its license files, which pip lists.
    grep -q '^License-Expression: ' "$information/METADATA" || fail "dist/build: maturin's METADATA has no licence beside which its files could be named"
    sed -i '0,/^License-Expression: .*/s//&\nLicense-File: LICENSE-APACHE\nLicense-File: LICENSE-MIT\nLicense-File: THIRD-PARTY.txt/' "$information/METADATA"
    find "$folder" -type f ! -name '*.so' -exec chmod 644 {} +
}

rm -rf "$staged/wheels"
# zig links against the symbols of the chosen glibc. maturin rejects symbols that a manylinux wheel must not need.
RUSTFLAGS="$maps" PATH=$work/venv/bin:$PATH wheel_of $linux_target --zig --compatibility "manylinux_${glibc/./_}" --auditwheel check

# Debian's second compiler builds the wheel for Windows, like the command. A Python process must survive a panic, so the library unwinds.
sources=$(realpath "$(/usr/bin/rustc --print sysroot)/lib/rustlib/src/rust")
for_windows_wheel() {
    local -x PATH=/usr/bin:/bin RUSTC=/usr/bin/rustc CARGO=/usr/bin/cargo RUSTC_BOOTSTRAP=1 CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER=x86_64-w64-mingw32-gcc
    local -x RUSTFLAGS="$maps --remap-path-prefix=$sources=/rust -Clink-arg=-Wl,--no-insert-timestamp"
    wheel_of $windows_target -Z build-std=std,panic_unwind
}
for_windows_wheel
