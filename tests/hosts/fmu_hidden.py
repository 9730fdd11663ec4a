"""Compares a damper exported openly and with hidden parameters, in FMPy. Arguments: open FMU, hidden FMU, numbers of the model as texts."""
import sys
import zipfile

import numpy as np
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

shown, hidden, *numbers = sys.argv[1:]


def check(condition, text):
    if not condition:
        sys.exit(f"{hidden}: {text}")


def forces(fmu, kind):
    names = [v.name for v in read_model_description(fmu, validate=False).modelVariables if v.causality == "output" and v.unit == "N"]
    t = np.arange(0.0, 2.0, 1e-3)
    x, v = 0.03 * np.sin(6.0 * t), 0.18 * np.cos(6.0 * t)
    inputs = [v.name for v in read_model_description(fmu, validate=False).modelVariables if v.causality == "input"]
    columns = [("time", t)] + [(n, v if v_of(n) else x) for n in inputs for v_of in [is_velocity] if v_of(n) or is_travel(n)]
    signal = np.array(list(zip(*[c for _, c in columns])), dtype=[(n, float) for n, _ in columns])
    answer = simulate_fmu(fmu, fmi_type=kind, stop_time=2.0, output_interval=1e-3, step_size=1e-3, input=signal, output=names)
    return names, np.array([list(row) for row in answer])


def is_velocity(name):
    return "velocity" in name.lower() or "rate" in name.lower()


def is_travel(name):
    return "displacement" in name.lower() or "jounce" in name.lower()


check(validate_fmu(hidden) == [], validate_fmu(hidden))
for kind in ["CoSimulation", "ModelExchange"]:
    (names, a), (again, b) = forces(shown, kind), forces(hidden, kind)
    check(names == again and a.shape == b.shape and len(a) > 1900, f"{kind}: {names} {again}")
    check(np.abs(a[:, 1:]).max() > 100.0, f"{kind}: hardly any force")
    check((a == b).all(), f"{kind}: {np.abs(a - b).max()} N apart")
    print(kind, "largest force", np.abs(b[:, 1:]).max())

description = read_model_description(hidden, validate=False)
own = {"motion_scale", "force_scale", "position_offset", "displacement_given", "initial_position", "inputs_between_points"}
told = {v.name.split(".")[-1] for v in description.modelVariables if v.causality == "parameter"}
told = {n.lower().removeprefix("damper_") for n in told}
check({n for n in told if not any(n.startswith(o) for o in own)} == set(), f"parameters are told: {told}")
for fmu, there in [(shown, True), (hidden, False)]:
    with zipfile.ZipFile(fmu) as archive:
        # The kernel's sources and binaries contain names and default values, which are no secret.
        names = [n for n in archive.namelist() if not n.startswith(("sources/kernel", "sources/lib", "binaries"))]
        text = b"\n".join(archive.read(n) for n in names)
    for number in numbers:
        check((number.encode() in text) == there, f"{fmu}: {number} {'is missing' if there else 'can be read'}")
