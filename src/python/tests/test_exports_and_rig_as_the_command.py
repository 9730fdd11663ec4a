"""Tests that FMUs, campaigns of the virtual rig and test matrices equal those of the command byte by byte."""

from __future__ import annotations

import shutil
import zipfile
from pathlib import Path
from typing import Any

import pytest
from conftest import Command

import dashpot
from dashpot._arguments import as_arguments


@pytest.fixture
def beside(command: Command, model: dashpot.FittedModel, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Makes the folder of the command, which contains two models, the working directory of Python."""
    monkeypatch.chdir(command.folder)
    Path("front.toml").write_text(model.text)
    Path("rear.toml").write_text(model.text.replace("\n[identification]", "\n# the rear one\n[identification]"))
    return command.folder


def same_folder(mine: Path, theirs: Path) -> None:
    names = sorted(str(path.relative_to(theirs)) for path in theirs.rglob("*") if path.is_file())
    assert sorted(str(path.relative_to(mine)) for path in mine.rglob("*") if path.is_file()) == names and names
    for name in names:
        assert (mine / name).read_bytes() == (theirs / name).read_bytes(), name


@pytest.mark.parametrize(
    ("models", "options", "arguments"),
    [
        (["front.toml"], [], {}),
        (["front.toml"], ["--carmaker", "0.4125"], {"carmaker_length_m": 0.4125}),
        (["front.toml"], ["--carmaker", "412.5mm", "--model-curve", "--fmi", "3"], {"carmaker_length_m": "412.5mm", "model_curve": True, "fmi": 3}),
        (["front.toml"], ["--carmaker", "0.4125", "--hide-parameters", "--no-sources"], {"carmaker_length_m": 0.4125, "hide_parameters": True, "sources": False}),
        (["front.toml"], ["--for-step", "0.005", "--wheel-mass", "30"], {"for_step_s": 0.005, "wheel_mass_kg": 30}),
        (["front.toml", "rear.toml"], ["--host-step", "0.004", "--binary", "darwin64=mac.dylib"], {"host_step_s": 0.004, "binaries": {"darwin64": "mac.dylib"}}),
        (["front.toml"], ["--four", "--motion-scale", "-0.001", "--position-offset", "0.01"], {"four": True, "motion_scale": -0.001, "position_offset_m": 0.01}),
    ],
    ids=lambda value: "-".join(value) if isinstance(value, list) else "",
)
def test_an_fmu(command: Command, beside: Path, models: list[str], options: list[str], arguments: dict[str, Any]) -> None:
    first, *others = [dashpot.Model.read(name) for name in models]
    first.export_fmu("first.fmu", others=others, force=True)
    # The package contains the binaries of FMUs. The command may have been built without them, and then the test is skipped.
    bare = command.run("export", "fmu", "front.toml", "-o", "bare.fmu")
    if bare.returncode != 0:
        assert "runtimes.sh" in bare.stderr
        pytest.skip(bare.stderr)
    # The library of an FMU serves as the binary for another platform, because the export does not check the platform of a library.
    with zipfile.ZipFile("first.fmu") as fmu:
        Path("mac.dylib").write_bytes(fmu.read(next(name for name in fmu.namelist() if name.endswith(".so"))))
    for folder in ("mine", "theirs"):
        shutil.rmtree(folder, ignore_errors=True)
        Path(folder).mkdir()
    platforms = first.export_fmu("mine/car.fmu", others=others, **arguments)
    said = command("export", "fmu", *models, "-o", "theirs/car.fmu", *options)
    same_folder(Path("mine"), Path("theirs"))
    assert ", ".join(platforms) in said and Path("mine/car.pluginfo").exists() == ("carmaker_length_m" in arguments)


def test_an_fmu_that_cannot_be(beside: Path) -> None:
    model = dashpot.Model.read("front.toml")
    for wrong in ({"four": True}, {"motion_scale": 1.0}, {"force_scale": 1.0}, {"position_offset_m": 0.1}):
        with pytest.raises(ValueError, match="^carmaker_length_m sets signs, units and zero"):
            model.export_fmu("never.fmu", carmaker_length_m=0.4, **wrong)
    with pytest.raises(ValueError, match="^model_curve chooses"):
        model.export_fmu("never.fmu", model_curve=True)
    with pytest.raises(dashpot.ExportError, match="^carmaker_length_m takes one model"):
        model.export_fmu("never.fmu", carmaker_length_m=0.4, others=model)
    with pytest.raises(dashpot.ExportError, match="no damper is 412.5 m long"):
        model.export_fmu("never.fmu", carmaker_length_m=412.5)
    with pytest.raises(dashpot.ExportError, match='^binaries: "mac/os" is no platform'):
        model.export_fmu("never.fmu", binaries={"mac/os": "front.toml"})
    with pytest.raises(dashpot.ExportError, match="^binaries: cannot read nowhere.dll"):
        model.export_fmu("never.fmu", binaries={"win64": "nowhere.dll"})
    Path("code.dll").write_bytes(b"MZ of other sources")
    with pytest.raises(dashpot.ExportError, match="the binary for win64 was not compiled from the sources of this FMU|runtimes.sh"):
        model.export_fmu("never.fmu", binaries={"win64": "code.dll"})
    with pytest.raises(dashpot.ExportError, match="^for_step_s is in s"):
        model.export_fmu("never.fmu", for_step_s=0.0)
    with pytest.raises(dashpot.OutputError, match="front.toml is there already.*force=True"):
        model.export_fmu("front.toml")
    Path("car.pluginfo").write_text("#INFOFILE of another")
    with pytest.raises(dashpot.OutputError, match="car.pluginfo is there already"):
        model.export_fmu("car.fmu", carmaker_length_m=0.4)
    with pytest.raises(dashpot.OutputError, match="name the FMU otherwise"):
        model.export_fmu("car.pluginfo", carmaker_length_m=0.4)
    assert not Path("never.fmu").exists() and not Path("car.fmu").exists()


def test_a_matrix(command: Command, beside: Path) -> None:
    command("matrix", "-o", "theirs.csv")
    assert dashpot.write_test_matrix("mine.csv") == len(Path("theirs.csv").read_text().splitlines()) - 1
    assert Path("mine.csv").read_bytes() == Path("theirs.csv").read_bytes()
    command("matrix", "--amplitudes", "50,15,2", "--peak-velocities", "125,262", "--frequency-limit", "4", "--no-slow", "-o", "theirs.csv")
    count = dashpot.write_test_matrix("mine.csv", force=True, amplitudes_m=[0.05, 0.015, 0.002], peak_velocities_m_s=[0.125, 0.262], frequency_limit_hz=4, slow_tests=False)
    assert Path("mine.csv").read_bytes() == Path("theirs.csv").read_bytes() and count == 4
    for wrong, words in [
        ({"amplitudes_m": [-0.01]}, "^amplitudes_m: -10 mm; give positive numbers"),
        ({"peak_velocities_m_s": []}, "^peak_velocities_m_s: the list is empty"),
        ({"frequency_limit_hz": 0.001}, "^frequency_limit_hz: no point of the matrix lies at or below"),
    ]:
        with pytest.raises(dashpot.RigError, match=words):
            dashpot.write_test_matrix("never.csv", **wrong)  # type: ignore[arg-type]
    with pytest.raises(dashpot.OutputError, match="front.toml is there already"):
        dashpot.write_test_matrix("front.toml")
    assert not Path("never.csv").exists()


def test_a_campaign_of_the_rig(command: Command, beside: Path) -> None:
    count = dashpot.write_test_matrix("tests.csv", amplitudes_m=[0.025, 0.005], peak_velocities_m_s=[0.13, 0.52], slow_tests=False)
    noise = ["--noise", "0.5", "--noise-colour", "0.3", "--hum", "2", "--bits", "14", "--sample-rate", "2000", "--no-side-force"]
    command("rig", "-o", "theirs rig", "--seed", "4", "--matrix", "tests.csv", *noise)
    measured = dashpot.measure_virtual(
        "my rig", seed=4, matrix="tests.csv", noise_percent=0.5, noise_colour=0.3, hum_n=2, bits=14, sample_rate_hz=2000, side_force=False
    )
    same_folder(Path("my rig"), Path("theirs rig"))
    assert len(measured) == count == 4


@pytest.mark.parametrize(
    ("options", "arguments"),
    [
        (["--hide", "free_play=1.5", "--strength", "--plan", "one-amplitude", "--start-temperature", "30", "--order", "4", "--no-temperature"],
         {"hide": {"free_play": 1.5}, "plan": "one-amplitude", "start_temperature_c": 30, "order": 4, "temperature": False}),
        (["--hide", "nothing"], {"hide": {}}),
        (["--hide", "nothing", "--plan", "one-amplitude"], {"hide": "nothing", "plan": "one-amplitude"}),
        (["--hide", "cavitation=1,free_play:hertz=0.5,force_offset", "--noise", "2"],
         {"hide": {"cavitation": 1.0, "free_play:hertz": 0.5, "force_offset": None}, "severity": True, "noise_percent": 2}),
        (["--hide", "bushing", "--hide", "unknown_wear_step", "--plan", "one-amplitude"],
         {"hide": ["bushing", "unknown_wear_step"], "plan": "one-amplitude"}),
        (["--hide", "bushing", "--matrix", "small.csv"], {"hide": "bushing", "matrix": "small.csv", "severity": True}),
    ],
    ids=["a poor plan", "what a damper without an effect is looked at by", "nothing by name", "severities", "names alone", "on tests of one's own"],
)  # fmt: skip
def test_a_damper_that_hides(command: Command, records: Path, beside: Path, tmp_path: Path, options: list[str], arguments: dict[str, Any]) -> None:
    command("rig", "-o", str(tmp_path / "theirs"), "--seed", "3", *options)
    dashpot.measure_virtual(tmp_path / "mine", seed=3, **arguments)
    same_folder(tmp_path / "mine", tmp_path / "theirs")


def test_a_rig_that_cannot_be(command: Command, records: Path, beside: Path) -> None:
    def sentence(*arguments: str) -> str:
        ran = command.run("rig", "-o", "never", *arguments)
        assert ran.returncode == 2
        return as_arguments(ran.stderr.splitlines()[-1].removeprefix("dashpot: "))

    for options, arguments, told in [
        (["--noise-colour", "2"], {"noise_colour": 2}, ("option noise colour", "noise_colour")),
        (["--bits", "99"], {"bits": 99}, ("option bits", "bits")),
        (["--sample-rate", "1"], {"sample_rate_hz": 1}, ("option sample rate", "sample_rate_hz")),
        (["--hide", "nothing", "--start-temperature", "500"], {"hide": {}, "start_temperature_c": 500}, ("option start temperature", "start_temperature_c")),
        (["--plan", "rich"], {"plan": "rich"}, ("option plan", "plan")),
        (["--hide", "ghosts"], {"hide": {"ghosts": 1.0}}, ("option hide", "hide")),
        (["--hide", "free_play,ghosts=2"], {"hide": {"free_play": None, "ghosts": 2.0}, "severity": True}, ("option hide", "hide")),
        (["--hide", "free_play:odd=2"], {"hide": {"free_play:odd": 2.0}, "severity": True}, ("option hide", "hide")),
        (["--hide", "nothing,free_play"], {"hide": ["nothing", "free_play"]}, ("option hide", "hide")),
        (["--hide", "free_play,free_play"], {"hide": ["free_play", "free_play"]}, ("option hide", "hide")),
        (["--hide", "free_play=nan"], {"hide": {"free_play": float("nan")}, "severity": True}, ("option hide", "hide")),
        (["--hide", "free_play=-1", "--strength"], {"hide": {"free_play": -1.0}}, ("option hide", "hide")),
        (["--hide", "free_play=2", "--matrix", "small.csv"], {"hide": {"free_play": 2.0}, "severity": True, "matrix": "small.csv"}, ("", "")),
        (["--hide", "free_play=2", "--noise", "0"], {"hide": {"free_play": 2.0}, "severity": True, "noise_percent": 0}, ("", "")),
    ]:
        with pytest.raises(dashpot.RigError) as refused:
            dashpot.measure_virtual("never", **arguments)  # type: ignore[arg-type]
        assert str(refused.value) == sentence(*options).replace(*told)
        if "ghosts" in str(options):
            assert "gas_spring, stribeck_friction" in str(refused.value) and "unknown_wear_step" in str(refused.value)
    with pytest.raises(dashpot.RigError, match=r"with tests of your own \(matrix\), give strengths \(severity=False\)"):
        dashpot.measure_virtual("never", hide={"free_play": 2.0}, severity=True, amplitudes_m=[0.01])
    with pytest.raises(dashpot.RigError, match=r"give noise_percent, or strengths \(severity=False\)"):
        dashpot.measure_virtual("never", hide={"free_play": 2.0}, severity=True, noise_percent=0)
    for wrong in ({"plan": "thesis", "matrix": "tests.csv"}, {"plan": "thesis", "slow_tests": False}, {"matrix": "tests.csv", "amplitudes_m": [0.01]}):
        with pytest.raises(ValueError, match="exclude each other; give one"):
            dashpot.measure_virtual("never", **wrong)
    for alone in ({"order": 3}, {"start_temperature_c": 30.0}, {"severity": True}):
        with pytest.raises(ValueError, match="is of a damper in which effects are hidden"):
            dashpot.measure_virtual("never", **alone)
    assert not Path("never").exists()
