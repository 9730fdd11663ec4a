"""One instance of an FMU with one corner, by direct calls of its library, and its messages to the importer's log.

Both versions of FMI and both kinds, co-simulation and model exchange, are supported."""
import ctypes
import sys
from ctypes import CFUNCTYPE, Structure, byref, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p, memset, sizeof
from pathlib import Path

from fmpy import extract, read_model_description, sharedLibraryExtension

OK, ERROR = 0, 3


class Fmu:
    """An unpacked FMU."""

    def __init__(self, path):
        self.description = read_model_description(path)
        self.three = self.description.fmiVersion.startswith("3")
        self.folder = Path(extract(path))
        platform = "x86_64-linux" if self.three else "linux64"
        self.library = self.folder / "binaries" / platform / f"dashpot_damper{sharedLibraryExtension}"
        resources = self.folder / "resources"
        self.resources = str(resources).encode() if self.three else resources.as_uri().encode()
        self.reference = {v.name: v.valueReference for v in self.description.modelVariables}
        self.said = []
        if self.three:
            self.Logger = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)
            self.log = self.Logger(lambda environment, status, category, message: self.said.append(message.decode()))
        else:
            # The message is the argument after the format, which is "%s".
            self.Logger = CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p, c_char_p)
            self.log = self.Logger(lambda environment, name, status, category, form, message: self.said.append(message.decode()))

    def check(self, condition, text):
        if not condition:
            sys.exit(f"{text}; said: {self.said}")


class Damper:
    """One instance. The library is loaded from `where`, by default from the FMU; `resources` is the folder that the importer names."""

    def __init__(self, fmu, resources, where=None, exchange=False):
        self.fmu, self.exchange = fmu, exchange
        self.library = ctypes.CDLL(str(where or fmu.library))
        name, token = b"damper", fmu.description.guid.encode()
        if fmu.three:
            kind = "ModelExchange" if exchange else "CoSimulation"
            make = getattr(self.library, f"fmi3Instantiate{kind}")
            make.restype = c_void_p
            more = [] if exchange else [c_bool(False), c_bool(False), None, c_size_t(0)]
            update = [] if exchange else [None]
            self.instance = make(name, token, resources, c_bool(False), c_bool(False), *more, None, fmu.log, *update)
        else:

            class Callbacks(Structure):
                _fields_ = [
                    ("logger", fmu.Logger), ("allocate", c_void_p), ("free", c_void_p), ("finished", c_void_p), ("environment", c_void_p)]

            make = self.library.fmi2Instantiate
            make.restype = c_void_p
            calls = Callbacks(logger=fmu.log)
            self.instance = make(name, 0 if exchange else 1, token, resources, byref(calls), 0, 0)
            memset(byref(calls), 0xAA, sizeof(calls))

    def call(self, name, *arguments):
        return getattr(self.library, ("fmi3" if self.fmu.three else "fmi2") + name)(c_void_p(self.instance), *arguments)

    def begin(self, start=0.0):
        if self.fmu.three:
            return self.call("EnterInitializationMode", c_bool(False), c_double(0), c_double(start), c_bool(False), c_double(0))
        status = self.call("SetupExperiment", 0, c_double(0), c_double(start), 0, c_double(0))
        return status or self.call("EnterInitializationMode")

    def real(self, name, value=None):
        """Gets the number of a variable, or sets it to `value`. The call must succeed."""
        status, number = self.asked(name, value)
        self.fmu.check(status == OK, f"{'Get' if value is None else 'Set'} {name}")
        return number

    def asked(self, name, value=None):
        """Gets the number of a variable, or sets it to `value`. Returns status and number."""
        number, count = (c_uint * 1)(self.fmu.reference[name]), c_size_t(1)
        room = (c_double * 1)(value or 0.0)
        more = [count] if self.fmu.three else []
        verb = ("Get" if value is None else "Set") + ("Float64" if self.fmu.three else "Real")
        return self.call(verb, number, count, room, *more), room[0]

    def step(self, t, h):
        if self.fmu.three:
            flags, last = (c_bool * 3)(), c_double()
            at = [byref(flags, i) for i in range(3)]
            return self.call("DoStep", c_double(t), c_double(h), c_bool(True), *at, byref(last))
        return self.call("DoStep", c_double(t), c_double(h), 1)

    def discrete_states(self):
        if self.fmu.three:
            flags, time = (c_bool * 5)(), c_double()
            return self.call("UpdateDiscreteStates", *[byref(flags, i) for i in range(5)], byref(time))
        return self.call("NewDiscreteStates", (c_double * 8)())

    def free(self):
        free = getattr(self.library, "fmi3FreeInstance" if self.fmu.three else "fmi2FreeInstance")
        free.restype = None
        free(c_void_p(self.instance))
