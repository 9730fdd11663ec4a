"""Compares directional derivatives of a vehicle's FMU, whose four dampers have elements with internal states, with differences.
Argument: FMU. Prints for each corner how many internal states moved."""
import ctypes
import math
import shutil
import sys

from fmpy import extract, read_model_description
from fmu_instance import begun

DT = 1e-3
CORNERS = ["L1", "R1", "L2", "R2"]

path = sys.argv[1]
description = read_model_description(path, validate=False)
folder = extract(path)
reference = {v.name: v.valueReference for v in description.modelVariables}
three = description.fmiVersion.startswith("3")
inputs = [f"{n}_{c}" for c in CORNERS for n in ("Damper_Jounce", "Damper_Jounce_Rate")]
forces = [f"Damper_Force_{c}" for c in CORNERS]
state_names = [v.derivative.name for v in description.modelVariables if v.derivative is not None]
rate_names = [v.name for v in description.modelVariables if v.derivative is not None]
worst = 0.0


def get(fmu, names):
    return list((fmu.getFloat64 if three else fmu.getReal)([reference[n] for n in names]))


def put(fmu, names, values):
    (fmu.setFloat64 if three else fmu.setReal)([reference[n] for n in names], list(values))


def derivative(fmu, unknown, known):
    return fmu.getDirectionalDerivative([reference[unknown]], [reference[known]], [1.0])[0]


def motion(t):
    values = []
    for i, hertz in enumerate((1.7, 3.1, 6.3, 11.0)):
        w = 2 * math.pi * hertz
        a = 0.6 / w
        # The slow sine of 4 mm makes each stroke different from the preceding ones.
        values += [a * math.sin(w * t) + 0.004 * math.sin(2.1 * t),
                   a * w * math.cos(w * t) + 0.004 * 2.1 * math.cos(2.1 * t)]
    return values


def compare(what, got, at, size):
    """Compares a derivative with central differences. At a knee, it must be between the differences of both sides (step.md, "Which derivative").

    The step of the differences is the one that fits best; `size` is the magnitude of the known variable."""
    global worst
    best = None
    here = at(0.0)
    for by in (1e-4, 1e-5, 1e-6, 1e-7):
        up, down = at(by * size), at(-by * size)
        wanted = (up - down) / (2 * by * size)
        sides = sorted(((up - here) / (by * size), (here - down) / (by * size)))
        # Bound of the rounding error of a difference quotient.
        noise = 1e-9 * (1.0 + abs(up)) / (by * size) * 1e-3
        off = 0.0 if sides[0] <= got <= sides[1] else min(abs(got - side) for side in (*sides, wanted))
        miss = max(0.0, off - noise) / max(abs(wanted), abs(got), 1e-3 / size)
        if best is None or miss < best[0]:
            best = (miss, wanted)
        if miss < 1e-4:
            break
    worst = max(worst, best[0])
    if best[0] > 1e-3:
        sys.exit(f"{path}: d({what}) = {got}, by difference {best[1]}")


try:
    co, exchange = begun(description, folder, False), begun(description, folder, True)
    points = []
    for k in range(1, 400):
        put(co, inputs, motion(k * DT))
        if k in (77, 160, 331, 399):
            before = co.getFMUState() if three else co.getFMUstate()
        co.doStep((k - 1) * DT, DT)
        if k in (77, 160, 331, 399):
            points.append((k, before, get(co, state_names)))
    after = co.getFMUState() if three else co.getFMUstate()
    moved = {s: max(abs(p[2][i]) for p in points) for i, s in enumerate(state_names)}
    alive = [s for s in state_names if moved[s] > 0.0 and not s.endswith("travel")]
    for c in CORNERS:
        print(c, sum(s.startswith(c) and "internal" in s for s in alive))

    # Model exchange: derivatives of the force and of the rates of every moving state, with respect to inputs and these states.
    for k, _, x in points:
        def look(names_at, values_at):
            xs, us = list(x), motion(k * DT)
            for n, v in zip(names_at, values_at):
                if n in inputs:
                    us[inputs.index(n)] += v
                else:
                    xs[state_names.index(n)] += v
            put(exchange, inputs, us)
            exchange.setContinuousStates((ctypes.c_double * len(xs))(*xs), len(xs))

        for c in CORNERS:
            mine = [s for s in alive if s.startswith(c + ".")]
            unknowns = [f"Damper_Force_{c}"] + [f"der({s})" for s in mine]
            for known in [n for n in inputs if n.endswith(c)] + mine:
                look([], [])
                got = {u: derivative(exchange, u, known) for u in unknowns}
                size = max(moved.get(known, 0.0), 1e-3)

                def at(by, cache={}):
                    # Evaluate all unknowns at once, because each of them needs the same points.
                    key = (k, known, by)
                    if key not in cache:
                        look([known], [by])
                        cache[key] = dict(zip(unknowns, get(exchange, unknowns)))
                    return cache[key]

                for u in unknowns:
                    compare(f"{u})/d({known}", got[u], lambda by: at(by)[u], size)

    # Co-simulation: derivatives of the force with respect to the inputs at the end of a step.
    for k, before, _ in points:
        for c in CORNERS:
            for known in [n for n in inputs if n.endswith(c)]:
                def step(by):
                    (co.setFMUState if three else co.setFMUstate)(before)
                    values = motion(k * DT)
                    values[inputs.index(known)] += by
                    put(co, inputs, values)
                    co.doStep((k - 1) * DT, DT)
                    return get(co, [f"Damper_Force_{c}"])[0]

                step(0.0)
                compare(f"step: Damper_Force_{c})/d({known}", derivative(co, f"Damper_Force_{c}", known), step, 1e-2)
    print("worst", worst)
    for _, before, _ in points:
        (co.freeFMUState if three else co.freeFMUstate)(before)
    (co.freeFMUState if three else co.freeFMUstate)(after)
    for fmu in (co, exchange):
        fmu.terminate()
        fmu.freeInstance()
finally:
    shutil.rmtree(folder, ignore_errors=True)
