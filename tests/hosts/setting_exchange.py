"""Integrates the states of an FMU in model exchange, whose damper depends on a setting that moves during the run, with Runge-Kutta's method of
order four. The forces must be those of the library's dashpot_step(). At several instants, the directional derivatives with respect to setting,
motion and states must be central differences. The derivatives of co-simulation are compared in the same way.

    python setting_exchange.py LIBRARY MODEL DEAD_TIME LOW HIGH FMU FMU_OF_FMI_3

DEAD_TIME is that of the model, s, and LOW and HIGH are the ends of its grid. In model exchange the host delays the command by the dead time."""
import ctypes as c
import math
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples"))
from dashpot_damper import Damper  # noqa: E402
from setting_fmu import Fmu, Fmu3, unpacked  # noqa: E402

STEP, STEPS = 4e-5, 10000
"""Steps of the integration, s. They resolve the internal mass, so the error of both integrations is small."""
LIMIT = 2e-3
"""Largest difference of the forces, as a fraction of the largest force."""
NEAR = 1e-4
"""Largest relative difference between a directional derivative and differences."""


def motion(t: float) -> tuple[float, float]:
    """Returns displacement, m, and velocity, m/s."""
    x = v = 0.0
    for amplitude, hertz in ((0.02, 1.7), (0.002, 13.0)):
        w = 2 * math.pi * hertz
        x += amplitude * math.sin(w * t)
        v += amplitude * w * math.cos(w * t)
    return x, v


def command(t: float, low: float, high: float) -> float:
    """Returns the command: a sine, with steps between two levels in the middle of the run."""
    if 0.1 <= t < 0.25:
        return low + (0.05 if math.floor(t / 0.025) % 2 else 0.85) * (high - low)
    return low + (0.5 + 0.45 * math.sin(2 * math.pi * 7.0 * t)) * (high - low)


class Exchange:
    """An FMU in model exchange."""

    def __init__(self, path: str, is_fmi_3: bool) -> None:
        self.fmu, self.is_fmi_3 = (Fmu3 if is_fmi_3 else Fmu)(path, exchange=True), is_fmi_3
        _, description = unpacked(path)
        self.rates = rates_of(description, is_fmi_3)
        self.states = [state for state, _ in self.rates]
        self.buffer = (c.c_double * len(self.states))()

    def begin(self, values: dict[str, float]) -> list[float]:
        """Initializes the FMU, and returns its states."""
        self.fmu.initialize(values)
        if self.is_fmi_3:
            flags = [c.c_bool() for _ in range(5)]
            self.fmu.call("UpdateDiscreteStates", *(c.byref(flag) for flag in flags), c.byref(c.c_double()))
        else:
            self.fmu.call("NewDiscreteStates", c.create_string_buffer(64))
        self.fmu.call("EnterContinuousTimeMode")
        self.fmu.call("GetContinuousStates", self.buffer, c.c_size_t(len(self.states)))
        return list(self.buffer)

    def look(self, t: float, setting: float, states: list[float], x: float, v: float) -> None:
        """Sets time, inputs and states."""
        self.fmu.call("SetTime", c.c_double(t))
        for name, value in (("displacement", x), ("velocity", v), ("setting", setting)):
            self.fmu.set(name, value)
        self.buffer[:] = states
        self.fmu.call("SetContinuousStates", self.buffer, c.c_size_t(len(states)))

    def derivatives(self) -> list[float]:
        name = "GetContinuousStateDerivatives" if self.is_fmi_3 else "GetDerivatives"
        self.fmu.call(name, self.buffer, c.c_size_t(len(self.states)))
        return list(self.buffer)

    def step(self, t: float, states: list[float], commands) -> list[float]:
        """Returns the states after a step of Runge-Kutta's method. `commands` has the command at the times of the stages."""

        def rate(time: float, at: list[float]) -> list[float]:
            self.look(time, commands(time), at, *motion(time))
            return self.derivatives()

        def moved(by: float, of: list[float]) -> list[float]:
            return [state + by * one for state, one in zip(states, of)]

        a = rate(t, states)
        b = rate(t + 0.5 * STEP, moved(0.5 * STEP, a))
        d = rate(t + 0.5 * STEP, moved(0.5 * STEP, b))
        e = rate(t + STEP, moved(STEP, d))
        return [s + STEP / 6 * (p + 2 * q + 2 * r + w) for s, p, q, r, w in zip(states, a, b, d, e)]


