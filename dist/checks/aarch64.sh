# The package for 64-bit Arm, run by an emulator. Its results must have the same digits as those of the package for
# x86-64. Runs in $here.
. "$here/checks/results.sh"
[ -e "$here/packages/$arm_name.tar.gz" ] || { skip "aarch64" "not built"; exit 0; }
[ -e "$here/packages/$linux_name.tar.gz" ] || { skip "aarch64" "the package for x86-64, to compare with, is not built"; exit 0; }
for tool in qemu-aarch64 aarch64-linux-gnu-gcc cc; do
    has $tool || { skip "aarch64" "needs $tool (Debian: qemu-user gcc-aarch64-linux-gnu libc6-dev-arm64-cross gcc)"; exit 0; }
done
mkdir -p "$here/aarch64" && cd "$here/aarch64"
tar -xzf "$here/packages/$arm_name.tar.gz" && tar -xzf "$here/packages/$linux_name.tar.gz"
export QEMU_LD_PREFIX=/usr/aarch64-linux-gnu
# The command of the package for Arm, and that of the package for x86-64.
on_arm() { qemu-aarch64 "$here/aarch64/$arm_name/bin/dashpot" "$@"; }
on_intel() { "$here/aarch64/$linux_name/bin/dashpot" "$@"; }

say_version() { [ "$(on_arm --version)" = "$(on_intel --version)" ] && on_arm --version; }
check "aarch64: version" say_version
demo() { on_arm demo -o demo && grep -q '<svg' demo/report.html && [ -s demo/damper.toml ]; }
check "aarch64: demo" demo
campaign() { on_intel matrix --amplitudes 50,15,1 --peak-velocities 52,262,1047 -o small.csv && on_intel rig -o records --matrix small.csv --seed 3; }
fits() { on_arm fit records -o arm.toml && on_intel fit records -o intel.toml && on_arm validate arm.toml records --report arm.html && same_model arm.toml intel.toml 0; }
check "aarch64: fit and validate; the model is that of x86-64, to the last digit" eval 'campaign && fits'
forces() {
    python3 -c "
import math
print('time_s,displacement_m')
for k in range(5001): print(f'{k / 500!r},{0.02 * math.sin(9 * k / 500) + 0.004 * math.sin(70 * k / 500)!r}')" >motion.csv
    on_arm simulate intel.toml motion.csv -o arm.csv && on_intel simulate intel.toml motion.csv -o intel.csv && cmp arm.csv intel.csv && [ "$(wc -l <arm.csv)" = 5002 ]
}
check "aarch64: the forces of a motion are those of x86-64, to the last digit" forces

# The library, with one model for every element and 20,000 steps each of a random motion like that of a wheel.
programs() {
    aarch64-linux-gnu-gcc -O2 -I "$arm_name/include" "$arm_name/share/dashpot/examples/damper.c" "$arm_name/lib/libdashpot.a" -o arm.static &&
        aarch64-linux-gnu-gcc -O2 -I "$arm_name/include" "$arm_name/share/dashpot/examples/damper.c" -L "$arm_name/lib" -ldashpot -o arm.shared &&
        cc -O2 -I "$linux_name/include" "$linux_name/share/dashpot/examples/damper.c" "$linux_name/lib/libdashpot.a" -o intel.static
}
check "aarch64: C programs, library static and shared" programs
elements() {
    local element number=0
    python3 -c "
import random
draw, v = random.Random(5), 0.0
for k in range(20000):
    v = 0.98 * v + 0.05 * draw.gauss(0, 1)
    print(repr(v))" >velocities
    # The headings of the page of parameters are the names of the elements.
    for element in $(sed -n 's/^## `\([a-z_]*\)`.*/\1/p' "$linux_name/share/doc/dashpot/docs/parameters.md"); do
        case $element in fv_curve | series_compliance | integration) continue ;; esac
        printf 'format = 1\nelements = ["fv_curve", "series_compliance", "%s"]\n' "$element" >one.toml
        ./intel.static one.toml 0.001 0 <velocities >intel.forces && qemu-aarch64 ./arm.static one.toml 0.001 0 <velocities >arm.forces || return 1
        [ "$(wc -l <intel.forces)" = 20000 ] && cmp intel.forces arm.forces || { echo "with $element"; return 1; }
        number=$((number + 1))
    done
    LD_LIBRARY_PATH=$arm_name/lib qemu-aarch64 -E LD_LIBRARY_PATH="$arm_name/lib" ./arm.shared one.toml 0.001 0 <velocities | cmp - arm.forces && echo "$number elements" && [ "$number" -gt 15 ]
}
check "aarch64: every element gives the forces of x86-64 in C, all digits printed" elements
