# One line for each check. A check is a command whose output is shown only where it fails.
result() {
    echo "$1"
    echo "$1" >>"$here/results"
}
check() { # name, command...
    local name=$1
    shift
    if "$@" >"$here/said" 2>&1; then
        result "ok      $name"
    else
        result "FAILED  $name"
        sed 's/^/        | /' "$here/said" | tail -25
    fi
}
skip() { result "skipped $1: $2"; }
has() { command -v "$1" >/dev/null; }

# Parameters of two model files agree: numbers within a share, texts wholly. Comments hold intervals and are left out.
same_model() { # file, file, share
    python3 - "$@" <<'P'
import re, sys
def numbers(path):
    text = "\n".join(line.split("#")[0] for line in open(path, encoding="utf-8"))
    # A list may run over lines.
    return {k.strip(): v for k, v in re.findall(r"(?m)^(\w+) *= *(\[[^\]]*\]|.*)$", text)}
a, b, share = numbers(sys.argv[1]), numbers(sys.argv[2]), float(sys.argv[3])
assert a.keys() == b.keys() and len(a) > 5, (sorted(a), sorted(b))
worst = 0.0
for key in a:
    p, q = ([float(n) if re.fullmatch(r"[-+0-9.e]+", n) else n for n in re.split(r"[\s,\[\]]+", x) if n] for x in (a[key], b[key]))
    assert len(p) == len(q), key
    for m, n in zip(p, q):
        if isinstance(m, float):
            worst = max(worst, abs(m - n) / max(abs(m), abs(n), 1e-12))
        else:
            assert m == n, (key, m, n)
assert worst <= share, f"numbers differ by {worst:.1e}"
print(f"largest difference {worst:.1e}")
P
}
