"""Results of the comparison of a damper with its limits. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from . import _native
from ._result import Result, Row


@dataclass(frozen=True, repr=False)
class LimitValue(Result):
    """Value of a limited quantity, and the test or tests from which it was evaluated."""

    tests: tuple[str, ...]
    value_n: float | None = field(default=None, metadata={"omitted": True})
    """Value of a force, N; None for a time."""
    value_s: float | None = field(default=None, metadata={"omitted": True})
    """Value of a response time, s; None for a force."""
    uncertainty_s: float | None = field(default=None, metadata={"omitted": True})
    """Uncertainty of a response time, s, if it is known."""
    damping_n: float | None = field(default=None, metadata={"omitted": True})
    """Part of a friction that grows with velocity, N: the damping at the speed of the slow tests. None if it is unknown."""
    step: tuple[float, float] | None = field(default=None, metadata={"omitted": True})
    """Settings before and after the step of a response time."""

    @property
    def value(self) -> float:
        """The value, N or s; NaN if there is none."""
        value = self.value_n if self.value_s is None else self.value_s
        return float("nan") if value is None else value


#: Limited quantities that are times, s. All other quantities are forces, N.
_TIMES = ("response_time_up", "response_time_down", "rise_time_up", "rise_time_down")


def missed(said: Mapping[str, Any], unit_of_setting: str = "", settings: Sequence[float] | None = None) -> str | None:
    """Describes why a limit is not passed, from the dictionary of a :class:`Checked`: it is violated or was not tested. None for a pass.

    :param unit_of_setting: unit of the setting of a limit that states none.
    :param settings: settings at which the damper was measured, if they are known.
    """
    if said["verdict"] == "pass":
        return None
    name, quantity, velocity = said["name"], said["quantity"], said["velocity_m_s"]
    words = quantity if velocity is None else f"{quantity} at {1e3 * velocity:g} mm/s"
    # The name of a limit without a name of its own is its quantity, which the text must not repeat.
    if name.lower().replace(" ", "_").replace("-", "_") != quantity:
        words = f"{name}, {words}"
    setting = said.get("setting")
    if setting is not None:
        words = f"{words} at setting {setting:g} {said.get('setting_unit') or unit_of_setting}".rstrip()
    if said["measured"] is None and quantity in _TIMES:
        return f"{words}: not tested, there is no such step of the setting"
    if said["measured"] is None and setting is not None and settings is not None:
        if not any(_native.is_same_setting(setting, own) for own in settings):
            return f"{words}: not tested, the damper was not measured at this setting"
    if said["measured"] is None:
        slow = quantity in ("gas_force", "friction")
        return f"{words}: not tested, there is no {'slow test (below 6 mm/s)' if slow else 'test at this speed'}"
    unit = "s" if quantity in _TIMES else "N"
    value, low, high = said["measured"][f"value_{unit.lower()}"], said[f"low_{unit.lower()}"], said[f"high_{unit.lower()}"]
    if low is not None and value < low:
        return f"{words}: {value:.4g} {unit} is below {low:g} {unit}"
    return f"{words}: {value:.4g} {unit} is above {high:g} {unit}"


@dataclass(frozen=True, repr=False)
class Checked(Result):
    """One limit, with the value in the records and the model's value on the same tests."""

    name: str
    """Name in the table, or the quantity if the table gives no name."""
    quantity: str
    velocity_m_s: float | None
    amplitude_m: float | None
    line: int
    """Line of the table, or position in the list of limits."""
    measured: LimitValue | None
    """Value in the records; None if they have no suitable test."""
    model: LimitValue | None
    verdict: str
    """Verdict on the damper: ``pass``, ``fail`` or ``not_tested``, which does not count as a pass."""
    model_verdict: str | None
    setting: float | None = field(default=None, metadata={"omitted": True})
    """Setting at which the limit applies, for a damper that depends on a setting."""
    setting_unit: str | None = field(default=None, metadata={"omitted": True})
    """Unit of the setting, if the damper states one."""
    low_n: float | None = None
    """Smallest allowed force, N; None for a time, or without a lower limit."""
    high_n: float | None = None
    """Largest allowed force, N; None for a time, or without an upper limit."""
    low_s: float | None = None
    """Smallest allowed response time, s; None for a force, or without a lower limit."""
    high_s: float | None = None
    """Largest allowed response time, s; None for a force, or without an upper limit."""

    def to_dict(self) -> dict[str, Any]:
        """Converts the limit to plain dictionaries, lists and numbers, with the keys of the command's JSON for the quantity's unit."""
        other = ("low_n", "high_n") if self.quantity in _TIMES else ("low_s", "high_s")
        return {key: value for key, value in super().to_dict().items() if key not in other}

    @property
    def missed(self) -> str | None:
        """Description of why the damper does not pass: it violates the limit, or was not tested. None for a pass."""
        return missed(self.to_dict())


def times_of(limit: Checked) -> Row:
    """Returns the columns of a limited time, s. Their values are None for a limited force."""
    return {
        "low_s": limit.low_s,
        "high_s": limit.high_s,
        "measured_s": limit.measured.value_s if limit.measured else None,
        "model_s": limit.model.value_s if limit.model else None,
    }


@dataclass(frozen=True, repr=False)
class PeakPoint(Result):
    """Measured and simulated force at the peak velocity of one stroke of a test."""

    test: str
    amplitude_m: float
    velocity_m_s: float
    force_n: float
    model_n: float | None


@dataclass(frozen=True, repr=False)
class Certificate(Result):
    """Verdict on all limits of a damper; the ``limits`` of ``dashpot validate --limits --json``."""

    passed: bool
    """Whether the damper was tested for every limit and keeps it."""
    overall: str
    """Verdict on the damper: ``pass``, ``fail`` if it violates a limit, ``incomplete`` if it violates none but some were not tested."""
    model_passed: bool | None
    """Whether the model was tested for every limit and keeps it."""
    limits: tuple[Checked, ...]
    peaks: tuple[PeakPoint, ...]
    """Peak forces of the tests, from which the forces at the limits' velocities are read or interpolated."""

    @property
    def missed(self) -> tuple[str, ...]:
        """Descriptions of all limits that the damper violates or that were not tested."""
        return tuple(told for limit in self.limits if (told := limit.missed))

    def _rows(self) -> list[Row]:
        return [
            {
                "limit": c.name,
                "quantity": c.quantity,
                "velocity_m_s": c.velocity_m_s,
                "amplitude_m": c.amplitude_m,
                "low_n": c.low_n,
                "high_n": c.high_n,
                "measured_n": c.measured.value_n if c.measured else None,
                "model_n": c.model.value_n if c.model else None,
                **(times_of(c) if any(c.quantity in _TIMES for c in self.limits) else {}),
                "verdict": c.verdict,
                "model_verdict": c.model_verdict,
                "line": c.line,
                "measured_tests": c.measured.tests if c.measured else (),
                "model_tests": c.model.tests if c.model else (),
            }
            for c in self.limits
        ]

    def _title(self) -> str:
        untested = sum(c.verdict == "not_tested" for c in self.limits)
        return {
            "pass": "Limits: PASS, all are kept",
            "fail": f"Limits: FAIL, {sum(c.verdict == 'fail' for c in self.limits)} are not kept",
            "incomplete": f"Limits: INCOMPLETE, {untested} of {len(self.limits)} could not be tested",
        }[self.overall]
