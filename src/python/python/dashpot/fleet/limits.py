"""What a good damper may do: limits from a CSV file, and whether a damper keeps them.

The file is that of ``dashpot validate --limits``, and what is compared is what that command compares: figures measured on the records.
Columns are ``quantity``, ``velocity_m_s``, ``low`` and ``high``, or ``nominal`` and ``tolerance`` in their place, and if wanted
``amplitude_m``, ``unit`` and ``name``. An empty low or high is no limit on that side. Forces are in N, tension positive; velocities
in m/s, extension positive.

| quantity | what is compared |
|---|---|
| ``force`` | force at peak velocity, of the longest stroke that reaches the velocity, between two tests of one stroke where they lie near enough |
| ``gas_force`` | what pushes the rod out in tests below 6 mm/s |
| ``friction`` | half the force between extension and compression in tests below 6 mm/s |
| ``hysteresis`` | mean gap between rising and falling velocity of the test with that peak velocity; the largest of all where none is given |
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from .._native import DashpotError
from ._text import delimiter_of, heading_of, rows_of, text_of
from .measured import Measured

QUANTITIES = ("force", "gas_force", "friction", "hysteresis")
COLUMNS = ("quantity", "velocity_m_s", "low", "high", "nominal", "tolerance", "amplitude_m", "unit", "name")
#: Newtons in the units of force that a rig's table is in.
UNITS = {
    "n": 1.0, "newton": 1.0, "newtons": 1.0, "dan": 10.0, "kn": 1e3,
    "lbf": 4.4482216152605, "lb": 4.4482216152605, "lbs": 4.4482216152605, "pound": 4.4482216152605, "pounds": 4.4482216152605,
    "kip": 4448.2216152605, "kips": 4448.2216152605, "klbf": 4448.2216152605, "klb": 4448.2216152605,
    "kgf": 9.80665, "kp": 9.80665, "kg": 9.80665,
}  # fmt: skip


@dataclass(frozen=True)
class Limit:
    """A range that a quantity has to keep."""

    quantity: str
    velocity_m_s: float | None
    low: float
    high: float
    amplitude_m: float | None = None
    """Stroke at which; the longest that reaches the velocity if not given."""
    label: str = ""
    """Name that the file gives it."""

    def name(self) -> str:
        """The quantity in words, behind the name that the file gives it."""
        said = self.quantity if self.velocity_m_s is None else f"{self.quantity} at {self.velocity_m_s:g} m/s"
        return f"{self.label}, {said}" if self.label else said

    def value(self, measured: Measured) -> float | None:
        """The quantity of a damper; none where its records cannot tell."""
        if self.quantity == "force":
            return None if self.velocity_m_s is None else measured.force(self.velocity_m_s, self.amplitude_m)
        if self.quantity == "gas_force":
            return measured.gas_force_n
        if self.quantity == "friction":
            return measured.friction_n
        return measured.hysteresis(self.velocity_m_s, self.amplitude_m)

    def missed(self, value: float | None) -> str | None:
        """A sentence where the limit is missed, or was not tested, which is no pass."""
        if value is None:
            slow = self.quantity in ("gas_force", "friction")
            return f"{self.name()}: not tested, there is no {'slow test (below 6 mm/s)' if slow else 'test at this speed'}"
        if value < self.low:
            return f"{self.name()}: {value:.4g} N is below {self.low:g} N"
        if value > self.high:
            return f"{self.name()}: {value:.4g} N is above {self.high:g} N"
        return None


def read_limits(path: str | os.PathLike[str]) -> tuple[Limit, ...]:
    """Reads limits.

    :raises DashpotError: naming file and line.
    """
    file = Path(path)
    text = text_of(file)
    delimiter = delimiter_of(heading_of(text))
    rows = rows_of(text, delimiter, file)
    line, head = next(rows, (1, []))
    head = [c.lower().replace(" ", "_").replace("-", "_") for c in head]
    for name in head:
        if name not in COLUMNS:
            raise DashpotError(
                f"{path}, line {line}: there is no column {name!r} in a table of limits; the columns are {', '.join(COLUMNS)}"
            )
        if head.count(name) > 1:
            raise DashpotError(f"{path}, line {line}: the column {name!r} stands there twice")
    if "quantity" not in head:
        raise DashpotError(f"{path}, line {line}: the column quantity is missing; the columns are {', '.join(COLUMNS)}")
    limits = []
    for line, row in rows:
        at = f"{path}, line {line}"
        if len(row) != len(head):
            raise DashpotError(f"{at}: has {len(row)} cells where the first line has {len(head)}")
        said = {name: cell for name, cell in zip(head, row, strict=True) if cell}
        # A spreadsheet that writes decimal commas separates by something else.
        limits.append(_limit(said, at, decimal_comma=delimiter != ","))
    if not limits:
        raise DashpotError(f"{path}: there is no limit in it")
    return tuple(limits)


def _limit(said: dict[str, str], at: str, *, decimal_comma: bool) -> Limit:
    def number(name: str, text: str) -> float:
        try:
            value = float(text.replace(",", ".") if decimal_comma else text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise DashpotError(f"{at}: {name} is {text!r}, which is no number")
        return value

    quantity = said.get("quantity", "").lower().replace(" ", "_").replace("-", "_")
    if quantity not in QUANTITIES:
        raise DashpotError(f"{at}: there is no quantity {said.get('quantity', '')!r}; it is {', '.join(QUANTITIES)}")
    unit = said.get("unit", "N")
    if unit.strip("[](){} ").lower() not in UNITS:
        raise DashpotError(f"{at}: the unit {unit!r} is no unit of force; N, kN, daN, lbf are")
    newtons = UNITS[unit.strip("[](){} ").lower()]

    def value(name: str) -> float | None:
        return number(name, said[name]) if name in said else None

    low, high = _window(said, at, newtons, number)
    velocity, amplitude = value("velocity_m_s"), value("amplitude_m")
    if low is None and high is None:
        raise DashpotError(f"{at}: neither low nor high is given, so there is nothing to keep")
    low, high = -math.inf if low is None else low, math.inf if high is None else high
    if not low <= high:
        raise DashpotError(
            f"{at}: low is {low:g} and high is {high:g}; low must not be above high "
            "(forces are signed, so in compression the stronger force is the lower one)"
        )
    if quantity == "force":
        if velocity is None:
            raise DashpotError(f"{at}: a limit on the force needs its velocity_m_s")
        if velocity == 0:
            raise DashpotError(f"{at}: there is no peak force at velocity 0; limit friction or gas_force instead")
        if velocity < 0 < low < math.inf:
            raise DashpotError(
                f"{at}: the force is positive at a negative velocity; compression has a negative velocity and a negative force here"
            )
    if amplitude is not None and amplitude <= 0:
        raise DashpotError(f"{at}: the amplitude {amplitude:g} m is not positive")
    return Limit(quantity, velocity, low, high, amplitude, said.get("name", ""))


def _window(said: dict[str, str], at: str, newtons: float, number: Callable[[str, str], float]) -> tuple[float | None, float | None]:
    """Smallest and largest value that are allowed, N."""
    low, high, nominal = (newtons * number(n, said[n]) if n in said else None for n in ("low", "high", "nominal"))
    tolerance = said.get("tolerance")
    if nominal is None and tolerance is None:
        return low, high
    if nominal is None or tolerance is None:
        raise DashpotError(f"{at}: nominal and tolerance belong together (tolerance in the unit, or as 10 %)")
    if low is not None or high is not None:
        raise DashpotError(f"{at}: give either low and high or nominal and tolerance, not both")
    if tolerance.endswith("%"):
        size = abs(nominal) * number("tolerance", tolerance[:-1].strip()) / 100
    else:
        size = newtons * number("tolerance", tolerance)
    if size < 0:
        raise DashpotError(f"{at}: the tolerance {tolerance!r} is negative")
    return nominal - size, nominal + size


def judge(limits: Sequence[Limit], measured: Measured) -> list[str]:
    """Every limit that the damper misses or that was not tested, in words."""
    return [told for limit in limits if (told := limit.missed(limit.value(measured)))]
