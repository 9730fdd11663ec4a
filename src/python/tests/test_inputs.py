"""Tests of the accepted forms of numbers, names, records and models in arguments, and of the messages for all other forms."""

from __future__ import annotations

import io
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fleets import damper, measure

import dashpot
from dashpot._arguments import as_arguments

T = np.arange(200) * 1e-3
X = 0.02 * np.sin(20 * T)


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> dashpot.Campaign:
    folder = tmp_path_factory.mktemp("Prüfstand ümläut") / "Dämpfer 1"
    measure(damper(), folder, seed=1)
    return dashpot.Campaign.read(folder)


def test_any_array_of_real_numbers_is_a_channel() -> None:
    expected = damper().simulate(T, X).force.tolist()
    wide = np.zeros((len(X), 3))
    wide[:, 1] = X
    frozen = X.copy()
    frozen.flags.writeable = False
    for same in (X.tolist(), wide[:, 1], frozen, X.astype(">f8"), X.astype(object), np.ma.masked_array(X), X[::-1][::-1]):
        assert damper().simulate(T, same).force.tolist() == expected
    assert damper().simulate(T.astype(np.float32), X.astype(np.float32)).force == pytest.approx(np.array(expected), rel=0.05, abs=20)
    many = dashpot.Damper(damper(), np.zeros(3))
    for velocity in ([0, 1, 0], np.array([0, 1, 0], dtype=np.int8), wide[:3, 0] + [0, 1, 0]):
        many.state = np.zeros((3, 14))
        forces = many.step(velocity, 1e-3)
        assert forces[1] > forces[0] == forces[2]


def test_series_of_pandas_are_channels() -> None:
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"t": T, "x": X})
    assert damper().simulate(table.t, table.x).force.tolist() == damper().simulate(T, X).force.tolist()
    with pytest.raises(ValueError, match="no finite number"):
        damper().simulate(table.t, table.x.where(table.x < 0.01))


@pytest.mark.parametrize(
    ("time", "displacement", "kind", "words"),
    [
        (T.astype("timedelta64[s]"), X, TypeError, "time_s holds dates or spans of time; give seconds"),
        (np.datetime64("2026-01-01") + T.astype("timedelta64[s]"), X, TypeError, "dates"),
        (T, X + 1j, TypeError, "displacement_m is no array of real numbers but of complex"),
        (T, np.ma.masked_greater(X, 0.01), ValueError, "displacement_m has masked values"),
        (T, np.zeros((len(T), 2)), ValueError, "one column of numbers, not 200 by 2"),
        (T, 0.1, ValueError, "not a single number"),
        (T, ["a"] * len(T), TypeError, "displacement_m is no array of real numbers"),
        (T, [{}] * len(T), TypeError, "displacement_m is no array of numbers"),
        (T, [None] * len(T), ValueError, "no finite number"),
        (T, np.where(T > 0.1, np.nan, X), ValueError, "no finite number"),
    ],
)  # fmt: skip
def test_what_is_no_column_of_real_numbers_is_refused(time: Any, displacement: Any, kind: type[Exception], words: str) -> None:
    with pytest.raises(kind, match=words):
        damper().simulate(time, displacement)


def test_dampers_say_what_they_take() -> None:
    many = dashpot.Damper(damper(), np.zeros(3))
    both = np.full(3, 0.1)
    frozen = np.zeros(3)
    frozen.flags.writeable = False
    kept = many.state
    for arguments, words in [
        ({"velocity_m_s": "0.1"}, "velocity_m_s is no array of real numbers"),
        ({"velocity_m_s": np.full(3, 1j)}, "complex"),
        ({"velocity_m_s": np.zeros((3, 1))}, "3 by 1"),
        ({"velocity_m_s": 0.1, "temperature_c": [20.0, 30.0]}, "temperature_c has 2 values"),
        ({"velocity_m_s": both, "out": both}, "out is velocity_m_s too"),
        ({"velocity_m_s": 0.1, "out": frozen}, "out must be a numpy array of one float64 for each damper"),
        ({"velocity_m_s": 0.1, "out": np.zeros(3, dtype=np.float32)}, "out must be"),
        ({"velocity_m_s": 0.1, "out": [0.0, 0.0, 0.0]}, "out must be"),
    ]:  # fmt: skip
        with pytest.raises((TypeError, ValueError), match=words):
            many.step(dt_s=1e-3, **arguments)  # type: ignore[arg-type]
    assert np.array_equal(many.state, kept)
    with pytest.raises(TypeError, match=r"made of a dashpot.Model, not of a str"):
        dashpot.Damper("damper.toml")  # type: ignore[arg-type]


