"""The virtual rig, which generates records for experiments, and test matrices."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence

from . import _native
from ._files import needs, write_new
from ._given import Bench, Tests
from ._numbers import real, words
from ._work import watched
from .campaign import Campaign, Path, Progress


def measure_virtual(
    folder: Path,
    *,
    amplitudes_m: Sequence[float] | None = None,
    peak_velocities_m_s: Sequence[float] | None = None,
    frequency_limit_hz: float | None = None,
    slow_tests: bool = True,
    matrix: Path | None = None,
    plan: str | None = None,
    seed: int = 0,
    noise_percent: float = 1.0,
    noise_colour: float = 0.0,
    hum_n: float = 0.0,
    bits: int | None = None,
    sample_rate_hz: float | None = None,
    side_force: bool = True,
    temperature: bool = True,
    hide: str | Sequence[str] | Mapping[str, float | None] | None = None,
    severity: bool = False,
    start_temperature_c: float | None = None,
    order: int | None = None,
    noise_seed: int | None = None,
    progress: Progress | None = None,
) -> Campaign:
    """Simulates a campaign on the virtual rig, writes its records into a folder, and reads them, like ``dashpot rig``.

    The damper is a physical simulation that shares no equations with the model. With ``hide``, it is a neutral damper of the model's topology
    with injected effects. The default tests are then those of the plan ``"diagnosis"``, and otherwise those of the thesis. The injected effects
    are written to ``sealed/truth.toml`` in the folder.

    :param amplitudes_m: amplitudes of the tests, m; by default those of the thesis.
    :param peak_velocities_m_s: peak velocities of the tests, m/s; by default those of the thesis.
    :param frequency_limit_hz: highest frequency, Hz. Tests above it are left out. The default is that of the thesis's rig.
    :param slow_tests: whether the tests include slow cycles for friction and gas force.
    :param matrix: path of a test matrix (CSV) that replaces these tests, such as :func:`write_test_matrix` or
        :meth:`Diagnosis.write_next_tests` writes.
    :param plan: name of a plan that replaces these tests: ``"diagnosis"``, ``"thesis"``, or a deficient plan: ``"one-amplitude"``,
        ``"one-frequency"``, ``"no-slow-tests"``, ``"centred"``, ``"no-side-force"``.
    :param seed: seed of the damper and of the noise; 0 is the default damper. Two campaigns of one seed have the same noise.
    :param noise_seed: seed of the noise alone, for a second measurement of the same damper; ``seed`` if not given.
    :param noise_percent: noise of the force, percent of each test's root-mean-square force; 0 makes every sensor ideal.
    :param noise_colour: correlation of adjacent noise samples; 0 is white noise.
    :param hum_n: amplitude of mains hum in the force, N.
    :param bits: resolution of the force channel's converter, bits; no quantization if not given.
    :param sample_rate_hz: sample rate, Hz; selected by the frequency of the test if not given.
    :param side_force: whether the side force is recorded in tests that apply one.
    :param temperature: whether the temperature of the damper's body is recorded. Only a damper with ``hide`` has a temperature.
    :param hide: effects to inject: a name, several names, or names with numbers: ``{"cavitation": 0.5, "free_play": None}``. A name without a
        number is a typical strong case. ``"free_play:hertz"`` selects a physical form, which the seed otherwise selects. An empty mapping, or
        ``"nothing"``, injects no effect. The error for an unknown name lists all names.
    :param severity: requires ``hide``. Its numbers are then severities, as in ``dashpot rig --hide``: the residual that remains after a refit of
        the model, in units of the noise. 0.5 is weak and 4 is strong. A search on the tests of a plan finds the strengths, which takes
        seconds. Otherwise the numbers are physical strengths, as in ``dashpot rig --strength``, and 1 is a typical strong case.
    :param start_temperature_c: requires ``hide``. Temperature of the damper before the first test, °C. The default is 22 °C, the temperature
        of the laboratory.
    :param order: requires ``hide``. Seed of another order of the plan's tests, which gives another thermal history.
    :raises RigError: if a test, an effect or a sensor is invalid.
    :raises ValueError: if more than one of matrix, plan and single tests is given, or ``severity``, ``order`` or ``start_temperature_c``
        without ``hide``.
    """
    tests = _tests(amplitudes_m, peak_velocities_m_s, frequency_limit_hz, slow_tests)
    varied = amplitudes_m is not None or peak_velocities_m_s is not None or frequency_limit_hz is not None or not slow_tests
    if (matrix is not None) + (plan is not None) + varied > 1:
        raise ValueError("matrix, plan and what varies the thesis's tests (amplitudes_m, peak_velocities_m_s, ...) exclude each other; give one")
    if hide is None:
        for name, value in (("start_temperature_c", start_temperature_c), ("order", order), ("severity", severity or None)):
            if value is not None:
                raise ValueError(f"{name} is of a damper in which effects are hidden; give hide, such as hide={{}} for none")
    for name, number in (("noise_percent", noise_percent), ("noise_colour", noise_colour), ("hum_n", hum_n)):
        real(name, number)
    tests["matrix"] = None if matrix is None else os.fspath(matrix)
    tests["plan"] = plan
    bench: Bench = {
        "seed": seed,
        "noise_percent": noise_percent,
        "sample_rate_hz": sample_rate_hz,
        "noise_colour": noise_colour,
        "hum_n": hum_n,
        "bits": bits,
        "side_force": side_force,
        "temperature": temperature,
        "start_temperature_c": start_temperature_c,
        "noise_seed": noise_seed,
        "order": order,
    }
    with watched(progress) as told, needs(matrix):
        _native.measure(os.fspath(folder), tests, bench, None if hide is None else _asked(hide), bool(severity), told)
    return Campaign.read(folder)


def write_test_matrix(
    path: Path,
    *,
    amplitudes_m: Sequence[float] | None = None,
    peak_velocities_m_s: Sequence[float] | None = None,
    frequency_limit_hz: float | None = None,
    slow_tests: bool = True,
    force: bool = False,
) -> int:
    """Writes a test matrix for a rig as CSV, by default that of the thesis, like ``dashpot matrix``.

    The matrix combines every amplitude with every peak velocity up to the frequency limit. Slow cycles for friction and gas force follow.

    :param amplitudes_m: amplitudes, m.
    :param peak_velocities_m_s: peak velocities, m/s.
    :param frequency_limit_hz: highest frequency that the rig can run, Hz.
    :param slow_tests: whether the matrix contains slow cycles for friction and gas force.
    :param force: replaces an existing file, even one of another kind or a write-protected file.
    :returns: the number of tests.
    :raises RigError: if a number is implausible for a rig, or no test remains.
    :raises OutputError: if the file cannot be written.
    :raises FileExistsError: if another file exists and ``force`` is not given. The exception is also an :class:`OutputError`.
    """
    text, count = _native.test_matrix(_tests(amplitudes_m, peak_velocities_m_s, frequency_limit_hz, slow_tests))
    write_new(path, text, force)
    return count


def _asked(hide: str | Sequence[str] | Mapping[str, float | None]) -> list[tuple[str, float | None]]:
    """Converts the argument ``hide`` to a list of names, each with its number or None."""
    if not isinstance(hide, Mapping):
        return [(name, None) for name in words(hide)]
    for name, number in hide.items():
        real(f"hide[{name!r}]", number)
    return list(hide.items())


def _tests(
    amplitudes_m: Sequence[float] | None, peak_velocities_m_s: Sequence[float] | None, frequency_limit_hz: float | None, slow_tests: bool
) -> Tests:
    return {
        "matrix": None,
        "plan": None,
        "amplitudes_m": None if amplitudes_m is None else [float(a) for a in amplitudes_m],
        "peak_velocities_m_s": None if peak_velocities_m_s is None else [float(v) for v in peak_velocities_m_s],
        "frequency_limit_hz": frequency_limit_hz,
        "slow_tests": bool(slow_tests),
    }
