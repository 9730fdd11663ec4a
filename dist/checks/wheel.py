"""Repeats with the installed Python package what the command did, and compares every digit and every byte of the files.

wheel.py FOLDER     contains records/ and the files of the command: damper.toml, fit.json, errors.json, motion.csv, force.csv, damper.fmu
"""

import json
import sys
from importlib.metadata import distribution
from pathlib import Path

import numpy as np

import dashpot

folder = Path(sys.argv[1])
assert Path(dashpot.__file__).parents[1].name == "site-packages", dashpot.__file__

# The metadata of the wheel.
told = distribution("dashpot")
assert told.version == dashpot.__version__, (told.version, dashpot.__version__)
for name in told.metadata.get_all("License-File"):
    assert told.read_text(f"licenses/{name}"), name
assert "numpy" in told.read_text("licenses/THIRD-PARTY.txt")
assert any(part["name"] == "pyo3" for part in json.loads(told.read_text("sboms/dashpot.cdx.json"))["components"])


def said(name):
    return json.loads((folder / name).read_text(encoding="utf-8"))


campaign = dashpot.Campaign.read(folder / "records")
model = dashpot.fit(campaign)
assert model.text == (folder / "damper.toml").read_text(encoding="utf-8"), "another model file than the command's"
fit = said("fit.json")
del fit["model"]
assert model.fit.to_dict() == fit and len(fit["parameters"]) > 10
assert model.validate(campaign).to_dict() == said("errors.json"), "other errors than the command's"

motion = np.loadtxt(folder / "motion.csv", delimiter=",", skiprows=1)
force = np.loadtxt(folder / "force.csv", delimiter=",", skiprows=1)
response = model.simulate(motion[:, 0], displacement_m=motion[:, 1])
assert np.array_equal(np.column_stack([response.time, response.displacement, response.velocity, response.force]), force), "other forces than the command's"
assert np.ptp(response.force) > 100

model.export_fmu(folder / "python.fmu")
assert (folder / "python.fmu").read_bytes() == (folder / "damper.fmu").read_bytes(), "another FMU than the command's"
print(f"Python {sys.version.split()[0]}, numpy {np.__version__}: model, {len(campaign)} tests, {len(force)} forces and FMU as the command's")
