"""Ecos, a co-simulation host of its own FMI library, with an exported FMU of either version, beside the library itself.

Arguments: FMU, shared library, model file. Every step gets displacement and velocity at its end. The force has to be that of
`dashpot_step` with the same motion, to rounding."""
import ctypes
import math
import sys
from pathlib import Path

# Its wheel needs this library of Intel's and does not bring it; a system may have another.
ctypes.CDLL(str(Path(sys.prefix) / "lib" / "libtbb.so.12"), mode=ctypes.RTLD_GLOBAL)
from ecospy import EcosSimulation, EcosSimulationStructure  # noqa: E402

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))
from dashpot_damper import Damper  # noqa: E402

fmu, library, model_file = sys.argv[1:4]
STEP, STEPS = 1e-3, 1500
tests = [(0.05, 0.3), (0.03, 5.6), (0.005, 20.0)]


def motion(amplitude, frequency, t):
    w = 2 * math.pi * frequency
    return [-amplitude * math.cos(w * t), amplitude * w * math.sin(w * t)]


def of_library(test):
    damper = Damper(library, model_file, motion(*test, 0.0)[0])
    return [damper.step(*motion(*test, (k + 1) * STEP), STEP) for k in range(STEPS)]


def of_host(test):
    structure = EcosSimulationStructure()
    structure.add_model("front_left", fmu)
    names = ["front_left::displacement", "front_left::velocity"]
    structure.add_parameter_set("start", dict(zip(names, motion(*test, 0.0))))
    forces = []
    with EcosSimulation(structure=structure, step_size=STEP) as host:
        host.init(parameter_set="start")
        for k in range(STEPS):
            for name, value in zip(names, motion(*test, (k + 1) * STEP)):
                host.set_real(name, value)
            host.step(1)
            forces.append(host.get_real("front_left::force"))
        host.terminate()
    return forces


for test in tests:
    ours, theirs = of_library(test), of_host(test)
    top = max(map(abs, ours))
    worst = max(abs(a - b) for a, b in zip(ours, theirs))
    print(f"{1e3 * test[0]:g} mm, {test[1]:g} Hz: largest difference {worst:.2e} N of {top:.0f} N")
    assert worst < 1e-9 * top, test
