"""Fixtures: records of the virtual rig, a fitted model, and the command with which the package is compared."""

from __future__ import annotations

import os
import re
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import pytest

import dashpot
from dashpot._arguments import loads

#: Path of the command, built from the same sources. Without it, tests that compare with the command are skipped.
COMMAND = os.environ.get("DASHPOT_COMMAND")


class Command:
    """The command ``dashpot``, which runs in a folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __call__(self, *arguments: str) -> str:
        """Runs the command, which must succeed, and returns its standard output."""
        ran = self.run(*arguments)
        assert ran.returncode == 0, ran.stderr
        return ran.stdout

    def run(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        assert COMMAND is not None
        return subprocess.run([COMMAND, *arguments], cwd=self.folder, capture_output=True, text=True, check=False)

    def json(self, name: str) -> Any:
        """Reads a JSON file of the command. Options in its messages are replaced by arguments of the package."""
        return loads((self.folder / name).read_text())


def content(path: Path) -> Any:
    """Returns the content of a report or workbook without its command, which names the files that the command wrote."""
    if path.suffix != ".xlsx":
        return re.sub(rb"dashpot (fit|validate|diagnose) [^<]*<", b"<", path.read_bytes())
    with zipfile.ZipFile(path) as book:
        return {name: re.sub(rb"dashpot (fit|validate|diagnose) [^<]*<", b"<", book.read(name)) for name in book.namelist()}


@pytest.fixture(scope="session")
def command(tmp_path_factory: pytest.TempPathFactory) -> Command:
    if COMMAND is None:
        pytest.skip("DASHPOT_COMMAND does not name the command to compare with")
    return Command(tmp_path_factory.mktemp("command"))


@pytest.fixture(scope="session")
def records(command: Command) -> Path:
    """Makes a small campaign of the virtual rig and returns its folder."""
    command("matrix", "--amplitudes", "50,15,1", "--peak-velocities", "52,262,1047", "-o", "small.csv")
    command("rig", "-o", "records", "--matrix", "small.csv", "--seed", "3")
    return command.folder / "records"


@pytest.fixture(scope="session")
def campaign(records: Path) -> dashpot.Campaign:
    return dashpot.Campaign.read(records)


@pytest.fixture(scope="session")
def model(campaign: dashpot.Campaign) -> dashpot.FittedModel:
    return dashpot.fit(campaign)
