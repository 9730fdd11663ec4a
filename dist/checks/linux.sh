# The Linux packages, used without the sources. Runs in $here.
. "$here/checks/results.sh"
cd "$here"
[ -e "packages/$linux_name.tar.gz" ] || { skip "linux" "not built"; exit 0; }
# A folder name with blanks and umlauts, as users have.
place="$here/Prüfstand Dämpfer 2"
mkdir -p "$place"
tar -xzf "packages/$linux_name.tar.gz" -C "$place"
prefix=$place/$linux_name
dashpot=$prefix/bin/dashpot
cd "$place"

say_version() { "$dashpot" --version | grep -Eq "^dashpot $version \(interface version [0-9]+\)$"; }
check "version" say_version
check "manual page" bash -c "man -l '$prefix/share/man/man1/dashpot-fit.1' 2>/dev/null | grep -q 'dashpot fit'"
check "completions of bash" bash -c ". '$prefix/share/bash-completion/completions/dashpot'; COMP_WORDS=(dashpot diag); COMP_CWORD=1; _dashpot dashpot diag dashpot; [ \"\${COMPREPLY[0]}\" = diagnose ]"

demo() { "$dashpot" demo -o demo && grep -q '<svg' demo/report.html && [ -s demo/damper.toml ]; }
check "demo" demo
fit() { "$dashpot" fit demo/records -o eigen.toml && "$dashpot" validate eigen.toml demo/records --report report.html; }
check "fit and validate, folder with umlauts" fit
. "$here/checks/window.sh"
check_window "the window shows the demonstration's records" "$dashpot" open demo/records demo/damper.toml
crlf() {
    mkdir -p crlf && for file in demo/records/*.csv; do printf '\xef\xbb\xbf' >"crlf/${file##*/}" && sed 's/$/\r/' "$file" >>"crlf/${file##*/}" || return 1; done
    cp demo/records/*.toml crlf/ 2>/dev/null
    "$dashpot" fit crlf -o crlf.toml && same_model eigen.toml crlf.toml 0
}
check "records with line ends of Windows and a byte-order mark give the same model" crlf
diagnose() {
    "$dashpot" rig -o good --seed 11 --hide nothing --plan diagnosis && "$dashpot" rig -o worn --seed 11 --hide free_play=2 --plan diagnosis &&
        "$dashpot" fit good -o good.toml && "$dashpot" diagnose good.toml worn --reference good -o better.toml --json d.json &&
        python3 -c "import json; assert json.load(open('d.json'))['findings'][0]['effect'] == 'free_play'"
}
check "diagnose finds play that was hidden, beside a reference" diagnose

export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
runs() { # program: its forces are those of the command
    printf '0.1\n0.2\n-0.3\n' | LD_LIBRARY_PATH=$prefix/lib "$1" demo/damper.toml 0.001 -0.02 | tee "$1.forces" | grep -c . | grep -qx 3
}
by_pkg_config() {
    # pkg-config escapes blanks of a path for the shell.
    eval "cc -O2 '$prefix/share/dashpot/examples/damper.c' $(pkg-config --cflags --libs dashpot) -o shared" && runs ./shared && pkg-config --modversion dashpot | grep -qx "$version"
}
if has cc && has pkg-config; then
    check "C program, shared library through pkg-config" by_pkg_config
    static() { cc -O2 -I "$prefix/include" "$prefix/share/dashpot/examples/damper.c" "$prefix/lib/libdashpot.a" -o static && runs ./static && cmp shared.forces static.forces; }
    check "C program, static library, the same forces" static
else
    skip "C program through pkg-config" "needs cc and pkg-config"
fi
by_cmake() {
    mkdir -p project && cp "$prefix/share/dashpot/examples/damper.c" project/ && cat >project/CMakeLists.txt <<C
cmake_minimum_required(VERSION 3.13)
project(damper C)
find_package(dashpot $version REQUIRED)
add_executable(damper damper.c)
target_link_libraries(damper dashpot::dashpot)
add_executable(damper_static damper.c)
target_link_libraries(damper_static dashpot::static)
C
    cmake -S project -B project/build -DCMAKE_PREFIX_PATH="$prefix" && cmake --build project/build && runs project/build/damper && runs project/build/damper_static &&
        cmp project/build/damper.forces shared.forces && cmp project/build/damper_static.forces shared.forces &&
        objdump -p project/build/damper | grep -q 'NEEDED *libdashpot.so$' || return 1
    # CMake must reject a program for an incompatible version.
    sed -i "s/dashpot $version/dashpot 99.1/" project/CMakeLists.txt
    ! cmake -S project -B project/other -DCMAKE_PREFIX_PATH="$prefix"
}
if has cmake && has cc; then check "C program, both libraries through CMake" by_cmake; else skip "C program through CMake" "needs cmake"; fi

in_fmpy() {
    "$dashpot" export fmu demo/damper.toml -o damper.fmu &&
        python3 -m venv "$here/venv" && "$here/venv/bin/pip" install --quiet fmpy==0.3.32 &&
        "$here/venv/bin/python" - <<'P'
import zipfile
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
names = zipfile.ZipFile("damper.fmu").namelist()
assert "binaries/linux64/dashpot_damper.so" in names and "binaries/win64/dashpot_damper.dll" in names, names
problems = validate_fmu("damper.fmu")
assert not problems, problems
import numpy as np
t = np.arange(0, 1, 1e-3)
position = 0.02 * np.sin(6 * t)
signals = np.array(list(zip(t, position, 0.12 * np.cos(6 * t))), dtype=[("time", float), ("displacement", float), ("velocity", float)])
out = simulate_fmu("damper.fmu", fmi_type="CoSimulation", stop_time=1.0, output_interval=1e-3, input=signals, output=["force"])
force = out["force"]
assert np.isfinite(force).all() and np.ptp(force) > 100, force
print("force from", force.min(), "to", force.max(), "N")
P
}
if python3 -c 'import ensurepip, venv' 2>/dev/null; then check "exported FMU in FMPy" in_fmpy; else skip "exported FMU in FMPy" "needs python3-venv"; fi
adams() { "$dashpot" export adams demo/damper.toml -o adams --length 412.5 && cmp adams/dashpot_adams.so "$prefix/lib/dashpot/dashpot_adams.so"; }
check "run folder for Adams holds the library of the package" adams

debian() {
    local at=$here/debian
    mkdir -p "$at/var/lib/dpkg/updates" "$at/var/lib/dpkg/info" && : >"$at/var/lib/dpkg/status"
    # Install into an empty system without libc. The programs use the libc outside.
    dpkg --root="$at" --force-depends --install "$here/packages/dashpot_${version}_amd64.deb" || return 1
    diff -r "$prefix" "$at/usr" && "$at/usr/bin/dashpot" --version &&
        dpkg --root="$at" --remove dashpot && [ ! -e "$at/usr/bin/dashpot" ]
}
if has dpkg; then check "the Debian package installs the same files, and removes them" debian; else skip "the Debian package" "needs dpkg"; fi
