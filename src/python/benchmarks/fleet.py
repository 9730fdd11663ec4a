"""Benchmark of a fleet run: campaigns per minute with one worker and with two workers, and memory of the processes.

python src/python/benchmarks/fleet.py [CAMPAIGNS] [FAMILY] [LIMITS.csv]
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from fleets import fleet  # noqa: E402


def processes(group: int) -> list[int]:
    """Returns the ids of the running processes of a process group."""
    out = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                if int((entry / "stat").read_text().rsplit(")", 1)[1].split()[2]) == group:
                    out.append(int(entry.name))
            except (OSError, IndexError):
                pass
    return out


def resident(pid: int) -> float:
    """Returns the resident memory of a process, MiB, or 0 if it has ended."""
    try:
        return int((Path("/proc") / str(pid) / "statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20
    except (OSError, IndexError):
        return 0.0


def measured(listed: Path, out: Path, family: str, workers: int, limits: str | None = None) -> tuple[float, list[float]]:
    """Returns the duration of a run, s, and the largest memory of each of its processes, MiB, in decreasing order."""
    command = [sys.executable, "-m", "dashpot.fleet", listed, "--family", family, "--workers", workers, "--out", out, "--quiet"]
    command += ["--limits", limits] if limits else []
    started = time.monotonic()
    process = subprocess.Popen(list(map(str, command)), start_new_session=True, stdout=subprocess.DEVNULL)
    peak: dict[int, float] = {}
    while process.poll() is None:
        for pid in processes(process.pid):
            peak[pid] = max(peak.get(pid, 0.0), resident(pid))
        time.sleep(0.1)
    if process.returncode:
        sys.exit(process.returncode)
    return time.monotonic() - started, sorted(peak.values(), reverse=True)


def main() -> None:
    """Runs the benchmark and prints its results."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100
    family = sys.argv[2] if len(sys.argv) > 2 else "thesis"
    limits = sys.argv[3] if len(sys.argv) > 3 else None
    with tempfile.TemporaryDirectory() as folder:
        listed = fleet(Path(folder), count)
        for workers in (1, 2):
            load = os.getloadavg()[0]
            seconds, peak = measured(listed, Path(folder) / f"{workers}.parquet", family, workers, limits)
            memory = ", ".join(f"{mib:.0f}" for mib in peak[: workers + 1])
            print(
                f"{count} campaigns, {family}{', limits' if limits else ''}, {workers} workers: {seconds:.0f} s, {60 * count / seconds:.0f} a minute, largest "
                f"processes {memory} MiB (load of the machine before: {load:.1f})",
                flush=True,
            )


if __name__ == "__main__":
    main()
