# The Linux package as a tree below a prefix, which is /usr or the unpacked folder.
say "command for Linux with glibc $glibc"
PATH=$work/venv/bin:$PATH RUSTFLAGS="$maps" cargo zigbuild --quiet --release -p dashpot-cli -p dashpot-gui --target "$linux_target.$glibc" "${profile[@]}"

tree=$staged/linux
rm -rf "$tree"
put() { install -D -m "$1" "$2" "$tree/$3"; }
put 755 "$CARGO_TARGET_DIR/$linux_target/release/dashpot" bin/dashpot
put 755 "$CARGO_TARGET_DIR/$linux_target/release/dashpot-window" bin/dashpot-window
put 644 "$CARGO_TARGET_DIR/release/libdashpot.so" lib/libdashpot.so
sh src/dll/static.sh "$CARGO_TARGET_DIR/release/libdashpot.a" "$work/libdashpot.a"
put 644 "$work/libdashpot.a" lib/libdashpot.a
put 644 include/dashpot.h include/dashpot.h
put 644 "$DASHPOT_RUNTIMES/linux64/dashpot_adams.so" lib/dashpot/dashpot_adams.so
put 644 "$DASHPOT_RUNTIMES/linux64/dashpot_damper.so" lib/dashpot/dashpot_damper.so
for file in dashpotConfig.cmake dashpotConfigVersion.cmake; do
    sed "s/@VERSION@/$version/" "dist/cmake/$file" >"$work/$file"
    put 644 "$work/$file" "lib/cmake/dashpot/$file"
done
sed "s/@VERSION@/$version/" dist/linux/dashpot.pc >"$work/dashpot.pc"
put 644 "$work/dashpot.pc" lib/pkgconfig/dashpot.pc
find examples -type f | sort | while read -r file; do put 644 "$file" "share/dashpot/$file"; done

command=$tree/bin/dashpot
rm -rf "$work/said"
mkdir -p "$work/said"
"$command" man "$work/said/man1" >/dev/null
for page in "$work"/said/man1/*; do put 644 "$page" "share/man/man1/${page##*/}"; done
complete() {
    "$command" completions "$1" -o "$work/said/$1"
    put 644 "$work/said/$1" "$2"
}
complete bash share/bash-completion/completions/dashpot
complete zsh share/zsh/site-functions/_dashpot
complete fish share/fish/vendor_completions.d/dashpot.fish

documents=share/doc/dashpot
for file in README.md CHANGELOG.md VERSIONING.md SECURITY.md LICENSE-MIT LICENSE-APACHE; do put 644 "$file" "$documents/$file"; done
find docs -name '*.md' -o -name '*.svg' | while read -r file; do put 644 "$file" "$documents/$file"; done
python3 dist/licences.py texts "$linux_target" dashpot-cli dashpot-gui dashpot-dll >"$work/said/licences"
put 644 "$work/said/licences" "$documents/THIRD-PARTY.txt"
"$work/venv/bin/python" dist/licences.py bill "$linux_target" dashpot-cli dashpot-gui dashpot-dll >"$work/said/bill"
put 644 "$work/said/bill" "$documents/dashpot.cdx.json"

for file in bin/dashpot bin/dashpot-window lib/libdashpot.so lib/dashpot/dashpot_adams.so lib/dashpot/dashpot_damper.so; do
    asks_for_no_more "$tree" "$file" ld-linux-x86-64.so.2
done
