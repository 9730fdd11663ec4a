# The wheels, installed without the sources into empty environments. Runs in $here.
. "$here/checks/results.sh"
mkdir -p "$here/Räder 4"
cd "$here/Räder 4"
numpy=1.26.4
python=$(python3 -c 'import sys; print(f"{sys.version_info[0]}.{sys.version_info[1]}")')

# Runs the command on a small campaign. The Python package must give the same results.
task() { # folder, command...
    local folder=$1
    shift
    mkdir -p "$folder" && cd "$folder" &&
        "$@" matrix --amplitudes 50,15,1 --peak-velocities 52,262,1047 -o small.csv && "$@" rig -o records --matrix small.csv --seed 3 &&
        "$@" fit records -o damper.toml --json fit.json && "$@" validate damper.toml records --json errors.json &&
        python3 -c "
import math
print('time_s,displacement_m')
for k in range(501): print(f'{k / 500!r},{0.02 * math.sin(9 * k / 500)!r}')" >motion.csv &&
        "$@" simulate damper.toml motion.csv -o force.csv && "$@" export fmu damper.toml -o damper.fmu
}

auditors() {
    [ -x tools/bin/auditwheel ] || { python3 -m venv tools && tools/bin/pip install --quiet auditwheel==6.8.2 abi3audit==0.0.26; }
}
# Uses of Python's interface outside of its stable part would fail under another version of Python than the one here.
stable() { auditors && tools/bin/abi3audit --strict --verbose --assume-minimum-abi3 3.10 "$here/packages/$1"; }

if [ ! -e "$here/packages/$linux_wheel" ]; then
    skip "wheel for Linux" "not built"
elif ! python3 -c 'import ensurepip, venv' 2>/dev/null; then
    skip "wheel for Linux" "needs python3-venv"
else
    manylinux() {
        local newest
        auditors && tools/bin/auditwheel show "$here/packages/$linux_wheel" >shown || return 1
        cat shown
        # auditwheel breaks the sentence into lines, so join them.
        newest=$(tr '\n' ' ' <shown | sed -n 's/.*consistent with the following platform tag: *"manylinux_\(2_[0-9]*\)_x86_64".*/\1/p' | tr _ .)
        [ -n "$newest" ] && [ "$(printf '%s\n' "$newest" "$glibc" | sort -V | tail -1)" = "$glibc" ]
    }
    check "wheel for Linux: auditwheel finds no more than glibc $glibc" manylinux
    check "wheel for Linux: only Python's stable interface" stable "$linux_wheel"
    fresh() {
        python3 -m venv fresh && fresh/bin/pip install --quiet "$here/packages/$linux_wheel" && fresh/bin/pip check &&
            [ "$(fresh/bin/pip list --format freeze | grep -Evc '^(pip|setuptools|wheel)==')" = 2 ]
    }
    check "wheel for Linux installs into an empty environment, with numpy alone" fresh
    if [ -e "$here/packages/$linux_name.tar.gz" ]; then
        mkdir -p package && tar -xzf "$here/packages/$linux_name.tar.gz" -C package
        same() { (task linux "$PWD/package/$linux_name/bin/dashpot") && fresh/bin/python "$here/checks/wheel.py" linux; }
        check "wheel for Linux: model, errors, forces and FMU are the command's, to the last digit" same
    else
        skip "wheel for Linux beside the command" "the package for Linux is not built"
    fi
fi

if [ ! -e "$here/packages/$windows_wheel" ]; then
    skip "wheel for Windows" "not built"
    exit 0
fi
check "wheel for Windows: only Python's stable interface" stable "$windows_wheel"
for tool in wine unzip x86_64-w64-mingw32-gcc; do
    has $tool || { skip "wheel for Windows, used" "needs $tool (Debian: wine wine64 unzip gcc-mingw-w64-x86-64-win32)"; exit 0; }
