# Packs the staged files again: every archive must have the same bytes. It does not check that the compilers give the same bytes again,
# which `dist/check reproduce` does.
again() {
    cp -r "$packages" "$here/first" || return 1
    # Other file times and another order on the disk must have no effect.
    for tree in "$staged"/*; do cp -r "$tree" "$tree.again" && rm -rf "$tree" && mv "$tree.again" "$tree"; done
    dist/build pack || return 1
    cmp "$here/first/SHA256SUMS" "$packages/SHA256SUMS" && cat "$packages/SHA256SUMS"
}
check "packed a second time, the archives have the same bytes" again
