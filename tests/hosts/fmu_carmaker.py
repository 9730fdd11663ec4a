"""Runs an FMU as CarMaker does according to its template files, with the links in the .pluginfo file next to the FMU.

Arguments: FMU, shared library, model file, length of the damper at the rig's zero, m. The inputs are length and vel (extension positive), and
for a damper over a setting CtrlIn, in the unit of the model file. The output Force is positive if the damper pushes. The force must equal
that of the library, and dissipate energy."""
import math
import sys
from pathlib import Path

from fmpy import extract, read_model_description
from fmu_instance import begun

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))
from dashpot_damper import Damper  # noqa: E402

fmu, library, model_file, zero = *sys.argv[1:4], float(sys.argv[4])
info = {}
for line in Path(fmu).with_suffix(".pluginfo").read_text().splitlines():
    if " = " in line and not line.startswith("#"):
        key, value = line.split(" = ", 1)
        info[key] = value
description, folder = read_model_description(fmu, validate=False), extract(fmu)
three = description.fmiVersion.startswith("3")
variables = {v.name: v for v in description.modelVariables}
assert info["FMU.Modelclass"] == "Susp_Damper" and info["FMU.Name"] == Path(fmu).stem
assert info["FMU.GUID"] == (description.instantiationToken if three else description.guid)
inputs = {value: key.split(".")[1] for key, value in info.items() if key.startswith("FMUIn.") and key.endswith(".Rel")}
outputs = {key.split(".")[1]: value for key, value in info.items() if key.startswith("IFVar.") and key.endswith(".Rel")}
assert all(info[f"FMUIn.{name}.Link"] == "IFVar" and variables[name].causality == "input" for name in inputs.values())
assert all(info[f"IFVar.{name}.Link"] == "FMUVar" and variables[to].causality == "output" for name, to in outputs.items())
controlled = "setting" in variables
assert set(inputs) == {"length", "vel", *(["CtrlIn"] if controlled else [])} and set(outputs) == {"Force"}

place = [variables[inputs[name]].valueReference for name in ("length", "vel")]
control = [variables[inputs["CtrlIn"]].valueReference] if controlled else []
force = [variables[outputs["Force"]].valueReference]
STEP, AMPLITUDE, OMEGA = 1e-3, 0.03, 2 * math.pi * 2


def motion(t):
    return [AMPLITUDE * math.sin(OMEGA * t), AMPLITUDE * OMEGA * math.cos(OMEGA * t)]


for told in (True, False):
    # An importer may set the length before initialization, or not before the first step.
    at = motion(0.0)
    damper = begun(description, folder, False,
                   lambda u: told and (u.setFloat64 if three else u.setReal)(place, [zero + at[0], 0.0]))
    get, put = (damper.getFloat64, damper.setFloat64) if three else (damper.getReal, damper.setReal)
    own = Damper(library, model_file, at[0])
    rest, power, worst, top = get(force)[0], 0.0, 0.0, 0.0
    # With velocity 0 the damper starts at rest, where the gas pushes the rod out.
    assert abs(rest + own.step(at[0], 0.0, 0.0)) < 1e-9 and rest > 50.0, rest
    for k in range(1500):
        x, v = motion((k + 1) * STEP)
        put(place, [zero + x, v])
        # The controller switches during the run.
        setting = None if not controlled else 0.6 if k < 500 else 1.4
        if setting is not None:
            put(control, [setting])
        damper.doStep(k * STEP, STEP)
        push, pull = get(force)[0], own.step(x, v, STEP, setting)
        worst, top, power = max(worst, abs(push + pull)), max(top, abs(pull)), power + push * v
    damper.terminate()
    damper.freeInstance()
    print(f"FMI {description.fmiVersion}: largest difference {worst:.2e} N of {top:.0f} N")
    assert worst < 1e-6 * top and power < 0.0, (worst, power)
