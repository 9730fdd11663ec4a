"""Tests of the Python code in documents: every block passes mypy --strict and runs without changes."""

from __future__ import annotations

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from fleets import TESTS, damper, measure

ROOT = Path(__file__).parents[3]
#: Expected number of Python blocks in each document. The test fails if a document loses its blocks.
PAGES = {"README.md": 1, "src/python/README.md": 1, "docs/book/src/python.md": 8, "docs/book/src/fleet.md": 0}


def blocks(page: str) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```$", (ROOT / page).read_text(), re.MULTILINE | re.DOTALL)


BLOCKS = [(page, k, text) for page in PAGES for k, text in enumerate(blocks(page))]
every_block = pytest.mark.parametrize("block", BLOCKS, ids=lambda b: f"{b[0]}-{b[1] + 1}")


def test_there_are_blocks() -> None:
    assert {page: len(blocks(page)) for page in PAGES} == PAGES


@every_block
def test_a_block_passes_the_strict_type_checker(block: tuple[str, int, str], tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    (tmp_path / "page.py").write_text(block[2])
    # FMPy has no type annotations, so its users also need this option of mypy.
    (tmp_path / "mypy.ini").write_text("[mypy]\nstrict = true\n[mypy-fmpy.*]\nignore_missing_imports = true\n")
    ran = subprocess.run(
        [sys.executable, "-m", "mypy", "page.py"], cwd=tmp_path, capture_output=True, text=True, check=False,
        env={**os.environ, "MYPYPATH": str(ROOT / "examples")},
    )  # fmt: skip
    assert ran.returncode == 0, ran.stdout + ran.stderr


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Makes a folder with the files that the documents assume."""
    folder = tmp_path_factory.mktemp("pages")
    measure(damper(), folder / "campaign", seed=1, tests=(*TESTS, (0.04, 0.3)))
    measure(damper(friction=80), folder / "other", seed=2, tests=(*TESTS, (0.04, 0.3)))
    for name, friction in (("sn17", 30), ("sn18", 80)):
        measure(damper(friction=friction), folder / "fleet" / name, seed=friction)
    for current, scale in (("0A", 0.6), ("0.8A", 1.0), ("1.6A", 1.5)):
        measure(damper(scale), folder / "semi_active" / current, seed=3, tests=(*TESTS, (0.04, 0.3)))
    (folder / "peaks.csv").write_text("velocity_m_s,force_N\n0.1,500\n0.3,900\n-0.1,-300\n-0.3,-600\n")
    (folder / "limits.csv").write_text("quantity,velocity_m_s,low,high\nforce,0.26,1,5000\nfriction,,0,100\n")
    for name, scale in (("rear.toml", 0.8), ("damper.toml", 1.0)):
        damper(scale).write(folder / name)
    library = Path(os.environ.get("DASHPOT_LIBRARY", "nowhere")).with_suffix(".so")
    if library.exists():
        shutil.copy(library, folder / "libdashpot.so")
    return folder


@every_block
def test_a_block_runs(block: tuple[str, int, str], folder: Path) -> None:
    text = block[2]
    if "fmpy" in text and (importlib.util.find_spec("fmpy") is None or not (folder / "damper.fmu").exists()):
        pytest.skip("FMPy is not installed, or this package was built without the runtimes of an FMU")
    if "libdashpot.so" in text and not (folder / "libdashpot.so").exists():
        pytest.skip("DASHPOT_LIBRARY names no library with a libdashpot.so beside it")
    if 'model.write("damper.toml")' in text:
        # The document's code writes a new file, and would fail if another one existed.
        (folder / "damper.toml").unlink(missing_ok=True)
    ran = subprocess.run(
        [sys.executable, "-c", text], cwd=folder, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONPATH": str(ROOT / "examples")}
    )
    if "export_fmu" in text and "runtimes.sh" in ran.stderr:
        # The code before the export has run.
        pytest.skip("this package was built without the runtimes of an FMU")
    assert ran.returncode == 0, ran.stdout + ran.stderr
