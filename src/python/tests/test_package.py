"""Tests of properties of the package: types, pickling, display in notebooks, and other threads and processes."""

from __future__ import annotations

import dataclasses
import html
import inspect
import math
import os
import pickle
import re
import shutil
import subprocess
import sys
import threading
import time
import tracemalloc
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fleets import damper, measure, turn

import dashpot
from dashpot import _native

SOURCES = Path(__file__).parent.parent


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> dashpot.Campaign:
    folder = tmp_path_factory.mktemp("own") / "campaign"
    measure(damper(), folder, seed=1)
    return dashpot.Campaign.read(folder)


def test_a_fault_of_the_program_would_be_an_exception() -> None:
    assert _native.UNWINDS


def test_stubs_say_what_is_there() -> None:
    pytest.importorskip("mypy")
    ran = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "dashpot._native", "--ignore-missing-stub"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_types_agree() -> None:
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--config-file", str(SOURCES / "pyproject.toml")]
    # The tests are checked too, because their code is like that of users.
    for folder in (SOURCES / "python" / "dashpot", SOURCES / "tests"):
        ran = subprocess.run([*command, str(folder)], capture_output=True, text=True, check=False)
        assert ran.returncode == 0, ran.stdout + ran.stderr


#: Code of a user of the package. A type checker must infer its types without casts.
ANALYST = """
from pathlib import Path
from typing_extensions import assert_type
import dashpot
import numpy as np
import numpy.typing as npt
campaign = dashpot.Campaign.read(Path("campaign"), units={"force": "kN"})
assert_type(campaign[0], dashpot.Record)
assert_type(campaign["a50"], dashpot.Record)
assert_type(campaign[0:2], dashpot.Campaign)
model = dashpot.fit(campaign, hold_out="a40*")
assert_type(model.validate(campaign).overall.error_percent, float)
assert_type(model.fit.misfit, float)
assert_type(dashpot.Model.read("damper.toml").fit, dashpot.FitResult | None)
judged = model.validate(campaign, limits=dashpot.read_limits("limits.csv")).limits
assert_type(judged.passed, bool)
assert_type(judged.limits[0].verdict, str)
assert_type(dashpot.diagnose(model, campaign).improved.validate(campaign).overall.error_percent, float)
assert_type(dashpot.diagnose(model, campaign, campaign).summary, str)
assert_type(model.validate(campaign, against=["fv", Path("dahl.toml")]).against[0].model, str)
assert_type(model.simulate([0.0, 1.0], displacement_m=[0.0, 0.1]), dashpot.Response)
first: float = campaign[0].force[0] + model.steady_force([0.1])[0]
assert_type(dashpot.Damper(model).step(0.1, 1e-3), float)
assert_type(dashpot.Damper(model, 0.01, initial_velocity_m_s=0.2).step(0.1, 1e-3), float)
forces: npt.NDArray[np.float64] = dashpot.Damper([model, model], [0, 0]).step(np.zeros(2), 1e-3)
dashpot.fit(campaign[1:])
dashpot.plot.curve(model)
"""


