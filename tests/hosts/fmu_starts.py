"""Tests how an FMU starts, how it uses inputs at the beginning of a step, and its messages on steps that are too long. Arguments: an FMU
exported with --inputs begin, one with --inputs end, and the longest stable step of an explicit solver, microseconds."""
import functools
import math
import shutil
import sys
from ctypes import c_double, c_size_t

import fmu_bare
from fmu_bare import ERROR, OK

begin, end = (fmu_bare.Fmu(path) for path in sys.argv[1:3])
microseconds = float(sys.argv[3])
check = begin.check
STEP = 1e-3


def started(fmu, displacement, velocity, exchange=False):
    damper = fmu_bare.Damper(fmu, fmu.resources, exchange=exchange)
    check(damper.begin() == OK, "begun")
    damper.real("displacement", displacement)
    damper.real("velocity", velocity)
    check(damper.call("ExitInitializationMode") == OK, "initialized")
    return damper


# Start in motion: the force is correct from the start, and the first steps of the same motion show no jump.
for velocity in (0.3, -0.3):
    damper = started(end, 0.01, velocity)
    first = damper.real("force")
    rest = started(end, 0.01, 0.0)
    check(abs(first - rest.real("force")) > 100.0, f"at {velocity} m/s the start has the force of rest, {first} N")
    for k in range(1, 4):
        damper.real("displacement", 0.01 + velocity * STEP * k)
        check(damper.step(STEP * (k - 1), STEP) == OK, "a step")
        jump = abs(damper.real("force") - first)
        check(jump < 0.01 * abs(first), f"at {velocity} m/s step {k} jumps by {jump} N of {first} N")
    damper.free()
    rest.free()
    # The same motion with the inputs of the beginning of each step. The first step knows no earlier velocity.
    damper = started(begin, 0.01, velocity)
    for k in range(1, 4):
        damper.real("displacement", 0.01 + velocity * STEP * (k - 1))
        check(damper.step(STEP * (k - 1), STEP) == OK, "a step")
        jump = abs(damper.real("force") - first)
        check(jump < 0.01 * abs(first), f"with the inputs of the beginning, at {velocity} m/s step {k} jumps by {jump} N of {first} N")
    damper.free()
    # Model exchange starts with the force of co-simulation.
    damper = started(end, 0.01, velocity, exchange=True)
    check(abs(damper.real("force") - first) < 1e-6 * abs(first), "model exchange starts with another force")
    damper.free()


def motion(t):
    omega = 2 * math.pi * 6.0
    return 0.015 * math.sin(omega * t), 0.015 * omega * math.cos(omega * t)


def forces(fmu, ahead):
    """Returns the forces at the ends of the steps, N, with the inputs of the time `ahead` steps after the beginning of each step."""
    damper = started(fmu, *motion(0.0))
    out = []
    for k in range(300):
        x, v = motion(STEP * (k + ahead))
        damper.real("displacement", x)
        damper.real("velocity", v)
        check(damper.step(STEP * k, STEP) == OK, "a step")
        out.append(damper.real("force"))
    damper.free()
    return out


exact = forces(end, 1)
largest = max(map(abs, exact))
off = {name: max(abs(a - b) for a, b in zip(forces(fmu, 0), exact)) / largest for name, fmu in (("begin", begin), ("end", end))}
print(f"inputs at the beginning: {100 * off['begin']:.2f} % off with --inputs begin, {100 * off['end']:.2f} % with --inputs end")
check(off["begin"] < 0.02 and off["end"] > 3 * off["begin"], f"off by {off}")

# A step of 1000 s is rejected and changes nothing.
damper = started(end, 0.01, 0.1)
before = damper.real("force")
end.said.clear()
check(damper.step(0.0, 1000.0) == ERROR, "a step of 1000 s")
check(len(end.said) == 1 and "1000 s is too long" in end.said[0] and "100 s" in end.said[0], "what it says of 1000 s")
check(damper.real("force") == before, "a rejected step has changed the force")
check(damper.step(0.0, -1e-3) == ERROR and damper.step(0.0, float("nan")) == ERROR, "steps that are none")
check(damper.step(0.0, STEP) == OK, "a step after them")
damper.free()

# An explicit solver with steps far above the limit gets a message that names the remedy.
damper = started(end, 0.0, 0.0, exchange=True)
check(damper.discrete_states() == OK and damper.call("EnterContinuousTimeMode") == OK, "continuous time")
# FMI 3.0 and FMI 2.0 count the states in the same way.
states = sum(1 for v in end.description.modelVariables if v.derivative is not None)
vector = c_double * states
x, rate = vector(), vector()


def many(name, values):
    return damper.call(name, values, c_size_t(states))


check(many("GetContinuousStates", x) == OK, "states")
end.said.clear()
status = OK
for k in range(200):
    position, velocity = motion(STEP * k)
    check(damper.call("SetTime", c_double(STEP * k)) == OK, "time")
    damper.real("displacement", position)
    damper.real("velocity", velocity)
    status = many("SetContinuousStates", x)
    if status == OK:
        status = many("GetContinuousStateDerivatives" if end.three else "GetDerivatives", rate)
    if status != OK:
        break
    for i in range(states):
        x[i] += STEP * rate[i]
check(status == ERROR, "an explicit Euler of 1 ms ran on")
check(any("implicit solver" in text and f"below {microseconds:.2g} microseconds" in text for text in end.said), "what it says of the solver")
end.said.clear()
for i in range(states):
    x[i] = float("nan")
check(many("SetContinuousStates", x) == ERROR and any("implicit solver" in text for text in end.said), "states that are none")
damper.free()

for fmu in (begin, end):
    shutil.rmtree(fmu.folder)
