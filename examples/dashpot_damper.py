"""One damper from a model file, by ctypes, for the Python hosts in this folder. Needs only libdashpot.so or dashpot.dll."""
import ctypes as c
from typing import Any


class Params(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("abi_version", c.c_uint32), ("opaque", c.c_uint64 * 2047)]


class Model(c.Structure):
    _fields_ = [("opaque", c.c_uint64 * 6144)]


class State(c.Structure):
    _fields_ = [("displacement", c.c_double), ("velocity", c.c_double), ("mass_displacement", c.c_double),
                ("mass_velocity", c.c_double), ("internal", c.c_double * 8),
                ("layout", c.c_double), ("reserved", c.c_double), ("commands", c.c_double * 20)]


class Input(c.Structure):
    _fields_ = [("struct_size", c.c_uint32), ("known", c.c_uint32)] + [
        (n, c.c_double) for n in ("displacement", "velocity", "side_force", "temperature", "setting")]


class Output(c.Structure):
    _fields_ = [(n, c.c_double) for n in (
        "force", "d_force_d_displacement", "d_force_d_velocity", "primary_force", "spring_force", "friction_force", "gas_force",
        "series_deflection", "stop_force", "oil_temperature")]


class Fault(c.Structure):
    _fields_ = [("status", c.c_int32), ("line", c.c_uint32), ("parameter", c.c_char * 48)]


ABI_VERSION, KNOWS_DISPLACEMENT, KNOWS_SETTING = 9, 1, 8


def aligned(kind: Any) -> Any:
    """Makes a zeroed structure at an address divisible by 16, which Params and Model need and ctypes does not guarantee."""
    block = c.create_string_buffer(c.sizeof(kind) + 16)
    made = kind.from_buffer(block, -c.addressof(block) % 16)
    made._block = block
    return made


class Damper:
    """A damper in SI units; extension velocity and tension are positive.

    `evaluate` is for hosts whose solver integrates the states, `step` for all others."""

    def __init__(self, library: str, model_file: str, position: float = 0.0) -> None:
        self.library = c.CDLL(library)
        self.library.dashpot_status_text.restype = c.c_char_p
        if self.library.dashpot_abi_version() != ABI_VERSION:
            raise RuntimeError(f"{library} has interface version {self.library.dashpot_abi_version()}, this file was written for {ABI_VERSION}")
        with open(model_file, "rb") as file:
            text = file.read()
        params, self.model, fault = aligned(Params), aligned(Model), Fault()
        params.struct_size, params.abi_version = c.sizeof(Params), ABI_VERSION
        if self.library.dashpot_params_read(c.byref(params), text, c.c_size_t(len(text)), c.byref(fault)) < 0:
            self.check(fault.status, f"{model_file}, line {fault.line}: {fault.parameter.decode()} ")
        self.check(self.library.dashpot_model_init(c.byref(self.model), c.byref(params)))
        self.state, self.output = State(), Output()
        self.rest(position)

    def check(self, status: int, before: str = "") -> None:
        if status < 0:
            raise ValueError(before + self.library.dashpot_status_text(c.c_int32(status)).decode())

    def rest(self, position: float) -> float:
        """Puts the damper at rest at a position, m. Returns its static force, N."""
        self.check(self.library.dashpot_state_init(c.byref(self.model), c.c_double(position), c.byref(self.state)))
        return self.try_step(position, 0.0, 0.0)[0]

    def motion(self, displacement: float, velocity: float, setting: float | None = None) -> Input:
        """Makes the damper's input from the motion and, for a damper that depends on a setting, the commanded setting."""
        known = KNOWS_DISPLACEMENT | (KNOWS_SETTING if setting is not None else 0)
        return Input(c.sizeof(Input), known, displacement, velocity, 0.0, 0.0, setting or 0.0)

    def try_step(self, displacement: float, velocity: float, dt: float, setting: float | None = None) -> tuple[float, State]:
        """Returns force, N, and state at the end of a step of dt, s, to this motion. The damper itself does not change."""
        motion = self.motion(displacement, velocity, setting)
        reached = State()
        self.check(self.library.dashpot_step(
            c.byref(self.model), c.byref(self.state), c.byref(motion), c.c_double(dt), c.byref(reached), c.byref(self.output)))
        return self.output.force, reached

    def step(self, displacement: float, velocity: float, dt: float, setting: float | None = None) -> float:
        """Advances the damper by dt, s, to this motion. Returns the force, N."""
        force, self.state = self.try_step(displacement, velocity, dt, setting)
        return force

    def evaluate(self, state: State, displacement: float, velocity: float) -> tuple[float, State]:
        """Returns the force, N, and the time derivatives of all states at a state and a motion."""
        motion, rate = self.motion(displacement, velocity), State()
        self.check(self.library.dashpot_evaluate(
            c.byref(self.model), c.byref(state), c.byref(motion), c.byref(self.output), c.byref(rate)))
        return self.output.force, rate
