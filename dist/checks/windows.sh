# The Windows package under Wine, used without the sources. Runs in $here.
. "$here/checks/results.sh"
cd "$here"
[ -e "packages/$windows_name.zip" ] || { skip "windows" "not built"; exit 0; }
for tool in wine unzip x86_64-w64-mingw32-gcc; do
    has $tool || { skip "windows" "needs $tool (Debian: wine wine64 unzip gcc-mingw-w64-x86-64-win32)"; exit 0; }
done
place="$here/Prüfstand Dämpfer 3"
mkdir -p "$place"
unzip -q "packages/$windows_name.zip" -d "$place"
prefix=$place/$windows_name
cd "$prefix"
export DASHPOT_NO_PAUSE=1 LANG=C.UTF-8 LC_ALL=C.UTF-8
. "$here/checks/wine.sh"
start_wine "$prefix"
dashpot() { wine dashpot.exe "$@"; }

say_version() { dashpot --version | tr -d '\r' | grep -Eq "^dashpot $version \(interface version [0-9]+\)$"; }
check "Windows: version" say_version
read_me() { [ "$(grep -c $'\r$' README.txt)" = "$(grep -c '' README.txt)" ] && [ "$(grep -c $'\r$' 'Try-dashpot.cmd')" -gt 5 ]; }
check "Windows: texts have the line ends of Windows" read_me
# `start` finds no browser here, so its exit code is ignored. The files of the demonstration must exist.
try_it() { wine cmd /c "Try-dashpot.cmd"; grep -q '<svg' demo/report.html && [ -s demo/damper.toml ]; }
check "Windows: double-click on 'Try-dashpot.cmd'" try_it
drag() {
    cp -r demo/records "$place/Meine Prüfungen" && wine cmd /c "Fit-my-records.cmd" "$(winepath -w "$place/Meine Prüfungen")"
    [ -s "$place/Meine Prüfungen-dashpot/damper.toml" ] && grep -q '<svg' "$place/Meine Prüfungen-dashpot/report.html"
}
check "Windows: a folder with umlauts dragged onto 'Fit-my-records.cmd'" drag
fit() { dashpot fit demo/records -o own.toml && dashpot validate own.toml demo/records --report report.html; }
check "Windows: fit and validate" fit
long_paths() {
    local long
    long='\\?\'$(winepath -w "$prefix/demo/records")
    dashpot fit "$long" -o '\\?\'"$(winepath -w "$prefix")"'\long.toml' && same_model own.toml long.toml 0
}
check 'Windows: paths that begin with \\?\ ' long_paths
crlf() {
    mkdir -p crlf && for file in demo/records/*.csv; do printf '\xef\xbb\xbf' >"crlf/${file##*/}" && sed 's/\r$//; s/$/\r/' "$file" >>"crlf/${file##*/}" || return 1; done
    cp demo/records/*.toml crlf/ 2>/dev/null
    dashpot fit crlf -o crlf.toml && same_model own.toml crlf.toml 0
}
check "Windows: records with line ends of Windows and a byte-order mark give the same model" crlf
refuses() { dashpot fit "nicht da" -o x.toml; [ $? = 2 ] && [ ! -e x.toml ]; }
check "Windows: what is not there ends with 2" refuses
diagnose() {
    dashpot rig -o good --seed 11 --hide nothing --plan diagnosis && dashpot rig -o worn --seed 11 --hide free_play=2 --plan diagnosis &&
        dashpot fit good -o good.toml && dashpot diagnose good.toml worn --reference good --json d.json &&
        python3 -c "import json; assert json.load(open('d.json'))['findings'][0]['effect'] == 'free_play'"
}
check "Windows: diagnose finds play that was hidden" diagnose

program() { # import library
    x86_64-w64-mingw32-gcc -O2 -I sdk/include examples/damper.c "$1" -o damper.exe && cp sdk/bin/dashpot.dll . &&
        printf '0.1\r\n0.2\r\n-0.3\r\n' | wine damper.exe demo/damper.toml 0.001 -0.02 | tr -d '\r' >"${1##*/}.forces" && [ "$(grep -c . "${1##*/}.forces")" = 3 ]
}
check "Windows: C program with mingw's import library" program sdk/lib/libdashpot.dll.a
microsoft() {
    program sdk/lib/dashpot.lib && cmp dashpot.lib.forces libdashpot.dll.a.forces &&
        # The import library has the short form that link.exe writes: each member is one import, of machine 0x8664.
        x86_64-w64-mingw32-objdump -a sdk/lib/dashpot.lib | grep -q dashpot.dll
}
check "Windows: C program with Microsoft's import library, linked by mingw" microsoft

if [ -e "$here/packages/$linux_name.tar.gz" ]; then
    mkdir -p "$here/linux" && tar -xzf "$here/packages/$linux_name.tar.gz" -C "$here/linux"
    linux=$here/linux/$linux_name/bin/dashpot
    same_fit() { "$linux" fit demo/records -o linux.toml && same_model own.toml linux.toml 0; }
    check "Windows: the same records give Linux's model, to the last digit" same_fit
    same_diagnosis() { "$linux" diagnose good.toml worn --reference good --json linux.json && tr -d '\r' <d.json | cmp - linux.json; }
    check "Windows: the same records give Linux's diagnosis, to the last digit" same_diagnosis
    linux_program() {
        cc -O2 -I "$here/linux/$linux_name/include" "$here/linux/$linux_name/share/dashpot/examples/damper.c" "$here/linux/$linux_name/lib/libdashpot.a" -o damper &&
            printf '0.1\n0.2\n-0.3\n' | ./damper demo/damper.toml 0.001 -0.02 | cmp - libdashpot.dll.a.forces
    }
    has cc && check "Windows: the library gives Linux's forces, all digits printed" linux_program
    same_fmu() { dashpot export fmu demo/damper.toml -o windows.fmu && "$linux" export fmu demo/damper.toml -o linux.fmu && cmp windows.fmu linux.fmu; }
    check "Windows: the FMU is Linux's, byte for byte" same_fmu
fi
adams() { dashpot export adams demo/damper.toml -o adamsrun --length 412.5 && cmp adamsrun/dashpot_adams.dll adams/dashpot_adams.dll; }
check "Windows: run folder for Adams holds the library of the package" adams
# Wine 8 has no compiler for the shaders of Direct3D 12, so the window uses OpenGL here. Wine's desktop started without a screen. It is
# ended, so that a new one starts on the screen of the window.
. "$here/checks/window.sh"
wineserver -k
check_window "Windows: the window shows the demonstration's records" wine dashpot-window.exe demo/records demo/damper.toml
wineserver -k || true
