"""Tests of fleets of dampers that depend on a setting: every setting has its own values, and an unmeasured setting has none."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dashpot
from dashpot._native import SettingsFigures
from dashpot.limits import rows as rows_of

pq = pytest.importorskip("pyarrow.parquet")
distributed = pytest.importorskip("distributed")

from dashpot.fleet import Job, Limit, Place, Plan, find_jobs, write_report  # noqa: E402
from dashpot.fleet import run as run_jobs  # noqa: E402
from dashpot.fleet.examine import examine  # noqa: E402
from dashpot.fleet.store import Store  # noqa: E402

FILE = Path(__file__).resolve().parents[3] / "examples/semi_active.toml"
#: Amplitude, m, and frequency, Hz, of the tests at each setting.
TESTS = ((0.02, 0.02), (0.02, 1.0), (0.02, 4.0))
#: Elements of a quick fit.
ELEMENTS = ("coulomb_friction", "gas_preload")


def measure(folder: Path, settings: list[float], seed: int, soft: float = 1.0, hard: float = 1.0, unit: str = "A") -> None:
    """Writes the tests of a semi-active damper at each setting, with 0.5 % noise. ``hard`` is a factor of its force at 1.6 A, ``soft`` elsewhere."""
    folder.mkdir(parents=True)
    family = dashpot.Family.read(FILE)
    noise = np.random.default_rng(seed)
    for setting in settings:
        for amplitude, frequency in TESTS:
            t = np.linspace(0.0, 4.0 / frequency, 801)
            x = amplitude * np.sin(2.0 * np.pi * frequency * t)
            force = (hard if setting == 1.6 else soft) * family.at(setting).simulate(t, x).force
            rows = np.column_stack((t, x, force + noise.normal(0.0, 0.005 * np.max(np.abs(force)), len(t))))
            factor = {"A": 1.0, "mA": 1e3, "bar": 10.0, "psi": 145.03774}[unit]
            shown = f"{factor * setting:.6g}{unit}"
            name = f"{1e3 * amplitude:g}mm_{frequency:g}Hz_{shown}.csv"
            np.savetxt(folder / name, rows, delimiter=",", header="time_s,displacement_m,force_N", comments="", fmt="%.9g")


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Makes four dampers: two at three currents, one without 0.8 A, and one at 0.8 A alone. The second is 30 % harder at 1.6 A."""
    folder = tmp_path_factory.mktemp("over") / "fleet"
    measure(folder / "d0", [0.0, 0.8, 1.6], seed=1)
    measure(folder / "d1", [0.0, 0.8, 1.6], seed=2, hard=1.3)
    measure(folder / "d2", [0.0, 1.6], seed=3)
    measure(folder / "d3", [0.8], seed=4)
    return folder


@pytest.fixture(scope="module")
def place() -> Any:
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None, silence_logs="ERROR") as local:
        yield Place(address=local.scheduler_address)


PLAN = Plan(setting="current", elements=ELEMENTS)


def rows(path: Path) -> list[dict[str, Any]]:
    table: list[dict[str, Any]] = pq.read_table(path).to_pylist()
    return table