def test_paths_and_results_in_each_others_place_are_told_apart(own: dashpot.Campaign) -> None:
    model = damper()
    for call in (
        lambda: dashpot.fit("campaign/"),  # type: ignore[arg-type]
        lambda: model.validate(Path("campaign")),  # type: ignore[call-overload]
        lambda: dashpot.diagnose(model, own, "good/"),  # type: ignore[arg-type]
    ):
        with pytest.raises(TypeError, match=r"is a dashpot.Campaign, not a .*; dashpot.Campaign.read\(path\) reads one"):
            call()
    with pytest.raises(TypeError, match=r"model is a dashpot.Model, not a Campaign"):
        dashpot.diagnose(own, model)  # type: ignore[call-overload]
    for path in (None, b"campaign", 3, [3]):
        with pytest.raises(TypeError, match="path is a file or folder"):
            dashpot.Campaign.read(path)  # type: ignore[arg-type]


def test_a_single_name_may_stand_alone(own: dashpot.Campaign) -> None:
    first = own.names[0]
    folder = own.paths[0]
    assert dashpot.Campaign.read(folder, exclude=first).names == dashpot.Campaign.read(folder, exclude=[first]).names == own.names[1:]
    one, listed = dashpot.fit(own, family="fv", hold_out=first), dashpot.fit(own, family="fv", hold_out=[first])
    assert one == listed and first not in one.tests
    found = dashpot.diagnose(one, own, candidates="free_play", max_effects=0, hold_out=first)
    assert [t.test for t in found.tests if t.left_out] == [first]


def test_numbers_of_a_mapping_are_numbers(own: dashpot.Campaign) -> None:
    with pytest.raises(ValueError, match="gain is nan; it must be a finite number"):
        dashpot.Campaign.read(own.paths[0], gain=float("nan"))


def test_a_wrong_name_is_answered_with_the_right_one(own: dashpot.Campaign) -> None:
    with pytest.raises(KeyError, match="did you mean 'coulomb_force'"):
        damper()["coulomb_forc"]
    with pytest.raises(dashpot.ModelError, match=r"Model.read"):
        dashpot.Model("damper.toml")


