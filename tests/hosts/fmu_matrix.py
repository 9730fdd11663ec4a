"""Runs sines through one damper FMU in FMPy, in both kinds. Arguments: FMU, tests (lines of amplitude, m, frequency, Hz, number of steps of
1 ms), solver (shared library of exchange_loop.c), output file. The file has the forces of co-simulation and of model exchange for each test.

FMPy's own solvers for model exchange keep the inputs constant within each step. A displacement that is 20 us late at 0.6 m/s gives an error
of 36 N on a series spring of 3 MN/m. Therefore FMPy only makes, initializes and ends the instance. A solver that sets the inputs in every
stage runs it."""
import ctypes
import math
import shutil
import sys
from array import array

from fmpy import extract, read_model_description
from fmu_instance import begun

DT = 1e-3
PARTS = 8
TAU = 2 * math.pi

path, tests, solver, out = sys.argv[1:5]
description = read_model_description(path, validate=False)
folder = extract(path)
references = {v.name: v.valueReference for v in description.modelVariables}
three = description.fmiVersion.startswith("3")
four = "Damper_Force_L1" in references
names = ["L1", "R1", "L2", "R2"]
corners = 4 if four else 1
sign = -1.0 if four else 1.0
inputs = [references[n + c] for c in names for n in ("Damper_Jounce_", "Damper_Jounce_Rate_")] if four else [
    references["displacement"], references["velocity"]]
outputs = [references["Damper_Force_" + c] for c in names] if four else [references["force"]]
with open(tests) as file:
    sines = [(float(a), float(f), int(n)) for a, f, n in map(str.split, file)]
# Each corner runs another test; the longest test of a group determines the number of steps.
groups = [sines[i : i + corners] for i in range(0, len(sines), corners)]


def motion(sine, t):
    amplitude, frequency, _ = sine
    w = TAU * frequency
    return sign * -amplitude * math.cos(w * t), sign * amplitude * w * math.sin(w * t)


def begin(exchange, group):
    values = [v for sine in group for v in motion(sine, 0.0)]
    return begun(
        description, folder, exchange, lambda fmu: (fmu.setFloat64 if three else fmu.setReal)(inputs, values))


def end(fmu):
    fmu.terminate()
    fmu.freeInstance()


def simulated(group):
    """Returns the forces of all corners, N, at each step of a co-simulation."""
    fmu = begin(False, group)
    get, put = (fmu.getFloat64, fmu.setFloat64) if three else (fmu.getReal, fmu.setReal)
    forces = [[sign * f for f in get(outputs)]]
    for k in range(max(n for _, _, n in group)):
        put(inputs, [v for sine in group for v in motion(sine, (k + 1) * DT)])
        fmu.doStep(k * DT, DT)
        forces.append([sign * f for f in get(outputs)])
    end(fmu)
    return forces


class Face(ctypes.Structure):
    _fields_ = [(n, ctypes.c_void_p) for n in ("component", "set_time", "set_states", "get_states", "get_rates", "set", "get")]


class Run(ctypes.Structure):
    _fields_ = [(n, ctypes.c_int32) for n in ("three", "corners", "states", "steps", "parts")] + [
        (n, ctypes.c_double) for n in ("dt", "sign")] + [
        (n, ctypes.c_void_p) for n in ("inputs", "outputs", "amplitude", "frequency", "forces")]


def exchanged(group):
    fmu = begin(True, group)
    calls = (["fmi3SetTime", "fmi3SetContinuousStates", "fmi3GetContinuousStates", "fmi3GetContinuousStateDerivatives",
              "fmi3SetFloat64", "fmi3GetFloat64"] if three else
             ["fmi2SetTime", "fmi2SetContinuousStates", "fmi2GetContinuousStates", "fmi2GetDerivatives", "fmi2SetReal",
              "fmi2GetReal"])
    face = Face(fmu.component, *(ctypes.cast(getattr(fmu.dll, c), ctypes.c_void_p) for c in calls))
    steps = max(n for _, _, n in group)
    vr, to = (ctypes.c_uint32 * len(inputs))(*inputs), (ctypes.c_uint32 * len(outputs))(*outputs)
    amplitude = (ctypes.c_double * corners)(*(a for a, _, _ in group))
    frequency = (ctypes.c_double * corners)(*(f for _, f, _ in group))
    forces = (ctypes.c_double * (corners * (steps + 1)))()
    run = Run(three, corners, description.numberOfContinuousStates, steps, PARTS, DT, sign,
              *(ctypes.cast(a, ctypes.c_void_p) for a in (vr, to, amplitude, frequency, forces)))
    if ctypes.CDLL(solver).exchange(ctypes.byref(face), ctypes.byref(run)):
        sys.exit(f"{path}: a call of the model exchange has failed")
    end(fmu)
    return [forces[corners * k : corners * (k + 1)] for k in range(steps + 1)]


try:
    with open(out, "wb") as file:
        for group in groups:
            # In a group with fewer tests than corners, the other corners run the first test.
            full = group + [group[0]] * (corners - len(group))
            both = [simulated(full), exchanged(full)]
            for i, (_, _, n) in enumerate(group):
                for forces in both:
                    array("d", (row[i] for row in forces[: n + 1])).tofile(file)
finally:
    shutil.rmtree(folder, ignore_errors=True)
