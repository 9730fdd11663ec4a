"""Tests one damper FMU with FMPy. Arguments: FMU, trace of the bridge (lines with jounce, rate and force of each corner) [, "quick"]."""
import ctypes
import math
import shutil
import sys

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu

DT = 1e-3


def check(condition, text):
    if not condition:
        sys.exit(f"{sys.argv[1]}: {text}")


class Damper:
    """An instance of either FMI version and either kind, with common calls."""

    def __init__(self, name, exchange=False):
        self.three = description.fmiVersion.startswith("3")
        self.exchange = exchange
        face = description.modelExchange if exchange else description.coSimulation
        kinds = {(False, False): FMU2Slave, (False, True): FMU2Model, (True, False): FMU3Slave, (True, True): FMU3Model}
        self.fmu = kinds[self.three, exchange](
            guid=description.guid, unzipDirectory=folder, modelIdentifier=face.modelIdentifier, instanceName=name)
        self.fmu.instantiate()

    def get(self, names):
        vr = [references[n] for n in names]
        return list(self.fmu.getFloat64(vr) if self.three else self.fmu.getReal(vr))

    def set(self, names, values):
        vr = [references[n] for n in names]
        (self.fmu.setFloat64 if self.three else self.fmu.setReal)(vr, list(values))

    def boolean(self, name, value):
        self.fmu.setBoolean([references[name]], [value])

    def begin(self):
        if not self.three:
            self.fmu.setupExperiment(startTime=0.0)
            self.fmu.enterInitializationMode()
        else:
            self.fmu.enterInitializationMode(startTime=0.0)

    def run(self):
        self.fmu.exitInitializationMode()
        if self.exchange:
            if self.three:
                self.fmu.updateDiscreteStates()
            else:
                self.fmu.newDiscreteStates()
            self.fmu.enterContinuousTimeMode()

    def step(self, t, h=DT):
        self.fmu.doStep(t, h)

    def derivative(self, unknown, known):
        vu, vk = [references[unknown]], [references[known]]
        return (self.fmu.getDirectionalDerivative(vu, vk, [1.0]))[0]

    def save(self):
        return self.fmu.getFMUState() if self.three else self.fmu.getFMUstate()

    def restore(self, state):
        (self.fmu.setFMUState if self.three else self.fmu.setFMUstate)(state)

    def free_state(self, state):
        (self.fmu.freeFMUState if self.three else self.fmu.freeFMUstate)(state)

    def serialized(self, state):
        return self.fmu.serializeFMUState(state) if self.three else self.fmu.serializeFMUstate(state)

    def deserialized(self, data):
        return self.fmu.deserializeFMUState(data) if self.three else self.fmu.deSerializeFMUstate(data)

    def states(self):
        n = self.count()
        x = (ctypes.c_double * n)()
        self.fmu.getContinuousStates(x, n)
        return list(x)

    def set_states(self, x):
        n = self.count()
        self.fmu.setContinuousStates((ctypes.c_double * n)(*x), n)

    def rates(self):
        n = self.count()
        x = (ctypes.c_double * n)()
        (self.fmu.getContinuousStateDerivatives if self.three else self.fmu.getDerivatives)(x, n)
        return list(x)

    def count(self):
        return description.numberOfContinuousStates

    def end(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


def drive(damper, rows, start=1):
    forces = []
    for k in range(start, len(rows)):
        damper.set(inputs, motion(rows[k]))
        damper.step((k - 1) * DT)
        forces.append(damper.get(outputs))
    return forces


def motion(row):
    # The motion of a single damper is positive in extension, that of the bridge without a map in compression.
    sign = 1.0 if four else -1.0
    return [sign * value for corner in row for value in corner[:2]]


def standing(row):
    """Returns the inputs for rest at the displacement of a row of the trace, where the bridge begins."""
    return [0.0 if i % 2 else value for i, value in enumerate(motion(row))]


def expected(row):
    return [(1.0 if four else -1.0) * corner[2] for corner in row]


def bit_for_bit_the_bridge():
    damper = Damper("bridge")
    # Set start values before the initialization mode, as some hosts do.
    damper.set(inputs, standing(trace[0]))
    damper.begin()
    damper.run()
    check(damper.get(outputs) == expected(trace[0]), "static force")
    for k, got in enumerate(drive(damper, trace), 1):
        check(got == expected(trace[k]), f"step {k}: {got} is not the bridge's {expected(trace[k])}")
    damper.end()


def instances_reset_and_states():
    one, two = Damper("one"), Damper("two")
    for damper in (one, two):
        damper.set(inputs, standing(trace[0]))
        damper.begin()
        damper.run()
    first = drive(one, trace[:300])
    # The second instance has made no step while the first one ran.
    check(drive(two, trace[:300]) == first, "instances disturb each other")
    state = one.save()
    data = one.serialized(state)
    ahead = drive(one, trace[:600], 300)
    one.restore(state)
    check(drive(one, trace[:600], 300) == ahead, "a restored state runs differently")
    other = two.deserialized(data)
    drive(two, trace[:500], 300)
    two.restore(other)
    check(drive(two, trace[:600], 300) == ahead, "a deserialized state runs differently")
    check(two.serialized(other) == data, "serialized twice is not the same")
    one.free_state(state)
    two.free_state(other)
    one.fmu.reset()
    one.set(inputs, standing(trace[0]))
    one.begin()
    one.run()
    check(drive(one, trace[:300]) == first, "a reset instance runs differently")
    one.end()
    two.end()


def steps_of_any_length():
    lengths = [1e-3, 2.5e-4, 2e-3, 7e-4, 5e-4]
    w, amplitude = 2 * math.pi * 2.0, 0.02
    forces = []
    for cut in (1, 8):
        damper = Damper("lengths")
        damper.begin()
        damper.run()
        t, forces_here = 0.0, []
        for k in range(300):
            h = lengths[k % len(lengths)]
            for _ in range(cut):
                damper_time = t
                t += h / cut
                damper.set(inputs, [amplitude * math.sin(w * t), amplitude * w * math.cos(w * t)] * len(outputs))
                damper.step(damper_time, h / cut)
            forces_here.append(damper.get(outputs)[0])
        forces.append(forces_here)
        damper.end()
    peak = max(map(abs, forces[1]))
    # The motion begins with a jump of the velocity, to which steps of different lengths respond differently.
    worst = max(abs(a - b) for a, b in zip(forces[0][20:], forces[1][20:]))
    check(worst < 2e-3 * peak, f"steps of different lengths: {worst} of {peak}")


def a_held_force():
    damper = Damper("held")
    damper.set(inputs, standing(trace[0]))
    damper.begin()
    damper.run()
    before = drive(damper, trace[:100])[-1]
    damper.set(inputs[:2], [math.nan, 0.1])
    damper.step(0.1)
    after = damper.get(outputs)
    check(after[0] == before[0], "an input that is not finite moves the force")
    status = references["Damper_Status_L1" if four else "status"]
    got = damper.fmu.getInt32([status]) if damper.three else damper.fmu.getInteger([status])
    check(got[0] == 65536, f"status {got}")
    damper.end()


def parameters_act():
    name = ("L1." if four else "") + "gas_force"
    damper = Damper("tuned")
    damper.begin()
    damper.run()
    still = [0.0] * len(inputs)
    damper.set(inputs, still)
    damper.step(0.0)
    before = damper.get(outputs)
    damper.set([name], [341.5])
    damper.step(DT)
    after = damper.get(outputs)
    check(abs(abs(after[0] - before[0]) - 200.0) < 1e-6, f"gas force: {before} {after}")
    check(after[1:] == before[1:], "another corner was tuned")
    # An invalid gas force is rejected at once, and the parameter keeps its last valid value.
    for wrong in (math.nan, 1e12):
        refused(lambda: damper.set([name], [wrong]), f"gas force {wrong}")
    damper.set(inputs, still)
    damper.step(2 * DT)
    check(damper.get(outputs) == after, "a refused parameter acts")
    damper.end()


def refused(call, what):
    try:
        call()
    except Exception:
        return
    check(False, f"{what}: accepted")


def calls_in_the_wrong_order_are_refused():
    for prepare in (lambda d: None, lambda d: d.begin()):
        damper = Damper("order")
        prepare(damper)
        refused(lambda: damper.step(0.0), "a step before initialization has ended")
        refused(damper.fmu.terminate, "terminate before initialization has ended")
        damper.fmu.freeInstance()


def the_zero_of_the_rig():
    """Checks that the parameter position_offset, m, gives the forces of a displacement that is larger by the same length."""
    prefix, sign, offset = ("L1.", -1.0, -0.012) if four else ("", 1.0, -0.012)
    forces = []
    for own in (0.0, offset):
        damper = Damper("zero")
        damper.set([prefix + "position_offset"], [own])
        refused(lambda: damper.set([prefix + "position_offset"], [12.0]), "an offset in mm")
        def rows(k):
            first = [sign * (0.02 * math.sin(0.03 * k) + offset - own), sign * 0.6 * math.cos(0.03 * k)]
            return first + [0.0] * (len(inputs) - 2)
        damper.set(inputs, rows(0))
        damper.begin()
        damper.run()
        got = [damper.get(outputs)[0]]
        for k in range(1, 200):
            damper.set(inputs, rows(k))
            damper.step((k - 1) * DT)
            got.append(damper.get(outputs)[0])
        damper.end()
        forces.append(got)
    # The forces differ by rounding only, because the offset is added in another order.
    apart = max(abs(a - b) for a, b in zip(*forces))
    check(apart < 1e-6, f"position_offset: {apart} N apart")


def inputs_between_points():
    """Checks an importer that sets the inputs known at the beginning of a step, as the standard says: 10 mm, 3 Hz, steps of 1 ms. The delay
    of the force is the shift of the correct force that fits best."""
    w, amplitude = 2 * math.pi * 3.0, 0.01
    sign = -1.0 if four else 1.0

    def rows(t):
        return [sign * -amplitude * math.cos(w * t), sign * amplitude * w * math.sin(w * t)] * len(outputs)

    def forces(choice, derivatives=False, ahead=0.0, cut=1):
        damper = Damper("between")
        if damper.three:
            damper.fmu.setInt64([references["inputs_between_points"]], [choice])
        else:
            damper.fmu.setInteger([references["inputs_between_points"]], [choice])
        damper.set(inputs, rows(0.0))
        damper.begin()
        damper.run()
        got = []
        for k in range(1000 * cut):
            t, h = k * DT / cut, DT / cut
            damper.set(inputs, rows(t + ahead * h))
            if derivatives:
                slope = [sign * amplitude * w * math.sin(w * t), sign * amplitude * w * w * math.cos(w * t)] * len(outputs)
                vr = (ctypes.c_uint32 * len(inputs))(*(references[n] for n in inputs))
                damper.fmu.fmi2SetRealInputDerivatives(
                    damper.fmu.component, vr, len(inputs), (ctypes.c_int * len(inputs))(*[1] * len(inputs)),
                    (ctypes.c_double * len(inputs))(*slope))
            damper.step(t, h)
            if (k + 1) % cut == 0:
                got.append(damper.get(outputs)[0])
        damper.end()
        return got

    fine = forces(1, ahead=1.0, cut=20)
    peak = max(map(abs, fine))

    def told(name, got):
        worst = max(abs(a - b) for a, b in zip(got[5:], fine[5:]))

        def off(delay):
            # The correct force, delayed by `delay` steps, with linear interpolation between the steps.
            whole, part = math.floor(delay), delay - math.floor(delay)
            late = [(1 - part) * fine[i - whole] + part * fine[i - whole - 1] for i in range(10, len(fine) - 2)]
            return sum((a - b) ** 2 for a, b in zip(got[10:-2], late))

        delay = min((off(d / 50), d / 50) for d in range(-50, 101))[1]
        print(f"{name}: {worst:.1f} N of {peak:.0f} N off at most, {delay:.2f} steps late")
        return worst / peak, delay

    hold, late = told("hold", forces(1))
    run_on, in_time = told("extrapolate", forces(2))
    check(hold > 0.05 and abs(late - 1.0) < 0.1, "held inputs are one step late")
    check(run_on < 0.01 and abs(in_time) < 0.1, "extrapolated inputs are in time")
    automatic, _ = told("automatic", forces(0))
    check(automatic == hold, "automatic is hold in co-simulation")
    if not description.fmiVersion.startswith("3"):
        check(description.coSimulation.canInterpolateInputs, "canInterpolateInputs")
        given, in_time = told("derivatives", forces(1, derivatives=True))
        check(given < 0.01 and abs(in_time) < 0.1, "input derivatives are in time")


def solve(rows_of, seconds, h):
    """Returns the forces of a model exchange, N, by the classical Runge-Kutta method with small steps, as an independent solver."""
    damper = Damper("exchange", True)
    damper.set(inputs, rows_of(0.0))
    damper.begin()
    damper.run()
    x = damper.states()
    forces = []

    def rate(t, x):
        damper.fmu.setTime(t)
        damper.set(inputs, rows_of(t))
        damper.set_states(x)
        return damper.rates()

    n = round(seconds / h)
    for k in range(n):
        t = k * h
        k1 = rate(t, x)
        k2 = rate(t + h / 2, [a + h / 2 * b for a, b in zip(x, k1)])
        k3 = rate(t + h / 2, [a + h / 2 * b for a, b in zip(x, k2)])
        k4 = rate(t + h, [a + h * b for a, b in zip(x, k3)])
        x = [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(x, k1, k2, k3, k4)]
        if (k + 1) % round(DT / h) == 0:
            rate(t + h, x)
            forces.append(damper.get(outputs))
    damper.end()
    return forces


def what_is_fixed_stays():
    prefix = "L1." if four else ""
    damper = Damper("fixed")
    # Before the run, all parameters can be set, also those that are fixed in the run.
    damper.set([prefix + "motion_scale"], [-1.0 if four else 1.0])
    damper.begin()
    damper.run()
    for name in ("motion_scale", "force_scale", "initial_position", "position_offset"):
        before = damper.get([prefix + name])
        try:
            damper.set([prefix + name], [0.5])
            check(False, f"{name} is fixed and was changed in a run")
        except Exception:
            check(damper.get([prefix + name]) == before, f"{name} was refused and has changed")
    damper.end()


def exchange_is_the_same_damper():
    """Compares both kinds on tests along the edges of the rig matrix. The motion is a raised cosine, whose stroke is twice the amplitude."""
    for amplitude, frequency in [
            (0.05, 0.3), (0.05, 3.3), (0.03, 5.6), (0.015, 3.0), (0.005, 20.0), (0.002, 12.0), (0.001, 2.0), (0.001, 20.0)]:
        w = 2 * math.pi * frequency
        # A raised cosine begins at rest.
        def rows_of(t):
            return [amplitude * (1 - math.cos(w * t)), amplitude * w * math.sin(w * t)] * len(outputs)
        seconds = min(0.5, 1.0 / frequency)
        exchange = solve(rows_of, seconds, 1e-4)
        damper = Damper("co")
        damper.set(inputs, rows_of(0.0))
        damper.begin()
        damper.run()
        co = []
        for k in range(len(exchange)):
            damper.set(inputs, rows_of((k + 1) * DT))
            damper.step(k * DT)
            co.append(damper.get(outputs))
        damper.end()
        peak = max(abs(f[0]) for f in exchange)
        apart = [a - b for p, q in zip(co, exchange) for a, b in zip(p, q)]
        worst, rms = max(map(abs, apart)), math.sqrt(sum(e * e for e in apart) / len(apart))
        print(f"{1e3 * amplitude:g} mm {frequency:g} Hz: {100 * rms / peak:.4f} % rms, {100 * worst / peak:.4f} % at most, of {peak:.0f} N")
        # The errors are the differences of co-simulation and model exchange. The acceleration jumps at the start, so the largest one may be 0.2 %.
        check(rms < 1e-3 * peak and worst < 2e-3 * peak, f"{amplitude} m {frequency} Hz: {rms} N rms, {worst} N of {peak} N")


def differences(unknowns, knowns, at, derivative, relative):
    """Compares derivatives with central differences of a function of the knowns, with several step sizes."""
    for known in knowns:
        for unknown in unknowns:
            got = derivative(unknown, known)
            for by in (1e-5, 1e-6, 1e-7):
                wanted = (at(known, by)[unknown] - at(known, -by)[unknown]) / (2 * by)
                if abs(got - wanted) <= relative * max(abs(wanted), 1.0):
                    break
            else:
                check(False, f"d({unknown})/d({known}) = {got}, by difference {wanted}")


def derivatives_of_exchange():
    damper = Damper("partials", True)
    damper.set(inputs, standing(trace[0]))
    damper.begin()
    damper.run()
    prefix = "L1." if four else ""
    states = [prefix + s for s in ("deflection", "mass_velocity")]
    rates = [f"der({s})" for s in states]
    x = damper.states()
    values = [0.01, 0.21] * len(outputs)
    place = {prefix + "deflection": 1, prefix + "mass_velocity": 2}
    x[1], x[2] = (0.0001, 0.2) if not four else (-0.0001, -0.2)

    def at(known, by):
        moved_x, moved_u = list(x), list(values)
        if known in place:
            moved_x[place[known]] += by
        else:
            moved_u[inputs.index(known)] += by
        damper.set(inputs, moved_u)
        damper.set_states(moved_x)
        got = dict(zip(outputs + rates, damper.get(outputs + rates)))
        damper.set(inputs, values)
        damper.set_states(x)
        return got

    at(inputs[0], 0.0)
    differences([outputs[0]] + rates, inputs[:2] + states, at, damper.derivative, 1e-4)
    # The FMU differentiates by the side force with differences. The expected value is the coefficient of the model times a smooth sign.
    side = "Damper_Side_Force_L1" if four else "side_force"
    damper.set([side], [100.0])
    got = damper.derivative(outputs[0], side)
    check(abs(abs(got) - 0.05) < 1e-3, f"side force {got}")
    if four:
        check(damper.derivative(outputs[1], inputs[0]) == 0.0, "corners are not coupled")
    damper.end()


def derivatives_of_steps():
    damper = Damper("step partials")
    damper.set(inputs, standing(trace[0]))
    damper.begin()
    damper.run()
    drive(damper, trace[:150])
    before = damper.save()
    values = motion(trace[150])

    def at(known, by):
        moved = list(values)
        moved[inputs.index(known)] += by
        damper.restore(before)
        damper.set(inputs, moved)
        damper.step(0.149)
        return dict(zip(outputs, damper.get(outputs)))

    def derivative(unknown, known):
        at(known, 0.0)
        return damper.derivative(unknown, known)

    differences([outputs[0]], inputs[:2], at, derivative, 1e-3)
    slope = "Damper_Force_by_Jounce_Rate_L1" if four else "d_force_d_velocity"
    at(inputs[0], 0.0)
    check(damper.get([slope])[0] == derivative(outputs[0], inputs[1]), "the slope output is the derivative")
    damper.free_state(before)
    damper.end()


def velocity_alone():
    """Checks that a displacement that is not given is integrated from the initial position."""
    prefixes = [f"{c}." for c in ("L1", "R1", "L2", "R2")] if four else [""]
    damper = Damper("velocity")
    for p in prefixes:
        damper.boolean(p + "displacement_given", False)
        damper.set([p + "initial_position"], [-0.02])
    damper.begin()
    damper.run()
    for k in range(100):
        damper.set(inputs, [1e9 if k % 2 else 0.0, 0.1] * len(outputs))
        damper.step(k * DT)
    travel = damper.get([p + "travel" for p in prefixes])
    scale = -1.0 if four else 1.0
    for x in travel:
        # The first step accelerates from rest to 0.1 m/s, so the travel is half a step shorter than 100 steps at 0.1 m/s.
        check(abs(x - (-0.02 + scale * 0.1 * 99.5 * DT)) < 1e-9, f"travel {travel}")
    damper.end()


path = sys.argv[1]
problems = validate_fmu(path)
check(not problems, "\n".join(problems))
description = read_model_description(path, validate=False)
folder = extract(path)
references = {v.name: v.valueReference for v in description.modelVariables}
four = "Damper_Force_L1" in references
if four:
    corners = ["L1", "R1", "L2", "R2"]
    inputs = [n + c for c in corners for n in ("Damper_Jounce_", "Damper_Jounce_Rate_")]
    outputs = [f"Damper_Force_{c}" for c in corners]
else:
    inputs, outputs = ["displacement", "velocity"], ["force"]
with open(sys.argv[2]) as file:
    numbers = [list(map(float, line.split())) for line in file]
trace = [[row[i : i + 3] for i in range(0, len(row), 3)] for row in numbers]

try:
    bit_for_bit_the_bridge()
    if "quick" in sys.argv[3:]:
        sys.exit(0)
    instances_reset_and_states()
    steps_of_any_length()
    a_held_force()
    parameters_act()
    what_is_fixed_stays()
    exchange_is_the_same_damper()
    derivatives_of_exchange()
    derivatives_of_steps()
    velocity_alone()
    calls_in_the_wrong_order_are_refused()
    the_zero_of_the_rig()
    inputs_between_points()
finally:
    shutil.rmtree(folder, ignore_errors=True)
