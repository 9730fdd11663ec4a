# The Windows package as a folder, built on Linux by Debian's second Rust compiler. This compiler has the sources of its standard library,
# whereas rustup's has only the library compiled for this system. Its version changes with Debian and is not pinned.
say "command and library for Windows"
sources=$(realpath "$(/usr/bin/rustc --print sysroot)/lib/rustlib/src/rust")
for_windows() {
    # Without a time in the programs, the same sources give the same bytes.
    env -u RUSTUP_TOOLCHAIN -u CARGO RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 \
        CARGO_TARGET_X86_64_PC_WINDOWS_GNU_LINKER=x86_64-w64-mingw32-gcc \
        RUSTFLAGS="$maps --remap-path-prefix=$sources=/rust -Clink-arg=-Wl,--no-insert-timestamp" \
        /usr/bin/cargo build --quiet --release --target $windows_target "${profile[@]}" "$@"
}
# The library does not use std. Built with the command's std, it would have a second panic handler, so it is built alone, and first because
# that is faster.
for_windows -p dashpot-dll -Zbuild-std=core
for_windows -p dashpot-cli -p dashpot-gui -Zbuild-std=std,panic_abort

tree=$staged/windows
rm -rf "$tree"
put() { install -D -m "$1" "$2" "$tree/$3"; }
# Editors on Windows expect Windows line ends.
text() {
    mkdir -p "$tree/$(dirname "$2")"
    sed 's/\r$//; s/$/\r/' "$1" >"$tree/$2"
}
built=$CARGO_TARGET_DIR/$windows_target/release
put 755 "$built/dashpot.exe" dashpot.exe
put 755 "$built/dashpot-window.exe" dashpot-window.exe
put 755 "$built/dashpot.dll" sdk/bin/dashpot.dll
# Import libraries for the linkers of mingw and of Microsoft (link.exe). Both are made from the functions of the library itself.
mkdir -p "$work/import"
{
    echo "LIBRARY dashpot.dll"
    echo "EXPORTS"
    x86_64-w64-mingw32-objdump -p "$built/dashpot.dll" | sed -n '/\[Ordinal\/Name Pointer\] Table/,/^$/s/.* \(dashpot_[a-z_0-9]*\)$/    \1/p' | sort
} >"$work/import/dashpot.def"
[ "$(wc -l <"$work/import/dashpot.def")" -gt 12 ] || fail "dist/build: dashpot.dll exports next to nothing; see $work/import/dashpot.def"
zig dlltool -m i386:x86-64 -d "$work/import/dashpot.def" -D dashpot.dll -l "$work/import/dashpot.lib"
# Without these options, the names of the members would depend on the path of the file or on the process id.
(cd "$work/import" && x86_64-w64-mingw32-dlltool --deterministic-libraries --temp-prefix dashpot -m i386:x86-64 -d dashpot.def -D dashpot.dll -l libdashpot.dll.a)
put 644 "$work/import/dashpot.lib" sdk/lib/dashpot.lib
put 644 "$work/import/libdashpot.dll.a" sdk/lib/libdashpot.dll.a
put 644 "$work/import/dashpot.def" sdk/lib/dashpot.def
text include/dashpot.h sdk/include/dashpot.h
for file in dashpotConfig.cmake dashpotConfigVersion.cmake; do
    sed "s/@VERSION@/$version/" "dist/cmake/$file" >"$work/$file"
    put 644 "$work/$file" "sdk/lib/cmake/dashpot/$file"
done
put 755 "$DASHPOT_RUNTIMES/win64/dashpot_adams.dll" adams/dashpot_adams.dll
put 755 "$DASHPOT_RUNTIMES/win64/dashpot_damper.dll" fmu/dashpot_damper.dll
text adams-usersub/README.md adams/README.md
find examples -type f | sort | while read -r file; do text "$file" "$file"; done
for file in dist/windows/*; do text "$file" "${file##*/}"; done
for file in CHANGELOG.md VERSIONING.md SECURITY.md; do text "$file" "documents/$file"; done
text README.md documents/README.md
find docs -name '*.md' | while read -r file; do text "$file" "documents/$file"; done
find docs -name '*.svg' | while read -r file; do put 644 "$file" "documents/$file"; done
for file in LICENSE-MIT LICENSE-APACHE; do text "$file" "licences/$file.txt"; done
mkdir -p "$work/said"
python3 dist/licences.py texts $windows_target dashpot-cli dashpot-gui dashpot-dll >"$work/said/licences.windows"
text "$work/said/licences.windows" licences/THIRD-PARTY.txt
"$work/venv/bin/python" dist/licences.py bill $windows_target dashpot-cli dashpot-gui dashpot-dll >"$work/said/bill.windows"
put 644 "$work/said/bill.windows" licences/dashpot.cdx.json

# The programs may need only libraries that every 64-bit Windows 10 has.
for file in dashpot.exe dashpot-window.exe sdk/bin/dashpot.dll adams/dashpot_adams.dll fmu/dashpot_damper.dll; do
    needed=$(x86_64-w64-mingw32-objdump -p "$tree/$file" | sed -n 's/^.*DLL Name: //p' | tr 'A-Z\n' 'a-z ')
    say "$file needs $needed"
    for library in $needed; do
        case $library in
            kernel32.dll | msvcrt.dll | ntdll.dll | advapi32.dll | bcrypt.dll | bcryptprimitives.dll | userenv.dll | ws2_32.dll | api-ms-win-*) ;;
            # Libraries that a window needs.
            combase.dll | dwmapi.dll | dwrite.dll | dxgi.dll | gdi32.dll | imm32.dll | ole32.dll | oleaut32.dll | opengl32.dll | propsys.dll | rpcrt4.dll | setupapi.dll | shell32.dll | uiautomationcore.dll | user32.dll | uxtheme.dll) ;;
            *) fail "dist/build: $file needs $library, which Windows may not have" ;;
        esac
    done
done
