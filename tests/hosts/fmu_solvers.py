"""Compares model exchange in FMPy's CVODE, with default options, with the co-simulation of the same FMU at steps of a tenth of the output
interval. Arguments: limit in percent of the largest force, then for each FMU its file and its tests as amplitude:frequency, m and Hz. A damper
that depends on a setting has tests as amplitude:frequency:low:high, whose setting moves between low and high. If DASHPOT_FMUSIM names the program fmusim, it runs the
tests, too."""
import contextlib
import csv
import io
import math
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmu_instance import begun
from sine import motion

SECONDS = 0.5
fmusim = os.environ.get("DASHPOT_FMUSIM")


def compare(path, limit, tests):
    """Runs the tests of an FMU. Exits if the difference of one is beyond the limit."""
    description = read_model_description(path, validate=False)
    folder = extract(path)
    reference = {v.name: v.valueReference for v in description.modelVariables}
    names = ["displacement", "velocity"] + ["setting"] * ("setting" in reference)
    inputs, force = [reference[name] for name in names], [reference["force"]]
    three = description.fmiVersion.startswith("3")

    def course(test, t):
        """Returns the inputs of a test at a time: displacement, velocity, and the setting if the damper depends on one."""
        amplitude, frequency, *ends = test
        at = motion(amplitude, frequency, t)
        if ends:
            low, high = ends
            at.append(low + (high - low) * (0.5 + 0.5 * math.sin(2 * math.pi * 3.0 * t)))
        return at

    def right(test, interval, parts=10):
        fmu = begun(description, folder, False, lambda u: (u.setFloat64 if three else u.setReal)(inputs, course(test, 0.0)))
        get, put = (fmu.getFloat64, fmu.setFloat64) if three else (fmu.getReal, fmu.setReal)
        forces, h = [get(force)[0]], interval / parts
        for k in range(1, parts * round(SECONDS / interval) + 1):
            put(inputs, course(test, k * h))
            fmu.doStep((k - 1) * h, h)
            if k % parts == 0:
                forces.append(get(force)[0])
        fmu.terminate()
        fmu.freeInstance()
        return np.array(forces)

    def signals(test):
        # The signals are longer than the run, because a solver steps beyond its end and evaluates there.
        t = np.arange(0.0, 1.1 * SECONDS + 1e-9, 1e-4)
        rows = [(time, *course(test, time)) for time in t]
        return np.array(rows, dtype=[(name, "f8") for name in ("time", *names)])

    def in_fmpy(test):
        with contextlib.redirect_stdout(io.StringIO()):  # suppresses a warning for each input that is not set
            return simulate_fmu(
                path, fmi_type="ModelExchange", stop_time=SECONDS, input=signals(test), output=["force"], model_description=description)

    def in_fmusim(test):
        with tempfile.TemporaryDirectory() as at:
            rows = signals(test)
            np.savetxt(f"{at}/in.csv", rows, delimiter=",", header=",".join(("time", *names)), comments="", fmt="%.17g")
            # Older versions of fmusim, which are in C, have no verbs.
            verb = ["simulate"] if subprocess.run([fmusim, "simulate", "--help"], capture_output=True).returncode == 0 else []
            subprocess.run([fmusim, *verb, "--interface-type", "me", "--solver", "cvode", "--stop-time", str(SECONDS), "--output-interval", "1e-3",
                            "--input-file", f"{at}/in.csv", "--output-file", f"{at}/out.csv", "--output-variable", "force", path], check=True)
            with open(f"{at}/out.csv") as file:
                got = [(float(r["time"]), float(r["force"])) for r in csv.DictReader(file)]
        return np.array(got, dtype=[("time", "f8"), ("force", "f8")])

    try:
        failed = False
        for test in tests:
            for name, solver in [("FMPy", in_fmpy)] + ([("fmusim", in_fmusim)] if fmusim else []):
                got = solver(test)
                interval = got["time"][1] - got["time"][0]
                want = right(test, round(interval, 9))
                peak = np.abs(want).max()
                worst = 100 * np.abs(got["force"] - want[: len(got)]).max() / peak if len(got) == len(want) else math.inf
                print(f"{1e3 * test[0]:g} mm {test[1]:g} Hz in {name}: {worst:.3f} % of {peak:.0f} N")
                failed |= not worst < limit
        if failed:
            sys.exit(f"{path}: more than {limit} % of the largest force off")
    finally:
        shutil.rmtree(folder, ignore_errors=True)


fmus = []
for argument in sys.argv[2:]:
    if argument.endswith(".fmu"):
        fmus.append((argument, []))
    else:
        fmus[-1][1].append(tuple(map(float, argument.split(":"))))
for fmu, tests_of_fmu in fmus:
    compare(fmu, float(sys.argv[1]), tests_of_fmu)
