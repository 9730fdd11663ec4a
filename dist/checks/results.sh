# Prints one line for each check. A check is a command whose output is shown only if it fails.
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

# Checks that two model files agree: numbers within a relative tolerance, other values exactly. Tables are ignored, because they contain
# intervals and fingerprints of the records' files.
same_model() { # file, file, relative tolerance
    python3 - "$@" <<'P'
import sys, tomllib
def damper(path):
    return {k: v for k, v in tomllib.load(open(path, "rb")).items() if not isinstance(v, dict)}
a, b, share = damper(sys.argv[1]), damper(sys.argv[2]), float(sys.argv[3])
assert a.keys() == b.keys() and len(a) > 5, (sorted(a), sorted(b))
worst = (0.0, "")
for key in a:
    p, q = (x if isinstance(x, list) else [x] for x in (a[key], b[key]))
    assert len(p) == len(q), key
    for m, n in zip(p, q):
        if isinstance(m, float) and m != n:
            worst = max(worst, (abs(m - n) / max(abs(m), abs(n)), key))
        else:
            assert m == n, (key, m, n)
assert worst[0] <= share, f"{worst[1]} differs by {worst[0]:.1e}"
print(f"largest difference {worst[0]:.1e}")
P
}
