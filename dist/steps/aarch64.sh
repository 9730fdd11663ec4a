# The Linux package for 64-bit Arm: the contents of that for x86-64, without the window and without the libraries for Adams and FMI hosts,
# which are x86-64 programs.
say "command and library for Linux on aarch64"
PATH=$work/venv/bin:$PATH RUSTFLAGS="$maps" cargo zigbuild --quiet --release -p dashpot-cli -p dashpot-dll --target "$arm_target.$glibc" "${profile[@]}"

tree=$staged/aarch64
rm -rf "$tree"
cp -r "$staged/linux" "$tree"
rm -rf "$tree/lib/dashpot" "$tree/bin"
put() { install -D -m "$1" "$2" "$tree/$3"; }
built=$CARGO_TARGET_DIR/$arm_target/release
put 755 "$built/dashpot" bin/dashpot
put 644 "$built/libdashpot.so" lib/libdashpot.so
sh src/dll/static.sh "$built/libdashpot.a" "$work/libdashpot.arm.a" aarch64-linux-gnu-
put 644 "$work/libdashpot.arm.a" lib/libdashpot.a
mkdir -p "$work/said"
python3 dist/licences.py texts $arm_target dashpot-cli dashpot-dll >"$work/said/licences.arm"
put 644 "$work/said/licences.arm" share/doc/dashpot/THIRD-PARTY.txt
"$work/venv/bin/python" dist/licences.py bill $arm_target dashpot-cli dashpot-dll >"$work/said/bill.arm"
put 644 "$work/said/bill.arm" share/doc/dashpot/dashpot.cdx.json
for file in bin/dashpot lib/libdashpot.so; do asks_for_no_more "$tree" "$file" ld-linux-aarch64.so.1; done
