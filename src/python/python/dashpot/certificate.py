"""Whether a damper keeps its limits. SI units; extension (rebound) velocity and tension force are positive."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from ._result import Result, Row


@dataclass(frozen=True, repr=False)
class LimitValue(Result):
    """A figure that a limit speaks of, and the test or tests that it comes from."""

    tests: tuple[str, ...]
    value_n: float | None = field(default=None, metadata={"omitted": True})
    """Of a force, N; None of a time."""
    value_s: float | None = field(default=None, metadata={"omitted": True})
    """Of a time of response, s; None of a force."""

    @property
    def value(self) -> float:
        """The figure, N or s."""
        value = self.value_n if self.value_s is None else self.value_s
        return float("nan") if value is None else value


#: Quantities that are times, s; all others are forces, N.
_TIMES = ("response_time_up", "response_time_down", "rise_time_up", "rise_time_down")


def missed(said: Mapping[str, Any]) -> str | None:
    """A sentence where a limit is missed, or was not tested, which is no pass; from the dictionary of a :class:`Checked`."""
    if said["verdict"] == "pass":
        return None
    name, quantity, velocity = said["name"], said["quantity"], said["velocity_m_s"]
    words = quantity if velocity is None else f"{quantity} at {1e3 * velocity:g} mm/s"
    # A limit without a name is called by its quantity, as the file writes it.
    if name.lower().replace(" ", "_").replace("-", "_") != quantity:
        words = f"{name}, {words}"
    if said["measured"] is None and quantity in _TIMES:
        return f"{words}: not tested, there is no such step of the setting"
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
    """One limit, with what the rig measured and what the model gives on the same tests."""

    name: str
    """Name in the table; the quantity where it has none."""
    quantity: str
    velocity_m_s: float | None
    amplitude_m: float | None
    line: int
    """Line of the table, or place among those given."""
    measured: LimitValue | None
    """None where the records cannot tell."""
    model: LimitValue | None
    verdict: str
    """Of the damper: ``pass``, ``fail`` or ``not_tested``, which is no pass."""
    model_verdict: str | None
    setting: float | None = field(default=None, metadata={"omitted": True})
    """Setting of the damper at which, for one that depends on a setting."""
    low_n: float | None = None
    """Smallest force allowed, N; None of a time."""
    high_n: float | None = None
    """Largest force allowed, N; None of a time."""
    low_s: float | None = None
    """Smallest time of response allowed, s; None of a force."""
    high_s: float | None = None
    """Largest time of response allowed, s; None of a force."""

    def to_dict(self) -> dict[str, Any]:
        """As plain dictionaries, lists and numbers, with the keys of the command's JSON: those of the quantity's unit."""
        other = ("low_n", "high_n") if self.quantity in _TIMES else ("low_s", "high_s")
        return {key: value for key, value in super().to_dict().items() if key not in other}

    @property
    def missed(self) -> str | None:
        """A sentence where the damper misses the limit, or it was not tested."""
        return missed(self.to_dict())


def times_of(limit: Checked) -> Row:
    """Columns of a limit of a time, s; None of a force."""
    return {
        "low_s": limit.low_s,
        "high_s": limit.high_s,
        "measured_s": limit.measured.value_s if limit.measured else None,
        "model_s": limit.model.value_s if limit.model else None,
    }


@dataclass(frozen=True, repr=False)
class PeakPoint(Result):
    """Force at peak velocity of one stroke of a test, of rig and model."""

    test: str
    amplitude_m: float
    velocity_m_s: float
    force_n: float
    model_n: float | None


@dataclass(frozen=True, repr=False)
class Certificate(Result):
    """Which limits a damper keeps; the ``limits`` of ``dashpot validate --limits --json``."""

    passed: bool
    """Whether every limit was tested and is kept."""
    overall: str
    """Of the damper: ``pass``, ``fail`` where a limit is not kept, ``incomplete`` where none is missed and some were not tested."""
    model_passed: bool | None
    """The same for the model."""
    limits: tuple[Checked, ...]
    peaks: tuple[PeakPoint, ...]
    """The points that the forces were read from."""

    @property
    def missed(self) -> tuple[str, ...]:
        """A sentence for every limit that the damper misses or that was not tested."""
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
