"""What a good damper may do: the windows of ``dashpot validate --limits``, from a table or given one by one.

Columns of a table are ``quantity``, ``velocity_m_s``, ``low`` and ``high``, or ``nominal`` and ``tolerance`` in their place, and if wanted
``amplitude_m``, ``setting``, ``unit`` and ``name``. An empty low or high is no limit on that side. Forces are in N, tension positive; velocities
in m/s, extension positive.

| quantity | what is compared |
|---|---|
| ``force`` | force at peak velocity, of the longest stroke that reaches the velocity, between two tests of one stroke where they lie near enough |
| ``gas_force`` | what pushes the rod out in tests below 6 mm/s |
| ``friction`` | half the force between extension and compression in tests below 6 mm/s |
| ``hysteresis`` | mean gap between rising and falling velocity of the test with that peak velocity; the largest of all where none is given |

Tables are read, records measured and both compared by the compiled part, as the command does it.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from . import _native
from ._files import needs


@dataclass(frozen=True)
class Limit:
    """A range that a quantity has to keep."""

    quantity: str
    """``force``, ``gas_force``, ``friction`` or ``hysteresis``."""
    velocity_m_s: float | None
    """Speed at which, negative in compression; none for friction and gas force."""
    low: float
    """Smallest value allowed, N; ``-math.inf`` where there is none."""
    high: float
    """Largest value allowed, N; ``math.inf`` where there is none."""
    amplitude_m: float | None = None
    """Stroke at which; the longest that reaches the velocity if not given."""
    label: str = ""
    """Name that the file gives it."""
    setting: float | None = None
    """Setting of the damper at which, for one that depends on a setting."""


class Limits(tuple[Limit, ...]):
    """The limits of a table, with the path that it was read from, which a certificate names."""

    path: str

    def __new__(cls, limits: Iterable[Limit], path: str | os.PathLike[str]) -> Limits:
        made = super().__new__(cls, tuple(limits))
        made.path = os.fspath(path)
        return made

    def __getnewargs__(self) -> tuple[tuple[Limit, ...], str]:
        return tuple(self), self.path


#: A limit as the compiled part takes it.
Row = tuple[str, str, "float | None", "float | None", "float | None", "float | None", "float | None"]


def read_limits(path: str | os.PathLike[str]) -> Limits:
    """Reads a table of limits, as ``dashpot validate --limits`` does.

    :raises ValidationError: naming file and line.
    :raises FileNotFoundError: the same error, where there is no such file.
    """
    with needs(path):
        read = _native.read_limits(os.fspath(path))
    limits = (
        Limit(quantity, velocity, -math.inf if low is None else low, math.inf if high is None else high, amplitude, label, setting)
        for label, quantity, velocity, low, high, amplitude, setting in read
    )
    return Limits(limits, path)


def rows(limits: Sequence[Limit]) -> list[Row]:
    """Limits as the compiled part takes them.

    :raises TypeError: where something else stands in their place.
    """
    if isinstance(limits, (str, os.PathLike)):
        raise TypeError(f"limits are dashpot.Limit, not the path of their table; give dashpot.read_limits({os.fspath(limits)!r})")
    for limit in limits:
        if not isinstance(limit, Limit):
            raise TypeError(f"limits are a sequence of dashpot.Limit, not of {type(limit).__name__}; dashpot.read_limits reads them from a file")
    return [(x.label, x.quantity, x.velocity_m_s, x.low, x.high, x.amplitude_m, x.setting) for x in limits]
