"""Runs an FMU in a host that converts units: by the units that the description declares, it must get the damper in SI.

Arguments: FMU in SI, then for each other FMU of the same damper its file and, separated by commas, the units of displacement, velocity, force,
stiffness and damping that it must declare, or - for no unit."""
import math
import sys
from xml.etree import ElementTree
from zipfile import ZipFile

from fmpy import extract, read_model_description
from fmpy.validation import validate_fmu

from fmu_instance import begun

plain, *others = sys.argv[1:]
# Names of the inputs and outputs of the first corner, in an FMU with one damper and in one of a vehicle.
NAMES = [("displacement", "Damper_Jounce"), ("velocity", "Damper_Jounce_Rate"), ("force", "Damper_Force"),
         ("d_force_d_displacement", "Damper_Force_by_Jounce"), ("d_force_d_velocity", "Damper_Force_by_Jounce_Rate")]
# Dimensions of these variables, from which a host chooses its own units.
DIMENSIONS = [{"m": 1}, {"m": 1, "s": -1}, {"kg": 1, "m": 1, "s": -2}, {"kg": 1, "s": -2}, {"kg": 1, "s": -1}]
STEP, AMPLITUDE, OMEGA = 1e-3, 0.03, 2 * math.pi * 3


def check(condition, text):
    if not condition:
        sys.exit(text)


class Host:
    """One corner of an FMU, used in SI: converted by the declared unit of a variable, or by the scales if it declares none."""

    def __init__(self, fmu):
        check(validate_fmu(fmu) == [], validate_fmu(fmu))
        self.description = read_model_description(fmu, validate=False)
        self.variables = {v.name: v for v in self.description.modelVariables}
        four = "Damper_Jounce_L1" in self.variables
        self.names = [f"{many}_L1" if four else one for one, many in NAMES]
        self.prefix = "L1." if four else ""
        self.three = self.description.fmiVersion.startswith("3")
        units = {u.name: u.baseUnit for u in self.description.unitDefinitions}
        self.units = [self.variables[name].unit for name in self.names]
        scale = {name: float(self.variables[self.prefix + name].start) for name in ("motion_scale", "force_scale")}
        motion, force = scale["motion_scale"], scale["force_scale"]
        # SI units per unit of the host, with sign, from the scales of the FMU.
        by_scales = [motion, motion, 1 / force, 1 / (force * motion), 1 / (force * motion)]
        self.factor = []
        for unit, dimensions, by_scale, name in zip(self.units, DIMENSIONS, by_scales, self.names):
            if unit is None:
                told = self.variables[name].description
                check("of the damper" in told, f"{name} has no unit and says no factor: {told}")
                self.factor.append(by_scale)
                continue
            base = units[unit]
            has = {d: int(getattr(base, d)) for d in ("kg", "m", "s", "A", "K", "mol", "cd", "rad") if int(getattr(base, d))}
            check(has == dimensions and float(base.offset or 0) == 0, f"{name} in {unit}: {has}")
            self.factor.append(math.copysign(float(base.factor or 1), by_scale))
        xml = ElementTree.fromstring(ZipFile(fmu).read("modelDescription.xml"))
        names = [u.get("name") for u in xml.iter("Unit")]
        check(len(set(names)) == len(names), f"a unit is defined twice: {names}")
        self.rests_in_si()
        self.fmu = begun(self.description, extract(fmu), False)

    def rests_in_si(self):
        """Checks that variables that the scales do not affect are in SI units."""
        for name, unit in [("side_force", "N"), ("Damper_Side_Force_L1", "N"), ("position_offset", "m"), ("initial_position", "m"),
                           ("speed_margin", "m/s"), ("travel", "m"), ("deflection", "m"), ("mass_velocity", "m/s"),
                           ("der(deflection)", "m/s")]:
            for full in {name, self.prefix + name, name.replace("(", "(" + self.prefix)} & set(self.variables):
                check(self.variables[full].unit == unit, f"{full} in {self.variables[full].unit}")

    def get(self, names):
        places = [self.variables[name].valueReference for name in names]
        return (self.fmu.getFloat64 if self.three else self.fmu.getReal)(places)

    def run(self):
        """Returns force and derivatives in SI, and internal variables, over an oscillation."""
        place = [self.variables[name].valueReference for name in self.names[:2]]
        inner = [self.prefix + name for name in ("travel", "deflection", "mass_velocity", "speed_margin")]
        rows = []
        for k in range(400):
            phase = OMEGA * STEP * (k + 1)
            si = [AMPLITUDE * math.sin(phase), AMPLITUDE * OMEGA * math.cos(phase)]
            told = [value / factor for value, factor in zip(si, self.factor)]
            (self.fmu.setFloat64 if self.three else self.fmu.setReal)(place, told)
            self.fmu.doStep(k * STEP, STEP)
            outputs = [value * factor for value, factor in zip(self.get(self.names[2:]), self.factor[2:])]
            rows.append(outputs + list(self.get(inner)))
        self.fmu.terminate()
        self.fmu.freeInstance()
        return rows


first = Host(plain)
check(first.units == ["m", "m/s", "N", "N/m", "N s/m"], f"without scales: {first.units}")
right = first.run()
for scaled, wanted in zip(others[::2], others[1::2]):
    second = Host(scaled)
    told = ",".join(unit or "-" for unit in second.units)
    check(told == wanted, f"{scaled} declares {told}, not {wanted}")
    got = second.run()
    for column, name in enumerate(["force", "stiffness", "damping", "travel", "deflection", "mass_velocity", "speed_margin"]):
        top = max(abs(row[column]) for row in right)
        worst = max(abs(a[column] - b[column]) for a, b in zip(got, right))
        # The force scale in the arguments, the reciprocal of a pound-force, is rounded, hence the tolerance of 1e-6.
        check(top > 0 and worst <= 1e-6 * top, f"{scaled} in {wanted}: {name} {worst} apart, of {top}")
        print(f"{wanted}: {name} {worst / top:.1e} apart")
