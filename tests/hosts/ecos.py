"""Runs an exported FMU of either version in Ecos, a co-simulation host with its own FMI library: see beside_library.py."""
import ctypes
import sys
from pathlib import Path

from beside_library import STEP, STEPS, compare, fmu
from sine import motion

# The wheel of Ecos needs this library of Intel's and does not contain it; the system's version may differ.
ctypes.CDLL(str(Path(sys.prefix) / "lib" / "libtbb.so.12"), mode=ctypes.RTLD_GLOBAL)
from ecospy import EcosSimulation, EcosSimulationStructure  # noqa: E402


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


compare(of_host, 1e-9)
