"""Tests that messages to users of the package name arguments, and not options of the command."""

from __future__ import annotations

import inspect
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fleets import damper, measure

import dashpot
from dashpot import _arguments
from dashpot._arguments import as_arguments, loads

SOURCES = Path(__file__).parents[2]
OPTION = re.compile(r"(?<![\w-])--[a-z]")
#: Pattern of a whole command in a message. It may contain options, because the user runs it as a command.
COMMAND = re.compile(r"dashpot [a-z-]+( [A-Z-]+)* --[a-z-]+")
#: Values for the placeholders of a message whose value affects the replacement of options.
AT = {"channel": "force", "of_first": "force", "of_second": "displacement", "what": "rebound_force", "example": "force", "likely": "kN", "written": "N"}


def sentences() -> Iterator[tuple[str, str]]:
    """Yields every text with an option in the sources of reading, fit and diagnosis. Values replace its placeholders."""
    for crate in ("records", "estimation", "identification", "diagnosis", "proving"):
        for file in sorted((SOURCES / crate / "src").rglob("*.rs")):
            # Unit tests are at the end of a file and are skipped. The file of literature models is skipped too, because its texts are part of
            # those model files.
            code = file.read_text().split("#[cfg(test)]")[0]
            if file.stem == "tests" or file.parts[-2:] == ("literature", "file.rs"):
                continue
            for text in re.findall(r'"((?:[^"\\]|\\.)*)"', re.sub(r"^\s*//.*$", "", code, flags=re.MULTILINE), re.DOTALL):
                said = re.sub(r"\\\n\s*", "", text).replace('\\"', '"')
                if OPTION.search(said):
                    yield str(file.relative_to(SOURCES)), re.sub(r"\{(\w*)[^}]*\}", lambda place: AT.get(place[1], "0.0123"), said)


def test_every_sentence_with_an_option_speaks_of_arguments() -> None:
    found = list(sentences())
    # A much smaller number of texts would mean that the search in the sources no longer works. 6 texts are in diagnosis and identification.
    assert len(found) > 50 and {file.split("/")[0] for file, _ in found} >= {"records", "identification", "diagnosis"}
    for file, said in found:
        assert not OPTION.search(COMMAND.sub("", as_arguments(said))), (file, as_arguments(said))


def test_arguments_that_are_named_are_there() -> None:
    functions = (
        dashpot.Campaign.read, dashpot.fit, dashpot.diagnose, dashpot.Model.validate, dashpot.Model.simulate, dashpot.Model.check,
        dashpot.Model.export_fmu, dashpot.Model.from_peaks, dashpot.measure_virtual, dashpot.diagnose_groups,
    )  # fmt: skip
    there = {name for function in functions for name in inspect.signature(function).parameters}
    assert {name.split("=")[0] for name in _arguments._NAMES.values()} <= there


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Give --delay 0.0065", "Give delay_s=0.0065"),
        ("their records need --delay=0.006500 --rig-mass=2.000000.", "their records need delay_s=0.006500, rig_mass_kg=2.000000."),
        ("--column displacement=1 --column force=2 --unit force=N --sample-rate 1000",
         'columns={"displacement": "1", "force": "2"}, units={"force": "N"}, sample_rate_hz=1000'),
        ("or leave it out with --exclude", "or leave it out with exclude"),
        ("say which it is with --positive rebound or --positive compression", 'say which it is with positive="rebound" or positive="compression"'),
    ],
)  # fmt: skip
def test_options_become_arguments(said: str, meant: str) -> None:
    assert as_arguments(said) == meant
    assert loads(f'{{"notes": ["{said}"], "n": 0.1}}') == {"notes": [meant], "n": 0.1}


def strings(said: Any) -> Iterator[str]:
    if isinstance(said, str):
        yield said
    elif isinstance(said, (list, dict)):
        for one in said.values() if isinstance(said, dict) else said:
            yield from strings(one)


def test_notes_of_records_models_and_diagnoses_speak_of_arguments(tmp_path: Path) -> None:
    measure(damper(), tmp_path / "campaign", seed=1)
    shutil.copytree(tmp_path / "campaign", tmp_path / "campaign" / "more")
    campaign = dashpot.Campaign.read(tmp_path / "campaign")
    assert any("subfolders=True reads them too" in note.text for note in campaign.notes)
    model = dashpot.fit(campaign, family="fv")
    flat = model.text.split("\n[identification]")[0]
    noted = dashpot.Model(flat + "\n[identification]\nnotes = [\"give --delay=0.0065 to read it so\"]\n")
    assert noted.notes == ("give delay_s=0.0065 to read it so",) and "--delay=0.0065" in noted.text
    found = dashpot.diagnose(model, campaign, candidates=["coulomb_friction"])
    for result in (campaign, noted, model, model.fit, model.validate(campaign), found):
        for text in strings(result.to_dict()):
            assert not OPTION.search(COMMAND.sub("", text)), text