def test_a_file_of_another_kind_is_replaced_where_that_is_asked_for(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(dashpot.OutputError, match="or give force=True to replace it") as refused:
        damper().write(tmp_path / "notes.txt")
    assert "--force" not in str(refused.value) and (tmp_path / "notes.txt").read_text() == "mine"
    damper().write(tmp_path / "notes.txt", force=True)
    assert (tmp_path / "notes.txt").read_text() == damper().text
    # `force` applies only to the file of its call.
    (tmp_path / "more.txt").write_text("mine")
    with pytest.raises(dashpot.OutputError, match="more.txt is there already"):
        damper().write(tmp_path / "more.txt")


def test_sentences_speak_of_arguments_and_not_of_options(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("time_s,x,load\n" + "".join(f"{k / 100},{k % 7},{k % 5}\n" for k in range(50)))
    with pytest.raises(dashpot.RecordError, match=r'units=\{"displacement": "mm", "force": "N"\}'):
        dashpot.Campaign.read(tmp_path / "a.csv")
    for said, wanted in [
        ("Give --unit force=kN, or --unit force=N to insist", 'Give units={"force": "kN"}, or units={"force": "N"} to insist'),
        ('give --column a="B b" --column b="A" (and --unit where)', 'give columns={"a": "B b", "b": "A"} (and units where)'),
        ("give --unit force=... (and --unit where)", 'give units={"force": ...} (and units where)'),
        ('Other headings can be given as --column force="Load Cell 1"', 'Other headings can be given as columns={"force": "Load Cell 1"}'),
        ("--positive rebound or --positive compression, or give --positive", 'positive="rebound" or positive="compression", or give positive'),
        ("Give --flip motion, and leave --flip out", 'Give flip="motion", and leave flip out'),
        ("read one only: --ignore velocity (or --ignore displacement)", 'read one only: ignore="velocity" (or ignore="displacement")'),
        ("--dates day-first says which", 'dates="day-first" says which'),
        ("say --sample-rate 1000 (samples per second)", "say sample_rate_hz=1000 (samples per second)"),
        ("say dashpot import-profile FOLDER --unit force=N once", "say dashpot import-profile FOLDER --unit force=N once"),
        ("compare them by dashpot diagnose --group folders", "compare them by dashpot diagnose --group folders"),
        ("file--model.csv has --modelling in it", "file--model.csv has --modelling in it"),
    ]:
        assert as_arguments(said) == wanted


def test_no_sentence_about_records_speaks_of_an_option_that_is_an_argument() -> None:
    source = (Path(__file__).parents[2] / "records" / "src" / "messages" / "phrases.rs").read_text(encoding="utf-8")
    sentences = [text for text in re.findall(r'"((?:[^"\\]|\\.)*)"', source) if "--" in text]
    assert len(sentences) > 30
    for text in sentences:
        said = as_arguments(re.sub(r"\{\w+\}", "force", text.replace('\\"', '"')))
        assert "--" not in re.sub(r"dashpot [a-z-]+( [A-Z]+)? --\S+", "", said), said


def test_a_model_may_be_written_where_it_was_read(tmp_path: Path) -> None:
    damper().write(tmp_path / "Modell ä.toml")
    again = dashpot.Model.read(tmp_path / "Modell ä.toml")
    # The file already contains the same bytes, so nothing is overwritten.
    again.write(tmp_path / "Modell ä.toml")
    assert dashpot.Model.read(tmp_path / "Modell ä.toml") == damper()


def test_names_of_tests_are_shown_as_they_stand(own: dashpot.Campaign, tmp_path: Path) -> None:
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from dashpot import plot

    for source, name in zip(sorted(Path(own.paths[0]).iterdir()), ("_first", "price $5^$", "50 %", "a_b"), strict=False):
        shutil.copy(source, tmp_path / f"{name}.csv")
    campaign = dashpot.Campaign.read(tmp_path)
    validation = damper().validate(campaign)
    drawn = plot.campaign(campaign)
    drawn.legend()
    legend = drawn.get_legend()
    assert legend is not None and len(legend.get_texts()) == len(campaign)
    for axes in (drawn, plot.errors(validation), plot.loop(validation, campaign, "price $5^$")):
        figure = axes.get_figure(root=True)
        assert figure is not None
        figure.savefig(io.BytesIO())


def test_complex_numbers_are_refused(own: dashpot.Campaign) -> None:
    one = np.complex128(0.1 + 1j)
    damped = dashpot.Damper(damper())
    kept = damped.state
    calls: list[Callable[[], object]] = [
        lambda: damped.step(one, 1e-3),
        lambda: damped.step(0.1, 1e-3, one),
        lambda: damped.step(0.1, 1e-3, side_force_n=one),
        lambda: setattr(damped, "state", kept + 0j),
        lambda: dashpot.Damper(damper(), one),
        lambda: dashpot.Damper(damper(), np.array([one])),
        lambda: damper().simulate(T, velocity_m_s=X, initial_position_m=one),  # type: ignore[arg-type]
        lambda: damper().steady_force(one),
        lambda: dashpot.Campaign.read(own.paths[0], gain=one),  # type: ignore[arg-type]
        lambda: dashpot.Campaign.read(own.paths[0], sample_rate_hz=one),  # type: ignore[arg-type]
    ]
    for call in calls:
        with pytest.raises(TypeError, match="real number"):
            call()
    assert np.array_equal(damped.state, kept)


def test_a_state_of_another_model_is_refused() -> None:
    rubber = dashpot.Damper(dashpot.Model(damper().text.replace('"series_compliance"', '"series_compliance", "bushing"')))
    plain = dashpot.Damper(damper())
    kept = plain.state
    if np.array_equal(rubber.state[:, 12], kept[:, 12]):
        pytest.fail("the two models have the same states")
    with pytest.raises(ValueError, match="damper 0 is of a model with other elements"):
        plain.state = rubber.state
    assert np.array_equal(plain.state, kept)
    plain.state = np.zeros((1, 14))
    plain.state = kept


def test_a_model_is_a_mapping_of_its_numbers(tmp_path: Path) -> None:
    model = damper()
    assert "coulomb_force" in model and "coulomb" not in model and 0 not in model
    assert list(model) == list(model.parameters) and len(model) == len(model.parameters)
    assert dict(model)["coulomb_force"] == model["coulomb_force"] == 30
    with pytest.raises(TypeError, match=r"not a PosixPath|not a WindowsPath"):
        dashpot.Model(tmp_path / "damper.toml")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"others are dashpot.Model, not str"):
        model.export_fmu(tmp_path / "d.fmu", others=["damper.toml"])  # type: ignore[list-item]
    assert model.export_fmu(tmp_path / "d.fmu", others=model)


def test_a_response_is_compared_and_made_again() -> None:
    one, same, other = damper().simulate(T, X), damper().simulate(T, X), damper().simulate(T, 2 * X)
    assert one == same and one != other and one != "a response"
    assert len({one, same, other}) == 2
    assert dashpot.Response.from_dict(one.to_dict()) == one


def test_some_records_of_a_campaign_do_in_its_place(own: dashpot.Campaign) -> None:
    few = dashpot.fit(own[1:], family="fv")
    assert few.tests == own.names[1:]
    assert dashpot.fit([r for r in own if r.name != own.names[0]], family="fv") == few
    assert dashpot.fit(own[:], family="fv") == dashpot.fit(own, family="fv")
    validation = few.validate(own[:2])
    assert [t.name for t in validation.tests] == list(own.names[:2]) and validation.campaign is not None
    for records, words in ([own[0], own[0]], "holds a record twice"), ([own[0], dashpot.Campaign.read(own.paths[0])[1]], "not of one"):
        with pytest.raises(ValueError, match=words):
            dashpot.fit(records)
    with pytest.raises(TypeError, match=r"campaign is a dashpot.Campaign, not a list"):
        dashpot.fit([])


def test_pictures_need_no_import_of_their_own() -> None:
    program = "import sys, dashpot; assert 'dashpot.plot' not in sys.modules; dashpot.plot.curve; assert 'plot' in dir(dashpot)"
    subprocess.run([sys.executable, "-c", program], check=True)
    with pytest.raises(AttributeError, match="no attribute 'plott'"):
        dashpot.plott
