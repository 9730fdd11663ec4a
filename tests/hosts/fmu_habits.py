"""Runs an FMU like importers that violate the standard. Argument: an FMU with one corner, of either version.

Stock importers behave so: QTronic's FMU SDK names a resources folder that does not exist, and others name none. Some free the structure
with their logger after instantiation. Many free an instance without terminating it."""
import functools
import math
import shutil
import sys
from ctypes import c_double

import fmu_bare
from fmu_bare import ERROR, OK

fmu = fmu_bare.Fmu(sys.argv[1])
description, folder, path, right, said, check = fmu.description, fmu.folder, fmu.library, fmu.resources, fmu.said, fmu.check
Damper = functools.partial(fmu_bare.Damper, fmu)


def run(damper):
    """Returns the force, N, after ten steps of an increasing motion."""
    check(damper.begin() == OK and damper.call("ExitInitializationMode") == OK, "begun")
    for k in range(10):
        damper.real("displacement", 0.001 * k)
        damper.real("velocity", 0.1 * k)
        check(damper.step(1e-3 * k, 1e-3) == OK, "a step")
    return damper.real("force")


damper = Damper(right)
wanted = run(damper)
check(abs(wanted) > 100.0, f"a force: {wanted}")
# Free an instance that runs, and a null pointer.
damper.free()
damper.instance = None
damper.free()

# Many importers set no start values that their user did not specify. The instance must start with the values of its description.
for exchange in (False, True):
    damper = Damper(right, exchange=exchange)
    check(damper.begin() == OK, "begun")
    started = [v for v in description.modelVariables if v.start is not None and v.type in ("Real", "Float64")]
    for variable in started:
        page, own = float(variable.start), damper.real(variable.name)
        check(abs(page - own) <= 1e-12 * abs(page), f"{variable.name} starts at {own}, where the page says {page}")
    check(len(started) > 40, "start values")
    damper.free()

# Resources: no folder, an empty name, a missing folder, and that of the FMU SDK, a relative path written as an absolute one.
for resources in [None, b"", b"file:///", b"file:///nowhere/resources", b"file:///fmuTmp/resources/", b"/nowhere"]:
    damper = Damper(resources)
    check(damper.instance, f"resources {resources}")
    check(run(damper) == wanted, f"resources {resources}: another force")
    damper.free()

# If the library is not in an FMU, there is no model, and a message states the reason.
alone = folder.parent / f"{folder.name}-alone"
alone.mkdir()
shutil.copy(path, alone / path.name)
said.clear()
check(not Damper(b"file:///nowhere", alone / path.name).instance, "a library without its FMU made an instance")
check(any("nowhere" in text for text in said), "it does not say what it lacks")
shutil.rmtree(alone)

# The logger must still work after the structure with it was overwritten.
damper = Damper(right)
said.clear()
check(damper.step(0.0, 1e-3) == ERROR and len(said) == 1, "a step before the initialization")
# Initialization at an invalid time and a second initialization are errors. After every reset, the run is that of a new instance.
check(damper.begin(float("nan")) == ERROR, "a start that is no time")
for _ in range(3):
    check(damper.call("Reset") == OK and run(damper) == wanted, "after a reset")
    check(damper.begin() == ERROR, "begun while it runs")
    # The rejected second initialization has not changed the force.
    check(damper.real("force") == wanted, "refused, and the force is another")
# Any number of steps of zero length is allowed.
still = [damper.real("force") for _ in range(5) if damper.step(0.01, 0.0) == OK]
check(len(still) == 5 and len(set(still)) == 1, f"steps of no length: {still}")
check(damper.step(0.01, 1e-3) == OK and damper.call("Terminate") == OK, "on and to the end")
damper.free()

# Calls of the other kind are rejected with a message.
damper = Damper(right, exchange=True)
check(damper.begin() == OK and damper.call("ExitInitializationMode") == OK, "model exchange")
said.clear()
check(damper.step(0.0, 1e-3) == ERROR and "model exchange" in said[0], "a step in model exchange")
damper.free()

# fmusim sets the inputs in every stage of its solver. The solver steps beyond the output times, and then goes back to them with the states
# alone. The velocity at such a time must be interpolated. It is observed through the rate of a state, here v = -der(deflection).
damper = Damper(right, exchange=True)
check(damper.begin() == OK and damper.call("ExitInitializationMode") == OK, "model exchange")
check(damper.discrete_states() == OK, "discrete states")
check(damper.call("EnterContinuousTimeMode") == OK, "continuous time")
AMPLITUDE, OMEGA, STEP = 0.03, 2 * math.pi * 5.6, 4e-3
SCALE = damper.real("motion_scale")
for k in range(6):
    t = STEP * k
    check(damper.call("SetTime", c_double(t)) == OK, "time")
    damper.real("displacement", -AMPLITUDE * math.cos(OMEGA * t) / SCALE)
    damper.real("velocity", AMPLITUDE * OMEGA * math.sin(OMEGA * t) / SCALE)
    check(abs(damper.real("der(deflection)") + AMPLITUDE * OMEGA * math.sin(OMEGA * t)) < 1e-12, "the velocity that was set")
for back in [0.5e-3, 2e-3, 3.9e-3]:
    check(damper.call("SetTime", c_double(t - back)) == OK, "time")
    off = abs(damper.real("der(deflection)") + AMPLITUDE * OMEGA * math.sin(OMEGA * (t - back)))
    # With a constant velocity the error would be up to 11 % of the largest velocity. With linear interpolation it is 0.1 % at most.
    check(off < 5e-4 * AMPLITUDE * OMEGA, f"{1e3 * back} ms back: off by {100 * off / (AMPLITUDE * OMEGA):.3f} %")
damper.free()

shutil.rmtree(folder)
