# Everything a second time, from a clone in another folder with compilers' results of its own.
reproduce() {
    git clone --quiet . "$here/clone" || return 1
    (cd "$here/clone" && env -u CARGO_TARGET_DIR dist/build) || return 1
    diff "$packages/SHA256SUMS" "$here/clone/target/dist/packages/SHA256SUMS"
}
check "built a second time in another folder, the packages have the same bytes" reproduce