def test_each_setting_has_its_columns_and_an_unmeasured_one_has_no_values(fleet: Path, place: Place, tmp_path: Path) -> None:
    out = tmp_path / "o.parquet"
    limits = (
        Limit("force", 0.12, 0, 1e4, setting=0.8),
        Limit("force", 0.5, 0, 1.15 * dashpot.Family.read(FILE).at(1.6).steady_force(0.5)[0], setting=1.6, label="R5"),
    )
    run_jobs(find_jobs(fleet), out, replace(PLAN, limits=limits), place)
    table = rows(out)
    assert [r["status"] for r in table] == ["ok"] * 4, [r["reason"] for r in table]
    assert [[one["setting"] for one in r["settings"]] for r in table] == [[0.0, 0.8, 1.6], [0.0, 0.8, 1.6], [0.0, 1.6], [0.8]]
    measured = [[r[f"error_percent_at_{s}_A"] is not None for s in ("0", "0.8", "1.6")] for r in table]
    assert measured == [[True] * 3, [True] * 3, [True, False, True], [False, True, False]]
    assert all((r["force_at_+0.262_m_s_at_0.8_A"] is not None) == m[1] for r, m in zip(table, measured, strict=True))
    # The force depends on the setting, so a column without a setting has no values.
    assert all(r["force_at_+0.262_m_s"] is None for r in table)
    family = dashpot.fit(dashpot.Campaign.read(fleet / "d0"), setting="current", elements=ELEMENTS)
    assert table[0]["model"] == family.text
    assert table[0]["force_at_+0.262_m_s_at_1.6_A"] == family.at(1.6).steady_force(0.262)[0]
    assert table[1]["force_at_+0.262_m_s_at_1.6_A"] == pytest.approx(1.3 * table[0]["force_at_+0.262_m_s_at_1.6_A"], rel=0.05)
    assert [r["judgement"] for r in table] == ["passed", "failed", "incomplete", "incomplete"]
    assert [m.split(":")[0] for m in table[1]["missed"]] == ["R5, force at 500 mm/s at setting 1.6 A"]
    assert table[2]["missed"] == ["force at 120 mm/s at setting 0.8 A: not tested, the damper was not measured at this setting"]

    # Other limits come from the stored figures, without a fit.
    before = out.stat().st_mtime_ns
    again = run_jobs(find_jobs(fleet), out, replace(PLAN, limits=(Limit("force", 0.12, 0, 1, setting=0.0),)), place)
    assert again.done_before == 4 and out.stat().st_mtime_ns > before
    assert [r["judgement"] for r in rows(out)] == ["failed"] * 3 + ["incomplete"]

    pytest.importorskip("matplotlib")
    write_report(out, tmp_path / "r.html")
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    over = text[text.index("<h2>Over the setting</h2>") :].split("</table>")[0]
    assert re.findall("<th>(at .*?)</th>", over) == ["at 0 A", "at 0.8 A", "at 1.6 A"]
    assert "<td>dampers measured</td><td>3 of 4</td><td>3 of 4</td><td>3 of 4</td>" in over
    listed = text[text.index("<h2>Dampers</h2>") :].split("</table>")[0].split("<tr>")[2:]
    cells = [re.findall("<td>(.*?)</td>", row)[4:7] for row in listed]
    assert [[cell == "not measured" for cell in row] for row in cells] == [[not one for one in row] for row in measured]
    assert "<h3>force at +262 mm/s at 0.8 A</h3>" in text


def test_a_parameter_that_one_damper_shares_is_beside_those_over_the_setting(tmp_path: Path) -> None:
    """If friction depends on the setting in one damper, a damper with constant friction has this value at each of its measured settings."""
    store = Store(tmp_path / "t.parquet")

    def friction(setting: float | None, value: float) -> dict[str, Any]:
        return {
            "name": "coulomb_force", "index": None, "unit": "N", "standing": "identified", "value": value, "low": value - 1, "high": value + 1,
            "setting": setting,
        }  # fmt: skip

    def row(key: str, unit: str, settings: list[float], parameters: list[dict[str, Any]]) -> dict[str, Any]:
        own = [{"setting": s, "tests": 1, "error_percent": 1.0, "forces": [None] * 10} for s in settings]
        return {
            "key": key, "campaign": key, "serial": key, "batch": "", "date": "", "status": "ok", "setting": "current", "setting_unit": unit,
            "settings": own, "parameters": parameters,
        }  # fmt: skip

    store.add(
        [
            row("varies", "A", [0.0, 0.8], [friction(0.0, 30.0), friction(0.8, 60.0)]),
            row("shares", "A", [0.0, 1.6], [friction(None, 31.0)]),
            # 801 mA are 0.8 A within the scatter of one setting.
            row("in mA", "mA", [801.0], [friction(None, 59.0)]),
            {"key": "bad", "campaign": "bad", "serial": "bad", "batch": "", "date": "", "status": "failed", "reason": "unreadable"},
        ]
    )
    store.table(["varies", "shares", "in mA", "bad"])
    store.close()
    table = rows(tmp_path / "t.parquet")
    assert [[r[f"coulomb_force_at_{s}_A"] for s in ("0", "0.8", "1.6")] for r in table] == [
        [30.0, 60.0, None], [31.0, None, 31.0], [None, 59.0, None], [None, None, None]
    ]  # fmt: skip
    assert "coulomb_force" not in table[0] and not any("801" in name for name in table[0])
    assert (table[1]["coulomb_force_at_1.6_A_low"], table[1]["coulomb_force_at_1.6_A_high"]) == (30.0, 32.0)
    pytest.importorskip("matplotlib")
    write_report(tmp_path / "t.parquet", tmp_path / "t.html")
    text = (tmp_path / "t.html").read_text(encoding="utf-8")
    assert "<h3>coulomb_force at 0.8 A</h3><p>median 59.5 N" in text


