"""Tests that exports to Adams, and models from Adams files and from tables, equal those of the command byte by byte."""

from __future__ import annotations

import warnings
from pathlib import Path

import pytest
from conftest import Command

import dashpot
from dashpot._arguments import as_arguments

#: A compiled model with one damper, as Adams Car writes it.
CAR = """A title
UNITS/
, FORCE = NEWTON
, MASS = KILOGRAM
, LENGTH = MILLIMETER
, TIME = SECOND
!  adams_view_name='susp.dal_ride_damper.force'
SFORCE/1
, TRANSLATIONAL
, I = 75
, J = 76
, FUNCTION = akispl(vr(75,76),0,9)
SPLINE/9
, X = -100, 0, 100
, Y = 500, 0, -900
END
"""


@pytest.fixture
def beside(command: Command, model: dashpot.FittedModel, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Makes the folder of the command, which contains the model, the working directory of Python."""
    monkeypatch.chdir(command.folder)
    Path("front.toml").write_text(model.text)
    return command.folder


def told(out: str) -> list[str]:
    """Returns the command's messages without the path of the output. Options are replaced by arguments of the package."""
    lines = [line.strip() for line in out.splitlines()]
    return [as_arguments(line.removeprefix("note: ").removeprefix("note, ")) for line in lines if " points in " not in line and "README.txt" not in line]


def same_folder(mine: str, theirs: str) -> None:
    names = sorted(path.name for path in Path(theirs).iterdir())
    assert sorted(path.name for path in Path(mine).iterdir()) == names and "README.txt" in names
    for name in names:
        assert (Path(mine) / name).read_bytes() == (Path(theirs) / name).read_bytes(), name


def test_a_run_folder(command: Command, beside: Path) -> None:
    model = dashpot.Model.read("front.toml")
    said = command("export", "adams", "front.toml", "-o", "c run", "--length", "412.5", "--wheel-mass", "35", "--host-step", "0.002")
    if not any(Path("c run").glob("*.so")):
        pytest.skip("this command was built without the libraries for Adams, which the package holds: sh vi-crt-bridge/runtimes.sh")
    notes = model.export_adams("p run", length_m="412.5mm", wheel_mass_kg=35, host_step_s=0.002)
    same_folder("p run", "c run")
    assert [line.split(": ", 1)[-1] for line in notes] == [line.split(": ", 1)[-1] for line in told(said)]
    # A length without a unit is in m.
    model.export_adams("p run", length_m=0.4125, wheel_mass_kg=35, host_step_s=0.002)
    same_folder("p run", "c run")
    command("export", "adams", "front.toml", "-o", "c ready", "--for-step", "0.005")
    model.export_adams("p ready", for_step_s=0.005)
    same_folder("p ready", "c ready")
    lengths: list[tuple[float | str, str]] = [
        (412.5, "no damper is 412.5 m long.*a number alone is in m"), ("0.4mm", "0.4 mm long"), ("412,5", "decimal comma")
    ]  # fmt: skip
    for wrong, words in lengths:
        with pytest.raises(dashpot.ExportError, match=words):
            model.export_adams("never", length_m=wrong)
    with pytest.raises(dashpot.ExportError, match="^wheel_mass_kg is in kg"):
        model.export_adams("never", wheel_mass_kg=-1.0)
    with pytest.raises(dashpot.ExportError, match="cannot read nothing.so"):
        model.export_adams("never", library="nothing.so")
    assert not Path("never").exists()
    Path("p run/README.txt").write_text("a,b\n1,2\n")
    with pytest.raises(dashpot.OutputError, match="README.txt is there already.*force=True"):
        model.export_adams("p run", length_m=0.4125)
    model.export_adams("p run", length_m=0.4125, wheel_mass_kg=35, host_step_s=0.002, force=True)
    same_folder("p run", "c run")


def test_a_property_file_and_back(command: Command, beside: Path) -> None:
    model = dashpot.Model.read("front.toml")
    for name, options in [("a.dpr", []), ("a.xml", []), ("own.dpr", ["--model-curve"])]:
        said = command("export", "dpr", "front.toml", "-o", f"c {name}", *options)
        assert model.export_dpr(f"p {name}", model_curve=bool(options)) == told(said)
        assert Path(f"p {name}").read_bytes() == Path(f"c {name}").read_bytes()
        command("import", "dpr", f"c {name}", "-o", "back.toml")
        back = dashpot.Model.from_dpr(f"c {name}")
        assert back.text == Path("back.toml").read_text() and "fv_curve" in back.elements
        assert abs(back.steady_force(0.3)[0]) > 10
    Path("no.dpr").write_text("nothing\n")
    with pytest.raises(dashpot.ModelError, match="no.dpr"):
        dashpot.Model.from_dpr("no.dpr")
    with pytest.raises(dashpot.ModelError, match="cannot read nowhere.dpr"):
        dashpot.Model.from_dpr("nowhere.dpr")
    with pytest.raises(dashpot.OutputError, match="no.dpr is there already"):
        model.export_dpr("no.dpr")
    model.export_dpr("no.dpr", force=True)
    with pytest.raises(dashpot.ExportError, match="the element fv_curve is off"):
        dashpot.Model("format = 1\nelements = [\"gas_preload\"]\ngas_force = 100.0\n").export_dpr("never.dpr")


def test_dampers_of_a_compiled_model(command: Command, beside: Path) -> None:
    Path("car.adm").write_text(CAR)
    command("export", "adm", "car.adm", "-o", "c.adm", "--damper", "dal_ride_damper.force=412.5,front.toml", "--replace-preload")
    for length in (412.5, "412.5mm", "0.4125m"):
        notes = dashpot.export_adm("car.adm", "p.adm", {"dal_ride_damper.force": (length, "front.toml")}, replace_preload=True)
        assert Path("p.adm").read_bytes() == Path("c.adm").read_bytes() and notes == []
    said = command("export", "adm", "car.adm", "-o", "c.adm", "--damper", "SFORCE/1=412.5mm", "--model-file", "no.toml")
    notes = dashpot.export_adm("car.adm", "p.adm", {"SFORCE/1": "412.5mm"}, model_file="no.toml")
    assert notes and notes == told("\n".join(said.splitlines()[1:])) and Path("p.adm").read_bytes() == Path("c.adm").read_bytes()
    with pytest.raises(dashpot.ExportError, match="SFORCE/1: no damper is 0.4125 millimeter long"):
        dashpot.export_adm("car.adm", "p.adm", {"SFORCE/1": 0.4125})
    with pytest.raises(dashpot.ExportError, match="SFORCE/7"):
        dashpot.export_adm("car.adm", "p.adm", {"SFORCE/7": 412.5})
    with pytest.raises(dashpot.OutputError, match="car.adm is read by this run"):
        dashpot.export_adm("car.adm", "car.adm", {"SFORCE/1": 412.5})
    with pytest.raises(TypeError, match="the length of SFORCE/1 is a length in m"):
        dashpot.export_adm("car.adm", "p.adm", {"SFORCE/1": None})  # type: ignore[dict-item]
    assert Path("car.adm").read_text() == CAR


def test_a_table_of_peaks(command: Command, beside: Path) -> None:
    rows = [(25, 60, 50), (50, 110, 70), (130, 260, 110), (250, 420, 170)]
    Path("dyno.csv").write_text("Velocity,Force A,Force B\n" + "".join(f"{v},{r},{c}\n" for v, r, c in rows))
    options = ["--unit", "velocity=mm/s", "--unit", "force=lbf", "--column", "rebound_force=Force A", "--column", "compression_force=3"]
    command("import", "peaks", "dyno.csv", "-o", "c.toml", *options, "--gas-force", "120", "--friction", "30")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        begun = dashpot.Model.from_peaks(
            "dyno.csv", units={"velocity": "mm/s", "force": "lbf"}, columns={"rebound_force": "Force A", "compression_force": 3},
            gas_force_n=120, friction_n=30,
        )  # fmt: skip
    assert begun.text == Path("c.toml").read_text()
    assert begun["gas_force"] == 120 and begun["coulomb_force"] == 30 and begun.elements
    # The table has a larger force in compression than in rebound, which few dampers have, so the import must warn.
    Path("signed.csv").write_text("velocity_m_s,force_N\n" + "".join(f"{s * v},{s * f}\n" for v, r, c in [(0.1, 200, 500), (0.3, 400, 900)] for s, f in ((1, r), (-1, c))))
    said = command("import", "peaks", "signed.csv", "-o", "c.toml")
    with pytest.warns(UserWarning, match='if the table counts compression positive, give positive="compression"') as warned:
        begun = dashpot.Model.from_peaks("signed.csv")
    assert begun.text == Path("c.toml").read_text() and str(warned[0].message) in as_arguments(said)
    command("import", "peaks", "signed.csv", "-o", "c.toml", "--positive", "compression")
    assert dashpot.Model.from_peaks("signed.csv", positive="compression").text == Path("c.toml").read_text()

    def refused(*arguments: str) -> str:
        ran = command.run("import", "peaks", "signed.csv", "-o", "never.toml", *arguments)
        assert ran.returncode == 2
        return as_arguments(ran.stderr.strip().removeprefix("dashpot: "))

    with pytest.raises(dashpot.ModelError) as weak:
        dashpot.Model.from_peaks("signed.csv", friction_n=450)
    assert str(weak.value) == refused("--friction", "450") and "give gas_force_n and friction_n as they are in the table" in str(weak.value)
    with pytest.raises(dashpot.ModelError, match="^gas_force_n is NaN N; it must be 0 N to 1e6 N"):
        dashpot.Model.from_peaks("signed.csv", gas_force_n=float("nan"))
    with pytest.raises(dashpot.ModelError, match="^units: mm is no unit of force"):
        dashpot.Model.from_peaks("signed.csv", units={"force": "mm"})
    with pytest.raises(dashpot.ModelError, match="^units: a table of peaks has velocity and force, no displacement"):
        dashpot.Model.from_peaks("signed.csv", units={"displacement": "mm"})
    with pytest.raises(dashpot.ModelError, match="^columns: 'rebound' is no column of a table of peaks"):
        dashpot.Model.from_peaks("signed.csv", columns={"rebound": "RO"})
    with pytest.raises(dashpot.ModelError, match="nowhere.csv"):
        dashpot.Model.from_peaks("nowhere.csv")


def test_a_table_of_peaks_for_each_click(command: Command, beside: Path) -> None:
    rows = [(click, s * v, s * f * (1 + click / 20)) for click in (0, 10) for s, f in ((1, 900), (-1, 500)) for v in (0.1, 0.3)]
    Path("clicks.csv").write_text("clicks,velocity_m_s,force_N\n" + "".join(f"{c},{v},{f}\n" for c, v, f in rows))
    command("import", "peaks", "clicks.csv", "-o", "c.toml", "--clicks", "all")
    for clicks in (0, 10):
        assert dashpot.Model.from_peaks("clicks.csv", clicks=clicks).text == Path(f"c_{clicks}.toml").read_text()
    command("import", "peaks", "clicks.csv", "-o", "family.toml", "--clicks", "family")
    family = dashpot.Family.from_peaks("clicks.csv")
    assert family.text == Path("family.toml").read_text() and list(family.grid) == [0, 10]
    with pytest.raises(dashpot.ModelError) as several:
        dashpot.Model.from_peaks("clicks.csv")
    assert "each of 0, 10 clicks; clicks=0 takes one of them, one call for each gives a model of each" in str(several.value)
    ran = command.run("import", "peaks", "clicks.csv", "-o", "never.toml")
    assert ran.returncode == 2 and str(several.value) == as_arguments(ran.stderr.strip().removeprefix("dashpot: "))
    with pytest.raises(dashpot.ModelError, match="no curve of 5 clicks; there are those of 0, 10"):
        dashpot.Model.from_peaks("clicks.csv", clicks=5)
