"""The virtual rig: records to try things on, and matrices of tests."""

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
    progress: Progress | None = None,
) -> Campaign:
    """Measures a campaign on the virtual rig, writes its records into a folder, and reads them; as ``dashpot rig``.

    The damper is a physical one that shares nothing with the model. With ``hide``, a neutral damper of the model's own topology
    instead, in which effects are hidden; its tests are those of the plan ``"diagnosis"`` if nothing is said of them, else those of the thesis.
    What is hidden is written beside the records, in ``sealed/truth.toml``.

    :param amplitudes_m: amplitudes of the tests, m; the thesis's if not given.
    :param peak_velocities_m_s: peak velocities of the tests, m/s; the thesis's if not given.
    :param frequency_limit_hz: highest frequency, Hz; what lies above is left out. That of the thesis's rig if not given.
    :param slow_tests: whether slow cycles for friction and gas force are among them.
    :param matrix: a test matrix (CSV) in their place, such as :func:`write_test_matrix` writes, or :meth:`Diagnosis.write_next_tests`.
    :param plan: a plan in their place: ``"diagnosis"``, ``"thesis"``, or a poor one, ``"one-amplitude"``, ``"one-frequency"``,
        ``"no-slow-tests"``, ``"centred"``, ``"no-side-force"``.
    :param seed: which damper, and which noise; 0 is the default damper.
    :param noise_percent: noise of the force, percent of each test's root-mean-square force; 0 makes every sensor ideal.
    :param noise_colour: correlation of that noise from one sample to the next; 0 is white.
    :param hum_n: amplitude of mains hum on the force, N.
    :param bits: bits of the force channel's converter; not rounded if not given.
    :param sample_rate_hz: samples per second; chosen by frequency if not given.
    :param side_force: whether the side force is recorded where it is applied.
    :param temperature: whether the temperature of the damper's body is recorded, which a damper with ``hide`` alone knows.
    :param hide: effects to hide: a name, several, or names with numbers: ``{"cavitation": 0.5, "free_play": None}``. A name without a number is
        a typical strong case, ``"free_play:hertz"`` asks for one physical form, where otherwise the seed chooses; an empty mapping, or
        ``"nothing"``, hides nothing. An unknown name is refused with all that there are.
    :param severity: with ``hide``: whether its numbers are severities, as those of ``dashpot rig --hide``: what refitting the model cannot absorb, in
        units of the noise, 0.5 being weak and 4 strong. The strengths that make them are searched for, which takes seconds, by the tests of
        a plan. Otherwise the numbers are physical strengths, 1 being a typical strong case, as with ``dashpot rig --strength``.
    :param start_temperature_c: with ``hide``: temperature of the damper before the first test, °C; that of the laboratory, 22 °C, if not given.
    :param order: with ``hide``: another order of a plan's tests, hence another thermal history.
    :raises RigError: where a test, an effect or a sensor cannot be.
    :raises ValueError: where tests are said in two ways, or ``severity``, ``order`` or ``start_temperature_c`` is given without ``hide``.
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
    """Writes a test matrix for a rig as CSV, by default the thesis's; as ``dashpot matrix``.

    Every amplitude is driven at every peak velocity up to the frequency limit, then come slow cycles for friction.

    :param amplitudes_m: amplitudes, m.
    :param peak_velocities_m_s: peak velocities, m/s.
    :param frequency_limit_hz: highest frequency that the rig can run, Hz.
    :param slow_tests: whether slow cycles for friction and gas force come last.
    :param force: replaces an existing file, even one of another kind or a write-protected file.
    :returns: the number of tests.
    :raises RigError: where a number is none of a rig, or no test is left.
    :raises OutputError: if the file cannot be written.
    :raises FileExistsError: if another file exists and ``force`` is not given. The exception is also an :class:`OutputError`.
    """
    text, count = _native.test_matrix(_tests(amplitudes_m, peak_velocities_m_s, frequency_limit_hz, slow_tests))
    write_new(path, text, force)
    return count


def _asked(hide: str | Sequence[str] | Mapping[str, float | None]) -> list[tuple[str, float | None]]:
    """Names to hide with their numbers, where they have one."""
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
