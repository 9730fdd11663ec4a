# Runs Windows programs under Wine, in a new Wine prefix, and adds a library that Wine 8 lacks.
export WINEPREFIX=$here/wine WINEDEBUG=-all
start_wine() { # folder of the program
    # The Windows library from which Rust's hash tables get their seed. It is for this check only and in no package.
    cat >"$here/primitives.c" <<'C'
__declspec(dllexport) int ProcessPrng(unsigned char *bytes, unsigned long long count)
{
    while (count--) bytes[count] = (unsigned char)(37 * count + 11);
    return 1;
}
C
    x86_64-w64-mingw32-gcc -shared -o "$1/bcryptprimitives.dll" "$here/primitives.c"
    [ -d "$WINEPREFIX" ] || wineboot -i >/dev/null 2>&1
}
