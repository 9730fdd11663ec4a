# Packs the staged trees into archives: sorted, with one owner and one time, so that the same tree gives the same bytes.
say "packing"
rm -rf "$packages"
mkdir -p "$packages"
if [ -d "$staged/linux" ]; then
    python3 dist/archive.py tar "$staged/linux" "$linux_name" "$packages/$linux_name.tar.gz"
    # The same tree below /usr.
    debian=$work/debian
    rm -rf "$debian"
    mkdir -p "$debian/DEBIAN" "$debian/usr"
    cp -r "$staged/linux/." "$debian/usr"
    size=$(du -sk --apparent-size "$debian/usr" | cut -f1)
    sed "s/@VERSION@/$version/; s/@SIZE@/$size/; s/@GLIBC@/$glibc/" dist/linux/control >"$debian/DEBIAN/control"
    find "$debian" -exec touch --no-dereference --date="@$SOURCE_DATE_EPOCH" {} +
    chmod -R u=rwX,go=rX "$debian"
    dpkg-deb --root-owner-group -Zxz --build "$debian" "$packages/dashpot_${version}_amd64.deb" >/dev/null
fi
if [ -d "$staged/aarch64" ]; then
    python3 dist/archive.py tar "$staged/aarch64" "$arm_name" "$packages/$arm_name.tar.gz"
fi
if [ -d "$staged/windows" ]; then
    python3 dist/archive.py zip "$staged/windows" "$windows_name" "$packages/$windows_name.zip"
fi
for folder in "$staged"/wheels/*; do
    if [ -d "$folder" ]; then python3 dist/archive.py wheel "$folder" "$packages/${folder##*/}.whl"; fi
done
(cd "$packages" && find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%P\n' | sort | xargs -r sha256sum >SHA256SUMS)
for file in "$packages"/*; do say "$(du -h --apparent-size "$file" | cut -f1) $file"; done