@pytest.mark.parametrize("checker", ["mypy", "pyright"])
def test_an_analysts_types_are_seen(checker: str, tmp_path: Path) -> None:
    pytest.importorskip(checker)
    (tmp_path / "analysis.py").write_text(ANALYST)
    strict = {"mypy": ["mypy", "--strict"], "pyright": ["pyright", "--pythonpath", sys.executable]}[checker]
    ran = subprocess.run(
        [sys.executable, "-m", *strict, "analysis.py"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_fit_finds_the_damper(own: dashpot.Campaign) -> None:
    model = dashpot.fit(own, elements=["series_compliance", "coulomb_friction", "gas_preload"])
    friction = model.parameters["coulomb_force"]
    assert friction.value == pytest.approx(30, abs=5)
    assert model["gas_force"] == pytest.approx(140, abs=10)
    assert friction.identified and friction.interval is not None and friction.unit == "N"
    truth = damper().steady_force([-0.4, 0.1, 0.4])
    assert np.allclose(model.steady_force([-0.4, 0.1, 0.4]), truth, rtol=0.03)
    again = dashpot.Model(model.text)
    assert again == model and again.parameters == model.parameters


def test_everything_is_a_dictionary_a_table_and_a_view(own: dashpot.Campaign) -> None:
    pandas = pytest.importorskip("pandas")
    model = dashpot.fit(own, family="fv")
    validation = model.validate(own)
    response = model.simulate([0, 0.1, 0.2], [0, 0.001, 0])
    for result in (own, own[0], model, model.fit, validation, response):
        assert isinstance(result.to_dict(), dict)
        assert isinstance(result.to_pandas(), pandas.DataFrame) and len(result.to_pandas())
        assert "<table>" in result._repr_html_()
    assert list(own[0].to_pandas()) == ["time_s", "displacement_m", "velocity_m_s", "force_N"]
    assert len(validation.to_pandas()) == len(own)


def leaves(said: Any) -> set[Any]:
    """Returns all texts and numbers in a nested dictionary."""
    if isinstance(said, dict):
        return set().union(*map(leaves, said.values()))
    if isinstance(said, (list, tuple)):
        return set().union(*map(leaves, said))
    return {said}


@pytest.fixture(scope="module")
def worn(own: dashpot.Campaign, tmp_path_factory: pytest.TempPathFactory) -> tuple[dashpot.FittedModel, dashpot.Campaign]:
    """Makes a model of the good damper, and a campaign of a damper with more friction and with a file that is no record."""
    folder = tmp_path_factory.mktemp("worn") / "campaign"
    measure(damper(friction=80), folder, seed=2)
    (folder / "notes.csv").write_text("what,when\nnothing,never\n")
    return dashpot.fit(own, elements=["series_compliance", "coulomb_friction", "gas_preload"]), dashpot.Campaign.read(folder)


def test_nothing_that_a_result_holds_is_missing_in_its_tables_and_its_view(own: dashpot.Campaign, worn: tuple[dashpot.FittedModel, dashpot.Campaign]) -> None:
    pytest.importorskip("pandas")
    model, campaign = worn
    assert campaign.unusable
    limits = [dashpot.Limit("force", 0.26, -math.inf, 1.0), dashpot.Limit("friction", None, 0.0, 500.0)]
    validation = model.validate(campaign, limits=limits)
    rivalled = model.validate(own, against=["fv", "dahl"])
    few = {"candidates": ["free_play", "moving_mass", "gas_spring"]}
    alone = dashpot.diagnose(model, campaign, **few)  # type: ignore[call-overload]
    compared = dashpot.diagnose(model, campaign, own, **few)  # type: ignore[call-overload]
    assert compared.changes and not compared.findings
    certificate = validation.limits
    assert dashpot.JudgedValidation.from_dict(validation.to_dict()) == validation
    results: list[Any] = [campaign, campaign[0], model, model.fit, validation, rivalled, validation.matrix, validation.tests[0], certificate, alone, compared]
    results += [*compared.changes, *compared.inventory, *model.fit.inventory, *alone.next_tests, *alone.regions, *alone.tree, campaign.sign]
    for result in results:
        assert result is not None
        tables = result.tables()
        in_tables = {value for table in tables.values() for column in table for value in leaves(list(table[column]))}
        view = result._repr_html_()
        for value in leaves(result.to_dict()):
            if value is None or value != value:
                continue
            assert value in in_tables, (type(result), value)
            if isinstance(value, str):
                # A long table is truncated and states the number of omitted rows.
                assert html.escape(value) in view or "more rows" in view, (type(result), value)
    assert list(validation.tables()) == list(dict.fromkeys(validation.tables())) and len(validation.to_pandas()) == len(campaign)
    # The main table of a result contains these values.
    found = compared.to_pandas()
    assert set(found["what"]) >= {"changed"}
    assert set(found["parameter"]) >= {c.name for c in compared.changes}
    matrix = validation.matrix.to_pandas()
    assert len(matrix) >= len(campaign) and set(matrix["by"]) >= {"amplitude", "peak velocity", "both"}
    assert "a25_v260" in leaves(list(certificate.to_pandas()["measured_tests"]))
    assert "not kept" in validation._repr_html_() and "Beside models of the literature" in rivalled._repr_html_()
    assert list(rivalled.tables()["against"]["model"])[1:] == ["fv", "dahl"] and "of" in rivalled.tables()["against.tests"]


def test_an_effect_without_numbers_is_in_the_table() -> None:
    pytest.importorskip("pandas")
    evidence = dict.fromkeys(("fraction", "mean_square_before", "mean_square_after", "log_odds", "numbers", "negative_log_prior", "tests_better"), 0.5)
    words = dict.fromkeys(("effect", "form", "meaning", "path", "family"), "word")
    finding: dict[str, Any] = {**words, **dict.fromkeys(("confidence", "family_confidence", "fraction", "force_n_rms"), 0.9), "of_the_rig": True, "parameters": {}, "gap_closed": None}
    empty: dict[str, Any] = dict.fromkeys(("where", "tree", "next_tests", "could_not_test", "shifts", "changes", "inventory", "notes", "tests", "iterations"), ())
    off = {"rmse_n": 1.0, "error_percent": 1.0, "left_out_rmse_n": None, "noise_n": 1.0, "left_out_noise_n": None}
    errors = dict.fromkeys(("mean_error_n", "error_percent", "region1_n", "region2_n", "rmse_n"), 1.0)
    whole = dict.fromkeys(("as_it_came", "refitted", "improved"), errors)
    found = dashpot.Diagnosis.from_dict({
        **empty, "verdict": "v", "summary": "s", "findings": [{**finding, "evidence": evidence, "rivals": []}], "before": off, "after": off,
        "suspects": [{"effect": "another", "confidence": 0.3, "fraction": 0.1, "why": "because"}], "gap_closed": None, "unexplained_fraction": 0.1,
        "corrections": {}, "over_whole_records": whole,
    })  # fmt: skip
    with pytest.raises(ValueError, match="kept by diagnose"):
        _ = found.improved
    assert found.to_pandas()[["what", "effect"]].to_numpy().tolist() == [["effect", "word"], ["suspect", "another"]]


def test_a_diagnosis_against_a_reference_says_what_changed(own: dashpot.Campaign, tmp_path: Path) -> None:
    folder = tmp_path / "worn"
    measure(damper(friction=80), folder, seed=2)
    worn = dashpot.Campaign.read(folder)
    model = dashpot.fit(own, elements=["series_compliance", "coulomb_friction", "gas_preload"])
    found = dashpot.diagnose(model, worn, own, candidates=["free_play"], max_effects=1)
    changed = {c.name: c for c in found.changes}
    assert changed["coulomb_force"].reference == pytest.approx(30, abs=5)
    assert changed["coulomb_force"].value == pytest.approx(80, abs=8)
    assert "coulomb_force" in found._repr_html_()


def test_a_campaign_and_a_reference_that_were_read_in_opposite_directions_are_told(own: dashpot.Campaign, tmp_path: Path) -> None:
    measure(damper(), tmp_path / "turned", seed=2)
    turn(tmp_path / "turned")
    turned = dashpot.Campaign.read(tmp_path / "turned")
    # This campaign is read with the wrong direction, so that rebound and compression are exchanged.
    wrong = dashpot.Campaign.read(tmp_path / "turned", positive="rebound")
    assert (own.sign.positive, turned.sign.positive) == ("rebound", "compression")
    model = dashpot.fit(own, family="fv")
    few = {"candidates": ["free_play"], "max_effects": 0}
    found = dashpot.diagnose(model, turned, own, **few)  # type: ignore[call-overload]
    assert any("counting compression positive and the reference as counting rebound" in note for note in found.notes)
    for campaign in (own, wrong):
        assert not any("counting" in note for note in dashpot.diagnose(model, campaign, own, **few).notes)  # type: ignore[call-overload]
    both = dashpot.Campaign.read(tmp_path / "turned", positive="compression"), dashpot.Campaign.read(own.paths[0], positive="rebound")
    assert not any("counting" in note for note in dashpot.diagnose(model, *both, **few).notes)  # type: ignore[call-overload]
    # A diagnosis with a reference that has no similar motion does not fail. Notes report the missing motion and the opposite directions.
    notes = dashpot.diagnose(model, turned[3:4], own[:1], **few).notes  # type: ignore[call-overload]
    assert any("the reference has no motion like these" in note for note in notes)
    assert any('read both with positive="rebound", or both with positive="compression"' in note for note in notes)


def test_a_model_file_is_written_as_it_was_read(own: dashpot.Campaign, tmp_path: Path) -> None:
    model = dashpot.fit(own, family="fv")
    model.write(tmp_path / "a.toml")
    read = dashpot.Model.read(tmp_path / "a.toml")
    read.write(tmp_path / "b.toml")
    assert (tmp_path / "a.toml").read_bytes() == (tmp_path / "b.toml").read_bytes()
    with pytest.raises(dashpot.OutputError, match="no folder"):
        model.write(tmp_path / "nowhere" / "a.toml")


def test_a_model_lists_the_numbers_that_are_in_use() -> None:
    table = ["fv_form", "fv_interpolation", "fv_velocity", "fv_force"]
    spring = ["spring_linear", "spring_quadratic", "spring_cubic", "spring_quartic"]
    text = damper().text.replace('"gas_preload"', '"parallel_spring"') + "substeps = 4\n"
    model = dashpot.Model(text)
    listed = list(model)
    assert [name for name in listed if name.startswith(("fv_", "spring_"))] == table + spring
    assert "substeps" in model and model["substeps"] == 4 and "gas_force" not in model
    # A note reports a parameter of an inactive element in the file.
    assert any("gas_force" in note and "off" in note for note in model.notes)
    with pytest.raises(KeyError, match="no parameter 'fv_rebound_c1' in use here"):
        model["fv_rebound_c1"]
    assert dict(model) == {name: parameter.value for name, parameter in model.parameters.items()}
    assert set(model.to_pandas()["name"]) == set(listed)
    knees = dashpot.Model('format = 1\nelements = ["fv_curve"]\nfv_form = "piecewise"\n')
    assert {"fv_rebound_c1", "fv_compression_v1"} < set(knees) and "fv_force" not in knees


def test_work_gives_the_lock_back(own: dashpot.Campaign) -> None:
    """Another Python thread continues while a fit runs."""
    ticks, gaps, stop = 0, [0.0], threading.Event()

    def tick() -> None:
        nonlocal ticks
        last = time.perf_counter()
        while not stop.is_set():
            time.sleep(0.001)
            now = time.perf_counter()
            gaps.append(now - last)
            last, ticks = now, ticks + 1

    thread = threading.Thread(target=tick)
    thread.start()
    started = time.perf_counter()
    dashpot.fit(own)
    spent = time.perf_counter() - started
    stop.set()
    thread.join()
    # If the fit did not release the lock, the other thread would stop for most of the time of the fit.
    assert max(gaps) < 0.5 * spent, (max(gaps), spent, ticks)


def test_progress_is_told_and_its_exceptions_come_through(own: dashpot.Campaign) -> None:
    told: list[tuple[float, str]] = []
    dashpot.fit(own, family="fv", progress=lambda done, text: told.append((done, text)))
    assert told[0][0] == 0.0 and told[-1] == (1.0, "done")

    def refuse(done: float, text: str) -> None:
        raise KeyError(text)

    with pytest.raises(KeyError):
        dashpot.fit(own, family="fv", progress=refuse)


def test_what_cannot_be_simulated_is_refused() -> None:
    model = damper()
    for arguments, words in [
        (([0, 1], [0, 1, 2]), "3 samples"),
        (([0, 0], [0, 1]), "increase"),
        (([0], [0]), "two times"),
        (([0, 1],), "needs displacement_m or velocity_m_s"),
        (([0, 1], [0, np.nan]), "no finite number"),
    ]:
        with pytest.raises(ValueError, match=words):
            model.simulate(*arguments)
    with pytest.raises(dashpot.MotionError, match="step"):
        model.simulate([0, 1], [0, 1], step_s=-1.0)


class TestDampers:
    """Tests of dampers that are simulated step by step."""

    T = np.arange(2001) * 1e-3
    X = 0.02 * np.sin(20 * T)
    V = 0.4 * np.cos(20 * T)

    def test_one_is_what_simulate_says(self) -> None:
        model = damper()
        # simulate() starts in equilibrium with the first velocity, which this offset makes zero.
        v = self.V - self.V[0]
        expected = model.simulate(self.T, velocity_m_s=v, initial_position_m=0.01).force
        one = dashpot.Damper(model, 0.01)
        steps = zip(v[1:].tolist(), np.diff(self.T).tolist(), strict=True)
        assert [one.step(u, dt) for u, dt in steps] == expected[1:].tolist()

    @pytest.mark.parametrize("count", [3, 700])
    def test_many_are_as_many_single_ones(self, count: int) -> None:
        model, other = damper(), damper(1.3)
        models = [model if k % 2 else other for k in range(count)]
        many = dashpot.Damper(models, np.linspace(-0.02, 0.02, count))
        singles = [dashpot.Damper(m, x) for m, x in zip(models, np.linspace(-0.02, 0.02, count).tolist(), strict=True)]
        gains = np.linspace(0.5, 1.5, count)
        out = np.empty(count)
        for v in self.V[:50]:
            assert many.step(gains * v, 1e-3, out=out) is out
            assert out.tolist() == [s.step(float(g * v), 1e-3) for s, g in zip(singles, gains, strict=True)]

    def test_a_known_displacement_is_taken(self) -> None:
        many = dashpot.Damper(damper(), np.zeros(2))
        forces = many.step(self.V[1], 1e-3, displacement_m=[0.0, 0.02])
        assert many.state[:, 0].tolist() == [0.0, 0.02]
        assert forces.shape == (2,)

    def test_a_state_is_kept_and_put_back(self) -> None:
        many = dashpot.Damper(damper(), np.zeros(5))
        many.step(0.1, 1e-3)
        kept = many.state
        first = many.step(np.linspace(-1, 1, 5), 1e-3)
        many.state = kept
        assert many.step(np.linspace(-1, 1, 5), 1e-3).tolist() == first.tolist()

    def test_a_refused_step_changes_nothing(self) -> None:
        many = dashpot.Damper(damper(), np.zeros(4))
        many.step(0.1, 1e-3)
        kept, out = many.state, np.full(4, 7.0)
        refused: list[tuple[Any, float, str]] = [([0, 0, np.nan, 0], 1e-3, "damper 2"), (0.0, 0.0, "dt"), (1e9, 1e-3, "damper 0")]
        for velocity, dt, words in refused:
            with pytest.raises(dashpot.StepError, match=words):
                many.step(velocity, dt, out=out)
        with pytest.raises(ValueError, match="4 dampers"):
            many.step([0.0, 1.0], 1e-3)
        assert np.array_equal(many.state, kept) and (out == 7).all()
        with pytest.raises(ValueError, match="models"):
            dashpot.Damper([damper(), damper()], [0.0, 0.0, 0.0])

    #: A damper with internal states: a series spring, presliding friction and a gas that cools. Its friction also depends on the side force.
    REMEMBERS = (
        damper().text.replace('"gas_preload"', '"gas_preload", "gas_spring", "presliding_friction", "side_force_friction"')
        + "gas_length = 0.3\ngas_adiabatic_index = 1.4\ngas_thermal_time = 1.0\n"
    )
    #: C program of the same simulation. It reads a model file, starts in steady motion, continues it, and prints all states and forces.
    IN_C = """
    #include "dashpot.h"
    #include <stdio.h>
    #include <stdlib.h>
    static dashpot_params params = DASHPOT_PARAMS_INIT;
    static dashpot_model model;
    int main(int count, char **given) {
      static char text[1 << 16];
      FILE *file = fopen(given[1], "rb");
      size_t size = fread(text, 1, sizeof text, file);
      dashpot_fault fault;
      dashpot_state state;
      dashpot_input input = dashpot_input_motion(atof(given[2]), atof(given[3]));
      if (dashpot_params_read(&params, text, size, &fault) < 0) return 1;
      if (dashpot_model_init(&model, &params) < 0) return 2;
      input.known |= DASHPOT_KNOWS_SIDE_FORCE | DASHPOT_KNOWS_TEMPERATURE;
      input.side_force = atof(given[4]);
      input.temperature = atof(given[5]);
      int status = dashpot_state_init_motion(&model, &input, &state);
      printf("%d\\n", status);
      if (status < 0) return 0;
      const double *number = &state.displacement;
      for (int k = 0; k < 14; k++) printf("%.17g\\n", number[k]);
      for (int k = 0; k < 5; k++) {
        dashpot_output output;
        input.displacement += 1e-3 * input.velocity;
        dashpot_step(&model, &state, &input, 1e-3, &state, &output);
        printf("%.17g\\n", output.force);
      }
      return count == 0;
    }
    """

    def test_a_start_in_motion_is_that_of_the_c_interface(self, tmp_path: Path) -> None:
        library, compiler = os.environ.get("DASHPOT_LIBRARY"), shutil.which("cc")
        if library is None or compiler is None:
            pytest.skip("DASHPOT_LIBRARY names no library of the same sources, or there is no C compiler")
        model = dashpot.Model(self.REMEMBERS)
        model.write(tmp_path / "m.toml")
        (tmp_path / "start.c").write_text(self.IN_C)
        include = Path(__file__).parents[3] / "include"
        subprocess.run([compiler, "-I", include, "-o", tmp_path / "start", tmp_path / "start.c", library, "-lm"], check=True)
        starts = [(0.01, 0.3, 0.0, 20.0), (-0.02, -0.8, 400.0, 20.0), (0.0, 0.0, 0.0, 60.0), (0.0, 2e3, 0.0, 20.0)]
        for x, v, side, temperature in starts:
            ran = subprocess.run(
                [tmp_path / "start", tmp_path / "m.toml", *map(repr, (x, v, side, temperature))], capture_output=True, text=True, check=True
            )
            status, *numbers = map(float, ran.stdout.split())
            if status < 0:
                with pytest.raises(dashpot.StepError, match="damper 0 cannot start so"):
                    dashpot.Damper(model, x, initial_velocity_m_s=v, side_force_n=side, temperature_c=temperature)
                continue
            one = dashpot.Damper(model, x, initial_velocity_m_s=v, side_force_n=side, temperature_c=temperature)
            assert one.state[0].tolist() == numbers[:14]
            forces = []
            for _ in range(5):
                x += 1e-3 * v
                forces.append(one.step(v, 1e-3, x, side_force_n=side, temperature_c=temperature))
            assert forces == numbers[14:]

    def test_a_damper_that_starts_in_motion_is_what_simulate_says(self) -> None:
        model = dashpot.Model(self.REMEMBERS)
        expected = model.simulate(self.T, self.X, self.V).force
        one = dashpot.Damper(model, self.X[0], initial_velocity_m_s=self.V[0])
        motion = zip(self.V[1:].tolist(), np.diff(self.T).tolist(), self.X[1:].tolist(), strict=True)
        assert [one.step(v, dt, x) for v, dt, x in motion] == expected[1:].tolist()
        # The continued steady motion has no jump. The force differs from the FV curve only by the gas force, because the gas is compressed
        # faster than it cools.
        steady = dashpot.Damper(damper(), 0.0, initial_velocity_m_s=0.5)
        assert steady.step(0.5, 1e-4) == pytest.approx(damper().steady_force(0.5)[0], abs=0.1)
        assert dashpot.Damper(damper(), 0.0).step(0.5, 1e-4) < 0.8 * damper().steady_force(0.5)[0]

    def test_each_of_many_may_start_in_its_own_manner(self) -> None:
        model = dashpot.Model(self.REMEMBERS)
        many = dashpot.Damper(model, [0.0, 0.01], initial_velocity_m_s=[0.2, -0.3], side_force_n=100.0, temperature_c=[20, 40])
        singles = [
            dashpot.Damper(model, x, initial_velocity_m_s=v, side_force_n=100.0, temperature_c=t) for x, v, t in [(0.0, 0.2, 20.0), (0.01, -0.3, 40.0)]
        ]
        assert many.state.tolist() == [s.state[0].tolist() for s in singles]
        for wrong, words in [
            ({"initial_velocity_m_s": [0.1]}, "initial_velocity_m_s has 1 values; give one number, or one for each of the 2 dampers"),
            ({"temperature_c": [[20.0, 20.0]]}, "temperature_c is one column"),
        ]:
            with pytest.raises(ValueError, match=words):
                dashpot.Damper(model, [0.0, 0.01], **wrong)  # type: ignore[arg-type]
        with pytest.raises(TypeError, match="complex"):
            dashpot.Damper(model, initial_velocity_m_s=1j)
        for wrong in ({"initial_velocity_m_s": float("nan")}, {"side_force_n": float("inf")}, {"temperature_c": 1e9}):
            with pytest.raises(dashpot.StepError, match="damper 0 cannot start so"):
                dashpot.Damper(model, **wrong)

    def test_steps_do_not_allocate_for_each_damper(self) -> None:
        def grown(count: int) -> int:
            many, out, v = dashpot.Damper(damper(), np.zeros(count)), np.empty(count), np.zeros(count)
            many.step(v, 1e-3, out=out)
            tracemalloc.start()
            for _ in range(10):
                many.step(v, 1e-3, out=out)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            return peak

        assert grown(20_000) < grown(20) + 4096


def test_export_fmu(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import zipfile

    # The FMU must come from the binaries in the installed wheel, because no compiler can run and no library is given.
    monkeypatch.setenv("PATH", str(tmp_path / "nothing"))
    monkeypatch.delenv("CC", raising=False)
    path = tmp_path / "car.fmu"
    platforms = damper().export_fmu(path, others=[damper(0.8)])
    assert "linux64" in platforms
    names = zipfile.ZipFile(path).namelist()
    assert "modelDescription.xml" in names and "binaries/linux64/dashpot_damper.so" in names
    damper().export_adams(tmp_path / "run")
    assert (tmp_path / "run" / "README.txt").is_file()
    with pytest.raises(dashpot.ExportError, match="FMI 4"):
        damper().export_fmu(tmp_path / "b.fmu", fmi=4)
    with pytest.raises(dashpot.ExportError, match="one model file, two"):
        damper().export_fmu(tmp_path / "b.fmu", others=[damper(), damper()])


def test_a_motion_that_is_none_of_a_damper_is_warned_of() -> None:
    t = np.linspace(0.0, 1.0, 1001)
    model = damper()
    calls: list[tuple[Callable[[], object], str]] = [
        (lambda: model.simulate(t, displacement_m=20.0 * np.sin(10 * t)), "amplitude of 20 m"),
        (lambda: model.simulate(t, velocity_m_s=200.0 * np.cos(10 * t), initial_position_m=0.0), "divide"),
        (lambda: model.simulate(t, 0.4 * np.sin(200 * t)), "m/s is none of a damper"),
        (lambda: model.steady_force([0.0, 260.0]), "260 m/s"),
        (lambda: dashpot.Damper(model, 12.0), "divide millimeters by 1000"),
        (lambda: dashpot.Damper(model, 0.0).step(300.0, 1e-4), "divide millimeters by 1000"),
        (lambda: dashpot.Damper(model, [0.0, 0.0]).step([0.1, -262.0], 1e-4), "divide millimeters by 1000"),
    ]
    for call, words in calls:
        with pytest.warns(UserWarning, match=words) as warned:
            call()
        assert len(warned) == 1 and warned[0].filename == __file__
    # Neither a long stroke of a real damper nor a large offset of its displacement causes a warning.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model.simulate(t, displacement_m=3.0 + 0.2 * np.sin(10 * t))
        dashpot.Damper(model, 0.3).step(5.0, 1e-3)


def test_a_sign_that_the_records_hardly_tell_is_warned_of(tmp_path: Path) -> None:
    """A symmetric damper without gas is equal in both directions, so the sign of its files is uncertain."""
    t = np.linspace(0.0, 4.0, 4001)
    for name, speed in (("slow", 0.1), ("fast", 0.4)):
        motion = 20.0 * np.sin(speed / 0.02 * t)
        force = 1500.0 * speed * np.cos(speed / 0.02 * t)
        rows = "".join(f"{a:.4f},{x:.5f},{f:.3f}\n" for a, x, f in zip(t, motion, force, strict=True))
        (tmp_path / f"{name}.csv").write_text("time_s,displacement_mm,force_N\n" + rows)
    with pytest.warns(UserWarning, match="sure") as warned:
        dashpot.Campaign.read(tmp_path)
    assert any('Say it: positive="' in str(of.message) for of in warned)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        dashpot.Campaign.read(tmp_path, positive="rebound")


def test_a_part_of_a_campaign_is_a_campaign(own: dashpot.Campaign) -> None:
    part = own[1:3]
    assert isinstance(part, dashpot.Campaign) and part.names == own.names[1:3] and len(own[5:2]) == 0
    assert part.sign == own.sign and part[0] == own[1] and part[-1:].names == own.names[2:3]
    assert np.array_equal(part[0].force, own[1].force) and part[0].fingerprint == own[1].fingerprint
    # Functions that accept records also accept parts of a campaign, and combined records of several parts.
    assert dashpot.fit(own[:], family="fv").text == dashpot.fit(list(own), family="fv").text
    assert dashpot.fit([*own[:2], *own[2:]], family="fv").text == dashpot.fit(list(own), family="fv").text
    assert pickle.loads(pickle.dumps(part)).names == part.names
    assert "2 tests" in repr(part)


def test_tables_of_tests_are_indexed_by_test(own: dashpot.Campaign) -> None:
    pytest.importorskip("pandas")
    table = own.to_pandas()
    assert table.index.name == "test" and list(table.index) == list(own.names)
    assert table.loc[own.names[1], "amplitude"] == own[1].amplitude
    validated = dashpot.fit(own, family="fv").validate(own).to_pandas()
    assert validated.index.name == "test" and set(validated.index) == set(own.names)


def test_channels_are_datasets_of_xarray(own: dashpot.Campaign) -> None:
    xarray = pytest.importorskip("xarray")
    measured = own[0].to_xarray()
    assert isinstance(measured, xarray.Dataset) and measured.force.attrs["units"] == "N" and measured.time.attrs["units"] == "s"
    assert np.array_equal(measured.force.values, own[0].force)
    answer = damper().simulate(own[0].time, own[0].displacement).to_xarray()
    assert float((answer.force - measured.force).mean()) == pytest.approx(float(np.mean(answer.force.values - own[0].force)))
    assert own.to_xarray().amplitude.sel(test=own.names[1]).item() == own[1].amplitude


def test_a_missing_path_is_a_file_that_is_not_found(own: dashpot.Campaign, tmp_path: Path) -> None:
    nowhere, model = tmp_path / "nowhere", damper()
    calls: list[tuple[Callable[[], object], type[Exception]]] = [
        (lambda: dashpot.Campaign.read(nowhere), dashpot.RecordError),
        (lambda: dashpot.Campaign.read([own.paths[0], nowhere / "a.csv"]), dashpot.RecordError),
        (lambda: dashpot.Model.read(f"{nowhere}.toml"), dashpot.ModelError),
        (lambda: dashpot.Model.from_dpr(f"{nowhere}.dpr"), dashpot.ModelError),
        (lambda: dashpot.Model.from_peaks(f"{nowhere}.csv"), dashpot.ModelError),
        (lambda: dashpot.read_limits(f"{nowhere}.csv"), dashpot.ValidationError),
        (lambda: model.export_fmu(tmp_path / "a.fmu", binaries={"win64": f"{nowhere}.dll"}), dashpot.ExportError),
        (lambda: dashpot.diagnose_groups(model, nowhere, "folders"), dashpot.DiagnosisError),
        (lambda: dashpot.explain(model, f"{nowhere}.toml"), dashpot.DimensionsError),
    ]
    for call, kind in calls:
        with pytest.raises(FileNotFoundError, match="nowhere") as raised:
            call()
        assert isinstance(raised.value, kind) and str(raised.value.filename).startswith(str(nowhere))
        again = pickle.loads(pickle.dumps(raised.value))
        assert (str(again), type(again)) == (str(raised.value), type(raised.value))


def test_write_overwrites_where_that_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    damper().write(path)
    damper().write(path)  # the same text
    with pytest.raises(FileExistsError, match="force=True") as raised:
        damper(1.3).write(path)
    assert isinstance(raised.value, dashpot.OutputError) and dashpot.Model.read(path) == damper()
    damper(1.3).write(path, force=True)
    assert dashpot.Model.read(path) == damper(1.3)
    dashpot.write_test_matrix(tmp_path / "m.csv")
    with pytest.raises(FileExistsError):
        dashpot.write_test_matrix(tmp_path / "m.csv", slow_tests=False)


def test_a_printed_fit_is_a_table(own: dashpot.Campaign) -> None:
    fit = dashpot.fit(own).fit
    printed = str(fit)
    lines = printed.splitlines()
    assert lines[0] == "[[Fit]]" and "[[Parameters]]" in lines
    for p in fit.parameters:
        name = p.name if p.index is None else f"{p.name}[{p.index}]"
        (line,) = [line for line in lines if line.strip().startswith(f"{name}:")]
        assert f"{p.value:.6g}" in line and p.unit in line
        assert ("+/-" in line) == (p.standing == "identified" and p.low is not None)
    assert max(map(len, lines[: lines.index("[[Parameters]]")])) < 100


def test_the_interface_alone_is_listed() -> None:
    assert set(dir(dashpot)) == {*dashpot.__all__, "fleet", "plot"}
    for name in dir(dashpot):
        assert getattr(dashpot, name) is not None


def test_every_number_of_an_argument_has_its_unit_in_its_name() -> None:
    """Every argument of type float has a unit in its name, except dimensionless numbers."""
    pure = {
        "gain", "setting", "clicks", "motion_scale", "force_scale", "noise_percent", "noise_colour", "hide", "seed", "max_effects",
    }  # fmt: skip
    units = ("_m", "_s", "_m_s", "_n", "_c", "_hz", "_kg")
    calls = [getattr(dashpot, name) for name in dashpot.__all__]
    calls += [f for kind in calls if inspect.isclass(kind) for name, f in vars(kind).items() if not name.startswith("_") or name == "__init__"]
    seen = 0
    for call in calls:
        function = call.__func__ if isinstance(call, (classmethod, staticmethod)) else call
        if not inspect.isfunction(function) or dataclasses.is_dataclass(getattr(function, "__self__", None)):
            continue
        # Constructors of results are skipped, because their arguments are the keys of the command's JSON.
        if function.__name__ == "__init__" and any(function is vars(k).get("__init__") for k in calls if dataclasses.is_dataclass(k)):
            continue
        for name, parameter in inspect.signature(function).parameters.items():
            hint = str(parameter.annotation)
            if ("float" in hint or "ArrayLike" in hint) and name not in pure and "Callable" not in hint and "Mapping" not in hint:
                seen += 1
                assert name.endswith(units), (function.__qualname__, name, hint)
    assert seen > 30


def test_views_of_notebooks_fit_a_page(own: dashpot.Campaign) -> None:
    model = dashpot.fit(own)
    for shown in (own, own[0], model, model.fit, model.validate(own), model.check()):
        view = shown._repr_html_()
        for cell in re.findall(r"<td[^>]*>(.*?)</td>", view):
            assert len(html.unescape(cell)) <= 48, cell
        # Every table scrolls in its own box, and all but a few remarks are folded.
        assert view.count("<table>") == view.count("max-height")
        assert all(listed.count("<li>") <= 8 for listed in re.findall(r"</h4><ul>(.*?)</ul>", view))
