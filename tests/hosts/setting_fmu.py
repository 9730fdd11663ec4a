"""Runs a damper that depends on a setting in a quarter car with an on-off skyhook controller, with the library and with an FMU. The forces must be
equal bit for bit. The calls of FMI 2.0 are direct, so that only Python is needed.

    python setting_fmu.py LIBRARY MODEL FMU
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


class Fmu:
    """One instance of the FMU in co-simulation."""

    def __init__(self, path: str) -> None:
        folder = Path(tempfile.mkdtemp())
        zipfile.ZipFile(path).extractall(folder)
        description = xml.parse(folder / "modelDescription.xml").getroot()
        self.variables = {v.get("name"): v for v in description.iter("ScalarVariable")}
        self.library = c.CDLL(str(folder / "binaries/linux64/dashpot_damper.so"))
        logger = c.CFUNCTYPE(None, c.c_void_p, c.c_char_p, c.c_int, c.c_char_p, c.c_char_p, c.c_char_p)
        self.log = logger(lambda environment, name, status, category, form, message: print(message.decode(), file=sys.stderr))

        class Callbacks(c.Structure):
            _fields_ = [("logger", logger), ("allocate", c.c_void_p), ("free", c.c_void_p), ("finished", c.c_void_p), ("environment", c.c_void_p)]

        make = self.library.fmi2Instantiate
        make.restype = c.c_void_p
        self.instance = make(b"damper", 1, description.get("guid").encode(), (folder / "resources").as_uri().encode(), c.byref(Callbacks(logger=self.log)), 0, 1)
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


def loop(rest, step) -> list[float]:
    """Returns the forces of the damper under the controller, N."""
    force = still = rest(0.6)
    body = body_rate = wheel = wheel_rate = road = 0.0
    seed, forces = 1, []
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


def main() -> None:
    library, model, path = sys.argv[1:4]
    damper, fmu = Damper(library, model), Fmu(path)

    def rest(setting: float) -> float:
        at = damper.motion(0.0, 0.0, setting)
        damper.check(damper.library.dashpot_state_init_motion(c.byref(damper.model), c.byref(at), c.byref(damper.state)))
        return damper.try_step(0.0, 0.0, 0.0, setting)[0]

    def fmu_rest(setting: float) -> float:
        fmu.call("EnterInitializationMode")
        fmu.set("setting", setting)
        fmu.call("ExitInitializationMode")
        return fmu.get("force")

    times = iter(range(10**6))

    def fmu_step(displacement: float, velocity: float, setting: float) -> float:
        for name, value in (("displacement", displacement), ("velocity", velocity), ("setting", setting)):
            fmu.set(name, value)
        fmu.call("DoStep", c.c_double(next(times) * STEP), c.c_double(STEP), 1)
        return fmu.get("force")

    setting = fmu.variables["setting"]
    real = setting.find("Real")
    assert setting.get("causality") == "input" and real.get("unit") == "A" and float(real.get("start")) == 0.6, xml.tostring(setting)
    assert "current" in setting.get("description")
    own = loop(rest, lambda x, v, s: damper.step(x, v, STEP, s))
    theirs = loop(fmu_rest, fmu_step)
    assert own == theirs, max(abs(a - b) for a, b in zip(own, theirs))
    assert max(own) - min(own) > 500.0
    # A setting outside of the grid is clamped, with a warning.
    fmu_step(0.0, 0.1, 9.0)
    assert fmu.status() == 4, fmu.status()
    print(f"{len(own)} forces, the same to the bit")


if __name__ == "__main__":
    main()
