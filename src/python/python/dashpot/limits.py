"""Limits of a good damper, as in ``dashpot validate --limits``, from a table or as single limits.

The columns of a table are ``quantity``, ``velocity_m_s``, and either ``low`` and ``high`` or ``nominal`` and ``tolerance``. Optional columns are
``amplitude_m``, ``setting``, ``unit`` and ``name``. An empty low or high means no limit on this side. Forces are in N, tension positive.
Velocities are in m/s, extension positive.

| quantity | what is compared |
|---|---|
| ``force`` | force at peak velocity, of the largest amplitude that reaches the velocity, interpolated between two near tests of one amplitude |
| ``gas_force`` | force that pushes the rod out in tests below 6 mm/s |
| ``friction`` | half the difference between the forces in extension and compression in tests below 6 mm/s |
| ``hysteresis`` | mean force difference between rising and falling velocity of the test with this peak velocity; without a velocity, the largest of all tests |
| ``response_time_up``, ``response_time_down`` | time from a step of the setting until 63 % of the force change, s |
| ``rise_time_up``, ``rise_time_down`` | time from 10 to 90 % of the force change after a step of the setting, s |

The extension module reads the tables and compares the records with the limits, with the code of the command.
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
    """Allowed range of a quantity."""

    quantity: str
    """Name of the quantity, such as ``force``, ``gas_force``, ``friction`` or ``hysteresis``."""
    velocity_m_s: float | None
    """Velocity at which the limit applies, negative in compression; None for friction and gas force."""
    low: float
    """Smallest allowed value, N (s for a response time); ``-math.inf`` without a lower limit."""
    high: float
    """Largest allowed value, N (s for a response time); ``math.inf`` without an upper limit."""
    amplitude_m: float | None = None
    """Amplitude at which the limit applies; by default the largest amplitude that reaches the velocity."""
    label: str = ""
    """Name in the table."""
    setting: float | None = None
    """Setting at which the limit applies, for a damper that depends on a setting."""


class Limits(tuple[Limit, ...]):
    """The limits of a table, with the path of the table, which a certificate names."""

    path: str

    def __new__(cls, limits: Iterable[Limit], path: str | os.PathLike[str]) -> Limits:
        made = super().__new__(cls, tuple(limits))
        made.path = os.fspath(path)
        return made

    def __getnewargs__(self) -> tuple[tuple[Limit, ...], str]:
        return tuple(self), self.path


#: A limit in the form that the extension module accepts: label, quantity, velocity, low, high, amplitude, setting.
Row = tuple[str, str, "float | None", "float | None", "float | None", "float | None", "float | None"]


def read_limits(path: str | os.PathLike[str]) -> Limits:
    """Reads a table of limits, like ``dashpot validate --limits``.

    :raises ValidationError: if the table is invalid. The message names file and line.
    :raises FileNotFoundError: if the file does not exist. The exception is also a :class:`ValidationError`.
    """
    with needs(path):
        read = _native.read_limits(os.fspath(path))
    limits = (
        Limit(quantity, velocity, -math.inf if low is None else low, math.inf if high is None else high, amplitude, label, setting)
        for label, quantity, velocity, low, high, amplitude, setting in read
    )
    return Limits(limits, path)


def rows(limits: Sequence[Limit]) -> list[Row]:
    """Converts limits to the form that the extension module accepts.

    :raises TypeError: if the argument is no sequence of limits.
    """
    if isinstance(limits, (str, os.PathLike)):
        raise TypeError(f"limits are dashpot.Limit, not the path of their table; give dashpot.read_limits({os.fspath(limits)!r})")
    for limit in limits:
        if not isinstance(limit, Limit):
            raise TypeError(f"limits are a sequence of dashpot.Limit, not of {type(limit).__name__}; dashpot.read_limits reads them from a file")
    return [(x.label, x.quantity, x.velocity_m_s, x.low, x.high, x.amplitude_m, x.setting) for x in limits]
