"""Tests of a fleet on a real Slurm. They are skipped without Slurm; ``slurm.sh`` in this folder starts one on Debian."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest
from fleets import fleet

pytest.importorskip("pyarrow.parquet")
# The module is searched but not imported, because its import installs a handler of Ctrl-C for all tests of this process.
if importlib.util.find_spec("dask_jobqueue") is None:
    pytest.skip("dask-jobqueue is not installed", allow_module_level=True)


def answers() -> bool:
    """Returns whether Slurm accepts jobs on this computer."""
    if shutil.which("sinfo") is None:
        return False
    told = subprocess.run(["sinfo", "-h", "-o", "%T"], capture_output=True, text=True, check=False)
    return told.returncode == 0 and any(state in told.stdout for state in ("idle", "mixed", "allocated"))


pytestmark = pytest.mark.skipif(not answers(), reason="no Slurm here; tests/slurm.sh starts one")

#: Elements of the test dampers.
ELEMENTS = "series_compliance,coulomb_friction,gas_preload"


@pytest.fixture(scope="module")
def campaigns(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return fleet(tmp_path_factory.mktemp("fleet"), 24)


def start(folder: Path, *arguments: str | Path) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "dashpot.fleet", *map(str, arguments)]
    return subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def finished(process: subprocess.Popen[str]) -> str:
    said, _ = process.communicate(timeout=300)
    assert process.returncode == 0, said
    return said


def running() -> list[str]:
    told = subprocess.run(["squeue", "-h", "-t", "R", "-n", "dask-worker", "-o", "%A"], capture_output=True, text=True, check=True)
    return told.stdout.split()


def test_the_table_is_that_of_this_computer_and_nothing_lies_about(campaigns: Path, tmp_path: Path) -> None:
    common: list[str | Path] = [campaigns, "--family", "fv", "--chunk", "3"]
    finished(start(tmp_path, *common, "--workers", "1", "--out", "local.parquet"))
    finished(start(tmp_path, *common, "--slurm", "2", "--out", "slurm.parquet"))
    assert (tmp_path / "slurm.parquet").read_bytes() == (tmp_path / "local.parquet").read_bytes()
    names = {"local.parquet", "local.parquet.parts", "slurm.parquet", "slurm.parquet.parts"}
    assert {entry.name for entry in tmp_path.iterdir()} == names


def test_jobs_that_the_scheduler_ends_are_replaced(campaigns: Path, tmp_path: Path) -> None:
    process = start(tmp_path, campaigns, "--elements", ELEMENTS, "--chunk", "2", "--slurm", "2", "--out", "out.parquet")
    deadline = time.monotonic() + 120
    while not list((tmp_path / "out.parquet.parts").glob("*.parquet")):
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.2)
    ended = running()
    assert ended
    subprocess.run(["scancel", *ended], check=True)
    said = finished(process)
    assert "24 campaigns" in said and "0 failed" in said


def test_a_refusal_is_told(campaigns: Path, tmp_path: Path) -> None:
    process = start(tmp_path, campaigns, "--slurm", "1", "--slurm-queue", "nowhere", "--out", "out.parquet")
    said, _ = process.communicate(timeout=60)
    assert process.returncode == 2 and "invalid partition" in said and "--slurm-queue" in said