def rates_of(description: xml.Element, is_fmi_3: bool) -> list[tuple[str, str]]:
    """Returns the names of the states and of their derivatives, in the order of the states."""
    if is_fmi_3:
        variables = list(description.find("ModelVariables"))
        name = {v.get("valueReference"): v.get("name") for v in variables}
        by_name = {v.get("name"): v for v in variables}
        unknowns = description.findall("ModelStructure/ContinuousStateDerivative")
        rates = [name[u.get("valueReference")] for u in unknowns]
        return [(name[by_name[rate].get("derivative")], rate) for rate in rates]
    variables = list(description.iter("ScalarVariable"))
    unknowns = description.findall("ModelStructure/Derivatives/Unknown")
    rates = [variables[int(u.get("index")) - 1] for u in unknowns]
    return [(variables[int(r.find("Real").get("derivative")) - 1].get("name"), r.get("name")) for r in rates]


def derivative(fmu: Fmu, unknown: str, known: str) -> float:
    """Returns a directional derivative of the FMU."""
    one, size, found = c.c_double(1.0), c.c_size_t(1), c.c_double()
    references = [c.byref(fmu.reference(unknown)), size, c.byref(fmu.reference(known)), size, c.byref(one)]
    if isinstance(fmu, Fmu3):
        fmu.call("GetDirectionalDerivative", *references, size, c.byref(found), size)
    else:
        fmu.call("GetDirectionalDerivative", *references, c.byref(found))
    return found.value


def compare(what: str, got: float, at, size: float, sides=(-1.0, 1.0)) -> float:
    """Compares a derivative with differences, and returns the relative deviation. `at` has the value with the known variable changed, and
    `size` is the magnitude of its changes. `sides` are the ends of the difference: one-sided at an end of the grid."""
    best = None
    for by in (1e-3, 1e-4, 1e-5, 1e-6):
        up, down = at(sides[1] * by * size), at(sides[0] * by * size)
        wanted = (up - down) / ((sides[1] - sides[0]) * by * size)
        # Bound of the rounding error of the difference.
        noise = 1e-12 * (1.0 + abs(up)) / (by * size)
        miss = max(0.0, abs(got - wanted) - noise) / max(abs(got), abs(wanted), 1e-3 / size)
        best = min(best or (miss, wanted), (miss, wanted))
    if best[0] > NEAR:
        sys.exit(f"d({what}) = {got}, by differences {best[1]}")
    return best[0]


def check_exchange_derivatives(exchange: Exchange, t: float, setting: float, states: list[float], sizes: list[float], span: float) -> int:
    """Compares the derivatives of force and rates with respect to setting, motion and states. Returns how many of those with respect to the
    setting differ from 0."""
    fmu, (x, v) = exchange.fmu, motion(t)
    unknowns = ["force"] + [rate for _, rate in exchange.rates]
    known = {"setting": span, "displacement": 1e-2, "velocity": 1e-1} | dict(zip(exchange.states, sizes))
    found = 0
    for name, size in known.items():

        def values(by: float, name=name) -> dict[str, float]:
            moved = [s + by * (name == state) for s, state in zip(states, exchange.states)]
            exchange.look(t, setting + by * (name == "setting"), moved, x + by * (name == "displacement"), v + by * (name == "velocity"))
            return {u: fmu.get(u) for u in unknowns}

        values(0.0)
        got = {u: derivative(fmu, u, name) for u in unknowns}
        cache: dict[float, dict[str, float]] = {}
        for u in unknowns:
            compare(f"{u})/d({name}", got[u], lambda by: cache.setdefault(by, values(by))[u], size)
        found += sum(got[u] != 0.0 for u in unknowns) * (name == "setting")
    return found