done
mkdir -p native && unzip -q "$here/packages/$windows_wheel" -d native
imports() {
    local needed library
    needed=$(x86_64-w64-mingw32-objdump -p native/dashpot/_native.pyd | sed -n 's/^.*DLL Name: //p' | tr 'A-Z\n' 'a-z ')
    echo "needs $needed"
    for library in $needed; do
        case $library in
            python3.dll | kernel32.dll | msvcrt.dll | ntdll.dll | advapi32.dll | bcrypt.dll | bcryptprimitives.dll | userenv.dll | ws2_32.dll | api-ms-win-*) ;;
            *) return 1 ;;
        esac
    done
    [[ " $needed " == *" python3.dll "* ]] && x86_64-w64-mingw32-objdump -p native/dashpot/_native.pyd | grep -q PyInit__native
}
check "wheel for Windows needs python3.dll and what every Windows has" imports

# Python for Windows, as python.org compiles it. Panda3D's wheel contains its library and its modules in C. Three parts are missing in it
# and added here: the program, which is one call; the library of the stable interface, which forwards every name; and the modules in Python,
# taken from Debian's Python of the same version.
windows_python() {
    local library=python${python/./} names
    mkdir -p windows-python panda/wheel && python3 -m venv panda/venv &&
        panda/venv/bin/pip download --quiet --no-deps --dest panda --platform win_amd64 --python-version "$python" --only-binary :all: panda3d==1.10.16 &&
        unzip -q panda/*.whl 'deploy_libs/*' -d panda/wheel && rm -f panda/wheel/deploy_libs/api-ms-* && cp panda/wheel/deploy_libs/* windows-python || return 1
    cp -r "/usr/lib/python$python" windows-python/Lib && rm -rf windows-python/Lib/{test,dist-packages,site-packages} && mkdir -p windows-python/{DLLs,Lib/site-packages}
    x86_64-w64-mingw32-objdump -p "windows-python/$library.dll" | sed -n '/\[Ordinal\/Name Pointer\] Table/,/^$/s/.*\[ *[0-9]*\] //p' >panda/names
    names=$(wc -l <panda/names) && [ "$names" -gt 1000 ] || return 1
    { printf 'LIBRARY python3.dll\nEXPORTS\n' && sed "s/.*/    & = $library.&/" panda/names; } >panda/python3.def
    { printf 'LIBRARY %s.dll\nEXPORTS\n' "$library" && cat panda/names; } >panda/library.def
    echo 'int DllMainCRTStartup(void) { return 1; }' >panda/empty.c
    printf '%s\n' '#include <wchar.h>' 'int Py_Main(int, wchar_t **);' 'int wmain(int count, wchar_t **words) { return Py_Main(count, words); }' >panda/python.c
    x86_64-w64-mingw32-dlltool -d panda/library.def -l panda/library.a && x86_64-w64-mingw32-gcc -municode -o windows-python/python.exe panda/python.c panda/library.a &&
        x86_64-w64-mingw32-gcc -shared -nostdlib -e DllMainCRTStartup -o windows-python/python3.dll panda/empty.c panda/python3.def &&
        panda/venv/bin/pip install --quiet --no-deps --target windows-python/Lib/site-packages --platform win_amd64 --python-version "$python" --only-binary :all: \
            "numpy==$numpy" "$here/packages/$windows_wheel" || return 1
    . "$here/checks/wine.sh"
    start_wine windows-python
    wine_python -c 'import numpy; print(numpy.__version__)' | tr -d '\r' | grep -x "$numpy"
}
# Under Wine, Python starts only if its input and output are pipes, not files.
wine_python() {
    echo | wine windows-python/python.exe "$@" 2>&1 | cat
    [ "${PIPESTATUS[1]}" = 0 ]
}
if windows_python >said 2>&1; then
    if [ -e "$here/packages/$windows_name.zip" ]; then
        unzip -q "$here/packages/$windows_name.zip" -d package
        same_on_windows() {
            cp windows-python/bcryptprimitives.dll "package/$windows_name/"
            (task windows wine "$PWD/package/$windows_name/dashpot.exe") && wine_python "$here/checks/wheel.py" windows
        }
        check "wheel for Windows, Python $python under Wine: model, errors, forces and FMU are the command's, to the last digit" same_on_windows
    else
        skip "wheel for Windows beside the command" "the package for Windows is not built"
    fi
else
    skip "wheel for Windows, used" "Python $python for Windows does not start here: $(tail -1 said)"
fi
