"""What a good damper may do: limits from a CSV file, and whether a damper keeps them.

The file has the columns ``quantity,velocity_m_s,low,high``; an empty low or high is no limit on that side. Forces are in N,
tension positive; velocities in m/s, extension positive.

| quantity | what is compared |
|---|---|
| ``force`` | force of the identified damper when it moves steadily at the velocity through displacement 0 |
| ``gas_force`` | the constant gas force of the identified damper; no velocity |
| ``friction`` | half the force between extension and compression at the velocity, 0.003 m/s if none is given |
| ``hysteresis`` | measured mean gap between rising and falling velocity of the test with that peak velocity (within a tenth) |
"""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .._native import DashpotError
from ..model import Model
from ..results import Validation

QUANTITIES = ("force", "gas_force", "friction", "hysteresis")
COLUMNS = ("quantity", "velocity_m_s", "low", "high")
#: Velocity, m/s, at which friction is read off: that of the thesis's slow tests, where the valves make next to nothing.
SLOW = 0.003
#: Share by which the peak velocity of a test may differ from that of a limit on its hysteresis.
SAME_VELOCITY = 0.1


@dataclass(frozen=True)
class Limit:
    """A range that a quantity has to keep."""

    quantity: str
    velocity_m_s: float | None
    low: float
    high: float

    def name(self) -> str:
        """The quantity in words."""
        return self.quantity if self.velocity_m_s is None else f"{self.quantity} at {self.velocity_m_s:g} m/s"

    def value(self, model: Model, validation: Validation) -> float:
        """The quantity of a damper; not a number where its campaign does not show it."""
        v = self.velocity_m_s
        if self.quantity == "force":
            return float(model.steady_force(v if v is not None else 0.0)[0])
        if self.quantity == "gas_force":
            parameter = model.parameters.get("gas_force")
            return float(parameter.value) if parameter and isinstance(parameter.value, float) else 0.0
        if self.quantity == "friction":
            speed = abs(v) if v else SLOW
            fast, slow = model.steady_force(np.array([speed, -speed]))
            return 0.5 * float(fast - slow)
        peak = abs(v) if v is not None else math.inf
        shown = [t for t in validation.tests if t.hysteresis is not None]
        if v is not None:
            shown = [t for t in shown if abs(t.peak_velocity_m_s - peak) <= SAME_VELOCITY * peak]
        if not shown:
            return math.nan
        nearest = max(shown, key=lambda t: (-abs(t.peak_velocity_m_s - peak) if v is not None else t.peak_velocity_m_s, t.name))
        return nearest.hysteresis.mean_gap_n.measured if nearest.hysteresis else math.nan

    def missed(self, value: float) -> str | None:
        """A sentence where the limit is missed, or cannot be judged."""
        if math.isnan(value):
            return f"{self.name()}: no test of the campaign shows it"
        if value < self.low:
            return f"{self.name()}: {value:.4g} N is below {self.low:g} N"
        if value > self.high:
            return f"{self.name()}: {value:.4g} N is above {self.high:g} N"
        return None


def read_limits(path: str | os.PathLike[str]) -> tuple[Limit, ...]:
    """Reads limits.

    :raises DashpotError: naming file and line.
    """
    limits = []
    with Path(path).open(encoding="utf-8-sig", newline="") as file:
        reader = csv.reader(file)
        head = [c.strip().lower() for c in next(reader, [])]
        if sorted(head) != sorted(COLUMNS):
            raise DashpotError(f"{path}, line 1: the columns are {','.join(COLUMNS)}, not {','.join(head) or 'nothing'}")
        for row in reader:
            if not any(cell.strip() for cell in row):
                continue
            at = f"{path}, line {reader.line_num}"
            if len(row) != len(head):
                raise DashpotError(f"{at}: {len(row)} cells where the first line has {len(head)}")
            said = {name: cell.strip() for name, cell in zip(head, row, strict=True)}
            limits.append(_limit(said, at))
    if not limits:
        raise DashpotError(f"{path}: there is no limit in it")
    return tuple(limits)


def _limit(said: dict[str, str], at: str) -> Limit:
    if said["quantity"] not in QUANTITIES:
        raise DashpotError(f"{at}: there is no quantity {said['quantity']!r}; it is {', '.join(QUANTITIES)}")
    numbers: dict[str, float | None] = {}
    for column in COLUMNS[1:]:
        try:
            numbers[column] = float(said[column]) if said[column] else None
        except ValueError:
            raise DashpotError(f"{at}: {column} is {said[column]!r}, which is no number") from None
    low, high = numbers["low"], numbers["high"]
    if said["quantity"] == "force" and numbers["velocity_m_s"] is None:
        raise DashpotError(f"{at}: a limit on the force needs its velocity_m_s")
    if low is None and high is None:
        raise DashpotError(f"{at}: neither low nor high is given, so there is nothing to keep")
    low, high = -math.inf if low is None else low, math.inf if high is None else high
    if not low <= high:
        raise DashpotError(f"{at}: low is {low:g} and high is {high:g}; low must not be above high")
    return Limit(said["quantity"], numbers["velocity_m_s"], low, high)


def judge(limits: Sequence[Limit], model: Model, validation: Validation) -> list[str]:
    """Every limit that the damper misses, in words."""
    return [told for limit in limits if (told := limit.missed(limit.value(model, validation)))]
