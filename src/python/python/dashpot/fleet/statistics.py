"""Figures over a fleet: what is usual, who is not, what drifts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Numbers = npt.NDArray[np.float64]
Places = npt.NDArray[np.intp]

#: Distance from the median, in robust standard deviations, from which a damper is an outlier (Iglewicz and Hoaglin, How to
#: Detect and Handle Outliers, 1993).
OUTLIER = 3.5
#: Standard deviation of a normal distribution over its median absolute deviation.
PER_MAD = 1.4826
#: The same over its mean absolute deviation.
PER_MEAN = 1.2533
#: Least deviation that counts, over the size of the values: repeatability of a good rig (ISO 376, class 00 load cells: 0.05 %; doubled).
#: Numbers that the fit took from what dampers show agree to many digits, and the one damper that differs would be 1e10 deviations off.
RESOLUTION = 1e-3
#: Half-width of the limits of an individuals chart over the mean moving range: 3 / d2 for two values (Montgomery, Introduction to
#: Statistical Quality Control, 6.4).
PER_RANGE = 2.66
#: So many values in a row on one side of the centre are a shift (Nelson's second rule).
RUN = 9
#: Deviations of the slope from which a drift is told: with some dozens of parameters one in a thousand is told by chance.
DRIFT = 3.3


@dataclass(frozen=True)
class Spread:
    """What is usual."""

    count: int
    median: float
    deviation: float
    """Robust standard deviation."""
    low: float
    high: float


def spread(values: Numbers) -> Spread:
    """Median, robust deviation and range of the values that are there."""
    there = values[np.isfinite(values)]
    if not len(there):
        return Spread(0, np.nan, np.nan, np.nan, np.nan)
    middle = float(np.median(there))
    deviation = PER_MAD * float(np.median(np.abs(there - middle)))
    return Spread(len(there), middle, deviation, float(there.min()), float(there.max()))


def far_off(values: Numbers, least: float = 0.0) -> Numbers:
    """Distance of each from the median in robust deviations; 0 where nothing spreads, not a number where there is no value.

    A deviation is :data:`RESOLUTION` of the values at least, and ``least``: what one value is known to.

    Where more than half of the values are the same, the median of the deviations is 0; the mean of them stands in its place
    (Iglewicz and Hoaglin).
    """
    usual = spread(values)
    none = 1e-12 * max(1.0, abs(usual.median))
    deviation = usual.deviation
    there = values[np.isfinite(values)]
    if not deviation > none and usual.count:
        deviation = PER_MEAN * float(np.mean(np.abs(there - usual.median)))
    if not deviation > none:
        return np.where(np.isfinite(values), 0.0, np.nan)
    size = float(np.median(np.abs(there)))
    return (values - usual.median) / max(deviation, RESOLUTION * size, least)


@dataclass(frozen=True)
class Drift:
    """A straight line over time or place."""

    slope: float
    deviation: float
    """Standard deviation of the slope."""

    @property
    def stands_out(self) -> bool:
        """Whether chance alone hardly makes such a slope."""
        return self.deviation > 0 and abs(self.slope) > DRIFT * self.deviation


def drift(at: Numbers, values: Numbers) -> Drift | None:
    """Slope of the values by least squares, outliers left out; none with fewer than five values or one time."""
    kept = np.isfinite(at) & np.isfinite(values)
    kept &= np.abs(np.nan_to_num(far_off(values))) <= OUTLIER
    x, y = at[kept], values[kept]
    if len(x) < 5 or np.ptp(x) == 0:
        return None
    x = x - x.mean()
    square = float(x @ x)
    slope = float(x @ y) / square
    left = y - y.mean() - slope * x
    return Drift(slope, float(np.sqrt(left @ left / (len(x) - 2) / square)))


@dataclass(frozen=True)
class Batch:
    """One batch beside the others."""

    name: str
    count: int
    mean: float
    low: float
    high: float
    """Ends of the 95 % interval of the mean."""


def batches(names: Sequence[str], values: Numbers) -> list[Batch]:
    """Mean of every batch with its interval, in the order of the names."""
    out = []
    for name in sorted({n for n in names if n}):
        own = values[[n == name for n in names]]
        own = own[np.isfinite(own)]
        if len(own):
            half = 1.96 * float(own.std(ddof=1)) / np.sqrt(len(own)) if len(own) > 1 else np.nan
            out.append(Batch(name, len(own), float(own.mean()), float(own.mean() - half), float(own.mean() + half)))
    return out


@dataclass(frozen=True)
class Control:
    """An individuals chart: centre and limits from the moving range, and the values that break a rule."""

    centre: float
    low: float
    high: float
    beyond: tuple[int, ...]
    """Places of values outside the limits."""
    shifted: tuple[int, ...]
    """Places of values that end a run of nine on one side of the centre."""


def control(values: Numbers) -> Control | None:
    """The chart of values in the order in which they were made; none with fewer than three."""
    places = np.flatnonzero(np.isfinite(values))
    there = values[places]
    if len(there) < 3:
        return None
    centre = float(there.mean())
    half = PER_RANGE * float(np.abs(np.diff(there)).mean())
    beyond = tuple(int(p) for p in places[np.abs(there - centre) > half])
    shifted, run, side = [], 0, 0.0
    for place, value in zip(places, there, strict=True):
        now = float(np.sign(value - centre))
        run = run + 1 if now == side and now != 0 else 1
        side = now
        if run >= RUN:
            shifted.append(int(place))
    return Control(centre, centre - half, centre + half, beyond, tuple(shifted))
