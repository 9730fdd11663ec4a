# Builds the packages again, from a clone in another folder with its own compiler output. The libraries that are part of every package come
# first, which takes minutes. Then come the packages that exist, which takes as long as dist/build took for them.
git clone --quiet . "$here/clone"
runtimes() {
    (
        cd "$here/clone" && unset CARGO_TARGET_DIR && . dist/steps/common.sh && . dist/steps/runtimes.sh
    ) && diff -r "$DASHPOT_RUNTIMES" "$here/clone/target/dist/cargo/runtimes"
}
check "built a second time in another folder, kernel, FMU runtimes and Adams libraries have the same bytes" runtimes
reproduce() {
    local parts=()
    [ ! -f "$packages/$linux_name.tar.gz" ] || parts+=(linux)
    [ ! -f "$packages/$windows_name.zip" ] || parts+=(windows)
    [ ! -f "$packages/$linux_wheel" ] || parts+=(wheels)
    [ ! -f "$packages/$arm_name.tar.gz" ] || parts+=(aarch64)
    (cd "$here/clone" && env -u CARGO_TARGET_DIR dist/build "${parts[@]}") || return 1
    diff "$packages/SHA256SUMS" "$here/clone/target/dist/packages/SHA256SUMS"
}
check "built a second time in another folder, the packages have the same bytes" reproduce
