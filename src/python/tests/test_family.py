"""Tests of dampers that depend on a setting."""

import pickle
from pathlib import Path

import numpy as np
import pytest
from conftest import Command

import dashpot

FILE = Path(__file__).resolve().parents[3] / "examples/semi_active.toml"


def test_a_family_at_a_setting_is_an_ordinary_damper() -> None:
    family = dashpot.Family.read(FILE)
    assert (family.name, family.unit, family.start) == ("current", "A", 0.6)
    assert list(family.grid) == [0.0, 0.4, 0.8, 1.2, 1.6]
    forces = [family.at(setting).steady_force([0.2])[0] for setting in np.linspace(0.0, 1.6, 33)]
    assert np.all(np.diff(forces) > 0.0)
    t = np.linspace(0.0, 1.0, 1001)
    x = 0.02 * np.sin(10.0 * t)
    constant = family.simulate(t, x, setting=0.8).force
    # At a constant setting, the hysteresis of the valve has no effect. The family divides its steps differently, which changes the force by
    # 2 mN at steps of 1 ms.
    assert np.allclose(constant, family.at(0.8).simulate(t, x).force, rtol=0.0, atol=1e-5 * np.max(np.abs(constant)))
    stepped = family.simulate(t, x, setting=np.where(t < 0.5, 0.8, 1.6)).force
    assert np.array_equal(stepped[:500], constant[:500]) and np.max(np.abs(stepped[520:] - constant[520:])) > 100.0


def test_an_ordinary_model_is_no_family_and_the_other_way_round() -> None:
    with pytest.raises(dashpot.ModelError, match="setting"):
        dashpot.Model.read(FILE)
    ordinary = 'format = 1\nelements = ["fv_curve"]\n'
    with pytest.raises(dashpot.ModelError, match="setting"):
        dashpot.Family(ordinary)
    family = dashpot.Family.read(FILE)
    with pytest.raises(ValueError, match="setting"):
        family.simulate([0.0, 1.0], [0.0, 0.01], setting=[0.0, np.nan])


def test_a_steady_force_is_that_of_the_ordinary_damper_for_scalars_and_arrays() -> None:
    family = dashpot.Family.read(FILE)
    alone = family.at(0.8).steady_force([0.2, -0.5])
    assert np.array_equal(family.steady_force([0.2, -0.5], setting=0.8), alone)
    assert family.steady_force(0.2, setting=0.8).shape == () and family.steady_force(0.2, setting=0.8) == alone[0]
    grid = family.steady_force(np.array([[0.2], [-0.5]]), setting=[0.0, 0.8, 1.6])
    assert grid.shape == (2, 3) and np.array_equal(grid[:, 1], alone) and np.all(np.diff(grid[0]) > 0.0)
    assert family.steady_force(0.2) == family.at(family.start).steady_force([0.2])[0]
    with pytest.raises(ValueError, match="setting"):
        family.steady_force([0.1, 0.2, 0.3], setting=[0.0, np.nan, 1.0])
    with pytest.raises(ValueError):
        family.steady_force([0.1, 0.2, 0.3], setting=[0.0, 1.0])


def test_a_family_has_a_table_of_its_settings(tmp_path: Path) -> None:
    family = dashpot.Family.read(FILE)
    table = family.to_pandas()
    assert list(table["current"]) == list(family.grid) and table["stribeck_coulomb_force"].is_monotonic_increasing
    family.write(tmp_path / "again.toml")
    assert dashpot.Family.read(tmp_path / "again.toml").text == family.text
    assert "current" in repr(family) and "<table" in family._repr_html_()
    assert np.array_equal(pickle.loads(pickle.dumps(family)).grid, family.grid)


def write_records(folder: Path, family: dashpot.Family, settings: list[float]) -> None:
    """Writes one sine test of a family for each setting. The name of its file contains the current."""
    folder.mkdir()
    noise = np.random.default_rng(5)
    for setting in settings:
        for amplitude, frequency in [(0.02, 0.04), (0.02, 1.0), (0.02, 4.0), (0.004, 12.0)]:
            t = np.linspace(0.0, 4.0 / frequency, 2001)
            x = amplitude * np.sin(2.0 * np.pi * frequency * t)
            force = family.at(setting).simulate(t, x).force
            rows = np.column_stack((t, x, force + noise.normal(0.0, 0.005 * np.max(np.abs(force)), len(t))))
            name = f"{1e3 * amplitude:g}mm_{frequency:g}Hz_{setting:g}A.csv"
            np.savetxt(folder / name, rows, delimiter=",", header="time_s,displacement_m,force_N", comments="", fmt="%.9g")