def check_exchange(library: str, model: str, dead_time: float, ends: tuple[float, float], path: str, is_fmi_3: bool) -> None:
    """Compares the forces of model exchange with those of the library, and the derivatives with differences."""
    exchange, damper = Exchange(path, is_fmi_3), Damper(library, model)
    x, v = motion(0.0)
    # The range of levels in one step, so that no stage sees the command of the next step.
    now = command(0.0, *ends)
    states = exchange.begin({"displacement": x, "velocity": v, "setting": now})
    at = damper.motion(x, v, now)
    damper.check(damper.library.dashpot_state_init_motion(c.byref(damper.model), c.byref(at), c.byref(damper.state)))
    peak = worst = 0.0
    sizes, points = [1e-9] * len(states), 0
    span = ends[1] - ends[0]
    for k in range(STEPS):
        t = k * STEP
        middle = t + 0.5 * STEP

        def delayed(time: float) -> float:
            """Returns the command after the dead time. A level does not change within a step."""
            inside = min(max(time, t + 1e-9), t + STEP - 1e-9) - dead_time
            return command(max(inside, 0.0), *ends)

        states = exchange.step(t, states, delayed)
        sizes = [max(size, abs(state)) for size, state in zip(sizes, states)]
        x, v = motion(t + STEP)
        exchange.look(t + STEP, delayed(t + STEP), states, x, v)
        # The library uses one command for the whole step. With an actuator, it is the command in the middle of the step, otherwise at its end.
        has_lag = any("setting" in name for name in exchange.states)
        theirs = damper.step(x, v, STEP, command(middle if has_lag or dead_time > 0.0 else t + STEP - 1e-9, *ends))
        ours = exchange.fmu.get("force")
        peak, worst = max(peak, abs(theirs)), max(worst, abs(ours - theirs))
        if k % 3001 == 1500:
            points += check_exchange_derivatives(exchange, t + STEP, delayed(t + STEP), states, sizes, span)
    print(f"model exchange {3 if is_fmi_3 else 2}: {1e2 * worst / peak:.4f} % of {peak:.0f} N, {points} derivatives by the setting")
    if not worst < LIMIT * peak or not points:
        sys.exit(f"{path}: {worst} N of {peak} N, {points} derivatives")


def check_step_derivatives(ends: tuple[float, float], path: str, is_fmi_3: bool) -> None:
    """Compares the derivative of the force with respect to the command of a step in co-simulation, also at the ends of the grid and outside."""
    fmu, dt, span = (Fmu3 if is_fmi_3 else Fmu)(path), 1e-3, ends[1] - ends[0]
    fmu.initialize({"displacement": motion(0.0)[0], "velocity": motion(0.0)[1], "setting": command(0.0, *ends)})
    nonzero = 0

    def step(k: int, setting: float) -> float:
        x, v = motion(k * dt)
        for name, value in (("displacement", x), ("velocity", v), ("setting", setting)):
            fmu.set(name, value)
        fmu.do_step((k - 1) * dt, dt)
        return fmu.get("force")

    for k in range(1, 200):
        # The command is inside the grid, at its ends, and outside, in turn.
        place = k // 23 % 4
        setting = (command(k * dt, *ends), ends[0], ends[1], ends[1] + span)[place]
        sides = ((-1.0, 1.0), (0.0, 1.0), (-1.0, 0.0), (-1.0, 1.0))[place]
        before = fmu.serialized() if k % 23 == 11 else None
        step(k, setting)
        if before:
            got, after = derivative(fmu, "force", "setting"), fmu.serialized()

            def at(by: float, k=k, before=before, setting=setting) -> float:
                fmu.restore(before)
                return step(k, setting + by)

            compare(f"force)/d(setting) of step {k}", got, at, span, sides)
            nonzero += got != 0.0
            fmu.restore(after)
    print(f"co-simulation {3 if is_fmi_3 else 2}: {nonzero} derivatives by the setting")


def main() -> None:
    library, model, *numbers = sys.argv[1:6]
    dead_time, *ends = map(float, numbers)
    for is_fmi_3, path in enumerate(sys.argv[6:8]):
        check_exchange(library, model, dead_time, tuple(ends), path, bool(is_fmi_3))
        check_step_derivatives(tuple(ends), path, bool(is_fmi_3))


if __name__ == "__main__":
    main()
