# Checks the contents of the archives, before anything runs.
names() { # archive
    case $1 in
        *.tar.gz) tar -tzf "$1" ;;
        *.zip | *.whl) unzip -Z1 "$1" ;;
        *.deb) dpkg-deb -c "$1" | awk '{print $6}' ;;
    esac
}
# No archive contains a path of the machine that built it.
no_paths() { # archive
    local folder
    folder=$(mktemp -d "$here/paths.XXXXXX")
    case $1 in
        *.tar.gz) tar -xzf "$1" -C "$folder" ;;
        *.zip | *.whl) unzip -q "$1" -d "$folder" ;;
        *.deb) dpkg-deb -x "$1" "$folder" ;;
    esac
    # Such a path would differ on another machine and give other bytes.
    ! grep -rlF -e "$root" -e "$cargo_home" "$folder"
}
complete() { # archive, names
    local archive=$1 name
    shift
    names "$archive" >"$here/names"
    for name in "$@"; do grep -q "$name" "$here/names" || { echo "$archive lacks $name"; return 1; }; done
}
check "checksums" bash -c "cd '$packages' && sha256sum --check --strict SHA256SUMS"
linux_files=(bin/dashpot$ lib/libdashpot.so$ lib/libdashpot.a$ lib/pkgconfig/dashpot.pc$ lib/cmake/dashpot/dashpotConfig.cmake$ include/dashpot.h$
    lib/dashpot/dashpot_adams.so$ lib/dashpot/dashpot_damper.so$ share/man/man1/dashpot-fit.1$ share/bash-completion/completions/dashpot$
    share/doc/dashpot/THIRD-PARTY.txt$ share/doc/dashpot/dashpot.cdx.json$ share/doc/dashpot/LICENSE-MIT$ share/dashpot/examples/damper.c$)
# The files of the Linux package without the libraries for hosts, which are x86-64 programs.
arm_files=()
for name in "${linux_files[@]}"; do [[ $name == lib/dashpot/dashpot_* ]] || arm_files+=("$name"); done
windows_files=(/dashpot.exe$ sdk/bin/dashpot.dll$ sdk/lib/dashpot.lib$ sdk/lib/libdashpot.dll.a$ sdk/include/dashpot.h$ adams/dashpot_adams.dll$
    fmu/dashpot_damper.dll$ /README.txt$ licences/THIRD-PARTY.txt$ licences/dashpot.cdx.json$ "Try-dashpot.cmd$" examples/damper.c$)
wheel_files=(^dashpot/__init__.py$ ^dashpot/py.typed$ ^dashpot/_native.pyi$ "^dashpot/_native\.[a-z0-9.]*\(so\|pyd\)$" dist-info/METADATA$ dist-info/RECORD$
    dist-info/licenses/THIRD-PARTY.txt$ dist-info/licenses/LICENSE-MIT$ dist-info/sboms/dashpot.cdx.json$)
for archive in "$packages"/*.tar.gz "$packages"/*.deb "$packages"/*.zip "$packages"/*.whl; do
    [ -e "$archive" ] || { skip "${archive##*/}" "not built"; continue; }
    case $archive in
        *.zip) check "${archive##*/} is complete" complete "$archive" "${windows_files[@]}" ;;
        *.whl) check "${archive##*/} is complete" complete "$archive" "${wheel_files[@]}" ;;
        *aarch64*) check "${archive##*/} is complete" complete "$archive" "${arm_files[@]}" ;;
        *) check "${archive##*/} is complete" complete "$archive" "${linux_files[@]}" ;;
    esac
    check "${archive##*/} holds no path of this machine" no_paths "$archive"
done