def test_fit_and_validation_are_those_of_the_command(command: Command) -> None:
    write_records(command.folder / "semi_active", dashpot.Family.read(FILE), [0.0, 0.8, 1.6])
    command("fit", "semi_active", "--setting", "current", "-o", "family.toml", "--json", "family.json")
    campaign = dashpot.Campaign.read(command.folder / "semi_active")
    family = dashpot.fit(campaign, setting="current")
    assert isinstance(family, dashpot.FittedFamily) and family.text == (command.folder / "family.toml").read_text()
    said = command.json("family.json")
    del said["model"]
    assert family.fit.to_dict() == said
    assert list(family.fit.to_pandas()["setting"]) == [0.0, 0.8, 1.6]
    command("validate", "family.toml", "semi_active", "--json", "over.json")
    validation = family.validate(campaign)
    assert validation.to_dict() == command.json("over.json")
    assert [of.setting for of in validation.settings] == [0.0, 0.8, 1.6]
    with pytest.raises(ValueError, match="dashpot validate"):
        validation.write_report(command.folder / "report.html")

    hard = dashpot.Limit("force", 0.5, 0.0, 1e5, setting=1.6)
    judged = family.validate(campaign, limits=[hard])
    assert judged.limits.passed and judged.limits.to_dict()["limits"][0]["setting"] == 1.6
    unit = family.unit
    low = family.validate(campaign, limits=[dashpot.Limit("force", 0.5, 0.0, 1.0, setting=1.6)])
    assert unit and f"at setting 1.6 {unit}: " in low.limits.missed[0]
    with pytest.raises(dashpot.ValidationError, match="setting"):
        family.validate(campaign, limits=[dashpot.Limit("force", 0.5, 0.0, 1e5)])
    with pytest.raises(dashpot.ValidationError, match="setting"):
        family.at(0.8).validate(campaign, limits=[hard])
    with pytest.raises(dashpot.FitError, match="clicks"):
        dashpot.fit(campaign, setting="clicks")
    with pytest.raises(ValueError, match="thesis"):
        dashpot.fit(campaign, setting="current", family="fv")
    command("diagnose", "family.toml", "semi_active", "--max-effects", "1", "--json", "found.json")
    found = dashpot.diagnose(family, campaign, max_effects=1)
    assert not any(one.interpolated for one in found.settings)
    assert found.to_dict() == command.json("found.json")
    assert [one.setting for one in found.settings] == [0.0, 0.8, 1.6] and found[0.8].verdict == found.settings[1].verdict
    assert found.settings[0].curves(found.settings[0].tests[0].test)["measured"].shape
    with pytest.raises(TypeError, match="setting"):
        dashpot.diagnose(family.at(0.8), campaign, setting=0.8)  # type: ignore[call-overload]
    again = pickle.loads(pickle.dumps(family))
    assert again.fit == family.fit and again.text == family.text


def test_dimensions_are_those_of_the_command(command: Command) -> None:
    write_records(command.folder / "drawn", dashpot.Family.read(FILE), [0.0, 1.6])
    drawing = command.folder / "dimensions.toml"
    drawing.write_text("rod_mm = 11\ngas_pressure_bar = 9\n")
    command("fit", "drawn", "--setting", "current", "--dimensions", "dimensions.toml", "-o", "family.toml")
    campaign = dashpot.Campaign.read(command.folder / "drawn")
    family = dashpot.fit(campaign, setting="current", dimensions=drawing)
    assert family.text == (command.folder / "family.toml").read_text() and any("gas_pressure_bar" in note for note in family.fit.notes)
    command("explain", "family.toml", "--dimensions", "dimensions.toml", "--setting", "0.8", "--json", "explained.json")
    said = command.json("explained.json")
    del said["model"], said["dimensions"]
    assert dashpot.explain(family, drawing, setting=0.8).to_dict() == said
    with pytest.raises(TypeError, match="give setting"):
        dashpot.explain(family, drawing)
    with pytest.raises(ValueError, match="outside those of the model, 0 to 1.6"):
        dashpot.explain(family, drawing, setting=2.0)
    with pytest.raises(TypeError, match="depends on none"):
        dashpot.explain(family.at(0.8), drawing, setting=0.8)
    command("fit", "drawn", "--hold-out", "*_1.6A", "--dimensions", "dimensions.toml", "-o", "soft.toml")
    soft = dashpot.fit(campaign, hold_out=["*_1.6A"], dimensions=drawing)
    assert soft.text == (command.folder / "soft.toml").read_text()
    command("diagnose", "soft.toml", "drawn", "--max-effects", "1", "--candidates", "aeration", "--dimensions", "dimensions.toml", "--json", "found.json")
    found = dashpot.diagnose(soft, campaign, max_effects=1, candidates=["aeration"], dimensions=drawing)
    assert found.to_dict() == command.json("found.json")
    with pytest.raises(dashpot.DimensionsError, match="absent.toml"):
        dashpot.fit(campaign, dimensions=command.folder / "absent.toml")
    with pytest.raises(dashpot.FitError, match="thesis"):
        dashpot.fit(campaign, family="fv", dimensions=drawing)


def test_a_limit_of_a_time_is_in_seconds() -> None:
    said = {
        "name": "response_time_up", "quantity": "response_time_up", "velocity_m_s": None, "amplitude_m": None, "low_s": None, "high_s": 0.011, "line": 2,
        "measured": {"value_s": 0.012, "tests": ["steps"]}, "model": None, "verdict": "fail", "model_verdict": "not_tested",
    }  # fmt: skip
    checked = dashpot.results.Checked.from_dict(said)
    assert checked.to_dict() == said and checked.measured is not None and checked.measured.value == 0.012
    assert checked.missed == "response_time_up: 0.012 s is above 0.011 s"
    untested = dashpot.results.Checked.from_dict({**said, "measured": None, "verdict": "not_tested"})
    assert untested.missed == "response_time_up: not tested, there is no such step of the setting"
