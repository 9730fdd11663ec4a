"""libcosim, the co-simulation host of the Open Simulation Platform, with an exported FMU 2.0, beside the library itself.

Arguments: FMU, shared library, model file. Every step gets displacement and velocity at its end, as a vehicle model hands them over. The
force has to be that of `dashpot_step` with the same motion, to rounding."""
import math
import sys
from pathlib import Path

from libcosimpy.CosimEnums import CosimVariableType
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

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
    execution = CosimExecution.from_step_size(step_size=round(1e9 * STEP))  # in nanoseconds
    damper = execution.add_local_slave(CosimLocalSlave(fmu_path=fmu, instance_name="front_left"))
    reference = {v.name.decode(): v.reference for v in execution.slave_variables(damper)}
    place = [reference["displacement"], reference["velocity"]]
    for number, value in zip(place, motion(*test, 0.0)):
        execution.real_initial_value(damper, number, value)
    hand, eye = CosimManipulator.create_override(), CosimObserver.create_last_value()
    execution.add_manipulator(hand)
    execution.add_observer(eye)
    forces = []
    for k in range(STEPS):
        hand.slave_real_values(damper, place, motion(*test, (k + 1) * STEP))
        assert execution.step(), f"step {k}"
        forces.append(eye.last_real_values(damper, [reference["force"]])[0])
    return forces


for test in tests:
    ours, theirs = of_library(test), of_host(test)
    top = max(map(abs, ours))
    worst = max(abs(a - b) for a, b in zip(ours, theirs))
    print(f"{1e3 * test[0]:g} mm, {test[1]:g} Hz: largest difference {worst:.2e} N of {top:.0f} N")
    assert worst < 1e-6 * top, test