def test_a_reference_is_compared_at_each_setting(fleet: Path, place: Place, tmp_path: Path) -> None:
    measure(tmp_path / "good", [0.0, 1.6], seed=9)
    out = tmp_path / "o.parquet"
    run_jobs([Job(str(fleet / f"d{k}"), f"d{k}") for k in range(4)], out, replace(PLAN, reference=str(tmp_path / "good"), candidates=("free_play",)), place)
    table = rows(out)
    assert [r["status"] for r in table] == ["ok"] * 4, [r["reason"] for r in table]
    assert table[0]["verdict"] == "nothing_missing" and not table[0]["changes"]
    assert table[1]["changes"] and {c["setting"] for c in table[1]["changes"]} == {1.6}
    assert [[one["verdict"] is None for one in r["settings"]] for r in table] == [[False, True, False]] * 2 + [[False, False], [True]]
    assert [any("not compared at 0.8 A" in note for note in r["notes"]) for r in table] == [True, True, False, True]
    pytest.importorskip("matplotlib")
    write_report(out, tmp_path / "r.html")
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    listed = text[text.index("<h2>Dampers</h2>") :].split("</table>")[0].split("<tr>")[2:]
    changed = [re.findall("<td>(.*?)</td>", row)[-1] for row in listed]
    assert changed[1].startswith("changed: ") and " at 1.6 A" in changed[1] and changed[3] == "not diagnosed"


def test_without_the_option_several_settings_are_told_with_it(fleet: Path, place: Place, tmp_path: Path) -> None:
    from dashpot.fleet.__main__ import main

    row = examine(Job(str(fleet / "d0")), "k", Plan(family="fv"))
    assert row["status"] == "failed" and "--setting current" in row["reason"] and "0 A, 0.8 A, 1.6 A" in row["reason"]
    assert "dashpot fit" not in row["reason"]
    assert examine(Job(str(fleet / "d3")), "k", Plan(family="fv"))["status"] == "ok"
    assert examine(Job(str(fleet / "d0")), "k", Plan(family="fv", setting="none"))["status"] == "ok"
    row = examine(Job(str(fleet / "d0")), "k", Plan(setting="clicks"))
    assert row["status"] == "failed" and "current" in row["reason"]
    shutil.copytree(fleet / "d3", tmp_path / "one")
    limits = tmp_path / "limits.csv"
    limits.write_text("quantity,velocity_m_s,setting,low,high\nforce,0.5,1.6,0,10\n")
    common = [str(fleet), "--out", str(tmp_path / "o.parquet"), "--quiet"]
    assert main([*common, "--limits", str(limits)]) == 2
    assert main([*common, "--setting", "current", "--family", "fv"]) == 2
    assert main([*common, "--setting", "current", "--reference", str(tmp_path / "one"), "--elements", ",".join(ELEMENTS)]) == 2
    limits.write_text("quantity,velocity_m_s,low,high\nforce,0.5,0,10\n")
    assert main([*common, "--setting", "current", "--limits", str(limits)]) == 2
    assert not (tmp_path / "o.parquet").exists()
    assert main([*common, "--setting", "current", "--elements", ",".join(ELEMENTS), "--scheduler", str(place.address)]) == 0
    assert [r["status"] for r in rows(tmp_path / "o.parquet")] == ["ok"] * 4


def test_stored_figures_judge_response_times_as_the_validation_does(tmp_path: Path) -> None:
    stepped(tmp_path / "d", 5)
    limits = (
        Limit("response_time_up", None, 0, 0.001),
        Limit("response_time_down", None, 0, 0.2, setting=0.0),
        Limit("rise_time_up", None, 0, 0.2, setting=0.8),
        Limit("force", 0.12, 0, 1e4, setting=1.6),
    )
    campaign = dashpot.Campaign.read(tmp_path / "d")
    fitted = dashpot.fit(campaign, setting="current", elements=ELEMENTS)
    validation = fitted.validate(campaign, limits=limits)
    assert validation.campaign is not None
    text = fitted._native.measure(validation.campaign._native).text
    found = json.loads(SettingsFigures.parse(text).judge(rows_of(limits)))
    expected = validation.limits.to_dict()["limits"]
    for one, other in zip(found["limits"], expected, strict=True):
        assert one["verdict"] == other["verdict"]
        assert one["measured"] is other["measured"] is None or other["measured"].items() <= one["measured"].items()
    assert [one["verdict"] for one in expected] == ["fail", "pass", "not_tested", "pass"]
    row = examine(Job(str(tmp_path / "d")), "k", replace(PLAN, limits=limits))
    assert row["judgement"] == "failed" and [one["setting"] for one in row["settings"]] == [0.0, 1.6], row["reason"]
    assert row["missed"][1] == "rise_time_up at setting 0.8 A: not tested, there is no such step of the setting"


