"""Tests that diagnoses of many dampers against one reference equal those of the command byte by byte."""

from __future__ import annotations

import copy
import pickle
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Command, content
from fleets import damper, measure

import dashpot
from dashpot._arguments import as_arguments

#: Restrictions that make a diagnosis quick, as options of the command and as arguments.
FEW = ["--candidates", "free_play", "--max-effects", "1"]
few: dict[str, Any] = {"candidates": "free_play", "max_effects": 1}


@pytest.fixture
def fleet(command: Command, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Makes records of dampers in separate folders and in one campaign, a good damper, and its model. Python runs in their folder."""
    root = command.folder / "of groups"
    if not root.exists():
        measure(damper(), root / "good", seed=1)
        for name, scale, friction in (("sn9", 1.0, 30.0), ("sn10", 1.25, 30.0), ("sn11", 1.0, 90.0)):
            measure(damper(scale, friction), root / "fleet" / name, seed=len(name) + int(friction))
        (root / "together").mkdir()
        for clicks, name in ((10, "sn10"), (9, "sn9"), (11, "sn11")):
            for file in (root / "fleet" / name).iterdir():
                shutil.copy(file, root / "together" / f"c{clicks}_{file.name}")
        shutil.copy(root / "good" / "a25_v260.csv", root / "together" / "warm up.csv")
        (root / "together" / "no record.csv").write_text("a note\n")
        (root / "tests.csv").write_text("test;clicks\nc9_*;9\nc10_*;10\nc11_*;11\nc12_*;12\n")
        (root / "dampers.csv").write_text("damper,batch\nfleet/sn9,spring\nfleet/sn10,autumn\nfleet/sn11,\n")
        fitted = dashpot.fit(dashpot.Campaign.read(root / "good"), elements=["series_compliance", "coulomb_friction", "gas_preload"])
        fitted.write(root / "good.toml")
    monkeypatch.chdir(root)
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    return root


def same(command: Command, found: dashpot.GroupsDiagnosis, *arguments: str, language: str = "en") -> None:
    """Checks that JSON, report and workbook equal those of the command."""
    beside = copy.copy(command)
    beside.folder = command.folder / "of groups"
    chosen = [] if language == "en" else ["--language", language]
    beside("diagnose", "good.toml", *arguments, *chosen, "--json", "c.json", "--report", "c.html", "--excel", "c.xlsx")
    assert found.to_dict() == beside.json("c.json")
    found.write_report("p.html", language=language)
    found.write_excel("p.xlsx", language=language)
    assert all(content(Path(f"p.{kind}")) == content(Path(f"c.{kind}")) for kind in ("html", "xlsx"))
    assert "SHA-256" in Path("p.html").read_text() or language != "en"


def test_folders_against_a_reference(command: Command, fleet: Path) -> None:
    model = dashpot.Model.read("good.toml")
    told: list[float] = []
    found = dashpot.diagnose_groups(model, "fleet", "folders", "good", **few, progress=lambda done, text: told.append(done))
    same(command, found, "fleet", "--group", "folders", "--reference", "good", *FEW)
    assert told == sorted(told) and told[-1] == 1.0
    assert list(found) == ["sn10", "sn11", "sn9"] and found.reference == "good" and len(found) == 3
    assert "coulomb_force" in {c.name for c in found["sn11"].changes} and not found["sn9"].changes
    # The result for one group equals the diagnosis of this damper alone.
    alone = dashpot.diagnose(model, dashpot.Campaign.read("fleet/sn11"), dashpot.Campaign.read("good"), **few).to_dict()
    assert {key: alone[key] for key in found["sn11"].to_dict()} == found["sn11"].to_dict()
    test = found["sn11"].tests[0]
    curves = found["sn11"].curves(test.test)
    assert np.sqrt(np.mean((curves["measured"] - curves["before"]) ** 2)) == pytest.approx(test.before_rmse_n, rel=1e-9)
    with pytest.raises(KeyError, match="there is no group 'sn12' beside the reference 'good'; there are 'sn10', 'sn11', 'sn9'"):
        found["sn12"]


def test_tests_of_a_campaign_by_their_names(command: Command, fleet: Path) -> None:
    model = dashpot.Model.read("good.toml")
    # The records are read by the function, or before its call. The first group is the reference, and 9 precedes 10.
    how: dict[str, Any] = {"exclude": "*v3", "gain": 1.01}
    for data, reading in (("together", how), (dashpot.Campaign.read("together", **how), {})):
        found = dashpot.diagnose_groups(model, data, "c{}_*", **few, **reading)
        same(command, found, "together", "--exclude", "*v3", "--gain=1.01", "--group", "c{}_*", *FEW, language="de")
        assert found.reference == "9" and list(found) == ["10", "11"]
        assert found.left_aside == ("warm up",) and "no record" in found.unusable[0].why and [g.tests for g in found.groups] == [4, 4]
    chain = dashpot.diagnose_groups(model, "together", "c{}_*", chain=True, **few)
    same(command, chain, "together", "--group", "c{}_*", "--chain", *FEW)
    assert [(one.group, one.reference) for one in chain.groups] == [("10", "9"), ("11", "10")]
    by_list = dashpot.diagnose_groups(model, Path("together"), "tests.csv:Clicks", reference=["good"], seed=3, **few)
    same(command, by_list, "together", "--group", "tests.csv:Clicks", "--reference", "good", *FEW, "--seed", "3")
    assert by_list.without_test == ("c12_* (line 5)",)


def test_folders_of_a_list(command: Command, fleet: Path) -> None:
    found = dashpot.diagnose_groups(dashpot.Model.read("good.toml"), ["fleet"], "dampers.csv:batch", **few)
    same(command, found, "fleet", "--group", "dampers.csv:batch", *FEW, language="zh")
    assert found.reference == "autumn" and list(found) == ["spring"] and found.left_aside == ("fleet/sn11",)


def test_what_no_command_makes_names_none(fleet: Path) -> None:
    model, together = dashpot.Model.read("good.toml"), dashpot.Campaign.read("together")
    others: list[dashpot.GroupsDiagnosis] = [
        dashpot.diagnose_groups(model, [r for r in together if r.name != "warm up"], "c{}_*", **few),
        dashpot.diagnose_groups(model, together, "c{}_*", dashpot.Campaign.read("good", gain=1.02), **few),
        dashpot.diagnose_groups(model, together, "c{}_*", dashpot.Campaign.read("good")[:], **few),
        dashpot.diagnose_groups(dashpot.Model(model.text), together, "c{}_*", "good", **few),
    ]
    for found in others:
        found.write_report("q.html")
        assert "Command:" not in Path("q.html").read_text() and "SHA-256" in Path("q.html").read_text()
    assert others[0].left_aside == () and others[2].reference.startswith("a5_v130, ")
    as_read = dashpot.diagnose_groups(model, together, "c{}_*", dashpot.Campaign.read("good"), **few)
    as_read.write_report("q.html")
    assert "dashpot diagnose good.toml together --group" in Path("q.html").read_text()


def test_what_a_user_sees(fleet: Path) -> None:
    pandas = pytest.importorskip("pandas")
    found = dashpot.diagnose_groups(dashpot.Model.read("good.toml"), "fleet", "folders", "good", **few)
    rows = found.to_pandas()
    assert isinstance(rows, pandas.DataFrame) and list(rows["group"]) == ["sn10", "sn11", "sn9"]
    assert {"effect", "confidence", "before_rmse_n", "after_rmse_n", "noise_n", "verdict", "summary"} <= set(rows)
    changed = found.tables()["groups.diagnosis.changes"]
    assert set(changed["of"]) == {"sn10", "sn11"} and "coulomb_force" in set(changed[changed["of"] == "sn11"]["name"])
    shown = found._repr_html_()
    assert "Compared with good" in shown and "sn11" in shown and "groups.diagnosis.changes" in shown
    assert "sn11" in repr(found.groups[1]) and "3 of Group" in repr(found)
    assert "coulomb_force" in found["sn11"]._repr_html_()
    again = dashpot.GroupsDiagnosis.from_dict(found.to_dict())
    kept = pickle.loads(pickle.dumps(found))
    for other in (again, kept):
        assert other == found and other.to_dict() == found.to_dict()
        with pytest.raises(ValueError, match=r"kept by dashpot\.diagnose_groups alone.*diagnose again"):
            other.write_report("q.html")
    assert kept["sn9"].curves("a25_v260") and kept.notes == found.notes
    with pytest.raises(ValueError, match=r"kept by diagnose\(\) and diagnose_groups\(\) alone"):
        again["sn9"].curves("a25_v260")


def test_two_effects_are_two_rows(fleet: Path) -> None:
    pytest.importorskip("pandas")
    said = dashpot.diagnose_groups(dashpot.Model.read("good.toml"), "fleet", "folders", "good", **few).to_dict()
    evidence = dict.fromkeys(("fraction", "mean_square_before", "mean_square_after", "log_odds", "numbers", "negative_log_prior", "tests_better"), 0.5)
    effect: dict[str, object] = {
        **dict.fromkeys(("effect", "form", "meaning", "path", "family"), "word"), **dict.fromkeys(("confidence", "family_confidence", "fraction", "force_n_rms"), 0.9),
        "of_the_rig": False, "parameters": {}, "gap_closed": None, "evidence": evidence, "rivals": [],
    }  # fmt: skip
    said["groups"][1]["diagnosis"]["findings"] = [effect, {**effect, "effect": "another"}]
    rows = dashpot.GroupsDiagnosis.from_dict(said).to_pandas()
    assert list(rows["group"]) == ["sn10", "sn11", "sn11", "sn9"] and list(rows["effect"])[1:3] == ["word", "another"]
    assert rows["effect"].isna().tolist() == [True, False, False, True]


def test_what_cannot_be_split(command: Command, fleet: Path) -> None:
    model = dashpot.Model.read("good.toml")
    Path("empty list.csv").write_text("test,clicks\n,3\n")
    Path("odd list.csv").write_text("test,clicks\na,3,4\n")

    def sentence(*arguments: str) -> str:
        beside = copy.copy(command)
        beside.folder = fleet
        ran = beside.run("diagnose", "good.toml", *arguments, *FEW)
        assert ran.returncode == 2, ran.stdout
        return as_arguments(ran.stderr.splitlines()[-1].removeprefix("dashpot: "))

    for data, group, words in [
        ("together", "a*", "once where the group stands"),
        ("together", "d{}_*", "matches no test"),
        ("good", "folders", "there is no folder in good"),
        ("good", "c{}_*", "matches no test"),
        ("together", "nowhere.csv:clicks", "nowhere.csv"),
        ("together", "tests.csv:bar", "the columns are test, clicks"),
        ("together", "empty list.csv:clicks", "no line has a test"),
        ("together", "odd list.csv:clicks", "line: 2"),
        ("good", "tests.csv:clicks", "gives no test of the data a group"),
        ("nowhere", "folders", "nowhere"),
        ("good", "a{}5_v50", "give reference to compare it with"),
    ]:
        with pytest.raises(dashpot.DiagnosisError, match=words) as refused:
            dashpot.diagnose_groups(model, data, group, **few)
        assert str(refused.value) == sentence(data, "--group", group) and "--" not in str(refused.value)
    with pytest.raises(dashpot.RecordError) as unread:
        dashpot.diagnose_groups(model, "nowhere", "c{}_*", **few)
    assert str(unread.value) == sentence("nowhere", "--group", "c{}_*")
    with pytest.raises(dashpot.DiagnosisError, match="^group sn10: ") as unknown:
        dashpot.diagnose_groups(model, "fleet", "folders", "good", candidates="ghosts", max_effects=1)
    assert str(unknown.value) == sentence("fleet", "--group", "folders", "--reference", "good", "--candidates", "ghosts")


def test_what_is_no_call(fleet: Path) -> None:
    model, campaign = dashpot.Model.read("good.toml"), dashpot.Campaign.read("together")
    calls: list[tuple[type[Exception], str, Callable[[], object]]] = [
        (TypeError, "^model is a dashpot.Model", lambda: dashpot.diagnose_groups("good.toml", "fleet", "folders")),  # type: ignore[arg-type]
        (TypeError, "^group is a text", lambda: dashpot.diagnose_groups(model, "fleet", None)),  # type: ignore[arg-type]
        (TypeError, "^data is a file or folder", lambda: dashpot.diagnose_groups(model, 3, "folders")),  # type: ignore[arg-type]
        (TypeError, "^there is no argument 'unit'", lambda: dashpot.diagnose_groups(model, "fleet", "folders", unit={})),  # type: ignore[call-arg]
        (TypeError, "^gain: the records of data are read already", lambda: dashpot.diagnose_groups(model, campaign, "c{}_*", gain=2.0)),
        (ValueError, "^group: these records are of no folder", lambda: dashpot.diagnose_groups(model, campaign[1:], "folders")),
        (ValueError, "^delay_s is nan", lambda: dashpot.diagnose_groups(model, "fleet", "folders", delay_s=float("nan"))),
    ]
    for kind, words, call in calls:
        with pytest.raises(kind, match=words):
            call()
