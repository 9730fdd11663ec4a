# Tools from PyPI, in versions that are known to work, in their own environment.
tools=(ziglang==0.17.1 cargo-zigbuild==0.24.0 maturin==1.16.0 "cyclonedx-python-lib[json-validation]==11.12.0")
if [ ! -e "$work/venv/${tools[*]}" ]; then
    say "tools from PyPI"
    python3 -m venv "$work/venv"
    "$work/venv/bin/pip" install --quiet "${tools[@]}"
    touch "$work/venv/${tools[*]}"
fi
zig() { "$work/venv/bin/python" -m ziglang "$@"; }
