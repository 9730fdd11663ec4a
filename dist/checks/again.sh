# The step of the archives a second time, from what was staged: every archive has the same bytes. What this does not show is that the compilers
# give the same bytes a second time: that is `dist/check reproduce`.
again() {
    cp -r "$packages" "$here/first" || return 1
    # Other times and another order on the disk must not show.
    for tree in "$staged"/*; do cp -r "$tree" "$tree.again" && rm -rf "$tree" && mv "$tree.again" "$tree"; done
    dist/build pack || return 1
    cmp "$here/first/SHA256SUMS" "$packages/SHA256SUMS" && cat "$packages/SHA256SUMS"
}
check "packed a second time, the archives have the same bytes" again
