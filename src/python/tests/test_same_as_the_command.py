"""The package and the command say the same digits and the same sentences."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from conftest import Command
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
    # Without what the fit found the records to be off by.
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


def test_check(command: Command) -> None:
    steep = dashpot.Model(damper().text.replace("coulomb_force = 30.0", "coulomb_force = 90.0\ncoulomb_steepness = 1e5"))
    steep.write(command.folder / "steep.toml")
    told = command("check", "steep.toml", "--host-step", "0.002", "--wheel-mass", "35", "--json", "check.json")
    found = steep.check(host_step=0.002, wheel_mass=35)
    assert found.to_dict() == command.json("check.json")
    assert found.chatters and found.element == "coulomb_friction"
    assert list(found.told) == [as_arguments(line) for line in told.splitlines() if not line.startswith("note: ")]
    assert any("for_step=0.002" in line for line in found.told) and found.ready == steep
    command("check", "steep.toml", "--for-step", "0.002", "--wheel-mass", "35", "-o", "ready.toml", "--json", "ready.json")
    ready = steep.check(for_step=0.002, wheel_mass=35)
    assert ready.to_dict() == command.json("ready.json") and ready.softened == ("coulomb_friction",)
    assert ready.ready.text == (command.folder / "ready.toml").read_text()
    assert "presliding_friction" in ready.ready.elements and not ready.ready.check(host_step=0.002, wheel_mass=35).chatters
    assert dashpot.HostCheck.from_dict(ready.to_dict()) == ready
    assert ready.told[0] in ready._repr_html_()
    for wrong, words in [({"host_step": 1.0}, "^host_step is in s and lies"), ({"for_step": 0.0}, "^for_step is in s"), ({"wheel_mass": -1.0}, "^wheel_mass is in kg")]:
        with pytest.raises(dashpot.ModelError, match=words):
            steep.check(**wrong)


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
    assert found.changed and any(c.velocity_m_s is None for c in found.changed)
    assert found.to_dict() == command.json("changed.json")


@pytest.mark.parametrize("known", ["displacement", "velocity", "both"])
def test_simulate(command: Command, model: dashpot.FittedModel, known: str) -> None:
    t = np.linspace(0, 1, 501)
    motion = {"displacement": 0.02 * np.sin(9 * t), "velocity": 0.18 * np.cos(9 * t)}
    if known != "both":
        motion = {known: motion[known]}
    heads = {"displacement": "displacement_m", "velocity": "velocity_m_s"}
    columns = [t, *motion.values()]
    header = ",".join(["time_s", *(heads[name] for name in motion)])
    rows = "\n".join(",".join(repr(float(x)) for x in row) for row in zip(*columns, strict=True))
    (command.folder / "motion.csv").write_text(f"{header}\n{rows}\n")
    model.write(command.folder / "simulated.toml")
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
        # Before it, notes on the records may stand.
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
    model.write(command.folder / "good.toml")
    with pytest.raises(dashpot.DiagnosisError) as diagnosed:
        dashpot.diagnose(model, campaign, candidates=["no_such"])
    assert str(diagnosed.value) == sentence("diagnose", "good.toml", "records", "--candidates", "no_such")
    (command.folder / "a table.csv").write_text("time_s,force_N\n0,1\n")
    with pytest.raises(dashpot.OutputError) as written:
        model.write(command.folder / "a table.csv")
    # There is no --force here.
    said = sentence("fit", "records", "-o", str(command.folder / "a table.csv"))
    assert str(written.value) == said.replace("or give --force to replace it", "or remove it first") != said
    assert all(issubclass(e.type, dashpot.DashpotError) for e in (records, read, missing, fitted, held, diagnosed, written))


def test_a_mapping_reads_as_the_options_of_the_command(command: Command, records: Path, campaign: dashpot.Campaign) -> None:
    """The same records in kN, compression positive, under other headings."""
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
    assert read.sign.given and read.sign.positive == "compression"
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
    # The same digits, tests and verdicts, of damper and model.
    found = model.validate(campaign, limits=limits).limits
    assert found is not None
    lines_of_the_table = [{**one, "line": k + 1} for k, one in enumerate(said["limits"])]
    assert found.to_dict() == {**said, "limits": lines_of_the_table}
    row = examine(Job(str(records)), "k", Plan(limits=limits))
    assert row["status"] == "ok", row["reason"]
    untested = [one for one in said["limits"] if one["verdict"] == "not_tested"]
    assert untested and not said["passed"] and row["judgement"] == "failed"
    assert row["missed"] == list(found.missed) and len(found.missed) == sum(one["verdict"] != "pass" for one in said["limits"])
