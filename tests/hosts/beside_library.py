"""Compares the force of an FMU in a co-simulation host with that of the library itself, over three sine tests.

Arguments of the program: FMU, shared library, model file. Every step gets displacement and velocity at its end, as a vehicle model
supplies them. The force must equal that of `dashpot_step` with the same motion, except for rounding."""
import sys
from pathlib import Path

from sine import motion

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))
from dashpot_damper import Damper  # noqa: E402

fmu, library, model_file = sys.argv[1:4]
STEP, STEPS = 1e-3, 1500
TESTS = [(0.05, 0.3), (0.03, 5.6), (0.005, 20.0)]


def of_library(test):
    damper = Damper(library, model_file, motion(*test, 0.0)[0])
    return [damper.step(*motion(*test, (k + 1) * STEP), STEP) for k in range(STEPS)]


def compare(of_host, share):
    """Checks the forces of `of_host`, which gives those of a test at the ends of its steps, N.

    They may differ from those of the library by the fraction `share` of the largest force."""
    for test in TESTS:
        ours, theirs = of_library(test), of_host(test)
        top = max(map(abs, ours))
        worst = max(abs(a - b) for a, b in zip(ours, theirs, strict=True))
        print(f"{1e3 * test[0]:g} mm, {test[1]:g} Hz: largest difference {worst:.2e} N of {top:.0f} N")
        assert worst < share * top, test
