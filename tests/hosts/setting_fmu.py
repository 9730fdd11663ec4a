"""Runs a damper that depends on a setting in a quarter car with an on-off skyhook controller, with the library and with FMUs: of FMI 2.0, of FMI
3.0, and of a vehicle with four corners. The forces must be equal bit for bit, also after an FMU was set back to a serialized state. The calls of
FMI are direct, so that only Python is needed.

    python setting_fmu.py LIBRARY MODEL FMU FMU_OF_FMI_3 FMU_OF_A_VEHICLE
"""
import ctypes as c
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples"))
from dashpot_damper import Damper  # noqa: E402

BODY, WHEEL, SPRING, TIRE, STEP, STEPS = 400.0, 45.0, 22e3, 210e3, 1e-3, 3000


def unpacked(path: str) -> tuple[Path, xml.Element]:
    """Returns the folder with the unpacked FMU, and its model description."""
    folder = Path(tempfile.mkdtemp())
    zipfile.ZipFile(path).extractall(folder)
    return folder, xml.parse(folder / "modelDescription.xml").getroot()


class Fmu:
    """One instance of the FMU, in co-simulation or in model exchange."""

    #: Names of the state and of its restoration in the functions of this version of FMI.
    STATE, DESERIALIZE = "FMUstate", "DeSerialize"

    def __init__(self, path: str, exchange: bool = False) -> None:
        folder, description = unpacked(path)
        self.variables = {v.get("name"): v for v in description.iter("ScalarVariable")}
        self.library = c.CDLL(str(folder / "binaries/linux64/dashpot_damper.so"))
        logger = c.CFUNCTYPE(None, c.c_void_p, c.c_char_p, c.c_int, c.c_char_p, c.c_char_p, c.c_char_p)
        self.log = logger(lambda environment, name, status, category, form, message: print(message.decode(), file=sys.stderr))

        class Callbacks(c.Structure):
            _fields_ = [("logger", logger), ("allocate", c.c_void_p), ("free", c.c_void_p), ("finished", c.c_void_p), ("environment", c.c_void_p)]

        make = self.library.fmi2Instantiate
        make.restype = c.c_void_p
        self.instance = make(b"damper", 0 if exchange else 1, description.get("guid").encode(), (folder / "resources").as_uri().encode(), c.byref(Callbacks(logger=self.log)), 0, 1)
        assert self.instance
        self.call("SetupExperiment", 0, c.c_double(0), c.c_double(0), 0, c.c_double(0))

    def call(self, name: str, *arguments: object) -> None:
        status = getattr(self.library, "fmi2" + name)(c.c_void_p(self.instance), *arguments)
        assert status == 0, f"{name}: {status}"

    def reference(self, name: str) -> c.c_uint:
        return c.c_uint(int(self.variables[name].get("valueReference")))

    def set(self, name: str, value: float) -> None:
        self.call("SetReal", c.byref(self.reference(name)), c.c_size_t(1), c.byref(c.c_double(value)))

    def get(self, name: str) -> float:
        value = c.c_double()
        self.call("GetReal", c.byref(self.reference(name)), c.c_size_t(1), c.byref(value))
        return value.value

    def status(self) -> int:
        value = c.c_int()
        self.call("GetInteger", c.byref(self.reference("status")), c.c_size_t(1), c.byref(value))
        return value.value

    def initialize(self, values: dict[str, float]) -> None:
        self.call("EnterInitializationMode")
        for name, value in values.items():
            self.set(name, value)
        self.call("ExitInitializationMode")

    def further(self) -> list[object]:
        """Returns the arguments of DoStep after time and step."""
        return [1]

    def do_step(self, time: float, step: float = STEP) -> None:
        self.call("DoStep", c.c_double(time), c.c_double(step), *self.further())

    def serialized(self) -> c.Array:
        """Returns the state of the instance as bytes."""
        state, size = c.c_void_p(), c.c_size_t()
        self.call("Get" + self.STATE, c.byref(state))
        self.call(f"Serialized{self.STATE}Size", state, c.byref(size))
        content = (c.c_char * size.value)()
        self.call("Serialize" + self.STATE, state, content, size)
        self.call("Free" + self.STATE, c.byref(state))
        return content

    def restore(self, content: c.Array) -> None:
        state = c.c_void_p()
        self.call(self.DESERIALIZE + self.STATE, content, c.c_size_t(len(content)), c.byref(state))
        self.call("Set" + self.STATE, state)
        self.call("Free" + self.STATE, c.byref(state))


class Fmu3(Fmu):
    """One instance of an FMU of FMI 3.0, in co-simulation or in model exchange."""

    STATE, DESERIALIZE = "FMUState", "Deserialize"

    def __init__(self, path: str, exchange: bool = False) -> None:
        folder, description = unpacked(path)
        self.variables = {v.get("name"): v for v in description.find("ModelVariables")}
        self.library = c.CDLL(str(folder / "binaries/x86_64-linux/dashpot_damper.so"))
        make = self.library.fmi3InstantiateModelExchange if exchange else self.library.fmi3InstantiateCoSimulation
        make.restype = c.c_void_p
        token, resources = description.get("instantiationToken").encode(), str(folder / "resources").encode() + b"/"
        none = c.c_void_p(None)
        further = (none, none) if exchange else (False, False, none, c.c_size_t(0), none, none, none)
        self.instance = make(b"damper", token, resources, False, True, *further)
        assert self.instance

    def call(self, name: str, *arguments: object) -> None:
        status = getattr(self.library, "fmi3" + name)(c.c_void_p(self.instance), *arguments)
        assert status == 0, f"{name}: {status}"

    def set(self, name: str, value: float) -> None:
        one = c.c_size_t(1)
        self.call("SetFloat64", c.byref(self.reference(name)), one, c.byref(c.c_double(value)), one)

    def get(self, name: str) -> float:
        value, one = c.c_double(), c.c_size_t(1)
        self.call("GetFloat64", c.byref(self.reference(name)), one, c.byref(value), one)
        return value.value

    def initialize(self, values: dict[str, float]) -> None:
        self.call("EnterInitializationMode", c.c_bool(False), c.c_double(0), c.c_double(0), c.c_bool(False), c.c_double(0))
        for name, value in values.items():
            self.set(name, value)
        self.call("ExitInitializationMode")

    def further(self) -> list[object]:
        event, terminate, early, last = c.c_bool(), c.c_bool(), c.c_bool(), c.c_double()
        return [c.c_bool(True), *(c.byref(flag) for flag in (event, terminate, early, last))]


