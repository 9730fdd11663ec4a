"""Tests that the package and the command give the same digits and the same messages."""

from __future__ import annotations

import datetime
import json
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


def test_fit(command: Command, records: Path, campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    command("fit", "records", "-o", "damper.toml", "--json", "fit.json")
    assert model.text == (command.folder / "damper.toml").read_text()
    said = command.json("fit.json")
    del said["model"]
    assert model.fit.to_dict() == said
    assert len(model.fit.parameters) > 10


def test_validate(command: Command, campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    model.write(command.folder / "validated.toml")
    command("validate", "validated.toml", "records", "--json", "errors.json")
    validation = model.validate(campaign)
    assert validation.to_dict() == command.json("errors.json")
    test = validation.tests[0]
    simulated, fv_only = validation.forces(test.name)
    # The errors are relative to the records after correction of the measurement errors that the fit found.
    assert validation.campaign is not None
    measured = validation.campaign[test.name].force
    assert np.abs(simulated - measured).mean() == pytest.approx(test.mean_error_n, rel=1e-12)
    assert np.abs(fv_only - measured).mean() == pytest.approx(test.fv_only.mean_error_n, rel=1e-12)


def test_validate_against_the_literature(command: Command, campaign: dashpot.Campaign, records: Path) -> None:
    model = dashpot.fit(campaign, hold_out="a15*")
    model.write(command.folder / "rivalled.toml")
    command("validate", "rivalled.toml", "records", "--against", "all", "--json", "rivals.json")
    validation = model.validate(campaign, against="all")
    assert validation.to_dict() == command.json("rivals.json")
    assert [one.model for one in validation.against[1:]] == ["fv", "piecewise", "lag", "surface", "dahl", "bouc-wen", "spencer", "kwok", "network"]
    own, curve = validation.against[:2]
    assert own.numbers is None and curve.numbers is not None and curve.left_out is not None and own.left_out is not None
    assert 0 < own.left_out.error_percent < curve.left_out.error_percent
    assert dashpot.Validation.from_dict(validation.to_dict()) == validation
    few = model.validate(campaign, against=["kwok", "fv", "kwok"])
    assert [one.model for one in few.against] == [own.model, "kwok", "fv"] and few.against[2] == curve
    assert few.tests == validation.tests and "against" not in model.validate(campaign).to_dict()
    for wrong in ("dahlia", ["fv", "dahlia"]):
        with pytest.raises(dashpot.ValidationError, match='no model called "dahlia" to compare with; there are fv, piecewise'):
            model.validate(campaign, against=wrong)
    with pytest.raises(dashpot.ValidationError, match="^against identifies its models from the tests that the model was fitted to"):
        model.validate([r for r in campaign if r.name.startswith("a15")], against="fv")
    with pytest.warns(UserWarning, match="the model file names no tests"):
        damper().validate(campaign, against="fv")


@pytest.mark.parametrize("name", ["surface", "dahl", "bouc-wen", "spencer", "kwok", "network"])
def test_a_model_of_the_literature_as_a_file(command: Command, campaign: dashpot.Campaign, name: str) -> None:
    command("fit", "records", "--model", name, "--hold-out", "a15*", "-o", "rival.toml", "--json", "rival.json")
    told: list[float] = []
    found = dashpot.fit_literature(campaign, name, hold_out="a15*", progress=lambda done, text: told.append(done))
    said = command.json("rival.json")
    del said["model"]
    assert found.to_dict() == said and found.name == name and told == [0.0, 1.0]
    found.write(command.folder / "mine.toml", force=True)
    assert (command.folder / "mine.toml").read_bytes() == (command.folder / "rival.toml").read_bytes()
    for kept in (pickle.loads(pickle.dumps(found)), dashpot.LiteratureModel.from_dict(found.to_dict())):
        assert kept == found
    assert pickle.loads(pickle.dumps(found)).text == found.text and name in found._repr_html_()


def test_the_file_of_a_model_of_the_literature(command: Command, campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    kwok = dashpot.fit_literature(campaign, "kwok")
    path = command.folder / "kwok.toml"
    for _ in range(2):
        kwok.write(path)
    compared = model.validate(campaign, against=path).against
    assert compared[1] == model.validate(campaign, against="kwok").against[1] and compared[1].numbers == kwok.numbers
    model.write(command.folder / "of a damper.toml")
    # An existing file of any kind is replaced only with `force`.
    with pytest.raises(dashpot.OutputError, match="of a damper.toml is there already"):
        kwok.write(command.folder / "of a damper.toml")
    with pytest.raises(FileExistsError, match="kwok.toml is there already"):
        model.write(path)
    with pytest.raises(dashpot.ModelError, match="against"):
        dashpot.Model.read(path)
    with pytest.raises(ValueError, match=r"kept by dashpot\.fit_literature alone"):
        dashpot.LiteratureModel.from_dict(kwok.to_dict()).write(path)
    calls: list[tuple[Callable[[], object], str]] = [
        (lambda: dashpot.fit_literature(campaign, "maxwell"), '^there is no model of the literature "maxwell"; there are surface, dahl, bouc-wen, spencer, kwok, network$'),
        (lambda: dashpot.fit_literature(campaign, "lag"), r'dashpot\.fit\(campaign, family="lag"\)$'),
        (lambda: dashpot.fit_literature(campaign, "dahl", hold_out="*"), "^hold_out leaves no test to fit"),
        (lambda: dashpot.fit(campaign, family="dahl"), r'dashpot\.fit_literature\(campaign, "dahl"\)$'),
        (lambda: dashpot.fit(campaign, family="maxwell"), '^there is no family "maxwell"; there are thesis, fv, piecewise, lag$'),
    ]
    for refused, words in calls:
        with pytest.raises(dashpot.FitError, match=words):
            refused()


def test_check(command: Command) -> None:
    steep = dashpot.Model(damper().text.replace("coulomb_force = 30.0", "coulomb_force = 90.0\ncoulomb_steepness = 1e5"))
    steep.write(command.folder / "steep.toml")
    told = command("check", "steep.toml", "--host-step", "0.002", "--wheel-mass", "35", "--json", "check.json")
    found = steep.check(host_step_s=0.002, wheel_mass_kg=35)
    assert found.to_dict() == command.json("check.json")
    assert found.chatters and found.element == "coulomb_friction"
    assert list(found.told) == [as_arguments(line) for line in told.splitlines() if not line.startswith("note: ")]
    assert any("for_step_s=0.002" in line for line in found.told) and found.ready == steep
    command("check", "steep.toml", "--for-step", "0.002", "--wheel-mass", "35", "-o", "ready.toml", "--json", "ready.json")
    ready = steep.check(for_step_s=0.002, wheel_mass_kg=35)
    assert ready.to_dict() == command.json("ready.json") and ready.softened == ("coulomb_friction",)
    assert ready.ready.text == (command.folder / "ready.toml").read_text()
    assert "presliding_friction" in ready.ready.elements and not ready.ready.check(host_step_s=0.002, wheel_mass_kg=35).chatters
    assert dashpot.HostCheck.from_dict(ready.to_dict()) == ready
    assert ready.told[0] in ready._repr_html_()
    for wrong, words in [({"host_step_s": 1.0}, "^host_step_s is in s and lies"), ({"for_step_s": 0.0}, "^for_step_s is in s"), ({"wheel_mass_kg": -1.0}, "^wheel_mass_kg is in kg")]:
        with pytest.raises(dashpot.ModelError, match=words):
            steep.check(**wrong)


def test_explain(command: Command) -> None:
    model, dimensions = damper(), command.folder / "dimensions.toml"
    model.write(command.folder / "explained.toml")
    dimensions.write_text('design = "monotube"\nbore_mm = 36\nrod_mm = 11\nrebound_chamber_mm = 130\ngas_pressure_bar = [5, 6]\n')
    told = command("explain", "explained.toml", "--dimensions", "dimensions.toml", "--json", "explained.json")
    found = dashpot.explain(model, dimensions)
    said = command.json("explained.json")
    del said["model"], said["dimensions"]
    assert found.to_dict() == said and list(found.lines) == told.splitlines()
    # A gas force of 140 N on a rod of 11 mm diameter is a pressure of 14.7 bar.
    pressure = found["gas_pressure"]
    assert pressure.value == pytest.approx(14.7, abs=0.1) and pressure.unit == "bar gauge" and "gas_force" in pressure.sources
    assert [one.parameter for one in found.contradictions] == ["gas_force"] and found.unknown
    assert dashpot.Explanation.from_dict(json.loads(json.dumps(said))) == found == pickle.loads(pickle.dumps(found))
    assert "gas_pressure" in found._repr_html_() and len(found.to_pandas()) == len(found.quantities)
    with pytest.raises(KeyError, match="no quantity 'colour'; there are .*gas_pressure"):
        found["colour"]
    dimensions.write_text("rod_mm = 11\nbore_m = 0.036\n")
    with pytest.raises(dashpot.DimensionsError) as refused:
        dashpot.explain(model, dimensions)
    ran = command.run("explain", "explained.toml", "--dimensions", str(dimensions))
    # The last line is the error; a note on the defaults of the model comes before it.
    error = ran.stderr.strip().splitlines()[-1].removeprefix("dashpot: ")
    assert ran.returncode == 2 and str(refused.value) == error and "line 2: bore_m" in error


def test_diagnose(command: Command, campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    few = ["free_play", "moving_mass"]
    model.write(command.folder / "diagnosed.toml")
    command("diagnose", "diagnosed.toml", "records", "--json", "diagnosis.json", "-o", "improved.toml",
            "--candidates", ",".join(few), "--max-effects", "1")  # fmt: skip
    found = dashpot.diagnose(model, campaign, candidates=few, max_effects=1)
    assert found.to_dict() == command.json("diagnosis.json")
    assert found.improved.text == (command.folder / "improved.toml").read_text()
    curves = found.curves(found.tests[0].test)
    assert np.sqrt(np.mean((curves["measured"] - curves["before"]) ** 2)) == pytest.approx(found.tests[0].before_rmse_n, rel=1e-9)


def test_diagnose_against_a_reference(command: Command) -> None:
    measure(damper(), command.folder / "good", seed=1)
    measure(damper(scale=1.2, friction=80), command.folder / "worn", seed=2)
    command("fit", "good", "-o", "good.toml", "--elements", "series_compliance,coulomb_friction,gas_preload")
    command("diagnose", "good.toml", "worn", "--reference", "good", "--json", "changed.json", "--candidates", "free_play")
    good, worn = (dashpot.Campaign.read(command.folder / name) for name in ("good", "worn"))
    found = dashpot.diagnose(dashpot.Model.read(command.folder / "good.toml"), worn, good, candidates="free_play")
    assert found.changes and any(c.velocity_m_s is None for c in found.changes)
    assert found.to_dict() == command.json("changed.json")


@pytest.fixture
def beside(command: Command, campaign: dashpot.Campaign, model: dashpot.FittedModel, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Makes the folder of the command, with the model and a table of limits, the working directory of Python.

    Reports name files by the paths that were given, so both must use the same relative paths.
    """
    monkeypatch.chdir(command.folder)
    monkeypatch.delenv("SOURCE_DATE_EPOCH", raising=False)
    Path("front.toml").write_text(model.text)
    Path("windows.csv").write_text("quantity,velocity_m_s,low,high\nforce,0.26,1,5000\nfriction,,0,10\ngas_force,,,900\n")
    return command.folder


def same_bytes(*pairs: tuple[str, str]) -> None:
    for mine, theirs in pairs:
        assert content(Path(mine)) == content(Path(theirs)), mine
        assert len(Path(mine).read_bytes()) > 2000


def same_figures(written: list[Path], theirs: str) -> None:
    assert sorted(path.name for path in written) == sorted(path.name for path in Path(theirs).iterdir())
    assert written and all(path.read_bytes() == (Path(theirs) / path.name).read_bytes() for path in written)


def test_papers_of_a_validation(command: Command, beside: Path) -> None:
    command.run("validate", "front.toml", "records", "--against", "fv,dahl", "--limits", "windows.csv", "--language", "de", "--date", "2026-03-11",
                "--report", "c.html", "--excel", "c.xlsx", "--certificate", "cc.html", "--svg", "c figures")  # fmt: skip
    model = dashpot.Model.read("front.toml")
    limits = pickle.loads(pickle.dumps(dashpot.read_limits("windows.csv")))
    assert limits == dashpot.read_limits("windows.csv") and limits.path == "windows.csv" and len(limits) == 3
    judged = pickle.loads(pickle.dumps(model)).validate(dashpot.Campaign.read("records"), against=["fv", "dahl"], limits=limits)
    # A pickled result writes the same files, for example in another process or on another day.
    for found in (judged, pickle.loads(pickle.dumps(judged))):
        found.write_report("p.html", language="de", date=datetime.date(2026, 3, 11))
        found.write_excel("p.xlsx", language="de", date="2026-03-11")
        found.write_certificate("pc.html", language="de", date="2026-03-11")
        same_bytes(("p.html", "c.html"), ("p.xlsx", "c.xlsx"), ("pc.html", "cc.html"))
    same_figures(judged.write_svg("p figures", language="de"), "c figures")
    assert any("against" in path.name for path in Path("p figures").iterdir())

    command("validate", "front.toml", "records", "--full", "--report", "c.html")
    plain = model.validate(dashpot.Campaign.read("records"))
    plain.write_report("p.html", full=True)
    same_bytes(("p.html", "c.html"))
    assert "dashpot validate front.toml records --full" in Path("p.html").read_text()


def test_papers_name_how_records_were_read(command: Command, beside: Path) -> None:
    options = ["--exclude", "a50*", "--delay=0.0001", "--gain=1.01", "--strict"]
    command("validate", "front.toml", "records", *options, "--report", "c.html")
    model = dashpot.Model.read("front.toml")
    read = dashpot.Campaign.read("records", exclude="a50*", delay_s=0.0001, gain=1.01, strict=True)
    model.validate(read).write_report("p.html")
    same_bytes(("p.html", "c.html"))
    model.validate(pickle.loads(pickle.dumps(read))).write_report("p.html")
    assert "dashpot validate front.toml records --exclude &#39;a50*&#39; --delay" in Path("p.html").read_text().replace("'", "&#39;")
    # The report names no command for part of a campaign, for a model without a file, or for limits without a table.
    for found in (
        model.validate(read[1:]),
        dashpot.Model(model.text).validate(read),
        model.validate(read, limits=[dashpot.Limit("friction", None, 0, 100)]),
    ):
        found.write_report("q.html")
        assert "Command:" not in Path("q.html").read_text() and "SHA-256" in Path("q.html").read_text()
    ready = model.check(for_step_s=0.005).ready
    ready.validate(read).write_report("q.html")
    # This damper differs from that in the file, so the report must not list the file with its hash.
    assert "<td>front.toml</td>" not in Path("q.html").read_text() and "<td>front.toml</td>" in Path("p.html").read_text()
    first = read[0].name
    model.validate(read[:1]).write_report("q.html")
    assert f"rig data in {first}<" in Path("q.html").read_text()


def test_papers_of_a_fit(command: Command, beside: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    command("fit", "records", "--hold-out", "a15*", "-o", "few.toml", "--excel", "c.xlsx", "--language", "fr", "--date", "2026-03-11")
    found = dashpot.fit(dashpot.Campaign.read("records"), hold_out="a15*").fit
    found.write_excel("p.xlsx", model="few.toml", language="fr", date="2026-03-11")
    same_bytes(("p.xlsx", "c.xlsx"))
    command("fit", "records", "--model", "fv", "-o", "few.toml", "--excel", "c.xlsx")
    # Without an argument `date`, the date comes from the environment variable, if it is set.
    fv = dashpot.fit(dashpot.Campaign.read("records"), family="fv").fit
    fv.write_excel("p.xlsx", model="few.toml")
    same_bytes(("p.xlsx", "c.xlsx"))
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "951782400")
    command("fit", "records", "--model", "fv", "-o", "few.toml", "--excel", "c.xlsx")
    fv.write_excel("p.xlsx", model="few.toml")
    same_bytes(("p.xlsx", "c.xlsx"))
    for kept in (pickle.loads(pickle.dumps(found)), dashpot.FitResult.from_dict(found.to_dict())):
        with pytest.raises(ValueError, match=r"kept by dashpot\.fit alone.*fit again"):
            kept.write_excel("q.xlsx")


def test_papers_of_a_diagnosis(command: Command, beside: Path) -> None:
    few = ["free_play", "moving_mass"]
    command("diagnose", "front.toml", "records", "--candidates", ",".join(few), "--max-effects", "1", "--language", "zh", "--full",
            "--report", "c.html", "--svg", "c loops", "--next-tests", "c.csv")  # fmt: skip
    command("diagnose", "front.toml", "records", "--candidates", ",".join(few), "--max-effects", "1", "--excel", "c.xlsx")
    found = dashpot.diagnose(dashpot.Model.read("front.toml"), dashpot.Campaign.read("records"), candidates=few, max_effects=1)
    found.write_report("p.html", language="zh", full=True)
    found.write_excel("p.xlsx")
    same_bytes(("p.html", "c.html"), ("p.xlsx", "c.xlsx"))
    same_figures(found.write_svg("p loops", language="zh"), "c loops")
    # The diagnosis proposes no sine test, so there is no file.
    assert found.write_next_tests("p.csv") == 0 and not Path("p.csv").exists() and not Path("c.csv").exists()
    for kept in (pickle.loads(pickle.dumps(found)), dashpot.Diagnosis.from_dict(found.to_dict())):
        assert kept == found
        with pytest.raises(ValueError, match=r"kept by dashpot\.diagnose alone.*diagnose again"):
            kept.write_report("q.html")


def test_papers_of_what_changed(command: Command, beside: Path) -> None:
    measure(damper(), beside / "as new", seed=1)
    measure(damper(scale=1.2, friction=80), beside / "old", seed=2)
    command("fit", "as new", "-o", "new.toml", "--elements", "series_compliance,coulomb_friction,gas_preload")
    command("diagnose", "new.toml", "old", "--reference", "as new", "--candidates", "free_play", "--report", "c.html")
    new, old = (dashpot.Campaign.read(name) for name in ("as new", "old"))
    found = dashpot.diagnose(dashpot.Model.read("new.toml"), old, new, candidates="free_play")
    found.write_report("p.html")
    same_bytes(("p.html", "c.html"))
    assert "--reference 'as new'" in Path("p.html").read_text().replace("&#39;", "'")
    few = ["free_play", "cavitation", "moving_mass"]
    command("fit", "as new", "-o", "poor.toml", "--elements", "coulomb_friction,gas_preload")
    command("diagnose", "poor.toml", "old", "--candidates", ",".join(few), "--max-effects", "1", "--next-tests", "c.csv")
    found = dashpot.diagnose(dashpot.Model.read("poor.toml"), old, candidates=few, max_effects=1)
    rows = found.write_next_tests("p.csv")
    assert rows == len(Path("p.csv").read_text().splitlines()) - 1 > 0 and Path("p.csv").read_bytes() == Path("c.csv").read_bytes()
    Path("foreign.csv").write_text("a,b\n1,2\n")
    with pytest.raises(dashpot.OutputError, match="foreign.csv is there already and holds a table"):
        found.write_next_tests("foreign.csv")
    assert found.write_next_tests("foreign.csv", force=True) == rows


def test_papers_take_no_other_files_place(command: Command, beside: Path) -> None:
    validation = dashpot.Model.read("front.toml").validate(dashpot.Campaign.read("records"))
    Path("mine.html").write_text("<!doctype html><p>mine")
    said = command.run("validate", "front.toml", "records", "--report", "mine.html").stderr.splitlines()[-1].removeprefix("dashpot: ")
    with pytest.raises(dashpot.OutputError) as refused:
        validation.write_report("mine.html")
    assert str(refused.value) == as_arguments(said) and "force=True" in said.replace("--force", "force=True")
    validation.write_report("mine.html", force=True)
    validation.write_report("mine.html")
    record = sorted(Path("records").glob("*.csv"))[0]
    before = record.read_bytes()
    for write in (validation.write_report, validation.write_excel):
        with pytest.raises(dashpot.OutputError, match="is read by this run and would be lost"):
            write(record)
    assert record.read_bytes() == before
    with pytest.raises(dashpot.OutputError, match="there is no folder nowhere; make it first"):
        validation.write_excel("nowhere/v.xlsx")
    with pytest.raises(ValueError, match='reports are written in en, de, fr and zh, not "es"'):
        validation.write_report("never.html", language="es")
    with pytest.raises(TypeError, match="date is a text"):
        validation.write_report("never.html", date=2026)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"kept by Model\.validate alone"):
        dashpot.Validation.from_dict(validation.to_dict()).write_report("never.html")
    assert not Path("never.html").exists()


@pytest.mark.parametrize("known", ["displacement", "velocity", "both"])
def test_simulate(command: Command, model: dashpot.FittedModel, known: str) -> None:
    t = np.linspace(0, 1, 501)
    motion: dict[str, Any] = {"displacement_m": 0.02 * np.sin(9 * t), "velocity_m_s": 0.18 * np.cos(9 * t)}
    if known != "both":
        motion = {name: values for name, values in motion.items() if name.startswith(known)}
    columns = [t, *motion.values()]
    header = ",".join(["time_s", *motion])
    rows = "\n".join(",".join(repr(float(x)) for x in row) for row in zip(*columns, strict=True))
    (command.folder / "motion.csv").write_text(f"{header}\n{rows}\n")
    model.write(command.folder / "simulated.toml", force=True)
    command("simulate", "simulated.toml", "motion.csv", "-o", "force.csv")
    written = np.loadtxt(command.folder / "force.csv", delimiter=",", skiprows=1)
    response = model.simulate(t, **motion)
    assert np.array_equal(np.column_stack([response.time, response.displacement, response.velocity, response.force]), written)


def test_the_same_sentences(command: Command, campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    (command.folder / "bad.csv").write_text("time_s,force_N\n0,1\nx,2\n")
    (command.folder / "bad.toml").write_text("format = 1\nelements = []\nseries_stifness = 1e6\n")
    bad_records, bad_model = command.folder / "bad.csv", command.folder / "bad.toml"

    def sentence(*arguments: str) -> str:
        ran = command.run(*arguments)
        assert ran.returncode == 2
        # The error is the last line, because notes on the records may precede it.
        return as_arguments(ran.stderr.rstrip("\n").splitlines()[-1].removeprefix("dashpot: "))

    with pytest.raises(dashpot.RecordError) as records:
        dashpot.Campaign.read(bad_records)
    assert str(records.value) == sentence("fit", str(bad_records), "-o", "never.toml")
    with pytest.raises(dashpot.ModelError) as read:
        dashpot.Model.read(bad_model)
    assert str(read.value) == sentence("validate", str(bad_model), "records")
    with pytest.raises(dashpot.ModelError) as missing:
        dashpot.Model.read(command.folder / "nowhere.toml")
    assert str(missing.value) == sentence("validate", str(command.folder / "nowhere.toml"), "records")
    with pytest.raises(dashpot.FitError) as fitted:
        dashpot.fit(campaign, elements=["no_such"])
    assert str(fitted.value) == sentence("fit", "records", "-o", "never.toml", "--elements", "no_such")
    with pytest.raises(dashpot.FitError) as held:
        dashpot.fit(campaign, hold_out=["nothing*"])
    assert str(held.value) == sentence("fit", "records", "-o", "never.toml", "--hold-out", "nothing*")
    model.write(command.folder / "good.toml", force=True)
    with pytest.raises(dashpot.DiagnosisError) as diagnosed:
        dashpot.diagnose(model, campaign, candidates=["no_such"])
    assert str(diagnosed.value) == sentence("diagnose", "good.toml", "records", "--candidates", "no_such")
    (command.folder / "a table.csv").write_text("time_s,force_N\n0,1\n")
    with pytest.raises(dashpot.OutputError) as written:
        model.write(command.folder / "a table.csv")
    assert "or give force=True to replace it" in str(written.value)
    assert all(issubclass(e.type, dashpot.DashpotError) for e in (records, read, missing, fitted, held, diagnosed, written))


def test_a_mapping_reads_as_the_options_of_the_command(command: Command, records: Path, campaign: dashpot.Campaign) -> None:
    """Records in kN, with positive compression and other headings, give the same campaign as the original records."""
    folder = command.folder / "foreign"
    folder.mkdir()
    for file in sorted(records.glob("*.csv")):
        table = np.loadtxt(file, delimiter=",", skiprows=1)
        heads = ["t", "stroke", "rate", "load"]
        rows = np.column_stack([table[:, 0], -table[:, 1], -table[:, 2], -table[:, 3] / 1000])
        text = "\n".join(",".join(repr(float(x)) for x in row) for row in rows)
        (folder / file.name).write_text(",".join(heads) + "\n" + text + "\n")
    units = {"time": "s", "displacement": "m", "velocity": "m/s", "force": "kN"}
    columns = dict(zip(units, ["t", "stroke", "rate", "load"], strict=True))
    read = dashpot.Campaign.read(folder, positive="compression", units=units, columns=columns)
    assert read.names == campaign.names
    assert read.sign.is_stated and read.sign.positive == "compression"
    for mine, theirs in zip(read, campaign, strict=True):
        assert np.allclose(mine.force, theirs.force, rtol=1e-9)
    options = [f"--unit={c}={u}" for c, u in units.items()] + [f"--column={c}={h}" for c, h in columns.items()]
    command("fit", "foreign", "-o", "foreign.toml", "--positive", "compression", "--model", "fv", *options)
    assert dashpot.fit(read, family="fv").text == (command.folder / "foreign.toml").read_text()


def test_records_in_subfolders_are_read_as_the_command_reads_them(command: Command, records: Path) -> None:
    for k, file in enumerate(sorted(records.glob("*.csv"))):
        folder = command.folder / "deep" / ("first" if k % 2 else "second")
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, folder)
    with pytest.raises(dashpot.RecordError, match="give subfolders=True, which reads them as one campaign"):
        dashpot.Campaign.read(command.folder / "deep")
    read = dashpot.Campaign.read(command.folder / "deep", subfolders=True)
    assert {name.split("/")[0] for name in read.names} == {"first", "second"}
    command("fit", "deep", "--subfolders", "--model", "fv", "-o", "deep.toml")
    assert dashpot.fit(read, family="fv").text == (command.folder / "deep.toml").read_text()


def test_results_survive_a_dictionary(campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    assert dashpot.FitResult.from_dict(json.loads(json.dumps(model.fit.to_dict()))) == model.fit
    validation = model.validate(campaign)
    assert dashpot.Validation.from_dict(validation.to_dict()) == validation


def test_a_fleet_judges_limits_as_the_command_does(command: Command, records: Path, campaign: dashpot.Campaign, model: dashpot.FittedModel) -> None:
    pytest.importorskip("pyarrow")
    from dashpot.fleet import Job
    from dashpot.fleet.examine import Plan, examine

    speeds = [f"{quantity},{v},-9999,9999" for quantity in ("force", "hysteresis") for v in (0.05, 0.26, 0.4, 1.0, 1.5, -0.26, -1.0)]
    lines = ["quantity,velocity_m_s,low,high", *speeds, "friction,,0,9999", "gas_force,,0,9999", "hysteresis,,0,9999"]
    text = "\n".join(line.replace("-9999", "") if ",-" not in line else line for line in lines)
    (command.folder / "limits.csv").write_text(text + "\n")
    model.write(command.folder / "judged.toml")
    command.run("validate", "judged.toml", str(records), "--limits", "limits.csv", "--json", "judged.json")
    said = command.json("judged.json")["limits"]
    limits = dashpot.read_limits(command.folder / "limits.csv")
    assert len(limits) == len(said["limits"]) == len(lines) - 1
    # Numbers, tests and verdicts of damper and model equal those of the command.
    found = model.validate(campaign, limits=limits).limits
    assert found is not None
    lines_of_the_table = [{**one, "line": k + 1} for k, one in enumerate(said["limits"])]
    assert found.to_dict() == {**said, "limits": lines_of_the_table}
    row = examine(Job(str(records)), "k", Plan(limits=limits))
    assert row["status"] == "ok", row["reason"]
    untested = [one for one in said["limits"] if one["verdict"] == "not_tested"]
    assert untested and not said["passed"] and row["judgement"] == ("failed" if said["overall"] == "fail" else "incomplete")
    assert row["missed"] == list(found.missed) and len(found.missed) == sum(one["verdict"] != "pass" for one in said["limits"])