def stepped(folder: Path, seed: int) -> None:
    """Writes tests at two constant currents, and one whose current steps between them during a sine."""
    measure(folder, [0.0, 1.6], seed)
    family = dashpot.Family.read(FILE)
    t = np.arange(0.0, 8.0, 1e-3)
    x = 0.02 * np.sin(2.0 * np.pi * 0.8 * t)
    current = np.where((t / 0.5).astype(int) % 2 == 0, 0.0, 1.6)
    force = family.simulate(t, x, setting=current).force + np.random.default_rng(seed).normal(0.0, 3.0, len(t))
    table = np.column_stack((t, x, force, current))
    np.savetxt(folder / "steps.csv", table, "%.9g", ",", header="time_s,displacement_m,force_N,current [A]", comments="")


def test_the_response_of_the_valve_has_columns_where_tests_have_steps(tmp_path: Path) -> None:
    stepped(tmp_path / "steps", 7)
    measure(tmp_path / "constant", [0.0, 1.6], seed=8)
    store = Store(tmp_path / "t.parquet")
    names = ("steps", "constant")
    store.add([examine(Job(str(tmp_path / name)), name, PLAN) for name in names])
    store.table(names)
    store.close()
    with_steps, without = rows(tmp_path / "t.parquet")
    assert [row["status"] for row in (with_steps, without)] == ["ok", "ok"], with_steps["reason"]
    # Other tests check the accuracy of the times. This test checks that the columns equal the estimates of the fit.
    assert with_steps["setting_time_up_low"] < with_steps["setting_time_up"] < with_steps["setting_time_up_high"]
    fitted = dashpot.fit(dashpot.Campaign.read(tmp_path / "steps"), setting="current", elements=ELEMENTS)
    assert fitted.fit.actuator is not None
    for estimate in fitted.fit.actuator.estimates:
        known = estimate.value if estimate.standing != "not_identified" else None
        assert with_steps[estimate.name] == known, estimate.name
        assert without[estimate.name] is None
    schema = pq.read_schema(tmp_path / "t.parquet")
    assert schema.field("setting_time_up").metadata[b"unit"] == b"s"


def test_parameters_of_the_valve_are_in_the_unit_of_the_fleet(tmp_path: Path) -> None:
    store = Store(tmp_path / "t.parquet")

    def row(key: str, unit: str, rate: float) -> dict[str, Any]:
        numbers = {"setting_rate_up": rate, "setting_hysteresis": 0.01 * rate, "setting_time_up": 0.01}
        common = {"index": None, "unit": "", "standing": "identified", "setting": None}
        parameters = [{"name": name, "value": value, "low": 0.9 * value, "high": 1.1 * value, **common} for name, value in numbers.items()]
        return {"key": key, "status": "ok", "setting": "pressure", "setting_unit": unit, "settings": [], "parameters": parameters}

    first = {"setting": 0.0, "tests": 1, "error_percent": 1.0, "rmse_n": 1.0, "fv_error_percent": 1.0, "forces": [None] * 10}
    store.add([{**row("a", "bar", 10.0), "settings": [first]}, {**row("b", "psi", 145.03774), "settings": [first]}])
    store.table(("a", "b"))
    store.close()
    a, b = rows(tmp_path / "t.parquet")
    for name in ("setting_rate_up", "setting_rate_up_high", "setting_hysteresis", "setting_time_up"):
        assert a[name] == pytest.approx(b[name], rel=1e-6), name
    schema = pq.read_schema(tmp_path / "t.parquet")
    assert [schema.field(n).metadata[b"unit"] for n in ("setting_rate_up", "setting_hysteresis")] == [b"bar/s", b"bar"]


def test_limits_apply_in_the_unit_of_each_damper(place: Place, tmp_path: Path) -> None:
    measure(tmp_path / "fleet" / "d0", [0.0, 1.6], seed=1, unit="bar")
    measure(tmp_path / "fleet" / "d1", [0.0, 1.6], seed=2, unit="psi")
    out = tmp_path / "o.parquet"
    plan = replace(PLAN, setting="pressure", limits=(Limit("force", 0.12, 0, 1e4, setting=16.0),))
    run_jobs(find_jobs(tmp_path / "fleet"), out, plan, place)
    of_bar, of_psi = rows(out)
    assert [row["status"] for row in (of_bar, of_psi)] == ["ok", "ok"], of_bar["reason"]
    # 16 bar are 232 psi: columns are in the unit of the first damper, and the limit at 16 is one at 16 psi for the second.
    assert all(row["error_percent_at_16_bar"] is not None for row in (of_bar, of_psi))
    assert [row["judgement"] for row in (of_bar, of_psi)] == ["passed", "incomplete"]
    assert of_psi["missed"] == ["force at 120 mm/s at setting 16 psi: not tested, the damper was not measured at this setting"]
    again = replace(plan, limits=(Limit("force", 0.12, 0, 1e4, setting=232.06),))
    run_jobs(find_jobs(tmp_path / "fleet"), out, again, place)
    assert [row["judgement"] for row in rows(out)] == ["incomplete", "passed"]