def loop(rest, step, seed: int = 1) -> list[float]:
    """Returns the forces of the damper under the controller, N."""
    force = still = rest(0.6)
    body = body_rate = wheel = wheel_rate = road = 0.0
    forces = []
    for _ in range(STEPS):
        spring, damping, tire = -SPRING * (body - wheel), force - still, -TIRE * (wheel - road)
        body_rate += STEP * (spring - damping) / BODY
        wheel_rate += STEP * (tire - spring + damping) / WHEEL
        body += STEP * body_rate
        wheel += STEP * wheel_rate
        seed = (seed * 1664525 + 1013904223) % 2**32
        road += STEP * (((seed >> 8) / 8388608.0 - 1.0) * 1.1 - 0.8 * road)
        rate = body_rate - wheel_rate
        force = step(body - wheel, rate, 1.4 if body_rate * rate > 0.0 else 0.1)
        forces.append(force)
    return forces


def of_fmu(fmu: Fmu) -> tuple:
    """Returns the two functions of :func:`loop` for an FMU: the force at rest at a setting, and the force of a step."""
    times = iter(range(10**6))

    def rest(setting: float) -> float:
        fmu.initialize({"setting": setting})
        return fmu.get("force")

    def step(displacement: float, velocity: float, setting: float) -> float:
        for name, value in (("displacement", displacement), ("velocity", velocity), ("setting", setting)):
            fmu.set(name, value)
        fmu.do_step(next(times) * STEP)
        return fmu.get("force")

    return rest, step


def of_library(library: str, model: str) -> tuple:
    """Returns the two functions of :func:`loop` for the library."""
    damper = Damper(library, model)

    def rest(setting: float) -> float:
        at = damper.motion(0.0, 0.0, setting)
        damper.check(damper.library.dashpot_state_init_motion(c.byref(damper.model), c.byref(at), c.byref(damper.state)))
        return damper.try_step(0.0, 0.0, 0.0, setting)[0]

    return rest, lambda x, v, s: damper.step(x, v, STEP, s)


def check_restored(fmu: Fmu, step) -> None:
    """Repeats steps with a changing setting after the FMU was set back. The command of a dead time is part of the state."""

    def run() -> list[float]:
        return [step(0.01 * (k % 40) / 40, 0.3 * (-1) ** (k // 20), (0.1, 1.4)[k // 3 % 2]) for k in range(200)]

    step(0.0, 0.2, 1.4)
    content = fmu.serialized()
    first = run()
    fmu.restore(content)
    assert run() == first
    assert max(first) - min(first) > 500.0


def check_four_corners(library: str, model: str, path: str) -> None:
    """Drives each corner of a vehicle with motion and setting of a loop of its own."""
    corners, driven = ("L1", "R1", "L2", "R2"), []
    for seed in range(1, 5):
        rest, step = of_library(library, model)
        inputs: list[tuple[float, float, float]] = []

        def recorded(*given: float, step=step, inputs=inputs) -> float:
            inputs.append(given)
            return step(*given)

        driven.append((loop(rest, recorded, seed), inputs))
    vehicle = Fmu(path)
    vehicle.initialize({f"Damper_Setting_{corner}": 0.6 for corner in corners})
    for k in range(STEPS):
        for corner, (_, inputs) in zip(corners, driven):
            displacement, velocity, setting = inputs[k]
            vehicle.set(f"Damper_Jounce_{corner}", -displacement)
            vehicle.set(f"Damper_Jounce_Rate_{corner}", -velocity)
            vehicle.set(f"Damper_Setting_{corner}", setting)
        vehicle.do_step(k * STEP)
        for corner, (forces, _) in zip(corners, driven):
            assert vehicle.get(f"Damper_Force_{corner}") == -forces[k], (k, corner)
    settings = [{given[2] for given in inputs} for _, inputs in driven]
    assert all(of == {0.1, 1.4} for of in settings) and driven[0][0] != driven[1][0]


def main() -> None:
    library, model, path, path_3, path_of_vehicle = sys.argv[1:6]
    fmu = Fmu(path)
    setting = fmu.variables["setting"]
    real = setting.find("Real")
    assert setting.get("causality") == "input" and real.get("unit") == "A" and float(real.get("start")) == 0.6, xml.tostring(setting)
    assert "current" in setting.get("description")
    own = loop(*of_library(library, model))
    functions = of_fmu(fmu)
    for theirs in (loop(*functions), loop(*of_fmu(Fmu3(path_3)))):
        assert own == theirs, max(abs(a - b) for a, b in zip(own, theirs))
    assert max(own) - min(own) > 500.0
    check_restored(fmu, functions[1])
    # A setting outside of the grid is clamped, with a warning.
    functions[1](0.0, 0.1, 9.0)
    assert fmu.status() == 4, fmu.status()
    check_four_corners(library, model, path_of_vehicle)
    print(f"{len(own)} forces, the same to the bit")


if __name__ == "__main__":
    main()
